"""Python's spelling of messages: keywords instead of options."""

from contextlib import suppress

from radcalc.calculators.results import listed_in
from radcalc.errors import NumberError, input_of, spell
from radcalc.quantities.light import describe
from radcalc.quantities.symbols import FLAG, SYMBOLS
from radcalc.units.numbers import read_number
from radcalc.units.table import resolve

OTHER_KEYWORDS = {"check": "claim"}  # options whose keywords differ
# Commands that are not functions.
AT_A_SHELL = ("columns", "help", "manual", "mark", "prompt", "quantities", "units")


def keyword(name: str) -> str:
    """Return a name as Python writes it, without hyphens: `half_angle`."""
    return name.replace("-", "_")


def symbol_name(keyword: str) -> str:
    """Return the symbol or command of a keyword: `half-angle`."""
    return keyword.replace("_", "-")


def is_absent(value: object) -> bool:
    """Return whether an argument counts as not given: None, or a flag that is False."""
    return value is None or value is False


class Python:
    """Python's spelling of symbols and commands in messages."""

    @staticmethod
    def option(name: str, value: str) -> str:
        """Return `height="6 m"`; a value in capitals is a placeholder, and a flag is True."""
        spelled = OTHER_KEYWORDS.get(name) or keyword(name)
        if not value:
            return spelled
        if value.isupper() and value.isalpha():
            return f"{spelled}={value}"
        return f"{spelled}={_as_literal(value)}"

    @staticmethod
    def command(*words: str) -> str:
        """Return `radcalc.lambertian("disc")`, or the shell's command if there is no function."""
        function = keyword(words[0])
        pairs = [input_of(word) for word in words[1:]]
        if words[0] in AT_A_SHELL or any(key == "list" for key, _ in pairs):
            call = " ".join([words[0], *[text for key, text in pairs if not key]])
            return f"`radcalc {call}` at a shell"
        arguments = [
            PythonHint.option(key, value) if key else _as_literal(value)
            for key, value in pairs
            if key != "get"
        ]
        results = listed_in([value for key, value in pairs if key == "get"])
        chosen = Python.result(results[0]) if len(results) == 1 else ""  # several: the whole answer
        return f"radcalc.{function}({', '.join(arguments)}){chosen}"

    @staticmethod
    def result(text: str) -> str:
        name, _, unit = text.partition(":")
        return f".{keyword(name)}" + (f'.to("{unit}")' if unit else "")

    @staticmethod
    def manual(name: str) -> str:
        return f"help(radcalc.{keyword(name)})"

    @staticmethod
    def measured(unit: str) -> str:
        """Return `illuminance (lx)`."""
        return describe(resolve(unit))


class PythonHint(Python):
    """The spelling in a hint, where a flag is shown as typed."""

    @staticmethod
    def option(name: str, value: str) -> str:
        """Return `isotropic=True`."""
        is_flag = name in SYMBOLS and SYMBOLS[name].form == FLAG
        return f"{Python.option(name, '')}=True" if is_flag else Python.option(name, value)


class Documented(Python):
    """The spelling of keywords in docstrings."""

    @staticmethod
    def option(name: str, value: str) -> str:
        """Return `half_angle`, in backquotes."""
        return f"``{Python.option(name, value)}``" if value else f"`{Python.option(name, '')}`"


def _as_literal(value: str) -> str:
    """Return a text in quotes, with a blank between a number and its unit."""
    with suppress(NumberError):
        end = read_number(value)[1]
        value = f"{value[:end]} {value[end:].strip()}".strip()
    return '"' + value.replace('"', '\\"') + '"'


def in_words(text: str) -> str:
    """Return a remark with keywords."""
    return spell(text, Python)
