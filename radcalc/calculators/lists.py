"""The pages of commands that list, search or talk, and calculate nothing."""

import sys
from collections.abc import Mapping
from pathlib import Path

from radcalc.calculators.page import (
    COLOR,
    FILE,
    OF_LISTS,
    OUTPUT,
    SEARCH,
    TOLERANCE,
    Operand,
    Page,
    choice,
    text,
)
from radcalc.quantities.language import LANGUAGES

# Forms of operands: words of typical values, of tasks, and names of pages of the manual.
TYPICAL, TASK, MANUAL = "typical value", "task", "manual"
MAIN = "radcalc"
LIST = Page(calculates=False, output=OF_LISTS)

PAGES: Mapping[str, Page] = {
    "mark": LIST._replace(
        operand=Operand("sheet", "FILE", FILE),
        sections={
            "Marks": (
                text(
                    "points",
                    "mistake=0.5",
                    "Parts of a question's points, as unit=0.5,digits=0.75,mistake=0.5 (the "
                    "default): for a right number without its unit, a number with too few digits, "
                    "one named mistake.",
                ),
                TOLERANCE,
            )
        },
    ),
    "columns": LIST._replace(operand=Operand("file", "FILE", FILE)),
    "units": LIST._replace(operand=Operand("search", "[SEARCH]", SEARCH)),
    "quantities": LIST._replace(
        operand=Operand("search", "[SEARCH]", SEARCH),
        sections={
            "Names": (
                choice(
                    "lang",
                    LANGUAGES,
                    "Language of the names (default: the locale's, else English).",
                ),
            )
        },
    ),
    "typical": LIST._replace(operand=Operand("search", "[SEARCH]", TYPICAL)),
    "examples": LIST._replace(operand=Operand("search", "[WORD ...]", TASK)),
    "manual": LIST._replace(operand=Operand("page", "[SECTION] [PAGE]", MANUAL), output=(COLOR,)),
    "help": LIST._replace(operand=Operand("search", "[WORD ...]", SEARCH)),
    "prompt": LIST._replace(output=OUTPUT),
}


def manual_folder() -> Path:
    """Return the folder of the manual: in the package of a wheel, next to sources, or share/man."""
    package = Path(__file__).parents[1]
    places = (package / "man", package.parent / "man", Path(sys.prefix) / "share" / "man")
    return next(filter(manual_pages, places), places[0])


def manual_pages(folder: Path | None = None) -> list[Path]:
    """Return the pages of the manual."""
    return sorted((folder or manual_folder()).glob(f"man?/{MAIN}*.?"))


def manual_names() -> list[str]:
    """Return the names of the pages, as they are typed."""
    return sorted({page.stem.removeprefix(f"{MAIN}-") for page in manual_pages()})
