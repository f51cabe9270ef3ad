"""The geometry under radiometry and photometry.

- `cones`: cones [sr], the cosine of the light on a surface, and the range checks.
- `directions`: spherical and Cartesian coordinates [rad].
- `solid` and `spheres`: solid angles of shapes [sr], which turn intensity into flux.
- `projected`: projected solid angles [sr], which turn radiance into irradiance.
- `etendue`: geometric extents of beams [m^2 sr], which turn radiance into flux.
- `far_field`: error of the inverse square law for small patches.
- `lobes`: distributions that fall off as a power of the cosine.
- `receivers`: light of a cone, a lobe or an isotropic source on a round receiver of any size.
- `sky`: the CIE skies; `uberlight`: the attenuations of a cinematographer's light.
- `projections` and `light_vectors`: maps of the sphere, and the light of their pixels.
- `polygons` and `outline`: plane polygons, and the check of their vertices.
- `numerics`: integrals, special functions and vectors.

Angles are in radians; the lengths of a shape are in any one unit.  Arguments are floats or NumPy
arrays; for floats only the integrals over directions import NumPy.  Arguments out of range raise a
`ConditionError`.  The examples assume the names of their module.
"""
