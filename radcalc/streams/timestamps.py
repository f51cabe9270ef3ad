"""Dates and times of day in logs, with an offset from UTC or without.

Ticks are whole nanoseconds: of a date since 1970, of a time of day since midnight.
"""

import re
from collections.abc import Iterable, Sequence
from contextlib import suppress
from datetime import date, datetime
from typing import NamedTuple

from radcalc.errors import (
    ConditionError,
    NumberError,
    RadcalcError,
    Try,
    add,
    mention,
    option,
    quote,
)

SECOND = 10**9  # ticks
HOUR, DAY = 3600 * SECOND, 86400 * SECOND
EPOCH = datetime(1970, 1, 1)
FIRST_DAY = EPOCH.toordinal()
FIRST_YEAR, LAST_YEAR = 1000, 9000
YEAR_FIRST = r"(?P<Y>\d{4})(?P<x>[-/.])(?P<m>\d\d?)(?P=x)(?P<d>\d\d?)|"
YEAR_FIRST += r"(?P<Y2>\d{4})(?P<m2>\d\d)(?P<d2>\d\d)"
WEEK = r"\d{4}-?W\d\d(?:-?\d)?"
# A date with its year behind: 1.6.2024, 06/01/2024, 01-Jun-2024, and 06/01/24.
YEAR_LAST = re.compile(r"(\d\d?)([-/.]) ?(\d\d?|[A-Za-z]{3,9})\2 ?(\d{4}|\d\d)(?!\d)", re.ASCII)
TIME_OF_DAY = (
    r"(?P<H>\d\d?):(?P<M>\d\d)(?::(?P<S>\d\d)(?:[.,](?P<f>\d{1,9})\d*)?)?"
    r"(?: ?(?P<p>[AaPp])\.?[Mm]\.?)?"
    r"|(?P<H2>\d\d)(?P<M2>\d\d)(?P<S2>\d\d)?"
)
OFFSET = r"(?P<z>[Zz]|UTC|GMT|[-+\u2212]\d\d(?::?\d\d)?)"
CLOCK = re.compile(rf"(?:{TIME_OF_DAY}) ?{OFFSET}?", re.ASCII)  # only ASCII digits
# begins with a date
STAMP = re.compile(
    r"\d{1,4}([-/.]) ?(?:\d\d?|[A-Za-z]{3,9})\1 ?\d{1,4}(?![\d.])"
    r"|\d{8}(?=T\d| \d{4}(?:\d\d)?(?!\d))|\d{4}-?W\d\d",
    re.ASCII,
)
TIME_ALONE = re.compile(r"\d\d?:\d\d(:\d\d)?([.,]\d+)?( ?[AaPp]\.?[Mm]\.?)?", re.ASCII)
IN_TITLE = re.compile(r"\b(?:GMT|UTC) ?(?P<z>[-+\u2212]\d\d?(?::?\d\d)?)?(?!\w)", re.IGNORECASE)
ORDER_IN_TITLE = re.compile(r"(mm?[-/.]dd?|dd?[-/.]mm?)[-/.]yyyy", re.IGNORECASE)
DIGITS_IN_TITLE = re.compile(r"(?<![a-z])(?:yy){1,2}mmdd(?:hh(?:mm(?:ss)?)?)?(?![a-z])", re.I)
OF_DWD = re.compile("mess_?datum", re.IGNORECASE)  # of the weather service of Germany
# Formats of times that are only digits, by their number; those with two digits of the year.
OF_DIGITS = {7: "%Y%j", 8: "%Y%m%d", 10: "%Y%m%d%H", 12: "%Y%m%d%H%M", 14: "%Y%m%d%H%M%S"}
SHORT = {6: "%y%m%d", 8: "%y%m%d%H", 10: "%y%m%d%H%M", 12: "%y%m%d%H%M%S"}
LIKELY = range(1990, 2030)  # years of a log, if its times are only digits
# Parts of a format, as in strptime; the first letter of a group is that of its part.
DIRECTIVES = {
    "Y": r"(?P<Y>\d{4})",
    "y": r"(?P<y>\d\d)",
    "m": r"(?P<m>\d\d?)",
    "d": r"(?P<d>\d\d?)",
    "j": r"(?P<j>\d{1,3})",
    "H": r"(?P<H>\d\d?)",
    "I": r"(?P<H>\d\d?)",
    "M": r"(?P<M>\d\d?)",
    "S": r"(?P<S>\d\d?)",
    "f": r"(?P<f>\d{1,9})",
    "p": r"(?P<p>[AaPp])\.?[Mm]\.?",
    "z": OFFSET,
    "b": r"(?P<b>[A-Za-z]{3,9})",
    "B": r"(?P<b>[A-Za-z]{3,9})",
    "%": "%",
}
WIDTHS = {"Y": 4, "j": 3, **dict.fromkeys("ymdHIMS", 2)}  # digits, with zeros before them
RUN = re.compile("((?:%[YymdjHIMS]){2,})")  # parts without a mark between them
MONTHS = ("jan", "feb", "mar", "apr", "may", "jun", "jul", "aug", "sep", "oct", "nov", "dec")
OF_DATES, OF_CLOCKS = "YymdjbB", "HIMSfpz"
FORMATS = mention("{time-format=%d/%m/%Y %H:%M} or {time-format=%m/%d/%Y %H:%M}")
KNOWN = "2024-06-01T12:35:00, with Z, an offset or {time-zone}; or {time-format=%d.%m.%Y %H:%M}"


