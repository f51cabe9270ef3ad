"""The manual's pages agree with the command line, and their examples run as shown."""

import re
import runpy
import subprocess
from functools import cache
from pathlib import Path

import click
import pytest
from conftest import ROOT
from helpers import displayed, displays_of, for_each, require
from test_cases import answered

from radcalc.calculators import COMMANDS
from radcalc.calculators.lists import manual_pages
from radcalc.cli import spelling
from radcalc.cli.command import commands
from radcalc.cli.lists import find_pages
from radcalc.quantities.names import QUANTITIES
from radcalc.units.compiled import PREFIX_NAMES, UNITS

MAN = ROOT / "man"
REWRITTEN = runpy.run_path(str(ROOT / "docs" / "manual.py"))["rewritten"]
PAGES = {f"{path.stem}({path.suffix[1:]})": path for path in manual_pages()}
SOURCES = {name: path.read_text(encoding="utf-8") for name, path in PAGES.items()}
MAIN, STREAMS = "radcalc(1)", "radcalc-streams(7)"
ELSEWHERE = {"man(1)", "numfmt(1)", "qalc(1)", "units(1)"}
# Messages in the DIAGNOSTICS of the pages, with calls that produce them.
PRODUCED = {
    "cannot convert radiant flux": "convert 5 W lm",
    "cannot convert luminous flux": "convert 5 lm kg",
    "--area 3m2 contradicts": "convert 800 lm lx --radius 1m --area 3m2",
    "--distance does not apply": "convert 100 lx fc --distance 2m",
    "--exponent cannot be used with": "convert 800 lm cd --exponent 3 --half-angle 30deg",
    "--solid-angle does not link": "convert 800 cd/m2 lx --solid-angle 1sr",
    "the unit of --distance 2": "convert 100 cd lx --distance 2",
    "--reflectance 1.2 is": "convert 500 lx cd/m2 --reflectance 1.2",
    "900nm is invisible": "convert 5 lm W --wavelength 900nm",
    "the result in nm": "convert 1e307 m nm",
    "the observer is on": "solid-angle sphere --radius 2m --distance 1m",
    "--radius does not apply": "solid-angle cone --half-angle 30deg --radius 2m",
    "--flux 800lm contradicts": "point-source --flux 800lm --intensity 100cd",
    "--incidence 30deg needs further inputs": "point-source --flux 1lm --incidence 30deg",
    "the inputs do not give": "point-source --flux 800lm --distance 2m -g exposure",
    "--luminous-flux 900lm contradicts": "point-source --flux 800lm --luminous-flux 900lm",
    "--luminous-intensity is": "point-source --radiant-flux 3W --luminous-intensity 5cd",
    "no light arrives": "point-source --illuminance 3lx --distance 2m --incidence 100deg",
    "a reflectance of 1.25664": "lambertian --incident-illuminance 500lx --luminance 200cd/m2",
    "--distance 2m is too": "lambertian --luminance 5cd/m2 --area 1m2 --distance 2m",
    "--incidence 89deg": "lambertian --luminance 5cd/m2 --area 1m2 --distance 9m --incidence 89deg",
    "the lobe varies": "point-source --intensity 9cd --exponent 9 --distance 1m --incidence 45deg "
    "--receiver-area 1m2",
    "a calorimeter measures": "calorimeter --flux 5lm --time 1s",
    "a table of 999001 answers": "point-source --flux 1lm --distance 1m:1000m:1mm",
    "unknown unit": "convert 5 LX fc",
    "'carcel'": "convert 5 carcel cd",
    "the unit 'W/m^2 sr'": "convert '5 W/m^2 sr' to W/m2/sr",
    "'1,5 lx'": "convert 1,5 lx fc",
    "stdin, line 2, field 3": "printf 'a b 1\\na b x\\n' | radcalc convert - lx fc --field 3",
    "stdin, line 2: field 3 is missing": "printf 'a b 1\\na b\\n' | radcalc convert - lx fc "
    "--field 3",
    "stdin, line 2: a quoted": "printf '1,2\\n\"1,2\\n' | radcalc convert - lx fc -d , --field 1",
    "the manual has no page": "manual photons",
    "cannot write the answer": "convert 1 lx fc > /dev/full",
}


def mandoc(path: Path, *words: str) -> subprocess.CompletedProcess[str]:
    require("mandoc")
    return subprocess.run(
        ["mandoc", *words, str(path)], capture_output=True, text=True, encoding="utf-8", timeout=60
    )


@cache
def rendered(name: str, width: int = 500) -> str:
    """Return a page without overstrikes, by default so wide that no word is broken."""
    done = mandoc(PAGES[name], "-T", "utf8", "-O", f"width={width}")
    assert done.returncode == 0, done.stderr
    return re.sub(".\b", "", done.stdout)


def contexts() -> dict[str, click.Context]:
    """Return the context of each command under the name of its page, with `radcalc` itself."""
    top = click.Context(commands, info_name="radcalc", **commands.context_settings)
    found = {MAIN: top}
    for name in commands.list_commands(top):
        command = commands.get_command(top, name)
        assert command is not None
        found[f"radcalc-{name}(1)"] = click.Context(
            command, info_name=name, parent=top, **command.context_settings
        )
    return found


