"""A spectrum: its shape, efficacies, photons and colour."""

import math
from collections.abc import Sequence

from radcalc import errors
from radcalc.answer import Answer, Formula, Remark, Step, Value
from radcalc.calculators.colours import LIT, ON_REQUEST, UNSEEN, colours, in_nanometres
from radcalc.calculators.kinds import of_kinds
from radcalc.calculators.page import Operand, Page, flag, text
from radcalc.calculators.results import absent, on_request, value
from radcalc.conversion.spectral import behind_filter
from radcalc.errors import RadcalcError, option
from radcalc.inputs import Inputs
from radcalc.quantities import (
    KIND_NAMES,
    LUMINOUS,
    PHOTON,
    RADIANT,
    base_of,
    kind_of_observer,
    light_dimension,
    ratio_unit,
)
from radcalc.quantities.symbols import (
    ALPHA_OPIC,
    SCOTOPIC,
    SPECTRUM,
    SYMBOLS,
    light_unit,
    specific_name,
)
from radcalc.spectra import observers as weights
from radcalc.spectra.contents import Counts, responsivity
from radcalc.spectra.observers import LIGHT, OBSERVERS, PLANCK, TRAPEZOIDS, observer_of
from radcalc.spectra.spectrum import PAR, WHOLE, BlackBody, Lines, Spectrum, range_text
from radcalc.units.compiled import WEIGHTS
from radcalc.units.table import resolve

# The results of weights.  Those of CIE S 026 are the efficacy of luminous radiation (elr), the
# daylight efficacy ratio (der) and the equivalent daylight illuminance (edi).
IRRADIANCES = {specific_name("irradiance", kind): kind for kind in WEIGHTS}
EDI = {f"{name}-edi": kind for kind, name in ALPHA_OPIC.items()}
ELR = {f"{name}-elr": kind for kind, name in ALPHA_OPIC.items()}
DER = {f"{name}-der": kind for kind, name in ALPHA_OPIC.items()}
HAZARDS = {"actinic-uv-elr": "act", "blue-light-elr": "blh"}
R_TO_FR = "r-fr-smith10"
OF_IRRADIANCE = (*EDI, "uv-index", *IRRADIANCES)  # of a spectrum that is an irradiance
OF_WEIGHTS = (*ELR, *DER, *HAZARDS, R_TO_FR, "mismatch", *OF_IRRADIANCE)
PAGE = Page(
    results=(
        "peak-wavelength",
        "centroid-wavelength",
        "fwhm",
        "range-start",
        "range-end",
        "range-fraction",
        "luminous-efficiency",
        "luminous-efficacy",
        "scotopic-luminous-efficacy",
        "sp-ratio",
        "per-watt",
        "per-lumen",
        "photon-energy",
        "photon-efficacy",
        "lux-per-ppfd",
        "x",
        "y",
        "cct",
        "duv",
        "cri",
        "exitance",
        "radiance",
        "luminance",
        "temperature",
        "irradiance",
        "illuminance",
        "photon-irradiance",
    ),
    about="Describe a spectrum: peak, width, efficacies, photons, colour; or compare several.",
    operand=Operand("spectrum", "SOURCE ...", SPECTRUM),
    sections={
        "Source": (
            text(
                "column",
                "NAME",
                "Column with the values: its title, with or without its unit, or its number.",
            ),
            text(
                "unit",
                "W/m2/nm",
                "Unit of the values of a file: W/m2/nm, umol/m2/s/nm ...; for relative values, "
                "the word relative (proportional to watts) or photons (proportional to photons).",
            ),
            flag("list", "List the named sources, or those of one kind.", name="list_"),
        ),
        "Light": (
            *("observer", "weight", "range", "photon-range", "filter", "response"),
            *("dark-outside", "reference"),
        ),
    },
    on_request=(*ON_REQUEST, *OF_WEIGHTS),
    texts={
        "observer": "Observer (eye response) of the luminous efficacy.",
        "range": ("LOW:HIGH", "Wavelength range that all results describe."),
        "photon-range": ("LOW:HIGH", "Wavelength range for the photons."),
    },
    draws=True,
    takes_lines=False,
    examples=(
        "LED-B3",
        "blackbody:5772K get=luminance:cd/m2",
        "AM1.5G get=irradiance:W/m2",
        "measured.csv range=380nm:780nm",
        "LED-B3 get=r9 get=rf get=rg get=ssi",
        "LED-B3 get=rf plot=tm30.svg   the colour vectors of TM-30",
        "D65 A line:532nm get=x plot=colours.png   the chromaticity diagram",
        "D65 LED-B3 HPS get=cct get=cri get=lux-per-ppfd",
        "blackbody:3000K:6000K:1000K get=temperature:K get=luminous-efficacy:lm/W",
        "LED-B3 plot=           a picture, with V(lambda) over it",
        "D65 A LED-B3 plot=lamps.svg",
        "list=                  the named sources",
        "list= fluorescent      those of a kind",
    ),
    remarks="""
    SOURCE is a name, blackbody:T, daylight:T, line:WAVELENGTH, gaussian:CENTRE,FWHM,
    band:LOW:HIGH, a file, or - for standard input. With several sources, each has its row
    in a table, or its line of numbers in a pipe.

    Colour quality is calculated on request, with -g: r1 to r14 (CIE 13.3), rf, rg, rf-h1 to
    rf-h16, rcs-h1 and rhs-h1 to h16 (TM-30), ssi, dominant-wavelength, excitation-purity,
    srgb-red, srgb-green and srgb-blue.

    A file has columns of text, or one of the formats of OceanView, SpectraSuite, Jaz, UPRtek,
    Sekonic, LI-COR, CGATS (X-Rite), or IES TM-27 (.spdx).
    """,
    mistakes=("efficacies of eyes",),
)

