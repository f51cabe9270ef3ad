"""Numerical methods that know nothing of light."""
