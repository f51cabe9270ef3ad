"""Formulas of laws as trees, and the edits of a tree: mistakes of any law, from its own formula.

A function may be taken for its sibling or left out, a power dropped, a sum taken for a difference,
a term or a factor forgotten.  The edited formula is solved for the same symbol as the law.
"""

import math
import re
from collections.abc import Callable, Iterator
from functools import cache
from typing import Any, NamedTuple

from radcalc.homework.chain import FAILURES
from radcalc.homework.edits import NAMES, NO_FACTORS, label_of, text_of
from radcalc.homework.problem import Candidate, Problem
from radcalc.homework.usual import USUAL
from radcalc.homework.words import Said
from radcalc.laws.law import At, Relation
from radcalc.quantities.symbols import SYMBOLS

PIECE = re.compile(r"\{[^}]*\}|\d+(?:\.\d+)?|[A-Za-z_]\w*|[-+*/^(){}]")
NUMBERS = {"pi": math.pi, "Omega0": 1.0, "Hz": 1.0, "lg2": math.log10(2)}
FUNCTIONS: dict[str, Callable[[float], float]] = {
    "sin": math.sin,
    "cos": math.cos,
    "tan": math.tan,
    "atan": math.atan,
    "asin": math.asin,
    "arcsin": math.asin,
    "sqrt": math.sqrt,
    "exp": math.exp,
    "ln": math.log,
    "log2": math.log2,
    "log10": math.log10,
    "ceil": math.ceil,
    "floor": math.floor,
}
SIBLINGS = {  # functions taken for another, the likeliest first; "" leaves the function out
    "sin": ("tan", "", "cos"),
    "cos": ("sin",),
    "tan": ("sin", ""),
    "atan": ("asin", ""),
    "asin": ("atan", ""),
    "arcsin": ("",),
    "sqrt": ("",),
    "log2": ("log10", "ln"),
    "log10": ("ln", "log2"),
    "ln": ("log10",),
    "ceil": ("floor",),
}


class Node(NamedTuple):
    """A part of a formula: a number, a symbol, a function, a power, a product or a sum.

    `kind` is "number", "symbol", "call", "power", "product" or "sum"; in a product and in a sum
    each part has a sign: -1 for a divisor or a term that is subtracted.
    """

    kind: str
    name: str = ""
    parts: tuple[tuple[float, Any], ...] = ()
    number: float = 0.0

    def at(self, values: At) -> float:
        """Return the value of the formula."""
        if self.kind == "number":
            return self.number
        if self.kind == "symbol":
            return float(values(self.name))
        sizes = [(sign, part.at(values)) for sign, part in self.parts]
        if self.kind == "sum":
            return float(sum(sign * size for sign, size in sizes))
        if self.kind == "product":
            return float(math.prod(size**sign for sign, size in sizes))
        if self.kind == "power":
            return float(sizes[0][1] ** sizes[1][1])
        return FUNCTIONS[self.name](sizes[0][1])

    def symbols(self) -> set[str]:
        own = {self.name} if self.kind == "symbol" else set()
        return own.union(*(part.symbols() for _, part in self.parts))


class Edit(NamedTuple):
    """An edited formula: the kind of the mistake, what it concerns, and the tree of each side."""

    kind: str
    what: str
    left: Node
    right: Node


class Unread(ValueError):
    """A formula that is not a tree: an integral, or one with words."""


# ---------------------------------------------------------------------------------------------
# Mistakes

