"""The geometry under radiometry and photometry.

- `cones`: cones [sr], the cosine of the light on a surface, and the range checks of all.
- `directions`: spherical coordinates and Cartesian ones [rad].
- `solid` and `spheres`: solid angles of shapes [sr], which turn intensity into flux.
- `projected`: projected solid angles [sr], which turn radiance into irradiance.
- `etendue`: geometric extents of beams [m^2 sr], which turn radiance into flux.
- `far_field`: how good the inverse square is for what is small beside its distance.
- `lobes`: distributions that fall off as a power of the cosine.
- `receivers`: what round receivers of any size get of a cone, a lobe or an isotropic source.
- `sky`: the skies of the CIE; `uberlight`: the attenuations of a cinematographer's light.
- `projections` and `light_vectors`: maps of the sphere, and what their pixels send.
- `polygons` and `outline`: plane polygons, and the check of what a user typed as one.
- `numerics`: integrals, special functions and vectors, without any light.

Angles are in radians; shapes have their lengths in any one unit.  Arguments are floats or NumPy
arrays; for floats only the integrals over directions import NumPy.  What no observer can see is
refused with a `ConditionError`.
"""
