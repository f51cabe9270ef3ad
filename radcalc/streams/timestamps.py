"""Dates and times of day in logs, with an offset from UTC or without.

Ticks are whole nanoseconds: of a date since 1970, of a time of day since midnight.
"""

import re
from collections.abc import Iterable, Sequence
from contextlib import suppress
from datetime import date, datetime, time, timedelta
from functools import partial
from typing import NamedTuple

from radcalc import errors
from radcalc.errors import NumberError, add, mention, option, quote

SECOND = 10**9  # ticks
HOUR, DAY = 3600 * SECOND, 86400 * SECOND
EPOCH = datetime(1970, 1, 1)
FIRST_DAY = EPOCH.toordinal()
FIRST_YEAR, LAST_YEAR = 1000, 9000
# A date with its year behind: 1.6.2024, 06/01/2024, 01-Jun-2024, and 06/01/24.
YEAR_LAST = re.compile(r"(\d\d?)([-/.]) ?(\d\d?|[A-Za-z]{3,9})\2 ?(\d{4}|\d\d)(?!\d)", re.ASCII)
OFFSET = r"(?P<z>[Zz]|UTC|GMT|[-+\u2212]\d\d(?::?\d\d)?)"
UTC_AT_END = re.compile(" ?(?:UTC|GMT)$")
FRACTION = re.compile(r"(?:(?<=:\d\d:\d\d)|(?<=\d{6}))[.,](\d{1,9})\d*", re.ASCII)  # of a second
# begins with a date
STAMP = re.compile(
    r"\d{1,4}([-/.]) ?(?:\d\d?|[A-Za-z]{3,9})\1 ?\d{1,4}(?![\d.])"
    r"|\d{8}(?=T\d| \d{4}(?:\d\d)?(?!\d))|\d{4}-?W\d\d",
    re.ASCII,
)
IN_TITLE = re.compile(r"\b(?:GMT|UTC) ?(?P<z>[-+\u2212]\d\d?(?::?\d\d)?)?(?!\w)", re.IGNORECASE)
ORDER_IN_TITLE = re.compile(r"(mm?[-/.]dd?|dd?[-/.]mm?)[-/.]yyyy", re.IGNORECASE)
DIGITS_IN_TITLE = re.compile(r"(?<![a-z])(?:yy){1,2}mmdd(?:hh(?:mm(?:ss)?)?)?(?![a-z])", re.I)
OF_DWD = re.compile("mess_?datum", re.IGNORECASE)  # of the weather service of Germany
# Formats of times that are only digits, by their number; those with two digits of the year.
OF_DIGITS = {7: "%Y%j", 8: "%Y%m%d", 10: "%Y%m%d%H", 12: "%Y%m%d%H%M", 14: "%Y%m%d%H%M%S"}
SHORT = {6: "%y%m%d", 8: "%y%m%d%H", 10: "%y%m%d%H%M", 12: "%y%m%d%H%M%S"}
LIKELY = range(1990, 2030)  # years of a log, if its times are only digits
OF_DATES, OF_CLOCKS = "YymdjbB", "HIMSfpz"
# Digits of the parts of a format.
WIDTHS = {"Y": 4, "j": 3, **dict.fromkeys("ymdHIMS", 2)}
ADJACENT = re.compile("%[YymdjHIMS]%")  # parts without a mark between them
RUN = re.compile("(?:%[YymdjHIMS])+|%[fz]")
OF_12_HOURS = re.compile(r"(.*\d) ?([AP])\.?M\.?")
CLOCKS = ("%I:%M %p", "%I:%M:%S %p", "%H:%M", "%H:%M:%S")  # are read as ISO 8601, or nearly so
FORMATS = mention("{time-format=%d/%m/%Y %H:%M} or {time-format=%m/%d/%Y %H:%M}")
KNOWN = "2024-06-01T12:35:00, with Z, an offset or {time-zone}; or {time-format=%d.%m.%Y %H:%M}"


