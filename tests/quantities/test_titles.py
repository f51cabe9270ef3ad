"""Titles of columns: their names and units."""

import re

import pytest
from conftest import run
from helpers import for_each
from hypothesis import given
from hypothesis import strategies as st

from radcalc.errors import UnitError, UsageError
from radcalc.quantities.column_titles import find, is_same, read_title, refuse_altered, unit_in
from radcalc.units.values import resolve_any

# The title, the unit of the numbers or None, the name and the unit in it, and the title with fc.
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
    "a number after it": ("lux_1", "lx", "1", "lux", "fc_1"),
    "two brackets": ("E [lx] (north)", "lx", "E (north)", "lx", "E [fc] (north)"),
    "two brackets, the unit last": ("E (north) [lx]", "lx", "E (north)", "lx", "E (north) [fc]"),
    "brackets in a unit": ("PPFD umol/(m2 s)", "umol/m2/s", "PPFD", "umol/(m2 s)", "PPFD fc"),
    "brackets in brackets": ("P (umol/(m2 s))", "umol/m2/s", "P", "umol/(m2 s)", "P (fc)"),
    "superscripts": ("P [µmol m⁻² s⁻¹]", "umol/m2/s", "P", "µmol m⁻² s⁻¹", "P [fc]"),
    "a name that is a unit": ("E (W) [lx]", None, "E (W)", "lx", "E (W) [fc]"),
    "underscores for signs": ("PPFD_umol_m2_s", "umol/m2/s", "PPFD", "umol/m2/s", "PPFD_fc"),
    "a scale": ("P_dBm", "dBm", "P", "dBm", "P_fc"),
    "another unit": ("E [fc]", "lx", "E", "fc", "E [fc]"),
    "another quantity in brackets": ("t (s)", "lx", "t", "s", "t (fc)"),
    "another quantity of light": ("mW", "lx", "", "mW", "fc"),
    "none typed": ("E [lx]", None, "E", "lx", "E [fc]"),
    "none typed, an underscore": ("E_lx", None, "E", "lx", "E_fc"),
    "none typed, and E is not an einstein": ("E lx", None, "E", "lx", "E fc"),
    "a symbol": ("E", "lx", "E", None, "E"),
    "a symbol with a subscript": ("E_v", "lx", "E_v", None, "E_v"),
    "a subscript that is a phot": ("E_ph", "umol/m2/s", "E_ph", None, "E_ph"),
    "a word that is a unit of time": ("min", "lx", "min", None, "min"),
    "a channel that is a watt": ("channel W", "lx", "channel W", None, "channel W"),
    "a kind of quantity": ("photon irradiance", "lx", "photon irradiance", None,
                           "photon irradiance"),
    "no unit in brackets": ("E (desk)", "lx", "E (desk)", None, "E (desk)"),
    "a length, and the word in": ("E at 2 m in W/m2", None, "E at 2 m", "W/m2", "E at 2 m in fc"),
    "many words": ("E of lamp 1 at 2 m / umol m-2 s-1 nm-1", None, "E of lamp 1 at 2 m",
                   "umol m-2 s-1 nm-1", "E of lamp 1 at 2 m / fc"),
    "a subscript that is a second": ("E_s", None, "E_s", None, "E_s"),
    "an empty title": ("", "lx", "", None, ""),
}  # fmt: skip


@for_each(TITLES.values())
def test_a_title_is_split_into_a_name_and_a_unit(text, like, name, unit, changed):
    title = read_title(text, resolve_any(like) if like else None)
    assert (title.name, title.unit and title.unit.text) == (name, unit)
    assert title.with_unit("fc") == changed


@pytest.mark.parametrize(
    ("text", "renamed"),
    [("E [lx]", "N [fc]"), ("E_lx", "N_fc"), ("E / lx", "N / fc"), ("E, lx", "N, fc"),
     ("lux", "N [fc]"), ("lux desk", "N [fc]"), ("E", "N")],
)  # fmt: skip
def test_a_new_name_gets_the_unit_in_the_same_form(text, renamed):
    assert read_title(text, resolve_any("lx")).renamed("N", "fc") == renamed


