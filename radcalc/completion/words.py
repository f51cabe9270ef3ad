"""The words of a line being typed, and completions of values: units, spectra, files, results."""

import os

from radcalc.completion.table import COMMANDS, ENDINGS, NAMES, SPECTRA, UNITS
from radcalc.spectra import FORMS
from radcalc.units import OWN, Unit
from radcalc.units.compiled import CONSTANTS
from radcalc.units.compiled import UNITS as COMPILED
from radcalc.units.numbers import is_sentence

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping, Sequence
    from typing import Any

HELP = "help"  # `radcalc help convert`
DIGITS = "0123456789"


class Completion:
    """A completion of a word; `closes` if a blank follows rather than more of the word."""

    __slots__ = ("closes", "description", "text")

    def __init__(self, text: str, description: str = "", closes: bool = True) -> None:
        self.text = text
        self.description = description
        self.closes = closes

    def after(self, text: str) -> "Completion":
        """Return the completion of a word that begins with a text."""
        return Completion(text + self.text, self.description, self.closes)

    def __repr__(self) -> str:
        """Show the word, and its blank."""
        return f"Completion({self.text + ' ' * self.closes!r}, {self.description!r})"


class Option:
    """A row of the table: the names of an option, its values, and its help."""

    __slots__ = ("form", "help", "hidden", "names", "repeats", "values")

    def __init__(self, row: "Sequence[Any]") -> None:
        self.names, self.form, self.values, self.help, self.hidden, self.repeats = row


class Line:
    """The words of a command before the word being typed.

    `given` has the texts of the options by their longest names; `waiting` is the option whose value
    comes next, and `offering` one with an optional file; after `--` every word is an operand.
    """

    def __init__(self, command: str, words: "Iterable[str]") -> None:
        self.command = command
        _, self.operand, option_rows = COMMANDS[command]
        self.options = [Option(row) for row in option_rows]
        self.given: dict[str, str] = {}
        self.operands: list[str] = []
        self.waiting: Option | None = None
        self.offering: Option | None = None
        self.is_closed = False
        for word in words:
            self._read(word)

    def _read(self, word: str) -> None:
        """Read a word as an option, the value of an option, or an operand."""
        offered, self.offering = self.offering, None
        if self.waiting:
            self.given[self.waiting.names[-1]] = word
            self.waiting = None
        elif offered and word.lower().endswith(offered.values):
            self.given[offered.names[-1]] = word
        elif word == "--" and not self.is_closed:
            self.is_closed = True
        elif self.is_closed or not is_option(word):
            self.operands.append(word)
        else:
            name, equals, text = word.partition("=")
            option = self.option(name)
            if option:
                self.given[option.names[-1]] = text
                if option.form == "figure":
                    self.offering = None if equals else option
                elif option.form != "flag" and not equals:
                    self.waiting = option

    def option(self, name: str) -> Option | None:
        return next((option for option in self.options if name in option.names), None)


def is_option(word: str) -> bool:
    """Return whether a word is read as an option, not a lone - or a negative number."""
    return word[:1] == "-" and not is_sentence([word])


def values_of(form: str, values: "Sequence[Any]", incomplete: str) -> list[Completion]:
    """Return every completion of a value of that form."""
    reader = READERS.get(form)
    return reader(values, incomplete) if reader else []


def starting(texts: "Iterable[str]", prefix: str, closes: bool = True) -> list[Completion]:
    """Return the texts with this beginning."""
    return [Completion(text, "", closes) for text in texts if text.startswith(prefix)]


def _quantities(values: "Sequence[Any]", incomplete: str) -> list[Completion]:
    """Return a number with units that fit, also at the end of a list or range; or an example."""
    example, quantities = values
    own = [
        Completion(name, OWN[name][0])
        for name, quantity in _own(CONSTANTS).items()
        if quantity in quantities and name.startswith(incomplete)
    ]
    if not incomplete:
        return [*([Completion(example, "an example")] if example else []), *own]
    likely = split_number(example)[2]
    return [*own, *in_units(quantities, incomplete, likely)]


def in_units(quantities: "Sequence[str]", incomplete: str, likely: str = "") -> list[Completion]:
    """Return a number (the last of a list or a range) with each unit, a likely one first."""
    head, number, typed = split_number(incomplete)
    if not number:
        return []
    units = sorted(units_of(quantities, typed), key=lambda unit: unit.text != likely)
    return [unit.after(head + number) for unit in units]


def units_of(quantities: "Iterable[str]", typed: str) -> list[Completion]:
    """Return the units with this beginning and their names; long names only once typed."""
    quantities = [*quantities]
    own = [(name, quantity) for name, quantity in _own(COMPILED).items() if quantity in quantities]
    known = [unit for name in quantities for unit in UNITS[name]]
    return [
        Completion(text, description)
        for text, description in dict([*known, *own]).items()
        if text.startswith(typed) and (typed or "_" not in text)
    ]


def _own(table: "Mapping[str, Any]") -> dict[str, str]:
    """Return the units or the constants of the user's definitions, with their quantities."""
    if not OWN:
        return {}
    from radcalc.quantities.names import full_name

    return {name: full_name(Unit("", 1, 1, table[name][2], ())) for name in OWN if name in table}


def split_number(text: str) -> tuple[str, str, str]:
    """Split a list or range: the text before the last number, the number, and its unit."""
    start = max(text.rfind(","), text.rfind(":")) + 1
    head, last = text[:start], text[start:]
    for end in range(len(last), 0, -1):
        if last[end - 1] in DIGITS + ".)" or last[:end].endswith(("pi", "\u03c0")):
            return head, last[:end], last[end:].lstrip()
    return head, "", last


