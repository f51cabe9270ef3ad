"""Output formats: a module for each, with the functions of `Renderer`.

`REMARKS_ARE_APART` means that assumptions and notes go to standard error instead.
"""

from collections.abc import Mapping, Sequence
from importlib import import_module
from typing import TYPE_CHECKING, Any

from radcalc.answer import Result, Row, ShownInput
from radcalc.quantities.language import ENGLISH
from radcalc.tuples import NamedTuple


class Style(NamedTuple):
    """Style of a text: digits, bare numbers, width, colour, language, remarks.

    `brief` allows a single line for a single value, as at the prompt; `auto` selects SI prefixes.
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
    """Rows of named fields; a `table` shows other rows, with its notes below.

    A field may be a list of texts.  `inputs` are the search terms.  Columns of the table that are
    `unfolded` are never folded.
    """

    rows: Sequence[Mapping[str, Any]]
    notes: Sequence[str]
    table: Sequence[Mapping[str, str]]
    right: Sequence[str] = ()
    inputs: Sequence[ShownInput] = ()
    unfolded: Sequence[str] = ()


class Judgement(NamedTuple):
    """The verdict on an answer, the right result, its inputs, assumptions and notes."""

    verdict: Any
    right: Row
    inputs: Sequence[ShownInput]
    assumptions: Sequence[str]
    notes: Sequence[str]


if TYPE_CHECKING:
    from typing import Protocol

    class Renderer(Protocol):
        """The functions of a format's module, for answers, lists and checked answers."""

        REMARKS_ARE_APART: bool

        def results(self, results: Sequence[Result], style: Style) -> str:
            """Return the text of one or several answers."""

        def records(self, records: Records, style: Style) -> str:
            """Return the text of a list."""

        def verdict(self, judgement: Judgement, style: Style) -> str:
            """Return the text of a judgement."""


def renderer(name: str) -> "Renderer":
    """Load and return the module of a format."""
    module: Any = import_module(f"radcalc.render.{name}")
    return module  # type: ignore[no-any-return]
