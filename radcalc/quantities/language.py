"""The user's language, and labels in it."""

import os

ENGLISH = "en"
LANGUAGES = (ENGLISH, "cs", "ru")


def language() -> str:
    """Return the language of the locale's messages; English if it is not in `LANGUAGES`."""
    for variable in ("LC_ALL", "LC_MESSAGES", "LANG"):
        if locale := os.environ.get(variable):
            spoken = locale.replace(".", "_").replace("@", "_").partition("_")[0]
            return spoken if spoken in LANGUAGES else ENGLISH
    return ENGLISH


def translate(label: str, language: str) -> str:
    """Return a quantity's English name in a language; unchanged if there is no translation.

    The text in brackets is translated separately; so is the quantity in labels of a mean or a part.
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