Results = dict[str, tuple[bool, tuple[str, ...]]]  # whether of one kind of light; its units


def _results(results: Results, incomplete: str) -> list[Completion]:
    name, colon, unit = incomplete.partition(":")
    fitting = _named(results, name)
    if name in results and (colon or len(fitting) == 1):
        completions = [] if colon else [Completion(name)]
        return completions + [u.after(f"{name}:") for u in units_of(results[name][1], unit)]
    return [Completion(result, "", False) for result in fitting]


def _named(results: Results, typed: str) -> list[str]:
    """Return the results with this beginning; those of one kind of light only once typed."""
    fitting = [name for name in results if name.startswith(typed)]
    return fitting if typed else [name for name in fitting if not results[name][0]]


def _claims(results: Results, incomplete: str) -> list[Completion]:
    name, equals, value = incomplete.partition("=")
    if not equals:
        return [Completion(f"{result}=", "", False) for result in _named(results, name)]
    in_each_unit = in_units(results[name][1], value) if name in results else []
    return [completion.after(f"{name}=") for completion in in_each_unit]


def _spectra(values: "Sequence[str]", incomplete: str) -> list[Completion]:
    """Return completions of a spectrum: names, forms with parameters, and files."""
    kind, colon, parameters = incomplete.partition(":")
    if colon and kind in FORMS:
        head, number, typed = split_number(parameters)
        units = [text for text in FORMS[kind][3] if number and text.startswith(typed)]
        return [Completion(f"{kind}:{head}{number}{text}") for text in units]
    own = {
        name: notes[0]
        for name, notes in OWN.items()
        if name not in COMPILED and name not in CONSTANTS
    }
    named = [
        Completion(name, description)
        for name, description in {**own, **SPECTRA}.items()
        if name.startswith(incomplete)
    ]
    forms = [
        Completion(f"{name}:", f"{description}, {example}", False)
        for name, (_, description, example, _) in FORMS.items()
        if name.startswith(incomplete)
    ]
    return [*named, *forms, *files(ENDINGS["spectrum"], incomplete)]


def _searches(values: "Sequence[str]", incomplete: str) -> list[Completion]:
    named = [Completion(name, row[0]) for name, row in NAMES.items() if name.startswith(incomplete)]
    return named + (units_of(UNITS, incomplete) if incomplete else [])


def _typical_values(values: "Sequence[str]", incomplete: str) -> list[Completion]:
    from radcalc.quantities.lookup import words_of_typical

    return starting(words_of_typical(), incomplete)


def _tasks(values: "Sequence[str]", incomplete: str) -> list[Completion]:
    from radcalc.quantities.lookup import words_of_tasks

    return starting(words_of_tasks(), incomplete)


def _pages(values: "Sequence[str]", incomplete: str) -> list[Completion]:
    from radcalc.calculators.lists import manual_names

    return starting(manual_names(), incomplete)


def _units(quantities: "Sequence[str]", incomplete: str) -> list[Completion]:
    return [*units_of(quantities, incomplete), Completion("1")]


def _distributions(values: "Sequence[str]", incomplete: str) -> list[Completion]:
    return starting(values, incomplete) + files(ENDINGS["distribution"], incomplete)


def _environments(skies: "Sequence[str]", incomplete: str) -> list[Completion]:
    completions = files(ENDINGS["environment"], incomplete)
    if ":" in incomplete:
        return starting([f"sky:{name}" for name in skies], incomplete)
    return starting(["sky:"], incomplete, closes=False) + completions


def _figures(endings: "Sequence[str]", incomplete: str) -> list[Completion]:
    return [
        completion
        for completion in files(endings, incomplete)
        if not completion.closes or completion.text.lower().endswith(tuple(endings))
    ]


def files(endings: "Sequence[str]", incomplete: str) -> list[Completion]:
    """Return the files with these endings, in their order, and folders; every file if none has."""
    folder, name = os.path.split(incomplete)
    typed = incomplete[: len(incomplete) - len(name)]
    fitting: list[Completion] = []
    other_files: list[Completion] = []
    try:
        entries = sorted(
            os.scandir(os.path.expanduser(folder) or "."), key=lambda entry: entry.name
        )
    except (OSError, ValueError):  # an impossible name of a file
        return []
    for entry in entries:
        if not entry.name.startswith(name) or (entry.name[0] == "." and name[:1] != "."):
            continue
        if entry.is_dir():
            fitting.append(Completion(f"{typed}{entry.name}/", "", False))
        elif entry.name.lower().endswith(tuple(endings)):
            fitting.append(Completion(typed + entry.name))
        else:
            other_files.append(Completion(typed + entry.name))
    fitting.sort(key=lambda completion: _place(completion.text.lower(), endings))
    return fitting if any(completion.closes for completion in fitting) else fitting + other_files


def _place(text: str, endings: "Sequence[str]") -> int:
    """Return the place of a file's ending; a folder is last."""
    return next((k for k, ending in enumerate(endings) if text.endswith(ending)), len(endings))


def _weights(names: "Sequence[str]", incomplete: str) -> list[Completion]:
    return starting(names, incomplete) + files(ENDINGS["spectrum"], incomplete)


READERS: "dict[str, Callable[[Any, str], list[Completion]]]" = {
    "choice": starting,
    "quantity": _quantities,
    "interval": _quantities,
    "range of wavelengths": _quantities,
    "result": _results,
    "claim": _claims,
    "spectrum": _spectra,
    "weight": _weights,
    "distribution": _distributions,
    "environment": _environments,
    "file": files,
    "figure": _figures,
    "search": _searches,
    "unit": _units,
    "typical value": _typical_values,
    "task": _tasks,
    "manual": _pages,
}
