"""Compiler of the table of completion from the commands.

`python -m radcalc.cli.compile PATH` writes the module `completion/built.py` of a wheel, so that
completion does not load the commands or Click.
"""

import re
import sys
from collections.abc import Iterator, Mapping
from contextlib import chdir
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import click

from radcalc.calculators.page import ENVIRONMENT, FILE
from radcalc.cli import options
from radcalc.cli.command import GET, PLOT, SectionedCommand, SymbolOption
from radcalc.cli.group import commands, context, protect_negatives
from radcalc.cli.help import HELPS
from radcalc.cli.names import COMMANDS
from radcalc.completion import sources, table
from radcalc.conversion.plan import target_of
from radcalc.distributions.maps.pictures import WRITERS as MAPS
from radcalc.errors import RadcalcError, UnknownResult
from radcalc.files.text import ENDINGS as COLUMNS
from radcalc.plots.figure import FORMATS
from radcalc.quantities.light import GEOMETRIES
from radcalc.quantities.symbols import (
    CHOICE,
    DIRECTION,
    DISTRIBUTION,
    DISTRIBUTIONS,
    FLAG,
    INTERVAL,
    QUANTITY,
    SPECTRUM,
    SYMBOLS,
    UNIT,
    WAVELENGTHS,
    WORD,
    Symbol,
    names_of_kinds,
)
from radcalc.quantities.targets import GENERIC, names_with_units
from radcalc.quantities.units import full_name, offered
from radcalc.spectra import listing
from radcalc.units.dimensions import TEMPERATURE
from radcalc.units.scales import on
from radcalc.units.table import resolve
from radcalc.units.unit import NUMBER, Dimension, Unit

ENDINGS = {
    SPECTRUM: (*COLUMNS, ".spd", ".asc", ".sp", ".xls", ".spdx"),
    DISTRIBUTION: (".ies", ".ldt", *COLUMNS),
    ENVIRONMENT: tuple(MAPS),
}
HEAD = '"""The table of completion, printed by `radcalc.cli.compile` from the commands."""\n'
EXAMPLE = re.compile(r"^ +radcalc (.*)$", re.MULTILINE)
RESULT, CLAIM = "result", "claim"
FIGURE = "figure"  # an option with an optional file
Row = tuple[Any, ...]
Results = Mapping[str, tuple[bool, tuple[str, ...]]]  # of one kind of light; quantities measured


class Compiler:
    """The rows of the table, and the units of their quantities."""

    def __init__(self) -> None:
        self.units: dict[str, tuple[tuple[str, str], ...]] = {}
        self.results: dict[str, dict[str, tuple[str, ...]]] = {}
        for name in ("distance", "temperature"):  # the parameters of spectra
            self.quantities(SYMBOLS[name])

    def text(self) -> str:
        commands: dict[str, Row] = {}
        for name, line in COMMANDS.items():
            command = command_of(name)
            commands[name] = line, self._operands(command), self._options(command)
        parts = {
            "COMMANDS": commands,
            "RADCALC": [self._option(option, {}) for option in main_options()],
            "UNITS": dict(self._light_first()),
            "NAMES": {
                name: ("", False) if name in GENERIC else (unit, target_of(name).is_exitance)
                for name, unit in names_with_units()
            },
            "ENDINGS": ENDINGS,
            "SPECTRA": dict(listing.described(listing.search())),
            "RESULTS": self.results,
        }
        return HEAD + "".join(f"{name} = {part!r}\n" for name, part in parts.items())

    def _light_first(self) -> list[tuple[str, tuple[tuple[str, str], ...]]]:
        light = {name for names, _ in GEOMETRIES.values() for name in names}
        return sorted(self.units.items(), key=lambda row: row[0] not in light)

    def _operands(self, command: SectionedCommand) -> Row:
        operand = command.page.operand
        if operand is None:
            return WORD, ()
        if operand.form == QUANTITY:
            symbol = SYMBOLS[operand.name]
            return QUANTITY, (symbol.example, self.quantities(symbol))
        return operand.form, tuple(operand.choices)

    def _options(self, command: SectionedCommand) -> list[Row]:
        results = {}
        if GET in command.params:
            calls, waiting = results_of(command), command.page.on_request
            example = next(iter(examples_of(command)), [])
            calls |= dict.fromkeys(waiting, example)
            results = {
                symbol.name: (bool(symbol.kind) or symbol.name in waiting, self.quantities(symbol))
                for symbol in map(command.page.symbol, calls)
            }
            for name, words in calls.items():
                if words:
                    self.results.setdefault(name, {})[words[0]] = (*words, "-g", name)
        listed = [option for group in command.sections.values() for option in group]
        return [self._option(option, results) for option in (*listed, *HELPS)]

    def _option(self, option: click.Option, results: Results) -> Row:
        form, values = self._takes(option, results)
        names = tuple(sorted(option.opts, key=len))
        is_hidden = option.hidden or names[-1][:2] != "--"  # -h is offered only if it is typed
        return names, form, values, option.help or "", is_hidden, option.multiple

    def _takes(self, option: click.Option, results: Results) -> tuple[str, Any]:
        example = option.metavar or ""
        if option.is_flag:
            return FLAG, ()
        if option is PLOT:
            return FIGURE, tuple(FORMATS)
        if isinstance(option.type, click.Choice):
            return CHOICE, tuple(option.type.choices)
        if option is GET:
            return RESULT, dict(results)
        if option in options.OF_CHECKS:
            return (CLAIM, dict(results)) if results and "--check" in option.opts else (WORD, ())
        if example.startswith("FILE"):
            return FILE, ENDINGS[ENVIRONMENT]
        if not isinstance(option, SymbolOption):
            return WORD, ()
        symbol = SYMBOLS[option.opts[-1].removeprefix("--")]
        offered_example = example if example and not example.isupper() else ""
        if symbol.form in (QUANTITY, INTERVAL):
            return QUANTITY, (offered_example, self.quantities(symbol))
        if symbol.form in (WAVELENGTHS, DIRECTION):
            parts = "wavelength" if symbol.form == WAVELENGTHS else "half-angle"
            return QUANTITY, (offered_example, self.quantities(SYMBOLS[parts])[:1])
        if symbol.form == UNIT:
            return UNIT, self.quantities(SYMBOLS["radiance"])
        if symbol.form == DISTRIBUTION:
            return DISTRIBUTION, DISTRIBUTIONS
        if symbol.form == SPECTRUM:
            return SPECTRUM, ()
        return WORD, (offered_example,) if offered_example else ()

    def quantities(self, symbol: Symbol) -> tuple[str, ...]:
        return tuple(self.quantity(dimension, symbol) for dimension in symbol.dimensions)

    def quantity(self, dimension: Dimension, symbol: Symbol) -> str:
        """Return the key of the units of a dimension; the displayed unit comes first."""
        name = full_name(Unit("", 1, 1, dimension, ()))
        if name in self.units:
            return name
        usual = resolve(symbol.unit or "1")
        usual_texts = (
            [symbol.unit.replace(" ", ".")] if usual.dimension == dimension and usual.atoms else []
        )
        texts = dict.fromkeys([*usual_texts, *offered(Unit("", 1, 1, dimension, ()))])
        called = {text: full_name(resolve(text)) for text in texts}
        if dimension not in (NUMBER, TEMPERATURE):  # few scales apply to these
            called.update({scale.name: scale.meaning for scale in on(dimension)})
        self.units[name] = tuple(called.items())
        return name


