"""`radcalc help [WORD ...]`: the help of a command, or all that has some words in its texts.

The commands, their options and results come from the table of completion; quantities, units,
spectra and typical values from the searches of their own commands.
"""

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import chdir, suppress
from functools import cache
from tempfile import TemporaryDirectory

import click

from radcalc import errors
from radcalc.answer import texts_of
from radcalc.calculators import COMMANDS, SUBJECTS, SUMMARIES, page_of
from radcalc.calculators.page import RESULT
from radcalc.cli.command import define, examples_of
from radcalc.cli.lane import hear
from radcalc.cli.output import Output, refuse_number_options
from radcalc.cli.spelling import pasted
from radcalc.completion import table
from radcalc.errors import RadcalcError, UsageError, call, nearest
from radcalc.quantities import lookup, search
from radcalc.quantities.language import ENGLISH, LANGUAGES, SYNONYMS
from radcalc.quantities.names import QUANTITIES
from radcalc.quantities.search import LONGEST, comparable, matching, names_elsewhere
from radcalc.quantities.symbols import SYMBOLS
from radcalc.render.formats import Records
from radcalc.spectra import FORMS, listing
from radcalc.spectra.sources import MEANT as INSTEAD
from radcalc.spectra.sources import WORDS as TAKEN
from radcalc.spectra.sources import aliases
from radcalc.terminal import JSON
from radcalc.tuples import NamedTuple
from radcalc.units import OWN
from radcalc.units.compiled import UNITS

ALIKE = 0.7  # of similar names
NAMED = 2  # commands with an option that are named
EXACT, BEGINNING, WORDS, ELSEWHERE = range(4)  # where a text is found, best first
SENTENCE_END = re.compile(r"(?<=[\w)])\. ")
# Subjects that radcalc does not cover, with their words, and the nearest command.
NOT_COVERED = {
    "light in absorbing media": ("absorbing absorption extinction complex index", "refraction"),
}
OTHER_NAMES = re.compile(r" \(also --[^)]*\)|; also --[^)]*(?=\))")  # of an option, for one kind


class Finding(NamedTuple):
    """Something that has the words: its kind, its name, what it is, and a call that shows it.

    `names` are all its names; `text` has other words by which it is found.  `is_meant` if the words
    mean it without being its name, as a unit means its quantity.
    """

    kind: str
    name: str
    what: str
    call: tuple[str, ...]
    names: Sequence[str]
    text: str = ""
    is_meant: bool = False

    def place(self, text: str) -> int:
        """Return where a text is found: a whole name, its beginning, words of it, elsewhere."""
        typed = comparable(text)
        names = [comparable(name) for name in self.names]
        if typed in names:
            return EXACT
        if self.is_meant or any(name.startswith(typed) for name in names):
            return BEGINNING
        return WORDS if matching(text, names, str) else ELSEWHERE


def find(text: str) -> list[Finding]:
    """Return everything that has the words of a text, the best first."""
    found: dict[tuple[str, str, str], Finding] = {}
    for searched in SEARCHES:
        with suppress(RadcalcError):  # there is no match
            for one in searched(text):
                found.setdefault((one.kind, one.name, one.what), one)
    return sorted(found.values(), key=lambda finding: finding.place(text))


def near(text: str, count: int) -> list[str]:
    """Return texts that are found, for one that is not: some of its words, or similar names."""
    words = [word.lstrip("-") for word in text.split() if find(word)]
    if words:
        return words[:count]
    names = {comparable(name): name for name in _names()}
    return [names[name] for name in nearest(comparable(text), names, count, ALIKE)]


def _names() -> Iterator[str]:
    yield from COMMANDS
    yield from (name.lstrip("-") for name in _rows())
    yield from _results()
    yield from (name for q in QUANTITIES for code in LANGUAGES for name in q.names(code))
    yield from UNITS
    yield from TAKEN
    yield from lookup.THINGS


def _of_commands(text: str) -> Iterable[Finding]:
    every = [
        Finding(
            "command",
            name,
            line,
            (name, "--help"),
            (name, *_shapes(name)),
            f"{line} {SUBJECTS.get(name, '')}",
        )
        for name, line in COMMANDS.items()
    ]
    return matching(text, every, _all_words)


def _shapes(name: str) -> Sequence[str]:
    """Return the operands that a calculator takes by name: cone, disc, overcast."""
    form, choices = table.COMMANDS[name][1]
    return tuple(choices) if form == "choice" and name in SUMMARIES else ()


def _of_options(text: str) -> Iterable[Finding]:
    """Return the options; those for one kind of light only by their names, or if alone."""
    by_hidden = {is_hidden: [*_options(is_hidden)] for is_hidden in (False, True)}
    found = matching(text, by_hidden[False], _all_words)
    hidden = matching(text, by_hidden[True], _all_words)
    return [*found, *(one for one in hidden if not found or one.place(text) == EXACT)]


