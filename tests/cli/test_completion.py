"""Completion: units in reach, options and their values, results and files, in three shells."""

from itertools import product

import pytest
from conftest import run
from helpers import for_each

from radcalc import completion
from radcalc.completion import completions
from radcalc.completion.table import COMMANDS, UNITS
from radcalc.completion.words import READERS, Completion
from radcalc.conversion.plan import plan, target_of
from radcalc.errors import MissingCondition
from radcalc.quantities import lookup, name_of
from radcalc.units import Unit
from radcalc.units.table import unit_of
from radcalc.units.values import resolve_any


def complete(line: str) -> list[Completion]:
    """Return the suggestions at the end of a line without quotes."""
    *words, last = line.split(" ")
    return completions(words, last)


def texts(line: str) -> list[str]:
    return [one.text for one in complete(line)]


def said(line: str, text: str) -> str:
    return next(one.description for one in complete(line) if one.text == text)


# ---------------------------------------------------------------------------------------------
# The targets of a conversion


@pytest.mark.parametrize("line", ["100 lx ", "convert 100 lx ", "100lx ", "convert 100 lx to "])
def test_units_of_the_quantity_come_before_those_with_a_condition(line):
    found = texts(line)
    own = ["klx", "fc", "ph", "lm/m2"]
    others = ["cd", "W/m2", "umol/m2/s", "cd/m2", "lm"]
    assert found == list(dict.fromkeys(found))
    assert max(map(found.index, own)) < min(map(found.index, others))


@pytest.mark.parametrize(
    ("line", "target", "condition"),
    [
        ("100 lx ", "cd", "luminous intensity, with --distance"),
        ("100 lx ", "W/m2", "irradiance, with --wavelength, --spectrum or --efficacy"),
        ("500 lm ", "cd", "luminous intensity, with --isotropic, --half-angle or --solid-angle"),
        ("5 W ", "J", "radiant energy, with --time"),
        ("250 cd/m2 ", "td", "retinal illuminance, with --pupil"),
        ("100 lx ", "fc", "footcandle"),
        ("100 lx ", "lm/ft2", "illuminance"),
    ],
)
def test_a_target_is_described_with_its_conditions(line, target, condition):
    assert said(line, target) == condition


SOURCES = ["lx", "W", "cd/m2", "umol/m2/s", "lm.s", "W/m2/nm", "nm", "dBm", "EV", "K"]


@for_each(product(SOURCES, ["", "l", "m", "W/m", "p"]))
def test_a_suggested_target_converts_or_lacks_the_condition_described(source, typed):
    unit = resolve_any(source)
    for one in complete(f"1 {source} {typed}"):
        is_free = "with --" not in one.description
        try:
            plan(unit, target_of(one.text, unit))
        except MissingCondition:
            assert not is_free, one
        else:
            assert is_free, one


def test_conditions_that_are_typed_are_taken_into_account():
    found = texts("800 lm --isotropic --distance 2m ")
    assert found[0] == "lx"
    assert said("800 lm --isotropic --distance 2m ", "lx") == "lux"
    assert "--" not in said("800 lm --isotropic ", "cd")
    assert texts("800 lm --isotropic --distance 1m,2m ")[0] == "lx"
    assert texts("5 mW --wavelength 632.8nm ")[0] == "lm"
    for spectrum in ("LED-B3", "no-such-file", "-"):
        assert texts(f"5 mW --spectrum {spectrum} ")[0] == "lm"


def test_a_compound_unit_completes_by_its_last_part():
    assert {"W/m2", "W/m2/sr"} <= set(texts("100 lx W/m"))
    assert "umol/m2/s" in texts("100 lx umol/m2/")
    assert "W/m2/nm" in texts("1 W/m2/um W/m2/")
    assert "W/m^2" in texts("100 lx W/m^")
    assert "kW/ft2" in texts("100 lx kW/ft")
    assert "m-2" in texts("5 W m-2 to mW ")
    assert texts("100 lx W.m-2.s") == ["W.m-2.s", "W.m-2.sr-1"]


def test_quantities_are_targets_by_their_names():
    assert said("100 lx ppf", "ppfd") == ("umol/m2/s, with --wavelength, --spectrum or --efficacy")
    assert said("100 fc ill", "illuminance") == "lx"
    assert said("100 lx luminous-ex", "luminous-exitance") == "lm/m2, with --reflectance"
    assert "luminous-intensity" in texts("100 lm --isotropic lumi")
    assert said("100 lm flu", "flux") == "of the same kind of light"
    assert "solid-angle" not in texts("100 lx sol")
    assert texts("quantities svě") == texts("units svě")
    assert "světelný-tok" in texts("quantities svě")


