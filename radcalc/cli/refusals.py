"""Errors of the command line: loaded only for an error."""

from itertools import pairwise

import click

from radcalc import errors
from radcalc.calculators import COMMANDS, SUMMARIES
from radcalc.calculators.worksheet import on_page
from radcalc.cli.command import called_in, parameters
from radcalc.errors import quote
from radcalc.quantities.language import names_meant
from radcalc.terminal import FORMATS
from radcalc.units.numbers import is_sentence

DIRECTION = ("--polar", "--azimuth")  # of --toward
TARGETS = ("--to", "--unit", "--in", "--as")  # before the unit of a result
# Words for the operand of a command, typed as options.
MEANT_OPERANDS = {
    "spectrum": "file spectrum spd csv source illuminant lamp",
    "environment": "file source map hdr exr pfm picture image",
    "dose": "file log csv",
    "scene": "file scene csv",
    "columns": "file table csv",
    "mark": "file sheet table csv key answers",
}


def about_unit(
    error: errors.MissingUnit | errors.WrongQuantity, words: list[str]
) -> errors.RadcalcError:
    """Return the error about a unit with the calls that are likely in a command."""
    joined = _join_unit(error, words) if isinstance(error, errors.MissingUnit) else None
    return joined or on_page(error, called_in(words))


def _join_unit(error: errors.MissingUnit, words: list[str]) -> errors.RadcalcError | None:
    """Return the error with the hint to write `--distance 2 ft` as one word, if it was two."""
    from radcalc.quantities.symbols import SYMBOLS
    from radcalc.units.table import resolve

    flag = f"--{error.symbol}"
    following = words[words.index(flag) + 2 :][:1] if flag in words else []
    symbol = SYMBOLS.get(error.symbol)
    try:
        if following and symbol and resolve(following[0]).dimension in symbol.dimensions:
            typed = f"{error.text} {following[0]}"
            return error.reworded(
                hint=errors.correct(typed, f"{error.text}{following[0]}", remark="one word")
            )
    except errors.RadcalcError:
        pass
    return None


def of_click(error: click.UsageError, words: list[str]) -> errors.RadcalcError:
    """Return Click's error about an option or a command, with the nearest correct ones."""
    called = called_in(words)
    if isinstance(error, click.NoSuchOption):
        return _no_such_option(error.option_name, called, words)
    message = one_line(error.format_message().replace(errors.MINUS, "-"))  # as it was typed
    message = message.replace("a valid integer range", "a whole number in its range")
    if "unexpected extra argument" in message:
        return _unexpected(message.partition("(")[2].rstrip(")"), words)
    hint = _of_value(error, called, words) or errors.call(*filter(None, [called]), "--help")
    return errors.RadcalcError(message[:1].lower() + message[1:].rstrip("."), hint)


def _unexpected(word: str, words: list[str]) -> errors.RadcalcError:
    """Return the error for a word that no place is left for."""
    problem = f"unexpected argument '{word}'"
    if ("--plot", word) in pairwise(words):
        return errors.RadcalcError(problem, errors.correct(word, f"{word.partition('.')[0]}.svg"))
    alone = "an option before each value, and the value and its unit as one word: --distance 2m"
    return errors.RadcalcError(problem, _one_word(word, words) or alone)


def _of_value(error: click.UsageError, called: str, words: list[str]) -> errors.Hint:
    """Propose values for an option: its choices, its example, or no value where it needs none."""
    if isinstance(error, click.BadOptionUsage):
        name = error.option_name
        needless = next((word for word in words if word.startswith(f"{name}=")), "")
        is_needless = "does not take a value" in error.format_message()
        return errors.correct(needless, name) if is_needless else _with_value(name, called)
    option = error.param if isinstance(error, click.BadParameter) else None
    if option is None:
        return ""
    name = next((name[2:] for name in option.opts if name[:2] == "--"), "")
    if name and isinstance(option.type, click.Choice):
        typed = error.message.partition("'")[2].partition("'")[0]
        choices = [str(choice) for choice in option.type.choices]
        return [errors.add(name, choice) for choice in errors.nearest(typed, choices) or choices]
    return errors.add(name) if name == "header" else ""


