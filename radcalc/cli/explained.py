"""`--explain`: the phrases of a sentence, what each becomes, and the command that it means."""

from typing import TYPE_CHECKING

import click

from radcalc import terminal
from radcalc.answer import texts_of
from radcalc.calculators.page import CHECKS
from radcalc.calculators.pages import COMMANDS
from radcalc.cli import files, habits
from radcalc.cli.cases import is_stream
from radcalc.cli.heard import hear
from radcalc.cli.lane import plain
from radcalc.cli.output import Output, decide, refuse_number_options
from radcalc.cli.sentence import Words, options_of, values_of
from radcalc.cli.spelling import EXPLAIN, pasted, quoted, typed
from radcalc.errors import RadcalcError, UsageError, call, drop, leave_out
from radcalc.render.formats import Records
from radcalc.sentences.calls import call_of
from radcalc.sentences.parts import parts_of
from radcalc.sentences.reader import read
from radcalc.terminal import JSON

if TYPE_CHECKING:
    from radcalc.cli.output import Listener

EXAMPLE = "20000 cd at 8 m to lx"
Rows = list[dict[str, str]]


def explain(words: Words, listener: "Listener | None" = None) -> int:
    """Write how a call without a command is read; do not answer it."""
    output, records = explained(words, listener)
    output.records(records, (JSON,))
    return terminal.ANSWERED


def explained(words: Words, listener: "Listener | None" = None) -> tuple[Output, Records]:
    """Return how a call without a command is read, with the options of the output."""
    asked, options = options_of([word for word in words if word != EXPLAIN])
    if not asked:
        raise UsageError("a sentence is missing", call(*EXAMPLE.split()))
    if asked[0] in COMMANDS:
        raise UsageError(f"{EXPLAIN} does not apply to {asked[0]}", drop(EXPLAIN))
    values = values_of(options, listener)
    others = {name: values.pop(name) for name in ("steps", *[row.parameter for row in CHECKS])}
    output = decide(**values, command="explain", listener=listener)
    refuse_number_options(output, EXPLAIN)
    for name, value in others.items():
        if value:
            tries = [leave_out(name), drop(EXPLAIN)]
            raise UsageError(f"--{name} does not apply to {EXPLAIN}", tries)
    rows, notes, meant = _sentence(asked, _complete(asked))
    text = " ".join(asked)
    rows.append({"phrase": text, "meaning": pasted(meant)})
    return output, Records(rows, notes, rows, inputs=texts_of({"sentence": text}))


def _complete(asked: Words) -> Words | None:
    """Return the call that words are without being read as a sentence, or None."""
    if files.begins_with_file(asked):
        return files.meant(asked) if all(word[:1] == "-" for word in asked[1:2]) else None
    if (other := habits.canonical(asked)) != asked:
        return other
    whole = ["convert", *asked]
    try:
        _ = any(map(is_stream, asked)) or hear(whole)
    except (RadcalcError, click.UsageError):
        return None
    return whole


def _sentence(asked: Words, whole: Words | None) -> tuple[Rows, list[str], Words]:
    """Return what the phrases of a sentence become, notes, and the call that it means.

    The call is `whole` if the words are complete; their phrases are those of the same call.
    """
    try:
        sentence = read(asked)
        found = call_of(sentence)
    except RadcalcError:
        if whole:
            return [], [], whole
        raise
    meant = list(typed(found))
    if whole and plain(whole) != plain(meant):
        return [], [], whole
    rows = [
        {"phrase": phrase, "meaning": _spelled(part) if part in found else part}
        for phrase, part in parts_of(sentence, found)
    ]
    notes = [f"ignored: {', '.join(sentence.ignored)}"] if sentence.ignored else []
    return rows, notes, whole or meant


def _spelled(part: str) -> str:
    return " ".join(map(quoted, typed([part])))
