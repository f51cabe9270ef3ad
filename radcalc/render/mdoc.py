"""Pages of the manual as text, from mdoc(7), so that no `man` is needed.

Only the macros that radcalc's own pages use are known; another one raises KeyError.
"""

import re
from collections.abc import Iterable, Iterator, Sequence
from types import MappingProxyType

from radcalc.terminal import BOLD, RESET, UNDERLINE

ESCAPES = MappingProxyType({
    r"\(aq": "'", r"\(dq": '"', r"\(ga": "`", r"\(ha": "^", r"\(ti": "~", r"\-": "-", r"\&": "",
    r"\e": "\\", r"\(+-": "±", r"\[+-]": "±", r"\(de": "°", r"\(mc": "µ", r"\(S2": "²",
    r"\[*D]": "Δ", r"\[*F]": "Φ", r"\[*h]": "θ", r"\[*p]": "π", r"\[*t]": "τ",
})  # fmt: skip
ESCAPED = re.compile(r"\\\[u([0-9A-F]{4,5})\]|\\\[[^]]*\]|\\\(..|\\.")
MARKED = re.compile("\033\\[[0-9;]*m")
TOKEN = re.compile(r'"([^"]*)"|(\S+)')

TITLE, BODY = 2, 5  # indents of the title of a subsection, and of text
WIDTHS = {"Ds": 6}  # of tags, by name
LONG, OFFSET = 6, 2  # indents of the later lines of a tag, and of displays
GAP = 2  # columns after a tag
STYLES = {"Fl": BOLD, "Cm": BOLD, "Nm": BOLD, "Ic": BOLD, "Ar": UNDERLINE, "Em": UNDERLINE,
          "Ev": "", "Li": "", "No": "", "Pa": UNDERLINE, "Sx": ""}  # fmt: skip
DEFAULTS = {"Ar": ("file", "...")}  # the arguments of a macro without any
# Macros whose marks are around the rest of the line.
AROUND = {"Dq": ('"', '"'), "Op": ("[", "]"), "Pq": ("(", ")"), "Ql": ("'", "'")}
OPENING, CLOSING = {"Oo": "[", "Po": "("}, {"Oc": "]", "Pc": ")"}
BEFORE, AFTER, MIDDLE = ("(", "["), (".", ",", ":", ";", ")", "]", "?", "!"), "|"
SIGNS = {"-bullet": "*", "-dash": "-", "-enum": "1."}  # of the first item of a list
CALLED = {*STYLES, *AROUND, *OPENING, *CLOSING, "Ns", "Xr"}
NO_TEXT = {"Dd", "Dt", "Os"}


def displayed(source: str) -> str:
    """Return the text that a source shows."""
    return ESCAPED.sub(lambda m: chr(int(m[1], 16)) if m[1] else ESCAPES[m[0]], source)


def typeset(page: str, width: int, is_colored: bool = False) -> str:
    """Return a page as lines of at most `width` columns, except those of its displays.

    Examples
    --------
    >>> print(typeset(".Sh NAME\\n.Nm radcalc\\n.Nd calculator of light", 80))
    NAME
         radcalc - calculator of light
    """
    return _Typesetter(width, is_colored).text(page)


class _List:
    """A list that is open: the columns of its tags, and whether there are blank lines in it."""

    def __init__(self, words: Sequence[str]) -> None:
        kind, *arguments = words
        self.sign = SIGNS.get(kind, "")
        self.is_compact = "-compact" in arguments
        self.columns: list[int] = []
        if kind == "-column":
            self.columns = [len(word) + GAP for word in arguments if word != "-compact"]
        if self.sign:
            self.tag = len(self.sign) + 1
        else:
            longest = arguments[arguments.index("-width") + 1] if "-width" in arguments else ""
            self.tag = WIDTHS.get(longest, len(longest)) + GAP