def test_scales_are_units_too():
    assert said("100 lx ", "EV") == "an illuminance at ISO 100"
    assert said("100 cd/m2 ", "EV") == "a luminance at ISO 100"
    assert {"mW", "W", "dBW"} <= set(texts("10 dBm "))
    assert "dBm" not in texts("10 dBm ")
    assert {"cd/m2", "lx"} <= set(texts("10 EV "))
    assert texts("4000 K mi") == ["mired", "mireds", "mirek", "mireks"]
    assert texts("point-source --flux 10dB") == ["10dBm", "10dBW", "10dBu(W)"]


def test_an_expression_has_the_targets_of_its_unit():
    assert texts("500lx*20m2/0.48 k")[0] == "klm"
    assert next(one.text for one in completions(["500 lx * 20 m2 / (0.6*0.8)"], "kl")) == "klm"
    assert texts("10**10**10 lx k") == []


@pytest.mark.parametrize(
    "value",
    [
        "100+-3 lx", "100 ± 3 lx", "100 lx ± 3 lx", "100(3) lx", "(100±3) lx",
        "100+-3,200+-5 lx", "100+-3lx,200+-5lx",
    ],
)  # fmt: skip
def test_an_uncertain_value_has_targets(value):
    assert texts(f"{value} k")[0] == texts(f"{value} to k")[0] == "klx"
    assert texts(f"{value} fc ") == texts("100 lx fc ")


def test_lists_complete_at_their_ends():
    assert texts("100,200,400 lx k")[0] == "klx"
    assert texts("1:5:1 m k")[0] == texts("1m:5m:1m k")[0] == "km"
    assert texts("100lx,200lx to k")[0] == texts("100,200,400 lx to k")[0] == "klx"
    assert texts("100 lx fc,kl")[0] == "fc,klx"
    assert texts("100 lx fc,cd ") == ["--distance"]


def test_operands_other_than_targets():
    assert texts("100l")[:2] == ["100lm", "100lx"]
    assert "cd/m2" in texts("convert 250 c")
    assert texts("convert - lx f")[0] == "fc"
    assert texts("convert 100 lx fc x") == []
    assert texts("100 lx fc lm") == []
    assert texts("100 lx nosuch") == texts("100 nosuch ") == []


def test_options_that_a_conversion_lacks_are_offered_first():
    assert texts("100 lx cd ") == ["--distance"]
    assert texts("800 lm lx --isotropic ") == ["--distance"]
    assert texts("100 lx cd --")[0] == "--distance"


# ---------------------------------------------------------------------------------------------
# Commands, options and their values


def test_commands_have_their_descriptions():
    assert texts("conv") == ["convert"]
    assert said("", "spectrum") == "Peak, efficacies and colour of a spectrum."
    assert texts("help sp") == ["spectrum"]
    assert texts("help illumina")[0] == "illuminance"
    assert texts("examples muse") == ["museum"]
    assert texts("manual sentenc") == ["sentences"]
    assert texts("nosuch ") == []
    assert texts("--v") == texts("--version") == ["--version"]
    assert "--version" in texts("-")
    assert texts("-h") == texts("convert -h") == ["-h"]
    assert "-h" not in texts("-") + texts("convert -")
    assert texts("-5")[:1] == []


def test_a_hidden_name_completes_if_no_other_fits():
    assert texts("lambertian --lum")[0] == "--luminance"
    assert "--luminous-flux" in texts("lambertian --lum")
    assert not {"--luminance", "--illuminance"} & set(texts("lambertian --"))
    assert texts("lambertian --i") == [
        "--intensity",
        "--irradiance",
        "--incident-irradiance",
        "--incidence",
    ]


def test_an_option_is_offered_once_unless_it_repeats():
    assert "--distance" not in texts("point-source --distance 2m --")
    assert "--get" in texts("point-source -g height --")
    assert texts("point-source -- --") == []


