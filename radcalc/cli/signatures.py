"""The keywords of the Python functions, made of the commands and of the vocabulary.

`python -m radcalc.cli.signatures` writes, in the modules of `radcalc.api`, the signature of every
function that is a command, and in its docstring the list of its parameters: what is a symbol of
the vocabulary is made anew, what is the function's own is kept as it stands there.
"""

import ast
import re
import textwrap
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

import radcalc
from radcalc.api.spelling import keyword, symbol_name
from radcalc.cli import COMMANDS
from radcalc.cli.command import SymbolOption
from radcalc.cli.compile import command_of
from radcalc.errors import mention, spell
from radcalc.quantities.light import KINDS
from radcalc.quantities.symbols import (
    CHOICE,
    DIRECTION,
    DISTRIBUTION,
    FLAG,
    INTERVAL,
    NUMBERS,
    PAIR,
    POINT,
    QUANTITY,
    SPECIFIC,
    SYMBOLS,
    VECTOR,
    Symbol,
    light_unit,
)
from radcalc.units.table import NUMBER

API = Path(radcalc.__file__).parent / "api"
# The functions whose command has another name, and what of it they do not take.
COMMAND_OF = {
    "explain": "convert",
    "factor": "convert",
    "irradiance_map": "environment",
    "reproject": "environment",
}
LEFT_OUT: dict[str, tuple[str, ...]] = {
    "irradiance_map": ("normal", "toward", "size"),
    "reproject": ("normal", "toward", "size"),
    "environment": ("size",),
    "sky": ("size",),
    "scene": ("grid", "normal"),
}
FORMS = {
    DIRECTION: "Direction",
    DISTRIBUTION: "Distribution",
    INTERVAL: "Interval",
    NUMBERS: "Numbers",
    PAIR: "Pair",
    POINT: "Vector",
    VECTOR: "Vector",
}
WIDTH = 100
PARAMETERS = re.compile(r"(?<=    Parameters\n    ----------\n)(.*?)(?=\n    Returns\n)", re.DOTALL)
ENTRY = re.compile(r"^    (\w[^\n]*?) : [^\n]*\n(?:        [^\n]*\n)*", re.MULTILINE)


class Keyword(NamedTuple):
    """A keyword: its type and default as the signature has them, its unit and what it is."""

    name: str
    type: str
    default: str
    unit: str
    help: str


class Documented:
    """How the docstring of a function names the others of its keywords."""

    @staticmethod
    def option(name: str, value: str) -> str:
        """`half_angle`, in quotes of its own."""
        own = keyword(name)
        return f'``{own}="{value}"``' if value else f"`{own}`"


def rewritten(source: str) -> str:
    """A module with the signatures and the lists of parameters as the commands have them."""
    lines = source.splitlines(keepends=True)
    for node in reversed(ast.parse(source).body):
        if isinstance(node, ast.FunctionDef) and (found := keywords(node.name)):
            docstring = node.body[0]
            assert docstring.end_lineno is not None
            text = "".join(lines[docstring.lineno - 1 : docstring.end_lineno])
            before, listed, behind = PARAMETERS.split(text)
            told = before + _entries(listed, node.args, found) + behind
            lines[node.lineno - 1 : docstring.end_lineno] = [_signature(source, node, found), told]
    return "".join(lines)


def keywords(function: str) -> dict[str, Keyword]:
    """The keywords of a function that are symbols; none where no command is like it."""
    name = COMMAND_OF.get(function, symbol_name(function))
    if name not in COMMANDS:
        return {}
    left_out = LEFT_OUT.get(function, ())
    options = [option for listed in command_of(name).sections.values() for option in listed]
    symbols = [
        SYMBOLS[one.opts[-1].removeprefix("--")] for one in options if isinstance(one, SymbolOption)
    ]
    kinds = [kind for kind in KINDS if any(symbol.kind == kind for symbol in symbols)] or [*KINDS]
    found = [
        _keyword(symbol, name, kinds)
        for symbol in symbols
        if symbol.name not in left_out and symbol.generic not in left_out
    ]
    return {one.name: one for one in found}