class _Typesetter:
    """The lines made so far, the words of the paragraph, and the lists that are open."""

    def __init__(self, width: int, is_colored: bool) -> None:
        self.width, self.is_colored = width, is_colored
        self.lines: list[str] = []
        self.words: list[str] = []
        self.is_joined = False  # the next word belongs to the last one
        self.lists: list[_List] = []
        self.tag: list[str] = []  # waits for the text of its item
        self.hanging = 0  # indent of the later lines of a paragraph
        self.name = self.section = ""

    def text(self, page: str) -> str:
        source = iter(page.splitlines())
        for line in source:
            if line == "." or line.startswith(r".\""):
                continue
            if line.startswith(".Bd"):
                self._display(source)
            elif line.startswith("."):
                macro, *words = _tokens(line[1:])
                self._macro(macro, words)
            else:
                for word in line.split():
                    self._word(displayed(word))
        self._end()
        return "\n".join(self.lines)

    def _macro(self, macro: str, words: Sequence[str]) -> None:
        """Set a line that begins with a macro."""
        if macro in ("Sh", "Ss"):
            self._title(macro, [displayed(word) for word in words])
        elif macro == "Pp":
            self._blank()
        elif macro == "Bl":
            self._end()
            self.lists.append(_List(words))
        elif macro == "It":
            self._item(words)
        elif macro == "El":
            self._end()
            self.lists.pop()
        elif macro == "Dl":
            self._end()
            self.lines.append(" " * (self._indent() + OFFSET) + displayed(" ".join(words)))
        elif macro == "Nd":
            self._line(["No", "-", *words])
        elif macro in CALLED:
            if macro == "Nm":
                self.name = self.name or words[0]
                if self.section == "SYNOPSIS":
                    self._end()
                    self.hanging = len(self.name) + 1
            self._line([macro, *words])
        elif macro not in NO_TEXT:
            raise KeyError(macro)

    def _title(self, macro: str, words: Sequence[str]) -> None:
        self._end()
        self._blank()
        self.hanging = 0
        title = self._styled(" ".join(words), BOLD)
        if macro == "Sh":
            self.section = " ".join(words)
        self.lines.append(title if macro == "Sh" else " " * TITLE + title)

    def _item(self, words: Sequence[str]) -> None:
        self._end()
        block = self.lists[-1]
        if not block.is_compact:
            self._blank()
        if block.columns:
            self._row(block.columns, words)
        elif block.sign:
            self.tag = [block.sign]
            if block.sign[:-1].isdigit():
                block.sign = f"{int(block.sign[:-1]) + 1}."
        else:
            self._line(["No", *words])
            self.tag, self.words = self.words, []

    def _row(self, columns: Sequence[int], words: Sequence[str]) -> None:
        cells = displayed(" ".join(words)).split(" Ta ")
        row = "".join(f"{cell:{size}}" for cell, size in zip(cells, columns, strict=True))
        self.lines.append(" " * self._indent() + row.rstrip())

    def _display(self, source: Iterator[str]) -> None:
        """Set the lines of a literal display as they are."""
        self._end()
        self._blank()
        for line in source:
            if line == ".Ed":
                break
            self.lines.append((" " * (self._indent() + OFFSET) + displayed(line)).rstrip())

    def _line(self, words: Sequence[str]) -> None:
        """Set a macro with its arguments, which may be macros."""
        words = list(words)
        after: list[str] = []
        while len(words) > 1 and words[-1] in AFTER:
            after.insert(0, words.pop())
        closing: list[str] = []
        macro, is_without = "", False  # whether the macro has had no argument yet
        rest = iter(words)
        for word in rest:
            if word in CALLED:
                if is_without:
                    self._without(macro, word)
                is_without = word in STYLES
                macro = word if is_without else "No"
                if word in AROUND:
                    opening, end = AROUND[word]
                    self._open(opening)
                    closing.insert(0, end)
                elif word in OPENING:
                    self._open(OPENING[word])
                elif word in CLOSING:
                    self._close(CLOSING[word])
                elif word == "Ns":
                    self.is_joined = True
                elif word == "Xr":
                    self._word(f"{next(rest)}({next(rest)})")
            elif word in AFTER:
                self._close(word)
            elif word in BEFORE:
                self._open(word)
            else:
                is_without = False
                self._argument(macro, word)
        if is_without:
            self._without(macro, "")
        for mark in (*closing, *after):
            self._close(mark)

    def _without(self, macro: str, following: str) -> None:
        """Set a macro without arguments: `-` is joined to the macro that follows."""
        if macro == "Nm":
            self._argument(macro, self.name)
        elif macro == "Fl":
            self._word(self._styled("-", BOLD))
            self.is_joined = bool(following)
        else:
            for word in DEFAULTS.get(macro, ()):
                self._argument(macro, word)

    def _argument(self, macro: str, words: str) -> None:
        is_flag = macro == "Fl"
        for word in displayed(words).split():
            if word == MIDDLE:
                self._word(word)
            else:
                self._word(self._styled(f"-{word}" if is_flag else word, STYLES[macro]))

    def _open(self, mark: str) -> None:
        self._word(mark)
        self.is_joined = True

    def _close(self, mark: str) -> None:
        self.is_joined = bool(self.words)
        self._word(mark)

    def _word(self, text: str) -> None:
        if self.is_joined and self.words:
            self.words[-1] += text
        else:
            self.words.append(text)
        self.is_joined = False

    def _styled(self, text: str, style: str) -> str:
        return f"{style}{text}{RESET}" if self.is_colored and style else text

    def _indent(self) -> int:
        return BODY + sum(block.tag for block in self.lists if not block.columns)

    def _blank(self) -> None:
        """End the paragraph, with a blank line below it unless there is one."""
        self._end()
        if self.lines and self.lines[-1]:
            self.lines.append("")

    def _end(self) -> None:
        """End the paragraph, and set its words, after the tag that waits for them."""
        indent = self._indent()
        folded = list(_folded(self.words, self.width - indent, self.hanging))
        if self.tag:
            before = indent - self.lists[-1].tag
            tag = list(_folded(self.tag, self.width - before, LONG))
            room = self.lists[-1].tag - _length(tag[-1])
            if folded and room > 0:
                tag[-1] += " " * room + folded.pop(0)
            self.lines += [" " * before + line for line in tag]
        self.lines += [" " * indent + line for line in folded]
        self.words, self.tag, self.is_joined = [], [], False


def _tokens(line: str) -> list[str]:
    """Return the words of a line; those in quotes are one."""
    return [quoted or word for quoted, word in TOKEN.findall(line)]


def _length(text: str) -> int:
    return len(MARKED.sub("", text))


def _folded(words: Iterable[str], width: int, hanging: int) -> Iterator[str]:
    """Yield lines of words; those after the first are indented by `hanging`."""
    line = ""
    for word in words:
        if line and _length(line) + 1 + _length(word) > width:
            yield line
            line = " " * hanging + word
        else:
            line = f"{line} {word}" if line.strip() else line + word
    if line:
        yield line
