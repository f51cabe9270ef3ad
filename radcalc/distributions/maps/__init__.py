"""Radiances of pictures of the surroundings, as functions of direction.

- `pictures`: picture files, read by their contents and written by their extension
- `rgbe`, `exr`, `pfm`: Radiance pictures, OpenEXR and portable float maps
- `radiance_map`: a picture in a projection, as a function of direction
- `light_sums`: irradiances of a map, as sums over its pixels; `harmonics`: approximate ones
- `irradiance_map`, `resampling`, `sky_map`: creation of maps of irradiances, of maps in another
  projection, and of maps of a sky

Pixels are 32-bit floats in NumPy arrays of (height, width, channels); row 0 is the top of the
picture.  They are proportional to radiance, and not encoded for display.
"""
