"""Functions of direction: how a source sends its light, as it is sold, measured or modelled.

- `distribution`: the protocol that all of them follow, and what they share
- `shapes`: isotropic, a uniform cone, a lobe
- `formula`: an expression in theta and phi
- `grid`: a table of angles and intensities
- `photometry`: what a file says of a luminaire, with its table
- `sources`: what a user names, a file or an expression, as one of these
- `files`, `ies` (with `ies_numbers`), `eulumdat`, `tables`: files, by format
- `contents`: what a file holds, read safely and written whole
- `planes`, `headings`: what tables of half planes share; what the titles over a table say
- `beams`: beam angles and field angles in a plane through the axis
- `places`: the light on places and discs under a source, and the places that get so much
- `pose`: where a source stands, where it is aimed and how it is rotated
- `scene`: sources in their places, and the irradiance that they give together
- `radiances`: what radiances can do, as functions of the direction that they come from; an
  expression as one
- `sky`, `maps`: the radiances of skies; those of pictures of what surrounds a place
- `environments`: what a user names, a map, a sky or an expression, as one of these

A distribution has coordinates of its own: the polar angle theta from the source's axis (the gamma
of C-gamma), and the azimuth phi about it (C), from its x axis (C0) towards its y axis (C90).
Angles are in radians, intensities in coherent SI (cd, W/sr, photon/s/sr); floats or NumPy arrays.
Needs NumPy.
"""