@for_each(
    [
        ("point-source --distance 2", ["2m", "2cm"]),
        ("point-source --distance=2", ["--distance=2m", "--distance=2cm"]),
        ("point-source --distance 1m,2c", ["1m,2cm"]),
        ("point-source --distance 1m:5m:1", ["1m:5m:1m", "1m:5m:1cm"]),
        ("point-source --distance ", ["2m"]),
        ("point-source --half-angle 30", ["30deg", "30rad"]),
        ("solid-angle cone --half-angle pi/6", ["pi/6deg", "pi/6rad"]),
        ("lambertian --luminance 100", ["100cd/m2"]),
        ("convert 5 mW lm --spectrum=LED-B3", ["--spectrum=LED-B3"]),
        ("convert 5 mW lm --spectrum black", ["blackbody:"]),
        ("convert 5 mW lm --spectrum blackbody:3000", ["blackbody:3000K"]),
        ("convert 5 mW lm --observer sco", ["scotopic"]),
        ("photon 555", ["555nm"]),
        ("solid-angle con", ["cone"]),
        ("lambertian re", ["rectangle"]),
        ("sky ov", ["overcast"]),
        ("environment sky:ov", ["sky:overcast"]),
        ("point-source --distribution co", ["cone"]),
        ("point-source -g lumi", ["luminous-flux", "luminous-intensity"]),
        ("point-source -g ", ["flux", "intensity", "irradiance", "exposure", "energy"]),
        ("environment map.hdr --unit c", ["cd/m2"]),
        ("point-source -g illuminance:", ["illuminance:lx"]),
        ("point-source --check beam-fl", ["beam-flux="]),
        ("point-source --check flux=800l", ["flux=800lm"]),
        ("spectrum LED-B3 -g cc", ["cct"]),
        ("spectrum LED-B3 LPS", ["LPS"]),
        ("lambertian disc LPS", []),
        ("convert 1 lx fc --format j", ["json"]),
    ],
)
def test_values(line, first):
    assert texts(line)[: len(first)] == first


@for_each(
    [
        ("100 lm l", "lx", "lm.s"),
        ("100 lm ", "cd", "lm.s"),
        ("convert 5 W/m2 u", "umol/m2/s", "umol/m2"),
    ]
)
def test_light_comes_before_energy_and_exposure(line, likely, other):
    found = texts(line)
    assert found.index(likely) < found.index(other)


def test_the_words_of_typical_values_find_values():
    found = texts("typical ")
    assert {"moon", "illuminance", "jas", "освещённость"} <= set(found)
    assert texts("typical moo") == ["moon"]
    assert all(lookup.search_typical(text) for text in found)


def test_named_spectra_have_descriptions():
    """CIE 15:2018 lists 4103 K for LED-B3 and 2856 K for A."""
    assert said("spectrum LED-B3", "LED-B3") == "4102 K, LED, blue and phosphor"
    assert said("spectrum A", "A") == "2856 K, incandescent"


