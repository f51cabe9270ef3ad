"""`--plot`: a picture below the answer, or as a figure in a file."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from radcalc import stdio
from radcalc.answer import Answer, Input
from radcalc.calculators.results import pick
from radcalc.cli.calculator import Answered, Asked, result, show
from radcalc.cli.command import HERE
from radcalc.cli.options import Output, width_of_terminal
from radcalc.errors import UsageError
from radcalc.given import Inputs
from radcalc.render.formats import CSV, JSON, TABLE

if TYPE_CHECKING:
    from radcalc.plots.data import Picture

FEW = 20  # answers of which a terminal has the table beside the picture
IN_A_FILE = "--plot FILE.svg, which leaves the numbers alone"


def refuse(asked: Asked, output: Output) -> None:
    """Refuse a picture where there is no place for it, before anything is worked out."""
    if asked.check is not None:
        raise UsageError("--check has one number, and no picture", "the same without --plot")
    if asked.plot != HERE:
        from radcalc.plots.figure import check_place

        check_place(asked.plot)
        return
    if output.format in (JSON, CSV):
        raise UsageError(f"a picture is no {output.format.upper()}", IN_A_FILE)
    if output.style.bare:
        raise UsageError("-n prints numbers alone, and no picture", IN_A_FILE)


def picture(
    command: str, given: Sequence[Inputs], answers: Sequence[Answer], asked: Asked, drawn: Any
) -> "Picture":
    """What the answers of a command look like; `drawn` is what it works on beside its inputs."""
    from radcalc.plots import answers as pictures
    from radcalc.plots.curves import Solved

    solved = [Solved(*one) for one in zip(given, answers, strict=True)]
    return pictures.picture(command, solved, asked.wanted, drawn)


def show_beside(
    made: "Picture",
    answers: Sequence[Answered],
    asked: Asked,
    output: Output,
    told: Sequence[Sequence[Input]],
) -> None:
    """Write the answers, and a picture below them or into its file.

    On a terminal many answers are the picture alone, unless their table is asked for.
    """
    if asked.plot != HERE:
        for one in answers:  # before anything is written
            for name in asked.wanted:
                pick(one.answer.values, name, one.case)
        from radcalc.plots.figure import write

        write(asked.plot, made)
        show(answers, asked, output, told)
        return
    count = sum(len(one.long.value) if one.long else 1 for one in answers)
    if count > FEW and output.format == TABLE and not output.is_chosen:
        output.remark([result(one, ()) for one in answers])
    else:
        show(answers, asked, output, told)
        stdio.write("\n")
    draw(made, output)


def draw(made: "Picture", output: Output) -> None:
    """Write a picture in characters."""
    from radcalc.plots import terminal

    style = terminal.style_of(width_of_terminal(), output.style.color)
    stdio.write(terminal.draw(made, style))
