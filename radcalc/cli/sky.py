"""`radcalc sky [TYPE]`."""

from radcalc.answer import texts_of
from radcalc.calculators.sky import OPERAND, sky, sky_map
from radcalc.calculators.solved import Task
from radcalc.cli.calculator import run
from radcalc.cli.cases import cases
from radcalc.cli.output import Output
from radcalc.cli.request import Request
from radcalc.errors import UsageError, quote
from radcalc.inputs.given import shown_inputs


def answer(
    typed: dict[str, str],
    request: Request,
    output: Output,
    words: tuple[str, ...] = (),
    save: str | None = None,
) -> int:
    """Answer for a sky, or write its map."""
    word, *others = words or [OPERAND.default]
    if others:
        raise UsageError(f"unexpected argument '{quote(others[0])}'", "one type of sky")
    name = word.lower()
    if save:
        from radcalc.cli.environment import one_case, write_map

        given = one_case(typed, request)
        inputs = (*texts_of({"type": name, "save": save}), *shown_inputs(given))
        return write_map(
            save, "map", lambda progress: sky_map(name, given), request, output, inputs
        )
    if "size" in typed:
        raise UsageError("--size does not apply without --save", "--save FILE with it")
    all_cases = cases(typed)
    is_drawn = bool(request.plot)
    task = Task(
        "sky",
        lambda given: sky(name, given, is_drawn),
        texts_of({"type": name}),
        name,
        drawn=name,
    )
    return run(all_cases, task, request, output)
