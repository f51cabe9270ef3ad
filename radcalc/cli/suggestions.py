"""Suggestions for a word that is not a command."""

from radcalc.calculators.pages import SUBJECTS
from radcalc.cli.names import COMMANDS
from radcalc.errors import Hint, Try, call, correct, corrections, nearest


def meant(args: list[str]) -> Hint:
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
    return looked_up(args[0]) or looked_up(" ".join(args)) or "radcalc --help"


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
