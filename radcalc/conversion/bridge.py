"""Two units of different quantities, and the missing conditions between them."""

from collections.abc import Iterable, Sequence

from radcalc.conversion.conditions import (
    AREA,
    BAND,
    CONE,
    DISTANCE,
    PUPIL,
    REFLECTANCE,
    RESPONSIVITY,
    TIME,
    Conditions,
    Factor,
)
from radcalc.conversion.ways import AT_RADIANCE, PLAIN, Way
from radcalc.errors import MissingCondition, Unused, command, manual, option, options, quote
from radcalc.inputs.given import Input
from radcalc.quantities.light import PHOTON, Reading, coherent_text, describe, read
from radcalc.units.unit import Unit

Links = list[tuple[Factor, int]]
KIND, AXIS, PER_LENGTH, PROJECTED = "kind", "axis", "per length", "projected solid angle"
_WAVELENGTH = option("wavelength", "LAMBDA")
_CONE = option("half-angle", "ANGLE")
# Descriptions of missing conditions, and the symbols that supply them.
WANTED = {
    KIND: (
        "a wavelength, a spectrum or an efficacy",
        f"{_WAVELENGTH}, {option('spectrum', 'SOURCE')} or {option('efficacy', 'RATIO')}",
    ),
    AXIS: ("a wavelength", _WAVELENGTH),
    PER_LENGTH: (
        "a length",
        f"the number times that length ({option('bandwidth')} is for densities written with nm, "
        "um, angstrom)",
    ),
    BAND: ("a bandwidth", option("bandwidth", "WIDTH")),
    TIME: ("a time", option("time", "T")),
    PUPIL: ("the pupil's diameter", option("pupil", "DIAMETER")),
    RESPONSIVITY: ("the detector's responsivity", option("responsivity", "S")),
    AREA: ("an area", option("area", "A")),
    CONE: ("a solid angle", f"{option('isotropic')}, {_CONE} or {option('solid-angle', 'OMEGA')}"),
    PROJECTED: ("a projected solid angle", f"{_CONE} or {option('hemisphere')}"),
    DISTANCE: ("a distance", option("distance", "D")),
    REFLECTANCE: ("a reflectance", option("reflectance", "RHO")),
}


class Bridge:
    """Two units of different quantities, the given conditions and the missing ones."""

    def __init__(
        self, source: Unit, target: Unit, given: Sequence[Input], number: str = "1"
    ) -> None:
        self.source, self.target = source, target
        self.number, self.amount = number, f"{number}{quote(source.text)}"
        self.conditions = Conditions(given)
        self.lacking: dict[str, tuple[str, str]] = {}

    @property
    def heading(self) -> str:
        return f"cannot convert {describe(self.source)} to {describe(self.target)}"

    def want(self, what: str) -> None:
        self.lacking[what] = WANTED[what]

    def want_space(self, rows: Iterable[Way], given: set[str]) -> None:
        rows = tuple(rows)
        extending = [way for way in rows if way.extends and given and given < set(way.powers)]
        sensible = [way for way in rows if way.is_suggested] or list(rows)
        alternatives: dict[str, str] = {}
        for way in (extending or sensible)[:2]:
            self.conditions.used |= given & set(way.powers)
            wanted = [
                PROJECTED if slot == CONE and way.supply is AT_RADIANCE else slot
                for slot in PLAIN
                if slot in way.powers and slot not in given
            ]
            phrases, hints = zip(*(WANTED[slot] for slot in wanted), strict=True)
            alternatives[" and ".join(phrases)] = " with ".join(hints)
        plain = all(" and " not in phrase for phrase in alternatives)
        phrase = (" or " if plain else ", or ").join(alternatives)
        self.lacking["space"] = (phrase, ", or ".join(alternatives.values()))

    def refuse(self) -> None:
        unused = self.conditions.unused
        if AXIS in self.lacking:
            self.lacking.pop(KIND, None)  # a wavelength supplies both
        if self.lacking:
            raise self._missing(unused)
        if unused:
            where = f"to the conversion of {describe(self.source)} to {describe(self.target)}"
            raise Unused(unused, where, self._instead(unused))

    def _instead(self, unused: Sequence[str]) -> str:
        """Return the probable intention of an unused condition between units of one quantity."""
        start, end = read(self.source), read(self.target)
        if start is None or end is None or start != end or len(self.conditions.given) > 1:
            return ""
        given = next(
            condition for condition in self.conditions.given.values() if condition.name == unused[0]
        )
        if given.name == "reflectance" and start.area and not start.solid_angle:
            number = f"{self.number}*{given.value:.12g}"
            again = command("convert", number, quote(self.source.text), quote(self.target.text))
            return f"{again}, which is the reflected part"
        if given.name == TIME and not start.time:
            slow = self.source.text.endswith(SLOW) and not self.target.text.endswith(SLOW)
            rate = self.source if slow else self.target
            total = _over_time(rate, end)
            return f"{total} in place of {quote(rate.text)}, for all of that time"
        return ""

    def _missing(self, unused: Sequence[str]) -> MissingCondition:
        phrases, hints = zip(*self.lacking.values(), strict=True)
        several = len(phrases) > 1
        listed = several and any(" or " in phrase for phrase in phrases)
        comma = "," if listed or any(", or " in phrase for phrase in phrases) else ""
        message = (
            f"{self.heading}: {f'{comma} and '.join(phrases)}{comma} "
            f"{'are' if several or _is_plural(phrases[0]) else 'is'} missing"
        )
        if unused:
            useless = options(unused, " and ")
            message += f"; {useless} {'does' if len(unused) == 1 else 'do'} not apply"
        hint = f"{'; and '.join(hints)} (see {manual('convert')})"
        return MissingCondition(message, hint, self.source.text, self.target.text, phrases)


def _is_plural(phrase: str) -> bool:
    """Return whether a phrase is like `an area and a solid angle`, without alternatives."""
    return " and " in phrase and " or " not in phrase


SLOW = ("/min", "/h", "/hour", "/d", "/day")  # of an amount per that time


def _over_time(unit: Unit, reading: Reading) -> str:
    """Return the unit of a rate summed over a time: mol/m2 for mol/m2/day, lm.s for lm."""
    rates = ("/s", *SLOW) if reading.kind == PHOTON else SLOW
    for rate in rates:
        if unit.text.endswith(rate):
            return quote(unit.text.removesuffix(rate))
    return coherent_text(reading._replace(time=1)).replace(" ", ".")