NAMED = {  # edits with words of their own: the law, the edit, and the usual mistake
    ("straight line to the source", "other sign", "lateral"): "sum-for-difference",
    ("flux of a lobe divided by its peak intensity", "no term", "1"): "lobe-without-one",
    ("flux of a lobe divided by its peak intensity", "no term", "exponent"): "lobe-without-one",
    ("working f-number", "no term", "magnification"): "magnification-forgotten",
    ("spread of a gaussian beam", "plain sum", ""): "sum-for-root",
    ("spread of a gaussian beam", "no term", "diameter"): "exit-forgotten",
    ("spread of a uniform beam", "no term", "diameter"): "exit-forgotten",
    ("guide number", "no function", "sqrt"): "speed-without-root",
    ("exposure value at ISO 100, behind a filter", "other sign", "stops"): "filter-the-wrong-way",
}
FUNCTION_NAMES = {"sin": "sine", "cos": "cosine", "tan": "tangent", "sqrt": "square root"}
KINDS = {  # by kind of an edit: the end of the mistake's name, its rank, and what was done
    "sibling": ("", 2.0, "{0} was used"),
    "no function": ("-forgotten", 3.0, "{0} was forgotten"),
    "plain sum": ("sum-for-root", 1.0, "the terms were added without their squares and the root"),
    "not squared": ("-not-squared", 2.0, "the {0} was not squared"),
    "product for power": ("-for-power", 3.0, "it was multiplied by the {0}, which is an exponent"),
    "other sign": ("-subtracted", 3.0, "the sign of the {0} was turned"),
    "no term": ("-left-out", 2.5, "the {0} was left out of the sum"),
    "no factor": ("-forgotten", 3.0, "the {0} was forgotten"),
    "inverted": ("-upside-down", 4.0, "the {0} was inverted"),
}


def find(p: Problem) -> Iterator[Candidate]:
    """Yield the wrong values from one edit of the formula of a relation in the derivation."""
    for law, target in p.chain.steps:
        if not isinstance(law, Relation):
            continue
        for edit in edits(law.template):
            if edit.kind in ("no factor", "inverted") and edit.what in NO_FACTORS:
                continue
            try:
                size = solve(edit, target, p.chain.values.__getitem__)
            except FAILURES:
                continue
            if not isinstance(size, float):
                continue
            used = law._replace(template=f"{text(edit.left)} = {text(edit.right)}")
            value = p.chain.by(used, target, size)
            if value is not None:
                yield _candidate(law, edit, value)


def _candidate(law: Relation, edit: Edit, value: float) -> Candidate:
    named = NAMED.get((law.name, edit.kind, edit.what))
    if edit.kind == "sibling" and edit.what.endswith("-for-log2"):
        named = "log10-for-log2"
    if named:
        rank, done, rule = USUAL[named]
        return Candidate(named, rank, value, done, rule or text_of(law))
    end, rank, done = KINDS[edit.kind]
    what = NAMES.get(edit.what) or FUNCTION_NAMES.get(edit.what, edit.what)
    if edit.kind == "no factor" and what[:1].isdigit():
        what = "constant"
    return Candidate(what + end, rank, value, Said(done, _words(edit.what)), text_of(law))


def is_of_symbol(candidate: Candidate) -> bool:
    """Return whether a mistake concerns a symbol or has a name: not a function or a number."""
    stem = candidate.mistake
    for end, _, _ in KINDS.values():
        stem = stem.removesuffix(end)
    return stem in SYMBOLS or candidate.mistake in NAMED.values()


def _words(what: str) -> str:
    if what in SYMBOLS:
        return label_of(what)
    sibling, _, name = what.partition("-for-")
    if name:
        return Said("{0} for {1}", sibling, name)
    return FUNCTION_NAMES.get(what, what)


# ---------------------------------------------------------------------------------------------
# Reading


class _Reader:
    """A reader of one side of a formula, in which a blank multiplies."""

    def __init__(self, text: str) -> None:
        self.pieces: list[str] = PIECE.findall(text)
        if "".join(self.pieces) != text.replace(" ", ""):
            raise Unread(text)
        self.place = 0

    def peek(self) -> str:
        return self.pieces[self.place] if self.place < len(self.pieces) else ""

    def next(self) -> str:
        self.place += 1
        return self.pieces[self.place - 1]

    def sum(self) -> Node:
        terms = [(1.0, self.product())]
        while self.peek() in ("+", "-"):
            sign = 1.0 if self.next() == "+" else -1.0
            terms.append((sign, self.product()))
        return terms[0][1] if len(terms) == 1 else Node("sum", parts=tuple(terms))

    def product(self) -> Node:
        factors = [(1.0, self.power())]
        while self.peek() not in ("", "+", "-", ")"):
            sign = 1.0
            if self.peek() == "/":
                self.next()
                sign = -1.0
            factors.append((sign, self.power()))
        return factors[0][1] if len(factors) == 1 else Node("product", parts=tuple(factors))

    def power(self) -> Node:
        base = self.factor()
        if self.peek() != "^":
            return base
        self.next()
        return Node("power", parts=((1.0, base), (1.0, self.factor())))

    def factor(self) -> Node:
        word = self.next() if self.peek() else ""
        if word == "-":
            return Node(
                "product", parts=((1.0, Node("number", number=-1.0)), (1.0, self.product()))
            )
        if word == "(":
            inner = self.sum()
            if not self.peek() or self.next() != ")":
                raise Unread(word)
            return inner
        if word.startswith("{"):
            return Node("symbol", word.strip("{}"))
        if word[:1].isdigit():
            return Node("number", number=float(word))
        if word in NUMBERS:
            return Node("number", word, number=NUMBERS[word])
        if word in FUNCTIONS:
            return self.call(word)
        raise Unread(word)

    def call(self, name: str) -> Node:
        """Read the argument of a function; sin^2(x) is the square of sin(x)."""
        exponent = None
        if self.peek() == "^":
            self.next()
            exponent = self.factor()
        argument = self.factor()
        node = Node("call", name, ((1.0, argument),))
        return Node("power", parts=((1.0, node), (1.0, exponent))) if exponent else node