class Pattern(NamedTuple):
    """The notation of dates and times of day: a pattern of each, and the mark between them.

    Without a mark, one pattern has both.
    """

    dates: re.Pattern[str] | None
    clocks: re.Pattern[str] | None
    mark: str
    assumption: str

    def parts(self, text: str) -> tuple[str, str]:
        if not self.mark:
            return text, text
        day, _, clock = text.partition(self.mark)
        return day, clock

    def begins(self, text: str) -> bool:
        """Return whether a text begins with a date of this form, even an impossible one."""
        assert self.dates is not None
        return bool(self.dates.fullmatch(self.parts(text)[0].strip()))

    def day(self, text: str) -> int:
        """Return the tick of a day's midnight, as if in UTC."""
        assert self.dates is not None
        match = self.dates.fullmatch(text.strip())
        if not match:
            raise _no_stamp(text)
        parts = {key[0]: part for key, part in match.groupdict().items() if part}
        if "W" in parts:
            return _of_week(text.strip())
        year = int(parts["Y"]) if "Y" in parts else _year_of_two_digits(int(parts["y"]))
        if not FIRST_YEAR <= year < LAST_YEAR:
            raise NumberError(f"'{quote(text)}' is in the year {year}", "a date of a log")
        try:
            if "j" in parts:
                ordinal = date(year, 1, 1).toordinal() + int(parts["j"]) - 1
                if date.fromordinal(ordinal).year != year:
                    raise ValueError
            else:
                month = (
                    int(parts["m"]) if "m" in parts else MONTHS.index(parts["b"][:3].lower()) + 1
                )
                ordinal = date(year, month, int(parts["d"])).toordinal()
        except (ValueError, OverflowError):
            raise NumberError(f"'{quote(text)}' is not a day of the calendar", "a date") from None
        return (ordinal - FIRST_DAY) * DAY

    def clock(self, text: str) -> tuple[int, int | None]:
        """Return ticks since midnight, and the offset from UTC if there is one."""
        text = text.strip()
        if not text:
            return 0, None
        match = (self.clocks or CLOCK).fullmatch(text)
        if not match:
            raise _no_stamp(text)
        parts = {key[0]: part for key, part in match.groupdict().items() if part}
        hour, minute, second = (int(parts.get(key, 0)) for key in "HMS")
        if "p" in parts:
            if not 1 <= hour <= 12:
                raise NumberError(f"'{quote(text)}' is not a time of day", "12:35 PM")
            hour = hour % 12 + (12 if parts["p"] in "pP" else 0)
        fraction = int(parts.get("f", "").ljust(9, "0"))
        is_end = (hour, minute, second, fraction) == (24, 0, 0, 0)
        if (hour > 23 or minute > 59 or second > 59) and not is_end:
            raise NumberError(f"'{quote(text)}' is not a time of day", "from 00:00 to 24:00")
        ticks = hour * HOUR + (minute * 60 + second) * SECOND + fraction
        return ticks, read_offset(parts["z"]) if "z" in parts else None


def looks_like_stamp(text: str, format_: str = "") -> bool:
    """Return whether a cell begins with a date, or has that format."""
    return pattern_of_format(format_).begins(text) if format_ else bool(STAMP.match(text))


def looks_like_clock(text: str) -> bool:
    """Return whether a cell is only a time of day."""
    return bool(TIME_ALONE.fullmatch(text))


