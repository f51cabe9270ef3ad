"""The geometry under radiometry: directions, solid angles, projected solid angles, etendue."""
