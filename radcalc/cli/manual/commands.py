"""Generated parts about commands: names, help, options and results."""

import re
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from textwrap import dedent

import click

from radcalc.answer import Row, Step
from radcalc.calculators.options import HELPS, OF_LINES, OF_RADCALC, OUTPUT, Option
from radcalc.calculators.page import ALSO, LINES, OUTPUTS, Page
from radcalc.calculators.pages import COMMANDS, page_of
from radcalc.cli.group import command_of, examples_of
from radcalc.cli.heard import hear
from radcalc.cli.help_format import joined, narrowed
from radcalc.cli.manual.mdoc import ROOM, argument, filled, literal, plain, sentences, text
from radcalc.cli.spelling import spelled
from radcalc.errors import RadcalcError
from radcalc.quantities.light import KINDS, RADIANT
from radcalc.quantities.symbols import (
    CHOICE,
    FLAG,
    LINKS,
    SPECIFIC,
    SYMBOLS,
    Symbol,
    light_unit,
    names_of_kinds,
    specific_name,
)

RESULT_WIDTH = 16  # of most of their names
IN_FULL = {  # labels that are short for tables
    "apex angle of the equal cone": "apex angle of the cone with the same solid angle",
    "half angle of the equal cone": "half angle of the cone with the same solid angle",
    "distance from the Planckian": "distance from the Planckian locus",
    "fraction in range": "share of the watts within the range",
    "far": "depths of the far cut",
    "far field irradiance": "far-field irradiance",
    "flux within": "flux within the angle --within",
    "horizontal": "horizontal full angle",
    "incidence": "angle of incidence",
    "intensity toward": "intensity in the direction of the receiver",
    "limit": "limit of the peak irradiance",
    "near": "depths of the near cut",
    "polar": "polar angle",
    "radiance toward": "radiance in the direction --toward",
    "rotate": "angle of rotation",
    "vertical": "vertical full angle",
    **{f"{axis} on a mirror ball": "coordinate on a mirror ball" for axis in "uvw"},
}
VERBATIM, EXAMPLES, DRAWN = "\b", "Examples:", "__"
Sections = Mapping[str, Sequence[Option]]


def name(of: str) -> Iterator[str]:
    """Yield the page's name, and the command's line in the list of commands."""
    yield f".Nm radcalc-{of}"
    yield f".Nd {_lowered(COMMANDS[of])}"


def listed(of: str) -> Iterator[str]:
    """Yield the commands with their lines and pages."""
    yield ".Bl -tag -width Ds -compact"
    for name, line in COMMANDS.items():
        yield f".It Xr radcalc-{name} 1"
        yield text(line)
    yield ".El"


def _lowered(line: str) -> str:
    return text(line[0].lower() + line[1:].rstrip("."))


def help_text(of: str) -> Iterator[str]:
    """Yield the text of --help, without its examples and lists: the page has fuller ones."""
    before = ""
    for paragraph in (command_of(of).help or "").split("\n\n"):
        first, *remaining = paragraph.strip("\n").split("\n")
        if first.strip() == VERBATIM:
            is_led_to = before.endswith(":") and remaining[0].strip() != EXAMPLES
            if is_led_to or any(DRAWN in line for line in remaining):
                lines = dedent("\n".join(remaining)).strip().split("\n")
                yield from literal(
                    part for joined_line in joined(lines) for part in narrowed(joined_line, ROOM)
                )
            continue
        if before and paragraph.strip():
            yield ".Pp"
        before = paragraph.strip()
        yield from sentences(before)


def options(of: str) -> Iterator[str]:
    """Yield the options of a command, or those of every command or every stream."""
    for i, (title, group) in enumerate(sections_of(of).items()):
        yield from [".Pp"] if i else []
        yield from [f"{text(title)}:"] if title else []
        yield ".Bl -tag -width Ds"
        yield from _items(group)
        yield ".El"


def sections_of(of: str) -> Sections:
    """Return the options of a block by the titles of the help; a single list has no title."""
    if of == "every command":
        return {"": [*OUTPUT, *HELPS]}
    if of == "every stream":
        return {"": OF_LINES}
    if of == "radcalc":
        return {"": OF_RADCALC}
    sections = {title: group for title, group in page_of(of).options.items() if title != LINES}
    # a hidden option of the output does not apply to the command
    shown = [option for option in sections[OUTPUTS] if not option.hidden]
    return sections | {OUTPUTS: [*shown, *HELPS]}


def results(of: str) -> Iterator[str]:
    """Yield the results by their names for --get, with letter and unit."""
    page = page_of(of)
    names = [
        name
        for name in page.result_names
        if name not in page.on_request and (of == "photon" or name not in LINKS)
    ]
    kinds, (rows, _) = _kinds(page), _heard(of)
    yield f'.Bl -tag -width "{"x" * RESULT_WIDTH}" -compact'
    for name in names:
        symbol = page.symbol(name)
        if symbol.kind and symbol.generic in names:
            continue
        yield f".It Cm {name}"
        if name in rows and not symbol.generic:
            symbol = symbol._replace(label=rows[name].quantity, letter=rows[name].symbol)
        yield from sentences(_described(symbol, kinds))
    yield ".El"


