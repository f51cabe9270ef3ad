r"""The generated parts of the pages in man/: lists and help, from the commands and tables.

`python docs/manual.py` rewrites the text between these marks (WHAT: see `WRITERS`):

    .\" generated: WHAT of NAME
    .\" end of generated
"""

import re
import textwrap
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cache
from itertools import groupby
from pathlib import Path
from textwrap import dedent

import click

from radcalc.answer import Row, Step
from radcalc.calculators import COMMANDS, SUMMARIES, page_of
from radcalc.calculators.lists import manual_pages
from radcalc.calculators.page import (
    ALSO,
    HELPS,
    LINES,
    OF_LINES,
    OF_RADCALC,
    OUTPUT,
    OUTPUTS,
    Option,
    Page,
)
from radcalc.cli.command import command_of, examples_of
from radcalc.cli.help import joined, narrowed
from radcalc.cli.lane import hear
from radcalc.cli.spelling import spelled
from radcalc.conversion.bridge import WANTED
from radcalc.conversion.plan import plan, target_of
from radcalc.errors import MissingCondition, RadcalcError
from radcalc.quantities import GEOMETRIES, KINDS, RADIANT, read
from radcalc.quantities import lookup as source
from radcalc.quantities.language import ENGLISH
from radcalc.quantities.lookup import CALL, Entry, entry
from radcalc.quantities.lookup import scales as scale_entries
from radcalc.quantities.names import MISNOMERS, QUANTITIES, Quantity
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
from radcalc.sentences.frames import FRAMES, taken_by
from radcalc.sentences.phrases import (
    COMMAND,
    FILTER,
    PERIOD,
    PHRASES,
    SHAPE,
    TARGET,
    UNKNOWN,
    WORDS,
    Phrase,
)
from radcalc.terminal import HANGING, fold
from radcalc.units import Unit
from radcalc.units.compiled import PREFIX_NAMES, PREFIX_SYMBOLS, UNITS
from radcalc.units.scale_table import SCALES

# -----------------------------------------------------------------------------------------------
# Text in mdoc(7): escapes, filled lines, displays, and marked-up options.

MARKED_FLAG = re.compile(r"([('\"]?)(--[a-z][\w=-]*|-[a-z](?![\w-]))(\W*)")
BETWEEN_SENTENCES = re.compile(r"(?<=[\w)\"'][.?!]) +(?=[A-Z\"])")
WIDTH = 80
ROOM = 73  # of a display, in a page of that width


def plain(text: str) -> str:
    """Escape a text so that its characters mean themselves."""
    text = text.replace("\\", r"\e").replace("^", r"\(ha").replace("~", r"\(ti")
    return "".join(c if c.isascii() else f"\\[u{ord(c):04X}]" for c in text)


def text(words: str) -> str:
    """Escape running text: hyphens stay hyphens, and no word is taken as a request."""
    words = re.sub(r"(?<![A-Za-z])-|(?<=\de)-(?=\d)", r"\\-", plain(words))
    return rf"\&{words}" if words[:1] in (".", "'") else words


def filled(words: Iterable[str]) -> list[str]:
    """Return lines of running text."""
    lines = textwrap.wrap(
        " ".join(map(text, words)), WIDTH, break_long_words=False, break_on_hyphens=False
    )
    lines = [rf"\&{line}" if line[:1] in (".", "'") else line for line in lines]
    # an abbreviation at the end of a line does not end a sentence
    return [*(rf"{line}\&" if line.endswith(".") else line for line in lines[:-1]), *lines[-1:]]


def sentences(words: str) -> Iterator[str]:
    """Return a text with one sentence a line, and its options marked up."""
    for sentence in BETWEEN_SENTENCES.split(" ".join(words.split())):
        waiting: list[str] = []
        for word in sentence.split():
            flag = MARKED_FLAG.fullmatch(word)
            if not flag:
                waiting.append(word)
                continue
            yield from filled(waiting)
            waiting = []
            yield " ".join([".Fl", *flag[1], plain(flag[2][1:]), *flag[3]])
        yield from filled(waiting)


