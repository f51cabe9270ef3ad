"""`radcalc integrate EXPRESSION`."""

from radcalc.calculators.integrate import integrate
from radcalc.cli.calculator import Asked, cases, run
from radcalc.cli.command import define
from radcalc.cli.options import Output
from radcalc.errors import UsageError


@define(
    "integrate",
    {
        "Directions": ("sphere", "hemisphere", "half-angle", "polar", "azimuth"),
        "Results": ("accuracy",),
    },
    words="EXPRESSION",
)
def command(words: tuple[str, ...], typed: dict[str, str], asked: Asked, shown: Output) -> int:
    """Integrate a function of direction over a part of the sphere.

    \b
    Examples:
      radcalc integrate 'cos(theta)' --hemisphere
      radcalc integrate '100*cos(theta)**10' --polar 0deg:45deg
      radcalc integrate 'max(x, 0)' --sphere --accuracy 1e-6
      radcalc integrate '(theta<30*deg)*100' --sphere
      radcalc integrate 'exp(-(theta/(10*deg))**2)' --half-angle 60deg -g integral:deg2

    EXPRESSION is made of theta (polar angle) and phi (azimuth) in radians, x, y, z (the unit
    vector), numbers, pi, e, deg, + - * / **, brackets, sin cos tan asin acos atan atan2 sinh cosh
    tanh exp log log10 sqrt abs min max, and comparisons by < <= > >=, which are 1 where they hold
    and 0 elsewhere; one that begins with a minus goes in brackets: '(-x)'.  The integral is over
    solid angle: sin(theta) is there already.  What does not converge is refused.
    """
    if not words:
        raise UsageError("an expression is missing", "radcalc integrate 'cos(theta)' --hemisphere")
    each = cases(typed, intervals=("polar", "azimuth"))
    text = " ".join(words)
    return run(each, lambda given: integrate(text, given), asked, shown, "integrate")
