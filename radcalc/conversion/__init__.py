"""Conversion of a value to another unit or quantity: plans, bridges and factors of conditions."""
