"""Laws as data, a module for each subject, and the solver that uses them.

All values are in coherent SI units; the angle, the cycle and the photon are dimensions, and Omega0
is 1 sr.
"""
