"""Elementary functions that serve floats with `math` and arrays with NumPy.

A scalar answer needs no NumPy: it is imported only when an argument is an array.
"""

import math
from typing import Any

Number = Any  # a float, or anything that NumPy can work on element by element


def _call(name: str, x: Number) -> Number:
    if isinstance(x, (int, float)):
        return getattr(math, name)(x)
    import numpy

    return getattr(numpy, name)(x)


def sin(x: Number) -> Number:
    """The sine of x [rad]."""
    return _call("sin", x)


def cos(x: Number) -> Number:
    """The cosine of x [rad]."""
    return _call("cos", x)


def atan(x: Number) -> Number:
    """The arc tangent of x, in radians."""
    return _call("atan", x)


def log1p(x: Number) -> Number:
    """The natural logarithm of 1 + x."""
    return _call("log1p", x)


def any_true(condition: Any) -> bool:
    """Whether a comparison holds anywhere: a bool as it is, an array if any element is true."""
    return condition if isinstance(condition, bool) else bool(condition.any())
