"""Inputs: the values of symbols, read and checked against limits."""
