"""`radcalc integrate EXPRESSION`."""

import click

from radcalc.answer import texts_of
from radcalc.calculators.integrate import BARE, integrand, integrate
from radcalc.cli.calculator import Asked, run
from radcalc.cli.cases import cases
from radcalc.cli.command import define
from radcalc.cli.options import Output
from radcalc.errors import UsageError

UNIT = click.Option(
    ["--unit"], metavar="cd", help="The unit of the expression: an intensity, a radiance, 1/sr."
)


@define(
    "integrate",
    {
        "Directions": ("sphere", "hemisphere", "half-angle", "polar", "azimuth"),
        "Results": (UNIT, "accuracy"),
    },
    words="EXPRESSION",
    takes_lines=False,
    draws=True,
)
def command(
    words: tuple[str, ...], unit: str | None, typed: dict[str, str], asked: Asked, shown: Output
) -> int:
    """Integrate a function of direction over a part of the sphere.

    \b
    Examples:
      radcalc integrate 'cos(theta)' --hemisphere
      radcalc integrate '100*cos(theta)**10' --polar 0deg:45deg
      radcalc integrate 'max(x, 0)' --sphere --accuracy 1e-6
      radcalc integrate '(theta<30*deg)*100' --sphere --unit cd
      radcalc integrate 'cos(theta)**2' --hemisphere --plot
      radcalc integrate 'exp(-(theta/(10*deg))**2)' --half-angle 60deg -g integral:deg2

    EXPRESSION is made of theta (polar angle) and phi (azimuth) in radians, x, y, z (the unit
    vector), numbers, pi, e, deg, + - * / **, brackets, sin cos tan asin acos atan atan2 sinh cosh
    tanh exp log log10 sqrt abs min max, and comparisons by < <= > >=, which are 1 where they hold
    and 0 elsewhere; one that begins with a minus goes in brackets: '(-x)'.  The integral is over
    solid angle: sin(theta) is there already.  What does not converge is refused.

    With --unit the integral of an intensity is a flux.  That of a radiance is the irradiance of a
    plane whose normal is +z only if the expression has its cosine, cos(theta).
    """
    if not words:
        raise UsageError("an expression is missing", "radcalc integrate 'cos(theta)' --hemisphere")
    each = cases(typed, intervals=("polar", "azimuth"))
    text = " ".join(words)
    of = integrand(unit) if unit else BARE
    operands = texts_of({"expression": text, "unit": unit or ""})
    return run(
        each,
        lambda given: integrate(text, given, of),
        asked,
        shown,
        "integrate",
        operands=operands,
        drawn=(text, unit or ""),
    )