RELATIVE = "the spectrum is relative"
# light of an absolute spectrum, and ratios that a relative one has
INSTEAD = (
    ("irradiance", "luminous-efficacy"),
    ("illuminance", "luminous-efficacy"),
    ("photon-irradiance", "photon-efficacy", "lux-per-ppfd"),
)
OF_BLACK_BODY = ("exitance", "radiance")
SAME = 1e-9  # relative difference of equal sums
# The results that count watts, and those that count photons.
OF_WATTS = (
    *("centroid-wavelength", "range-start", "range-end", "range-fraction", "luminous-efficiency"),
    *("luminous-efficacy", "scotopic-luminous-efficacy", "photon-efficacy", RADIANT),
)
OF_A_WEIGHT = ("per-watt", "per-lumen")
OF_PHOTONS = ("photon-energy", "photon-efficacy", "lux-per-ppfd", PHOTON)


def spectrum(given: Inputs, requested: Sequence[str] = ()) -> Answer:
    """Return the results of a spectrum, or of its part in the given range.

    `requested` are those of `ON_REQUEST` to calculate.  Photons are counted over the given photon
    range (default: 400 nm to 700 nm; for lines, all).
    """
    given = behind_filter(given)
    source: Spectrum = given["spectrum"].value
    if "dark-outside" in given and "weight" not in given and not {*requested} & {*OF_WEIGHTS}:
        raise errors.Unused(["dark-outside"], "without a weight or a result of one")
    chosen = {name: item.value for name, item in given.items()}
    seen = kind_of_observer(chosen.get("observer", "photopic"))
    ranges = chosen.get("range"), chosen.get("photon-range")
    whole = Counts(source, *ranges)
    known = f"; the data of {source.label} cover {whole.known}" if whole.known else ""
    light = source.part(ranges[0]) if ranges[0] else source
    if light is None or not whole.amount(RADIANT) > 0:
        problem = f"there is no power in {whole.over(RADIANT)}{known}"
        raise errors.ConditionError(problem, f"another {option('range')}")
    counts = Counts(light, *ranges, is_dark_outside="dark-outside" in given)
    colour = colours(light, requested, _reference(given, requested))
    uncounted = _without_photons(source, counts)
    kinds = (RADIANT, seen) if uncounted else (RADIANT, seen, PHOTON)
    of_weights, by_weights, steps = weighted(counts, requested)
    values = [
        *_shape(counts, source.total()),
        *_efficacies(counts, seen),
        *_photons(counts, seen),
        *colour.values,
        *of_weights,
        *_mismatch(source, given, requested),
        *(of_weight(counts, chosen["weight"]) if "weight" in chosen else ()),
        *[on_request(name) for name in _further(source) if name not in requested],
        *_absolute(source, {kind: counts.amount(kind) for kind in kinds}),
        *uncounted,
    ]
    assumptions = [*_assumptions(source, counts, whole, bool(ranges[0])), *colour.assumptions]
    assumptions += by_weights
    if "weight" in chosen:
        assumptions.append(Remark(described(chosen["weight"]), OF_A_WEIGHT))
    clipped = (RADIANT,) if ranges[0] else (RADIANT, PHOTON)  # the photons also by the range
    notes = [*source.notes, *whole.notes(clipped), *counts.notes((seen, PHOTON)), *colour.notes]
    notes += [Remark(note, OF_WATTS) for note in whole.left_out((RADIANT,))]
    notes += _notes(source, counts, whole, bool(ranges[0]))
    if "dark-outside" in given:
        notes.append(f"{source.label} is taken as dark outside its data")
    return Answer(values, assumptions, notes, [*_steps(counts, seen), *steps])


