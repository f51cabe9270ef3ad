"""Laws as data, and the solver that uses them.

What a law is, is in `law`; `solver` has everything that follows from what is given.  The laws
themselves are in a module a subject: `cones`, `solid_angles`, `sizes`, `etendue`, `point`,
`luminaire`, `surface`, `laser`, `energy`, `heat`, `exposure`, `photon`, `mesopic`.  All values are
in coherent SI units, in which an angle, a cycle and a photon are dimensions; Omega0 is 1 sr.
"""
