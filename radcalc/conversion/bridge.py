"""Two units of different quantities, and the missing conditions between them.

Formulas of textbooks are typed as expressions without the steradian: I / d^2, Phi / (4 pi).
"""

from collections.abc import Iterable, Sequence

from radcalc import errors
from radcalc.conversion.geometric import (
    AREA,
    AT_RADIANCE,
    BAND,
    CONE,
    DISTANCE,
    FLUX,
    INTENSITY,
    IRRADIANCE,
    PLAIN,
    PUPIL,
    RADIANCE,
    REFLECTANCE,
    RESPONSIVITY,
    TIME,
    Conditions,
    Factor,
    Way,
)
from radcalc.errors import manual, option, quote
from radcalc.maths import is_array
from radcalc.quantities import PHOTON, Reading, coherent_text, describe, read
from radcalc.tuples import NamedTuple
from radcalc.units import Daily, Unit
from radcalc.units.table import resolve

SQUARE = r"\(\s*[\d.]+\s*[a-zµ]+\s*\)\s*(?:\^\s*2|\*\*\s*2|²)"  # of a length
PI = r"(?:pi|π)"
# The quantity of the expression and that of the target; what the expression has; the law.
FORMS = (
    (RADIANCE, IRRADIANCE, rf"/\s*{SQUARE}", "E = I Omega0 / d^2"),
    (FLUX, INTENSITY, rf"\*\s*{SQUARE}|{SQUARE}\s*\*", "I = E d^2 / Omega0"),
    (FLUX, INTENSITY, rf"/\s*\(\s*4\s*\*?\s*{PI}\s*\)", "I = Phi / (4 pi Omega0)"),
    (IRRADIANCE, RADIANCE, rf"/\s*{PI}(?!\w)", "L = rho E / (pi Omega0)"),
    (RADIANCE, IRRADIANCE, rf"(?:^|[*\s(]){PI}\s*\*|\*\s*{PI}(?!\w)", "M = pi Omega0 L"),
)


def as_law(text: str, source: Unit, target: Unit) -> Unit:
    """Return the unit of an expression with the steradian of its law, which a note names.

    The unit is unchanged if the expression is not one of `FORMS`.
    Raises ConversionError if it is a product that lacks the steradian of one of them.
    """
    import re

    start, end = read(source), read(target)
    if start is None or end is None or (start.kind, start.time) != (end.kind, end.time):
        return source
    forms = [form for form in FORMS if (start.geometry[1:], end.geometry[1:]) == form[:2]]
    for here, _, pattern, law in forms:
        if re.search(pattern, text):
            power = "/sr" if here in (FLUX, IRRADIANCE) else ".sr"
            complete = resolve(f"({source.text}){power}")
            return complete.of_class(Unit, f"sr read into the formula: {law}")
    if forms and any(sign in text.replace(source.text, "") for sign in "/*"):
        laws = " or ".join(law for *_, law in forms)
        raise errors.ConversionError(
            f"'{quote(text)}' is in {source.text}, and {target.text} differs by a steradian",
            f"{laws}, with the distance in brackets as in (10 m)^2 and pi as pi; or sr where it "
            "belongs",
        )
    return source


Links = list[tuple[Factor, int]]
KIND, AXIS, PER_LENGTH, PROJECTED = "kind", "axis", "per length", "projected solid angle"


class Wanted(NamedTuple):
    """A missing condition: its description, the symbols that supply it, and likely values."""

    phrase: str
    hint: str
    choices: tuple[errors.Try, ...] = ()


