"""A first word that is a file, or neither a file nor a command; files of an unexpected kind."""

import os
from contextlib import suppress
from itertools import takewhile

from radcalc import terminal
from radcalc.calculators.pages import COMMANDS, SUBJECTS
from radcalc.cli.spelling import pasted
from radcalc.errors import (
    RadcalcError,
    Try,
    UsageError,
    call,
    correct,
    corrections,
    nearest,
    quote,
    quote_path,
)

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from collections.abc import Sequence

    from radcalc.cli.output import Listener
    from radcalc.errors import Hint

# The kind of file that each command reads as an operand, and each option.
OPERANDS = {
    "spectrum": "spectrum",
    "environment": "map",
    "dose": "log",
    "scene": "scene",
    "columns": "table",
    "mark": "table",
}
OPTIONS = {"--distribution": "luminaire", "--spectrum": "spectrum"}
QUIET = ("-q", "--quiet")


def begins_with_file(words: list[str]) -> bool:
    """Return whether the first word of a call is a regular file, and nothing that radcalc knows.

    A command, a value, a unit, a quantity and a spectrum come first: ./D65 is the file.
    """
    word = words[0] if words else ""
    if word in COMMANDS or word == "help" or word[:1] in ("", "-") or not os.path.isfile(word):
        return False
    if words[1:] and (words[1][:1] != "-" or "to" in words):  # a sentence
        return False
    if "/" in word:
        return True
    from radcalc.units.numbers import is_sentence
    from radcalc.units.reading import read_amount

    if is_sentence([word]):
        with suppress(RadcalcError):
            read_amount(word)
            return False
    return looked_up(word) is None


def route(path: str) -> tuple[str, ...]:
    """Return the words of the command that a file means, without other options.

    Raises
    ------
    ConditionError
        If the file cannot be read, or is not of a known kind.
    """
    from radcalc.routes.kinds import COMMANDS as FOR_KIND
    from radcalc.routes.kinds import kind_of

    command, symbol = FOR_KIND[kind_of(path)]
    return (command, f"--{symbol}", path) if symbol else (command, path)


def call_of_file(words: list[str]) -> list[str]:
    """Return the call that a file as the first word means.

    A map without a unit is relative.
    """
    routed = [*route(words[0]), *words[1:]]
    has_unit = any(word.partition("=")[0] == "--unit" for word in words)
    if routed[0] == "environment" and not has_unit:
        from radcalc.routes.kinds import is_relative

        if is_relative(words[0]):
            routed[2:2] = ["--unit", "1"]
    return routed


def only_file(words: "Sequence[str]", contents: str, hint: "Hint") -> str:
    """Return the file that a command reads, its only operand."""
    if len(words) == 1:
        return words[0]
    missing = f"the file of the {contents} is missing"
    raise UsageError(f"unexpected argument '{quote(words[1])}'" if words else missing, hint)


def say(
    words: list[str], listener: "Listener | None" = None, assumptions: "Sequence[str]" = ()
) -> None:
    """Write how a call is read, and what that assumes, unless it is quiet."""
    is_quiet = listener is not None and listener.settings.get("quiet")
    if not is_quiet and not {*words} & {*QUIET}:
        terminal.say([*terminal.remarks(assumptions, ()), f"read as: {pasted(words)}"])


def redirected(error: RadcalcError, words: list[str]) -> RadcalcError:
    """Return the error of a command, or a better one if it was given a file of another kind."""
    called = words[0] if words else ""
    option = ""
    for word in words[1:]:
        name, equals, value = word.partition("=")
        expected = OPTIONS.get(name if equals else option)
        path = value if equals else word
        if not option and not word.startswith("-"):
            expected, path = OPERANDS.get(called), word
        option = word if word.startswith("--") and not equals else ""
        if expected and os.path.isfile(path) and (better := _of_other_kind(path, expected)):
            return better
    return error


def _of_other_kind(path: str, expected: str) -> RadcalcError | None:
    from radcalc.routes.kinds import NAMES, TABLE, kind_of

    try:
        kind = kind_of(path)
    except RadcalcError:
        return None
    if kind in (expected, TABLE):
        return None
    message = f"{quote_path(path)} is {NAMES[kind]}, not {NAMES[expected]}"
    return RadcalcError(message, proposed(kind, path))


def proposed(kind: str, path: str) -> Try:
    """Propose the command for a file of a kind."""
    from radcalc.routes.kinds import call_of_file

    return call(*call_of_file(kind, path))


def similar_calls(args: list[str]) -> "Hint":
    """Return the hint for a word that is not a command."""
    word = args[0].lower()
    if near := nearest(word, COMMANDS, 1, 0.75):
        return correct(args[0], near[0])
    from radcalc.calculators.solid_angle import NAMES

    if word in NAMES:
        return correct(args[0], "solid-angle", word)
    names = [name for name, synonyms in SUBJECTS.items() if word in synonyms.split()]
    if names:
        tries = corrections(args[0], *names[:2])
        return tries if args[1:] else [call(names[0], "--help")]
    whole = " ".join(args)
    return looked_up(args[0]) or looked_up(whole) or typical_of(whole) or "radcalc --help"


def absent_file(args: list[str]) -> UsageError | None:
    """Return the error for a word with the ending of a file that does not exist, if any.

    Words after an option, such as the file of a picture, are not files to read.
    """
    from radcalc.routes.kinds import ALL_ENDINGS

    before = takewhile(lambda word: word[:1] != "-", args)
    absent = [a for a in before if a.lower().endswith(ALL_ENDINGS) and not os.path.exists(a)]
    if not absent:
        return None
    folder, name = os.path.split(absent[0])
    near: list[str] = []
    with suppress(OSError):
        near = nearest(name, [one.name for one in os.scandir(folder or ".") if one.is_file()])
    paths = [os.path.join(folder, one) for one in near]
    hint = corrections(absent[0], *paths) or "the path of a file"
    return UsageError(f"there is no file '{quote(absent[0])}'", hint)


def typical_of(text: str) -> Try | None:
    """Return the call that lists typical values of a thing; None if there are none."""
    from radcalc.quantities.lookup import is_seen

    return call("typical", *text.split()) if is_seen(text) else None


def looked_up(word: str) -> Try | None:
    """Return the call that explains a unit, a quantity or a spectrum; None for other words."""
    from radcalc.quantities.search import is_name
    from radcalc.spectra.sources import find_named
    from radcalc.units.scales import find
    from radcalc.units.table import unit_of

    if unit_of(word) or find(word):
        return call("units", word)
    if is_name(word):
        return call("quantities", word)
    return call("spectrum", word) if find_named(word) else None