def _options(are_hidden: bool) -> Iterator[Finding]:
    """Return the options that some command shows in its help, or the others."""
    for name, rows in _rows().items():
        shown = {command: help_text for command, help_text, hidden in rows if not hidden}
        if are_hidden == bool(shown):
            continue
        helps = shown or {command: help_text for command, help_text, _ in rows}
        first = next(iter(helps))
        where = "every command" if len(helps) == len(COMMANDS) else _listed([*helps])
        what = f"{_sentence(OTHER_NAMES.sub('', helps[first]))} ({where})"
        synonyms = SYNONYMS.get(name.lstrip("-"), "")
        words = " ".join([*helps.values(), synonyms])
        yield Finding("option", name, what, (first, "--help"), (name,), words)


def _of_results(text: str) -> Iterable[Finding]:
    """Return the results of commands that are not options, by any of their names."""
    options = _rows()
    every = [_result(*row) for row in _results().items() if f"--{row[0]}" not in options]
    found = [_with_call(finding) for finding in matching(text, every, _all_words)]
    return [finding for finding in found if finding]


@cache
def _results() -> dict[str, list[str]]:
    """Return the results by their names, each with the calculators that have it."""
    results: dict[str, list[str]] = {}
    for command, (_, _, rows) in table.COMMANDS.items():
        for _, form, values, *_ in rows:
            for name in values if form == RESULT else ():
                results.setdefault(name, []).append(command)
    return results


def _result(name: str, commands: Sequence[str]) -> Finding:
    symbol = SYMBOLS[name]
    letter = symbol.letter.replace("_", "")
    names = (name, symbol.label, letter, *names_elsewhere(symbol.label))
    what = f"{symbol.label} ({_listed(commands)})"
    return Finding("result", name, what, (), names, SYNONYMS.get(name, ""))


def _with_call(finding: Finding) -> Finding | None:
    """Return a result with an example that answers it; None if no example does."""
    for command in _results()[finding.name]:
        for words, names in _examples(command):
            if finding.name in names:
                return finding._replace(call=(*words, "-g", finding.name))
    return None


@cache
def _examples(command: str) -> list[tuple[list[str], Sequence[str]]]:
    """Return the examples of a command, with the results that each has.

    The error about an unknown name has them.  Results on request are not calculated.  In an empty
    folder the files of examples are missing.
    """
    answered: list[tuple[list[str], Sequence[str]]] = []
    with TemporaryDirectory() as folder, chdir(folder):
        for words in examples_of(command):
            pairs = zip(words, ["", *words], strict=False)
            call = [word for word, before in pairs if "-g" not in (word, before)]
            try:
                hear([*call, "-g", "?"])
            except errors.UnknownResult as error:
                answered.append((call, (*error.names, *page_of(command).on_request)))
            except (RadcalcError, click.ClickException):
                continue
    return answered


def _listed(commands: Sequence[str]) -> str:
    """Return the first names of commands, and the number of the others."""
    more = len(commands) - NAMED
    listing = ", ".join(commands[:NAMED])
    return f"{listing} and {more} more" if more > 0 else listing


def _rows() -> dict[str, list[tuple[str, str, bool]]]:
    """Return the rows of the options by their long names: command, help, and whether hidden."""
    options: dict[str, list[tuple[str, str, bool]]] = {}
    for command, (_, _, rows) in table.COMMANDS.items():
        for names, _, _, help_text, hidden, _ in rows:
            options.setdefault(names[-1], []).append((command, help_text, hidden))
    return options


def _of_quantities(text: str) -> Iterator[Finding]:
    for quantity, note in search.search(text):
        name = quantity.name(ENGLISH)
        what = f"{quantity.unit}: {note or _sentence(quantity.definition)}"
        names = [n for code in LANGUAGES for n in quantity.names(code)]
        typed = ("quantities", *name.split())
        yield Finding("quantity", name, what, typed, (*names, quantity.symbol), is_meant=True)


def _of_units(text: str) -> Iterator[Finding]:
    for unit in lookup.search_units(text):
        spellings = unit.symbols.partition(" (")[0].split(", ")
        what = ": ".join(filter(None, [unit.quantity, unit.definition]))
        yield Finding("unit", unit.name, what, ("units", unit.name), (unit.name, *spellings))


def _of_spectra(text: str) -> Iterator[Finding]:
    """Return the spectra that a word means, the forms with parameters, and the named ones."""
    for name in filter(None, INSTEAD.get(comparable(text), "").split(", ")):
        yield _spectrum(name, is_meant=True)
    for kind, (_, description, example, _) in FORMS.items():
        if matching(text, [f"{kind} {description}"], str):
            yield _spectrum(example)
    with suppress(RadcalcError):
        for spectrum in listing.search(text):
            yield _spectrum(spectrum.name)


