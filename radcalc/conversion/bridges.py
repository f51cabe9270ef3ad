"""What stands between two different quantities, and which of the given conditions supply it.

The two quantities' facts (kind, time, area, solid angle, axis of density) are subtracted; each
difference needs a condition.  Area and solid angle can be bridged in more than one way, so there
the exponents -1, 0, +1 of the conditions are searched: no way is a refusal that names what is
missing, and a condition without use, or one too many, is refused as well.
"""

from collections.abc import Iterable, Sequence
from itertools import product

from radcalc.conversion import conditions as c
from radcalc.conversion import geometric, spectral
from radcalc.conversion.conditions import Factor, Given
from radcalc.errors import ConditionError, ConversionError, RadcalcError, quote
from radcalc.maths import any_true
from radcalc.quantities.light import (
    FREQUENCY,
    KIND_NAMES,
    LUMINOUS,
    NONE,
    PHOTON,
    RADIANT,
    SOLID_ANGLE,
    WAVENUMBER,
    Reading,
    describe,
    is_exitance,
    is_per_length,
    powers,
    read,
)
from radcalc.units.table import Unit

Links = list[tuple[Factor, int]]

# What multiplying by each condition does to the powers of 1/area and 1/solid angle.
SPATIAL = {
    c.AREA_SLOT: (-1, 0),
    c.CONE: (0, -1),
    c.DISTANCE: (1, -1),
    c.REFLECTANCE: (0, 1),
}
# The sets of them that are worth suggesting to somebody who gave none.
SUGGESTED = (
    {c.CONE},
    {c.REFLECTANCE},
    {c.AREA_SLOT},
    {c.DISTANCE},
    {c.AREA_SLOT, c.REFLECTANCE},
    {c.DISTANCE, c.REFLECTANCE},
)
PROJECTED = "projected solid angle"
KIND, AXIS, PER_LENGTH = "kind", "axis", "per length"
# What is missing, and the options that supply it.
WANTED = {
    KIND: (
        "a wavelength, a spectrum or an efficacy",
        "--wavelength LAMBDA, --spectrum SOURCE or --efficacy RATIO",
    ),
    AXIS: ("a wavelength", "--wavelength LAMBDA"),
    PER_LENGTH: (
        "a length",
        "the number times that length (--bandwidth is for densities written with nm, um, angstrom)",
    ),
    c.BAND: ("a bandwidth", "--bandwidth WIDTH"),
    c.TIME: ("a time", "--time T"),
    c.PUPIL: ("the pupil's diameter", "--pupil DIAMETER"),
    c.AREA_SLOT: ("an area", "--area A"),
    c.CONE: ("a solid angle", "--isotropic, --half-angle ANGLE or --solid-angle OMEGA"),
    PROJECTED: ("a projected solid angle", "--half-angle ANGLE or --hemisphere"),
    c.DISTANCE: ("a distance", "--distance D"),
    c.REFLECTANCE: ("a reflectance", "--reflectance RHO"),
}


class _Search:
    """The conditions given, by slot, and which have found a use."""

    def __init__(self, source: Unit, target: Unit, given: Sequence[Given]) -> None:
        self.source = source
        self.target = target
        self.given: dict[str, Given] = {}
        self.used: set[str] = set()
        self.missing: dict[str, tuple[str, str]] = {}
        for one in given:
            slot = one.option.name if one.option.slot == c.REFINES else one.option.slot
            if slot in self.given:
                raise ConditionError(
                    f"{self.given[slot].flag} and {one.flag} contradict each other: "
                    f"both supply {'the link of kinds' if slot == c.LINK else f'the {slot}'}",
                    "one of them",
                )
            self.given[slot] = one

    def use(self, slot: str) -> Given | None:
        """Take a condition, so that it counts as used."""
        if slot in self.given:
            self.used.add(slot)
        return self.given.get(slot)

    def want(self, slot: str) -> None:
        """Note that a condition is missing."""
        self.missing[slot] = WANTED[slot]

    def wavelength(self) -> spectral.Light | None:
        """The wavelength given, or None; used, with its observer where it is one of light seen."""
        given = self.given.get(c.LINK)
        if given is None or given.option.name != "wavelength":
            return None
        self.used.add(c.LINK)
        return spectral.light(given, self.given.get("observer"))

    def heading(self) -> str:
        return f"cannot convert {describe(self.source)} to {describe(self.target)}"