SCALED = ["E (1000 lx)", "E [10^3 lx]", "E [10³ lx]", "E lx x10", "E 1e3 lx"]
UNKNOWN = ["E [Mlux]", "mLux", "E lx*10", "E (lx*)", "E [W/m2 x]", "x" * 200 + " lx"]


@pytest.mark.parametrize("text", [*SCALED, *UNKNOWN])
def test_a_title_with_a_factor_or_an_unknown_unit_is_refused(text):
    message = "scales its numbers" if text in SCALED else "unknown unit"
    with pytest.raises(UnitError, match=message):
        read_title(text, resolve_any("lx"))


# Brackets beside a unit or a name that stands for one, and whether they only say which it is.
BRACKETS = {
    "lux [mV]": False, "fc [foo]": False, "PAR [xx]": False, "GHI [counts]": False,
    "lux (lab 7 of the house)": False, "PPFD (raw)": False,
    "lux (desk)": True, "Lux (min)": True, "Lux (h)": True, "PAR (in)": True, "GHI (s)": True,
    "PAR (sensor 1)": True, "lux (B)": True, "lux (max)": True, "E (h) [lx]": True,
    "any wall at all (north, 2nd floor) [lx]": True,
}  # fmt: skip


@for_each(BRACKETS.items())
def test_brackets_beside_a_unit_are_known_or_refused(text, is_known):
    if is_known:
        assert read_title(text).unit is None or read_title(text).unit.is_light
    else:
        with pytest.raises(UnitError):
            read_title(text)


NAMES = ["E", "E_v", "Ev", "desk", "room 7", "sensor-2", "x1 y2", "Osvětlenost stolu", "grid 3x3",
         "20 m²", "E1", "lamp 5 W", "at 2 m", "LG monitor", "logger 1", "1/2", "f/2.8", "50 %",
         "400-700 nm", "2024-06-01", "max", "exp 1", "1/e2",
         "room 3 E", "2 m E", "5 m"]  # fmt: skip
SET_OFF = ["{0} [{1}]", "{0} ({1})", "{0}, {1}", "{0}_{1}", "{0} in {1}"]
UNITS = ["lx", "klx", "W/m2", "umol/m2/s", "cd/m2"]
# Factors and functions of the numbers: after or before a title, or in its name.
FACTORS = ["{} x1000", "{} *1000", "{}*1000", "{} /1000", "{}_x10", "{}, x10", "{} × 10³",
           "{} ·100", "{} %", "{} ÷10", "{} (x1000)", "1000 x {}", "1000*{}", "10^3 * {}", "1e3 {}",
           "thousands of {}"]  # fmt: skip
FUNCTIONS = ["log {}", "log10 {}", "log10({})", "LOG {}", "ln {}", "lg({})", "sqrt {}", "√{}",
             "1/{}", "1 / {}", "{} (log)", "{}, log", "{}²", "{}**2",
             "inverse {}", "dB {}"]  # fmt: skip


@given(st.sampled_from(NAMES), st.sampled_from(SET_OFF), st.sampled_from(UNITS))
def test_a_title_with_any_name_has_its_unit(name, style, unit):
    assert read_title(style.format(name, unit)).unit.text == unit


@given(
    st.sampled_from(["E", "desk", "E_v", "Osvětlenost"]),
    st.sampled_from(SET_OFF),
    st.sampled_from(UNITS),
    st.sampled_from([*FACTORS, *FUNCTIONS]),
    st.booleans(),
)
def test_a_factor_or_a_function_in_a_title_is_refused(name, style, unit, change, of_name):
    text = style.format(change.format(name), unit) if of_name else None
    text = text or change.format(style.format(name, unit))
    with pytest.raises(UnitError, match=r"scales its|a function of|unknown unit"):
        refuse_altered(read_title(text))


