"""Quantities, their names and their symbols."""
