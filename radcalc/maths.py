"""Elementary functions of floats, by `math`, and of arrays, by NumPy.

NumPy is imported only when an argument is an array.  Its functions may differ from those of `math`
in the last bit; inside `exactly`, `math` computes the elements of arrays too.
"""

import math
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from itertools import repeat
from threading import local
from typing import Any

from radcalc.floats import SMALLEST

# [1] Relative tolerance of an upper limit: 12.566370614360 sr and 3.14159265359 rad, typed with
# rounded digits, are within the sphere.
SLACK = 1e-12
# Inputs other than 0 must be between 1 / LARGEST and LARGEST, so that squares and ratios stay
# within the range of a float.
LARGEST = 1e100
FAINTEST = 1e-300  # near the smallest float with full precision
Number = Any  # a float, or anything with NumPy's elementwise operations


class _Mode(local):
    is_exact = False


_MODE = _Mode()


def is_array(x: Any) -> bool:
    """Return whether x needs NumPy: not a plain number, a text, a flag or None."""
    return hasattr(x, "dtype") and not isinstance(x, float) and not is_uncertain(x)


def frozen(x: Any) -> Any:
    """Return a view of a NumPy array that cannot be changed; anything else unchanged."""
    if not (hasattr(x, "setflags") and x.ndim):
        return x
    view = x.view()
    view.setflags(write=False)
    return view


def is_uncertain(x: Any) -> bool:
    """Return whether x is a number of the `uncertainties` package (not an array)."""
    return hasattr(x, "error_components")


def is_column(x: Any) -> bool:
    """Return whether x is an array with at least one axis, not a single number."""
    return is_array(x) and x.ndim > 0


@contextmanager
def exactly() -> Iterator[None]:
    """Compute the elements of arrays to the same last bit as floats, which takes longer."""
    before = _MODE.is_exact
    _MODE.is_exact = True
    try:
        yield
    finally:
        _MODE.is_exact = before


def each(function: Callable[..., float], *xs: Number) -> Number:
    """Apply a function of floats to every element of arrays that are broadcast together."""
    for x in xs:
        if type(x) is not float and is_array(x):  # the type first: most arguments are floats
            return _mapped(function, xs)
    return function(*xs)


def _mapped(function: Callable[..., float], xs: tuple[Number, ...]) -> Number:
    import numpy

    shape = numpy.broadcast_shapes(*[numpy.shape(x) for x in xs])
    size = math.prod(shape)
    columns = [
        numpy.broadcast_to(x, shape).ravel().tolist() if is_array(x) else repeat(x, size)
        for x in xs
    ]
    return numpy.fromiter(map(function, *columns), float, size).reshape(shape)[()]


def _call(name: str, *xs: Number) -> Number:
    """Call a function of `math`, or of NumPy, which returns nan or inf outside the domain."""
    function = getattr(math, name)
    for x in xs:
        if type(x) is not float and is_array(x):
            if _MODE.is_exact:
                with suppress(ValueError, OverflowError):
                    return _mapped(function, xs)
            import numpy

            return getattr(numpy, name)(*xs)
    return function(*xs)


def is_lost(value: Number, *of: Number) -> bool:
    """Return whether a product of nonzero factors, or an element of it, underflows."""
    small = abs(value) < SMALLEST
    if small is False:
        return False
    for factor in of:
        small = small & (factor != 0)
    return any_true(small)


def product(a: Number, b: Number) -> tuple[Number, bool]:
    """Return the product of arrays, and whether any element of it overflows or underflows."""
    import numpy

    with numpy.errstate(all="ignore"):
        products = a * b
        gone = ~numpy.isfinite(products) & numpy.isfinite(a) & numpy.isfinite(b)
        gone |= (abs(products) < SMALLEST) & (a != 0) & (b != 0)
    return products, bool(numpy.any(gone))


def sin(x: Number) -> Number:
    """Return the sine of x [rad]."""
    return math.sin(x) if type(x) is float else _call("sin", x)


def cos(x: Number) -> Number:
    """Return the cosine of x [rad]."""
    return math.cos(x) if type(x) is float else _call("cos", x)


def tan(x: Number) -> Number:
    """Return the tangent of x [rad]."""
    return math.tan(x) if type(x) is float else _call("tan", x)


def atan(x: Number) -> Number:
    """Return the arc tangent of x, in radians."""
    return math.atan(x) if type(x) is float else _call("atan", x)