@given(
    st.sampled_from(["1000", "10 ", "1e3 ", "2.5 "]),
    st.sampled_from(["E", "E_v", "Ev", "I", "L", "Φ_e"]),
    st.sampled_from([*SET_OFF, "{0} / {1}"]),
    st.sampled_from(UNITS),
)
def test_a_number_before_a_symbol_is_refused(number, symbol, style, unit):
    with pytest.raises(UnitError, match=r"scales its|unknown unit"):
        read_title(number + style.format(symbol, unit))


@given(
    st.sampled_from(["[{0}] or [{1}]", "({0}) ({1})", "[{0}] ({1})", "{0}, {1}", "_{0} [{1}]",
                     "[{0}] {1}"]),
    st.lists(st.sampled_from(UNITS), min_size=2, max_size=2, unique=True),
)  # fmt: skip
def test_two_units_in_a_title_are_refused(style, units):
    with pytest.raises(UnitError, match=r"two units|unknown unit"):
        read_title("E " + style.format(*units))


@pytest.mark.parametrize(
    "title",
    ["E [W/m2/nm] x1000", "1000 x E [W/m2/nm]", "log10 E [W/m2/nm]", "E [W/m2/nm] (log)",
     "E² [W/m2/nm]", "1/E [W/m2/nm]", "E [W/m2/nm] %", "E [W/m2/nm] or [mW/m2/nm]",
     "E (W/m2/nm) (uW/cm2/nm)", "E [mW/m²·nm]"],
)  # fmt: skip
@pytest.mark.parametrize("command", ["convert", "dose", "spectrum"])
def test_every_command_refuses_an_altered_or_ambiguous_title(title, command):
    first = {"convert": "t", "dose": "t [s]", "spectrum": "nm"}[command]
    told = {
        "convert": ["-", "kW/m2/nm", "-d", ";", "--header", "--field", "2"],
        "dose": ["-"],
        "spectrum": ["-", "-g", "peak-wavelength"],
    }
    title = title if command == "spectrum" else title.replace("/nm", "")
    data = f"{first};{title}\n400;1\n500;2\n600;1\n"
    done = run(command, *told[command], input=data)
    assert (done.returncode, done.stdout) == (2, "")
    assert re.search(r"scales its|a function of|two units|unknown unit|calibrated", done.stderr)


# Names of quantities with units that they must accept: units of ISO 80000-7; PAR also in W/m2
# (FAO 56), and PPF also in the units of PPFD, its newer name.
NAMED = {
    "illuminance": ["lx", "klx", "fc", "lm/m2"],
    "Illuminance (desk)": ["lx"],
    "illuminance_2": ["lx"],
    "luminance": ["cd/m2", "fL", "EV"],
    "irradiance": ["W/m2", "umol/m2/s", "W/m2/nm"],
    "spectral irradiance": ["W/m2/nm", "W/m2/Hz"],
    "PPFD": ["umol/m2/s", "mol/m2/d", "umol/m2/s/nm"],
    "photons": ["umol/m2/s", "umol/s", "umol/m2/s/nm"],
    "PAR": ["umol/m2/s", "W/m2"],
    "PPF": ["umol/s", "umol/m2/s"],
    "jas": ["cd/m2"],
    "Osvětlenost": ["lx"],
    "сила света": ["cd"],
    "ozáření": ["J/m2", "W/m2"],
    "retinal illuminance": ["td", "lx"],
    "radiant flux": ["W", "dBm"],
    "luminous flux": ["lm", "lm/m"],
    "illuminance of the desk": ["lx", "cd/m2", "W/m2"],
    "photon energy": ["J"],
}
MISNAMED = {
    "illuminance": ["cd/m2", "W/m2", "lm", "td", "umol/m2/s"],
    "Illuminance (desk)": ["cd/m2"],
    "illuminance_2": ["W/m2"],
    "luminance": ["lx", "td"],
    "irradiance": ["cd/m2", "W/sr", "J/m2"],
    "spectral irradiance": ["W/m2"],
    "PPFD": ["lx", "W/m2", "W/m2/nm", "umol/s"],
    "photons": ["mW/m2/nm", "lx"],
    "PPF": ["W"],
    "jas": ["lx"],
    "Osvětlenost": ["W/m2"],
    "сила света": ["lx"],
    "retinal illuminance": ["cd/m2"],
    "luminous efficacy": ["lx"],
}