def _with_value(typed: str, called: str) -> errors.Hint:
    """Propose values for an option that has none, or the call without it."""
    from radcalc.quantities.symbols import SYMBOLS

    option = next((p for p in parameters(called) if typed in p.opts), None)
    if option and isinstance(option.type, click.Choice):
        return [errors.correct(typed, typed, str(choice)) for choice in option.type.choices]
    return errors.add(typed[2:]) if typed[2:] in SYMBOLS else errors.drop(typed)


def _one_word(unit: str, words: list[str]) -> list[errors.Try]:
    """Propose a number and its unit, typed as two words, as one."""
    from radcalc.units.table import unit_of
    from radcalc.units.values import find_scale

    before = next((a for a, b in pairwise(words) if b == unit), "")
    if before[-1:].isdigit() and before[:1] not in "-" and (unit_of(unit) or find_scale(unit)):
        return [errors.correct(f"{before} {unit}", f"{before}{unit}", remark="one word")]
    return []


def _no_such_option(typed: str, called: str, words: list[str]) -> errors.RadcalcError:
    """Return the error for an unknown option, with the likeliest correction as its hint."""
    from radcalc.calculators.page import GET

    if after_command := options_behind(words):
        problem = f"'{quote(words[0])}' is before the command: options go after it"
        return errors.RadcalcError(problem, after_command)
    if called == "convert" and typed in GET.spellings:
        problem = f"convert has no {quote(typed)} option: a conversion has one result"
        return errors.RadcalcError(problem, errors.call(*_with_values(_bare(words))))
    problem = f"{called or 'radcalc'} has no {quote(typed)} option"
    if operand := _operand(typed, called, words):
        return errors.RadcalcError(problem, operand)
    if typed[2:] in FORMATS:
        return errors.RadcalcError(problem, errors.correct(typed, "--format", typed[2:]))
    if toward := _toward(called, words):
        return errors.RadcalcError(problem, toward)
    known = [name for p in parameters(called) for name in p.opts if name.startswith("--")]
    if doubled := _doubled(typed, known, words):
        return errors.RadcalcError(problem, doubled)
    if called and typed in TARGETS:
        hint = _results_in(typed, called, words) or errors.call(called, "--help")
        return errors.RadcalcError(problem, hint)
    if near := _near(typed, called, known):
        return errors.RadcalcError(problem, near)
    manual = errors.call(*filter(None, [called]), "--help")
    is_alone = typed.startswith("--") or words == [typed]
    return errors.RadcalcError(problem, manual if is_alone else errors.drop(typed))


def _near(typed: str, called: str, known: list[str]) -> errors.Hint:
    """Return the hint of an option by its other words, another command that has it, or letters."""
    near = [f"--{name}" for name in names_meant(typed[2:], [name[2:] for name in known])]
    if called and not near and typed.startswith("--") and (takers := _takers(typed)):
        others = f" (also {', '.join(takers[1:])})" if takers[1:] else ""
        return errors.call(takers[0], "--help", remark=f"which has {quote(typed)}{others}")
    near = near or errors.nearest(f"--{typed.removeprefix('--').lower()}", known, cutoff=0.7)
    return errors.corrections(typed, *near) if near else ""


def _doubled(typed: str, known: list[str], words: list[str]) -> list[errors.Try]:
    """Propose --divergence 1mrad for --half-divergence 0.5mrad."""
    whole = f"--{typed.removeprefix('--half-')}"
    values = [value for name, value in pairwise(words) if name == typed]
    values += [word.partition("=")[2] for word in words if word.startswith(f"{typed}=")]
    if whole == typed or whole not in known or not values:
        return []
    from radcalc.units.amounts import split_value

    try:
        number, unit = split_value(values[0])
    except errors.RadcalcError:
        return []
    mark = "=" if f"{typed}={values[0]}" in words else " "
    twice = f"{2 * number:.15g}{unit}"
    return [
        errors.correct(
            f"{typed}{mark}{values[0]}", whole, twice, remark="the full one is twice the half"
        )
    ]


