"""`radcalc direction X Y Z`, or by its angles."""

import click

from radcalc.answer import Answer
from radcalc.calculators.direction import of_angles, of_vector
from radcalc.cli import calculator, output
from radcalc.cli.sections import SectionedCommand
from radcalc.conversion.conditions import LENGTH
from radcalc.errors import ConditionError, UsageError, quote
from radcalc.quantities.light import describe
from radcalc.units.grammar import split_quantity
from radcalc.units.table import resolve


@click.command(
    "direction",
    cls=SectionedCommand,
    sections={"Angles": ("polar", "elevation", "azimuth"), "Results": calculator.RESULTS},
    context_settings={"max_content_width": 100},
)
@click.argument("words", nargs=-1, metavar="[X Y Z]")
@calculator.inputs("polar", "elevation", "azimuth")
@calculator.results
@output.options
def command(
    words: tuple[str, ...],
    asked: calculator.Asked,
    shown: output.Output,
    **typed: str | None,
) -> int:
    """Give a direction in spherical coordinates and as a unit vector.

    \b
    Examples:
      radcalc direction 1 1 1
      radcalc direction 3m 4m 0m -g length:cm -g azimuth:deg
      radcalc direction --polar 45deg --azimuth 30deg
      radcalc direction --elevation 10deg:80deg:10deg --azimuth 0deg -g z

    The polar angle is counted from +z, the azimuth from +x towards +y; the elevation is 90
    degrees less the polar angle.
    """
    given = calculator.cases(typed)
    coordinates = words[0].split(",") if len(words) == 1 else list(words)
    if words and given[0][1]:
        raise ConditionError("a vector and angles contradict each other", "one of them")
    if not words and not given[0][1]:
        raise UsageError("a direction is missing", "X Y Z, or --polar 45deg --azimuth 30deg")
    vector = _of_words(coordinates) if words else None
    return calculator.run(
        given, lambda g: vector or of_angles(g), asked, shown, command="direction"
    )


def _of_words(coordinates: list[str]) -> Answer:
    if len(coordinates) != 3:
        raise UsageError(
            f"a vector has three coordinates, not {len(coordinates)}", "radcalc direction 1 1 1"
        )
    parts = [split_quantity(word) for word in coordinates]
    units = [resolve(unit or "1") for _, unit in parts]
    if len({unit.dimension for unit in units}) > 1:
        raise ConditionError("the coordinates mix quantities", "one unit for X, Y and Z")
    if parts[0][1] and units[0].dimension != LENGTH:
        raise ConditionError(
            f"a coordinate is a length or a bare number, not {describe(units[0])}",
            f"without {quote(parts[0][1])}",
        )
    x, y, z = (number * unit.factor for (number, _), unit in zip(parts, units, strict=True))
    if max(abs(x), abs(y), abs(z)) > 1e100:
        raise ConditionError("a coordinate is beyond what radcalc reckons with", "up to 1e100")
    return of_vector(x, y, z, parts[0][1])
