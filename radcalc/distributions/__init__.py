"""Functions of direction: the light of sources as they are sold, measured or modelled.

- `distribution`, `radiances`: the protocols of distributions and of radiances by direction
- `shapes`, `formula`, `grid`: exact shapes, expressions, tables of angles and intensities
- `sources`, `environments`: distributions and surroundings as a user gives them
- `files`, `ies`, `eulumdat`, `tables`, `photometry`: photometric files and their contents
- `beams`, `places`: beam and field angles; the light on places and discs under a source
- `pose`, `scene`: aim of a source; the irradiance from several sources
- `sky`, `maps`: radiances of skies, and of pictures of the surroundings

A distribution has its own coordinates: the polar angle theta from the source's axis (the gamma of
C-gamma), and the azimuth phi about it (C), from its x axis (C0) towards its y axis (C90).
Angles are in radians, intensities in coherent SI (cd, W/sr, photon/s/sr); floats or NumPy arrays.
The package needs NumPy.
"""