def laws(of: str) -> Iterator[str]:
    """Yield the laws in the derivations of the help's examples, with their sources."""
    steps = {step.law: step for step in _heard(of)[1] if step.formula}
    formulas = " ".join(step.formula for step in steps.values())
    steradian = " (Omega0 is 1 sr)" if "Omega0" in formulas else ""
    yield from sentences(f"The laws, as --steps prints them{steradian}:")
    yield ".Bl -tag -width Ds -compact"
    for step in steps.values():
        yield f".It {argument(step.law)}"
        reference = f" [{step.reference}]" if step.reference else ""
        # initials of authors do not end a sentence
        yield from (line.replace(". ", r".\& ") for line in filled([step.formula + reference]))
    yield ".El"


@cache
def _heard(of: str) -> tuple[dict[str, Row], list[Step]]:
    """Return rows by name, and steps, of the examples of a help that can run and write no file."""
    rows: dict[str, Row] = {}
    steps: list[Step] = []
    writes = {
        spelling
        for options in page_of(of).options.values()
        for option in options
        if "FILE" in option.example
        for spelling in option.spellings
    }
    for words in examples_of(of):
        if writes.intersection(words) or "--list" in words:
            continue
        try:
            results = hear([*words, "--steps"])
        except (RadcalcError, click.ClickException):
            continue
        rows.update((row.name, row) for result in results for row in result.rows)
        steps += [step for result in results for step in result.steps]
    return rows, steps


def _kinds(page: Page) -> list[str]:
    """Return the kinds of light that a command takes, by the names of its options.

    A name such as irradiance belongs to every kind, and to the radiant one.
    """
    options = {
        spelling.removeprefix("--")
        for rows in page.options.values()
        for row in rows
        for spelling in row.spellings
    }
    kinds = {SPECIFIC[name][1] for name in options if name in SPECIFIC}
    generic = [name for name in options if name in SYMBOLS and SYMBOLS[name].generic == name]
    if any(specific_name(name, RADIANT) == name for name in generic):
        kinds.add(RADIANT)
    return [kind for kind in KINDS if kind in kinds] or [*KINDS]


def _described(symbol: Symbol, kinds: Sequence[str]) -> str:
    if symbol.label == symbol.letter:  # x, y and z
        return f"Coordinate {symbol.label}."
    label = IN_FULL.get(symbol.label, symbol.label)
    label = f"{label[0].upper()}{label[1:]}"
    letter = f" ({symbol.letter})" if symbol.letter and not label.endswith(symbol.letter) else ""
    if symbol.geometry is None or symbol.kind:
        unit = f", in {symbol.unit}" if symbol.unit not in ("", "1") else ""
        return f"{label}{letter}{unit}."
    units = _either([light_unit(symbol.generic, kind) for kind in kinds])
    names = [name for name in names_of_kinds(symbol.name) if SPECIFIC[name][1] in kinds]
    of_kinds = f"; {_all_of(names)} for one kind" if names else ""
    return f"{label}{letter}, in {units}{of_kinds}."


def _all_of(names: Sequence[str]) -> str:
    """Return the subject of a sentence: the names a and b ask."""
    *first, last = names
    return f"the names {', '.join(first)} and {last} ask" if first else f"the name {last} asks"


def _either(words: Sequence[str]) -> str:
    *first, last = words
    return f"{', '.join(first)} or {last}" if first else last


def _items(listed: Sequence[Option]) -> Iterator[str]:
    """Yield an item for each option; hidden ones are other names of the one before."""
    visible = [option for option in listed if not option.hidden]
    starts = [listed.index(option) for option in visible]
    for option, start, end in zip(visible, starts, [*starts[1:], len(listed)], strict=True):
        spellings = [spelling for alias in listed[start:end] for spelling in _spellings(alias)]
        flags = " , ".join(f"Fl {plain(spelling[1:])}" for spelling in spellings)
        yield f".It {flags}{_argument(option)}"
        yield from sentences(_without_names(spelled(option.help)))


def _without_names(text: str) -> str:
    """Return the help of an option without its names for the kinds, which the item lists."""
    description, also, _ = text.partition(ALSO)
    if also and description.endswith("; "):
        return f"{description[:-2]})."
    return f"{description.removesuffix(' (')}." if also else text


def _spellings(option: Option) -> list[str]:
    return sorted(option.spellings, key=len)


def _argument(option: Option) -> str:
    if option.form == FLAG:
        return ""
    if option.form == CHOICE:
        # a lone punctuation mark must not be mdoc's
        choices = [rf"\&{word}" if word in (".", ",") else word for word in option.choices]
        return f" Cm {' | '.join(choices)}"
    metavar = option.example or "VALUE"
    if "[" not in metavar:
        return f" Ar {plain(metavar)}"
    macros = {"[": "Oo", "]": "Oc", "=": "=", ":": ":"}
    parts = [macros.get(part, f"Ar {part}") for part in re.findall(r"[][=:]|[^][=:]+", metavar)]
    words = " " if metavar[:2] != "[=" else " Ns "
    for part, following in zip(parts, [*parts[1:], ""], strict=True):
        words += part
        if following and part != "Oo" and following != "Oc":
            words += " Ns"
        words += " " if following else ""
    return words