def link(source: Unit, target: Unit, given: Sequence[Given]) -> Links:
    """Find the factors, with their powers, that turn the source's quantity into the target's."""
    search = _Search(source, target, given)
    start, end = read(source), read(target)
    links: Links = []
    if source.dimension != target.dimension:
        if start is None or end is None:
            raise _unlike(search)
        links += _kind(search, start, end)
        links += _axis(search, start, end)
        links += _time(search, start, end)
        links += _pupil(search, start, end)
        links += _space(search, start, end)
    unused = [one.flag for slot, one in search.given.items() if slot not in search.used]
    useless = f"{' and '.join(unused)} {'has' if len(unused) == 1 else 'have'} no use"
    if AXIS in search.missing:
        search.missing.pop(KIND, None)  # a wavelength supplies both
    if search.missing:
        phrases, hints = zip(*search.missing.values(), strict=True)
        several = len(phrases) > 1
        listed = several and any(" or " in phrase for phrase in phrases)
        comma = "," if listed or any(", or " in phrase for phrase in phrases) else ""
        raise ConversionError(
            f"{search.heading()}: {f'{comma} and '.join(phrases)}{comma} "
            f"{'are' if several else 'is'} missing" + (f"; {useless}" if unused else ""),
            f"{'; and '.join(hints)} (see radcalc convert --help)",
        )
    if unused:
        raise ConditionError(
            f"{useless} in converting {describe(source)} to {describe(target)}",
            f"the same without {' and '.join(unused)}",
        )
    return links


def _unlike(search: _Search) -> RadcalcError:
    """Refuse two quantities of which one is no light quantity: no condition links them."""
    per_second = powers(time=-1)
    if per_second in (search.source.dimension, search.target.dimension):
        return ConversionError(
            f"{search.heading()}: a frequency counts cycles", "Hz, or cycle/s, for a frequency"
        )
    spectral = c.OPTIONS["wavelength"].dimensions
    if search.source.dimension in spectral and search.target.dimension in spectral:
        return ConversionError(
            f"{search.heading()}: no condition links them, but a photon has both",
            f"radcalc photon 1{quote(search.source.text)}, with your number",
        )
    if {search.source.dimension, search.target.dimension} == {c.ANGLE, SOLID_ANGLE}:
        option = "half-angle" if search.source.dimension == c.ANGLE else "solid-angle"
        return ConversionError(
            f"{search.heading()}: no condition links them, a solid angle depends on the shape",
            f"radcalc solid-angle cone --{option} 1{quote(search.source.text)}, with your number",
        )
    hint = "radcalc units UNIT, which shows what a unit measures"
    if notes := search.source.notes + search.target.notes:
        hint = "; ".join(notes)
    elif search.target.atoms and all(power < 0 for _, power in search.target.atoms):
        both = f"{search.source.text} {search.target.text}"
        hint = f"quotes around '{quote(both)}', if that is one unit"
    return ConversionError(
        f"{search.heading()}: they are different quantities, and no condition links them", hint
    )


def _kind(search: _Search, start: Reading, end: Reading) -> Links:
    """Between radiant, luminous and photon."""
    if start.kind == end.kind:
        return []
    light = search.wavelength()
    if light is not None:
        if LUMINOUS in (start.kind, end.kind):
            search.use("observer")
        return [(spectral.kind_factor(light, end.kind, start.kind), 1)]
    given = search.use(c.LINK)
    if given is None:
        search.want(KIND)
        return []
    if given.option.name == "spectrum":
        return [(_spectral(search, given, start, end), 1)]
    factor = spectral.given_ratio(given, end.kind, start.kind)
    if factor is None:
        raise ConditionError(
            f"--efficacy {given.text} does not link {KIND_NAMES[start.kind]} "
            f"and {KIND_NAMES[end.kind]} quantities",
            {
                "ev": "--efficacy 93lm/W",
                "ep": "--efficacy 2.1umol/J",
                "pv": "--efficacy 54lm.s/umol",
            }["".join(sorted((start.kind, end.kind)))],
        )
    return [(factor, 1)]


