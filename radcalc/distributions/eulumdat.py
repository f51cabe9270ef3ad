"""EULUMDAT files (.ldt): one number or text in each line, in a fixed order.

The lines, counted from 1, of a file with n lamp sets::

    1  company                          9  luminaire name        22  downward flux fraction [%]
    2  Ityp, 1 to 3 (0)                10  luminaire number      23  light output ratio, LORL [%]
    3  Isym, 0 to 4                    11  file name             24  conversion factor
    4  Mc, number of C planes          12  date and user         25  tilt in the measurement [deg]
    5  Dc, angle between them, or 0    13  to 21: sizes [mm]     26  n, number of lamp sets
    6  Ng, number of gamma angles
    7  Dg, angle between them, or 0    then n times: number of lamps, type, luminous flux [lm],
    8  report number                   colour, colour rendering, power with ballast [W]

followed by 10 direct ratios, Mc angles C, Ng angles gamma, and the intensities [cd per 1000 lm of
the first lamp set], plane by plane.  Isym defines which planes are present::

    0  all                   1  one, which represents all   2  C0 to C180
    3  C270 over C0 to C90   4  C0 to C90

Lamp sets are alternatives.  A negative number of lamps means absolute photometry: the flux is that
of the luminaire.  Numbers may have decimal commas.

References
----------
.. [1] A. W. Stockmar, EULUMDAT - ein Leuchtendatenformat fuer den europaeischen
   Beleuchtungsplaner, Licht '90 (1990) 641; as in the help of Photometric Toolbox,
   docs.agi32.com, "EULUMDAT file format".
.. [2] Handling of absolute photometry data in EULUMDAT files, DIAL and Lighting Analysts (2009).
"""

import math
from collections.abc import Sequence
from typing import Any, NoReturn

import numpy

from radcalc.distributions import distribution
from radcalc.distributions.distribution import Grid, Photometry
from radcalc.errors import ConditionError, quote
from radcalc.files import refusal
from radcalc.files.columns import MARKS, Decimals, finite, numbers_at_once

KILOLUMEN = 1000.0  # [lm]
MOST = 10_000  # angles, planes, lamps
GREATEST = 1e12  # flux [lm] or factor
STEP = 0.1  # [deg] rounding of listed angles, compared with the declared step
SYMMETRIES = {
    0: "",
    1: "the one C plane represents all (Isym 1)",
    2: "the planes C0 to C180 represent both sides of that plane (Isym 2)",
    3: "the planes are those from C270 over C0 to C90, and represent both sides (Isym 3)",
    4: "the planes C0 to C90 represent all four quadrants (Isym 4)",
}


def read(lines: Sequence[str], name: str) -> Photometry:
    """Read an EULUMDAT file.

    Returns
    -------
    Photometry
        Intensities [cd] in all planes, closed to a whole circle.  It declares `lamp-flux` and
        `output-ratio` (or `flux`, for absolute photometry), `downward-fraction` and
        `input-power`, if the file has them.

    Raises
    ------
    ConditionError
        With the line: for unexpected contents, angles that contradict the declared steps or the
        symmetry, negative intensities, and missing or superfluous lines.

    Notes
    -----
    ::

        I = table * conversion factor * luminous flux of the first lamp set / 1000 lm

    Examples
    --------
    A lamp of 1000 lm with 100 cd in every direction:

    >>> head = ["", 1, 1, 1, 0, 3, 90, *[""] * 14, 50, 100, 1, 0, 1, 1, "", 1000, "", "", 12]
    >>> lamp = read([str(x) for x in [*head, *[""] * 10, 0, 0, 90, 180, 100, 100, 100]], "lamp")
    >>> round(lamp.distribution.flux().value / math.pi, 9), lamp.declared["input-power"]
    (400.0, 12.0)
    """
    return _Reader(lines, name).photometry()


