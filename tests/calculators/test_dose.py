"""Sums of samples: against exact fractions, in parts, over gaps, in constant memory."""

import tracemalloc
from fractions import Fraction
from itertools import accumulate, pairwise
from math import inf

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from radcalc.calculators import dose_sums
from radcalc.calculators.dose import READINGS, SummedLog, check_unit
from radcalc.calculators.dose_sums import HALVES, POINTS, Dose
from radcalc.errors import RadcalcError
from radcalc.inputs.reading import read
from radcalc.units.table import resolve

DAY = 100  # ticks of the days of these tests


def days(time):
    start = time // DAY * DAY
    return start, start + DAY, f"day {start // DAY}"


def summed(times, values, size=1 << 20, **told):
    """Return the dose of samples in parts."""
    dose = Dose(**told)
    for k in range(0, len(times), size):
        dose.add(times[k : k + size], values[k : k + size])
    return dose


def total(dose):
    return sum(Fraction(period.total) + Fraction(period.low) for period in dose.periods)


def exact(times, values, longest=None):
    """Return the sum of the trapezoids, in fractions."""
    pairs = list(pairwise(zip(times, map(Fraction, values), strict=True)))
    return sum((v + w) / 2 * (b - a) for (a, v), (b, w) in pairs if not longest or b - a <= longest)


LOGS = st.lists(
    st.tuples(st.integers(1, 400), st.floats(0, 1e6, allow_subnormal=False)), min_size=2
)


def log_of(steps):
    times, now = [], 0
    for step, _ in steps:
        now += step
        times.append(now)
    return times, [value for _, value in steps]


@given(LOGS, st.integers(1, 7), st.sampled_from([None, 1, 50, 200]))
def test_sums_in_parts_and_with_gaps_equal_those_of_fractions(steps, size, longest):
    times, values = log_of(steps)
    dose = summed(times, values, size, **({"longest": longest} if longest else {}))
    expected = exact(times, values, longest)
    assert abs(total(dose) - expected) <= expected * Fraction(1, 2**51)
    bridged = [b - a for a, b in pairwise(times) if not longest or b - a <= longest]
    assert dose.gaps == len(times) - 1 - len(bridged)
    assert dose.gap_time + sum(bridged) == times[-1] - times[0]
    assert sum(period.covered for period in dose.periods) == sum(bridged)
    assert dose.periods[0].count == dose.count == len(times)


@given(LOGS, st.integers(1, 7), st.sampled_from([None, 50, 200]))
def test_days_add_up_to_the_whole(steps, size, longest):
    times, values = log_of(steps)
    told = {"longest": longest} if longest else {}
    dose = summed(times, values, size, spans=days, **told)
    expected = exact(times, values, longest)
    assert abs(total(dose) - expected) <= expected * Fraction(1, 2**45)
    assert sum(period.count for period in dose.periods) == len(times)
    for period in dose.periods:
        assert period.count == sum(period.start <= time < period.end for time in times)
        assert 0 <= period.covered <= DAY
        assert period.start <= period.when <= period.end
    assert [p.start for p in dose.periods] == sorted({p.start for p in dose.periods})


@given(LOGS, st.integers(1, 7), st.sampled_from([1, 20, 200]))
@example([(50, 0.0), (50, 0.0), (250, 0.0), (1, 0.0)], 1, 50)  # a gap begins at midnight
def test_a_day_without_covered_time_is_listed(steps, size, longest):
    times, values = log_of(steps)
    joined = [b - a <= longest for a, b in pairwise(times)]
    if not any(joined):
        return
    # from the first sample to the last; a bridge that ends at midnight ends the day before
    told = {days(time)[2] for time in range(times[0], times[-1] + (not joined[-1]))}
    dose = summed(times, values, size, longest=longest, spans=days)
    found = [label for label, _ in SummedLog(dose, resolve("lx"), (1, 1), str).of_periods({})]
    assert sorted(found) == sorted(told)


def test_a_trapezoid_over_several_days_is_split_at_midnight():
    """From 0 at 50 to 300 at 350: 50 at 100, 150 at 200, 250 at 300."""
    dose = summed([50, 350], [0.0, 300.0], spans=days)
    sums = [50 * 25, 100 * 100, 100 * 200, 50 * 275]
    assert [period.total for period in dose.periods] == sums
    assert [period.peak for period in dose.periods] == [50, 150, 250, 300]
    assert [period.count for period in dose.periods] == [1, 0, 0, 1]


