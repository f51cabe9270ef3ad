"""The light quantities of a calculator: given in any kind, shown in every kind that is linked.

A generic name (`flux`) serves every kind, and the unit decides; a name of one kind
(`luminous-flux`) takes that kind alone.
"""

from typing import Any, NamedTuple

from radcalc.answer import Step, Value
from radcalc.calculators.inputs import INPUTS as OTHER_INPUTS
from radcalc.calculators.inputs import unit_of
from radcalc.conversion import spectral
from radcalc.conversion.conditions import Factor, Given, Option, give, read
from radcalc.errors import ConditionError, NumberError
from radcalc.quantities.light import KIND_NAMES, LUMINOUS, PHOTON, RADIANT, light_dimension
from radcalc.units.table import NUMBER

GEOMETRY = {
    "flux": (0, 0, 0),
    "intensity": (0, 0, 1),
    "irradiance": (0, 1, 0),
    "exitance": (0, 1, 0),
    "radiance": (0, 1, 1),
    "exposure": (1, 1, 0),
    "energy": (1, 0, 0),
    "incident-irradiance": (0, 1, 0),
    "received-flux": (0, 0, 0),
    "flux-within": (0, 0, 0),
    "beam-flux": (0, 0, 0),
    "far-field-irradiance": (0, 1, 0),
}
INPUTS = {
    "flux": "All the flux",
    "intensity": "The intensity on the source's axis",
    "irradiance": "The irradiance on the receiver",
    "exitance": "The exitance of the source",
    "radiance": "The uniform radiance of the source",
    "exposure": "The exposure of the receiver (with --time)",
    "energy": "All the energy (with --time)",
    "incident-irradiance": "The irradiance on the reflector (with --reflectance)",
}
SYMBOLS = {
    "flux": "Φ",
    "intensity": "I",
    "irradiance": "E",
    "exitance": "M",
    "radiance": "L",
    "exposure": "H",
    "energy": "Q",
    "incident-irradiance": "E_i",
    "received-flux": "Φ_r",
    "flux-within": "Φ_w",
    "beam-flux": "Φ_b",
    "far-field-irradiance": "E_ff",
}
# name of one kind -> generic name and kind; with them go the labels of the results
SPECIFIC = {
    "radiant-flux": ("flux", RADIANT),
    "luminous-flux": ("flux", LUMINOUS),
    "photon-flux": ("flux", PHOTON),
    "radiant-intensity": ("intensity", RADIANT),
    "luminous-intensity": ("intensity", LUMINOUS),
    "photon-intensity": ("intensity", PHOTON),
    "illuminance": ("irradiance", LUMINOUS),
    "photon-irradiance": ("irradiance", PHOTON),
    "radiant-exitance": ("exitance", RADIANT),
    "luminous-exitance": ("exitance", LUMINOUS),
    "photon-exitance": ("exitance", PHOTON),
    "luminance": ("radiance", LUMINOUS),
    "photon-radiance": ("radiance", PHOTON),
    "radiant-exposure": ("exposure", RADIANT),
    "luminous-exposure": ("exposure", LUMINOUS),
    "photon-exposure": ("exposure", PHOTON),
    "radiant-energy": ("energy", RADIANT),
    "luminous-energy": ("energy", LUMINOUS),
    "photon-number": ("energy", PHOTON),
    "incident-illuminance": ("incident-irradiance", LUMINOUS),
    "incident-photon-irradiance": ("incident-irradiance", PHOTON),
    "received-luminous-flux": ("received-flux", LUMINOUS),
    "received-radiant-flux": ("received-flux", RADIANT),
    "received-photon-flux": ("received-flux", PHOTON),
    "far-field-illuminance": ("far-field-irradiance", LUMINOUS),
}
# geometry -> the unit to show of each kind, and the coherent one of a derivation
UNITS = {
    (0, 0, 0): (("W", "lm", "umol/s"), ("W", "lm", "photon/s")),
    (0, 0, 1): (("W/sr", "cd", "umol/s/sr"), ("W/sr", "cd", "photon/s/sr")),
    (0, 1, 0): (("W/m2", "lx", "umol/m2/s"), ("W/m2", "lx", "photon/m2/s")),
    (0, 1, 1): (("W/m2/sr", "cd/m2", "umol/m2/s/sr"), ("W/m2/sr", "cd/m2", "photon/m2/s/sr")),
    (1, 1, 0): (("J/m2", "lx s", "umol/m2"), ("J/m2", "lx s", "photon/m2")),
    (1, 0, 0): (("J", "lm s", "umol"), ("J", "lm s", "photon")),
}
ORDER = (RADIANT, LUMINOUS, PHOTON)
LINKS = ("wavelength", "spectrum", "efficacy")
REFINEMENTS = ("observer", "range", "photon-range")


