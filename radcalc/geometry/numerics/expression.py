"""Functions of direction that a user types, such as ``100*cos(theta)**10``.

Python parses the text but never evaluates it: the syntax tree is turned into NumPy calls, and only
numbers, the names and functions below, + - * / **, comparisons and brackets are allowed.  Every
angle has a unit: ``30*deg`` or ``0.5*rad``; theta and phi have theirs.
"""

import ast
import math
import re
import warnings
from collections.abc import Callable
from sys import float_info
from typing import Any

import numpy

from radcalc import errors
from radcalc.errors import manual, quote
from radcalc.maths import limit
from radcalc.units.expressions import LOGARITHMS, NO_ANGLE, NOT_A_NUMBER, OF_ANGLES

ANGLES = ("theta", "phi", "deg", "rad")
INVERSES = ("asin", "acos", "atan", "atan2")
KEEPING = ("abs", "min", "max")  # the value has the unit of the arguments

Power = float | None  # of the unit of an angle; None, of 0 and pi, fits every sum and function


class Angles:
    """The powers of an angle's unit in the parts of an expression.

    Parameters
    ----------
    text, source : str
        The expression as typed, and as parsed.
    tree : ast.expr
        The expression, of allowed operations only.

    Raises
    ------
    ConditionError
        For a sine of a bare number, an exponential of an angle, or a sum or comparison of an angle
        and a bare number.

    Examples
    --------
    >>> Angles("cos(45)", "cos(45)", ast.parse("cos(45)", mode="eval").body)
    Traceback (most recent call last):
        ...
    radcalc.errors.ConditionError: 'cos(45)' has no angle in cos(45)
    try: cos(45*deg) or cos(45*rad)
    """

    def __init__(self, text: str, source: str, tree: ast.expr) -> None:
        self.text, self.source = text, source
        self.powers: dict[ast.AST, Power] = {}
        for node in reversed(list(ast.walk(tree))):  # parts before the whole, without recursion
            if isinstance(node, ast.expr):
                self.powers[node] = self._power(node)

    def _power(self, node: ast.expr) -> Power:
        """Return the power of the angle unit in a node, None for 0 and pi, which may have any."""
        match node:
            case ast.Constant(value=value):
                return 0.0 if value else None
            case ast.Name(id=name):
                return None if name == "pi" else float(name in ANGLES)
            case ast.UnaryOp(operand=operand):
                return self.powers[operand]
            case ast.Compare(left=left, comparators=others):
                self._same(node, [left, *others])
            case ast.Call(func=ast.Name(id=name), args=args):
                return self._of_call(name, args, node)
            case ast.BinOp(left=left, op=ast.Add() | ast.Sub(), right=right):
                return self._same(node, [left, right])
            case ast.BinOp(left=left, op=ast.Pow(), right=right):
                self._refuse_angle(right, right)
                return self._raised(self.powers[left], right)
            case ast.BinOp(left=left, op=op, right=right):
                a, b = self.powers[left], self.powers[right]
                sign = -1 if isinstance(op, ast.Div) else 1
                return None if a is None or b is None else a + sign * b
        return 0.0

    def _raised(self, power: Power, exponent: ast.expr) -> Power:
        match exponent:
            case ast.Constant(value=float() | int() as number):
                return power and power * number
            case ast.UnaryOp(op=ast.USub(), operand=ast.Constant(value=float() | int() as number)):
                return power and -power * number
        return power and None  # an exponent that varies

    def _of_call(self, name: str, args: list[ast.expr], node: ast.expr) -> Power:
        power = self._same(node, args)
        if name in KEEPING:
            return power
        if name == "sqrt":
            return power and power / 2
        if name in OF_ANGLES and power not in (1, None):
            raise self._wrong(
                NO_ANGLE, node, self._ways(args[0], 1 - (power or 0), f"{name}({{}})")
            )
        if name not in (*OF_ANGLES, "atan2"):
            self._refuse_angle(args[0], node)
        return float(name in INVERSES)

    def _same(self, node: ast.expr, parts: list[ast.expr]) -> Power:
        """Return the power that all parts have."""
        powers = {part: power for part in parts if (power := self.powers[part]) is not None}
        if len(set(powers.values())) < 2:
            return next(iter(powers.values()), None)
        part, *_, other = sorted(powers, key=lambda part: abs(powers[part]))
        mixed = "different powers of an angle" if powers[part] else "an angle and a bare number"
        ways = self._ways(part, powers[other] - powers[part])
        raise self._wrong(f"has {mixed} in {{}}", node, ways)

    def _refuse_angle(self, part: ast.expr, node: ast.expr) -> None:
        if power := self.powers[part]:
            wrong = NOT_A_NUMBER.format("angle (rad)", "{}")
            raise self._wrong(wrong, node, self._ways(part, -power))

    def _ways(self, part: ast.expr, missing: float, form: str = "{}") -> list[errors.Try]:
        """Propose a part with the missing power of an angle."""
        typed = text = self._part(part)
        if isinstance(part, ast.BinOp | ast.UnaryOp | ast.Compare):
            text = f"({text})"
        power = "" if abs(missing) == 1 else f"**{abs(missing):g}"
        sign = "*" if missing > 0 else "/"
        ways = [form.format(f"{text}{sign}{unit}{power}") for unit in ("deg", "rad")]
        return errors.corrections(form.format(typed), *ways)

    def _part(self, node: ast.expr) -> str:
        return self.source[node.col_offset : node.end_col_offset]

    def _wrong(self, problem: str, node: ast.expr, hint: list[errors.Try]) -> errors.ConditionError:
        problem = problem.format(quote(self._part(node)))
        return errors.ConditionError(f"'{quote(self.text)}' {problem}", hint)


