"""The words of a call: symbols and commands in the shell's spelling, files, words of other tools.

A first word may be a file, or neither a file nor a command; or a file is of an unexpected kind.
Other tools convert with --from and --to, as GNU units does, and in pipes without a -.
"""

import os
import select
import stat
from contextlib import suppress
from itertools import pairwise, takewhile

from radcalc import errors, terminal
from radcalc.calculators import COMMANDS, SUBJECTS
from radcalc.errors import MINUS, NoFile, RadcalcError, UsageError, call, nearest, quote
from radcalc.units import Unit
from radcalc.units.grammar import ALSO_UNITS, TO
from radcalc.units.numbers import is_sentence

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence
    from types import ModuleType
    from typing import Any

    from radcalc.errors import Hint

# The groups of the help, in its order.  That of COMMANDS is the order of proposals.
GROUPS = {
    "Convert": ("convert",),
    "Lamps and files": ("point-source", "scene", "uberlight", "laser", "dose", "columns"),
    "Surfaces, sky and rooms": ("lambertian", "environment", "sky", "room", "screen", "refraction"),
    "Light itself": (
        "photon",
        "spectrum",
        "mesopic",
        "solid-angle",
        "direction",
        "etendue",
        "integrate",
    ),
    "Cameras and detectors": ("ev", "sensor", "calorimeter"),
    "Homework": ("mark",),
    "Tables and help": ("units", "quantities", "typical", "examples", "manual", "help", "prompt"),
}
HELP_NAMES = SHORT_HELP, COMPLETE_HELP = "-h", "--help"
EXPLAIN = "--explain"


def own_module(name: str) -> "ModuleType | None":
    """Import the module of a command; None for a calculator that its page describes alone."""
    from importlib import import_module
    from importlib.util import find_spec

    module_name = f"radcalc.cli.{name.replace('-', '_')}"
    return import_module(module_name) if find_spec(module_name) else None


LONGEST = 10_000  # characters of a typed line
NEED_QUOTES = set(" ()<>;&|")  # at a shell
SAFE = dict.fromkeys(map(ord, "%+,-./:=@_^µΩ°²³·"))  # at a shell, without quotes


class Shell:
    """The spelling as typed at a shell: options begin with two dashes."""

    @staticmethod
    def option(name: str, value: str) -> str:
        """Return `--height 6m`."""
        text = f"'{value}'" if "'" not in value and NEED_QUOTES.intersection(value) else value
        return f"{'-g' if name == 'get' else f'--{name}'} {text}".rstrip()

    @staticmethod
    def command(*words: str) -> str:
        """Return `radcalc solid-angle cone --half-angle 30deg`; a word with = is an option."""
        typed = []
        for name, text in map(errors.input_of, words):
            quoted = f"'{text}'" if NEED_QUOTES.intersection(text) else text
            typed.append(Shell.option(name, text) if name else quoted)
        return " ".join(["radcalc", *typed])

    @staticmethod
    def manual(name: str) -> str:
        return f"radcalc {name} --help"

    @staticmethod
    def measured(unit: str) -> str:
        """Return `illuminance (lx)`."""
        from radcalc.quantities import describe
        from radcalc.units.table import resolve

        return describe(resolve(unit))


def refuse_long(line: str) -> None:
    """Refuse a line that is too long to be typed."""
    if len(line) > LONGEST:
        problem = f"a line of {len(line)} characters is too long"
        raise UsageError(problem, f"at most {LONGEST}")


def split(line: str) -> list[str]:
    """Split a line into words, with quotes as at a shell; `radcalc` may be the first of them."""
    import shlex  # slow, and rarely needed

    try:
        words = shlex.split(line)
    except ValueError as error:
        mark = "\\" if "escaped" in str(error) else '"' if line.count('"') % 2 else "'"
        missing = "nothing after it" if mark == "\\" else "no second one"
        raise UsageError(f"the {mark} has {missing}", f"the line without {mark}") from None
    return words[1:] if words[:1] == ["radcalc"] else words


