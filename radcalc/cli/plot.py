"""Pictures below the answer or in a file, and maps in files."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from radcalc import terminal
from radcalc.answer import Answer, Result, ShownInput
from radcalc.calculators.results import pick
from radcalc.calculators.solved import Task
from radcalc.cli.answers import Answered, refuse_bare, result, show, with_steps
from radcalc.cli.output import Output, height_of_terminal, width_of_terminal
from radcalc.cli.request import TO_TERMINAL, Request, cases
from radcalc.errors import UsageError, add, leave_out, one_of, quote_path
from radcalc.inputs import Inputs, refuse_uncertain
from radcalc.terminal import CSV, JSON, TABLE

if TYPE_CHECKING:
    from radcalc.calculators.solved import RenderedMap
    from radcalc.plots import Picture

FEW = 20  # most answers with both a table and a picture on a terminal
A_FIGURE = "a figure in a file"


def refuse(request: Request, output: Output) -> None:
    """Refuse an impossible picture before anything is calculated."""
    if request.check is not None:
        raise UsageError("--plot cannot be used with --check", leave_out("plot"))
    if request.plot != TO_TERMINAL:
        from radcalc.plots.figure import check_place, load_apart

        load_apart()
        check_place(request.plot)
        return
    if output.format in (JSON, CSV):
        problem = f"--plot cannot be used with --format {output.format}"
        instead = add("plot", "plot.svg", A_FIGURE)
        raise UsageError(problem, [instead, leave_out("plot"), leave_out("json", "format")])
    if output.style.bare:
        problem = "--plot cannot be used with -n"
        raise UsageError(problem, one_of("plot", "number"))


def picture(
    task: Task, given: Sequence[Inputs], answers: Sequence[Answer], wanted: Sequence[str]
) -> "Picture":
    """Return the picture of a task's answers, or of the requested results."""
    from radcalc.plots import answers as pictures
    from radcalc.plots.curves import Solved

    solved = [Solved(*pair) for pair in zip(given, answers, strict=True)]
    return pictures.picture(task.command, solved, wanted, task.drawn)


def show_with_picture(
    drawing: "Picture",
    answers: Sequence[Answered],
    request: Request,
    output: Output,
    inputs: Sequence[Sequence[ShownInput]],
) -> None:
    """Write the answers, with a picture below them or in its file.

    On a terminal, a picture replaces the table of many answers unless a table is requested.
    """
    from radcalc.plots import IN_A_FILE

    if request.plot == TO_TERMINAL and (kind := IN_A_FILE.get(type(drawing))):
        problem = f"{kind} is not drawn in characters"
        raise UsageError(problem, add("plot", "plot.png", A_FIGURE))
    drawn = [_drawn(answered, request.wanted) for answered in with_steps(answers, request)]
    if request.plot != TO_TERMINAL:
        from radcalc.plots.figure import write

        write(request.plot, drawing)
        show(answers, request, output, inputs)
        return
    count = sum(len(answered.long.value) if answered.long else 1 for answered in answers)
    if count > FEW and output.format == TABLE and not output.is_chosen:
        output.remark(drawn)
    else:
        show(answers, request, output, inputs)
        terminal.write("\n")
    draw(drawing, output)


def _drawn(answered: Answered, wanted: Sequence[str]) -> Result:
    """Return the requested results of an answer, or all."""
    chosen = [pick(answered.answer.values, name, answered.case) for name in wanted]
    return result(answered, chosen or None)


def draw(drawing: "Picture", output: Output) -> None:
    """Write a picture in characters."""
    from radcalc.plots import characters

    size = width_of_terminal(), height_of_terminal()
    style = characters.style_of(*size, output.style.color)
    terminal.write(characters.draw(drawing, style))


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
    from radcalc.render.table import progress

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
