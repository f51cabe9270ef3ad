"""`radcalc direction X Y Z`, by its angles, or by a mirror."""

from radcalc.answer import Answer, texts_of
from radcalc.calculators.direction import ANGLES, MIRRORS, ON_BALL, direction
from radcalc.cli.calculator import Asked, run
from radcalc.cli.cases import cases
from radcalc.cli.command import define
from radcalc.cli.options import Output
from radcalc.errors import ConditionError, UsageError, option
from radcalc.given import Inputs, read_coordinates


@define(
    "direction",
    {"Angles": ANGLES, "Mirrors": ("mirror-ball", *MIRRORS)},
    words="[X Y Z]",
)
def command(words: tuple[str, ...], typed: dict[str, str], asked: Asked, shown: Output) -> int:
    """Give a direction in spherical coordinates and as a unit vector, or what a mirror makes of it.

    \b
    Examples:
      radcalc direction 1 1 1
      radcalc direction 3m 4m 0m -g length:cm -g azimuth:deg
      radcalc direction --polar 45deg --azimuth 30deg
      radcalc direction --elevation 10deg:80deg:10deg --azimuth 0deg -g z
      radcalc direction --mirror-ball 0.6,0
      radcalc direction 0.96 0 0.28 -g mirror-ball-u -g mirror-ball-v
      radcalc direction --polar 30deg --azimuth 0deg --reflect-at 0,0,1
      radcalc direction 0 0 1 --reflect-to 1,0,0                (the mirror's normal)

    The polar angle is counted from +z, the azimuth from +x towards +y; the elevation is 90
    degrees less the polar angle. Directions point away from a mirror: to where the light comes
    from, and to where it goes. A mirror ball is seen along -z from far away, x to the right and y
    up; where it shows a direction is a result when asked for by name: mirror-ball-u and
    mirror-ball-v, and mirror-ball-w, with which they are the ball's normal there.
    """
    each = cases(typed)
    coordinates = words[0].split(",") if len(words) == 1 else list(words)
    others = [name for name in typed if name not in MIRRORS]
    if words and others:
        what = option("mirror-ball") if "mirror-ball" in others else "angles"
        raise ConditionError(f"a vector and {what} contradict each other", "one of them")
    if not words and not others:
        raise UsageError("a direction is missing", "X Y Z, or --polar 45deg --azimuth 30deg")
    vector, unit = _read(coordinates) if words else (None, "")
    with_ball = any(map(asked.wants, ON_BALL))

    def work_out(given: Inputs) -> Answer:
        return direction(given, vector, unit, with_ball)

    operands = texts_of({"vector": ",".join(coordinates)})
    return run(each, work_out, asked, shown, "direction", operands=operands)


def _read(coordinates: list[str]) -> tuple[tuple[float, float, float], str]:
    if len(coordinates) != 3:
        raise UsageError(
            f"a vector has three coordinates, not {len(coordinates)}", "radcalc direction 1 1 1"
        )
    (x, y, z), unit = read_coordinates(coordinates)
    return (x, y, z), unit