_WAVELENGTH = option("wavelength", "LAMBDA")
_CONE = option("half-angle", "ANGLE")
_INTO_CONE = errors.add("half-angle", "30deg", "evenly into a cone")
WANTED = {
    KIND: Wanted(
        "a wavelength, a spectrum or an efficacy",
        f"{_WAVELENGTH}, {option('spectrum', 'SOURCE')} or {option('efficacy', 'RATIO')}",
        (
            errors.add("spectrum", "sun", "sunlight (AM1.5G)"),
            errors.add("spectrum", "LED-B3", "a white LED"),
            errors.add("wavelength", "555nm", "green light of one wavelength"),
        ),
    ),
    AXIS: Wanted("a wavelength", _WAVELENGTH, (errors.add("wavelength", "555nm"),)),
    PER_LENGTH: Wanted(
        "a length",
        f"the number times that length ({option('bandwidth')} is for densities written with nm, "
        "um, angstrom)",
    ),
    BAND: Wanted("a bandwidth", option("bandwidth", "WIDTH"), (errors.add("bandwidth", "10nm"),)),
    TIME: Wanted(
        "a time", option("time", "T"), (errors.add("time", "1h"), errors.add("time", "1s"))
    ),
    "photoperiod": Wanted(
        "the time of light in a day",
        option("photoperiod", "T"),
        tuple([errors.add("photoperiod", f"{hours}h") for hours in (12, 16, 18)]),
    ),
    PUPIL: Wanted(
        "the pupil's diameter",
        option("pupil", "DIAMETER"),
        (errors.add("pupil", "3mm", "a pupil in daylight"),),
    ),
    RESPONSIVITY: Wanted(
        "the detector's responsivity",
        option("responsivity", "S"),
        (errors.add("responsivity", "0.4A/W", "silicon, in red light"),),
    ),
    AREA: Wanted(
        "an area", option("area", "A"), (errors.add("area", "1m2", "evenly over an area"),)
    ),
    CONE: Wanted(
        "a solid angle",
        f"{option('isotropic')}, {_CONE} or {option('solid-angle', 'OMEGA')}",
        (errors.add("isotropic", "", "evenly in all directions"), _INTO_CONE),
    ),
    PROJECTED: Wanted(
        "a projected solid angle",
        f"{_CONE} or {option('hemisphere')}",
        (errors.add("hemisphere", "", "evenly bright in the whole hemisphere"), _INTO_CONE),
    ),
    DISTANCE: Wanted("a distance", option("distance", "D"), (errors.add("distance", "2m"),)),
    REFLECTANCE: Wanted(
        "a reflectance",
        option("reflectance", "RHO"),
        (errors.add("reflectance", "0.5", "a matte surface"),),
    ),
}