def _mismatch(source: Spectrum, given: Inputs, requested: Sequence[str]) -> list[Value]:
    """Return the spectral mismatch of a detector, as in IEC 60904-7, if it is requested.

    It is of a light against the reference, beside a meter that counts all watts.
    """
    if "mismatch" not in requested:
        if "response" in given:
            unused = f"{option('response')} does not apply without a mismatch"
            add = errors.add("get", "mismatch")
            raise errors.ConditionError(unused, [errors.leave_out("response"), add])
        return []
    lacking = [name for name in ("response", "reference") if name not in given]
    if lacking:
        because = errors.MissingInput(
            f"a spectral mismatch needs {errors.options(lacking, ' and ')}",
            "the responsivity of the detector and the spectrum of its calibration",
        )
        return [value("mismatch", 0.0)._replace(units=(), because=because)]
    is_dark = "dark-outside" in given
    own, reference = given["response"].value, given["reference"].value
    ratios = [responsivity(own, one, WHOLE, is_dark_outside=is_dark) for one in (source, reference)]
    return [value("mismatch", ratios[0] / ratios[1])]


def _further(source: Spectrum) -> list[str]:
    """Return the results on request that a spectrum can have."""
    relative = () if source.absolute == "irradiance" else OF_IRRADIANCE
    return [name for name in PAGE.on_request if name not in relative]


def _reference(given: Inputs, requested: Sequence[str]) -> Spectrum | None:
    """Return the reference of the similarity, which must be requested."""
    if "reference" not in given or ("ssi" not in requested and "mismatch" in requested):
        return None
    if "ssi" not in requested:
        unused = f"{option('reference')} does not apply without a spectral similarity index"
        raise errors.ConditionError(
            unused, [errors.leave_out("reference"), errors.add("get", "ssi")]
        )
    reference: Spectrum = given["reference"].value
    return reference


def _assumptions(source: Spectrum, counts: Counts, whole: Counts, has_range: bool) -> list[str]:
    """Return the source and what is counted; `whole` counts the light without its range."""
    described = source.described
    if has_range:
        described += f"; all results are of the light in {counts.over(RADIANT)}"
    relative_to = f"{whole.known}, all of the data" if whole.known else "all of the light"
    counted = [Remark(f"{described}; photons counted over {counts.over(PHOTON)}", OF_PHOTONS)]
    if not has_range:
        watts = f"{described}; watts counted over {counts.over(RADIANT)}"
        counted.insert(0, Remark(watts, OF_WATTS))
    if whole.known or has_range:
        fraction = f"{described}; range-fraction is relative to {relative_to}"
        counted.append(Remark(fraction, ["range-fraction"]))
    return [*counted, described]


