"""`radcalc direction X Y Z`, or by its angles."""

from radcalc.answer import Answer
from radcalc.calculators.direction import of_angles, of_vector
from radcalc.cli.calculator import Asked, cases, run
from radcalc.cli.command import define
from radcalc.cli.options import Output
from radcalc.errors import ConditionError, UsageError
from radcalc.given import read_coordinates


@define("direction", {"Angles": ("polar", "elevation", "azimuth")}, words="[X Y Z]")
def command(words: tuple[str, ...], typed: dict[str, str], asked: Asked, shown: Output) -> int:
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
    each = cases(typed)
    coordinates = words[0].split(",") if len(words) == 1 else list(words)
    if words and typed:
        raise ConditionError("a vector and angles contradict each other", "one of them")
    if not words and not typed:
        raise UsageError("a direction is missing", "X Y Z, or --polar 45deg --azimuth 30deg")
    vector = _of_words(coordinates) if words else None
    return run(each, lambda given: vector or of_angles(given), asked, shown, "direction")


def _of_words(coordinates: list[str]) -> Answer:
    if len(coordinates) != 3:
        raise UsageError(
            f"a vector has three coordinates, not {len(coordinates)}", "radcalc direction 1 1 1"
        )
    (x, y, z), unit = read_coordinates(coordinates)
    return of_vector(x, y, z, unit)
