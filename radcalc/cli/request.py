"""Requests of a command besides its inputs: results, checks, lines of standard input."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from radcalc import errors, terminal
from radcalc.answer import Answer, Row, ShownInput
from radcalc.calculators.page import Page
from radcalc.calculators.solved import requesting
from radcalc.errors import add
from radcalc.quantities.symbols import SYMBOLS
from radcalc.tuples import NamedTuple

if TYPE_CHECKING:
    from radcalc.cli.cases import Case
    from radcalc.cli.output import Output
    from radcalc.homework.question import Question


def refuse_idle(check: str | None, tolerance: str | None) -> None:
    """Refuse --tolerance without --check."""
    if tolerance is not None and check is None:
        raise errors.UsageError(
            "--tolerance does not apply without --check", errors.leave_out("tolerance")
        )


def several(
    varied: Sequence[ShownInput] = (), operands: Sequence[tuple[str, str]] = ()
) -> errors.UsageError:
    """Return the error for --check with several answers, with the first values as a proposal.

    `varied` are the inputs with several values, `operands` the lists typed as words, each with
    its first value.
    """
    problem = "--check takes one answer, not several"
    first = first_of(varied)
    if first.inputs:
        return errors.UsageError(problem, first)
    lists = [errors.correct(typed, value) for typed, value in operands if typed != value]
    return errors.UsageError(problem, lists or errors.leave_out("check"))


def first_of(varied: Sequence[ShownInput]) -> errors.Try:
    """Propose the first value of each input that has several."""
    return errors.Try(tuple([(given.name, given.text) for given in varied if given.name]))


def refuse_stream(check: str | None) -> None:
    """Refuse --check with a stream."""
    if check is not None:
        raise errors.UsageError("--check cannot be used with a stream", errors.leave_out("check"))


def judge(
    question: "Question",
    claim: str,
    tolerance: str | None,
    output: "Output",
    inputs: Sequence[ShownInput] = (),
) -> int:
    """Write whether an answer is right, or its likely mistake; return the exit status."""
    output.ask(question)
    from radcalc.calculators.results import measured_in, of_kind, said_of
    from radcalc.homework import check
    from radcalc.render.formats import Judgement

    output.refuse_auto("--check compares it with the answer given", errors.leave_out("auto"))
    verdict = check(question, claim, tolerance)
    answer = question.answer
    right = next(value for value in answer.values if value.name == verdict.result)
    name = right.also if question.plan else verdict.name
    label = of_kind(right, measured_in(verdict.unit, right.name))
    is_given, off = right.given is not None, verdict.uncertainty
    row = Row(*label, verdict.value, verdict.unit, "", name, is_given, off)
    output.judge(Judgement(verdict, row, inputs, *said_of(answer, [row])))
    return terminal.ANSWERED if verdict.right else terminal.WRONG


class LineOptions(NamedTuple):
    """The options for streams as typed, or None."""

    field: str | None
    column: str | None
    delimiter: str | None
    header: int | None
    add: str | None
    rename: str | None
    decimal: str | None
    invalid: str | None


def refuse_lines(options: LineOptions, hint: errors.Hint) -> None:
    """Refuse an option for streams if there is no stream."""
    for name, value in zip(LineOptions._fields, options, strict=True):
        if value is not None and value in SYMBOLS["electric-field"].choices:
            raise errors.UsageError(
                f"--{name} {value} applies to the fields of lines, not to a wave",
                errors.Try((("electric-field", value),), (name,), remark="for a wave"),
            )
        if value is not None:
            raise errors.UsageError(f"--{name} applies to lines of standard input only", hint)


def refuse_second_reader(typed: dict[str, Any]) -> None:
    """Refuse a spectrum from standard input, which has the numbers."""
    if str(typed.get("spectrum", "")).partition(":")[0].strip() == "-":
        raise errors.UsageError(
            "- cannot be used twice: there is one standard input", add("spectrum")
        )


def refuse_condition(case: "Case") -> None:
    """Refuse lines of standard input for a condition of a conversion."""
    if case.stream:
        stream_option = errors.option(case.stream.name, "-")
        problem = f"{stream_option}: a conversion reads lines of standard input only for VALUE"
        raise errors.UsageError(problem, errors.command("convert", "-", "UNIT", "TARGET"))


class Request(NamedTuple):
    """The requested results, derivation, check and picture.

    `lines` are the options for lines of standard input; `plot` is the place of the picture.
    """

    wanted: tuple[str, ...] = ()
    steps: bool = False
    check: str | None = None
    tolerance: str | None = None
    lines: LineOptions | None = None
    plot: str = ""

    @classmethod
    def of(cls, values: dict[str, Any], takes_lines: bool) -> "Request":
        """Take the request out of a command's values; refuse --check and --get together."""
        lines = None
        if takes_lines:
            line_values = [values.pop(name) for name in LineOptions._fields]
            lines = LineOptions(*line_values)
        from radcalc.calculators.results import listed_in

        wanted, steps = listed_in(values.pop("wanted")), values.pop("steps")
        checked, tolerance = values.pop("check"), values.pop("tolerance")
        request = cls(wanted, steps, checked, tolerance, lines, values.pop("plot", None) or "")
        refuse_idle(request.check, request.tolerance)
        if request.check is not None and request.wanted:
            raise errors.UsageError(
                "--check cannot be used with --get", errors.one_of("check", "get")
            )
        return request

    def wants(self, name: str) -> bool:
        """Return whether a result is requested, by its name or a spelling of it: R9, R_f,h1."""
        from radcalc.calculators.results import name_of

        names = [*self.wanted, (self.check or "").replace("=", ":")]
        return _letters(name) in [_letters(name_of(text)) for text in names]

    def narrowed(self, function: Callable[..., Answer], page: Page) -> Callable[..., Answer]:
        """Return the function of a page that also calculates the requested results."""
        return requesting(function, tuple(filter(self.wants, page.on_request)))


def _letters(name: str) -> str:
    return "".join(filter(str.isalnum, name.lower()))


TO_TERMINAL = "-"  # --plot without a file