CONTEXTS = contexts()


def options(context: click.Context) -> list[click.Option]:
    return [p for p in context.command.get_params(context) if isinstance(p, click.Option)]


def spellings(context: click.Context) -> set[str]:
    return {s for option in options(context) for s in (*option.opts, *option.secondary_opts)}


@for_each(CONTEXTS)
def test_every_command_and_every_option_has_help(page):
    context = CONTEXTS[page]
    assert context.command.help
    assert [option.opts for option in options(context) if not option.help] == []


@pytest.mark.parametrize("width", [20, 40, 80, 100])
def test_the_help_lists_the_commands_as_click_would_if_it_imported_them(width):
    ours, clicks = (click.HelpFormatter(width=width) for _ in range(2))
    commands.format_commands(CONTEXTS[MAIN], ours)
    click.Group.format_commands(commands, CONTEXTS[MAIN], clicks)
    rows, expected = (
        sorted(line.rstrip() for line in made.getvalue().split("\n") if line[:1] == " ")
        for made in (ours, clicks)
    )
    assert rows == expected  # only the groups are ours
    assert "  convert" in "\n".join(rows)


@for_each(CONTEXTS)
def test_a_help_names_its_page(page):
    context = CONTEXTS[page]
    last = context.command.get_help(context).rpartition("\n\nManual: radcalc manual")[2]
    assert find_pages(last.split())[0] == PAGES[page]


def test_every_command_has_a_page():
    first = {name for name in PAGES if name.endswith("(1)")}
    assert first == {MAIN, *(f"radcalc-{name}(1)" for name in COMMANDS)}


@for_each(PAGES)
def test_a_page_has_the_sections_of_its_kind(name):
    sections = re.findall(r"^\.Sh (.+)$", SOURCES[name], re.M)
    first = ["NAME", "SYNOPSIS", "DESCRIPTION"] if name.endswith("(1)") else ["NAME", "DESCRIPTION"]
    assert sections[: len(first)] == first
    wanted = {"OPTIONS", "EXAMPLES", "SEE ALSO"} if name.endswith("(1)") else {"SEE ALSO"}
    assert wanted <= set(sections)
    title = re.search(r"^\.Dt (\S+) (\d)$", SOURCES[name], re.M)
    assert title
    assert f"{title[1].lower()}({title[2]})" == name


@pytest.mark.parametrize("name", PAGES)
def test_the_generated_parts_are_up_to_date(name):
    assert REWRITTEN(SOURCES[name]) == SOURCES[name]  # python docs/manual.py


@for_each(PAGES)
def test_a_page_is_clean_mdoc(name):
    done = mandoc(PAGES[name], "-T", "lint", "-W", "warning")
    assert (done.returncode, done.stdout) == (0, "")


@for_each(PAGES)
def test_the_pages_that_a_page_names_exist(name):
    named = re.findall(r"^\.(?:It )?Xr (\S+) (\d)", SOURCES[name], re.M)
    assert named
    assert {f"{page}({section})" for page, section in named} <= {*PAGES, *ELSEWHERE}
    sections = re.findall(r"^\.Sx (.+?)(?: [.,;])?$", SOURCES[name], re.M)
    assert set(sections) <= set(re.findall(r"^\.S[hs] (.+)$", SOURCES[name], re.M))


def test_the_main_page_leads_to_every_other():
    named = re.findall(r"^\.(?:It )?Xr (\S+) (\d)", SOURCES[MAIN], re.M)
    assert {*PAGES} - {f"{page}({section})" for page, section in named} == {MAIN}


def described(name: str) -> set[str]:
    """Return the options that are list items in a page's OPTIONS."""
    section = re.search(r"^OPTIONS\n(.*?)^\S", rendered(name), re.M | re.S)
    assert section
    items = re.findall(r"^ {5}((?:--?[\w-]+(?:, )?)+)", section[1], re.M)
    return {spelling for item in items for spelling in item.split(", ") if spelling}


@for_each(CONTEXTS)
def test_a_page_describes_every_option_of_its_command_and_no_other(name):
    of_all = {"-n", "--number", "--auto", "--precision"}  # refused by lists of units and names
    if name == MAIN:
        shared = spellings(CONTEXTS["radcalc-units(1)"])
        assert described(name) == spellings(CONTEXTS[name]) | shared
        return
    found = described(name)
    hidden = spellings(CONTEXTS[name]) - found
    if "--get" in found and hidden - of_all:
        assert hidden == described(STREAMS)
    else:
        assert hidden <= of_all
    assert found <= spellings(CONTEXTS[name])


@for_each(PAGES)
def test_every_option_that_a_page_names_exists(name):
    named = set(re.findall(r"(?<![\w-])--[a-z][\w-]*", rendered(name)))
    understood = spelling.ENDS  # words of other tools
    assert named - set().union(understood, *map(spellings, CONTEXTS.values())) == set()