def test_only_files_of_the_kind_are_offered_or_all_if_there_are_none(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for name in ("lamp.ies", "lamp.csv", "notes.md", ".hidden.csv", "map.hdr"):
        (tmp_path / name).touch()
    (tmp_path / "lamps").mkdir()
    (tmp_path / "lamps" / "a.ldt").touch()
    assert texts("point-source --distribution lam") == ["lamp.ies", "lamp.csv", "lamps/"]
    assert texts("point-source --distribution lamps/") == ["lamps/a.ldt"]
    assert texts("scene ") == ["lamp.csv", "lamps/"]
    assert texts("scene .") == [".hidden.csv"]
    assert texts("scene no") == ["notes.md"]
    assert texts("environment m") == ["map.hdr"]
    assert not complete("scene lamps")[0].closes
    assert texts("scene nosuch/") == []


def test_after_plot_come_figures_folders_and_operands(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for name in ("day.svg", "day.png", "D65.txt", "notes.md"):
        (tmp_path / name).touch()
    (tmp_path / "figures").mkdir()
    assert texts("spectrum D65 --plot ")[:3] == ["day.svg", "day.png", "figures/"]
    assert texts("spectrum D65 --plot=da") == ["--plot=day.svg", "--plot=day.png"]
    assert texts("photon 555nm --plot no") == []
    assert texts("spectrum --plot D65") == ["D65", "D65.txt"]
    assert texts("spectrum --plot day.svg D65") == ["D65", "D65.txt"]
    assert "--json" in texts("spectrum D65 --plot -")


def test_the_error_of_an_irradiance_has_its_units():
    assert "error:lx" in texts("environment room.hdr -g error:")
    assert "error:sr" not in texts("environment room.hdr -g error:")


def test_every_form_has_a_reader():
    forms = {option[1] for _, _, listed in COMMANDS.values() for option in listed}
    forms |= {operands[0] for _, operands, _ in COMMANDS.values()}
    assert forms - READERS.keys() == {"flag", "word", "conversion"}


@for_each(UNITS)
def test_the_units_of_a_quantity_measure_it(quantity):
    units = [unit for text, _ in UNITS[quantity] if (unit := unit_of(text))]  # except scales
    assert len({unit.dimension for unit in units}) <= 1
    unnamed = [Unit("", 1, 1, unit.dimension, ()) for unit in units[:1]]  # lx_mel names an EDI
    assert {*map(name_of, unnamed)} <= {quantity}


# ---------------------------------------------------------------------------------------------
# The line of a shell

BREAKS = " \t\n\"'><=;|&(:"  # as bash splits them


@pytest.mark.parametrize(
    ("line", "words", "word", "cut"),
    [
        ("radcalc ", ["radcalc"], "", 0),
        ("radcalc 100 lx f", ["radcalc", "100", "lx"], "f", 0),
        ("radcalc '500 lx * 2' k", ["radcalc", "500 lx * 2"], "k", 0),
        ("radcalc '500 l", ["radcalc"], "500 l", 0),
        ('radcalc "500 \\"l', ["radcalc"], '500 "l', 0),
        ("radcalc a\\ b", ["radcalc"], "a b", 0),
        ("radcalc a\\", ["radcalc"], "a", 0),
        ("radcalc -g irradiance:l", ["radcalc", "-g"], "irradiance:l", 11),
        ("radcalc --spectrum=blackbody:30", ["radcalc"], "--spectrum=blackbody:30", 21),
        ("radcalc x'ISO 7", ["radcalc"], "xISO 7", 1),
        ("A=1 B='2 3' radcalc 1", ["radcalc"], "1", 0),
        ("radcalc - lx fc 2>/dev/null <da", ["radcalc", "-", "lx", "fc"], "da", 0),
        ("radcalc '' x", ["radcalc", ""], "x", 0),
    ],
)
def test_the_words_of_a_line(line, words, word, cut):
    typed = completion.Typed(line, BREAKS)
    assert (typed.words, typed.word, typed.cut) == (words, word, cut)


@pytest.fixture
def ask(monkeypatch, capfd):
    """Return the completion that a shell gets for a line; radcalc prints no errors."""

    def answered(shell: str, line: str) -> str:
        monkeypatch.setenv("COMP_LINE", line)
        monkeypatch.setenv("COMP_WORDBREAKS", BREAKS)
        assert completion.answer_shell(f"{shell}_complete") == 0
        out, err = capfd.readouterr()
        assert err == ""
        return out

    return answered


def test_the_installed_command_answers_a_shell(monkeypatch):
    monkeypatch.setenv("_RADCALC_COMPLETE", "bash_complete")
    monkeypatch.setenv("COMP_LINE", "radcalc conv")
    done = run()
    assert (done.returncode, done.stdout, done.stderr) == (0, "convert \n", "")


def test_bash_gets_the_replacement_with_a_trailing_blank(ask):
    assert ask("bash", "radcalc point-source -g illuminance:klx") == "klx \n"
    assert ask("bash", "radcalc spectrum ISO\\ 7589\\ Ph").splitlines() == [
        "ISO\\ 7589\\ Photographic\\ Daylight ",
        "ISO\\ 7589\\ Photoflood ",
    ]
    assert ask("bash", "radcalc spectrum 'ISO 7589 Photog") == "ISO 7589 Photographic Daylight\n"


def test_zsh_and_fish_get_the_full_description(ask):
    line = "Convert between units, and between quantities that a condition links."
    assert ask("zsh", "radcalc conv") == f" convert\tconvert  -- {line}\n"
    assert ask("fish", "radcalc conv") == f"convert\t{line}\n"
    assert (
        ask("zsh", "radcalc point-source -g illuminance:klx")
        == " illuminance:klx\tilluminance:klx  -- kilolux\n"
    )


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
@pytest.mark.parametrize(
    "line",
    [
        "",
        " ",
        "radcalc '",
        'radcalc "',
        "radcalc \\",
        "radcalc -- ",
        "radcalc convert --",
        "radcalc convert -- -",
        "radcalc nosuch --",
        "radcalc convert '' ''",
        "radcalc convert '' x",
        "radcalc 100 ",
        "radcalc 1e999 lx ",
        "radcalc (((((",
        "radcalc 10**10**10 lx ",
        "radcalc convert 100 \udcff\udcfe",
        "radcalc scene \udcff/",
        "radcalc 100 lx --distance \u2212",
        "radcalc point-source -g :",
        "radcalc point-source --check =",
        "radcalc point-source --distance ,",
        "radcalc --distance",
        "radcalc 100 lx to to ",
        "radcalc in in",
        "radcalc lambertian --spectrum \x1b[",
    ],
)
def test_completion_never_prints_an_error(shell, line, ask):
    ask(shell, line)


@for_each(["20000 cd at ", "20000 cd at 8 m ", "20000 cd at 8 m to ", "isotropic 800 lm "])
def test_tab_in_a_sentence_offers_options_or_nothing(line):
    assert all(text.startswith("--") for text in texts(line))
