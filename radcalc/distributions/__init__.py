"""Functions of direction: the light of sources as they are sold, measured or modelled.

- `distribution`: the protocol of distributions, beam angles, aim of a source, tables of intensities
- `ies`, `eulumdat`, `tables`, `contents`: photometric files and their contents
- `sources`, `environments`: distributions and surroundings as a user gives them
- `scene`: the light on places under a source, and from several sources
- `maps`: radiances of pictures of the surroundings

A distribution has its own coordinates: the polar angle theta from the source's axis (the gamma of
C-gamma), and the azimuth phi about it (C), from its x axis (C0) towards its y axis (C90).
Angles are in radians, intensities in coherent SI (cd, W/sr, photon/s/sr); floats or NumPy arrays.
The package needs NumPy.
"""