def command_of(name: str) -> SectionedCommand:
    """Return a command by its name."""
    command = commands.get_command(context(), name)
    if not isinstance(command, SectionedCommand):
        raise KeyError(f"there is no command {name!r}")
    return command


def main_options() -> list[click.Option]:
    """Return the options of `radcalc` itself."""
    return [
        parameter
        for parameter in commands.get_params(context())
        if isinstance(parameter, click.Option)
    ]


def results_of(command: SectionedCommand) -> dict[str, list[str]]:
    """Return the results of a calculator, each with an example that has it, by names.

    The error about an unknown name has those of an example.  Inputs have no example here, and
    neither have names for one kind of light.  Results on request are not calculated: the packages
    that they need are missing where a wheel is built.
    """
    calls: dict[str, list[str]] = {
        option.opts[-1].removeprefix("--"): []
        for group in command.sections.values()
        for option in group
        if isinstance(option, SymbolOption) and not option.hidden
    }
    for words in examples_of(command):
        try:
            call = _without_results(words)
            with commands.make_context("radcalc", [*call, "-g", "?"]) as call_context:
                commands.invoke(call_context)
        except UnknownResult as error:
            for name in error.names:
                calls.setdefault(name, call)
        except (RadcalcError, click.ClickException):
            continue  # the file is missing here
    for name in [name for generic in calls for name in names_of_kinds(generic)]:
        calls.setdefault(name, [])
    return {
        name: call for name, call in calls.items() if name in SYMBOLS and SYMBOLS[name].dimensions
    }


def _without_results(words: list[str]) -> list[str]:
    """Return the words of a call without the results that it asks for."""
    return [
        word
        for word, before in zip(words, ["", *words], strict=False)
        if "-g" not in (word, before)
    ]


def examples_of(command: SectionedCommand) -> Iterator[list[str]]:
    """Yield the words of the examples of a command in its help."""
    for line in EXAMPLE.findall(command.help or ""):
        words = line.partition("  ")[0].split()
        if words[0] == command.name:
            yield protect_negatives(words)


def made() -> str:
    """Return the text of the table, whatever files are in the working directory.

    Examples in the help name files, which are thus always missing.
    """
    with TemporaryDirectory() as folder, chdir(folder):
        return Compiler().text()


def fill_table() -> None:
    """Make the table of completion, and keep it until the sources change."""
    text = made()
    sources.keep(text)
    table.fill(sources.values_of(text))


def main() -> None:
    """Write the table into the file named on the command line."""
    Path(sys.argv[1]).write_text(made(), encoding="utf-8")


if __name__ == "__main__":
    main()
