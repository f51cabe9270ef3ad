"""The words of a verdict: an English sentence that knows its template, for other languages."""

from typing import Any

from radcalc.quantities.language import ENGLISH, LANGUAGES, translate


class Said(str):
    """An English sentence, with the template and the fields that it was made of.

    Examples
    --------
    >>> Said("the {0} was forgotten", "reflectance")
    'the reflectance was forgotten'
    """

    __slots__ = ("fields", "template")

    def __new__(cls, template: str, *fields: Any) -> "Said":
        said = super().__new__(cls, template.format(*fields))
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
        return translate(text, language)
    if not isinstance(text, Said):
        return template
    return template.format(*(in_language(str_of(field), language) for field in text.fields))


def str_of(field: Any) -> str:
    return field if isinstance(field, str) else str(field)
