"""`radcalc help [WORD ...]`: the help of a command, or a search for words."""

from collections.abc import Iterator, Sequence
from contextlib import suppress

from radcalc.answer import texts_of
from radcalc.calculators.pages import COMMANDS, page_of
from radcalc.cli.command import define
from radcalc.cli.findings import EXACT, Finding, find, near
from radcalc.cli.output import Output, refuse_number_options
from radcalc.cli.spelling import pasted
from radcalc.errors import UsageError, call, quote
from radcalc.render.formats import Records
from radcalc.sentences import tasks
from radcalc.terminal import JSON

MOST, OF_A_KIND = 20, 5  # findings shown, and of one kind unless they have the exact name
# The kinds with their plurals, and the commands that list all of one kind.
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
    if len(words) > 1 and all(word in COMMANDS for word in words):
        raise UsageError("help takes one command", [call(word, "--help") for word in words])
    found = find(text)
    if not found:
        similar = [call("help", *name.split()) for name in near(text, 3)]
        raise UsageError(
            f"nothing has the words '{quote(text)}'", similar or [call("--help"), call("examples")]
        )
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
    for kind, (plural, listing) in KINDS.items():
        more = sum(one.kind == kind for one in found) - sum(one.kind == kind for one in shown)
        if more:
            way = f": {pasted((*listing, *text.split()))}" if listing else ""
            yield f"{more} more {kind if more == 1 else plural}{way}"


def _tasks(text: str) -> Iterator[str]:
    with suppress(UsageError):  # no task has the words
        count = len(tasks.search(text))
        mention = "1 example mentions" if count == 1 else f"{count} examples mention"
        yield f"{mention} it: {pasted(('examples', *text.split()))}"
