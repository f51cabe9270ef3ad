"""`radcalc integrate EXPRESSION`."""

from radcalc.answer import texts_of
from radcalc.calculators.integrate import BARE, PAGE, integrand, integrate
from radcalc.calculators.solved import Task
from radcalc.cli.calculator import run
from radcalc.cli.cases import cases
from radcalc.cli.output import Output
from radcalc.cli.request import Request
from radcalc.errors import UsageError, call


def answer(
    typed: dict[str, str],
    request: Request,
    output: Output,
    words: tuple[str, ...] = (),
    unit: str | None = None,
) -> int:
    """Answer for an expression, with or without a unit."""
    if not words:
        raise UsageError("an expression is missing", call("integrate", "cos(theta)", hemisphere=""))
    all_cases = cases(typed, arrays=False, intervals=PAGE.intervals)
    text = " ".join(words)
    of = integrand(unit) if unit else BARE
    operands = texts_of({"expression": text, "unit": unit or ""})
    drawn = text, unit or ""
    task = Task("integrate", lambda given: integrate(text, given, of), operands, drawn=drawn)
    return run(all_cases, task, request, output)