class Bridge:
    """Two units of different quantities, the given conditions and the missing ones."""

    def __init__(
        self, source: Unit, target: Unit, conditions: Conditions, number: str = "1"
    ) -> None:
        self.source, self.target, self.conditions = source, target, conditions
        self.number, self.amount = number, joined(number, quote(source.text))
        self.lacking: dict[str, Wanted] = {}

    @property
    def heading(self) -> str:
        return f"cannot convert {describe(self.source)} to {describe(self.target)}"

    def want(self, what: str) -> None:
        self.lacking[what] = WANTED[what]

    def want_space(self, rows: Iterable[Way], given: set[str]) -> None:
        """Add the conditions that at most two ways between area and solid angle lack."""
        rows = tuple(rows)
        extending = [way for way in rows if way.extends and given and given < set(way.powers)]
        sensible = [way for way in rows if way.is_suggested] or list(rows)
        alternatives: dict[str, str] = {}
        tries: list[errors.Try] = []
        start = read(self.source)
        start_shines = start is not None and start.is_radiance
        for way in (extending or sensible)[:2]:
            self.conditions.used |= given & set(way.powers)
            wanted = [
                PROJECTED if slot == CONE and way.supply is AT_RADIANCE else slot
                for slot in PLAIN
                if slot in way.powers and slot not in given
            ]
            phrases, hints, choices = zip(*(WANTED[slot] for slot in wanted), strict=True)
            alternatives[" and ".join(phrases)] = " with ".join(hints)
            calls = together(choices)
            if start_shines and REFLECTANCE not in wanted:
                tries = [*calls, *tries]  # a surface that shines is commoner than one that reflects
            else:
                tries += calls
        plain = all(" and " not in phrase for phrase in alternatives)
        phrase = (" or " if plain else ", or ").join(alternatives)
        self.lacking["space"] = Wanted(phrase, ", or ".join(alternatives.values()), tuple(tries))

    def refuse(self) -> None:
        unused = self.conditions.unused
        if AXIS in self.lacking:
            self.lacking.pop(KIND, None)  # a wavelength supplies both
        if self.lacking:
            raise self._missing(unused)
        if unused:
            where = f"to the conversion of {describe(self.source)} to {describe(self.target)}"
            raise errors.Unused(unused, where, self._instead(unused))

    def _instead(self, unused: Sequence[str]) -> errors.Hint:
        """Return the probable intention of an unused condition between units of one quantity."""
        start, end = read(self.source), read(self.target)
        if start is None or end is None or start != end or len(self.conditions.given) > 1:
            return ""
        given = next(
            condition for condition in self.conditions.given.values() if condition.name == unused[0]
        )
        if given.name == "photoperiod":  # a rate of mol/m2/day counts all 24 h
            rates = [unit.text for unit in (self.source, self.target) if unit.text.endswith(SLOW)]
            return (
                errors.correct(rates[0], "dli", remark="the sum of a day")
                if len(rates) == 1
                else ""
            )
        is_one = not is_array(given.value)
        if given.name == "reflectance" and is_one and start.area and not start.solid_angle:
            number = f"{self.number}*{given.value:.12g}"
            units = quote(self.source.text), quote(self.target.text)
            return errors.call("convert", number, *units, remark="the reflected part")
        if given.name == TIME and not start.time:
            slow = self.source.text.endswith(SLOW) and not self.target.text.endswith(SLOW)
            rate = self.source if slow else self.target
            total = _over_time(rate, end)
            return errors.correct(rate.text, total, remark="in all of that time")
        return ""

    def _missing(self, unused: Sequence[str]) -> errors.MissingCondition:
        """Return the error that names the missing conditions, with hints and calls."""
        phrases, hints, choices = zip(*self.lacking.values(), strict=True)
        several = len(phrases) > 1
        listed = several and any(" or " in phrase for phrase in phrases)
        comma = "," if listed or any(", or " in phrase for phrase in phrases) else ""
        message = (
            f"{self.heading}: {f'{comma} and '.join(phrases)}{comma} "
            f"{'are' if several or _is_plural(phrases[0]) else 'is'} missing"
        )
        if unused:
            useless = errors.options(unused, " and ")
            message += f"; {useless} {'does' if len(unused) == 1 else 'do'} not apply"
        hint = f"{'; and '.join(hints)} (see {manual('convert')})"
        missing = {wanted.phrase: errors.mentioned(wanted.hint) for wanted in self.lacking.values()}
        tries = [*self._as_ppfd(), *together(choices, tuple(unused))]
        if PER_LENGTH in self.lacking and not unused:
            product = f"{self.number} {quote(self.source.text)} * 1 m"
            tries = [
                errors.call(
                    "convert", product, quote(self.target.text), remark="over 1 m, an example"
                )
            ]
        return errors.MissingCondition(
            message, hint, self.source.text, self.target.text, missing, tries
        )

    def _as_ppfd(self) -> list[errors.Try]:
        """Propose PPFD for a number of photons in umol, as growers say it."""
        for unit, other in ((self.source, self.target), (self.target, self.source)):
            own, on_area = read(unit), read(other)
            is_number = own and own.kind == PHOTON and own.geometry == (1, 0, 0)
            if is_number and on_area and on_area.geometry[1:] == (1, 0):
                light = WANTED[KIND].choices[:1] if KIND in self.lacking else ()
                inputs = [given for choice in light for given in choice.inputs]
                inputs += [("photoperiod", "16h")] if isinstance(other, Daily) else []
                remark = ", ".join(["PPFD: umol/m2/s", *[choice.remark for choice in light]])
                return [
                    errors.Try(tuple(inputs), instead=(quote(unit.text), "ppfd"), remark=remark)
                ]
        return []


def joined(number: str, unit: str) -> str:
    """Return an amount as one word: 2m, 500/cm."""
    return f"{number}{unit.removeprefix('1')}"


def together(
    choices: Sequence[Sequence[errors.Try]], without: tuple[str, ...] = ()
) -> list[errors.Try]:
    """Return calls with a choice for each of several inputs: the first of all, then others."""
    if not all(choices):
        return []
    first = [of_one[0] for of_one in choices]
    combined = [first]
    for k, of_one in enumerate(choices):
        combined += [[*first[:k], other, *first[k + 1 :]] for other in of_one[1:]]
    return [
        errors.Try(
            tuple([given for proposal in chosen for given in proposal.inputs]),
            without,
            remark=", ".join([proposal.remark for proposal in chosen if proposal.remark]),
        )
        for chosen in combined
    ]


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
