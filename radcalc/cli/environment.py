"""`radcalc environment SOURCE`."""

import os
from functools import partial

from radcalc.answer import Answer, texts_of
from radcalc.calculators import environment as page
from radcalc.calculators.environment import Source, environment
from radcalc.calculators.task import Task
from radcalc.cli.calculator import run
from radcalc.cli.cases import cases
from radcalc.cli.command import define
from radcalc.cli.maps import one_case, write_map
from radcalc.cli.output import Output
from radcalc.cli.request import Request
from radcalc.errors import Try, UsageError, add, call, leave_out, quote_path
from radcalc.inputs.given import Inputs, shown_inputs
from radcalc.quantities.symbols import LATLONG, WHOLE_SPHERE

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
    reproject: str | None,
    to: str | None,
    request: Request,
    output: Output,
) -> int:
    """Answer for a receiver, or write a map."""
    if not words:
        raise UsageError("a map, a sky or an expression is missing", EXAMPLES)
    operands = {"source": " ".join(words)}
    source = Source(operands["source"])
    path = irradiance_map or reproject
    if path is None:
        for name, value, file in (
            ("--order", order, "--irradiance-map"),
            ("--to", to, "--reproject"),
            ("--size", typed.get("size"), "--irradiance-map"),
        ):
            if value:
                raise UsageError(f"{name} does not apply without {file}", f"{file} FILE with it")
        all_cases = cases(typed, arrays=False)

        def work_out(given: Inputs) -> Answer:
            return environment(source, given)

        task = Task("environment", work_out, texts_of(operands), drawn=source)
        return run(all_cases, task, request, output)
    for name in ("normal", "toward"):
        if name in typed:
            problem = f"--{name} does not apply when a map is written"
            raise UsageError(problem, leave_out(name))
    _refuse_source(path, operands["source"])
    given = one_case(typed, request)
    if irradiance_map:
        if reproject:
            message = "--irradiance-map cannot be used with --reproject: each makes a file"
            other = Try((("to", to or LATLONG),), without=("irradiance-map",))
            raise UsageError(message, [leave_out("reproject", "to"), other])
        if to:
            raise UsageError("--to does not apply to --irradiance-map", leave_out("to"))
        make = partial(page.irradiance_map, source, given, 2 if order else None)
        inputs = texts_of({**operands, "irradiance-map": path, "order": order or ""})
        return write_map(
            path, "irradiance map", make, request, output, (*inputs, *shown_inputs(given))
        )
    if order:
        raise UsageError("--order does not apply to --reproject", leave_out("order"))
    if not to:
        ways = [add("to", name) for name in WHOLE_SPHERE]
        raise UsageError("the projection to write is missing", ways)
    make = partial(page.reprojection, source, given, to)
    inputs = (*texts_of({**operands, "reproject": path, "to": to}), *shown_inputs(given))
    return write_map(path, "reprojection", make, request, output, inputs)


def _refuse_source(path: str, source: str) -> None:
    """Refuse to overwrite the map to read, under any name or link."""
    if os.path.exists(source) and os.path.exists(path) and os.path.samefile(source, path):
        raise UsageError(f"{quote_path(path)} is also the map to read", "another name")
