"""The short help: one screen with the examples and the options that people use most.

Both come from the examples of the complete help: what they use most often is shown.
"""

import re
from collections.abc import Mapping, Sequence
from functools import cache
from inspect import cleandoc

import click

from radcalc.cli.help_format import HelpFormatter, joined, narrowed
from radcalc.terminal import fold

SCREEN = 23  # lines; the shell's prompt is the last one of 24
EXAMPLES = 5  # lines
TERM = 27  # columns of an option with its value
ALWAYS = ("--get", "--check", "--json")
INDENT = "  "
BRACKETS = re.compile(r" \([^()]*\)")
Sections = Mapping[str, Sequence[click.Option]]


def write_examples(command: click.Command, sections: Sections, formatter: HelpFormatter) -> None:
    """Write the first example, those with the options that are used most, then the next ones.

    Those of one line come first.
    """
    room = formatter.width - len(INDENT)
    folded = {line: narrowed(line, room) for line in _examples(command)}
    lines = sorted(folded, key=lambda line: len(folded[line]) > 1)
    order = lines[:1]
    for spellings in _used(command, sections).values():
        if not any(spellings & _options(line) for line in order):
            order += [line for line in lines if spellings & _options(line)][:1]
    chosen: list[str] = []
    for line in dict.fromkeys([*order, *lines]):
        if sum(len(folded[other]) for other in [*chosen, line]) <= EXAMPLES:
            chosen.append(line)
    with formatter.section("Examples"):
        for line in folded:
            if line in chosen:
                formatter.write("".join(f"{part}\n" for part in folded[line]))


def write_options(
    command: click.Command, sections: Sections, formatter: HelpFormatter, ctx: click.Context
) -> None:
    """Write the options of the examples, the first of each section and the next ones, a line each.

    They are as many as the screen has room for, in the order of the complete help.
    """
    families = _families(sections)
    firsts = [next((o for o in group if not o.hidden), None) for group in sections.values()]
    order = [
        *(option for option in families if option.opts[-1] in ALWAYS),
        *_used(command, sections),
        *filter(None, firsts),
        *families,
    ]
    room = SCREEN - formatter.getvalue().count("\n") - len(["", "Options:", "more:"])
    chosen = [*dict.fromkeys(order)][:room]
    records = [option.get_help_record(ctx) or ("", "") for option in families if option in chosen]
    terms = [_term(term) for term, _ in records]
    column = max(map(len, terms)) + 2 * len(INDENT)
    meanings = [_cut(meaning, formatter.width - column) for _, meaning in records]
    with formatter.section("Options"):
        formatter.write_dl(list(zip(terms, meanings, strict=True)))


@cache
def _examples(command: click.Command) -> Sequence[str]:
    """Return the examples of the complete help, each on one line."""
    _, _, examples = cleandoc(command.help or "").partition("\b\nExamples:\n")
    return [*joined(examples.partition("\n\n")[0].split("\n"))] if examples else []


@cache
def _options(line: str) -> frozenset[str]:
    """Return the options of an example."""
    call = line.strip().partition("  ")[0]
    return frozenset(word.partition("=")[0] for word in call.split() if word[:1] == "-")


def _families(sections: Sections) -> dict[click.Option, set[str]]:
    """Return the visible options with their spellings; hidden ones are of the one before."""
    families: dict[click.Option, set[str]] = {}
    for group in sections.values():
        spellings: set[str] = set()
        for option in group:
            if not option.hidden:
                spellings = families[option] = set()
            spellings.update(option.opts)
    return families


def _used(command: click.Command, sections: Sections) -> dict[click.Option, set[str]]:
    """Return the options of the examples, the most frequent first."""
    lines = [_options(line) for line in _examples(command)]
    families = _families(sections)
    uses = {o: sum(bool(names & line) for line in lines) for o, names in families.items()}
    return {o: families[o] for o in sorted(uses, key=lambda o: -uses[o]) if uses[o]}


def _term(term: str) -> str:
    """Return an option with its value, with its first choices, or alone."""
    if len(term) <= TERM:
        return term
    choices, _, _ = term[: TERM - len("...]")].rpartition("|")
    return f"{choices}|...]" if choices else f"{term.partition(' ')[0]} ..."


def _cut(text: str, room: int) -> str:
    """Return the first sentence, without its remarks in brackets or cut if it is too long."""
    sentence = f"{' '.join(text.split()).partition('. ')[0].removesuffix('.')}."
    if len(sentence) > room:
        sentence = BRACKETS.sub("", sentence)
    if len(sentence) <= room:
        return sentence
    return f"{fold(sentence, room - len(' ...'))[0].rstrip(',;:(')} ..."
