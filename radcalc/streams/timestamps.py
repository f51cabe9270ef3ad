"""Dates and times of day in logs, with an offset from UTC or without.

Ticks are whole nanoseconds: of a date since 1970, of a time of day since midnight.
"""

import re
from datetime import date, datetime
from typing import NamedTuple

from radcalc.errors import ConditionError, NumberError, mention, option, quote

SECOND = 10**9  # ticks
HOUR, DAY = 3600 * SECOND, 86400 * SECOND
EPOCH = datetime(1970, 1, 1)
FIRST_DAY = EPOCH.toordinal()
FIRST_YEAR, LAST_YEAR = 1000, 9000
YEAR_FIRST = r"(?P<Y>\d{4})(?P<x>[-/.])(?P<m>\d\d?)(?P=x)(?P<d>\d\d?)|"
YEAR_FIRST += r"(?P<Y2>\d{4})(?P<m2>\d\d)(?P<d2>\d\d)"
DAY_FIRST = r"(?P<d>\d\d?)(?P<x>[-/.]) ?(?P<m>\d\d?)(?P=x) ?(?P<Y>\d{4})"
MONTH_FIRST = r"(?P<m>\d\d?)(?P<x>[-/])(?P<d>\d\d?)(?P=x)(?P<Y>\d{4})"
TIME_OF_DAY = (
    r"(?P<H>\d\d?):(?P<M>\d\d)(?::(?P<S>\d\d)(?:[.,](?P<f>\d{1,9})\d*)?)?"
    r"(?: ?(?P<p>[AaPp])\.?[Mm]\.?)?"
    r"|(?P<H2>\d\d)(?P<M2>\d\d)(?P<S2>\d\d)?"
)
OFFSET = r"(?P<z>[Zz]|UTC|GMT|[-+\u2212]\d\d(?::?\d\d)?)"
CLOCK = re.compile(rf"(?:{TIME_OF_DAY}) ?{OFFSET}?", re.ASCII)  # only ASCII digits
# begins with a date
STAMP = re.compile(r"\d{1,4}([-/.]) ?\d\d?\1 ?\d{1,4}(?![\d.])|\d{8}(?=T\d)", re.ASCII)
TIME_ALONE = re.compile(r"\d\d?:\d\d(:\d\d)?([.,]\d+)?( ?[AaPp]\.?[Mm]\.?)?", re.ASCII)
IN_TITLE = re.compile(r"\b(?:GMT|UTC) ?(?P<z>[-+\u2212]\d\d?(?::?\d\d)?)?(?!\w)", re.IGNORECASE)
ORDER_IN_TITLE = re.compile(r"(mm?[-/]dd?|dd?[-/]mm?)[-/]yyyy", re.IGNORECASE)
# Parts of a format, as in strptime.
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


def pattern_of(text: str, title: str) -> Pattern:
    """Return the notation of a stamp."""
    mark = "T" if "T" in text and ":" not in text.partition("T")[0] else " "
    day = text.partition(mark)[0]
    if re.fullmatch(YEAR_FIRST, day):
        return Pattern(re.compile(YEAR_FIRST, re.ASCII), None, mark, "")
    parts = re.fullmatch(r"(\d\d?)([-/.])(\d\d?)\2(\d{2,4})", day)
    if not parts:
        raise _no_stamp(text)
    first, joint, second, year = parts.groups()
    if len(year) != 4:
        raise ConditionError(
            f"'{quote(text)}' has a year of {len(year)} digits, without a clear order",
            mention("{time-format=%m/%d/%y %I:%M:%S %p} or another format"),
        )
    order = ORDER_IN_TITLE.search(title.replace("_", " "))
    if order:
        by_day = order[1][:1] in "dD"
        assumption = f"the dates are {order[0]}, as the title has it"
    elif joint == ".":
        by_day, assumption = True, "dates with points have the day first"
    elif int(first) > 12 or int(second) > 12:
        by_day = int(first) > 12
        assumption = f"'{quote(day)}' shows that the {'day' if by_day else 'month'} is first"
    else:
        readings = " or ".join(
            _reading(year, *month_and_day) for month_and_day in ((second, first), (first, second))
        )
        raise ConditionError(f"'{quote(day)}' is ambiguous: {readings}", FORMATS)
    if by_day:
        return Pattern(re.compile(DAY_FIRST, re.ASCII), None, mark, assumption)
    return Pattern(re.compile(MONTH_FIRST, re.ASCII), None, mark, assumption)


def _reading(year: str, month: str, day: str) -> str:
    return f"{year}-{month:>02}-{day:>02}"


def pattern_of_format(text: str) -> Pattern:
    """Return the pattern of a strptime format, with date and time apart at a blank or T."""
    _check_format(text)
    for mark in (" ", "T"):
        day, _, clock = text.partition(mark)
        directives = re.findall("%(.)", day), re.findall("%(.)", clock)
        are_apart = {*directives[0]} <= {*OF_DATES} and {*directives[1]} <= {*OF_CLOCKS}
        if clock and are_apart:
            return Pattern(_compiled(day, text), _compiled(clock, text), mark, "")
    pattern = _compiled(text, text)
    has_clock = {*re.findall("%(.)", text)} & {*OF_CLOCKS}
    return Pattern(pattern, pattern, "", "") if has_clock else Pattern(pattern, None, "\n", "")


def _check_format(text: str) -> None:
    """Refuse a format with an unknown part, an incomplete date, or an ambiguous hour."""
    option_text = option("time-format", quote(text))
    letters = {*(directives := re.findall("%(.)", text))}
    if unknown := [letter for letter in directives if letter not in DIRECTIVES]:
        problem = f"{option_text} has %{quote(unknown[0])}, which is not supported"
        raise ConditionError(
            problem, " ".join(f"%{letter}" for letter in DIRECTIVES if letter != "%")
        )
    if not (letters & {*"Yy"} and ("j" in letters or ("d" in letters and letters & {*"mbB"}))):
        raise ConditionError(f"{option_text} has no complete date", FORMATS)
    if ("I" in letters) != ("p" in letters):
        problem = f"{option_text} has %{'I' if 'I' in letters else 'p'} alone"
        raise ConditionError(problem, "%H up to 23, or %I up to 12 with %p for AM and PM")


def _year_of_two_digits(year: int) -> int:
    """Return the year by POSIX: 69 is 1969, and 68 is 2068."""
    return year + (1900 if year >= 69 else 2000)


def _compiled(part: str, text: str) -> re.Pattern[str]:
    pieces = re.split("%(.)", part)
    try:
        return re.compile(
            "".join(
                DIRECTIVES[piece] if k % 2 else re.escape(piece) for k, piece in enumerate(pieces)
            ),
            re.ASCII,
        )
    except re.error:
        problem = f"{option('time-format', quote(text))} has a part twice"
        raise ConditionError(problem, "each part once") from None


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
