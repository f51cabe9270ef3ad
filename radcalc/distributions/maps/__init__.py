"""Functions of direction that are radiances, as pictures of what surrounds a place.

- `pictures`: what a picture file holds, read by its content and written by its extension
- `rgbe`, `exr`, `pfm`: Radiance pictures, OpenEXR and portable float maps
- `radiance_map`: a picture in a projection, as a function of direction
- `light_sums`: irradiances of a map, as sums over its pixels; `harmonics`: approximate ones
- `irradiance_map`, `resampling`, `sky_map`: maps that are made: of irradiances, in another
  projection, of a sky

Pixels are 32-bit floats in NumPy arrays of (height, width, channels); row 0 is the top of the
picture.  They are proportional to radiance, and not encoded for display.
"""