def pattern_of(text: str, title: str, others: Iterable[str] = ()) -> Pattern:
    """Return the notation of a stamp; the others of its log decide between day and month."""
    mark = "T" if re.match(r"[\dW-]*T", text) else " "
    day = text.partition(mark)[0]
    if re.fullmatch(f"{YEAR_FIRST}|{WEEK}", day):
        return Pattern(re.compile(f"{YEAR_FIRST}|(?P<W>{WEEK})", re.ASCII), None, mark, "")
    parts = YEAR_LAST.match(text)
    if not parts or not (orders := _orders(parts)):
        raise _no_stamp(text)
    joint = parts[2]
    if len(parts[4]) != 4:
        problem = f"'{quote(text)}' has a year of 2 digits, without a clear order"
        raise ConditionError(problem, _ways(text, parts, orders))
    assumption = ""
    if order := ORDER_IN_TITLE.search(title.replace("_", " ")):
        orders = ["dmY" if order[1][:1] in "dD" else "mdY"]
        assumption = f"the dates are {order[0]}, as the title has it"
    elif joint == "." and "m" in orders[0]:
        assumption = "dates with points have the day first"
    elif "m" in orders[0]:
        parts, orders = _decided(parts, orders, others)
        if len(readings := _readings(parts, orders)) > 1:
            problem = f"'{quote(parts[0])}' is ambiguous: {' or '.join(readings)}"
            raise ConditionError(problem, _ways(text, parts, orders))
        if len(orders) == 1:
            which = "day" if orders == ["dmY"] else "month"
            assumption = f"'{quote(parts[0])}' shows that the {which} is first"
    fields = [DIRECTIVES[part] for part in orders[0]]
    if len(orders) > 1:  # 05/05/2018 alone so far: a date that shows the order later is refused
        fields[1] = r"(?P<m>(?P=d))"
    form = f"{re.escape(joint)} ?".join(fields)
    return Pattern(re.compile(form, re.ASCII), None, mark, assumption)


def _orders(date_parts: re.Match[str]) -> list[str]:
    """Return the orders of day, month and year that a date may have, as parts of a format."""
    first, joint, second, last = date_parts.groups()
    year = "Y" if len(last) == 4 else "y"
    if second.isalpha():
        return [f"db{year}"]
    orders = [f"dm{year}", f"md{year}", "ymd"]
    if year == "Y":
        orders = orders[: 1 if joint == "." else 2]
    limits = {"d": 31, "m": 12, "y": 99, "Y": LAST_YEAR}
    numbers = int(first), int(second), int(last)
    return [
        order
        for order in orders
        if all(n <= limits[part] for part, n in zip(order, numbers, strict=True))
    ]


def _decided(
    first: re.Match[str], orders: list[str], others: Iterable[str]
) -> tuple[re.Match[str], list[str]]:
    """Return the date that shows the order of all, and the order.

    Without such a date, return one with several readings, or any if none has.
    """
    doubtful = first
    for parts in filter(None, map(YEAR_LAST.match, others)):
        if len(orders) == 1:
            break
        orders = [order for order in orders if order in _orders(parts)] or orders
        if len(orders) == 1 or len(_readings(doubtful, orders)) < 2:
            doubtful = parts
    return doubtful, orders


def _readings(parts: re.Match[str], orders: Sequence[str]) -> list[str]:
    """Return the different days that a date may be, in ISO 8601."""
    named = [dict(zip(order, (parts[1], parts[3], parts[4]), strict=True)) for order in orders]
    return [*dict.fromkeys(f"{of['Y']}-{of['m']:>02}-{of['d']:>02}" for of in named)]


def _ways(text: str, parts: re.Match[str], orders: Sequence[str]) -> list[Try]:
    """Propose the formats of a stamp, one for each order of its date."""
    clock = ""
    if match := CLOCK.fullmatch(text[parts.end() + 1 :]):
        colon = "" if match["H2"] else ":"
        found = match["H2"] or match["H"], match["M2"] or match["M"], match["S2"] or match["S"]
        names = ("%I" if match["p"] else "%H", "%M", "%S")
        clock = text[parts.end()] + colon.join(
            name for name, digits in zip(names, found, strict=True) if digits
        )
        clock += (".%f" if match["f"] else "") + (" %p" if match["p"] else "")
        clock += "%z" if match["z"] else ""
    return [
        add("time-format", parts[2].join(f"%{part}" for part in order) + clock) for order in orders
    ]


