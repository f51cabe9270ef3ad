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


class Count:
    """A number of things, formatted with the form of their word that it needs in a language.

    The forms are those after 1 and after other numbers in English, after 1, 2 to 4 and 5 in Czech,
    and after 1, 2 and 5 in Russian, where the last digits decide.

    Examples
    --------
    >>> f"{Count(4, 'cs'):clona|clony|clon}, {Count(21, 'ru'):ступень|ступени|ступеней}"
    '4 clony, 21 ступень'
    """

    def __init__(self, number: int, language: str):
        self.number, self.language = number, language

    def __format__(self, forms: str) -> str:
        """Return the number, with its word if the forms `one|few|many` are given."""
        number = str(self.number)
        return f"{number} {forms.split('|')[self._form()]}" if forms else number

    def _form(self) -> int:
        few = {2, 3, 4}
        if self.language == "ru":
            tens, last = divmod(self.number, 10)
            if tens % 10 == 1:
                return 2
            return 0 if last == 1 else 1 if last in few else 2
        if self.language == "cs":
            return 0 if self.number == 1 else 1 if self.number in few else 2
        return 0 if self.number == 1 else 1


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
