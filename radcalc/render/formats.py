"""The formats of an answer: a module each, in which three functions make a text of it.

`results(results, style)` is for answers, `records(records, style)` for lists of what there is,
`verdict(judgement, style)` for whether an answer is right.  `REMARKS_ARE_APART` says that what
was assumed and noted goes to standard error instead.
"""

from collections.abc import Mapping, Sequence
from importlib import import_module
from typing import TYPE_CHECKING, Any, NamedTuple

from radcalc.answer import Result, Row, ShownInput
from radcalc.quantities.language import ENGLISH

TABLE, PLAIN, JSON, CSV = "table", "plain", "json", "csv"
FORMATS = (TABLE, PLAIN, JSON, CSV)


class Style(NamedTuple):
    """How a text is to look: digits, bare numbers, width, colour, language, with remarks or not.

    `command` is the one that answers.
    `brief` is a table that may be a line where there is one value, as at the prompt.
    With `auto` the units have the prefixes that fit.
    """

    precision: int | None = None
    bare: bool = False
    width: int = 80
    color: bool = False
    language: str = ENGLISH
    remarks: bool = True
    command: str = ""
    brief: bool = False
    auto: bool = False


class Records(NamedTuple):
    """Rows of named fields; a table has its own, and the notes below it, not beside.

    A field may be a list of texts, which JSON keeps; elsewhere they are parted by commas.
    `inputs` are what was looked for.
    """

    rows: Sequence[Mapping[str, Any]]
    notes: Sequence[str]
    table: Sequence[Mapping[str, str]]
    right: Sequence[str] = ()
    inputs: Sequence[ShownInput] = ()


class Judgement(NamedTuple):
    """What is said of an answer; the right one, from what it follows, and what was assumed."""

    verdict: Any
    right: Row
    inputs: Sequence[ShownInput]
    assumptions: Sequence[str]
    notes: Sequence[str]


if TYPE_CHECKING:
    from typing import Protocol

    class Renderer(Protocol):
        """What the module of a format has."""

        REMARKS_ARE_APART: bool

        def results(self, results: Sequence[Result], style: Style) -> str:
            """The text of one answer, or of several."""

        def records(self, records: Records, style: Style) -> str:
            """The text of a list."""

        def verdict(self, judgement: Judgement, style: Style) -> str:
            """The text of a judgement."""


def renderer(name: str) -> "Renderer":
    """The module of a format, loaded when it is needed."""
    module: Any = import_module(f"radcalc.render.{name}")
    return module  # type: ignore[no-any-return]
