"""Numerical methods for the geometry: integrals, special functions, expressions."""