def argument(words: str) -> str:
    """Escape the arguments of a macro, so that none is taken as another macro."""
    return re.sub(r"(?<![\w\\])(?=[A-Z][a-z](?!\w))", r"\\&", plain(words))


def literal(lines: Iterable[str]) -> Iterator[str]:
    """Return a display of unchanged lines."""
    yield ".Bd -literal -offset 2n"
    for line in lines:
        kept = plain(line).replace("-", r"\-").replace("'", r"\(aq").replace("`", r"\(ga")
        yield rf"\&{kept}" if kept.startswith(".") else kept
    yield ".Ed"


# -----------------------------------------------------------------------------------------------
# Generated parts about commands: names, help, options and results.

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


# -----------------------------------------------------------------------------------------------
# Generated parts of radcalc-sentences(7): the phrases, and the words that add nothing.

LONG = 60  # characters of alternatives, which are then on several lines
MISSING = "VALUE"  # of a phrase without an amount
REFUSED = "(refused)"
ASKED = "(the refusal asks for the value)"


def phrases(_: str) -> Iterator[str]:
    """Yield the phrases by their groups, under what they fill."""
    for title, group in groupby(PHRASES, lambda phrase: phrase.group):
        yield f".Ss {text(title.capitalize())}"
        yield ".Bl -tag -width Ds -compact"
        by_place: dict[str, list[Phrase]] = {}
        for phrase in group:
            by_place.setdefault(_place(phrase), []).append(phrase)
        for place, listed in by_place.items():
            yield f".It {place}"
            marks = [" ;"] * (len(listed) - 1) + [""]
            for phrase, mark in zip(listed, marks, strict=True):
                yield f".{_pattern(phrase.pattern)}{mark}"
            if not listed[0].form and place != REFUSED and not _is_flag(listed[0]):
                yield ASKED
        yield ".El"


def fillers(_: str) -> Iterator[str]:
    """Yield the words that add nothing to a sentence."""
    yield from filled(
        [", ".join(sorted({word for word, _, role, _ in WORDS if role == "nothing"})) + "."]
    )


def frames(_: str) -> Iterator[str]:
    """Yield the commands that sentences call, in the order in which they are tried."""
    *first, last = dict.fromkeys(frame.command for frame in FRAMES)
    yield f".Cm {' , '.join(first)}"
    yield "and"
    yield f".Cm {last} ."


def _is_flag(phrase: Phrase) -> bool:
    return phrase.fills[0] == SHAPE or SYMBOLS[phrase.fills[0]].form == FLAG


def _place(phrase: Phrase) -> str:
    """Return what a phrase fills: options of its readings, a result, or an operand."""
    amounts = [part[1:-1].upper() for part in phrase.pattern.split() if part[0] == "{"]
    value = plain(phrase.form.format(*amounts))
    if phrase.fills == (SHAPE,):
        return f"Cm solid-angle {value}"
    if phrase.fills == (COMMAND,):
        return f"Cm {value}"
    if phrase.fills == (PERIOD,):
        return f"Cm dose Fl -by Cm {value}"
    if phrase.fills == (FILTER,):
        return f"Li * ({value})"
    if phrase.fills == (UNKNOWN,):
        return REFUSED
    if phrase.fills == (TARGET,):
        return f"Fl g Cm {value}"
    options = " No or ".join(map(_option, phrase.fills))
    if not phrase.form:
        return options if _is_flag(phrase) else f"{options} Ar {MISSING}"
    return options if phrase.form == "{}" else f"{options} Cm {value}"


def _option(name: str) -> str:
    """Return the option of a symbol, or the label of one that no command takes."""
    is_taken = any(name in taken_by(page_of(command)) for command in SUMMARIES)
    return f"Fl -{name}" if is_taken else f"Em {SYMBOLS[name].label}"


