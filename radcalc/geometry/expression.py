"""A function of direction, as a text: read by Python's own parser, and by nothing evaluated.

Only numbers, the names and functions below, + - * / ** and brackets are let through.
"""

import ast
import math
import warnings
from collections.abc import Callable
from typing import Any

import numpy

from radcalc.errors import ConditionError, RadcalcError, nearest, quote

NAMES = ("theta", "phi", "x", "y", "z")
CONSTANTS = {"pi": math.pi, "e": math.e, "deg": math.pi / 180}
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
    "log": (1, numpy.log),
    "log10": (1, numpy.log10),
    "sqrt": (1, numpy.sqrt),
    "abs": (1, numpy.abs),
    "min": (2, numpy.minimum),
    "max": (2, numpy.maximum),
}
OPERATORS: dict[type, Callable[..., Any]] = {
    ast.Add: numpy.add,
    ast.Sub: numpy.subtract,
    ast.Mult: numpy.multiply,
    ast.Div: numpy.true_divide,
    ast.Pow: numpy.power,
    ast.USub: numpy.negative,
    ast.UAdd: numpy.positive,
}
LONGEST, DEEPEST = 1000, 100  # characters, and brackets or operators within each other
EXAMPLE = "an expression such as '100*cos(theta)**10'"

Function = Callable[[dict[str, Any]], Any]


def read_expression(text: str) -> Function:
    """Read a text into a function of the arrays theta, phi, x, y, z."""
    if len(text) > LONGEST:
        raise ConditionError(f"the expression has {len(text)} characters", f"at most {LONGEST}")
    # ^ has no other meaning here; the minus may be the one that negative numbers are given
    source = text.strip().replace("^", "**").replace("\u2212", "-")
    if not source:
        raise ConditionError("the expression is empty", EXAMPLE)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            tree = ast.parse(source, mode="eval")
    except SyntaxError as error:
        column = f" at column {error.offset}" if error.offset else ""
        hint = EXAMPLE
        if "perhaps you forgot a comma" in str(error) or "invalid decimal" in str(error):
            hint = "a * between factors: 2*cos(theta)"
        raise ConditionError(f"'{quote(text)}' is not an expression{column}", hint) from None
    except (RecursionError, MemoryError, ValueError):
        raise ConditionError(f"'{quote(text)}' is not an expression", EXAMPLE) from None
    return _function(tree.body, DEEPEST)


def _function(node: ast.expr, depth: int) -> Function:
    """The function of one node; whatever is not listed here is refused."""
    if not depth:
        raise ConditionError("the expression is nested too deeply", f"at most {DEEPEST} levels")
    match node:
        case ast.Constant(value=int() | float() as value) if not isinstance(value, bool):
            try:
                number = float(value)
            except OverflowError:
                raise ConditionError("a number is too large", "less than 1e308") from None
            return lambda _: number
        case ast.Name(id=name) if name in NAMES:
            return lambda at: at[name]
        case ast.Name(id=name) if name in CONSTANTS:
            return lambda _: CONSTANTS[name]
        case ast.Name(id=name):
            raise _unknown(name)
        case ast.UnaryOp(op=op, operand=operand) if type(op) in OPERATORS:
            unary, one = OPERATORS[type(op)], _function(operand, depth - 1)
            return lambda at: unary(one(at))
        case ast.BinOp(left=left, op=op, right=right) if type(op) in OPERATORS:
            binary, a, b = (
                OPERATORS[type(op)],
                _function(left, depth - 1),
                _function(right, depth - 1),
            )
            return lambda at: binary(a(at), b(at))
        case ast.Call(func=ast.Name(id=name), args=args, keywords=[]):
            return _call(name, args, depth)
    raise ConditionError(
        f"'{quote(ast.unparse(node))}' cannot stand in an expression",
        "numbers, + - * / **, brackets, " + ", ".join((*NAMES, *CONSTANTS, *FUNCTIONS)),
    )


def _call(name: str, args: list[ast.expr], depth: int) -> Function:
    if name not in FUNCTIONS:
        raise _unknown(name)
    count, function = FUNCTIONS[name]
    if len(args) != count:
        raise ConditionError(
            f"{name}() takes {count} argument{'s' if count > 1 else ''}, not {len(args)}",
            f"{name}({', '.join(('theta', 'phi')[:count])})",
        )
    inner = [_function(arg, depth - 1) for arg in args]
    return lambda at: function(*(one(at) for one in inner))


def _unknown(name: str) -> RadcalcError:
    known = (*NAMES, *CONSTANTS, *FUNCTIONS)
    near = nearest(name, known)
    return ConditionError(
        f"'{quote(name)}' is not known in an expression", ", ".join(near or known)
    )
