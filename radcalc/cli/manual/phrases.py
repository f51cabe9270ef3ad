"""Generated parts of radcalc-sentences(7): the phrases, and the words that add nothing."""

from collections.abc import Iterator
from itertools import groupby

from radcalc.calculators.pages import SUMMARIES, page_of
from radcalc.cli.manual.mdoc import filled, plain, text
from radcalc.quantities.symbols import FLAG, SYMBOLS
from radcalc.sentences.frames import FRAMES, taken_by
from radcalc.sentences.phrases import (
    COMMAND,
    FILTER,
    IGNORED,
    PERIOD,
    PHRASES,
    SHAPE,
    TARGET,
    UNKNOWN,
    Phrase,
)

LONG = 60  # characters of alternatives, which are then on several lines
MISSING = "VALUE"  # of a phrase without an amount
REFUSED = "(refused)"
ASKED = "(the refusal asks for the value)"


def phrases(_: str) -> Iterator[str]:
    """Yield the phrases by their groups, under what they fill."""
    for title, group in groupby(PHRASES, lambda phrase: phrase.group):
        yield f".Ss {text(title.capitalize())}"
        yield ".Bl -tag -width Ds -compact"
        by_place: dict[str, list[Phrase]] = {}
        for phrase in group:
            by_place.setdefault(_place(phrase), []).append(phrase)
        for place, listed in by_place.items():
            yield f".It {place}"
            marks = [" ;"] * (len(listed) - 1) + [""]
            for phrase, mark in zip(listed, marks, strict=True):
                yield f".{_pattern(phrase.pattern)}{mark}"
            if not listed[0].form and place != REFUSED and not _is_flag(listed[0]):
                yield ASKED
        yield ".El"


def fillers(_: str) -> Iterator[str]:
    """Yield the words that add nothing to a sentence."""
    yield from filled(
        [", ".join(sorted({word.replace("-", " ") for word in IGNORED.split()})) + "."]
    )


def frames(_: str) -> Iterator[str]:
    """Yield the commands that sentences call, in the order in which they are tried."""
    *first, last = dict.fromkeys(frame.command for frame in FRAMES)
    yield f".Cm {' , '.join(first)}"
    yield "and"
    yield f".Cm {last} ."


def _is_flag(phrase: Phrase) -> bool:
    return phrase.fills[0] == SHAPE or SYMBOLS[phrase.fills[0]].form == FLAG


def _place(phrase: Phrase) -> str:
    """Return what a phrase fills: options of its readings, a result, or an operand."""
    amounts = [part[1:-1].upper() for part in phrase.pattern.split() if part[0] == "{"]
    value = plain(phrase.form.format(*amounts))
    if phrase.fills == (SHAPE,):
        return f"Cm solid-angle {value}"
    if phrase.fills == (COMMAND,):
        return f"Cm {value}"
    if phrase.fills == (PERIOD,):
        return f"Cm dose Fl -by Cm {value}"
    if phrase.fills == (FILTER,):
        return f"Li * ({value})"
    if phrase.fills == (UNKNOWN,):
        return REFUSED
    if phrase.fills == (TARGET,):
        return f"Fl g Cm {value}"
    options = " No or ".join(map(_option, phrase.fills))
    if not phrase.form:
        return options if _is_flag(phrase) else f"{options} Ar {MISSING}"
    return options if phrase.form == "{}" else f"{options} Cm {value}"


def _option(name: str) -> str:
    """Return the option of a symbol, or the label of one that no command takes."""
    is_taken = any(name in taken_by(page_of(command)) for command in SUMMARIES)
    return f"Fl -{name}" if is_taken else f"Em {SYMBOLS[name].label}"


def _pattern(pattern: str) -> str:
    """Return a pattern in mdoc: words, words that may be missing, and amounts."""
    parts = []
    for part in pattern.split():
        words = plain("|".join(dict.fromkeys(part.rstrip("?").split("|"))))
        words = words.replace("|", " | ") if len(words) > LONG else words
        if part[0] == "{":
            parts.append(f"Ar {part[1:-1].upper()}")
        else:
            parts.append(f"Oo Cm {words} Oc" if part[-1] == "?" else f"Cm {words}")
    return " ".join(parts)
