"""The quantities' names in the user's language: which language that is, and a label in it."""

import os

ENGLISH = "en"
LANGUAGES = (ENGLISH, "cs", "ru")


def language() -> str:
    """Return the language of the locale's messages; English where it is not one of `LANGUAGES`."""
    for variable in ("LC_ALL", "LC_MESSAGES", "LANG"):
        if locale := os.environ.get(variable):
            spoken = locale.replace(".", "_").replace("@", "_").partition("_")[0]
            return spoken if spoken in LANGUAGES else ENGLISH
    return ENGLISH


def translate(label: str, language: str) -> str:
    """A quantity's English name in a language; as it is where there is no other.

    What stands in brackets, the axis of a spectral density, is translated by itself; so is the
    quantity of which a mean, a part or the like is told.
    """
    if language == ENGLISH:
        return label
    stem, bracket, rest = label.partition(" (")
    if bracket:
        return f"{translate(stem, language)} ({translate(rest.removesuffix(')'), language)})"
    from radcalc.quantities.names import LABELS, PARTS, QUANTITIES

    place = LANGUAGES.index(language) - 1
    if label in LABELS:
        return LABELS[label][place]
    for part, names in PARTS.items():
        whole = f" {label} ".replace(f" {part} ", " ").strip()
        if whole != label and (name := translate(whole, language)) != whole:
            return names[place].format(name)
    return next((q.name(language) for q in QUANTITIES if q.name(ENGLISH) == label), label)