def pasted(words: "Sequence[str]") -> str:
    """Return a call as it can be pasted at a shell."""
    return " ".join(["radcalc", *map(quoted, words)])


def quoted(word: str) -> str:
    """Return a word as typed at a shell; < is a redirection."""
    others = word.translate(SAFE)
    if word == "<" or (word and (others.isalnum() or not others)):
        return word
    import shlex  # slow, and rarely needed

    return shlex.quote(word)


def spelled(text: str) -> str:
    """Return a text with its mentions spelled as at a shell."""
    return errors.spell(text, Shell)


def typed(words: "Sequence[str]") -> "Iterator[str]":
    """Yield the words of a mention as they are typed: NAME=VALUE is an option."""
    for name, value in map(errors.input_of, words):
        if not name:
            yield value
            continue
        yield "-g" if name == "get" else f"--{name}"
        if value:
            yield value.replace(MINUS, "-")


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
    from radcalc.routes import COMMANDS as FOR_KIND
    from radcalc.routes import kind_of

    command, symbol = FOR_KIND[kind_of(path)]
    return (command, f"--{symbol}", path) if symbol else (command, path)


def call_of_file(words: list[str]) -> list[str]:
    """Return the call that a file as the first word means.

    A map without a unit is relative.
    """
    routed = [*route(words[0]), *words[1:]]
    has_unit = any(word.partition("=")[0] == "--unit" for word in words)
    if routed[0] == "environment" and not has_unit:
        from radcalc.routes import is_relative

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
    words: list[str], settings: "Mapping[str, Any] | None" = None, assumptions: "Sequence[str]" = ()
) -> None:
    """Write how a call is read, and what that assumes, unless it is quiet."""
    is_quiet = settings is not None and settings.get("quiet")
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
    from radcalc.routes import NAMES, TABLE, kind_of

    try:
        kind = kind_of(path)
    except RadcalcError:
        return None
    if kind in (expected, TABLE):
        return None
    message = f"{errors.quote_path(path)} is {NAMES[kind]}, not {NAMES[expected]}"
    return RadcalcError(message, proposed(kind, path))


def proposed(kind: str, path: str) -> errors.Try:
    """Propose the command for a file of a kind."""
    from radcalc.routes import call_of_file

    return call(*call_of_file(kind, path))


def similar_calls(args: list[str]) -> "Hint":
    """Return the hint for a word that is not a command."""
    word = args[0].lower()
    if near := nearest(word, COMMANDS, 1, 0.75):
        return errors.correct(args[0], near[0])
    from radcalc.calculators.solid_angle import NAMES

    if word in NAMES:
        return errors.correct(args[0], "solid-angle", word)
    names = [name for name, synonyms in SUBJECTS.items() if word in synonyms.split()]
    if names:
        tries = errors.corrections(args[0], *names[:2])
        return tries if args[1:] else [call(names[0], "--help")]
    whole = " ".join(args)
    return looked_up(args[0]) or looked_up(whole) or typical_of(whole) or "radcalc --help"


def absent_file(args: list[str]) -> UsageError | None:
    """Return the error for a word with the ending of a file that does not exist, if any.

    Words after an option, such as the file of a picture, are not files to read.
    """
    from radcalc.routes import ALL_ENDINGS

    before = takewhile(lambda word: word[:1] != "-", args)
    absent = [a for a in before if a.lower().endswith(ALL_ENDINGS) and not os.path.exists(a)]
    if not absent:
        return None
    folder, name = os.path.split(absent[0])
    near: list[str] = []
    with suppress(OSError):
        near = nearest(name, [one.name for one in os.scandir(folder or ".") if one.is_file()])
    paths = [os.path.join(folder, one) for one in near]
    hint = errors.corrections(absent[0], *paths) or "the path of a file"
    return NoFile(f"there is no file '{quote(absent[0])}'", hint)


