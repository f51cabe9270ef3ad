"""`radcalc integrate EXPRESSION`."""

import math

import click

from radcalc.answer import Answer
from radcalc.calculators.inputs import Inputs, read_interval, take
from radcalc.calculators.inputs import half_angle as half_angle_of
from radcalc.calculators.integrate import integrate
from radcalc.cli import calculator, output
from radcalc.cli.sections import SectionedCommand
from radcalc.conversion.conditions import positive
from radcalc.errors import ConditionError, UsageError

WHERE = "--sphere, --hemisphere, --half-angle 30deg or --polar 30deg:60deg"


@click.command(
    "integrate",
    cls=SectionedCommand,
    sections={
        "Directions": ("sphere", "hemisphere", "half_angle", "polar", "azimuth"),
        "Results": ("accuracy", *calculator.RESULTS),
    },
    context_settings={"max_content_width": 100},
)
@click.argument("words", nargs=-1, metavar="EXPRESSION")
@click.option("--sphere", is_flag=True, help="All directions.")
@click.option("--hemisphere", is_flag=True, help="The hemisphere about +z.")
@calculator.inputs("half-angle", half_angle="The cone of that half angle about +z.")
@click.option("--polar", metavar="30deg:60deg", help="A zone between two polar angles.")
@click.option("--azimuth", metavar="0deg:90deg", help="Only between these azimuths.")
@calculator.inputs("accuracy")
@calculator.results
@output.options
def command(
    words: tuple[str, ...],
    sphere: bool,
    hemisphere: bool,
    half_angle: str | None,
    polar: str | None,
    azimuth: str | None,
    accuracy: str | None,
    asked: calculator.Asked,
    shown: output.Output,
) -> int:
    """Integrate a function of direction over a part of the sphere.

    \b
    Examples:
      radcalc integrate 'cos(theta)' --hemisphere
      radcalc integrate '100*cos(theta)**10' --polar 0deg:45deg
      radcalc integrate 'max(x, 0)' --sphere --accuracy 1e-6
      radcalc integrate 'exp(-(theta/(10*deg))**2)' --half-angle 60deg -g integral:deg2

    EXPRESSION is made of theta (polar angle) and phi (azimuth) in radians, x, y, z (the unit
    vector), numbers, pi, e, deg, + - * / **, brackets, sin cos tan asin acos atan atan2 sinh cosh
    tanh exp log log10 sqrt abs min max; one that begins with a minus goes in brackets: '(-x)'.
    The integral is over solid angle: sin(theta) is there already.  What does not converge is
    refused.
    """
    if not words:
        raise UsageError("an expression is missing", "radcalc integrate 'cos(theta)' --hemisphere")
    given = [name for name in (sphere, hemisphere, half_angle, polar) if name]
    if not given:
        raise UsageError("the directions to integrate over are missing", WHERE)
    if len(given) > 1:
        raise ConditionError("the directions to integrate over are given twice", f"one of {WHERE}")
    around = read_interval("azimuth", azimuth) if azimuth else (0.0, 2 * math.pi)
    stop = positive(take("accuracy", accuracy)) if accuracy else 1e-9

    def work_out(one: Inputs) -> Answer:
        if polar:
            ends = read_interval("polar", polar)
        elif half_angle:
            ends = (0.0, half_angle_of(one["half-angle"]))
        else:
            ends = (0.0, math.pi if sphere else math.pi / 2)
        return integrate(" ".join(words), ends, around, stop)

    each = calculator.cases({"half-angle": half_angle})
    facts = {"command": "integrate", "polar": polar and read_interval("polar", polar)}
    return calculator.run(each, work_out, asked, shown, **facts)
