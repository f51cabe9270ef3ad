"""Observers, and later sources: what links watts, lumens and photons."""