NAMES = ("theta", "phi", "x", "y", "z")  # polar angle, azimuth [rad], unit vector [1]
CONSTANTS = {"pi": math.pi, "e": math.e, "deg": math.pi / 180, "rad": 1.0}  # 30*deg, 0.5*rad
FUNCTIONS: dict[str, tuple[int, Callable[..., Any]]] = {
    "sin": (1, numpy.sin),
    "cos": (1, numpy.cos),
    "tan": (1, numpy.tan),
    "asin": (1, numpy.arcsin),
    "acos": (1, numpy.arccos),
    "atan": (1, numpy.arctan),
    "atan2": (2, numpy.arctan2),
    "sinh": (1, numpy.sinh),
    "cosh": (1, numpy.cosh),
    "tanh": (1, numpy.tanh),
    "exp": (1, numpy.exp),
    "ln": (1, numpy.log),
    "log10": (1, numpy.log10),
    "log2": (1, numpy.log2),
    "sqrt": (1, numpy.sqrt),
    "abs": (1, numpy.abs),
    "min": (2, numpy.minimum),
    "max": (2, numpy.maximum),
}
UNITS = re.compile(r"(?<=[\d.])\s*(?=(?:deg|rad)\b)")  # where 45 deg has no sign
OPERATORS: dict[type, Callable[..., Any]] = {
    ast.Add: numpy.add,
    ast.Sub: numpy.subtract,
    ast.Mult: numpy.multiply,
    ast.Div: numpy.true_divide,
    ast.Pow: numpy.power,
    ast.USub: numpy.negative,
    ast.UAdd: numpy.positive,
}
COMPARISONS: dict[type, Callable[..., Any]] = {
    ast.Lt: numpy.less,
    ast.LtE: numpy.less_equal,
    ast.Gt: numpy.greater,
    ast.GtE: numpy.greater_equal,
}
CHEAP = ("abs", "min", "max", "sqrt")  # cost as much as an addition
COSTS = {"function": 10, "power": 30, "comparison": 5}  # [1] largest cost, in additions
EXAMPLE = "an expression such as '100*cos(theta)**10', with * between factors"
GREEK = {"θ": "theta", "ϑ": "theta", "φ": "phi", "ϕ": "phi", "π": "pi"}
SIGNS = {"^": "**", errors.MINUS: "-", "≤": "<=", "≥": ">=", "⩽": "<=", "⩾": ">="}
STEP = "a comparison by < <= > >=, as in (theta<30*deg)*100"
EQUALS = re.compile(r"(?<![<>])=|==")
# before a missing sign of multiplication: a number, a bracket, a name
FACTOR = re.compile(r"((?<![\w.])\d+\.?\d*(?:e[+-]?\d+)?|\)|\w(?= ))\s*(?=[a-zA-Zθφπ(]|(?<= )\d)")
LONGEST, DEEPEST = 1000, 400  # characters, and levels of nested brackets or operators
REFUSED = re.compile(r"[^\w\s.+*/(),<>=-]|_|\b0[xXoObB]|[^\x00-\x7f]")