def _pattern(pattern: str) -> str:
    """Return a pattern in mdoc: words, words that may be missing, and amounts."""
    parts = []
    for part in pattern.split():
        words = plain("|".join(dict.fromkeys(part.rstrip("?").split("|"))))
        words = words.replace("|", " | ") if len(words) > LONG else words
        if part[0] == "{":
            parts.append(f"Ar {part[1:-1].upper()}")
        else:
            parts.append(f"Oo Cm {words} Oc" if part[-1] == "?" else f"Cm {words}")
    return " ".join(parts)


# -----------------------------------------------------------------------------------------------
# Generated parts about the tables: quantities, conditions, units, prefixes and scales.

EXITANCE = "M"  # of its symbol
LANGUAGE_NAMES = {"cs": "Czech", "ru": "Russian"}
LIGHT = [names[i] for i in range(len(KINDS)) for names, _ in GEOMETRIES.values()]


def quantities(_: str) -> Iterator[str]:
    """Yield each quantity: name, symbol, unit, definition, other names, and conversions."""
    yield ".Bl -tag -width Ds"
    for quantity in QUANTITIES:
        symbol, unit = argument(quantity.symbol), argument(quantity.unit)
        yield f".It Em {quantity.name(ENGLISH)} No ({symbol}, {unit})"
        yield from sentences(quantity.definition)
        yield from sentences(_names(quantity))
        if remarks := [*_misnomers(quantity), *_leads(quantity)]:
            yield ".Bl -dash -compact"
            for remark in remarks:
                yield ".It"
                yield from sentences(remark)
            yield ".El"
    yield ".El"


def _names(quantity: Quantity) -> str:
    names = [f"also {name}" for name in quantity.names(ENGLISH)[1:]]
    names += [
        f"{LANGUAGE_NAMES[code]} {', '.join(quantity.names(code))}"
        for code in LANGUAGE_NAMES
        if quantity.names(code)
    ]
    return _sentence("; ".join(names))


def _sentence(words: str) -> str:
    return f"{words[:1].upper()}{words[1:]}." if words else ""


def _misnomers(quantity: Quantity) -> Iterator[str]:
    for terms, meant, why in MISNOMERS:
        if meant == quantity.symbol:
            yield f"{', '.join(terms)}: {why}"


def _leads(quantity: Quantity) -> Iterator[str]:
    """Return the quantities that one condition leads to, by the condition."""
    by_condition: dict[str, list[str]] = {}
    for other in QUANTITIES:
        try:
            plan(_unit(quantity), _unit(other), [])
        except MissingCondition as error:
            if len(error.missing) == 1 and _is_one_step(quantity, other):
                by_condition.setdefault(next(iter(error.missing)), []).append(other.name(ENGLISH))
        except RadcalcError:
            continue  # no condition leads there, or the quantity lacks a unit
    for what, names in by_condition.items():
        yield f"with {what}: {', '.join(names)}"


def _is_one_step(quantity: Quantity, other: Quantity) -> bool:
    """Return whether they differ by one step, even if W/m2 is both incident and emitted."""
    source, target = _unit(quantity), _unit(other)
    start, end = read(source), read(target)
    if start is None or end is None:
        return True
    if EXITANCE in (quantity.symbol[0], other.symbol[0]):
        if start.axis or end.axis:
            return False  # densities are not marked as leaving a surface
        if start.geometry != end.geometry:
            return start.kind == end.kind and start.time == end.time
        return start.kind == end.kind or source.is_exitance == target.is_exitance
    return start.kind == end.kind or start.geometry == end.geometry


def _unit(quantity: Quantity) -> Unit:
    """Return the usual unit; for an exitance, one of light that leaves a surface."""
    return target_of(quantity.name(ENGLISH))


