"""What every calculator shares: reading its inputs, --get, --check, and showing answers."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any, NamedTuple

from radcalc import stdio
from radcalc.answer import Answer, Result
from radcalc.calculators.results import element, pick, rows
from radcalc.cli import check
from radcalc.cli.options import Output
from radcalc.errors import UsageError, nearest, quote
from radcalc.given import Inputs, read, read_interval, values_of
from radcalc.maths import is_array
from radcalc.render.formats import PLAIN, TABLE
from radcalc.render.plain import DIGITS, number
from radcalc.units.ranges import MOST, one_by_one

LINES = 1000  # formatted at a time
BLOCK = 100_000  # values of a long range that are worked out at a time
Case = tuple[str, Inputs]


class Asked(NamedTuple):
    """What is asked of the answer: some results, the derivation, whether a number is right."""

    wanted: tuple[str, ...]
    steps: bool
    check: str | None
    tolerance: str | None

    @classmethod
    def of(cls, values: dict[str, Any]) -> "Asked":
        """Take it out of a command's values; refuse what has no use with --check, or without."""
        asked = cls(*(values.pop(name) for name in cls._fields))
        check.refuse_idle(asked.check, asked.tolerance)
        if asked.check is not None and asked.wanted:
            raise UsageError("--check and --get contradict each other", "--check NAME=VALUE")
        return asked

    def wants(self, name: str) -> bool:
        """Whether a result is asked for by its name."""
        named = [*self.wanted, (self.check or "").replace("=", ":")]
        return any(one.partition(":")[0].strip() == name for one in named)


def cases(typed: dict[str, Any], arrays: bool = False, intervals: Sequence[str] = ()) -> list[Case]:
    """The inputs as given; several times where one of them is a list or a range.

    With `arrays` a long range is one case, whose values are arrays; `intervals` are A:B.
    """
    given = {
        name: [read_interval(name, text)]
        if name in intervals
        else [read(name, part) for part in values_of(name, text, arrays)]
        for name, text in typed.items()
    }
    long = [name for name, values in given.items() if is_array(values[0].value)]
    varied, each = one_by_one(given, long)
    return [(case[varied].text if varied else "", case) for case in each]


def shape(word: str, names: Sequence[str]) -> str:
    """The name of a shape, in any case."""
    if word.lower() in names:
        return word.lower()
    near = nearest(word.lower(), names, 1) or names
    raise UsageError(f"there is no shape '{quote(word)}'", ", ".join(near))


def run(
    each: Sequence[Case],
    work_out: Callable[[Inputs], Answer],
    asked: Asked,
    output: Output,
    command: str,
    shape: str = "",
) -> int:
    """Work out the answer to every case and show it, or judge one; return the exit status."""
    if asked.check is not None:
        from radcalc.homework.question import of_calculator

        check.refuse_several(len(each))
        question = of_calculator(command, shape, each[0][1], work_out, asked.steps)
        return check.judge(question, asked.check, asked.tolerance, output)
    if asked.wanted:
        each = [part for one in each for part in _blocks(one)]
    else:
        _refuse_long(each)
    answers = (one for case, given in each for one in _every(case, work_out(given)))
    show(answers, asked, output)
    return stdio.ANSWERED


def _blocks(case: Case) -> Iterator[Case]:
    """A case of a long range in parts, whose answers do not fill the memory."""
    name, given = case
    long = next((one for one in given.values() if is_array(one.value)), None)
    if long is None:
        yield case
        return
    for start in range(0, len(long.value), BLOCK):
        part = slice(start, start + BLOCK)
        values = long._replace(value=long.value[part], number=long.number[part])
        yield name, {**given, long.name: values}


def _refuse_long(each: Sequence[Case]) -> None:
    """Refuse a table of more answers than anybody reads."""
    for _, given in each:
        count = max((len(one.value) for one in given.values() if is_array(one.value)), default=1)
        if count > MOST:
            raise UsageError(f"a table of {count} answers is too long", "-g NAME:UNIT, for columns")


