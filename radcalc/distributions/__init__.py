"""Functions of direction: the light of sources as they are sold, measured or modelled.

- `distribution`: the protocol of all distributions, and functions for any of them
- `shapes`: isotropic, a uniform cone, a lobe
- `formula`: an expression in theta and phi
- `grid`: a table of angles and intensities
- `photometry`: the contents of a photometric file: its table and its declared values
- `sources`: reading of a distribution as a user gives it, a file or an expression
- `files`, `ies` (with `ies_numbers`), `eulumdat`, `tables`: files, by format
- `contents`: safe reading and writing of files
- `planes`, `column_titles`: parts shared by tables of half planes; titles of a table
- `beams`: beam angles and field angles in a plane through the axis
- `places`: the light on places and discs under a source, and places with a given irradiance
- `pose`: aim and rotation of a source
- `scene`: the irradiance from several sources at their positions
- `radiances`: the protocol of radiances by direction; an expression as one of them
- `sky`, `maps`: radiances of skies, and of pictures of the surroundings
- `environments`: reading of surroundings as a user gives them, a map, a sky or an expression

A distribution has its own coordinates: the polar angle theta from the source's axis (the gamma of
C-gamma), and the azimuth phi about it (C), from its x axis (C0) towards its y axis (C90).
Angles are in radians, intensities in coherent SI (cd, W/sr, photon/s/sr); floats or NumPy arrays.
The package needs NumPy.
"""