def typical_of(text: str) -> errors.Try | None:
    """Return the call that lists typical values of a thing; None if there are none."""
    from radcalc.quantities.lookup import is_seen

    return call("typical", *text.split()) if is_seen(text) else None


def looked_up(word: str) -> errors.Try | None:
    """Return the call that explains a unit, a quantity or a spectrum; None for other words."""
    from radcalc.quantities.search import is_name
    from radcalc.spectra.sources import is_named
    from radcalc.units.table import unit_of
    from radcalc.units.values import find_scale

    if unit_of(word) or find_scale(word):
        return call("units", word)
    if is_name(word):
        return call("quantities", word)
    return call("spectrum", word) if is_named(word) else None


ENDS = ("--from", "--to")
BETWEEN = (*TO, *ALSO_UNITS)


def is_piped() -> bool:
    """Return whether standard input is a pipe or a regular file, not a terminal or /dev/null."""
    try:
        mode = os.fstat(0).st_mode
    except OSError:
        return False
    return stat.S_ISFIFO(mode) or stat.S_ISREG(mode)


def is_fifo() -> bool:
    """Return whether standard input is a pipe."""
    return is_piped() and stat.S_ISFIFO(os.fstat(0).st_mode)


def _has_data() -> bool | None:
    """Return whether a pipe has data; None if it may have some later, or on Windows."""
    if not hasattr(select, "poll"):
        return None
    poll = select.poll()
    poll.register(0, select.POLLIN)
    events = dict(poll.poll(0)).get(0, 0)
    return True if events & select.POLLIN else False if events & select.POLLHUP else None


def canonical(words: list[str]) -> list[str]:
    """Return the conversion that words of another tool mean, and say so; or the words as they are.

    `convert 500 --from lx --to fc` is `convert 500 lx fc`, and `footcandle lx` is
    `convert 1 footcandle lx`.  With a pipe, `to fc` is `convert - to fc`, `convert lx fc` is
    `convert - lx fc`, and `fc` alone, if the pipe has lines, `convert - fc`.
    """
    parts = words[0].split() if len(words) == 1 and not os.path.exists(words[0]) else words
    found = _canonical(parts)
    return words if found == parts else found


def _canonical(words: list[str]) -> list[str]:
    """Return the conversion that words mean; the words as they are if they mean none."""
    is_convert = words[:1] == ["convert"]
    if not words or _is_other(words[0], words[is_convert:]):
        return words
    operands, options, ends = _parts(words[is_convert:])
    value = operands[: is_sentence(operands[:1])]  # also the - of a stream
    sides = _with_ends(value, operands[len(value) :], ends)
    if value:
        return _said("convert", *value, *sides, *options) if ends else words
    source, target = _sides(sides)
    if not _is_target(target):
        return words
    units = [*filter(None, (source, target))]
    has_word = bool(ends) or (not source and operands != [target])  # to, --from or --to
    is_read = not source or _unit(source) is not None
    if (is_convert or has_word) and is_read and is_piped():
        return _said("convert", "-", *units, *options)
    if source and is_read and _unit(target):
        return _said("convert", "-" if _has_lines(units) else "1", *units, *options)
    if operands == [target] and not ends and is_fifo() and _has_data():
        return _said("convert", "-", target, *options)
    # without a pipe, a target alone is refused for its missing value
    return ["convert", "to", target, *options] if has_word and not source else words


def _with_ends(value: list[str], sides: list[str], ends: dict[str, str]) -> list[str]:
    """Return the words after a value, with the units of --from and --to in their places."""
    last = [ends[name] for name in ENDS[1:] if name in ends]
    if ENDS[0] in ends:
        return _after_source(value, sides, ends[ENDS[0]], last)
    return [*sides, *(["to"] if value and last else []), *last]


