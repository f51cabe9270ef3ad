"""Remarks on the lines of a stream."""

from radcalc.streams.calculated import Remarks


def test_a_remark_missing_from_the_first_lines_names_its_lines():
    remarks = Remarks()
    remarks.hear([], range(1, 2))
    remarks.hear(["note: dark"], range(2, 3))
    assert remarks.not_yet_said() == ["note: line 2: dark"]


def test_a_remark_on_all_lines_has_the_range_of_its_numbers():
    remarks = Remarks()
    remarks.hear(["assumed: within 0.38 %"], range(1, 2))
    remarks.hear(["assumed: within 0.05 %"], range(2, 3))
    assert remarks.not_yet_said() == ["assumed: within 0.05 to 0.38 %"]
    remarks.hear(["assumed: within 1.2 %"], range(3, 4))
    assert remarks.changed() == ["assumed: within 0.05 to 1.2 %"]


def lines_of(*heard):
    remarks = Remarks()
    remarks.hear([], range(1, 2))
    for lines in heard:
        remarks.hear(["note: dark"], lines)
    return remarks.not_yet_said()[0].removeprefix("note: ").removesuffix(": dark")


def test_a_remark_names_only_the_lines_that_have_it():
    assert lines_of([2], [4]) == "lines 2, 4"
    assert lines_of([2], [3], range(3, 8)) == "lines 2 to 7"
    assert lines_of([5], [2]) == "lines 2, 5"
    assert lines_of([2, 4, 6]) == "lines 2, 4, 6"
    assert lines_of([2, 4, 6, 8], [1, 9]) == "lines 1, 2, 4 and others up to 9"
    assert lines_of([3, 5], [4, 6]) == "lines 3, 4, 5 and others up to 6"