def _notes(source: Spectrum, counts: Counts, whole: Counts, has_range: bool) -> list[str]:
    """Return notes on a peak at an end, and on invisible light."""
    notes = []
    peak = counts.source.peak()[0]
    is_last = whole.known and peak in source.known
    if is_last or (has_range and peak in counts.ranges[RADIANT]):
        ended = "data" if is_last else "range"
        notes.append(f"the peak is at the end of the {ended}: the peak of the source may be beyond")
    if not counts.amount(LUMINOUS):
        notes.append(UNSEEN)
    return notes


def _shape(counts: Counts, total: float) -> list[Value]:
    """Return the peak, centroid, width and limits of the light, and its share of the total."""
    source, watts, limits = counts.source, counts.amount(RADIANT), counts.ranges[RADIANT]
    peak, width = source.peak()
    centroid = source.photons(limits) * PLANCK * LIGHT / watts * 1e9
    results = [
        in_nanometres("peak-wavelength", peak),
        in_nanometres("centroid-wavelength", centroid),
    ]
    if width is not None:
        results.append(in_nanometres("fwhm", width))
    else:
        is_lines = isinstance(source, Lines)
        ends = "range ends" if counts.given[RADIANT] else "data end"
        why = "a line has no width" if is_lines else f"the {ends} above half of the peak"
        others = "peak-wavelength", "centroid-wavelength"
        results.append(absent("fwhm", why, " and ".join(others), *others))
    if limits != WHOLE:
        results.append(in_nanometres("range-start", limits[0]))
        results.append(in_nanometres("range-end", limits[1]))
    return [*results, value("range-fraction", watts / total)]


def _efficacies(counts: Counts, seen: str) -> list[Value]:
    """Return the luminous efficiency, the efficacies and the S/P ratio, or why they are absent."""
    eye, lumens, dark = observer_of(seen), counts.amount(LUMINOUS), counts.amount(SCOTOPIC)
    assert eye is not None
    results = [
        *_ratio(counts, seen, RADIANT, "luminous-efficiency", eye.maximum),
        *_ratio(counts, seen, RADIANT, "luminous-efficacy"),
    ]
    if seen != SCOTOPIC:
        results += _ratio(counts, SCOTOPIC, RADIANT, "scotopic-luminous-efficacy")
    if seen != LUMINOUS:
        reason = f"it is defined for {OBSERVERS['photopic'].label}"
        results.append(absent("sp-ratio", reason, f"leave out {option('observer')}"))
    elif lumens:
        results.append(value("sp-ratio", dark / lumens))
    else:
        results.append(absent("sp-ratio", UNSEEN, LIT))
    return results


def _ratio(counts: Counts, over: str, under: str, name: str, scale: float = 1.0) -> list[Value]:
    """Return a ratio of kinds, or a result with the reason why the range has none."""
    if problem := counts.impossible(over, under):
        return [absent(name, problem.message, problem.hint)]
    result = value(name, counts.amount(over) / counts.amount(under) / scale)
    return [of_kinds(result, over, under) if scale == 1 else result]


def _photons(counts: Counts, seen: str) -> list[Value]:
    limits, photons = counts.ranges[PHOTON], counts.amount(PHOTON)
    if not photons:
        why = f"there are no photons in {counts.over(PHOTON)}"
        hint = f"another {option('photon-range')}"
        return [absent(n, why, hint) for n in ("photon-energy", "photon-efficacy", "lux-per-ppfd")]
    energy = counts.source.power(limits) / photons
    return [
        value("photon-energy", energy, label="mean photon energy"),
        *_ratio(counts, PHOTON, RADIANT, "photon-efficacy"),
        *_ratio(counts, seen, PHOTON, "lux-per-ppfd"),
    ]


