"""`radcalc environment SOURCE`, and commands that write a map, if every input is valid."""

import os
from functools import partial
from typing import TYPE_CHECKING

from radcalc.answer import Answer, texts_of
from radcalc.calculators import environment as page
from radcalc.calculators.environment import Source, environment
from radcalc.calculators.solved import Task
from radcalc.cli.calculator import run
from radcalc.cli.command import define
from radcalc.cli.output import Output
from radcalc.cli.plot import one_case, write_map
from radcalc.cli.request import Request, cases
from radcalc.errors import UsageError, call, leave_out, quote_path
from radcalc.inputs import Inputs, shown_inputs

if TYPE_CHECKING:
    pass


EXAMPLES = (
    call("environment", "sky:overcast"),
    call("environment", "map.hdr", unit="cd/m2", remark="for a picture"),
)


@define("environment", page.PAGE)
def command(
    words: tuple[str, ...],
    typed: dict[str, str],
    irradiance_map: str | None,
    order: str | None,
    request: Request,
    output: Output,
) -> int:
    """Answer for a receiver, or write an irradiance map."""
    if not words:
        raise UsageError("a map, a sky or an expression is missing", EXAMPLES)
    operands = {"source": " ".join(words)}
    source = Source(operands["source"])
    if irradiance_map is None:
        for name, value in (("--order", order), ("--size", typed.get("size"))):
            if value:
                problem = f"{name} does not apply without --irradiance-map"
                raise UsageError(problem, "--irradiance-map FILE with it")
        all_cases = cases(typed, arrays=False)

        def work_out(given: Inputs) -> Answer:
            return environment(source, given)

        task = Task("environment", work_out, texts_of(operands), drawn=source)
        return run(all_cases, task, request, output)
    for name in ("normal", "toward"):
        if name in typed:
            problem = f"--{name} does not apply when a map is written"
            raise UsageError(problem, leave_out(name))
    _refuse_source(irradiance_map, operands["source"])
    given = one_case(typed, request)
    make = partial(page.irradiance_map, source, given, 2 if order else None)
    inputs = texts_of({**operands, "irradiance-map": irradiance_map, "order": order or ""})
    return write_map(
        irradiance_map,
        "irradiance map",
        make,
        request,
        output,
        (*inputs, *shown_inputs(given)),
    )


def _refuse_source(path: str, source: str) -> None:
    """Refuse to overwrite the map to read, under any name or link."""
    if os.path.exists(source) and os.path.exists(path) and os.path.samefile(source, path):
        raise UsageError(f"{quote_path(path)} is also the map to read", "another name")
