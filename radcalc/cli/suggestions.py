"""Suggestions for a word that is not a command."""

import os
from contextlib import suppress
from itertools import takewhile

from radcalc.calculators.pages import COMMANDS, SUBJECTS
from radcalc.errors import Hint, Try, UsageError, call, correct, corrections, nearest, quote


def similar_calls(args: list[str]) -> Hint:
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
    from radcalc.quantities.typical import is_seen

    return call("typical", *text.split()) if is_seen(text) else None


def looked_up(word: str) -> Try | None:
    """Return the call that explains a unit, a quantity or a spectrum; None for other words."""
    from radcalc.quantities.targets import is_name
    from radcalc.spectra.sources import find_named
    from radcalc.units.scales import find
    from radcalc.units.table import unit_of

    if unit_of(word) or find(word):
        return call("units", word)
    if is_name(word):
        return call("quantities", word)
    return call("spectrum", word) if find_named(word) else None