def conditions(_: str) -> Iterator[str]:
    """Yield the missing conditions as worded in errors, and the options that supply them."""
    yield ".Bl -tag -width Ds -compact"
    for wanted in WANTED.values():
        yield f".It {wanted.phrase}"
        yield from sentences(spelled(wanted.hint) + ".")
    yield ".El"


def units(_: str) -> Iterator[str]:
    """Yield every named unit by quantity, units of light first."""
    measured: dict[str, list[Entry]] = {}
    for name in UNITS:
        listed = entry(name)
        measured.setdefault(listed.quantity or "other", []).append(listed)
    light = [name for name in LIGHT if name in measured]
    for quantity in dict.fromkeys([*light, *measured]):
        yield f".Ss {text(quantity[0].upper() + quantity[1:])}"
        yield from _entries(measured[quantity])


def scales(_: str) -> Iterator[str]:
    """Yield every scale, with its function."""
    yield from _entries(scale_entries(SCALES))


def _entries(entries: Sequence[Entry]) -> Iterator[str]:
    yield ".Bl -tag -width Ds -compact"
    for unit in entries:
        comma = "" if unit.symbols.startswith("(") else ","
        symbols = f" No {comma} {argument(unit.symbols)}" if unit.symbols else ""
        yield f".It Li {argument(unit.name)}{symbols}".replace(" No ,", " ,")
        source = f" [{unit.source}]" if unit.source else ""
        yield from sentences(f"{unit.definition}{source}")
        if unit.note:
            yield from sentences(f"(note: {unit.note})")
    yield ".El"


def prefixes(_: str) -> Iterator[str]:
    """Yield the prefixes with their symbols and powers of ten."""
    yield ".Bl -column quetta Micro 10^-30 -compact"
    for name, power in PREFIX_NAMES.items():
        symbols = ", ".join(symbol for symbol, of in PREFIX_SYMBOLS.items() if of == name)
        yield f".It {name} Ta {plain(symbols)} Ta 10\\(ha{text(str(power))}"
    yield ".El"


# -----------------------------------------------------------------------------------------------
# Generated part of radcalc-examples(7): the tasks.


def tasks(_: str) -> Iterator[str]:
    """Yield each task with its calls and how to read them, by trade."""
    for trade, group in groupby(source.tasks(), lambda task: task.trade):
        yield f".Sh {text(trade.upper())}"
        for task in group:
            yield f".Ss {argument(task.title)}"
            yield from sentences(task.question)
            yield from literal(_lines(task))
            yield ".Pp"
            yield from sentences(task.reading)


def _lines(task: source.Task) -> Iterator[str]:
    for call in task.calls:
        yield from narrowed(f"{CALL}{call.command}", ROOM)
        for printed in call.output:
            yield from fold(printed, ROOM, HANGING)


MARKED = re.compile(
    r'^(\.\\" generated: (\w+)(?: of (.+))?\n)(?:.*\n)*?(\.\\" end of generated\n)', re.MULTILINE
)
WRITERS: Mapping[str, Callable[[str], Iterable[str]]] = {
    "name": name,
    "help": help_text,
    "options": options,
    "results": results,
    "laws": laws,
    "list": listed,
    "tasks": tasks,
    "phrases": phrases,
    "fillers": fillers,
    "frames": frames,
    "quantities": quantities,
    "conditions": conditions,
    "units": units,
    "prefixes": prefixes,
    "scales": scales,
}


def rewritten(page: str) -> str:
    """Return the page with its generated parts made anew."""

    def write(match: re.Match[str]) -> str:
        lines = WRITERS[match[2]](match[3] or "")
        return match[1] + "".join(f"{line}\n" for line in lines) + match[4]

    return MARKED.sub(write, page)


if __name__ == "__main__":
    for page in manual_pages(Path(__file__).parents[1] / "man"):
        page.write_text(rewritten(page.read_text(encoding="utf-8")), encoding="utf-8")