def dimension(name: str, kind: str) -> tuple[int, ...]:
    """The dimension of a light quantity by its generic name."""
    return light_dimension(kind, GEOMETRY[name], "")


def unit(name: str, kind: str, coherent: bool = False) -> str:
    """The unit to show of a light quantity, or its coherent one; an exitance is in lm/m2."""
    text = UNITS[GEOMETRY[name]][coherent][ORDER.index(kind)]
    return "lm/m2" if text == "lx" and name == "exitance" else text


def option(name: str) -> Option:
    """How a light quantity is given, by its generic name or that of one kind."""
    generic, kind = SPECIFIC.get(name, (name, ""))
    taken = (kind,) if kind else ORDER
    example = f"100{unit(generic, kind or LUMINOUS)}".replace(" ", ".")
    label = name.replace("-", " ")
    return Option(
        name,
        "",
        tuple(dimension(generic, k) for k in taken),
        f"{'an' if label[0] in 'aeiou' else 'a'} {label}",
        example,
        "",
    )


def read_any(name: str, value: Any) -> Given:
    """Read an input of a calculator, a light quantity, or what links its kinds.

    `value` is a text, a number, or a pair of a number or an array and a `Unit`.
    """
    if name in LINKS or name in REFINEMENTS:
        return give(name, value)
    own = OTHER_INPUTS[name] if name in OTHER_INPUTS else option(name)
    try:
        return read(own, value)
    except NumberError as error:
        if "," in str(value) and own.dimensions == (NUMBER,):
            parts = ",".join(p if "." in p else f"{p}.0" for p in str(value).split(","))
            raise NumberError(error.message, f"{parts}, if that is a list") from None
        raise


def names_of(generic: str) -> tuple[str, ...]:
    """The names of one kind that go with a generic name."""
    return tuple(name for name, (own, _) in SPECIFIC.items() if own == generic)


def kind_of(name: str, given: Given) -> str:
    """The kind in which a light quantity was given."""
    return next(kind for kind in ORDER if dimension(name, kind) == given.dimension)


def sort(given: dict[str, Given]) -> tuple[dict[str, Given], dict[str, Given], dict[str, Given]]:
    """Tell light quantities, what links their kinds, and the rest from each other."""
    quantities = {n: g for n, g in given.items() if n in INPUTS or n in SPECIFIC}
    links = {n: g for n, g in given.items() if n in LINKS or n in REFINEMENTS}
    rest = {n: g for n, g in given.items() if n not in quantities and n not in links}
    return quantities, links, rest


class Lit(NamedTuple):
    """What was given of the light: quantities of one kind [SI], and what links the kinds."""

    kind: str
    values: dict[str, Given]
    amounts: dict[str, Any]
    light: dict[str, Given]
    assumptions: tuple[str, ...]
    notes: tuple[str, ...]
    steps: tuple[Step, ...]


