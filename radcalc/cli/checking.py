"""--check and --tolerance: whether a number is the right answer."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import click

from radcalc.errors import UsageError

if TYPE_CHECKING:
    from radcalc.answer import Answer
    from radcalc.cli.output import Output
    from radcalc.conversion.conditions import Given
    from radcalc.units.table import Unit

OPTIONS = (
    click.option(
        "--check",
        metavar="[NAME=]VALUE[UNIT]",
        help="Say whether that answer is right, and if not, what went wrong (status 1).",
    ),
    click.option(
        "--tolerance",
        metavar="1%",
        help="How near it must be: 1% (the default), 0.5lx, or 3sf for significant digits.",
    ),
)


def refuse_idle(check: str | None, tolerance: str | None) -> None:
    """Refuse a tolerance of nothing."""
    if tolerance is not None and check is None:
        raise UsageError("--tolerance has no use without --check", "--check VALUE with it")


def judge(
    given: "dict[str, Given]",
    work_out: "Callable[[dict[str, Given]], Answer]",
    claim: str,
    tolerance: str | None,
    steps: bool,
    shown: "Output",
    **facts: Any,
) -> int:
    """Say whether an answer is right, and what went wrong; return the exit status."""
    from radcalc.cli import verdict
    from radcalc.homework import Question, check

    values, assumptions, notes, derivation = work_out(given)
    question = Question(
        values, given, lambda g: work_out(g)[0], facts, tuple(derivation) if steps else ()
    )
    return verdict.show(check(question, claim, tolerance or "1%"), assumptions, notes, shown)


def judge_conversion(
    value: float,
    source: "Unit",
    target: "Unit",
    given: "Sequence[Given]",
    claim: str,
    tolerance: str | None,
    steps: bool,
    shown: "Output",
) -> int:
    """The same of a conversion."""
    from radcalc.answer import Value
    from radcalc.conversion.plan import derive, plan
    from radcalc.quantities.light import name_of, symbol_of

    def work_out(conditions: "dict[str, Given]") -> "Answer":
        made = plan(source, target, list(conditions.values()))
        result = Value(
            "value",
            name_of(target) or "value",
            symbol_of(target),
            made.apply(value) * target.factor,
            (target.dimension,),
            (target.text,),
            also=name_of(target).replace(" ", "-"),
        )
        derivation = derive(made, value) if steps else []
        return [result], list(made.assumptions), list(made.notes), derivation

    conditions = {one.option.name: one for one in given}
    facts = _facts(source, target, conditions)
    facts["unchanged"] = value * target.factor  # the number, with the other unit behind it
    return judge(conditions, work_out, claim, tolerance, steps, shown, **facts)


PER_PI = ("lambert", "apostilb", "skot", "blondel", "bril")


def _facts(source: "Unit", target: "Unit", given: "dict[str, Given]") -> dict[str, Any]:
    """What the usual mistakes of a conversion depend on."""
    from radcalc.conversion import spectral
    from radcalc.quantities.light import LUMINOUS, RADIANT, read
    from radcalc.spectra.observers import luminous_efficacy

    facts: dict[str, Any] = {"command": "convert"}
    names = [name for unit in (source, target) for name, _ in unit.atoms]
    facts["per_pi"] = any(word in name for name in names for word in PER_PI)
    if "wavelength" in given:
        light = spectral.light(given["wavelength"], given.get("observer"))
        facts["efficacy"] = luminous_efficacy(light.table, light.observer)
        start, end = read(source), read(target)
        if start and end and start.axis != end.axis and start.axis and end.axis:
            facts["jacobian"] = spectral.jacobian(light, start.axis, end.axis).value
    elif "spectrum" in given:
        refined = given.get("range"), given.get("photon-range"), given.get("observer")
        factor = spectral.spectral_factor(given["spectrum"], LUMINOUS, RADIANT, *refined)
        facts["efficacy"] = factor.value
    elif "efficacy" in given:
        ratio = spectral.given_ratio(given["efficacy"], LUMINOUS, RADIANT)
        facts["efficacy"] = ratio.value if ratio else None
    return facts