def _spectrum(name: str, is_meant: bool = False) -> Finding:
    kind, _, parameters = name.partition(":")
    own = OWN[name][0] if name in OWN else ""
    what = FORMS[kind][1] if parameters else own or table.SPECTRA.get(name, "")
    names = (kind,) if parameters else (name, *aliases(name))
    return Finding("spectrum", name, what, ("spectrum", name), names, is_meant=is_meant)


def _of_typical_values(text: str) -> Iterator[Finding]:
    for value in lookup.search_typical(text):
        what = f"{value.value} {value.unit} ({value.quantity})"
        yield Finding("typical value", value.what, what, ("typical", *text.split()), value.names)


def _all_words(finding: Finding) -> str:
    return f"{' '.join(finding.names)} {finding.text}"


def _sentence(text: str) -> str:
    """Return the first sentence of a text, without its full stop."""
    sentence = SENTENCE_END.split(text)[0]
    return sentence if sentence.endswith("...") else sentence.removesuffix(".")


# In the order of the kinds in an answer.
SEARCHES: Sequence[Callable[[str], Iterable[Finding]]] = (
    _of_commands,
    _of_quantities,
    _of_results,
    _of_units,
    _of_spectra,
    _of_typical_values,
    _of_options,
)


MOST, OF_A_KIND = 20, 5  # findings shown, and of one kind unless they have the exact name


KINDS = {
    "command": ("commands", ()),
    "result": ("results", ()),
    "quantity": ("quantities", ("quantities",)),
    "unit": ("units", ("units",)),
    "spectrum": ("spectra", ("spectrum", "--list")),
    "typical value": ("typical values", ("typical",)),
    "option": ("options", ()),
}


@define("help", page_of("help"))
def command(words: tuple[str, ...], output: Output) -> None:
    """Show the help of a command, or search for words.

    \b
    Examples:
      radcalc help convert             the same as radcalc convert --help
      radcalc help beam angle          options, quantities ... with these words
      radcalc help lux                 a unit, its quantity, typical values
      radcalc help sunlight            spectra and typical values

    The search covers commands, options, results, quantities, units, spectra and typical values.
    Exact names come first, then names that begin so, then words of names and of texts.
    """
    refuse_number_options(output, "help")
    text = " ".join(words)
    if not text.strip():
        raise UsageError("a word is missing", [call("help", "lux"), call("--help")])
    if len(text) > LONGEST:
        raise UsageError(f"nothing has the words '{errors.quote(text)}'", call("help", "--help"))
    if len(words) > 1 and all(word in COMMANDS for word in words):
        raise UsageError("help takes one command", [call(word, "--help") for word in words])
    found = find(text)
    for subject, (known, nearest_command) in NOT_COVERED.items():
        if matching(text, [known], str) and not any(one.place(text) < ELSEWHERE for one in found):
            raise UsageError(f"{subject} is not covered", call(nearest_command, "--help"))
    if not found:
        similar = [call("help", *name.split()) for name in near(text, 3)]
        problem = f"nothing has the words '{errors.quote(text)}'"
        raise UsageError(problem, similar or [call("--help"), call("examples")])
    shown = _best(found, text)
    rows = [
        {"kind": one.kind, "name": one.name, "what": one.what, "command": pasted(one.call)}
        for one in shown
    ]
    titles = ("kind", "name", "what it is", "command to type")
    table = [dict(zip(titles, row.values(), strict=True)) for row in rows]
    notes = [*_more(text, found, shown), *_tasks(text)]
    inputs, unfolded = texts_of({"search": text}), ("command to type",)
    output.records(Records(rows, notes, table, inputs=inputs, unfolded=unfolded), (JSON,))


def _best(found: Sequence[Finding], text: str) -> list[Finding]:
    """Return the findings to show."""
    shown: list[Finding] = []
    for finding in found:
        alike = sum(other.kind == finding.kind for other in shown)
        if len(shown) < MOST and (alike < OF_A_KIND or finding.place(text) == EXACT):
            shown.append(finding)
    return shown


def _more(text: str, found: Sequence[Finding], shown: Sequence[Finding]) -> Iterator[str]:
    """Yield the numbers of the findings that are not shown, with the calls that list them."""
    for kind, (plural, lists_them) in KINDS.items():
        more = sum(one.kind == kind for one in found) - sum(one.kind == kind for one in shown)
        if more:
            way = f": {pasted((*lists_them, *text.split()))}" if lists_them else ""
            yield f"{more} more {kind if more == 1 else plural}{way}"


def _tasks(text: str) -> Iterator[str]:
    with suppress(UsageError):  # no task has the words
        count = len(lookup.search_tasks(text))
        mention = "1 example mentions" if count == 1 else f"{count} examples mention"
        yield f"{mention} it: {pasted(('examples', *text.split()))}"