def _spectral(search: _Search, given: Given, start: Reading, end: Reading) -> Factor:
    """By a whole spectrum, with what refines it."""
    if start.axis or end.axis:
        raise ConditionError(
            f"{search.heading()}: --spectrum links whole bands, not spectral densities",
            "--wavelength LAMBDA for a density",
        )
    both = {start.kind, end.kind}
    return spectral.spectral_factor(
        given,
        end.kind,
        start.kind,
        search.use("range") if RADIANT in both else None,
        search.use("photon-range") if PHOTON in both else None,
        search.use("observer") if LUMINOUS in both else None,
    )


def _axis(search: _Search, start: Reading, end: Reading) -> Links:
    """Between spectral densities, and between a density and a band."""
    if start.axis == end.axis:
        return []
    if NONE not in (start.axis, end.axis):
        return _jacobian(search, start.axis, end.axis)
    band = search.use(c.BAND)
    if band is None:
        strip = any(is_per_length(unit) for unit in (search.source, search.target))
        search.want(PER_LENGTH if strip else c.BAND)
        return []
    of_kind = search.given.get(c.LINK) if start.kind != end.kind else None
    width = spectral.bandwidth(band, of_kind)
    if end.axis == NONE:
        return [*_jacobian(search, start.axis, spectral.band_axis(band)), (width, 1)]
    return [(width, -1), *_jacobian(search, spectral.band_axis(band), end.axis)]


def _jacobian(search: _Search, start: str, end: str) -> Links:
    if start == end:
        return []
    if {start, end} == {FREQUENCY, WAVENUMBER}:
        return [(spectral.jacobian(None, start, end), 1)]
    light = search.wavelength()
    if light is None:
        search.want(AXIS)
        return []
    return [(spectral.jacobian(light, start, end), 1)]


def _time(search: _Search, start: Reading, end: Reading) -> Links:
    """Between energy and flux, exposure and irradiance."""
    if start.time == end.time:
        return []
    given = search.use(c.TIME)
    if given is None:
        search.want(c.TIME)
        return []
    return [(geometric.duration(given), end.time - start.time)]


def _pupil(search: _Search, start: Reading, end: Reading) -> Links:
    """Between luminance and trolands."""
    if start.retinal == end.retinal:
        return []
    given = search.use(c.PUPIL)
    if given is None:
        search.want(c.PUPIL)
        return []
    return [(geometric.pupil(given), 1 if end.retinal else -1)]


def ways(start: Reading, end: Reading) -> list[dict[str, int]]:
    """Every set of exponents of the spatial conditions that bridges area and solid angle."""
    wanted = (end.area - start.area, end.solid_angle - start.solid_angle)
    found = []
    for exponents in product((0, 1, -1), repeat=len(SPATIAL)):
        moved = tuple(
            sum(p * step[i] for p, step in zip(exponents, SPATIAL.values(), strict=True))
            for i in (0, 1)
        )
        way = {slot: power for slot, power in zip(SPATIAL, exponents, strict=True) if power}
        # A reflector turns irradiance into radiance, whatever else has that dimension.
        reflects = end.is_radiance - start.is_radiance
        fits = moved == wanted and way.get(c.REFLECTANCE, reflects) == reflects
        if fits and _is_physical(set(way), start.is_radiance or end.is_radiance):
            found.append(way)
    return found


def _is_physical(slots: set[str], radiance: bool) -> bool:
    """Whether the conditions mean together what their dimensions say.

    An area and a distance are the far field of a source, between radiance and irradiance
    alone: an area at a distance from a small source catches a cone of its light, no more than
    a sphere's worth.  A cone and a distance are a lamp's: between radiance and intensity the
    one would be exact and the other a far field.
    """
    if {c.AREA_SLOT, c.DISTANCE} <= slots:
        return radiance and len(slots) == 2
    return not (radiance and {c.CONE, c.DISTANCE} <= slots and c.REFLECTANCE not in slots)


