"""Titles as people write them, and what is their name and their unit."""

import pytest

from radcalc.errors import UnitError, UsageError
from radcalc.quantities.titles import find, is_same, read_title
from radcalc.units.scales import resolve_any

# The title, the unit of the numbers or none, the name in it, its unit, and with fc in its place.
TITLES = {
    "square brackets": ("E [lx]", "lx", "E", "lx", "E [fc]"),
    "round ones": ("E (Lux)", "lx", "E", "Lux", "E (fc)"),
    "no blank before them": ("E[lx]", "lx", "E", "lx", "E[fc]"),
    "blanks in them": ("E [ lx ]", "lx", "E", "lx", "E [ fc ]"),
    "a slash as in ISO 80000-1": ("E / lx", "lx", "E", "lx", "E / fc"),
    "a slash without blanks": ("E/lx", "lx", "E", "lx", "E/fc"),
    "a slash before brackets": ("E / (W/m2)", "W/m2", "E", "W/m2", "E / (fc)"),
    "an underscore": ("E_lx", "lx", "E", "lx", "E_fc"),
    "a comma": ("E, lx", "lx", "E", "lx", "E, fc"),
    "quotes": ('E, "lx"', "lx", "E", "lx", 'E, "fc"'),
    "the word in": ("E in lux", "lx", "E", "lux", "E in fc"),
    "the word in, in brackets": ("E (in lx)", "lx", "E", "lx", "E (in fc)"),
    "a symbol before it in brackets": ("light (Ev, lx)", "lx", "light", "lx", "light (Ev, fc)"),
    "the unit alone": ("lux", "lx", "", "lux", "fc"),
    "the unit first": ("Lux desk", "lx", "desk", "Lux", "fc desk"),
    "a number behind it": ("lux_1", "lx", "1", "lux", "fc_1"),
    "two brackets": ("E [lx] (north)", "lx", "E (north)", "lx", "E [fc] (north)"),
    "two brackets, the unit last": ("E (north) [lx]", "lx", "E (north)", "lx", "E (north) [fc]"),
    "brackets in a unit": ("PPFD umol/(m2 s)", "umol/m2/s", "PPFD", "umol/(m2 s)", "PPFD fc"),
    "brackets in brackets": ("P (umol/(m2 s))", "umol/m2/s", "P", "umol/(m2 s)", "P (fc)"),
    "superscripts": ("P [µmol m⁻² s⁻¹]", "umol/m2/s", "P", "µmol m⁻² s⁻¹", "P [fc]"),
    "underscores for signs": ("PPFD_umol_m2_s", "umol/m2/s", "PPFD", "umol/m2/s", "PPFD_fc"),
    "a scale": ("P_dBm", "dBm", "P", "dBm", "P_fc"),
    "another unit": ("E [fc]", "lx", "E", "fc", "E [fc]"),
    "another quantity in brackets": ("t (s)", "lx", "t", "s", "t (fc)"),
    "another quantity of light": ("mW", "lx", "", "mW", "fc"),
    "none typed": ("E [lx]", None, "E", "lx", "E [fc]"),
    "none typed, an underscore": ("E_lx", None, "E", "lx", "E_fc"),
    "none typed, and E is no einstein": ("E lx", None, "E", "lx", "E fc"),
    "a symbol": ("E", "lx", "E", None, "E"),
    "a symbol with a subscript": ("E_v", "lx", "E_v", None, "E_v"),
    "a subscript that is a phot": ("E_ph", "umol/m2/s", "E_ph", None, "E_ph"),
    "a word that is a unit of time": ("min", "lx", "min", None, "min"),
    "a channel that is a watt": ("channel W", "lx", "channel W", None, "channel W"),
    "a kind of quantity": ("photon irradiance", "lx", "photon irradiance", None,
                           "photon irradiance"),
    "no unit in brackets": ("E (desk)", "lx", "E (desk)", None, "E (desk)"),
    "an empty title": ("", "lx", "", None, ""),
}  # fmt: skip


@pytest.mark.parametrize(("text", "like", "name", "unit", "changed"), TITLES.values(), ids=TITLES)
def test_a_title_is_a_name_and_a_unit(text, like, name, unit, changed):
    title = read_title(text, resolve_any(like) if like else None)
    assert (title.name, title.unit and title.unit.text) == (name, unit)
    assert title.with_unit("fc") == changed


@pytest.mark.parametrize(
    ("text", "renamed"),
    [("E [lx]", "N [fc]"), ("E_lx", "N_fc"), ("E / lx", "N / fc"), ("E, lx", "N, fc"),
     ("lux", "N [fc]"), ("lux desk", "N [fc]"), ("E", "N")],
)  # fmt: skip
def test_another_name_has_the_unit_as_the_first_had_it(text, renamed):
    assert read_title(text, resolve_any("lx")).renamed("N", "fc") == renamed


SCALED = ["E (1000 lx)", "E [10^3 lx]", "E [10³ lx]", "E lx x10", "E 1e3 lx"]
UNKNOWN = ["E [klux]", "kLux", "E lx*10", "E (lx*)", "E [W/m2 x]", "x" * 200 + " lx"]


@pytest.mark.parametrize("text", [*SCALED, *UNKNOWN])
def test_what_scales_its_numbers_or_has_an_unknown_unit_is_refused(text):
    message = "scales its numbers" if text in SCALED else "a unit that is not known"
    with pytest.raises(UnitError, match=message):
        read_title(text, resolve_any("lx"))


@pytest.mark.parametrize(
    ("one", "other", "wanted"),
    [("lx", "lux", True), ("lx", "lm/m2", True), ("lx", "fc", False), ("lx", "radlux", False),
     ("umol/m2/s", "µmol m-2 s-1", True), ("dBm", "dB(mW)", True), ("dBm", "dBW", False),
     ("dBm", "mW", False), ("lx", "cd/m2", False), ("lx", "klx", False)],
)  # fmt: skip
def test_units_are_the_same_where_their_numbers_are(one, other, wanted):
    assert is_same(resolve_any(one), resolve_any(other)) is wanted


@pytest.mark.parametrize(
    ("titles", "name", "place"),
    [
        (["t", "E [lx]"], "E [lx]", 1),
        (["t", "E [lx]"], "E", 1),
        (["t", "E [lx]"], "e", 1),
        (["t", "E [lx]"], "e [LX]", 1),
        (["E", "E [lx]"], "E", 0),
        (["e", "E [lx]"], "E", 1),
        (["E [lx]", "E2 [lx]"], "E", 0),
        (["t", "Osvětlenost (lx)"], "OSVĚTLENOST", 1),
        (["t", "lux"], " lux ", 1),
        (["2", "1"], "1", 1),
    ],
)
def test_a_column_is_found_by_its_title(titles, name, place):
    assert find(titles, name, "it") == place


@pytest.mark.parametrize(
    ("titles", "name", "message", "hint"),
    [
        (["E", "E"], "E", "it has the column 'E' 2 times", "E (field 1), E (field 2)"),
        (["E [lx]", "E [fc]"], "E", "2 times", "E [lx] (field 1), E [fc] (field 2)"),
        (["e", "ε", "E "], "ee", "it has no column 'ee'", "e"),
        (["t", "light"], "lihgt", "it has no column 'lihgt'", "light"),
        (["t", "light"], "2", "it has no column '2'", "t, light"),
        ([], "x", "it has no column 'x'", "a title for each column"),
    ],
)
def test_a_column_that_is_not_there_once_is_refused(titles, name, message, hint):
    with pytest.raises(UsageError) as caught:
        find(titles, name, "it")
    assert message in caught.value.message
    assert hint in caught.value.hint
