"""Numerical methods for the geometry.

`quadrature` integrates functions of one variable, `cubature` functions of direction over a part
of the sphere, and `strips` solid angles of thin triangles.  `special` has the special functions
of the closed forms, `vectors` the algebra of triples of coordinates, and `expression` parses
functions of direction.
"""
