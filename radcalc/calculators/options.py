"""Options that are not symbols: rows that Click, completion, the help and the manual read."""

from radcalc.errors import mention
from radcalc.quantities.symbols import CHOICE, FLAG, WORD
from radcalc.terminal import AUTO, COLORING, FORMATS, INVALID
from radcalc.tuples import NamedTuple

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from typing import Any

PERIODS = PER_DAY, PER_HOUR = "day", "hour"  # of a log
# Forms of values, in addition to those of symbols: results, an answer to check, files.
RESULT, CLAIM, FIGURE, FILE, WHOLE = "result", "claim", "figure", "file", "whole number"


class Option(NamedTuple):
    """An option: its spellings, the example of its value, and its help.

    `form` is the kind of its value; `least` and `most` are the limits of a whole number.  `name` is
    the parameter that a command gets, if it is not the longest spelling.  A hidden option is not in
    the help: it is another name of the option before it, or another command documents it.
    """

    spellings: tuple[str, ...]
    example: str
    help: str
    form: str = WORD
    choices: tuple[str, ...] = ()
    default: "Any" = None
    repeats: bool = False
    least: "int | None" = None
    most: "int | None" = None
    name: str = ""
    hidden: bool = False
    symbol: "Any" = None

    @property
    def parameter(self) -> str:
        return self.name or self.spellings[-1].lstrip("-").replace("-", "_")


def _option(names: str, example: str, help_text: str, *form: "Any", **more: "Any") -> Option:
    """Return a row; `names` are without dashes, and the text mentions options as {name}."""
    spellings = tuple([f"{'-' * min(len(name), 2)}{name}" for name in names.split()])
    return Option(spellings, example, mention(help_text), *form, **more)


def flag(names: str, help_text: str, **more: "Any") -> Option:
    """Return the row of an option without a value."""
    return _option(names, "", help_text, FLAG, default=False, **more)


def choice(names: str, choices: "Any", help_text: str, **more: "Any") -> Option:
    """Return the row of an option with a few possible values."""
    return _option(names, "", help_text, CHOICE, tuple(choices), **more)


def text(names: str, example: str, help_text: str, **more: "Any") -> Option:
    """Return the row of an option with a text as its value."""
    return _option(names, example, help_text, **more)


GET = text(
    "g get",
    "NAME[:UNIT]",
    "Print only this result, as a bare number or in the format of {format}.  "
    "Without UNIT, the unit is that of the full answer.  Several: flux,illuminance:klx.",
    form=RESULT,
    repeats=True,
    name="wanted",
)
PLOT = text(
    "plot", "[FILE]", "Draw a picture below the answer, or in FILE (.svg, .png).", form=FIGURE
)
STEPS = flag("steps", "Show the derivation.")
COLOR = choice(
    "color",
    COLORING,
    "Colour on a terminal (NO_COLOR and FORCE_COLOR are respected).",
    default=AUTO,
)
OUTPUT = (
    flag("n number", "Print bare numbers only."),
    choice(
        "format",
        FORMATS,
        "Format of the output (default: a table on a terminal, else plain).",
        name="format_",
    ),
    flag("json", "Same as {format=json}.", name="json_"),
    text(
        "precision",
        "N",
        "Significant digits, from 1 to 17 (default: 6 in tables, 12 in plain text, all in JSON).",
        form=WHOLE,
        least=1,
        most=17,
    ),
    COLOR,
    flag("auto", "Choose SI prefixes that fit: 2.1 mlx, not 0.0021 lx."),
    flag("q quiet", "Omit notes and assumptions."),
    text(
        "definitions",
        "FILE",
        "Units, constants and spectra of your own (default: ~/.config/radcalc/definitions.txt).",
        form=FILE,
    ),
)
OF_ANSWERS = (*OUTPUT, STEPS)
# Lists have no numbers to print; the hidden options give better errors.
NUMERIC = ("number", "precision", "auto")
OF_LISTS = tuple([row._replace(hidden=row.parameter in NUMERIC) for row in OUTPUT])
DEFAULTS: "dict[str, Any]" = {row.parameter: row.default for row in OUTPUT}

TOLERANCE = text(
    "tolerance", "1%", "Allowed deviation: 1% (default), 0.5lx, or 3sf (3 significant digits)."
)
# Homework: a check of an answer.
CHECKS = (
    text(
        "check",
        "[NAME=]VALUE[UNIT]",
        "Compare VALUE, your own answer, with the result.  If it is wrong, radcalc names the "
        "likely mistake and exits with status 1.",
        form=CLAIM,
    ),
    TOLERANCE,
)
# Lines of standard input: shown by convert, and hidden in calculators.
OF_LINES = (
    text("field", "LIST", "Fields to convert, by number: 3, 1,3, 2-4, 3- (from 3 on), or - (all)."),
    text(
        "column",
        "NAME",
        "Field to convert: its title, with or without its unit (E for E [lx]), or its number.",
    ),
    text("d delimiter", "X", "Field separator: one character, or tab (default: runs of blanks)."),
    text(
        "header",
        "[=N]",
        "Number of header lines (1 without N; {column} implies 1).  Every line must have as "
        "many fields as the header.  If a title has a unit, it must be the input unit; the unit of "
        "the result replaces it.",
        form=WHOLE,
        least=1,
    ),
    text("add", "NAME", "Keep the field, and append a field with this title for the result."),
    text("rename", "NAME", "New title of the field; required if the result is another quantity."),
    choice(
        "decimal",
        (".", ","),
        "Decimal mark of input and output: a comma, or a point (the default).",
    ),
    choice(
        "invalid",
        INVALID,
        "Treatment of unreadable lines.  abort (default): stop at the first.  fail, warn, "
        "ignore: copy them unchanged, and fail at the end (status 2), warn (status 0) or say "
        "nothing (status 0).",
    ),
)
VERSION = flag("version", "Show the version and exit.")
EXPLAIN = flag("explain", "Show how a sentence is read, without answering it.")
HELPS = (
    flag("h", "Show the help on one screen and exit."),
    flag("help", "Show the complete help and exit."),
)
OF_RADCALC = (VERSION, EXPLAIN, *HELPS)