class Pattern(NamedTuple):
    """The notation of dates and times of day: the formats of each ("": ISO 8601).

    A mark divides the time of day from the date, whose own marks divide it into so many pieces, or
    the date has `width` digits; otherwise one format has both.  A date that several formats read
    is the same in all of them.
    """

    dates: tuple[str, ...] = ("",)
    clocks: str = ""
    mark: str = " "
    pieces: int = 1
    width: int = 0
    assumption: str = ""

    def parts(self, text: str) -> tuple[str, str]:
        if self.width:
            size = self.width + _width(self.clocks)
            text = text if self.dates[0][:2] == "%Y" else text.zfill(size)
            return text[: self.width], text[self.width if len(text) >= size else 0 :]
        if not self.mark:
            return text, text
        parts = text.split(self.mark)
        return self.mark.join(parts[: self.pieces]), self.mark.join(parts[self.pieces :])

    def day(self, text: str) -> int:
        """Return the tick of a day's midnight, as if in UTC."""
        text = text.strip()
        try:
            days = [*dict.fromkeys(_date(text, form) for form in self.dates)]
        except ValueError:
            raise NumberError(f"'{quote(text)}' is not a date", mention(KNOWN)) from None
        if days[1:]:
            problem = f"'{quote(text)}' is ambiguous: {' or '.join(map(str, days))}"
            raise NumberError(problem, [add("time-format", form) for form in self.dates])
        if not FIRST_YEAR <= days[0].year < LAST_YEAR:
            problem = f"'{quote(text)}' is in the year {days[0].year}"
            raise NumberError(problem, "a date of a log")
        return (days[0].toordinal() - FIRST_DAY) * DAY

    def clock(self, text: str) -> tuple[int, int | None]:
        """Return ticks since midnight, and the offset from UTC if there is one."""
        typed = text = text.strip()
        if not text:
            return 0, None
        fraction = 0
        if (self.mark or self.width) and (match := FRACTION.search(text)):
            text, fraction = FRACTION.sub("", text), int(match[1].ljust(9, "0"))
        text = _padded(text, self.clocks)
        is_end = text[:2] == "24" and self.clocks[:2] in ("", "%H")
        try:
            found = _time("00" + text[2:] if is_end else text, self.clocks)
            if is_end and (fraction or found.replace(tzinfo=None) != time()):
                raise ValueError
        except ValueError:
            problem = f"'{quote(typed)}' is not a time of day"
            raise NumberError(problem, mention(f"from 00:00 to 24:00; {KNOWN}")) from None
        seconds = (24 * is_end + found.hour) * 3600 + found.minute * 60 + found.second
        ticks = seconds * SECOND + found.microsecond * 1000 + fraction
        offset = found.utcoffset()
        return ticks, None if offset is None else round(offset.total_seconds()) * SECOND


def _date(text: str, form: str) -> date:
    """Return a date in a format, or in ISO 8601; raise ValueError for other texts."""
    if form:
        return _strptime(text, form).date()
    text = text.replace("/", "-").replace(".", "-")
    try:
        return date.fromisoformat(text)
    except ValueError:  # without zeros
        return _strptime(text, "%Y-%m-%d").date()


def _time(text: str, form: str) -> time:
    """Return a time of day in a format, or in ISO 8601 or 12 hours; ValueError for others."""
    if form:
        return _strptime(text, form).timetz()
    text = UTC_AT_END.sub("Z", text.upper().replace("\u2212", "-"))
    text = text.replace(" -", "-").replace(" +", "+")
    if match := OF_12_HOURS.fullmatch(text):
        text = match[1]
    if "." in text or "," in text:  # of 12.5, fromisoformat would make half a second
        raise ValueError
    found = time.fromisoformat("0" + text if text[1:2] in ("", ":") else text)
    if match and not 1 <= found.hour <= 12:
        raise ValueError
    return found.replace(hour=found.hour % 12 + 12 * (match[2] == "P")) if match else found


def _strptime(text: str, form: str) -> datetime:
    """Return the time in a format; raise ValueError for other texts."""
    if not text.isascii():  # digits of other scripts
        raise ValueError
    text = _padded(text, form)
    if "%b" in form:
        text = re.sub("([A-Za-z]{3})[A-Za-z]+", r"\1", text)
    if form.endswith("%z"):
        text = re.sub(r"([-+]\d\d)$", r"\g<1>00", re.sub("(?:UTC|GMT)$", "Z", text))
    found = datetime.strptime(text, form)
    if "%j" in form and "366" in text and found.timetuple().tm_yday == 1:  # of a shorter year
        raise ValueError
    return found


def _padded(text: str, form: str) -> str:
    """Return a text with the zeros that numbers of adjacent parts lack: 0105 for 105 by %H%M."""
    if not ADJACENT.search(form):
        return text
    widths = (_width(run) * (run[:2] != "%Y") for run in RUN.findall(form))
    return re.sub(r"\d+", lambda number: number[0].zfill(next(widths, 0)), text)


def _width(form: str) -> int:
    return sum(WIDTHS.get(letter, 0) for letter in re.findall("%(.)", form))


def looks_like_stamp(text: str, format_: str = "") -> bool:
    """Return whether a cell begins with a date, or has that format."""
    if not format_:
        return bool(STAMP.match(text))
    pattern = pattern_of_format(format_)
    with suppress(NumberError):
        return bool(pattern.day(pattern.parts(text)[0]))
    return False


def looks_like_clock(text: str) -> bool:
    """Return whether a cell is only a time of day."""
    with suppress(NumberError):
        return ":" in text and Pattern().clock(text)[0] >= 0
    return False