def atan2(y: Number, x: Number) -> Number:
    """Return the angle of the point (x, y), in radians from -pi to pi."""
    return _call("atan2", y, x)


def asin(x: Number) -> Number:
    """Return the arc sine of x, in radians."""
    return math.asin(x) if type(x) is float else _call("asin", x)


def acos(x: Number) -> Number:
    """Return the arc cosine of x, in radians."""
    return math.acos(x) if type(x) is float else _call("acos", x)


def exp(x: Number) -> Number:
    """Return e to the power of x."""
    return math.exp(x) if type(x) is float else _call("exp", x)


def expm1(x: Number) -> Number:
    """Return e to the power of x, minus 1."""
    return math.expm1(x) if type(x) is float else _call("expm1", x)


def log2(x: Number) -> Number:
    """Return the logarithm of x to the base 2."""
    return math.log2(x) if type(x) is float else _call("log2", x)


def log10(x: Number) -> Number:
    """Return the logarithm of x to the base 10."""
    return math.log10(x) if type(x) is float else _call("log10", x)


def sqrt(x: Number) -> Number:
    """Return the square root of x; NumPy rounds it as `math` does."""
    if type(x) is not float and is_array(x):
        import numpy

        return numpy.sqrt(x)
    return math.sqrt(x)


def power(x: Number, exponent: Number) -> Number:
    """Return x to a power."""
    if _MODE.is_exact and (is_array(x) or is_array(exponent)):
        with suppress(ZeroDivisionError, OverflowError, TypeError):  # TypeError: complex results
            return _mapped(pow, (x, exponent))
    return x**exponent


def square(x: Number) -> Number:
    """Return x squared, computed by `power` for arrays."""
    return x**2 if type(x) is float else power(x, 2)


def rounded(x: Number, digits: int) -> Number:
    """Return x rounded to a number of decimals."""
    if not is_array(x):
        return round(x, digits)
    import numpy

    return _mapped(round, (x, digits)) if _MODE.is_exact else numpy.round(x, digits)


def log(x: Number) -> Number:
    """Return the natural logarithm of x."""
    return math.log(x) if type(x) is float else _call("log", x)


def log1p(x: Number) -> Number:
    """Return the natural logarithm of 1 + x."""
    return math.log1p(x) if type(x) is float else _call("log1p", x)


def hypot(x: Number, y: Number) -> Number:
    """Return the length of (x, y)."""
    if type(x) is float and type(y) is float:
        return math.hypot(x, y)
    return _call("hypot", x, y)


def power_of_two(x: Number) -> Number:
    """Return the power of two just above x; dividing by it is exact."""
    if type(x) is not float and is_array(x):
        import numpy

        return numpy.ldexp(1.0, numpy.frexp(x)[1])
    return math.ldexp(1.0, math.frexp(x)[1])


def any_true(condition: Any) -> bool:
    """Return whether a comparison is true: a bool itself, an array if any element is true."""
    return condition if isinstance(condition, bool) else bool(condition.any())


def chosen(x: Number, condition: Any) -> Number:
    """Return the elements of x that satisfy a condition; a single x itself."""
    if isinstance(condition, bool):
        return x
    import numpy

    return numpy.broadcast_to(x, condition.shape)[condition]


def larger(x: Number, y: Number) -> Number:
    """Return the larger of two, element by element."""
    return piecewise(x >= y, lambda a, b: a, lambda a, b: b, x, y)


def smaller(x: Number, y: Number) -> Number:
    """Return the smaller of two, element by element."""
    return piecewise(x <= y, lambda a, b: a, lambda a, b: b, x, y)


def piecewise(
    condition: Any, then: Callable[..., Number], otherwise: Callable[..., Number], *xs: Number
) -> Number:
    """Return `then(*xs)` where the condition is true and `otherwise(*xs)` elsewhere."""
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


HALVINGS = 200  # at most; fewer than 70 find a limit that is not close to 0


def limit(holds: Callable[[float], bool], outside: float, inside: float) -> float:
    """Return the last number, from `inside` towards `outside`, that satisfies a condition.

    The condition changes once between them.
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


CHUNK = 16_384  # elements; their intermediate values fit into a processor's cache


def in_chunks(function: Callable[..., Number], *xs: Number) -> Number:
    """Return `function(*xs)`, computed in parts for long rows, which is faster."""
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
