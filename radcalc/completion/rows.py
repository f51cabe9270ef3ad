"""The rows of completion, made of the pages of the commands.

`python -m radcalc.completion.rows PATH` writes them as the module `built` of a wheel, since the
import of all pages takes longer than a Tab may.
"""

import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from radcalc.calculators import COMMANDS, page_of
from radcalc.calculators.page import (
    CLAIM,
    ENVIRONMENT,
    FIGURE,
    FILE,
    HELPS,
    OF_RADCALC,
    RESULT,
    Option,
    Page,
)
from radcalc.conversion.plan import target_of
from radcalc.distributions.maps.pictures import WRITERS as MAPS
from radcalc.errors import spell
from radcalc.files import ENDINGS as COLUMNS
from radcalc.plots.figure import FORMATS
from radcalc.quantities import GEOMETRIES, symbols
from radcalc.quantities.names import full_name, offered
from radcalc.quantities.search import GENERIC, names_with_units
from radcalc.spectra import listing
from radcalc.units import NUMBER, OWN, Dimension, Unit
from radcalc.units.compiled import WEIGHTS
from radcalc.units.dimensions import TEMPERATURE
from radcalc.units.table import resolve
from radcalc.units.values import on

ENDINGS = {
    symbols.SPECTRUM: (*COLUMNS, ".spd", ".asc", ".sp", ".xls", ".spdx"),
    symbols.DISTRIBUTION: (".ies", ".ldt", *COLUMNS),
    ENVIRONMENT: tuple(MAPS),
}
Row = tuple[Any, ...]
Results = Mapping[str, tuple[bool, tuple[str, ...]]]  # of one kind of light; quantities measured


def table() -> dict[str, Any]:
    """Return the parts of the table; `table.py` describes them."""
    rows = _Rows()
    commands = {name: (line, *rows.of_page(page_of(name))) for name, line in COMMANDS.items()}
    return {
        "COMMANDS": commands,
        "RADCALC": [rows.of_option(option, {}) for option in OF_RADCALC],
        "UNITS": rows.light_first(),
        "NAMES": {
            name: ("", False) if name in GENERIC else (unit, target_of(name).is_exitance)
            for name, unit in names_with_units()
        },
        "ENDINGS": ENDINGS,
        "SPECTRA": dict(listing.described([s for s in listing.search() if s.name not in OWN])),
    }


class Shown:
    """The spelling of options and commands in a description."""

    @staticmethod
    def option(name: str, value: str) -> str:
        return f"--{name} {value}".rstrip()

    @staticmethod
    def command(*words: str) -> str:
        return " ".join(["radcalc", *words])


class _Rows:
    """The rows of commands, and the units of their quantities."""

    def __init__(self) -> None:
        self.units: dict[str, tuple[tuple[str, str], ...]] = {}
        for name in ("distance", "temperature"):  # the parameters of spectra
            self.quantities(symbols.SYMBOLS[name])

    def light_first(self) -> dict[str, tuple[tuple[str, str], ...]]:
        light = {name for names, _ in GEOMETRIES.values() for name in names}
        return dict(sorted(self.units.items(), key=lambda row: row[0] not in light))

    def of_page(self, page: Page) -> tuple[Row, list[Row]]:
        """Return the form of a command's operands, and its options."""
        results: dict[str, tuple[bool, tuple[str, ...]]] = {}
        if page.calculates:
            for symbol in map(page.symbol, page.result_names):
                is_special = bool(symbol.kind) or symbol.name in page.on_request
                results[symbol.name] = is_special, self.quantities(symbol)
        listed = [row for rows in page.options.values() for row in rows]
        options = [self.of_option(row, results) for row in (*listed, *HELPS)]
        if page.operand is None:
            return (symbols.WORD, ()), options
        if page.operand.form == symbols.QUANTITY:
            symbol = symbols.SYMBOLS[page.operand.name]
            return (symbols.QUANTITY, (symbol.example, self.quantities(symbol))), options
        return (page.operand.form, tuple(page.operand.choices)), options

    def of_option(self, option: Option, results: Results) -> Row:
        """Return spellings, form, values, help, whether hidden, and whether it may be repeated."""
        form, values = self._takes(option, results)
        names = tuple(sorted(option.spellings, key=len))
        is_hidden = option.hidden or len(names[-1]) == 2  # -h is offered only if it is typed
        return names, form, values, spell(option.help, Shown), is_hidden, option.repeats

    def _takes(self, option: Option, results: Results) -> tuple[str, Any]:
        """Return the form of an option's value, and what completes it."""
        form = option.form
        if form == FIGURE:
            return form, tuple(FORMATS)
        if form in (symbols.FLAG, symbols.CHOICE):
            return form, option.choices
        if form == RESULT or (form == CLAIM and results):
            return form, dict(results)
        if option.example.startswith("FILE"):
            return FILE, ENDINGS[ENVIRONMENT]
        if not option.symbol:
            return symbols.WORD, ()
        example = "" if option.example.isupper() else option.example
        if form in (symbols.QUANTITY, symbols.INTERVAL):
            return symbols.QUANTITY, (example, self.quantities(option.symbol))
        if form in (symbols.WAVELENGTHS, symbols.DIRECTION):
            parts = "wavelength" if form == symbols.WAVELENGTHS else "half-angle"
            return symbols.QUANTITY, (example, self.quantities(symbols.SYMBOLS[parts])[:1])
        if form == symbols.UNIT:
            return symbols.UNIT, self.quantities(symbols.SYMBOLS["radiance"])
        if form == symbols.WEIGHT:
            return form, tuple([row[0] for row in WEIGHTS.values()])
        if form in (symbols.DISTRIBUTION, symbols.SPECTRUM):
            return form, symbols.DISTRIBUTIONS if form == symbols.DISTRIBUTION else ()
        return symbols.WORD, (example,) if example else ()

    def quantities(self, symbol: symbols.Symbol) -> tuple[str, ...]:
        return tuple(self.quantity(dimension, symbol) for dimension in symbol.dimensions)

    def quantity(self, dimension: Dimension, symbol: symbols.Symbol) -> str:
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


def module_text() -> str:
    """Return the table as the text of a module."""
    lines = ['"""The table of completion, printed by `radcalc.completion.rows`."""']
    lines += [f"{name} = {part!r}" for name, part in table().items()]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    Path(sys.argv[1]).write_text(module_text(), encoding="utf-8")