def test_the_options_of_a_command_have_the_titles_of_its_help():
    section = re.search(r"^OPTIONS\n(.*?)^\S", rendered("radcalc-point-source(1)"), re.M | re.S)
    assert section
    titles = re.findall(r"^ {5}([A-Z][\w, ]+):$", section[1], re.M)
    assert titles == [
        "Light",
        "Directions",
        "Receiver",
        "Radiant, luminous and photon quantities",
        "Results",
        "Output",
    ]


def test_the_parts_of_an_argument_are_distinguished():
    source = SOURCES["radcalc-ev(1)"]
    assert ".It Fl g , Fl -get Ar NAME Ns Oo : Ns Ar UNIT Oc\n" in source
    assert ".It Fl -check Oo Ar NAME Ns = Oc Ns Ar VALUE Ns Oo Ar UNIT Oc\n" in source


def test_the_pages_have_every_quantity_unit_and_prefix():
    quantities, units = rendered("radcalc-quantities(7)"), rendered("radcalc-units(7)")
    for quantity in QUANTITIES:
        assert f" {quantity.names('en')[0]} ({quantity.symbol}, {quantity.unit})\n" in quantities
        assert quantity.definition in quantities
    for name in UNITS:
        assert re.search(rf"^ {{5}}{name}(?:,| |$)", units, re.M), name
    for name, power in PREFIX_NAMES.items():
        assert re.search(rf"^ {{5}}{name} .* 10\^{power}$", units, re.M), name


# From CIE's vocabulary: I = dPhi/dOmega and E = dPhi/dA link lm with cd and lx.
@pytest.mark.parametrize(
    ("quantity", "line"),
    [
        ("luminous flux", "with a solid angle: luminous intensity"),
        ("luminous flux", "with an area: luminous exitance"),
        ("illuminance", "with a time: luminous exposure"),
        ("luminance", "with the pupil's diameter: retinal illuminance"),
    ],
)
def test_a_quantity_names_the_conditions_that_lead_to_another(quantity, line):
    item = rendered("radcalc-quantities(7)").partition(f"\n     {quantity} (")[2]
    assert f"- {line}\n" in re.sub(r"- +", "- ", item.partition("\n\n")[0] + "\n")


# The inverse square law, a cosine-power lobe's flux over its peak, a Gaussian beam's width far
# from a waist of the diameter D, and the lumen method.
@pytest.mark.parametrize(
    ("name", "law"),
    [
        ("radcalc-point-source(1)", "E = I cos(theta) Omega0 / d^2 [ISO 80000-7"),
        ("radcalc-point-source(1)", "Omega = 2 pi Omega0 / (n + 1)"),
        ("radcalc-laser(1)", "D_s = sqrt(D^2 + (phi d)^2)"),
        ("radcalc-room(1)", "E = n Phi U MF / A"),
    ],
)
def test_a_page_has_the_laws_of_its_command(name, law):
    section = re.search(r"^LAWS\n(.*?)^\S", rendered(name), re.M | re.S)
    assert section
    assert law in section[1]


def test_incident_light_is_not_one_step_from_light_that_leaves_another_surface():
    item = rendered("radcalc-quantities(7)").partition("\n     radiant exposure (")[2]
    leads = item.partition("\n\n")[0]
    assert "irradiance" in leads
    assert "exitance" not in leads


TRANSCRIPTS = [
    pytest.param(command, output, id=f"{name}: {command}")
    for name in PAGES
    if name != "radcalc-examples(7)"  # generated from a transcript of test_cases
    for command, output in displays_of(SOURCES[name])
]


@pytest.mark.parametrize(("command", "output"), TRANSCRIPTS)
def test_an_example_prints_what_the_page_shows(command, output):
    """Compare words: the page folds long lines and has blanks instead of tabs."""
    printed, status = answered(command.replace("\\\n", " "))
    assert [*printed.split(), *([f"[{status}]"] if status else [])] == output.split()


@for_each(PAGES)
def test_no_line_of_a_display_is_wider_than_80_columns(name):
    wide = [line for line in rendered(name, 80).splitlines() if len(line) > 80]
    assert wide == []


@for_each(COMMANDS)
def test_every_command_has_examples_that_run(name):
    ran = [command for command, _ in displays_of(SOURCES[f"radcalc-{name}(1)"])]
    assert any(f"radcalc {name}" in command for command in ran)


DIAGNOSTICS = [
    displayed(message)
    for source in SOURCES.values()
    for message in re.findall(
        r"^\.It Li (.+)$", source.partition(".Sh DIAGNOSTICS")[2].partition(".Sh ")[0], re.M
    )
]


@for_each(DIAGNOSTICS)
def test_a_message_in_the_manual_is_the_one_printed(message):
    (words,) = [words for start, words in PRODUCED.items() if message.startswith(start)]
    printed, status = answered(words if words.startswith("printf") else f"radcalc {words}")
    assert status == 2
    assert f"radcalc: {message}" in printed


def test_an_unknown_mark_is_refused():
    with pytest.raises(KeyError):
        REWRITTEN('.\\" generated: nothing\n.\\" end of generated\n')
    with pytest.raises(KeyError):
        REWRITTEN('.\\" generated: options of nothing\n.\\" end of generated\n')
