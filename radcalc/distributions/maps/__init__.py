"""Radiances of pictures of the surroundings, as functions of direction.

Pixels are 32-bit floats in NumPy arrays of (height, width, channels); row 0 is the top of the
picture.  They are proportional to radiance, and not encoded for display.
"""