def _without_photons(source: Spectrum, counts: Counts) -> list[Value]:
    """Return the photons of an absolute source as absent, if its range has others than are counted.

    With a range alone they may be all its photons, or the PPFD from 400 nm to 700 nm.
    """
    chosen, also = counts.given[RADIANT], counts.given[PHOTON]
    names = OF_BLACK_BODY if isinstance(source, BlackBody) else (source.absolute,)
    if not chosen or also or not any(names):
        return []
    every, counted = counts.source.photons(counts.ranges[RADIANT]), counts.amount(PHOTON)
    if math.isclose(every, counted, rel_tol=SAME):
        return []
    ranges = {"all photons of the range": chosen, "those of PAR": PAR}
    if not counted:
        ranges = {"all photons of the range, none of which is PAR": chosen}
    tries = [
        errors.computed(errors.add("photon-range", f"{low:g}nm:{high:g}nm", remark))
        for remark, (low, high) in ranges.items()
    ]
    text = range_text(chosen)
    why = f"{text} has photons that are not in {counts.over(PHOTON)}, where they are counted"
    return [_absent_photons(name, why, tries) for name in names]


def _absent_photons(name: str, why: str, tries: list[errors.Try]) -> Value:
    symbol = SYMBOLS[specific_name(name, PHOTON)]
    error = errors.UsageError(f"the {symbol.label} is ambiguous: {why}", tries)
    return value(symbol.name, 0.0)._replace(units=(), because=error)


def _absolute(source: Spectrum, amounts: dict[str, float]) -> list[Value]:
    """Return the light of an absolute source in each kind, or a black body's radiation.

    `amounts` are its watts, lumens and photons; each result has all these kinds.
    """
    if isinstance(source, BlackBody):
        leaving = {kind: amount / math.pi for kind, amount in amounts.items()}
        return [
            _of_light("exitance", RADIANT, amounts)._replace(
                label="radiant exitance", letter="M_e"
            ),
            _of_light("radiance", RADIANT, leaving)._replace(letter="L_e"),
            *[
                _of_light("radiance", kind, leaving)
                for kind in amounts
                if base_of(kind) == LUMINOUS
            ],
            value("temperature", source.temperature),
        ]
    if source.absolute:
        return [_of_light(source.absolute, kind, amounts) for kind in amounts]
    hint = errors.command("convert", "VALUE", "UNIT", "UNIT", spectrum=source.label)
    return [absent(name, RELATIVE, hint, *others) for name, *others in INSTEAD]


def _of_light(name: str, kind: str, amounts: dict[str, float]) -> Value:
    """Return a light quantity in one kind, with its generic name if that is radiant."""
    symbol = SYMBOLS[specific_name(name, kind) if kind != RADIANT else name]
    geometry = symbol.geometry or (0, 0, 0)
    reach = {light_dimension(k, geometry, ""): amount for k, amount in amounts.items()}
    unit = light_unit(name, kind)
    base_dimension = light_dimension(kind, geometry, "")
    letter = symbol.letter if kind != RADIANT else ""
    also = specific_name(name, LUMINOUS) if base_of(kind) == LUMINOUS else ""
    return Value(
        symbol.name,
        symbol.label,
        letter,
        amounts[kind],
        (base_dimension,),
        (unit,),
        reach,
        also=also,
    )


def _steps(counts: Counts, seen: str) -> list[Step]:
    eye, lumens, watts = observer_of(seen), counts.amount(seen), counts.amount(RADIANT)
    assert eye is not None
    unit = ratio_unit(seen, RADIANT)
    weight = eye.label.split("(")[0]
    formula = Formula(
        "luminous efficacy of radiation",
        f"K = {eye.constant} int(S {weight} dlambda) / int(S dlambda)",
        f"{TRAPEZOIDS}; {eye.described}",
    )
    if counts.impossible(seen, RADIANT):
        return []
    ratio = f"{lumens:.6g} {unit.partition('/')[0]} / {watts:.6g} W"
    return [formula.with_numbers(f"K = {ratio} = {lumens / watts:.6g} {unit}")]


# ---------------------------------------------------------------------------------------------
# Weights


def weighted(
    counts: Counts, requested: Sequence[str]
) -> tuple[list[Value], list[Remark], list[Step]]:
    """Return the requested results of weights of a light, with their assumptions and steps."""
    values, remarks, steps = [], [], []
    for name in [name for name in OF_WEIGHTS if name in requested and name != "mismatch"]:
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
    """Return a result of a weight, or why it is absent."""
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
            hint = f"an irradiance with this spectrum ({errors.manual('convert')})"
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