@cache
def read(template: str) -> tuple[Node, Node]:
    """Return the two sides of the formula of a law."""
    left, _, right = template.partition(" = ")
    sides = []
    for text in (left, right):
        reader = _Reader(text)
        sides.append(reader.sum())
        if reader.peek():
            raise Unread(template)
    return sides[0], sides[1]


# ---------------------------------------------------------------------------------------------
# Edits


@cache
def edits(template: str) -> tuple[Edit, ...]:
    """Return the edited formulas of a law; none if its formula is not a tree."""
    try:
        left, right = read(template)
    except (Unread, IndexError):
        return ()
    everywhere = [
        Edit("no function", name, _without(left, name), _without(right, name))
        for name in ("sin", "tan", "cos")
        if _count(left, name) + _count(right, name) > 1
    ]
    of_left = [Edit(name, what, node, right) for name, what, node in _edited(left)]
    of_right = [Edit(name, what, left, node) for name, what, node in _edited(right)]
    return (*of_right, *of_left, *everywhere)


def _count(node: Node, function: str) -> int:
    own = node.kind == "call" and node.name == function
    return own + sum(_count(part, function) for _, part in node.parts)


def _without(node: Node, function: str) -> Node:
    """Return a formula with a function left out wherever it is used."""
    parts = tuple((sign, _without(part, function)) for sign, part in node.parts)
    is_left_out = node.kind == "call" and node.name == function
    return parts[0][1] if is_left_out else node._replace(parts=parts)


def _edited(node: Node) -> Iterator[tuple[str, str, Node]]:
    """Yield the name of a mistake, what was edited, and the tree with the edit."""
    yield from _own(node)
    for k, (sign, part) in enumerate(node.parts):
        for name, what, other in _edited(part):
            parts = (*node.parts[:k], (sign, other), *node.parts[k + 1 :])
            yield name, what, node._replace(parts=parts)


def _own(node: Node) -> Iterator[tuple[str, str, Node]]:
    """Yield the edits of a part itself, not of what it is made of."""
    if node.kind == "call":
        for sibling in SIBLINGS.get(node.name, ()):
            if sibling:
                yield "sibling", f"{sibling}-for-{node.name}", node._replace(name=sibling)
            else:
                yield "no function", node.name, node.parts[0][1]
        if node.name == "sqrt" and (plain := _without_squares(node.parts[0][1])):
            yield "plain sum", "", plain
    elif node.kind == "power":
        (_, base), (_, exponent) = node.parts
        if _is_square(node):
            yield "not squared", _name(base), base
        elif exponent.kind != "number":
            yield "product for power", _name(exponent), Node("product", parts=node.parts)
    elif node.kind == "sum":
        yield from _terms(node)
    elif node.kind == "product":
        yield from _factors(node)


def _terms(node: Node) -> Iterator[tuple[str, str, Node]]:
    for k, (sign, part) in enumerate(node.parts):
        rest = node.parts[:k] + node.parts[k + 1 :]
        if k:
            turned = (*node.parts[:k], (-sign, part), *node.parts[k + 1 :])
            yield "other sign", _name(part), node._replace(parts=turned)
        is_one = len(rest) == 1 and rest[0][0] > 0
        yield "no term", _name(part), rest[0][1] if is_one else node._replace(parts=rest)


