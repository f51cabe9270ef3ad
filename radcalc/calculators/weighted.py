"""Results of the weights of a spectrum: alpha-opic values, UV index, hazards, plant bands.

The names of the alpha-opic results are those of CIE S 026: the efficacy of luminous radiation
(elr), the daylight efficacy ratio (der), the equivalent daylight illuminance (edi).
"""

from collections.abc import Sequence

from radcalc.answer import Formula, Remark, Step, Value
from radcalc.calculators.kinds import of_kinds
from radcalc.calculators.results import absent, value
from radcalc.errors import RadcalcError
from radcalc.quantities import KIND_NAMES, LUMINOUS, PHOTON, RADIANT, ratio_unit
from radcalc.quantities.symbols import ALPHA_OPIC, light_unit, specific_name
from radcalc.spectra import weights
from radcalc.spectra.contents import Counts
from radcalc.units.compiled import WEIGHTS
from radcalc.units.table import resolve

IRRADIANCES = {specific_name("irradiance", kind): kind for kind in WEIGHTS}
EDI = {f"{name}-edi": kind for kind, name in ALPHA_OPIC.items()}
ELR = {f"{name}-elr": kind for kind, name in ALPHA_OPIC.items()}
DER = {f"{name}-der": kind for kind, name in ALPHA_OPIC.items()}
HAZARDS = {"actinic-uv-elr": "act", "blue-light-elr": "blh"}
R_TO_FR = "r-fr-smith10"
OF_IRRADIANCE = (*EDI, "uv-index", *IRRADIANCES)  # of a spectrum that is an irradiance
ON_REQUEST = (*ELR, *DER, *HAZARDS, R_TO_FR, *OF_IRRADIANCE)
RELATIVE = "the spectrum is relative"


def weighted(
    counts: Counts, requested: Sequence[str]
) -> tuple[list[Value], list[Remark], list[Step]]:
    """Return the requested results of weights of a light, with their assumptions and steps."""
    values, remarks, steps = [], [], []
    for name in [name for name in ON_REQUEST if name in requested]:
        try:
            values.append(_result(counts, name))
        except RadcalcError as error:
            values.append(value(name, 0.0)._replace(units=(), because=error))
            continue
        kinds = ("rs", "frs") if name == R_TO_FR else (_kind(name),)
        remarks += [Remark(described(kind), [name]) for kind in kinds]
        steps += [_step(counts, name, kind) for kind in kinds]
    return values, remarks, [step for step in dict.fromkeys(steps) if step]


def _step(counts: Counts, name: str, kind: str) -> Step | None:
    """Return the step of a weighted amount, per lumen if the result is a ratio."""
    own = weights.weight(kind) if weights.observer_of(kind) is None else None
    if own is None:
        return None
    amount = counts.amount(kind)
    by_energy = " lambda/(h c)" if own.acts_on == PHOTON else ""
    integral = f"int(S w({KIND_NAMES[kind]}){by_energy} dlambda)"
    unit = ratio_unit(kind, LUMINOUS).partition("/")[0]
    formula = Formula(f"{KIND_NAMES[kind]} light", f"X = {integral}", own.source)
    if name not in (*ELR, *DER, *HAZARDS):
        return formula.with_numbers(f"X = {amount:.6g} {unit}")
    lumens = counts.amount(LUMINOUS)
    formula = formula._replace(template=f"K = {integral} / (Km int(S V dlambda))")
    numbers = f"K = {amount:.6g} {unit} / {lumens:.6g} lm = {amount / lumens:.6g} {unit}/lm"
    if name in DER:
        numbers += f", {amount / lumens / daylight(kind):.6g} of {daylight(kind):.6g} in D65"
    return formula.with_numbers(numbers)


def described(kind: str) -> str:
    """Return the weight of a kind with its source, for an assumption."""
    if eye := weights.observer_of(kind):
        return eye.described
    return weights.weight(kind).described


def _kind(name: str) -> str:
    if name == "uv-index":
        return "ery"
    return next(rows[name] for rows in (ELR, DER, EDI, HAZARDS, IRRADIANCES) if name in rows)


def _result(counts: Counts, name: str) -> Value:
    if name == R_TO_FR:
        far_red = counts.amount("frs")
        if not far_red:
            return absent(name, "it has no light from 725 nm to 735 nm", "another spectrum")
        return value(name, counts.amount("rs") / far_red)
    kind = _kind(name)
    if name in OF_IRRADIANCE:
        if counts.source.absolute != "irradiance":
            instead = name.replace("-edi", "-elr")
            others = [instead] if instead in ELR else []
            hint = "an irradiance with this spectrum (radcalc convert --help)"
            return absent(name, RELATIVE, hint, *others)
        return value(name, counts.amount(kind))
    lumens = counts.amount(LUMINOUS)
    if not lumens:
        return absent(name, "this spectrum is invisible", "another spectrum")
    share = counts.amount(kind) / lumens
    return value(name, share / daylight(kind) if name in DER else share)


def daylight(kind: str) -> float:
    """Return the weighted watts per lumen of daylight D65."""
    return resolve(f"lx_{kind}").factor


def of_weight(counts: Counts, kind: str) -> list[Value]:
    """Return the results of a light for the weight that a call names."""
    amount, watts, lumens = (counts.amount(k) for k in (kind, RADIANT, LUMINOUS))
    label = f"{KIND_NAMES[kind]} light"
    values = [of_kinds(value("per-watt", amount / watts, label=f"{label} per watt"), kind, RADIANT)]
    if lumens:
        of_lumens = value("per-lumen", amount / lumens, label=f"{label} per lumen")
        values.append(of_kinds(of_lumens, kind, LUMINOUS))
    if absolute := counts.source.absolute:
        name = specific_name(absolute, kind)
        values.append(value(name, amount, light_unit(absolute, kind)))
    return values
