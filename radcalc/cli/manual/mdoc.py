"""Text in mdoc(7): escapes, filled lines, displays, and marked-up options."""

import re
import textwrap
from collections.abc import Iterable, Iterator

FLAG = re.compile(r"([('\"]?)(--[a-z][\w=-]*|-[a-z](?![\w-]))(\W*)")
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
            flag = FLAG.fullmatch(word)
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