Function = Callable[[dict[str, Any]], Any]
Interval = tuple[float, float]
SAMPLES, MOST_STEPS = 10_001, 50  # points at which comparisons are tested, changes of each


class Expression:
    """A function of direction, parsed from a text.

    Parameters
    ----------
    text : str
        The expression, of at most 1000 characters, in the names theta and phi [rad], x, y, z
        (components of the unit vector), the constants pi, e, deg and rad, and the functions in
        `FUNCTIONS`.  ``^`` is read as ``**``, the Greek letters for theta, phi and pi as names, and
        ``45 deg`` as ``45*deg``.
        A comparison by ``< <= > >=`` is 1 if it holds and 0 otherwise; it binds less tightly than
        arithmetic, and a chain (``10*deg < theta < 30*deg``) holds if all its comparisons do.

    Attributes
    ----------
    text : str
        The text as given.
    uses : set of str
        Those of theta, phi, x, y, z that the expression depends on.
    comparisons : list of str
        Texts of its comparisons.
    cost : int
        Approximate cost of a value, in additions.

    Raises
    ------
    ConditionError
        If the text is not an expression, contains an unknown name, an operation that is not
        allowed or an angle without a unit, or is too long or nested too deeply.

    Notes
    -----
    An instance is called with a dict from names to arrays, as by `over_directions` of
    `radcalc.geometry.numerics.cubature`.  Values outside a function's domain are NaN, not an error.

    Examples
    --------
    A spot of 100 cd along +z has 100/2^10 cd at 60 degrees from it:

    >>> import math
    >>> from radcalc.geometry.numerics.expression import Expression
    >>> spot = Expression("100*cos(theta)^10")
    >>> sorted(spot.uses)
    ['theta']
    >>> round(float(spot({"theta": math.radians(60)})), 9) == round(100 / 2**10, 9)
    True
    >>> Expression("__import__('os')")
    Traceback (most recent call last):
        ...
    radcalc.errors.ConditionError: '_' is not allowed in an expression
    try: an expression such as '100*cos(theta)**10', with * between factors
    """

    def __init__(self, text: str) -> None:
        self.text = text
        self.uses: set[str] = set()
        self.comparisons: list[str] = []
        self._steps: list[tuple[set[str], Function]] = []  # names in a comparison, and itself
        self.cost = 1
        self._source = _prepared(text)
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                tree = ast.parse(self._source, mode="eval")
        except SyntaxError as error:
            column = f" (see column {error.offset})" if (error.offset or 0) > 1 else ""
            problem = f"'{quote(text)}' is not an expression{column}"
            raise errors.ConditionError(problem, EXAMPLE, _mended(text)) from None
        except (RecursionError, MemoryError, ValueError):
            raise errors.ConditionError(f"'{quote(text)}' is not an expression", EXAMPLE) from None
        self._function = self._read(tree.body, DEEPEST)
        Angles(text, self._source, tree.body)

    def __call__(self, at: dict[str, Any]) -> Any:
        """Return values of the function.

        Parameters
        ----------
        at : dict of str to float or ndarray
            Values of at least the names in `uses`; arrays are broadcast together.

        Returns
        -------
        float or ndarray
            The function's values; a number if the expression contains none of the names.
        """
        return self._function(at)

    @property
    def is_axial(self) -> bool:
        """Return whether the function is the same at every azimuth."""
        return self.uses <= {"theta", "z"}

    def _read(self, node: ast.expr, depth: int) -> Function:
        """Return a node as a function of the coordinates; refuse all but arithmetic."""
        if not depth:
            raise errors.ConditionError(
                "the expression is nested too deeply", f"at most {DEEPEST} levels"
            )
        match node:
            case ast.Constant(value=int() | float() as value) if not isinstance(value, bool):
                number = _finite(value)
                return lambda _: number
            case ast.Name(id=name) if name in NAMES:
                self.uses.add(name)
                return lambda at: at[name]
            case ast.Name(id=name) if name in CONSTANTS:
                return lambda _: CONSTANTS[name]
            case ast.Name(id=name):
                raise _unknown(name)
            case ast.UnaryOp(op=op, operand=operand) if type(op) in OPERATORS:
                self.cost += 1
                unary, side = OPERATORS[type(op)], self._read(operand, depth - 1)
                return lambda at: unary(side(at))
            case ast.BinOp(left=left, op=op, right=right) if type(op) in OPERATORS:
                self.cost += COSTS["power"] if isinstance(op, ast.Pow) else 1
                binary = OPERATORS[type(op)]
                a, b = self._read(left, depth - 1), self._read(right, depth - 1)
                return lambda at: binary(a(at), b(at))
            case ast.Call(func=ast.Name(id=name), args=args, keywords=[]):
                return self._call(name, args, depth)
            case ast.Compare(ops=ops) if all(type(op) in COMPARISONS for op in ops):
                return self._compare(node, depth)
            case ast.BoolOp(op=op, values=values):
                hint = "a product of comparisons for both, (x<1)*(y<0); max(a, b) for either"
                parts = [f"({self._part(value)})" for value in values]
                both = [errors.correct(self._part(node), "*".join(parts))] * isinstance(op, ast.And)
                raise errors.ConditionError(
                    "'and' and 'or' is not allowed in an expression", hint, both
                )
        part = self._part(node)
        raise errors.ConditionError(
            f"'{quote(part)}' is not allowed in an expression",
            "numbers, + - * / **, comparisons, brackets, "
            + ", ".join((*NAMES, *CONSTANTS, *FUNCTIONS)),
            [errors.correct(part, part.partition(".")[0])]
            if isinstance(node, ast.Attribute)
            else (),
        )

    def _part(self, node: ast.expr) -> str:
        return self._source[node.col_offset : node.end_col_offset]

    def _compare(self, node: ast.Compare, depth: int) -> Function:
        """Return a function that is 1 if all comparisons of a chain hold, else 0; NaN gives NaN."""
        self.comparisons.append(self._part(node))
        self.cost += COSTS["comparison"] * len(node.ops)
        tests = [COMPARISONS[type(op)] for op in node.ops]
        outside, self.uses = self.uses, set()
        sides = [self._read(side, depth - 1) for side in (node.left, *node.comparators)]
        inside, self.uses = self.uses, outside | self.uses

        def holds(at: dict[str, Any]) -> Any:
            values = [side(at) for side in sides]
            truth: Any = 1.0
            for test, a, b in zip(tests, values, values[1:], strict=False):
                nowhere = numpy.isnan(a) | numpy.isnan(b)
                truth = truth * numpy.where(nowhere, math.nan, test(a, b))
            return truth

        self._steps.append((inside, holds))
        return holds

    def steps(self, polar: Interval, azimuth: Interval) -> tuple[list[float], list[float]]:
        """Return the polar angles and azimuths at which comparisons of one angle change.

        Parameters
        ----------
        polar, azimuth : tuple of 2 floats [rad]
            Intervals of the angles.

        Returns
        -------
        tuple of 2 lists of float [rad]
            The angles, in the form that `over_directions` takes.  The list is incomplete for a
            comparison that changes more than 50 times, or twice within a 10 000th of the interval.

        Examples
        --------
        >>> import math
        >>> from radcalc.geometry.numerics.expression import Expression
        >>> step = Expression("(z > 0.5)*(phi < 1*rad)*(x < y)")
        >>> [[round(x, 12) for x in of] for of in step.steps((0, math.pi), (0, 2 * math.pi))]
        [[1.047197551197], [1.0]]
        """
        angles: tuple[list[float], list[float]] = ([], [])
        for uses, holds in self._steps:
            if uses and uses <= {"theta", "z"}:
                angles[0].extend(_changes(_along_theta(holds), polar))
            elif uses == {"phi"}:
                angles[1].extend(_changes(_along_phi(holds), azimuth))
        return angles

    def _call(self, name: str, args: list[ast.expr], depth: int) -> Function:
        """Return a call of a known function with the right number of arguments."""
        if name in LOGARITHMS:
            meant = [f"{other}({', '.join(map(self._part, args))})" for other in LOGARITHMS[name]]
            raise errors.ConditionError(
                f"unknown function '{name}' in '{quote(self.text)}'", quote(" or ".join(meant))
            )
        if name not in FUNCTIONS:
            raise _unknown(name)
        count, function = FUNCTIONS[name]
        if len(args) != count:
            raise errors.ConditionError(
                f"{name}() takes {count} argument{'s' if count > 1 else ''}, not {len(args)}",
                f"{name}({', '.join(('theta', 'phi')[:count])})",
                self._shorter(name, args, count),
            )
        self.cost += 1 if name in CHEAP else COSTS["function"]
        inner = [self._read(arg, depth - 1) for arg in args]
        return lambda at: function(*(argument(at) for argument in inner))

    def _shorter(self, name: str, args: list[ast.expr], count: int) -> list[errors.Try]:
        """Propose a call of a function without the arguments that are too many."""
        if len(args) <= count:
            return []
        parts = [self._part(arg) for arg in args]
        whole = self._source[: args[-1].end_col_offset]
        typed = whole[whole.rindex(f"{name}", 0, args[0].col_offset) :]
        return [errors.correct(f"{typed})", f"{name}({', '.join(parts[:count])})")]