def pattern_of(text: str, title: str, others: Iterable[str] = ()) -> Pattern:
    """Return the notation of a stamp; the others of its log decide between day and month."""
    mark = "T" if re.match(r"[\dW-]*T", text) else " "
    with suppress(ValueError):
        if _date(text.partition(mark)[0], ""):
            return Pattern(mark=mark)
    parts = YEAR_LAST.match(text)
    if not parts or not (orders := _orders(parts)):
        raise NumberError(f"'{quote(text)}' is not a date and time", mention(KNOWN))
    joint = parts[2]
    if len(parts[4]) != 4:
        problem = f"'{quote(text)}' has a year of 2 digits, without a clear order"
        raise errors.ConditionError(problem, _ways(text, parts, orders))
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
            raise errors.ConditionError(problem, _ways(text, parts, orders))
        if len(orders) == 1:
            which = "day" if orders == ["dmY"] else "month"
            assumption = f"'{quote(parts[0])}' shows that the {which} is first"
    # 05/05/2018 alone so far has two orders: a date that shows the order later is refused
    forms = tuple([joint.join(f"%{part}" for part in order) for order in orders])
    return Pattern(forms, mark=mark, assumption=assumption)


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


def _ways(text: str, parts: re.Match[str], orders: Sequence[str]) -> list[errors.Try]:
    """Propose the formats of a stamp, one for each order of its date."""
    clock = text[parts.end() + 1 :]
    rest, zone = re.subn(f" ?{OFFSET}$", "", clock.strip())
    rest, fraction = FRACTION.subn("", rest)
    digits = ("%H",) if len(rest) < 3 else ("%H%M", "%H%M%S")
    form = next(filter(partial(_is_time, rest), (*CLOCKS, *digits)), "")
    clock = text[parts.end()] + form + ".%f" * fraction + "%z" * zone if form else ""
    return [
        add("time-format", parts[2].join(f"%{part}" for part in order) + clock) for order in orders
    ]


def _is_time(text: str, form: str) -> bool:
    with suppress(ValueError):
        _strptime(text, form)
        return True
    return False


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
        with suppress(errors.RadcalcError):
            day, clock = pattern.parts(text)
            pattern.clock(clock)
            if (EPOCH.year + pattern.day(day) // (365.2425 * DAY)) // 1 in LIKELY:
                found.append(form)
    return found, False


def pattern_of_format(text: str) -> Pattern:
    """Return the pattern of a strptime format, with date and time apart if the date is first."""
    _check_format(text)
    text = text.replace("%B", "%b")
    parts = re.fullmatch("((?:[^%]*%[Yymdjb%])+)([^%]*)(%[HIMSfpz].*)", text)
    if not parts:
        has_clock = {*re.findall("%(.)", text)} & {*OF_CLOCKS}
        return Pattern((text,), text, "") if has_clock else Pattern((text,), mark="\n")
    day, mark, clock = parts.groups()
    is_run = not mark and re.fullmatch("(?:%[Yymdj])+", day)
    if not (mark or is_run) or {*re.findall("%(.)", clock)} & {*OF_DATES}:
        return Pattern((text,), text, "")
    clock = re.sub("[.,]%f", "", clock)
    clock = "" if clock in CLOCKS else clock
    pieces = 1 + day.count(mark) if mark else 1
    return Pattern((day,), clock, mark, pieces, 0 if mark else _width(day))


def _check_format(text: str) -> None:
    """Refuse a format with an unknown part, one twice, an incomplete date, or a doubtful hour."""
    option_text = option("time-format", quote(text))
    directives = re.findall("%([^%])", text)
    letters = {*directives}
    if unknown := [letter for letter in directives if letter not in OF_DATES + OF_CLOCKS]:
        problem = f"{option_text} has %{quote(unknown[0])}, which is not supported"
        known = " ".join(f"%{letter}" for letter in OF_DATES + OF_CLOCKS)
        raise errors.ConditionError(problem, known)
    if len({*"".join(directives).replace("I", "H").replace("B", "b")}) < len(directives):
        raise errors.ConditionError(f"{option_text} has a part twice", "each part once")
    if not (letters & {*"Yy"} and ("j" in letters or ("d" in letters and letters & {*"mbB"}))):
        raise errors.ConditionError(f"{option_text} has no complete date", FORMATS)
    if ("I" in letters) != ("p" in letters):
        problem = f"{option_text} has %{'I' if 'I' in letters else 'p'} alone"
        raise errors.ConditionError(problem, "%H up to 23, or %I up to 12 with %p for AM and PM")


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
    sign = "+" if text[0] == "+" else "-"
    try:
        offset = time.fromisoformat(f"00:00{sign}{text[1:].zfill(2)}").utcoffset() or timedelta()
    except ValueError:
        raise NumberError(f"'{quote(text)}' is not an offset from UTC", "+02:00") from None
    return round(offset.total_seconds()) * SECOND
