"""Remarks on the lines of a stream."""

from radcalc.streams.remarks import Remarks


def test_a_remark_that_the_first_lines_lack_names_its_lines():
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