def read_light(typed: dict[str, Given], light: dict[str, Given]) -> Lit:
    """Sort the light quantities that were given, by generic names, and turn them into one kind.

    The kind is that of the first; another needs a wavelength, a spectrum or an efficacy.
    """
    given: dict[str, Given] = {}
    for name, one in typed.items():
        generic = SPECIFIC.get(name, (name, ""))[0]
        if generic in given:
            raise ConditionError(
                f"{given[generic].flag} and {one.flag} are the same quantity", "one of them"
            )
        given[generic] = one
    links = [one for name, one in light.items() if name in LINKS]
    if len(links) > 1:
        raise ConditionError(
            f"{links[0].flag} and {links[1].flag} contradict each other: both link the kinds",
            "one of them",
        )
    _refuse_unused(light)
    kind = kind_of(*next(iter(given.items()))) if given else RADIANT
    first = next(iter(given.values()), None)
    said: list[str] = []
    notes: list[str] = []
    steps: list[Step] = []
    amounts = {}
    for name, one in given.items():
        own = kind_of(name, one)
        amounts[name] = one.value
        if own != kind and first:
            factor = _factor(light, kind, own)
            if factor is None:
                raise ConditionError(
                    f"{one.flag} is {_named(own)}, {first.flag} {_named(kind)}: "
                    "what links them is missing",
                    "--wavelength, --spectrum or --efficacy",
                )
            amounts[name] = one.value * factor.value
            said.append(factor.assumption)
            notes += factor.notes
            steps += factor.steps
    return Lit(kind, given, amounts, light, tuple(said), tuple(notes), tuple(steps))


def _named(kind: str) -> str:
    return KIND_NAMES[kind]


def _refuse_unused(light: dict[str, Given]) -> None:
    """Refuse refinements of what is not there."""
    for name in REFINEMENTS:
        useful = ("wavelength", "spectrum") if name == "observer" else ("spectrum",)
        if name in light and not set(useful) & set(light):
            raise ConditionError(
                f"--{name} has no use", f"--{' or --'.join(useful)} with it, or neither"
            )


def _factor(light: dict[str, Given], over: str, under: str) -> Factor | None:
    """The ratio of two kinds, as the conditions have it; None where they do not link them."""
    observer = light.get("observer")
    if "wavelength" in light:
        return spectral.kind_factor(spectral.light(light["wavelength"], observer), over, under)
    if "spectrum" in light:
        ranges = light.get("range"), light.get("photon-range")
        return spectral.spectral_factor(light["spectrum"], over, under, *ranges, observer)
    if "efficacy" in light:
        return spectral.given_ratio(light["efficacy"], over, under)
    return None


class Shown(NamedTuple):
    """Light quantities as results, with what their kinds assume."""

    values: dict[str, list[Value]]
    assumptions: list[str]
    notes: list[str]
    steps: list[Step]


def show_light(lit: Lit, found: dict[str, Any]) -> Shown:
    """Light quantities [SI, by generic name] as results, in every kind that is linked."""
    factors = {}
    for kind in ORDER:
        if kind != lit.kind and (factor := _factor(lit.light, kind, lit.kind)):
            factors[kind] = factor
    values: dict[str, list[Value]] = {}
    for name, amount in found.items():
        rows = []
        reach = {dimension(name, kind): amount * factor.value for kind, factor in factors.items()}
        for kind in (lit.kind, *factors):
            given = lit.values.get(name)
            is_given = given is not None and kind_of(name, given) == kind
            text = unit_of(given) if given and is_given else unit(name, kind)
            own = amount if kind == lit.kind else reach[dimension(name, kind)]
            rows.append(
                Value(
                    name if kind == lit.kind else row_name(name, kind),
                    specific(name, kind).replace("-", " "),
                    f"{SYMBOLS[name]}_{kind}" if "_" not in SYMBOLS[name] else SYMBOLS[name],
                    given.value if given and is_given else own,
                    (dimension(name, kind),),
                    (text,),
                    reach if kind == lit.kind else None,
                    given=given.number if given and is_given else None,
                    also=specific(name, kind),
                )
            )
        values[name] = rows
    told = dict.fromkeys(f.assumption for f in factors.values())
    return Shown(
        values,
        list(told),
        [note for factor in factors.values() for note in factor.notes],
        [step for factor in factors.values() for step in factor.steps],
    )


def row_name(name: str, kind: str) -> str:
    """What --get calls a light quantity of another kind than the given one."""
    own = specific(name, kind)
    return f"radiant-{name}" if own == name else own


def efficacy(lit: Lit) -> Any:
    """The luminous efficacy [lm/W] that links the kinds, or None."""
    factor = _factor(lit.light, LUMINOUS, RADIANT)
    return factor.value if factor else None


def specific(name: str, kind: str) -> str:
    """The name of a light quantity in one kind."""
    for own, pair in SPECIFIC.items():
        if pair == (name, kind):
            return own
    return name if kind == RADIANT else f"{_named(kind)}-{name}"