def _factors(node: Node) -> Iterator[tuple[str, str, Node]]:
    plain = [(sign, part.parts[0][1] if _is_square(part) else part) for sign, part in node.parts]
    if sum(_is_square(part) for _, part in node.parts) > 1:
        yield "not squared", _name(node), node._replace(parts=tuple(plain))
    for k, (sign, part) in enumerate(node.parts):
        if part.kind not in ("symbol", "number") or (part.kind == "number" and part.number == 1):
            continue
        others = node.parts[:k] + node.parts[k + 1 :]
        is_one = len(others) == 1 and others[0][0] > 0
        rest = others[0][1] if is_one else Node("product", parts=others)
        yield "no factor", _name(part), rest
        if part.kind == "symbol":
            turned = (*node.parts[:k], (-sign, part), *node.parts[k + 1 :])
            yield "inverted", _name(part), Node("product", parts=turned)


def _is_square(node: Node) -> bool:
    return node.kind == "power" and node.parts[1][1].number == 2


def _without_squares(node: Node) -> Node | None:
    """Return a sum of squares as the sum of its terms."""
    if node.kind != "sum" or any(part.kind != "power" for _, part in node.parts):
        return None
    return node._replace(parts=tuple((sign, part.parts[0][1]) for sign, part in node.parts))


def text(node: Node, is_part: bool = False) -> str:
    """Return a tree as a formula, with brackets if it is a part of another one that needs them."""
    if node.kind == "number":
        return node.name or f"{node.number:g}"
    if node.kind == "symbol":
        return f"{{{node.name}}}"
    if node.kind == "call":
        return f"{node.name}({text(node.parts[0][1])})"
    if node.kind == "power":
        (_, base), (_, exponent) = node.parts
        return f"{text(base, True)}^{text(exponent, True)}"
    written = ""
    for k, (sign, part) in enumerate(node.parts):
        link = (" + ", " - ") if node.kind == "sum" else (" ", " / ")
        inner = text(part, part.kind == "sum" or (sign < 0 and part.kind == "product"))
        if k or sign < 0:
            written += link[sign < 0]
        written += inner
    written = written.strip() or "1"
    if node.kind == "product" and written.startswith("/"):
        written = f"1 {written}"
    return f"({written})" if is_part else written


def _name(node: Node) -> str:
    """Return the name of a part: a number, a function, or its first symbol."""
    if node.kind == "number":
        return node.name or f"{node.number:g}"
    if node.kind in ("symbol", "call"):
        return node.name
    names = [name for _, part in node.parts if (name := _name(part))]
    return next((name for name in names if not name[0].isdigit()), "")


# ---------------------------------------------------------------------------------------------
# Solving

STEP, STEPS = 1.3, 16  # of the search for a root, on each side of the right value
HALVINGS = 44


def solve(edit: Edit, target: str, at: At) -> float:
    """Return the value of a symbol by an edited formula: of two roots the one near the right value.

    `at` has the right value of the target, too.
    """
    if edit.left.kind == "symbol" and edit.left.name == target:
        if target in edit.right.symbols():
            raise ValueError(target)
        return edit.right.at(at)
    right = at(target)

    def off(size: float) -> float:
        values = lambda name: size if name == target else at(name)  # noqa: E731
        return edit.left.at(values) - edit.right.at(values)

    return _root(off, right)


def _root(off: Callable[[float], float], start: float) -> float:
    """Return the root nearest to a positive start."""
    if start <= 0:
        raise ValueError("no positive start")
    first = off(start)
    ends = [(start, first), (start, first)]
    for _ in range(STEPS):
        for side, ratio in enumerate((STEP, 1 / STEP)):
            inner, before = ends[side]
            try:
                after = off(inner * ratio)
            except (ArithmeticError, ValueError):
                continue
            if before * after <= 0:
                return _between(off, (inner, before), inner * ratio)
            ends[side] = (inner * ratio, after)
    raise ValueError("no root")


def _between(off: Callable[[float], float], start: tuple[float, float], other: float) -> float:
    """Return the root between two values."""
    inner, sign = start
    for _ in range(HALVINGS):
        middle = (inner + other) / 2
        if off(middle) * sign > 0:
            inner = middle
        else:
            other = middle
    return (inner + other) / 2