def _space(search: _Search, start: Reading, end: Reading) -> Links:
    """Between flux, intensity, irradiance and radiance."""
    radiance = start.is_radiance or end.is_radiance
    exitance = is_exitance(search.source) or is_exitance(search.target)
    across = start.area == end.area and start.solid_angle != end.solid_angle
    if radiance and across and not exitance:
        seen = _disc(search, end.solid_angle < start.solid_angle)
        if seen:
            return seen
    given = set(SPATIAL) & set(search.given)
    open_ways = ways(start, end)
    if exitance:  # it leaves the source's surface: nothing is on the way yet
        open_ways = [way for way in open_ways if not {c.DISTANCE, c.REFLECTANCE} & set(way)]
    inside = [way for way in open_ways if set(way) <= given]
    if len(inside) > 1:
        flags = [search.given[slot].flag for slot in SPATIAL if slot in given]
        raise ConditionError(
            f"{search.heading()}: over-specified by {' and '.join(flags)}",
            "fewer of them",
        )
    if inside and c.DISTANCE in given - set(inside[0]):
        # a distance that finds no use beside an area: the lamp's cone is what is missing
        cones = [way for way in open_ways if set(way) == {c.CONE, c.DISTANCE}]
        if cones and c.CONE not in given:
            _want_space(search, cones, {c.DISTANCE}, radiance)
            return []
    if not inside:
        _want_space(search, open_ways, given, radiance)
        return []
    return _apply(search, inside[0], radiance)


def _is_projected(slots: Iterable[str], radiance: bool) -> bool:
    """Whether a cone stands between a radiance and an irradiance, exitance or flux.

    With a reflector it does not: there the cone is the lamp's, between flux and intensity.
    """
    return radiance and c.REFLECTANCE not in slots


def _want_space(
    search: _Search, open_ways: list[dict[str, int]], given: set[str], radiance: bool
) -> None:
    """Note which spatial conditions are missing beside those given: the two shortest ways."""
    possible = sorted((set(way) for way in open_ways), key=len)
    pair = {c.AREA_SLOT, c.CONE} if radiance else {c.CONE, c.DISTANCE}
    far = {c.AREA_SLOT, c.DISTANCE} if radiance else pair
    extending = [
        way for way in possible if given and given < way and way in (*SUGGESTED, pair, far)
    ]
    sensible = [way for way in possible if way in SUGGESTED or way == pair] or possible
    alternatives: dict[str, str] = {}
    if radiance and given == {c.DISTANCE} and {c.AREA_SLOT, c.DISTANCE} in possible:
        search.used.add(c.DISTANCE)
        search.missing[c.AREA_SLOT] = ("the size of the source", "--radius R or --area A")
        return
    for slots in (extending or sensible)[:2]:
        search.used |= slots & given
        cone = PROJECTED if _is_projected(slots, radiance) else c.CONE
        needed = [cone if slot == c.CONE else slot for slot in SPATIAL if slot in slots - given]
        phrases, hints = zip(*(WANTED[slot] for slot in needed), strict=True)
        alternatives[" and ".join(phrases)] = " with ".join(hints)
    plain = all(" and " not in phrase for phrase in alternatives)
    phrase = (" or " if plain else ", or ").join(alternatives)
    search.missing[c.CONE] = (phrase, ", or ".join(alternatives.values()))


def _disc(search: _Search, forward: bool) -> Links:
    """--radius and --distance between radiance and irradiance: the exact disc."""
    source = search.given.get(c.AREA_SLOT)
    distance = search.given.get(c.DISTANCE)
    if not source or not distance or source.option.name == "area":
        return []
    if {c.CONE, c.REFLECTANCE} & set(search.given):
        return []
    search.used |= {c.AREA_SLOT, c.DISTANCE}
    factor = geometric.disc(source, distance, search.use("incidence"))
    return [_checked(factor, 1 if forward else -1)]


def _apply(search: _Search, way: dict[str, int], radiance: bool) -> Links:
    links: Links = []
    for slot, power in way.items():
        given = search.use(slot)
        assert given is not None
        if slot == c.AREA_SLOT:
            factor = geometric.area(given)
            if radiance and c.DISTANCE in way:
                geometric.far_field(factor, search.given[c.DISTANCE])
        elif slot == c.CONE:
            projected = _is_projected(way, radiance)
            factor = (
                geometric.projected_solid_angle(given)
                if projected
                else geometric.solid_angle(given)
            )
        elif slot == c.DISTANCE:
            factor = geometric.inverse_square(given, search.use("incidence"))
        else:
            factor = geometric.reflector(given)
        links.append(_checked(factor, power))
    return links


def _checked(factor: Factor, power: int) -> tuple[Factor, int]:
    """Refuse to divide by a factor of 0: nothing follows from no light."""
    if power < 0 and any_true(factor.value == 0):
        raise ConditionError(
            f"{factor.assumption}: no light arrives, so nothing follows from it",
            "a reflectance above 0, and an incidence below 90 deg",
        )
    return factor, power
