"""Remarks on the answers to lines: assumptions and notes, each written once for all its lines.

Remarks that differ only in their numbers are one, with the range of each number.
"""

import re
from collections.abc import Sequence

NUMBER = r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?(?:/[1-9]\d*)?"
SPAN = re.compile(f"({NUMBER})(?: to ({NUMBER}))?")
MARK = "\0"  # stands for a number or a range
FEW = 3  # most lines named one by one

Span = tuple[str, str]  # the least and the largest number, as written


class Remark:
    """A remark on some of the lines so far."""

    def __init__(self, template: str, spans: list[Span], lines: Sequence[int]) -> None:
        self.template = template
        self.spans = spans
        self.first_lines = [*lines[: FEW + 1]]
        self.last_line = lines[-1]
        self.is_unbroken = _are_unbroken(lines)
        self.is_shared = False  # by all lines
        self.shown_spans: list[Span] | None = None

    def widen(self, spans: list[Span], lines: Sequence[int]) -> None:
        touches = lines[0] - 1 <= self.last_line and self.first_lines[0] - 1 <= lines[-1]
        self.is_unbroken = self.is_unbroken and touches and _are_unbroken(lines)
        self.first_lines = sorted({*self.first_lines, *lines[: FEW + 1]})[: FEW + 1]
        self.last_line = max(self.last_line, lines[-1])
        pairs = zip(self.spans, spans, strict=True)
        self.spans = [old if old == new else _together(*old, *new) for old, new in pairs]

    @property
    def text(self) -> str:
        """Return the remark with its numbers, and with its lines if other lines lack it."""
        spans = iter(self.spans)
        text = re.sub(MARK, lambda _: " to ".join(dict.fromkeys(next(spans))), self.template)
        if self.is_shared:
            return text
        word, colon, rest = text.partition(": ")
        return f"{word}{colon}{self._where()}: {rest}"

    def _where(self) -> str:
        first, last = self.first_lines[0], self.last_line
        if first == last:
            return f"line {first}"
        if self.is_unbroken:
            return f"lines {first} to {last}"
        named = ", ".join(map(str, self.first_lines[:FEW]))
        others = f" and others up to {last}" if len(self.first_lines) > FEW else ""
        return f"lines {named}{others}"


def _are_unbroken(lines: Sequence[int]) -> bool:
    return lines[-1] - lines[0] + 1 == len(lines)


def _together(*numbers: str) -> Span:
    return min(numbers, key=_size), max(numbers, key=_size)


def _size(number: str) -> float:
    top, _, bottom = number.partition("/")
    return float(top) / float(bottom or 1)


class Remarks:
    """The remarks on the lines of a stream."""

    def __init__(self) -> None:
        self.remarks: dict[str, Remark] = {}  # by their templates
        self.shared: set[str] | None = None  # by all lines before any answer is written
        self.has_begun = False

    def hear(self, texts: Sequence[str], lines: Sequence[int]) -> None:
        templates = [SPAN.sub(MARK, text) for text in texts]
        if not self.has_begun:
            self.shared = {*templates} & ({*templates} if self.shared is None else self.shared)
        for template, text in zip(templates, texts, strict=True):
            spans = [(low, high or low) for low, high in SPAN.findall(text)]
            if template in self.remarks:
                self.remarks[template].widen(spans, lines)
            else:
                self.remarks[template] = Remark(template, spans, lines)

    def not_yet_said(self) -> list[str]:
        """Return the remarks not yet written, for output before the answers."""
        remarks = [item for item in self.remarks.values() if item.shown_spans is None]
        for remark in remarks:
            remark.is_shared = not self.has_begun and remark.template in (self.shared or ())
            remark.shown_spans = remark.spans
        self.has_begun = self.has_begun or self.shared is not None
        return [remark.text for remark in remarks]

    def changed(self) -> list[str]:
        """Return the remarks with numbers outside the range already written."""
        return [
            remark.text
            for remark in self.remarks.values()
            if remark.shown_spans not in (None, remark.spans)
        ]