def refuse_format(output: Output) -> None:
    """Refuse a format beside the bare numbers that were asked for."""
    if output.format not in (PLAIN, TABLE):
        problem = f"--get prints bare numbers, and contradicts --format {output.format}"
        raise UsageError(problem, "one of them")


def refuse_bare(output: Output) -> None:
    """Refuse -n where there are several results."""
    if output.style.bare:
        raise UsageError("-n prints one number, and there are several results", "-g NAME:UNIT")


def show(answers: Iterable[tuple[str, Answer]], asked: Asked, output: Output) -> None:
    """Write the answers, or the numbers that were asked for; each answer with its case."""
    if not asked.steps:
        answers = ((case, answer._replace(steps=())) for case, answer in answers)
    if asked.wanted:
        refuse_format(output)
        texts: list[str] = []
        remarks: dict[tuple[Any, ...], Result] = {}
        for _, answer in answers:
            columns = [pick(answer.values, name) for name in asked.wanted]
            is_part = any(is_array(value.given) for value in answer.values)
            if not (is_part and texts) or any(map(is_array, columns)):
                texts.append(lines(columns, output.style.precision))
            steps = () if is_part and texts[1:] else answer.steps
            said = result("", answer._replace(values=(), steps=steps))
            remarks[said if said.steps else said[1:3]] = said
        for text in texts:
            stdio.write(text)
        output.remark(list(remarks.values()))
        return
    refuse_bare(output)
    output.show([result(case, answer) for case, answer in _spread(answers)])


def _every(case: str, answer: Answer) -> list[tuple[str, Answer]]:
    """The answer to a case, or all of them where several fit, each with its number."""
    if not answer.more:
        return [(case, answer)]
    of_case = f"{case}, " if case else ""
    return [(f"{of_case}answer {k}", one) for k, one in enumerate((answer, *answer.more), start=1)]


def lines(columns: Sequence[Any], precision: int | None) -> str:
    """Numbers in tab-separated columns; of arrays a line for each element."""
    arrays = [column for column in columns if is_array(column)]
    if not arrays:
        return "\t".join(number(column, precision) for column in columns) + "\n"
    return formatted(columns, f"%.{precision or DIGITS}g", "\t")


def formatted(columns: Sequence[Any], one: str, delimiter: str) -> str:
    """A line for each element of arrays; `one` is the format of a number."""
    count = max(len(column) for column in columns if is_array(column))
    form = delimiter.join([one] * len(columns)) + "\n"
    lists = [c.tolist() if is_array(c) else [c] * count for c in columns]
    flat = lists[0] if len(lists) == 1 else [x for line in zip(*lists, strict=True) for x in line]
    width = len(columns) * LINES
    pieces = (flat[k : k + width] for k in range(0, len(flat), width))
    return "".join([form * (len(part) // len(columns)) % tuple(part) for part in pieces])


def _spread(answers: Iterable[tuple[str, Answer]]) -> list[tuple[str, Answer]]:
    """The answers, those of a long range one by one."""
    found: list[tuple[str, Answer]] = []
    for case, answer in answers:
        shown = [value for value in answer.values if not value.is_absent]
        long = [v for v in shown if not isinstance(v.si, float) and is_array(v.si)]
        if not long:
            found.append((case, answer))
            continue
        count = max(len(value.si) for value in long)
        given = next(value for value in long if value.given is not None)
        for k in range(count):
            name = f"{given.given[k]:.15g}{given.units[0]}"
            values = [element(value, k) for value in shown]
            steps = answer.steps if k == 0 else ()
            found.append((name, answer._replace(values=values, steps=steps)))
    return found


def result(case: str, answer: Answer) -> Result:
    """An answer as rows, with its case."""
    return Result(
        tuple(rows(answer.values, case)),
        tuple(answer.assumptions),
        tuple(answer.notes),
        tuple(answer.steps),
    )
