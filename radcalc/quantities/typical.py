"""Typical values of light: what the sun, the sky, the moon and some lamps give.

Orientation for a reader who wonders whether an answer can be right.  Where a table that goes
round in lecture notes is wrong, the value here is the corrected one, and the note says what is
wrong.  Numbers are texts, with the digits that the source has.
"""

from typing import NamedTuple

from radcalc.errors import RadcalcError, UsageError, nearest, quote
from radcalc.quantities.language import ENGLISH, LANGUAGES
from radcalc.quantities.light import name_of
from radcalc.quantities.names import QUANTITIES
from radcalc.quantities.search import called, comparable, matching
from radcalc.units.table import resolve

LECTURES = "lecture tables"
IAU = "IAU 2015 resolution B3"
MAGNITUDES = "Wikipedia, Orders of magnitude (illuminance)"
MAGNITUDES_L = "Wikipedia, Orders of magnitude (luminance)"
OVERCAST = "CIE overcast sky: E = 7 pi L/9"
THINGS = ("sun", "moon", "sky", "cloud", "starlight", "window", "lamp", "laser")


class Typical(NamedTuple):
    """A value in a unit: a number, or a range such as `0.1 to 0.3`."""

    what: str
    value: str
    unit: str
    source: str
    note: str = ""

    @property
    def low(self) -> float:
        """The value, or where its range begins."""
        return float(self.value.partition(" to ")[0])

    @property
    def high(self) -> float:
        """The value, or where its range ends."""
        return float(self.value.rpartition(" to ")[2])

    @property
    def quantity(self) -> str:
        """The quantity's English name, as the unit has it."""
        return name_of(resolve(self.unit))


SUN, GROUND = "sun outside the atmosphere", "sun at the ground"
VALUES = (
    Typical(SUN, "1361", "W/m2", IAU, "older texts have 1367 W/m2"),
    Typical(SUN, "133", "klx", "ASTM G173-03: radcalc spectrum AM0"),
    Typical(
        SUN,
        "2.0e7",
        "W/m2/sr",
        "1361 W/m2 over the disc's 6.794e-5 sr",
        "the 2.3e7 of some texts is a black body of 6000 K, and does not fit 1367 W/m2 either",
    ),
    Typical(SUN, "2.0e9", "cd/m2", "133 klx over the disc's 6.794e-5 sr"),
    Typical(f"{GROUND}, winter noon, direct, facing it", "852", "W/m2", LECTURES),
    Typical(f"{GROUND}, winter noon, all light on a horizontal plane", "686", "W/m2", LECTURES),
    Typical(f"{GROUND}, clear, at most", "1000", "W/m2", LECTURES),
    Typical(f"{GROUND}, clear, at most", "100 to 110", "klx", f"{MAGNITUDES}: 110 klx"),
    Typical(
        f"{GROUND}, winter noon, disc",
        "1.25e7",
        "W/m2/sr",
        "852 W/m2 over the disc's 6.794e-5 sr",
        "the 1.4e7 of lecture tables implies 951 W/m2, not the 852 beside it",
    ),
    Typical(f"{GROUND}, disc at noon", "1.6e9", "cd/m2", MAGNITUDES_L),
    Typical(
        "overcast day",
        "10000",
        "lx",
        LECTURES,
        "the 300 cd/m2 of the same tables is a darker day's sky, of 733 lx",
    ),
    Typical("at a window by day", "1000", "lx", LECTURES),
    Typical("least light to work by", "100", "lx", LECTURES),
    Typical(
        "full moon",
        "0.1 to 0.3",
        "lx",
        f"{MAGNITUDES}: 0.25 lx",
        "the 0.02 lx of lecture notes is ten times too low",
    ),
    Typical("starlight, clear night without moon", "0.0002 to 0.002", "lx", MAGNITUDES),
    Typical("sunlit cloud", "30000", "cd/m2", LECTURES),
    Typical("clear sky", "3000", "cd/m2", LECTURES),
    Typical("overcast sky that gives 10 klx, its zenith", "4093", "cd/m2", OVERCAST),
    Typical(
        "overcast sky, dark, its zenith",
        "300",
        "cd/m2",
        LECTURES,
        "gives 733 lx, not the 10 klx that the same tables have for an overcast day",
    ),
    Typical(
        "moon's disc",
        "2500 to 5000",
        "cd/m2",
        f"{MAGNITUDES_L}: 2500 cd/m2",
        "the 0.03 cd/m2 of lecture notes is a white wall in moonlight",
    ),
    Typical("tungsten lamp, gas-filled, 100 W", "82", "W", LECTURES),
    Typical("fluorescent lamp, 40 W", "23.2", "W", LECTURES),
    Typical("He-Ne laser, 632.8 nm", "5", "mW", "a common rating"),
    Typical("He-Ne laser, 632.8 nm, of 5 mW", "0.81", "lm", "Km V(λ), CIE 018:2019"),
    Typical("sun's disc", "6.794e-5", "sr", "radius 695700 km (IAU 2015) from 1 au"),
    Typical("moon's disc", "6.418e-5", "sr", "radius 1737.4 km from 384400 km"),
)


def words() -> tuple[str, ...]:
    """What is worth searching for: things, and the names of the quantities, each as one word."""
    measured = {value.quantity for value in VALUES}
    there = [q for q in QUANTITIES if q.name(ENGLISH) in measured]
    return (*THINGS, *(q.name(one).replace(" ", "-") for one in LANGUAGES for q in there))


def search(text: str) -> list[Typical]:
    """Find values by their quantity, in any language, by a unit, by words; all, without a text.

    The first of these that finds anything decides; raises UsageError where none does.
    """
    text = text.strip()
    if not text:
        return list(VALUES)
    found = _of_quantity(text) or _in_unit(text)
    found = found or matching(text, VALUES, lambda v: f"{v.what} {v.quantity}")
    found = found or matching(text, VALUES, lambda v: f"{v.note} {v.source}", str.__eq__)
    if found:
        return found
    words = {word for v in VALUES for word in comparable(f"{v.what} {v.quantity}").split()}
    near = nearest(comparable(text), words, cutoff=0.75)
    raise UsageError(
        f"there is no typical value for '{quote(text)}'",
        ", ".join(near) or "radcalc typical, which lists them all",
    )


def _of_quantity(text: str) -> list[Typical]:
    meant = {f.quantity.name("en") for f in called(text)}
    return [value for value in VALUES if value.quantity in meant]


def _in_unit(text: str) -> list[Typical]:
    try:
        dimension = resolve(text).dimension
    except RadcalcError:
        return []
    return [value for value in VALUES if resolve(value.unit).dimension == dimension]
