"""The geometry under radiometry and photometry.

- `directions`: spherical coordinates and Cartesian ones [rad].
- `solid`: solid angles of shapes [sr], which turn intensity into flux.
- `projected`: projected solid angles [sr], which turn radiance into irradiance.
- `etendue`: geometric extents of beams [m^2 sr], which turn radiance into flux.
- `lobes`: distributions that fall off as a power of the cosine.
- `polygons` and `outline`: plane polygons, and the check of what a user typed as one.
- `numerics`: integrals, special functions and vectors, without any light.

Angles are in radians; shapes have their lengths in any one unit.  Arguments are floats or NumPy
arrays; for floats only the integrals over directions import NumPy.  What no observer can see is
refused with a `ConditionError`.
"""