def _along_theta(function: Function) -> Callable[[Any], Any]:
    return lambda theta: function({"theta": theta, "z": numpy.cos(theta)})


def _along_phi(function: Function) -> Callable[[Any], Any]:
    return lambda phi: function({"phi": phi})


def _changes(function: Callable[[Any], Any], interval: Interval) -> list[float]:
    """Return the values at which a function that is 1 or 0 changes, to the last digit."""
    at = numpy.linspace(*interval, SAMPLES)
    with numpy.errstate(all="ignore"):
        values = numpy.broadcast_to(function(at), at.shape)
        after = numpy.flatnonzero(values[1:] != values[:-1])
        if len(after) > MOST_STEPS:
            return []
        return [_last(function, values[i], at[i], at[i + 1]) for i in after]


def _last(function: Callable[[Any], Any], value: float, low: float, high: float) -> float:
    return limit(lambda x: bool(function(x) == value), float(high), float(low))


def _prepared(text: str) -> str:
    """Return the text in Python's syntax, with usual letters and signs replaced."""
    if len(text) > LONGEST:
        raise errors.ConditionError(
            f"the expression has {len(text)} characters", f"at most {LONGEST}"
        )
    source = text.strip()
    for letter, name in (GREEK | SIGNS).items():
        source = source.replace(letter, name)
    source = UNITS.sub("*", source)
    if not source:
        raise errors.ConditionError("the expression is empty", EXAMPLE)
    if match := REFUSED.search(source):
        raise errors.ConditionError(f"'{quote(match[0])}' is not allowed in an expression", EXAMPLE)
    if "+-" in source:  # the sign of an uncertainty in other inputs
        raise errors.ConditionError(
            "'+-' is not allowed in an expression, which takes no uncertainties",
            errors.correct("+-", "-"),
        )
    if match := EQUALS.search(source):
        raise errors.ConditionError(
            f"'{match[0]}' is not allowed in an expression: numbers are equal on no part of the "
            "sphere",
            STEP,
        )
    return source


def _mended(text: str) -> list[errors.Try]:
    """Propose a text with the signs of multiplication and the brackets that it lacks."""
    mended = FACTOR.sub(r"\1*", text)
    mended += ")" * (mended.count("(") - mended.count(")"))
    return [errors.correct(text, mended)] if mended != text else []


def _finite(value: float) -> float:
    """Convert a number; Python's parser reads integers of any size."""
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    if number == math.inf:
        raise errors.ConditionError("a number in the expression is too large", "less than 1e308")
    if 0 < number < float_info.min:
        raise errors.ConditionError("a number in the expression is too small", "more than 2.3e-308")
    return number


def _unknown(name: str) -> errors.RadcalcError:
    near = errors.nearest(name, (*NAMES, *CONSTANTS, *FUNCTIONS), cutoff=0.7)
    message = f"unknown name '{quote(name)}' in the expression"
    names = f"{', '.join(NAMES)} (see {manual('integrate')})"
    return errors.ConditionError(message, errors.corrections(name, *near) or names)
