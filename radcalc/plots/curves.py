"""Results of several answers, or of arrays, as curves over an input."""

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

from radcalc import errors
from radcalc.answer import Answer, Row
from radcalc.calculators.results import pick
from radcalc.errors import listed, option, quote
from radcalc.inputs import Input, Inputs
from radcalc.maths import is_array
from radcalc.plots.data import LINE, POINTS, Axis, Chart, Series
from radcalc.quantities.symbols import DIRECTION, QUANTITY
from radcalc.units.scales import ScaleUnit

MOST = 20_000  # points of a picture
SMOOTH = 16  # least number of points to draw as a line
WIDE = 50.0  # ratio of greatest to least above which an axis may be logarithmic
PREFERRED = ("irradiance", "radiance-toward", "intensity-toward", "luminous-efficacy")
RANGE = "a list or a range of values: {distance=1m:10m:0.1m}"


class Line(NamedTuple):
    """Points of a curve, and the ends of their uncertain values."""

    x: list[float]
    y: list[float]
    low: list[float]
    high: list[float]

    def series(self, label: str) -> Series:
        """Return the curve in the order of x."""
        order = sorted(range(len(self.x)), key=self.x.__getitem__)
        x, y, low, high = ([numbers[k] for k in order] for numbers in self)
        band = (low, high) if low != high else None
        return Series(label, x, y, LINE if len(x) >= SMOOTH else POINTS, band)


Lines = dict[str, Line]  # by label


class Solved(NamedTuple):
    """The inputs of an answer, and the answer."""

    given: Inputs
    answer: Answer

    @property
    def answers(self) -> list[Answer]:
        return [self.answer, *self.answer.more]


def varied(solved: Sequence[Solved]) -> list[str]:
    """Return the names of the inputs that differ between answers."""
    first = solved[0].given
    return [
        name
        for name, item in first.items()
        if is_array(item.value) or any(other.given[name].text != item.text for other in solved)
    ]


def ranged(given: Inputs) -> errors.Hint:
    """Propose a range of an input for a plot, up to its given value; "" if there is none."""
    for name, item in given.items():
        is_size = isinstance(item.number, (int, float)) and item.number > 0
        if item.symbol.form == QUANTITY and is_size and not isinstance(item.unit, ScaleUnit):
            ends = (f"{item.number * part:.6g}" for part in (0.5, 1, 0.05))
            unit = item.unit_text if item.unit else ""
            return errors.add(name, ":".join(f"{end}{unit}" for end in ends), "a range of values")
    return ""


def without_band(uncertain: Sequence[Input]) -> str:
    """Return the note of a picture that does not show the uncertainty of inputs."""
    texts = dict.fromkeys(f"{item.symbol.label or item.name} {item.text}" for item in uncertain)
    return f"drawn without the uncertainty of {listed([*texts])}"


def curves(solved: Sequence[Solved], wanted: Sequence[str] = ()) -> Chart:
    """Return results as curves; of several varied inputs, the last numeric one is the x axis.

    At least one input must differ between answers, or be an array.  `wanted` are results,
    NAME[:UNIT]; by default the main one.  Raise a UsageError if there is nothing to draw, or
    results have different units.
    """
    _check_arrays(solved[0].given)
    lists = varied(solved)
    numbers = [name for name in lists if _is_number(solved[0].given[name])]
    along = (numbers or lists)[-1]
    other_lists = [name for name in lists if name != along]
    lines, rows = _lines(solved, wanted or [_usual(solved, along)], along, other_lists)
    if len({row.unit for row in rows}) > 1:
        several = " and ".join(dict.fromkeys(f"{row.name} in {row.unit}" for row in rows))
        each = {row.name: errors.add("get", f"{row.name}:{row.unit}") for row in rows}
        raise errors.UsageError(f"{several}: an axis has one unit", [*each.values()])
    _refuse_many(lines)
    is_log = _is_wide([line.x for line in lines.values()]) and _is_wide(
        [[*line.y, *line.low] for line in lines.values()]
    )
    x_axis = Axis(*_axis_name(solved[0].given[along]), is_log=is_log)
    names = list(dict.fromkeys(f"{row.quantity} {row.symbol}".strip() for row in rows))
    y_axis = Axis(names[0] if len(names) == 1 else "", rows[0].unit, is_log=is_log)
    fixed = [item for name, item in solved[0].given.items() if name not in (*other_lists, along)]
    title = ", ".join(f"{item.name} {item.text}".strip() for item in fixed)
    drawn = [line.series(label) for label, line in lines.items()]
    note = _coverage(drawn, [answered.given[along] for answered in solved])
    return Chart(title, x_axis, y_axis, drawn, note=note)


