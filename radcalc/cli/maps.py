"""Commands that write maps: one at a time, and only if every input is valid."""

from collections.abc import Callable
from typing import TYPE_CHECKING

from radcalc import terminal
from radcalc.answer import ShownInput
from radcalc.calculators.results import pick
from radcalc.cli.answers import Answered, refuse_bare, show
from radcalc.cli.cases import cases
from radcalc.cli.output import Output
from radcalc.cli.request import Request
from radcalc.errors import UsageError, leave_out, quote_path
from radcalc.inputs.given import Inputs, refuse_uncertain
from radcalc.render.progress import progress

if TYPE_CHECKING:
    from radcalc.calculators.maps import RenderedMap


def one_case(typed: dict[str, str], request: Request) -> Inputs:
    """Return the inputs of the only map of a call."""
    if request.check is not None:
        raise UsageError("--check does not apply when a map is written", leave_out("check"))
    if request.plot:
        raise UsageError("--plot does not apply when a map is written", leave_out("plot"))
    all_cases = cases(typed, arrays=False)
    if len(all_cases) > 1 or all_cases[0].stream:
        raise UsageError("one map is written at a time", "one value of everything")
    refuse_uncertain(all_cases[0].given.values(), "a map")
    return all_cases[0].given


def write_map(
    path: str,
    task: str,
    make: Callable[..., "RenderedMap"],
    request: Request,
    output: Output,
    inputs: tuple[ShownInput, ...],
) -> int:
    """Make and write a map, and show its answer; check everything before writing."""
    from radcalc.distributions.maps.pictures import check_target, write_picture

    if not request.wanted:
        refuse_bare(output)
    check_target(path)
    with progress(task, output.style.remarks) as tick:
        rendered = make(progress=tick)
    for name in request.wanted:
        pick(rendered.answer.values, name)
    lost = write_picture(path, rendered.picture)
    description = f"{quote_path(path)}: {rendered.what}"
    answer = rendered.answer._replace(notes=(*rendered.answer.notes, description, *lost))
    show([Answered("", inputs, answer)], request, output)
    return terminal.ANSWERED
