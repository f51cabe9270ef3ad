"""The geometry under radiometry and photometry.

- `cones`: cones and lobes [sr], the cosine of the light on a surface, and the range checks.
- `solid`: solid angles of shapes [sr], which turn intensity into flux, projected ones [sr], which
  turn radiance into irradiance, and etendues of beams [m^2 sr], which turn radiance into flux.
- `receivers`: light of a cone, a lobe or an isotropic source on a round receiver of any size.
- `models`: the CIE skies, and the attenuations of a cinematographer's light.
- `projections`: vectors, directions [rad], and maps of the sphere.
- `polygons`: plane polygons, and the check of their vertices.
- `numerics`: integrals, special functions and typed expressions.

Angles are in radians; the lengths of a shape are in any one unit.  Arguments are floats or NumPy
arrays; for floats only the integrals over directions import NumPy.  Arguments out of range raise a
`ConditionError`.  The examples assume the names of their module.
"""
