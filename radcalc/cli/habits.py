"""Conversions in the words of other tools: --from and --to, GNU units, and pipes without a -."""

import os
import select
import stat
from contextlib import suppress
from itertools import pairwise

from radcalc.calculators.pages import COMMANDS
from radcalc.cli.files import say
from radcalc.errors import RadcalcError, UsageError, call, quote
from radcalc.units import Unit
from radcalc.units.grammar import ALSO_UNITS, TO
from radcalc.units.numbers import is_sentence

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
    operands, options, typed = _parts(words[is_convert:])
    ends = list(typed.values())
    if is_sentence(operands[:1]):  # it has a value, or the - of a stream
        _refuse_second_unit(operands, typed)
        between = ["to"] if len(ends) == 1 else []
        return _said("convert", *operands, *between, *ends, *options) if ends else words
    source, target = _sides([*operands, *ends])
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


def _refuse_second_unit(operands: list[str], ends: dict[str, str]) -> None:
    """Refuse the unit of --from after a value with its own unit: 500 lx --from fc."""
    from radcalc.units.numbers import split_quantity

    source, unit = ends.get(ENDS[0], ""), "".join(operands[1:2])
    with suppress(RadcalcError):
        unit = split_quantity(operands[0])[1] or unit
    if source and unit and operands[0] != "-":
        problem = f"{quote(operands[0])} has two units: {quote(unit)} and --from {quote(source)}"
        raise UsageError(problem, call("convert", *operands, "to", source))


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
    from radcalc.units.scales import resolve_any

    try:
        return resolve_any(word)
    except RadcalcError:
        return None


def _is_target(word: str) -> bool:
    from radcalc.quantities.search import is_name

    return bool(word) and (_unit(word) is not None or is_name(word))