def _coverage(drawn: Sequence[Series], places: Sequence[Input]) -> str:
    """Return the meaning of the bands; "" without any."""
    styles = {series.style for series in drawn if series.band}
    if not styles:
        return ""
    from radcalc.calculators.uncertainty import STANDARD

    kind = " and ".join(
        name for style, name in ((LINE, "band"), (POINTS, "bar")) if style in styles
    )
    text = f"{kind}: \u00b1 {STANDARD}"
    if any(place.is_uncertain for place in places):
        text += f", with that of the {places[0].symbol.label}"
    return text


def _check_arrays(given: Inputs) -> None:
    for item in given.values():
        if is_array(item.value) and (item.value.ndim != 1 or not item.value.size):
            problem = f"{option(item.name)} is an array of the shape {item.value.shape}"
            raise errors.UsageError(problem, "one dimension, with an element or more")


def _lines(
    solved: Sequence[Solved], wanted: Sequence[str], along: str, other_lists: Sequence[str]
) -> tuple[Lines, list[Row]]:
    """Return the points of each line by its label, and the rows they come from."""
    first = solved[0].given[along]
    lines: Lines = {}
    rows: list[Row] = []
    for answered in solved:
        places = _places(answered.given[along], first)
        list_texts = [f"{name} {answered.given[name].text}".strip() for name in other_lists]
        for k, answer in enumerate(answered.answers, start=1):
            case = [*list_texts, *([f"answer {k}"] if len(answered.answers) > 1 else [])]
            for name in wanted:
                row = pick(answer.values, name, ", ".join(case))
                rows.append(row)
                label = ", ".join([*([row.quantity] if len(wanted) > 1 else []), *case])
                line = lines.setdefault(label, Line([], [], [], []))
                numbers = _numbers(row.value, len(places))
                ends = row.value - row.uncertainty, row.value + row.uncertainty
                for part, more in zip(line, (places, numbers, *ends), strict=True):
                    part += more if isinstance(more, list) else _numbers(more, len(places))
    return lines, rows


def _usual(solved: Sequence[Solved], along: str) -> str:
    """Return the main result among those that vary."""
    values = [
        value
        for value in solved[0].answer.values
        if not value.is_absent and value.given is None and value.name != along
    ]
    names = [value.name for value in values]
    for name in (*(preferred for preferred in PREFERRED if preferred in names), *names):
        results = [pick(case.answer.values, name).value for case in solved if _has(case, name)]
        if len(results) == len(solved) and (is_array(results[0]) or len(set(results)) > 1):
            return name
    problem = f"no result depends on {option(along)}"
    raise errors.UsageError(problem, "a range of something else")


def _has(solved: Solved, name: str) -> bool:
    return any(value.name == name and not value.is_absent for value in solved.answer.values)


def _places(given: Input, first: Input) -> list[float]:
    """Return positions along the axis, in the unit of the first answer."""
    if given.symbol.form == DIRECTION:
        return [math.degrees(given.value[0])]
    if not _is_number(given):
        problem = f"{option(given.name, quote(given.text))} is not a number for an axis"
        raise errors.ConditionError(problem, errors.mention(RANGE))
    number = given.number
    if given.unit_text != first.unit_text:
        is_on_scale = isinstance(given.unit, ScaleUnit) or isinstance(first.unit, ScaleUnit)
        if is_on_scale or given.dimension != first.dimension:
            problem = f"{option(given.name)} is in {given.unit_text} and in {first.unit_text}"
            raise errors.UsageError(f"{problem}: an axis has one unit", errors.leave_out("plot"))
        number = given.value / float(first.unit.factor if first.unit else 1)
    return [float(x) for x in (number if is_array(number) else [number])]


def _is_number(given: Input) -> bool:
    return given.symbol.form == DIRECTION or (
        given.symbol.form == QUANTITY and given.number is not None
    )


def _axis_name(given: Input) -> tuple[str, str]:
    if given.symbol.form == DIRECTION:
        return "polar angle \u03b8", "deg"
    letter = given.symbol.letter
    unit = "" if given.unit is None else given.unit_text
    return f"{given.symbol.label} {letter}".strip(), unit


def _numbers(value: Any, count: int) -> list[float]:
    return [float(x) for x in value] if is_array(value) else [float(value)] * count


def _refuse_many(lines: Lines) -> None:
    count = sum(len(line.x) for line in lines.values())
    if count > MOST:
        raise errors.UsageError(f"{count} points are too many for a picture", f"at most {MOST}")


def _is_wide(numbers: Sequence[Sequence[float]]) -> bool:
    values = [x for row in numbers for x in row]
    return min(values) > 0 and max(values) > WIDE * min(values)
