"""Inputs: what somebody gave for a symbol, read and held to its limits."""
