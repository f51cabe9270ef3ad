"""Elementary functions that serve floats with `math` and arrays with NumPy.

A scalar answer needs no NumPy: it is imported only when an argument is an array.
"""

import math
from collections.abc import Callable
from functools import wraps
from sys import float_info
from typing import Any, TypeVar

SMALLEST = float_info.min  # below it a float loses digits
# [1] By what part of it an upper limit may be exceeded: 12.566370614360 sr and 3.14159265359 rad,
# as somebody types them, are still within the sphere.
SLACK = 1e-12
# What is given is held to this size, and to 1 over it where it is not 0: then squares and ratios
# stay within a float.
LARGEST = 1e100
FAINTEST = 1e-300  # near the end of what a float holds, where it has fewer digits
T = TypeVar("T")
Number = Any  # a float, or anything that NumPy can work on element by element


def is_array(x: Any) -> bool:
    """Whether NumPy must serve x: neither a number nor a text, a flag or nothing."""
    return hasattr(x, "dtype") and not isinstance(x, float) and not is_uncertain(x)


def is_uncertain(x: Any) -> bool:
    """Whether x is a number of the `uncertainties` package, which counts as no array."""
    return hasattr(x, "error_components")


def is_column(x: Any) -> bool:
    """Whether x is an array of elements, and no single number."""
    return is_array(x) and x.ndim > 0


def is_recorded(x: Any) -> bool:
    """Whether what is done with x is noted down (`streams/traces.py`): it then calls functions."""
    return hasattr(x, "call")


def in_one_step(function: Callable[..., T]) -> Callable[..., T]:
    """A function of floats that is recorded whole, where an argument is: not what it does."""

    @wraps(function)
    def called(*xs: Any) -> T:
        for x in xs:
            if type(x) is not float and is_recorded(x):
                return x.call(function, *xs)  # type: ignore[no-any-return]
        return function(*xs)

    return called


def _call(name: str, *xs: Number) -> Number:
    for x in xs:
        if type(x) is float:  # the type first, since nearly all are floats
            continue
        if is_array(x):
            import numpy

            return getattr(numpy, name)(*xs)
        if is_recorded(x):
            return x.call(getattr(math, name), *xs)
    return getattr(math, name)(*xs)


def is_lost(value: Number, *of: Number) -> bool:
    """Whether a product of factors that are not 0, or an element of it, is too small to be held."""
    small = abs(value) < SMALLEST
    if small is False:
        return False
    for factor in of:
        small = small & (factor != 0)
    return any_true(small)


def product(a: Number, b: Number) -> tuple[Number, bool]:
    """The product of arrays, and whether an element of it is beyond what a float holds."""
    import numpy

    with numpy.errstate(all="ignore"):
        found = a * b
        gone = ~numpy.isfinite(found) & numpy.isfinite(a) & numpy.isfinite(b)
        gone |= (abs(found) < SMALLEST) & (a != 0) & (b != 0)
    return found, bool(numpy.any(gone))


def sin(x: Number) -> Number:
    """The sine of x [rad]."""
    return _call("sin", x)


def cos(x: Number) -> Number:
    """The cosine of x [rad]."""
    return _call("cos", x)


def tan(x: Number) -> Number:
    """The tangent of x [rad]."""
    return _call("tan", x)


def atan(x: Number) -> Number:
    """The arc tangent of x, in radians."""
    return _call("atan", x)


def atan2(y: Number, x: Number) -> Number:
    """The angle of the point (x, y), in radians from -pi to pi."""
    return _call("atan2", y, x)


def asin(x: Number) -> Number:
    """The arc sine of x, in radians."""
    return _call("asin", x)


def acos(x: Number) -> Number:
    """The arc cosine of x, in radians."""
    return _call("acos", x)


def exp(x: Number) -> Number:
    """e to the power of x."""
    return _call("exp", x)


def expm1(x: Number) -> Number:
    """e to the power of x, less 1."""
    return _call("expm1", x)


def log2(x: Number) -> Number:
    """The logarithm of x to the base 2."""
    return _call("log2", x)


def log10(x: Number) -> Number:
    """The logarithm of x to the base 10."""
    return _call("log10", x)


def sqrt(x: Number) -> Number:
    """The square root of x."""
    return _call("sqrt", x)


def log(x: Number) -> Number:
    """The natural logarithm of x."""
    return _call("log", x)


def log1p(x: Number) -> Number:
    """The natural logarithm of 1 + x."""
    return _call("log1p", x)


def hypot(x: Number, y: Number) -> Number:
    """The length of (x, y)."""
    return _call("hypot", x, y)


def power_of_two(x: Number) -> Number:
    """The power of two just above x: to divide by it rounds nothing."""
    if type(x) is not float and is_recorded(x):
        return x.call(power_of_two, x)
    return _call("ldexp", 1.0, _call("frexp", x)[1])


def any_true(condition: Any) -> bool:
    """Whether a comparison holds anywhere: a bool as it is, an array if any element is true."""
    return condition if isinstance(condition, bool) else bool(condition.any())


def larger(x: Number, y: Number) -> Number:
    """The larger of two, element by element."""
    return piecewise(x >= y, lambda a, b: a, lambda a, b: b, x, y)


def smaller(x: Number, y: Number) -> Number:
    """The smaller of two, element by element."""
    return piecewise(x <= y, lambda a, b: a, lambda a, b: b, x, y)


def piecewise(
    condition: Any,
    then: Callable[..., Number],
    otherwise: Callable[..., Number],
    *xs: Number,
) -> Number:
    """`then(*xs)` where the condition holds, `otherwise(*xs)` elsewhere.

    Each function sees only the elements it is meant for.
    """
    if isinstance(condition, bool):
        return then(*xs) if condition else otherwise(*xs)
    import numpy

    chosen, *spread = numpy.broadcast_arrays(condition, *xs)
    result = numpy.empty(chosen.shape)
    if chosen.any():
        result[chosen] = then(*(x[chosen] for x in spread))
    if not chosen.all():
        result[~chosen] = otherwise(*(x[~chosen] for x in spread))
    return result


HALVINGS = 200  # at most; fewer than 70 find a limit that is not next to 0


def limit(holds: Callable[[float], bool], outside: float, inside: float) -> float:
    """The last number, from `inside` towards `outside`, at which a condition holds, by bisection.

    It holds inside and not outside, and changes once between them.
    """
    for _ in range(HALVINGS):
        middle = (outside + inside) / 2
        if middle in (outside, inside):
            break
        if holds(middle):
            inside = middle
        else:
            outside = middle
    return inside


CHUNK = 16_384  # elements whose intermediate values fit a processor's cache


def in_chunks(function: Callable[..., Number], *xs: Number) -> Number:
    """`function(*xs)`; of long rows of one length a part at a time, which is faster."""
    sizes = {len(x) if is_column(x) and x.ndim == 1 else 0 for x in xs}
    count = sizes.pop()
    if sizes or count <= CHUNK:
        return function(*xs)
    import numpy

    result = numpy.empty(count)
    for start in range(0, count, CHUNK):
        part = slice(start, start + CHUNK)
        result[part] = function(*(x[part] for x in xs))
    return result


def each(function: Callable[..., float], *xs: Number) -> Number:
    """A function of floats for every element of arrays that are broadcast together."""
    for x in xs:
        if is_array(x):
            import numpy

            return numpy.vectorize(function, otypes=[float])(*xs)
        if type(x) is not float and is_recorded(x):
            return x.call(function, *xs)
    return function(*xs)
