"""The words of a verdict: an English sentence that knows its template, for other languages.

The catalogues of other languages are radcalc/locale/*/LC_MESSAGES/radcalc.po.  The build hook
compiles them; without a compiled catalogue the words stay English.
"""

import os
from typing import Any

from radcalc.quantities.language import ENGLISH, translate

CATALOGUES = os.path.join(os.path.dirname(os.path.dirname(__file__)), "locale")
DOMAIN = "radcalc"  # the name of a catalogue's file


class Translatable(str):
    """An English sentence, with the template and the fields that it was made of.

    If the first field is a number of things, `plural` is the template for other numbers than 1.

    Examples
    --------
    >>> Translatable("the {0} was forgotten", "reflectance")
    'the reflectance was forgotten'
    >>> Translatable("to {0} digit", 3, plural="to {0} digits")
    'to 3 digits'
    """

    __slots__ = ("fields", "plural", "template")
    fields: tuple[Any, ...]
    plural: str
    template: str

    def __new__(cls, template: str, *fields: Any, plural: str = "") -> "Translatable":
        used = plural if plural and fields[0] != 1 else template
        sentence = super().__new__(cls, used.format(*fields))
        sentence.template, sentence.fields, sentence.plural = template, fields, plural
        return sentence


def in_language(text: str, language: str) -> str:
    """Return a sentence of a verdict in a language; a word without a translation stays English."""
    if language == ENGLISH or not text:
        return text
    from gettext import translation  # which imports re

    catalogue = translation(DOMAIN, CATALOGUES, [language], fallback=True)
    if not isinstance(text, Translatable):
        translated = catalogue.gettext(text)
        is_name = translated == text and "=" not in text  # not a formula
        return translate(text, language) if is_name else translated
    if text.plural:
        template = catalogue.ngettext(text.template, text.plural, text.fields[0])
    else:
        template = catalogue.gettext(text.template)
    fields = (in_language(f, language) if isinstance(f, str) else f for f in text.fields)
    return template.format(*fields)