def _operand(typed: str, called: str, words: list[str]) -> errors.Try | None:
    """Return the call with an option that is a word for the operand left out, or None."""
    if typed.removeprefix("--").lower() not in MEANT_OPERANDS.get(called, "").split():
        return None
    if typed in words[:-1]:
        following = words[words.index(typed) + 1]
        return None if following.startswith("--") else errors.drop(typed)
    joined = next((word for word in words if word.startswith(f"{typed}=")), "")
    return errors.correct(joined, joined.partition("=")[2]) if joined else None


def _toward(called: str, words: list[str]) -> errors.Try | None:
    """Return the call with the direction of --polar and --azimuth as --toward, or None."""
    from radcalc.calculators.page import GET

    values = {name: value for name, value in pairwise([*words, ""]) if name in DIRECTION}
    if not values or not any("--toward" in one.opts for one in parameters(called)):
        return None
    pairs = [pair for name in values for pair in (name, values[name])]
    kept = ["intensity-toward" if w == "intensity" else w for w in words if w not in pairs]
    own = {} if {*GET.spellings} & {*words} else {"get": "intensity-toward"}
    toward = ",".join([values.get(name, "0deg") for name in DIRECTION])
    return errors.call(*kept, toward=toward, **own)


def _results_in(typed: str, called: str, words: list[str]) -> list[errors.Try]:
    """Return the calls with a result in the unit of --to; none if no result has it."""
    from radcalc.calculators.results import right_names
    from radcalc.cli.lane import asked

    at = next(k for k, word in enumerate(words) if word.partition("=")[0] == typed)
    joined = typed != words[at]
    unit = words[at].partition("=")[2] if joined else "".join(words[at + 1 : at + 2])
    text = words[at] if joined else f"{typed} {unit}"
    if called not in SUMMARIES or called == "convert":
        return [errors.correct(text, "to", unit)] if unit and called == "convert" else []
    try:
        values = asked([*words[:at], *words[at + 2 - joined :]]).question.answer.values
    except (errors.RadcalcError, click.UsageError):
        return []
    names = [one for one in right_names(unit, values) if one.endswith(f":{unit}")]
    return [errors.correct(text, "-g", name) for name in names]


def _bare(words: list[str]) -> list[str]:
    """Return a conversion without its -g NAME, and with -n."""
    from radcalc.calculators.page import GET

    kept: list[str] = []
    rest = iter(words)
    for word in rest:
        name, equals, _ = word.partition("=")
        if name not in GET.spellings:
            kept.append(word)
        elif not equals:
            next(rest, "")
    return [*kept, "-n"]


def options_behind(words: list[str]) -> errors.Try | None:
    """Return the call with the options before the command moved after it.

    Return None if there are none, or if the call has another error.
    """
    implied = "convert" if any(is_sentence([word]) for word in words) else ""
    called = next((word for word in words if word in COMMANDS), implied)
    if not called:
        return None
    known = {spelling: p for p in parameters(called) for spelling in p.opts}
    at = 0
    while words[at : at + 1] and words[at].startswith("-") and not is_sentence(words[at:]):
        name, equals, _ = words[at].partition("=")
        if name not in known:
            return None
        is_flag = getattr(known[name], "is_flag", False)
        at += 1 if is_flag or equals else 2
    if not at or not (words[at:] and (words[at] == called or is_sentence(words[at:]))):
        return None
    return errors.call(*_with_values([*words[at:], *words[:at]]))


def _with_values(words: list[str]) -> list[str]:
    """Join an option and a value with a =, for a proposal."""
    mentioned: list[str] = []
    for word in words:
        if "=" in word and mentioned and mentioned[-1].startswith("--"):
            mentioned[-1] = f"{mentioned[-1][2:]}={word}"
        else:
            mentioned.append(word[2:] if word.startswith("--") and "=" in word else word)
    return mentioned


def _takers(name: str) -> list[str]:
    return [c for c in COMMANDS if any(name in p.opts for p in parameters(c))]


def one_line(text: str) -> str:
    """Return one printable line of bounded length."""
    text = " ".join(text.split())
    return quote(text) if not text.isprintable() or len(text) > 300 else text
