"""The grammar of numbers: a text to a float.

Nothing is evaluated: one pass over the text, one character at a time, bounded in length.

    NUMBER = [sign] TERM { ("*" | "/") TERM }        TERM = DECIMAL ["pi"] | "pi"
"""

import math

from radcalc.errors import NumberError, quote

MAX_LENGTH = 1000
SMALLEST = 2.2250738585072014e-308  # below it a float loses digits

DIGITS = "0123456789"
MINUS = "-\u2212"
SIGNS = "+" + MINUS


def read_number(text: str) -> tuple[float, int]:
    """Read the number that `text` starts with; return it and where it ends.

    Raises NumberError where no number starts, or where the number is one that people read
    in two ways (`1,5`, `1,000`), that radcalc does not read (`1_000`, `0x10`, `nan`), or
    that a float cannot hold.
    """
    if len(text) > MAX_LENGTH:
        raise NumberError(
            f"a text of {len(text)} characters is not a number",
            f"at most {MAX_LENGTH} characters are read",
        )
    at = 1 if text[:1] and text[0] in SIGNS else 0
    value, at = _term(text, at)
    while at + 1 < len(text) and text[at] in "*/" and _term_starts(text, at + 1):
        operator = text[at]
        right, at = _term(text, at + 1)
        if operator == "*":
            value *= right
        elif right == 0:
            raise NumberError(f"'{quote(text)}' divides by zero", "a number other than 0")
        else:
            value /= right
    _refuse_lookalikes(text, at)
    if math.isinf(value):
        raise NumberError(f"'{quote(text)}' is too large for a number", "less than 1.8e308")
    return (-value if text[0] in MINUS else value), at


def parse_number(text: str) -> float:
    """Read the whole of `text` as one number."""
    text = text.strip()
    value, end = read_number(text)
    if end != len(text):
        raise NumberError(f"'{quote(text)}' is not a number", "a number such as 1.5e3, 1/3 or 4pi")
    return value


def split_quantity(text: str) -> tuple[float, str]:
    """Cut '100 lx' into its number and the text of its unit (which may be empty)."""
    text = text.strip()
    value, end = read_number(text)
    return value, text[end:].strip()


def _term_starts(text: str, at: int) -> bool:
    if text[at] in DIGITS:
        return True
    return (text[at] == "." and text[at + 1 : at + 2] in tuple(DIGITS)) or _pi_ends(text, at) > at


def _pi_ends(text: str, at: int) -> int:
    """Where a pi that starts at `at` ends, or `at` where none does."""
    end = at + 2 if text.startswith("pi", at) else at + 1 if text.startswith("π", at) else at
    if text[end:] in ("sr", "rad"):  # 4pisr, as people write it
        return end
    return at if end < len(text) and (text[end].isalnum() or text[end] == "_") else end


def _term(text: str, at: int) -> tuple[float, int]:
    start = at
    while at < len(text) and text[at] in DIGITS:
        at += 1
    whole = at - start
    if at < len(text) and text[at] == ".":
        point = at
        at += 1
        while at < len(text) and text[at] in DIGITS:
            at += 1
        if whole + at - point - 1 == 0:
            at = point
    if at == start:
        end = _pi_ends(text, at)
        if end > at:
            return math.pi, end
        raise _not_a_number(text)
    mantissa = at
    if at + 1 < len(text) and text[at] in "eE":
        digits = at + 2 if text[at + 1] in SIGNS else at + 1
        if digits < len(text) and text[digits] in DIGITS:
            at = digits
            while at < len(text) and text[at] in DIGITS:
                at += 1
    value = float(text[start:at].replace("\u2212", "-"))
    if value < SMALLEST and text[start:mantissa].strip("0.") != "":
        raise NumberError(f"'{quote(text)}' is too small for a number", "more than 2.3e-308")
    end = _pi_ends(text, at)
    return (value * math.pi, end) if end > at else (value, at)


def _not_a_number(text: str) -> NumberError:
    word = text.lstrip(SIGNS).lower()
    if word.startswith(("nan", "inf")):
        return NumberError(f"'{quote(text)}' is not a number radcalc takes", "a finite number")
    if not text.strip():
        return NumberError("a number is missing", "a number such as 1.5e3, 1/3 or 4pi")
    if word[:1].isnumeric() and not word[0].isascii():
        return NumberError(f"'{quote(text)}' is not a number", "the digits 0 to 9")
    return NumberError(f"'{quote(text)}' is not a number", "a number such as 1.5e3, 1/3 or 4pi")


def _refuse_lookalikes(text: str, at: int) -> None:
    """Refuse what goes on, after the number, in a way that people read as a number."""
    rest = text[at : at + 2]
    if rest[:1] == "," and rest[1:] in tuple(DIGITS):
        group = text[at + 1 : at + 5]
        thousands = len(group) >= 3 and group[:3].isdigit() and not group[3:].isdigit()
        if text.count(",") == 1 and "." not in text:
            choices = text.replace(",", ".")
            choices = f"{text.replace(',', '')} or {choices}" if thousands else choices
        else:
            choices = text.replace(",", "")
        raise NumberError(f"'{quote(text)}' has a comma in its number", quote(choices))
    if rest[:1] == "_":
        raise NumberError(f"'{quote(text)}' is not a number", quote(text.replace("_", "")))
    if rest[:1] in ("x", "X") and text[:at].lstrip(SIGNS) == "0" and rest[1:].isalnum():
        raise NumberError(f"'{quote(text)}' is not a number", "decimal digits")
    if rest[:1].isnumeric():
        raise NumberError(f"'{quote(text)}' is not a number", "the digits 0 to 9")
