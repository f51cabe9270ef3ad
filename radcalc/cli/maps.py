"""Maps that commands write: one at a time, and none where anything is refused."""

from collections.abc import Callable
from typing import TYPE_CHECKING

from radcalc import stdio
from radcalc.answer import Input
from radcalc.calculators.results import pick
from radcalc.cli.calculator import Answered, Asked, refuse_bare, show
from radcalc.cli.cases import cases
from radcalc.cli.options import Output
from radcalc.errors import UsageError, quote_path
from radcalc.given import Inputs, refuse_uncertain
from radcalc.render.progress import progress

if TYPE_CHECKING:
    from radcalc.calculators.environment import Made


def one_case(typed: dict[str, str], asked: Asked) -> Inputs:
    """What is given for a map, of which one is made at a time."""
    if asked.check is not None:
        raise UsageError("--check has no use where a map is written", "the same without --check")
    if asked.plot:
        raise UsageError("--plot has no use where a map is written", "the same without --plot")
    each = cases(typed)
    if len(each) > 1 or each[0].stream:
        raise UsageError("one map is written at a time", "one value of everything")
    refuse_uncertain(each[0].given.values(), "a map")
    return each[0].given


def write_map(
    path: str,
    task: str,
    make: Callable[..., "Made"],
    asked: Asked,
    shown: Output,
    inputs: tuple[Input, ...],
) -> int:
    """Make a map, write it, and tell what it is; everything is checked before it is written."""
    from radcalc.distributions.maps.pictures import check_target, write_picture

    if not asked.wanted:
        refuse_bare(shown)
    check_target(path)
    with progress(task, shown.style.remarks) as tick:
        made = make(progress=tick)
    for name in asked.wanted:
        pick(made.answer.values, name)
    lost = write_picture(path, made.picture)
    said = f"{quote_path(path)}: {made.what}"
    answer = made.answer._replace(notes=(*made.answer.notes, said, *lost))
    show([Answered("", inputs, answer)], asked, shown)
    return stdio.ANSWERED
