"""The rule that every angle of an expression has a unit: theta and phi have theirs."""

import ast

from radcalc.errors import ConditionError, Try, corrections, quote
from radcalc.units.expressions import NO_ANGLE, NOT_A_NUMBER, OF_ANGLES

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

    def _ways(self, part: ast.expr, missing: float, form: str = "{}") -> list[Try]:
        """Propose a part with the missing power of an angle."""
        typed = text = self._part(part)
        if isinstance(part, ast.BinOp | ast.UnaryOp | ast.Compare):
            text = f"({text})"
        power = "" if abs(missing) == 1 else f"**{abs(missing):g}"
        sign = "*" if missing > 0 else "/"
        ways = [form.format(f"{text}{sign}{unit}{power}") for unit in ("deg", "rad")]
        return corrections(form.format(typed), *ways)

    def _part(self, node: ast.expr) -> str:
        return self.source[node.col_offset : node.end_col_offset]

    def _wrong(self, problem: str, node: ast.expr, hint: list[Try]) -> ConditionError:
        problem = problem.format(quote(self._part(node)))
        return ConditionError(f"'{quote(self.text)}' {problem}", hint)