STYLES = ["{} [{}]", "{} ({})"]


@for_each([(n, u, s) for n, units in NAMED.items() for u in units for s in STYLES])
def test_a_name_of_the_quantity_of_the_unit_is_accepted(name, unit, style):
    assert read_title(style.format(name, unit)).unit.text == unit


@for_each([(n, u, s) for n, units in MISNAMED.items() for u in units for s in STYLES])
def test_a_name_of_another_quantity_than_that_of_the_unit_is_refused(name, unit, style):
    with pytest.raises(UnitError, match=r" names [^,]+, not ") as caught:
        read_title(style.format(name, unit))
    assert f"({unit})" in caught.value.message


@pytest.mark.parametrize(
    ("words", "titles"),
    [
        ("convert - fL --header", "illuminance [cd/m2]"),
        ("convert - fc --header", "PPFD [lx]"),
        ("convert - fc --header -d , --column PPFD", "t,PPFD\n,lx"),
        ("dose -", "t [s],illuminance [W/m2]"),
        ("dose -", "t [s],PPFD [lx]"),
        ("dose -", "t,illuminance\ns,W/m2"),
        ("dose - --unit W/m2", "t [s],illuminance"),
        ("spectrum -", "nm,PPFD [W/m2/nm]"),
        ("spectrum -", "nm,photons [mW/m2/nm]"),
    ],
)
def test_every_command_refuses_numbers_under_the_name_of_another_quantity(words, titles):
    data = f"{titles}\n400,1\n500,2\n600,1\n"
    done = run(*words.split(), input=data)
    assert (done.returncode, done.stdout) == (2, "")
    assert re.search(r" names \w+.*, not \w+| would be named ", done.stderr), done.stderr


def test_a_unit_is_found_whatever_else_is_in_the_title():
    assert unit_in("log E [lx]").text == "lx"
    assert unit_in("PAR_umol_m2_s", resolve_any("s")).text == "umol/m2/s"


@pytest.mark.parametrize(
    ("one", "other", "wanted"),
    [("lx", "lux", True), ("lx", "lm/m2", True), ("lx", "fc", False), ("lx", "radlux", False),
     ("umol/m2/s", "µmol m-2 s-1", True), ("dBm", "dB(mW)", True), ("dBm", "dBW", False),
     ("dBm", "mW", False), ("lx", "cd/m2", False), ("lx", "klx", False)],
)  # fmt: skip
def test_units_are_the_same_if_their_numbers_are(one, other, wanted):
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
        (["t", "light"], "2", 1),
        (["", ""], "2", 1),
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
        (
            ["t", "light"],
            "3",
            "it has no column '3'",
            "from 1 to 2, or one of the titles: t; light",
        ),
        (["t", "light"], "0", "it has no column '0'", "from 1 to 2"),
        (["", ""], "3", "it has no column '3'", "from 1 to 2"),
        (["t", "lux_1"], "1", "it has the column '1' 2 times", "t (field 1), lux_1 (field 2)"),
        ([], "x", "it has no column 'x'", "a title for each column"),
    ],
)
def test_a_missing_or_repeated_column_is_refused(titles, name, message, hint):
    with pytest.raises(UsageError) as caught:
        find(titles, name, "it")
    assert message in caught.value.message
    assert hint in caught.value.hint