def _keyword(symbol: Symbol, command: str, kinds: Sequence[str]) -> Keyword:
    example, text = symbol.shown_in(command)
    said = spell(mention(text), Documented)
    name = keyword(symbol.name)
    unit = ""
    if symbol.form in (QUANTITY, INTERVAL) and NUMBER not in symbol.dimensions:
        unit = symbol.unit
        if symbol.name == symbol.generic:
            unit = ", ".join(light_unit(symbol.name, kind) for kind in kinds)
    if symbol.form == FLAG:
        return Keyword(name, "bool", "False", unit, said)
    kind = FORMS.get(symbol.form, "Text")
    if symbol.form == CHOICE:
        kind = "".join(map(str.capitalize, symbol.name.split("-"))) + " | None"
    elif symbol.form == QUANTITY:
        kind = "Interval" if ":" in example else "Amount" if unit else "Number"
    return Keyword(name, kind, "None", unit, said)


def _signature(source: str, node: ast.FunctionDef, found: dict[str, Keyword]) -> str:
    """A parameter a line."""
    arguments = node.args
    defaults = [None] * (len(arguments.args) - len(arguments.defaults)) + [*arguments.defaults]
    lines = [_parameter(source, *one) for one in zip(arguments.args, defaults, strict=True)]
    lines.append("*")
    lines += [f"{one.name}: {one.type} = {one.default}" for one in found.values()]
    lines += [
        _parameter(source, *one)
        for one in zip(arguments.kwonlyargs, arguments.kw_defaults, strict=True)
        if one[0].arg not in found
    ]
    assert node.returns is not None
    inner = "".join(f"    {line},\n" for line in lines)
    return f"def {node.name}(\n{inner}) -> {ast.unparse(node.returns)}:\n"


def _parameter(source: str, argument: ast.arg, default: ast.expr | None) -> str:
    text = ast.get_source_segment(source, argument) or ""
    return text if default is None else f"{text} = {ast.get_source_segment(source, default)}"


def _entries(text: str, arguments: ast.arguments, found: dict[str, Keyword]) -> str:
    """The entries of the symbols, between the function's own operands and its own keywords."""
    own = {name: entry[0] for entry in ENTRY.finditer(text) for name in entry[1].split(", ")}
    operands = dict.fromkeys(own[one.arg] for one in arguments.args)
    rest = dict.fromkeys(own[one.arg] for one in arguments.kwonlyargs if one.arg not in found)
    return "".join([*operands, *_of_symbols(found), *rest])


def _of_symbols(found: dict[str, Keyword]) -> Iterator[str]:
    """An entry a symbol, in which a light quantity has the names of its kinds too."""
    of: dict[str, list[str]] = {}
    for name in found:
        generic = keyword(SPECIFIC.get(symbol_name(name), (name, ""))[0])
        of.setdefault(generic if generic in found else name, []).append(name)
    for first, names in of.items():
        one = found[first]
        kind = f"{one.type.removesuffix(' | None')}, optional"
        unit = f" [{one.unit}]" if one.unit else ""
        if len(line := f"    {', '.join(names)} : {kind}\n") <= WIDTH:
            yield line + _filled(f"{one.help}{unit}")
        else:
            yield f"    {first} : {kind}\n" + _filled(f"{one.help}{unit}")
            yield f"    {', '.join(names[1:])} : {kind}\n" + _filled("The same of one kind.")


def _filled(text: str) -> str:
    indent = " " * 8
    filled = textwrap.fill(
        text, WIDTH, initial_indent=indent, subsequent_indent=indent, break_on_hyphens=False
    )
    return f"{filled}\n"


def main() -> None:
    """Write the modules anew."""
    for path in sorted(API.glob("*.py")):
        source = path.read_text(encoding="utf-8")
        path.write_text(rewritten(source), encoding="utf-8")


if __name__ == "__main__":
    main()
