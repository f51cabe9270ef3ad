"""Functions of direction that are radiances, as pictures of what surrounds a place.

- `pictures`: what a picture file holds, read by its content and written by its extension
- `rgbe`, `exr`, `pfm`: Radiance pictures, OpenEXR and portable float maps

Pixels are 32-bit floats in NumPy arrays of (height, width, channels); row 0 is the top of the
picture.  They are proportional to radiance: an encoding for display is nobody's here.
"""
