"""Calculators, one module each: inputs, laws and assumptions."""
