"""The lists of options in the manual page, made of the commands: as in --help, a list a section.

`python -m radcalc.cli.manual man/radcalc.1` writes them anew between the page's marks

    .\\" options of NAME
    .\\" end of options

where NAME is a command, `radcalc`, `every command`, `every calculator` or `every stream`.  The
rest of the page is written by hand.
"""

import re
import sys
import textwrap
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path

import click

from radcalc.cli import check, commands, options, streams
from radcalc.cli.command import ALSO, GET, LINES, SectionedCommand

BLOCK = re.compile(r'^(\.\\" options of (.+)\n)(?:.*\n)*?(\.\\" end of options\n)', re.MULTILINE)
OF_EVERY_CALCULATOR = (GET, *check.OPTIONS, options.STEPS)
FLAG = re.compile(r"(\(?)(--[a-z][\w=-]*)(\W*)")
WIDTH = 80

Sections = Mapping[str, Sequence[click.Option]]


def rewritten(page: str) -> str:
    """The page with every list of options as the commands have them."""
    return BLOCK.sub(lambda found: found[1] + _lists(sections_of(found[2])) + found[3], page)


def sections_of(name: str) -> Sections:
    """The options that a block lists, by the titles of the help; a single list has no title."""
    top = click.Context(commands, info_name="radcalc", **commands.context_settings)
    if name == "every command":
        help_option = commands.get_help_option(top)
        return {"": [*options.OPTIONS, *([help_option] if help_option else [])]}
    if name == "every calculator":
        return {"": OF_EVERY_CALCULATOR}
    if name == "every stream":
        return {"": streams.OPTIONS}
    if name == "radcalc":
        return {"": [one for one in commands.get_params(top) if isinstance(one, click.Option)]}
    command = commands.get_command(top, name)
    if not isinstance(command, SectionedCommand):
        raise KeyError(f"no command has the options of {name!r}")
    shared = {*options.OPTIONS, *options.OF_LISTS}
    if GET in command.params:
        shared.update(OF_EVERY_CALCULATOR)
    own = {
        title: [option for option in listed if option not in shared]
        for title, listed in command.sections.items()
        if title != LINES
    }
    return {title: listed for title, listed in own.items() if listed}


def _lists(sections: Sections) -> str:
    """A list a section."""
    lines: list[str] = []
    for title, listed in sections.items():
        lines += [".Pp", f"{_text(title)}:"] if title else []
        lines += [".Bl -tag -width Ds", *_items(listed), ".El"]
    return "".join(f"{line}\n" for line in lines)


def _items(listed: Sequence[click.Option]) -> Iterator[str]:
    """An item an option; hidden ones are other names of the one before them."""
    shown = [option for option in listed if not option.hidden]
    starts = [listed.index(option) for option in shown]
    for option, start, end in zip(shown, starts, [*starts[1:], len(listed)], strict=True):
        spellings = [spelling for one in listed[start:end] for spelling in _spellings(one)]
        flags = " , ".join(f"Fl {_plain(spelling[1:])}" for spelling in spellings)
        yield f".It {flags}{_argument(option)}"
        text, also, _ = (option.help or "").partition(ALSO)
        yield from _sentences(f"{text}." if also else text)


def _spellings(option: click.Option) -> list[str]:
    """The short name first."""
    return sorted(option.opts, key=len)


def _argument(option: click.Option) -> str:
    """What follows an option: one of several words, or an example or a word for a value."""
    if option.is_flag or option.count:
        return ""
    if isinstance(option.type, click.Choice):
        # a punctuation mark of its own is none of mdoc's
        choices = [rf"\&{word}" if word in (".", ",") else word for word in option.type.choices]
        return f" Cm {' | '.join(choices)}"
    metavar = option.metavar or "VALUE"
    if "[" not in metavar:
        return f" Ar {_plain(metavar)}"
    macros = {"[": "Oo", "]": "Oc", "=": "=", ":": ":"}
    parts = [macros.get(part, f"Ar {part}") for part in re.findall(r"[][=:]|[^][=:]+", metavar)]
    words = " " if metavar[:2] != "[=" else " Ns "
    for part, following in zip(parts, [*parts[1:], ""], strict=True):
        words += part
        if following and part != "Oo" and following != "Oc":
            words += " Ns"
        words += " " if following else ""
    return words


def _sentences(text: str) -> Iterator[str]:
    """A help text as lines of mdoc, in which the options that it names are marked up."""
    words: list[str] = []
    for word in text.split():
        named = FLAG.fullmatch(word)
        if not named:
            words.append(word)
            continue
        yield from _filled(words)
        words = []
        yield " ".join([".Fl", *named[1], _plain(named[2][1:]), *named[3]])
    yield from _filled(words)


def _filled(words: Iterable[str]) -> list[str]:
    """Lines of running text."""
    return textwrap.wrap(
        " ".join(map(_text, words)), WIDTH, break_long_words=False, break_on_hyphens=False
    )


def _text(text: str) -> str:
    """Running text: hyphens stay hyphens, and no word is taken for a request."""
    text = re.sub(r"(?<![A-Za-z])-|(?<=\de)-(?=\d)", r"\\-", _plain(text))
    return rf"\&{text}" if text[:1] in (".", "'") else text


def _plain(text: str) -> str:
    """Text whose characters mean themselves."""
    text = text.replace("\\", r"\e").replace("^", r"\(ha")
    return "".join(c if c.isascii() else f"\\[u{ord(c):04X}]" for c in text)


def main(words: Sequence[str]) -> None:
    """Rewrite a page in its place."""
    path = Path(words[0])
    path.write_text(rewritten(path.read_text(encoding="utf-8")), encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
