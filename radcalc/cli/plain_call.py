"""Calls of calculators that are answered without Click: every option is spelled in full, once."""

from radcalc import terminal
from radcalc.calculators.pages import page_of
from radcalc.cli.output import Output, decide
from radcalc.cli.request import Request
from radcalc.errors import OutputError
from radcalc.quantities.symbols import CHOICE, FLAG, SYMBOLS
from radcalc.terminal import FORMATS
from radcalc.tuples import NamedTuple

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

GET = ("-g", "--get")
# Options of the output without a value, and the parameters of `decide`.
OUTPUT = {
    "--json": "json_",
    "-n": "number",
    "--number": "number",
    "-q": "quiet",
    "--quiet": "quiet",
}
OF_LINES = {  # options for lines with a text as their value
    "--field": "field",
    "--column": "column",
    "-d": "delimiter",
    "--delimiter": "delimiter",
    "--add": "add",
    "--rename": "rename",
}


class Call(NamedTuple):
    """The words of a call: operands, inputs, results, and options of the output and of lines."""

    operands: list[str]
    given: "dict[str, Any]"
    wanted: list[str]
    of_output: "dict[str, Any]"
    of_lines: dict[str, str]


def answer_in_full(words: "Sequence[str]") -> int | BaseException | None:
    """Answer a calculator, or lines of standard input by `convert`; return the exit status.

    Return None for a command with options of its own, for other words, and for whatever is refused:
    nothing is written before all results are known.  Return the error of lines that are refused:
    some may be read and written.
    """
    name = words[0]
    try:
        call = _read(words)
        output = decide(**call.of_output, command=name)
        is_stream = name == "convert" and call.operands[:1] == ["-"]
        if is_stream and not (call.given or call.wanted):
            return _convert_lines(call, output)
        # a conversion without conditions was tried before
        is_other = name == "convert" and (call.wanted or not call.given)
        if is_stream or is_other or call.of_lines:
            return None
        if work_out(name, call.operands, call.given, call.wanted, output):
            return terminal.ANSWERED
        return None
    except OutputError as error:  # a full disk
        return terminal.complain(error)
    except Exception:  # an error or a bug, which the boundary reports
        return None


def _read(words: "Sequence[str]") -> Call:
    """Read the words of a call; raise ValueError for those that need Click."""
    name, *rest = words
    call = Call([], {}, [], {}, {})
    page = page_of(name)
    following = iter(rest)
    for word in following:
        symbol = word.removeprefix("--")
        if word in OUTPUT:
            call.of_output[OUTPUT[word]] = True
        elif word == "--format" and "format_" not in call.of_output:
            call.of_output["format_"] = FORMATS[FORMATS.index(next(following))]
        elif word in GET:
            call.wanted.append(_value(next(following)))
        elif word in OF_LINES and OF_LINES[word] not in call.of_lines:
            call.of_lines[OF_LINES[word]] = _value(next(following))
        elif symbol == word and page.operand:
            call.operands.append(word if word == "-" else _value(word))
        elif symbol in call.given or not page.accepts(symbol) or SYMBOLS[symbol].form == CHOICE:
            raise ValueError(word)
        else:
            call.given[symbol] = SYMBOLS[symbol].form == FLAG or _value(next(following))
    return call


def _value(word: str) -> str:
    """Return a word that is certainly a value: not an option, a stream or a negative number."""
    if not word or word.lstrip()[:1] == "-":
        raise ValueError(word)
    return word


def _convert_lines(call: Call, output: Output) -> int | BaseException:
    """Convert the lines of standard input; return the exit status, or the error."""
    from radcalc.cli import streams
    from radcalc.cli.cases import Case
    from radcalc.cli.request import LineOptions

    typed: dict[str, Any] = dict.fromkeys(LineOptions._fields) | call.of_lines
    try:
        return streams.convert(call.operands, LineOptions(**typed), [Case({})], False, output)
    except BaseException as error:
        return error


def work_out(
    name: str,
    operands: "Sequence[str]",
    given: "dict[str, Any]",
    wanted: "Sequence[str]",
    output: Output,
) -> bool:
    """Write the answers of a calculator or of `convert` to typed inputs; return whether it can."""
    if name == "convert":
        from radcalc.calculators.convert import PAGE
        from radcalc.cli.cases import cases
        from radcalc.cli.conversions import conversions, show

        show(conversions([*operands], cases(given, False, bare=PAGE.bare)), given, False, output)
        return True
    from radcalc.calculators.results import listed_in
    from radcalc.cli.operands import answerer

    answer_in_full = answerer(name)
    if answer_in_full:
        answer_in_full(
            typed=given, request=Request(listed_in(wanted)), output=output, words=tuple(operands)
        )
    return answer_in_full is not None
