"""Calls of calculators that are answered without Click: every option is spelled in full, once."""

from radcalc import terminal
from radcalc.calculators.pages import page_of
from radcalc.cli.output import Output, decide
from radcalc.cli.request import Request
from radcalc.errors import OutputError
from radcalc.quantities.symbols import CHOICE, FLAG, SYMBOLS
from radcalc.render.formats import FORMATS

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


def answer(words: "Sequence[str]") -> int | None:
    """Answer a calculator; return the exit status.

    Return None for a command with options of its own, for other words, and for whatever is refused:
    nothing is written before all results are known.
    """
    name, *rest = words
    try:
        operands: list[str] = []
        given: dict[str, Any] = {}
        wanted: list[str] = []
        of_output: dict[str, Any] = {}
        page = page_of(name)
        following = iter(rest)
        for word in following:
            symbol = word.removeprefix("--")
            if word in OUTPUT:
                of_output[OUTPUT[word]] = True
            elif word == "--format" and "format_" not in of_output:
                of_output["format_"] = FORMATS[FORMATS.index(next(following))]
            elif word in GET:
                wanted.append(_value(next(following)))
            elif symbol == word:
                operands.append(_value(word))
            elif symbol in given or not page.accepts(symbol) or SYMBOLS[symbol].form == CHOICE:
                return None
            else:
                given[symbol] = SYMBOLS[symbol].form == FLAG or _value(next(following))
        if (operands and not page.operand) or (name == "convert" and (wanted or not given)):
            return None  # a conversion without conditions was tried before
        output = decide(**of_output, command=name)
        return terminal.ANSWERED if work_out(name, operands, given, wanted, output) else None
    except OutputError as error:  # a full disk
        return terminal.complain(error)
    except Exception:  # an error or a bug, which the boundary reports
        return None


def _value(word: str) -> str:
    """Return a word that is certainly a value: not an option, a stream or a negative number."""
    if not word or word.lstrip()[:1] == "-":
        raise ValueError(word)
    return word


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
    from radcalc.cli.calculator import answerer

    answer = answerer(name)
    if answer:
        answer(
            typed=given, request=Request(listed_in(wanted)), output=output, words=tuple(operands)
        )
    return answer is not None