class _Reader:
    def __init__(self, lines: Sequence[str], name: str) -> None:
        end = len(lines)
        while end and not lines[end - 1].strip():
            end -= 1
        self.lines, self.name = lines[:end], name
        self.at = 0
        self.decimals = Decimals()
        self.assumptions: list[str] = []
        self.notes: list[str] = []

    def refuse(self, number: int, problem: str, hint: str) -> NoReturn:
        raise refusal(self.name, number, problem, hint)

    def text(self, what: str) -> str:
        if self.at >= len(self.lines):
            self.refuse(max(self.at, 1), f"the file ends here, before its {what}", "the whole file")
        self.at += 1
        return self.lines[self.at - 1].strip()

    def number(self, what: str, low: float = -math.inf, high: float = math.inf) -> float:
        text = self.text(what)
        value = finite(text, True)
        if value is None or not low <= value <= high:
            bounds = f" from {low:g} to {high:g}" if high < math.inf else f" of {low:g} or more"
            within = bounds if low > -math.inf else ""
            problem = f"'{quote(text)}' is not a valid {what}: it must be a number{within}"
            hint = "the original file; a line above may be missing or duplicated"
            self.refuse(self.at, problem, hint)
        if problem := self.decimals.conflict(text, self.at):
            self.refuse(self.at, problem, MARKS)
        return value

    def optional(self, what: str, low: float = -math.inf) -> float:
        """Return 0 for an empty line."""
        if self.at < len(self.lines) and not self.lines[self.at].strip():
            self.at += 1
            return 0.0
        return self.number(what, low)

    def whole(self, what: str, low: int, high: int = MOST) -> int:
        value = self.number(what, low, high)
        if value != int(value):
            problem = f"{value:g} is not a valid {what}: it must be a whole number"
            self.refuse(self.at, problem, "1, 2, 3 ...")
        return int(value)

    def photometry(self) -> Photometry:
        """Read the lines of the file in their order; refuse one that the format does not allow."""
        self.text("company")
        self.whole("type Ityp", 0, 3)
        symmetry = self.whole("symmetry Isym", 0, 4)
        planes, plane_step = self.whole("number Mc of C planes", 1), self.number("angle Dc", 0)
        self.check_planes(symmetry, planes)
        angles = self.whole("number Ng of gamma angles", 2)
        angle_step = self.number("angle Dg", 0)
        self.text("report number")
        luminaire = self.text("luminaire name")
        for what in ("luminaire number", "file name", "date"):
            self.text(what)
        sizes = [
            self.optional(f"{what} [mm]")
            for what in ("length", "width", "height") + ("size of the luminous area",) * 6
        ]
        size = max(sizes[3:5]) or max(sizes[:2])  # of the luminous area, or else of the luminaire
        declared = {
            "downward-fraction": self.optional("downward flux fraction [%]") / 100,
            "output-ratio": self.optional("light output ratio LORL [%]") / 100,
        }
        factor = self.number("conversion factor", 0, GREATEST)
        if not factor:
            self.refuse(self.at, "the conversion factor is 0", "1, or that of the measurement")
        tilt = self.optional("tilt [deg]")
        if tilt:
            self.notes.append(
                f"measured at a tilt of {tilt:g} deg; the directions are those of the table"
            )
        lumens = self.lamps(declared)
        stored = {0: planes, 1: 1, 4: planes // 4 + 1}.get(symmetry, planes // 2 + 1)
        self.skip_direct_ratios(planes + angles + stored * angles)
        start = self.at
        azimuths = self.angles("C", planes, plane_step, 360)
        polar = self.angles("gamma", angles, angle_step, 180)
        values = self.intensities(stored, angles)
        self.check_end()
        if doubt := self.decimals.doubt():
            self.refuse(*doubt)
        values *= factor * lumens / KILOLUMEN
        around, values = self.around(symmetry, azimuths, values, start)
        grid = Grid(numpy.radians(polar), numpy.radians(around), values)
        return Photometry(
            grid,
            f"EULUMDAT, Isym {symmetry}",
            quote(luminaire),
            {symbol: value for symbol, value in declared.items() if value > 0},
            (*self.assumptions, *distribution.end_of(polar)),
            tuple(self.notes),
            max(size, 0.0) / 1000,
        )

    def skip_direct_ratios(self, count: int) -> None:
        """Skip the direct ratios, if the file has more than the `count` numbers after them."""
        if len(self.lines) - self.at == count:
            self.notes.append("the file has no direct ratios; they are not needed")
        else:
            for k in range(10):
                self.optional(f"direct ratio {k + 1}")

    def check_end(self) -> None:
        for number, line in enumerate(self.lines[self.at :], self.at + 1):
            if line.strip():
                hint = "a file that ends there; a line may be duplicated, or Mc or Ng too small"
                self.refuse(number, f"'{quote(line.strip())}' follows the last intensity", hint)

    def check_planes(self, symmetry: int, planes: int) -> None:
        """Raise an error for the line of Mc if the number of planes does not fit the symmetry."""
        part = {2: 2, 3: 4, 4: 4}.get(symmetry, 1)
        if planes % part:
            problem = f"Mc is {planes}, which does not fit the symmetry (Isym {symmetry})"
            self.refuse(4, problem, f"a multiple of {part}")

    def lamps(self, declared: dict[str, float]) -> float:
        """Return the flux of the first lamp set [lm], and add what it declares."""
        sets = []
        for k in range(self.whole("number of lamp sets", 1)):
            count = self.whole(f"number of lamps of set {k + 1}", -MOST)
            self.text("type of lamps")
            lumens = self.number(f"luminous flux of lamp set {k + 1} [lm]", 0, GREATEST)
            line = self.at
            self.text("colour of lamps")
            self.text("colour rendering of lamps")
            sets.append((count, lumens, self.optional(f"power of lamp set {k + 1} [W]", 0), line))
        (count, lumens, power, line), *alternatives = sets
        if not lumens:
            self.refuse(line, "the first lamp set has 0 lm", "intensities are per 1000 lm of it")
        if alternatives:
            descriptions = ", ".join(
                f"{other[1]:g} lm, {other[2]:g} W" for other in alternatives[:3]
            )
            more = " ..." if len(alternatives) > 3 else ""
            self.notes.append(
                f"{len(sets)} lamp sets, which are alternatives: the first is used "
                f"({lumens:g} lm, {power:g} W), not {descriptions}{more}"
            )
        declared["input-power"] = power
        if count < 0:
            self.assumptions.append(
                f"absolute photometry (a negative number of lamps): {lumens:g} lm is the flux of "
                "the luminaire"
            )
            del declared["output-ratio"]
            declared["flux"] = lumens
        else:
            declared["lamp-flux"] = lumens
        return lumens

    def angles(self, what: str, count: int, step: float, highest: int) -> Any:
        """Read rising angles [deg]; they must have the declared step unless it is 0."""
        angles: list[float] = []
        for k in range(count):
            angle = self.number(f"angle {what} {k + 1} of {count}", 0, highest)
            if angles and angle - angles[-1] < distribution.CLOSEST:
                problem = f"the {what} angles do not rise: {angle:g} deg after {angles[-1]:g} deg"
                self.refuse(self.at, problem, f"{count} rising angles")
            if angles and step and abs(angle - angles[-1] - step) > STEP:
                self.refuse(
                    self.at,
                    f"the angle {what} {angle:g} deg, after {angles[-1]:g} deg, contradicts the "
                    f"declared step D{what[0].lower()} of {step:g} deg",
                    "the step of the angles listed in line 5 or 7, or 0 for uneven angles",
                )
            angles.append(angle)
        return numpy.array(angles)

    def intensities(self, planes: int, angles: int) -> Any:
        """Read the table [cd/klm], with a row for each plane."""
        start, count = self.at, planes * angles
        block = self.lines[start : start + count]
        is_plain = not (self.decimals.comma or self.decimals.doubtful)
        values = numbers_at_once(block) if is_plain else None
        if values is not None and len(values) == count:
            self.at += count
        else:
            what = "intensity {} of plane {} of " + str(planes)
            values = [
                self.number(what.format(k + 1, plane + 1))
                for plane in range(planes)
                for k in range(angles)
            ]
        table, notes = distribution.without_noise(
            numpy.array(values),
            lambda place, problem, hint: self.refuse(start + place + 1, problem, hint),
        )
        self.notes += notes
        return table.reshape(planes, angles)

    def around(self, symmetry: int, azimuths: Any, values: Any, start: int) -> tuple[Any, Any]:
        """Return the planes of the whole circle [deg], and their values."""
        if symmetry == 1 or len(azimuths) == 1:
            self.assumptions.append(
                SYMMETRIES[1] if symmetry == 1 else "the table has only one C plane"
            )
            return numpy.zeros(1), values
        if symmetry == 0:
            try:
                return distribution.closed(azimuths, values)
            except ConditionError as error:
                self.refuse(start + len(azimuths), error.message, error.hint)
        quarter, half = len(azimuths) // 4, len(azimuths) // 2
        for k, angle in {
            2: ((0, 0), (half, 180)),
            3: ((0, 0), (quarter, 90), (3 * quarter, 270)),
            4: ((0, 0), (quarter, 90)),
        }[symmetry]:
            if azimuths[k] != angle:
                problem = (
                    f"the plane C{azimuths[k]:g} is listed where the symmetry (Isym {symmetry}) "
                    f"requires C{angle}"
                )
                self.refuse(start + k + 1, problem, "as many planes on each of its sides")
        kept = {2: azimuths[: half + 1], 4: azimuths[: quarter + 1]}.get(
            symmetry, numpy.append(azimuths[3 * quarter :] - 360, azimuths[: quarter + 1])
        )
        around, values = distribution.mirrored(kept, values)
        images = numpy.sort(around[:-1] % 360)
        for k, (listed, image) in enumerate(zip(azimuths, images, strict=True)):
            if abs(listed - image) > STEP:
                problem = (
                    f"the plane C{listed:g} is listed where the symmetry (Isym {symmetry}) "
                    f"requires C{image:g}"
                )
                self.refuse(start + k + 1, problem, "planes that are mirror images of one another")
        self.assumptions.append(SYMMETRIES[symmetry])
        return around, values
