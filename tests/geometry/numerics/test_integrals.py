"""Special functions against mpmath's."""

import mpmath
import pytest
from geometry.references import DIGITS, close
from mpmath import mpf

from radcalc.geometry import numerics


@pytest.mark.parametrize("kc", [1e-9, 1e-3, 0.4, 1.0, 3.0, 1e3])
@pytest.mark.parametrize("p", [1e-9, 1e-4, 0.5, 1.0, 2.0, 1e6])
def test_bulirschs_integral_is_legendres(kc, p):
    with mpmath.workdps(DIGITS):
        m, n = 1 - mpf(kc) ** 2, 1 - mpf(p)
        first, second, third = mpmath.ellipk(m), mpmath.ellipe(m), mpmath.ellippi(n, m)
        mixed = (third - first) / n if n else None
        square = mpf(kc) ** 2
    close(numerics.cel(kc, 1.0, 1.0, 1.0), first)
    close(numerics.cel(kc, 1.0, 1.0, float(square)), second)
    close(numerics.cel(kc, p, 1.0, 1.0), third)
    if mixed is not None:  # with sin^2 in the numerator: n sin^2 = 1 - (1 - n sin^2), (Pi - K)/n
        close(numerics.cel(kc, p, 0.0, 1.0), mixed)


@pytest.mark.parametrize("x", [1e-9, 1e-3, 0.1, 0.2499, 0.25, 0.2501, 0.7, 0.999999, 1.0])
def test_differences_keep_their_digits(x):
    with mpmath.workdps(DIGITS):
        close(numerics.less_arctangent(x), mpf(x) - mpmath.atan(mpf(x)))
        close(numerics.arc_excess(x), mpmath.asin(mpf(x)) / mpf(x) - 1)