def _after_source(value: list[str], sides: list[str], source: str, last: list[str]) -> list[str]:
    """Return the unit of --from and the target; refuse another unit, and a missing target.

    The `sides` are the words after the value, `last` is the unit of --to.
    """
    from radcalc.units.numbers import split_quantity

    targets = [*[side for side in sides if side not in TO], *last]
    is_number = value not in ([], ["-"])
    is_unit = len(targets) > 1 or (is_number and sides != [] and sides[0] not in TO)
    unit = targets[0] if is_unit else ""
    with suppress(RadcalcError):
        unit = (is_number and split_quantity(value[0])[1]) or unit
    if unit:
        problem = (
            f"{quote((*value, *sides)[0])} has two units: {quote(unit)} and --from {quote(source)}"
        )
        readings = [[source, unit], [unit, "to", source]] if targets == [unit] else [targets]
        readings = readings if targets else [["to", source]]
        raise UsageError(problem, [call("convert", *value, *each) for each in readings])
    if not targets and not is_number:
        raise UsageError("a target is missing: --to", call("convert", "1", source))
    return [source, *targets]


def _is_other(first: str, words: list[str]) -> bool:
    """Return whether a call is another command, or a conversion without words of other tools."""
    if first in COMMANDS and first != "convert":
        return True
    typed = " ".join(words)
    if typed[:1].isdigit() and ENDS[0] not in typed and ENDS[1] not in typed:
        return True  # without further calls, as most are
    is_option = first[:1] == "-" and first.partition("=")[0] not in ENDS
    return not first or (is_option and not _is_operand(first))


def _has_lines(units: list[str]) -> bool:
    """Return whether a pipe has lines; refuse one that may have some later."""
    has_data = _has_data() if is_fifo() else False
    if has_data is not None:
        return has_data
    problem = "standard input is a pipe, whose lines may be the values"
    raise UsageError(problem, [call("convert", "-", *units), call("convert", "1", *units)])


def _said(*words: str) -> list[str]:
    say([*words])
    return [*words]


def _sides(words: list[str]) -> tuple[str, str]:
    """Return the unit and the target, "" for what is missing."""
    if len(words) == 3 and words[1] in BETWEEN:
        return words[0], words[2]
    if len(words) == 2:
        inch, target = map(_unit, words)
        is_unit = inch and target and inch.dimension == target.dimension
        return ("" if words[0] in BETWEEN and not is_unit else words[0]), words[1]
    return "", words[0] if len(words) == 1 else ""


def _parts(words: list[str]) -> tuple[list[str], list[str], dict[str, str]]:
    """Return the operands, the options after them, and the units of --from and --to."""
    ends: dict[str, str] = {}
    rest: list[str] = []
    waiting = ""
    for word in words:
        name, is_joined, value = word.partition("=")
        if not waiting and name in ENDS and name in ends:
            typed = [following for word, following in pairwise(words) if word == name]
            hint = (
                call("convert", *rest, "to", ",".join(typed)) if name == ENDS[1] else "one of them"
            )
            raise UsageError(f"{name} is given more than once", hint)
        if waiting:
            ends[waiting], waiting = word, ""
        elif name in ENDS and is_joined:
            ends[name] = value
        elif name in ENDS:
            waiting = name
        else:
            rest.append(word)
    if waiting:  # without its unit
        return words, [], {}
    options = (k for k, word in enumerate(rest) if word[:1] == "-" and not _is_operand(word))
    count = next(options, len(rest))
    return rest[:count], rest[count:], {name: ends[name] for name in ENDS if name in ends}


def _is_operand(word: str) -> bool:
    return word in TO or is_sentence([word])


def _unit(word: str) -> Unit | None:
    from radcalc.units.values import resolve_any

    try:
        return resolve_any(word)
    except RadcalcError:
        return None


def _is_target(word: str) -> bool:
    from radcalc.quantities.search import is_name

    return bool(word) and (_unit(word) is not None or is_name(word))
