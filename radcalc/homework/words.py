"""The words of a verdict: an English sentence that knows its template, for other languages."""

from collections.abc import Iterable, Iterator
from typing import Any

from radcalc.quantities.language import ENGLISH, LANGUAGES, Count, translate


class Said(str):
    """An English sentence, with the template and the fields that it was made of.

    The field of a number of things may have the forms of their word.

    Examples
    --------
    >>> Said("the {0} was forgotten", "reflectance")
    'the reflectance was forgotten'
    >>> Said("to {0:digit|digits}", 3)
    'to 3 digits'
    """

    __slots__ = ("fields", "template")
    template: str
    fields: tuple[Any, ...]

    def __new__(cls, template: str, *fields: Any) -> "Said":
        said = super().__new__(cls, template.format(*_counted(fields, ENGLISH)))
        said.template, said.fields = template, fields
        return said


def in_language(text: str, language: str) -> str:
    """Return a sentence of a verdict in a language; a word without a translation stays English."""
    if language == ENGLISH:
        return text
    from radcalc.homework.translations import SENTENCES

    template = text.template if isinstance(text, Said) else text
    if template in SENTENCES:
        template = SENTENCES[template][LANGUAGES.index(language) - 1]
    elif not isinstance(text, Said):
        return text if "=" in text else translate(text, language)  # a formula, or a name
    if not isinstance(text, Said):
        return template
    fields = (in_language(f, language) if isinstance(f, str) else f for f in text.fields)
    return template.format(*_counted(fields, language))


def _counted(fields: Iterable[Any], language: str) -> Iterator[Any]:
    """Yield the fields of a sentence, where a number takes its word in the form of a language."""
    for field in fields:
        yield Count(field, language) if isinstance(field, int) else field