def test_small_terms_are_not_lost_next_to_large_ones():
    """1e17, then 10 000 blocks with a 1, each less than half an ulp (8)."""
    times = [0, 1, 2, *range(3, 10004)]
    values = [1e17, 1e17, 0.0, *[1.0] * 10001]
    dose = summed(times, values, 1)
    assert total(dose) == exact(times, values)


def test_an_omitted_sample_is_a_gap_unless_the_longest_step_is_given():
    for told, gaps in (({}, 1), ({"longest": 20, "bridges": True}, 0)):
        dose = Dose(**told)
        dose.add([0], [1.0])
        dose.interrupt()
        dose.add([20, 30], [1.0, 1.0])
        assert (dose.gaps, float(total(dose))) == (gaps, 10 if gaps else 30)


def test_a_step_that_rounding_made_longer_is_not_a_gap():
    """Every 10 min in days of 6 decimals: 0.006944 and 0.006945 d are 599.96 and 600.05 s."""
    times = [round(k / 144, 6) * 86400 for k in range(11)]
    assert max(b - a for a, b in pairwise(times)) > 600.04
    assert summed(times, [1.0] * 11, longest=600).gaps == 0
    assert summed([0, 600, 1201], [1.0] * 3, longest=600).gaps == 1


def test_negative_samples_are_kept_and_noted():
    """From -1 to 3 in 4: below 0 for 1, a triangle of 1/2."""
    dose = summed([0, 4, 8, 10], [-1.0, 3.0, 99.0, 99.0])
    assert total(dose) == 4 + 4 * 51 + 2 * 99
    assert (dose.negative, dose.least, dose.below) == (1, -1.0, -0.5)


@pytest.mark.parametrize(
    ("unit", "said"),
    [
        ("cd/m2", "luminance"),
        ("cd", "luminous intensity"),
        ("lx.s", "integrated over time"),
        ("J/m2", "integrated over time"),
        ("W/m2/nm", "spectral irradiance"),
        ("td", "retinal illuminance"),
        ("m", "length"),
    ],
)
def test_samples_without_a_dose_are_refused(unit, said):
    with pytest.raises(RadcalcError) as refused:
        check_unit(resolve(unit))
    assert said in refused.value.message


def answer(dose, unit="lx", **inputs):
    log = SummedLog(dose, resolve(unit), (1, 1), str)
    log.check()
    given = {name: read(name, text) for name, text in inputs.items()}
    return {value.name: value for value in log.of_all(given).values}


def test_a_log_without_light_has_a_mean_of_0():
    found = answer(summed([0, 10], [0.0, 0.0]))
    assert found["exposure"].amount == found["mean-irradiance"].amount == 0


def test_flux_gives_energy_and_with_a_receiver_area_exposure():
    dose = summed([0, 10], [1.0, 3.0])
    found = answer(dose, "mW", **{"receiver-area": "4cm2"})
    assert (found["energy"].amount, found["exposure"].amount) == (0.02, pytest.approx(50))


@pytest.mark.parametrize(
    ("times", "values", "said"),
    [
        ([0], [1.0], "one sample"),
        ([0, 10], [-1.0, 10.0], "too far below 0"),
        ([0, 10], [-1.0, -1.0], "too far below 0"),
        ([0, 10], [1e308, 1e308], "is too large"),
        ([0, 1, 2], [1e308, 1e308, 1e308], "is too large"),
    ],
)
def test_inputs_without_a_dose_are_refused(times, values, said):
    with pytest.raises(RadcalcError) as refused:
        answer(summed(times, values))
    assert said in refused.value.message


def test_a_distant_time_does_not_make_an_endless_list(monkeypatch):
    monkeypatch.setattr(dose_sums, "MOST", 50)
    assert len(summed([0, 49 * DAY], [1.0, 1.0], spans=days).periods) == 50
    with pytest.raises(RadcalcError, match="more than 50 days or hours"):
        summed([0, 50 * DAY], [1.0, 1.0], spans=days)


def test_a_log_of_gaps_only_is_refused():
    with pytest.raises(RadcalcError, match="every step is a gap"):
        answer(summed([0, 10, 20], [1.0, 1.0, 1.0], longest=5))


