"""Laws as data, and the solver that uses them.

`law` defines the types of laws; `solver` derives every value that follows from given values.  Each
subject has a module of laws: `cones`, `solid_angles`, `sizes`, `etendue`, `point`, `luminaire`,
`surface`, `refraction`, `laser`, `energy`, `heat`, `exposure`, `photon`, `mesopic`.  All values are
in coherent SI units; the angle, the cycle and the photon are dimensions, and Omega0 is 1 sr.
"""