def formats_of_digits(text: str, title: str) -> tuple[list[str], bool]:
    """Return formats of a time of digits, and whether the title has one.

    The format is that of the title, as of YYYYMMDDHH; else all that give a date of a log.
    """
    if OF_DWD.search(title):
        return [OF_DIGITS[len(text)]] if len(text) in OF_DIGITS else [], True
    if stated := DIGITS_IN_TITLE.search(title.replace("_", " ")):
        known = OF_DIGITS if stated[0].lower().startswith("yyyy") else SHORT
        return [known[len(text)]] if len(text) == len(stated[0]) else [], True
    found = []
    for form in filter(None, (OF_DIGITS.get(len(text)), SHORT.get(len(text)))):
        pattern = pattern_of_format(form)
        with suppress(RadcalcError):
            if pattern.clocks:
                pattern.clock(text)
            if (EPOCH.year + pattern.day(text) // (365.2425 * DAY)) // 1 in LIKELY:
                found.append(form)
    return found, False


def pattern_of_format(text: str) -> Pattern:
    """Return the pattern of a strptime format, with date and time apart at a blank or T."""
    _check_format(text)
    for mark in (" ", "T"):
        day, _, clock = text.partition(mark)
        directives = re.findall("%(.)", day), re.findall("%(.)", clock)
        are_apart = {*directives[0]} <= {*OF_DATES} and {*directives[1]} <= {*OF_CLOCKS}
        if clock and are_apart:
            return Pattern(_compiled(day), _compiled(clock), mark, "")
    pattern = _compiled(text)
    has_clock = {*re.findall("%(.)", text)} & {*OF_CLOCKS}
    return Pattern(pattern, pattern, "", "") if has_clock else Pattern(pattern, None, "\n", "")


def _check_format(text: str) -> None:
    """Refuse a format with an unknown part, one twice, an incomplete date, or a doubtful hour."""
    option_text = option("time-format", quote(text))
    letters = {*(directives := re.findall("%(.)", text))}
    if unknown := [letter for letter in directives if letter not in DIRECTIVES]:
        problem = f"{option_text} has %{quote(unknown[0])}, which is not supported"
        raise ConditionError(
            problem, " ".join(f"%{letter}" for letter in DIRECTIVES if letter != "%")
        )
    meant = [DIRECTIVES[letter] for letter in directives if letter != "%"]
    if len({*meant}) < len(meant):
        raise ConditionError(f"{option_text} has a part twice", "each part once")
    if not (letters & {*"Yy"} and ("j" in letters or ("d" in letters and letters & {*"mbB"}))):
        raise ConditionError(f"{option_text} has no complete date", FORMATS)
    if ("I" in letters) != ("p" in letters):
        problem = f"{option_text} has %{'I' if 'I' in letters else 'p'} alone"
        raise ConditionError(problem, "%H up to 23, or %I up to 12 with %p for AM and PM")


def _year_of_two_digits(year: int) -> int:
    """Return the year by POSIX: 69 is 1969, and 68 is 2068."""
    return year + (1900 if year >= 69 else 2000)


def _of_week(text: str) -> int:
    """Return the tick of the midnight of a day of a week, 2024-W22-6, or of the week's Monday."""
    try:
        return (date.fromisoformat(text).toordinal() - FIRST_DAY) * DAY
    except ValueError:
        raise NumberError(f"'{quote(text)}' is not a day of the calendar", "a date") from None


def _compiled(part: str) -> re.Pattern[str]:
    """Return the pattern of a format; digits without a mark between them have their full width.

    Zeros at their start may be missing: 105 is 01:05 by %H%M.
    """
    form = ""
    for k, text in enumerate(RUN.split(part)):
        if k % 2:
            form += f"(?:{'|'.join(_ways_of_run(text.replace('%', '')))})"
            continue
        pieces = re.split("%(.)", text)
        form += "".join(
            DIRECTIVES[piece] if n % 2 else re.escape(piece) for n, piece in enumerate(pieces)
        )
    return re.compile(form, re.ASCII)


def _ways_of_run(letters: str) -> list[str]:
    """Return the patterns of parts without a mark: all, and of clocks those without the first."""
    first_parts = range(len(letters) if {*letters} <= {*"HMS"} else 1)
    return [
        "".join(
            rf"(?P<{letter.replace('I', 'H')}{first}>\d"
            rf"{{{1 if k == first and letter not in 'Yj' else WIDTHS[letter]},{WIDTHS[letter]}}})"
            for k, letter in enumerate(letters)
            if k >= first
        )
        for first in first_parts
    ]


def offset_in(title: str) -> int | None:
    """Return the offset in a title: Date Time, GMT-05:00."""
    match = IN_TITLE.search(title.replace("_", " "))
    if not match:
        return None
    return read_offset(match["z"]) if match["z"] else 0


def read_offset(text: str) -> int:
    """Read an offset from UTC, in ticks."""
    if not text[1:2].isdigit():
        return 0
    digits = text[1:].replace(":", "")
    hours, minutes = int(digits[:-2] if len(digits) > 2 else digits), 0
    if len(digits) > 2:
        minutes = int(digits[-2:])
    if hours > 23 or minutes > 59:
        raise NumberError(f"'{quote(text)}' is not an offset from UTC", "+02:00")
    ticks = hours * HOUR + minutes * 60 * SECOND
    return ticks if text[0] == "+" else -ticks


def _no_stamp(text: str) -> NumberError:
    return NumberError(f"'{quote(text)}' is not a date and time", mention(KNOWN))