def test_a_long_log_needs_no_more_memory_than_a_short_one():
    def most(blocks):
        tracemalloc.start()
        dose = Dose()
        for k in range(blocks):
            dose.add(list(range(1000 * k, 1000 * (k + 1))), [1.0] * 1000)
        used = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        assert total(dose) == 1000 * blocks - 1
        return used

    assert most(200) < 2 * most(10)


@given(
    st.lists(st.tuples(st.integers(1, 15), st.integers(0, 100)), min_size=2, max_size=40),
    st.integers(1, 40),
    st.integers(5, 60),
    st.booleans(),
    st.sampled_from(sorted(HALVES)),
)
def test_a_mean_lasts_over_its_steps(rows, size, day, has_limit, reading):
    """The sum over single ticks, each with the value of the sample whose mean includes it."""
    longest = 15 if has_limit else inf
    times = list(accumulate(2 * step for step, _ in rows))
    values = [float(value) for _, value in rows]
    dose = Dose(
        longest, True, lambda t: (t // day * day, t // day * day + day, str(t // day)), reading
    )
    for start in range(0, len(rows), size):
        dose.add(times[start : start + size], values[start : start + size])
    dose.finish()
    before = {"means": 0, "means-centred": 1 / 2, "means-before": 1}[reading]
    step = times[1] - times[0]
    starts = [times[0] - before * step if step <= longest * 1.001 else times[0]]
    ends = []
    usual = 0
    for time, after in pairwise(times):
        step = after - time
        if step <= longest * 1.001:
            usual = step
            ends.append(after - before * step)
            starts.append(ends[-1])
        else:
            ends.append(min(time + (1 - before) * usual, after))
            starts.append(max(after - before * usual, ends[-1]))
    ends.append(times[-1] + (1 - before) * usual)
    expected: dict[int, float] = {}
    for start, end, value in zip(starts, ends, values, strict=True):
        for tick in range(int(start), int(end)):
            expected[tick // day] = expected.get(tick // day, 0) + value
    sums = {int(period.label): period.total + period.low for period in dose.periods}
    assert {k: v for k, v in sums.items() if v} == {k: v for k, v in expected.items() if v}
    assert sum(period.count for period in dose.periods) == len(rows)
    assert dose.time - dose.first == ends[-1] - starts[0]
    assert sum(period.covered for period in dose.periods) + dose.gap_time == ends[-1] - starts[0]


def notes_of(times, values, size=1 << 20, reading=POINTS, **told):
    dose = summed(times, values, size, reading=reading, **told)
    dose.finish()
    return " ".join(SummedLog(dose, resolve("lx"), (1, 1), str).remarks())


# Rows that are taken out of a regular log, and the steps that then lack samples.
@pytest.mark.parametrize("size", [1, 7, 1000])
@pytest.mark.parametrize("reading", READINGS)
@pytest.mark.parametrize(
    ("out", "count", "longest"),
    [({10}, 1, 120), ({10, 50, 51}, 2, 180), ({3, 5, 70, 71, 72}, 3, 240), ({1}, 1, 120)],
)
def test_missing_rows_of_a_regular_log_are_noted(out, count, longest, reading, size):
    rows = [(60 * k + k % 3, 100.0) for k in range(300) if k not in out]  # the times jitter
    times, values = map(list, zip(*rows, strict=True))
    notes = notes_of(times, values, size, reading)
    assert (f"{count} long steps" if count > 1 else "a step of ") in notes
    steps = [b - a for a, b in pairwise(times)]
    assert max(steps) == pytest.approx(longest, abs=3)
    assert "the usual step has 1 min" in notes or "the usual step has 1.0" in notes
    cut = float(notes.partition("max-gap")[2].partition("min")[0].lstrip("\ue001 "))
    split = summed(times, values, size, longest=60 * cut)
    assert split.gaps == count
    assert "the usual step" not in notes_of(times, values, size, longest=60 * cut)


@pytest.mark.parametrize(
    "steps", [[60] * 200, [60, 61, 59] * 70, [1, 7, 30, 100, 3, 400] * 30, [60, 600] * 50]
)
def test_a_log_without_missing_rows_or_without_regular_steps_has_no_such_note(steps):
    times = [0, *accumulate(steps)]
    assert "the usual step" not in notes_of(times, [1.0] * len(times))
