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
    template: str
    fields: tuple[Any, ...]

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
        return text if "=" in text else translate(text, language)  # a formula, or a name
    if not isinstance(text, Said):
        return template
    fields = [field if isinstance(field, str) else str(field) for field in text.fields]
    return template.format(*(in_language(field, language) for field in fields))
