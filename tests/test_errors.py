"""The text of every error at each gate; a user's text is never taken for a mention."""

import inspect
import pickle
import re
from collections.abc import Callable
from itertools import product
from typing import Any

import pytest
from conftest import ROOT, run
from helpers import for_each, shell
from hypothesis import given, settings
from hypothesis import strategies as st

from radcalc import errors
from radcalc.api.result import in_python as of_function
from radcalc.calculators import COMMANDS
from radcalc.calculators.integrate import integrate
from radcalc.calculators.point_source import point_source
from radcalc.calculators.results import pick
from radcalc.calculators.solid_angle import solid_angle
from radcalc.conversion.operands import read_operands
from radcalc.conversion.plan import plan
from radcalc.errors import (
    END,
    START,
    VALUE,
    WORD,
    ConditionError,
    Contradiction,
    Exclusive,
    ExpressionError,
    HorizonCuts,
    Idle,
    Impossible,
    LineError,
    MissingCondition,
    MissingInput,
    MissingUnit,
    NumberError,
    OutOfRange,
    OutputError,
    RadcalcError,
    SeveralReadings,
    TooNarrow,
    TooNear,
    UnitError,
    Unused,
    UsageError,
    WrongQuantity,
    command,
    manual,
    measured,
    option,
    options,
    quote,
)
from radcalc.inputs.places import read_direction, read_point
from radcalc.inputs.reading import read, read_interval
from radcalc.quantities import lookup, search
from radcalc.quantities.symbols import SYMBOLS
from radcalc.units.numbers import parse_number
from radcalc.units.ranges import read_series
from radcalc.units.table import resolve


def plainly(error: RadcalcError) -> tuple[str, str]:
    message, _, hint = str(error).partition("\ntry: ")
    return message, hint


def in_python(error: RadcalcError) -> tuple[str, str]:
    """Return the message and hint as a function of `radcalc.api` raises them."""

    @of_function
    def call() -> None:
        raise error

    with pytest.raises(RadcalcError) as caught:
        call()
    return caught.value.message, caught.value.hint


GATES: dict[str, Callable[[RadcalcError], tuple[str, str]]] = {
    "the shell": shell, "no gate": plainly, "Python": in_python,
}  # fmt: skip
# an error, and its message and hint at each gate in turn
Said = tuple[str, str]
ERRORS: dict[str, tuple[Callable[[], RadcalcError], Said, Said, Said]] = {
    "an error without mentions has the same text at every gate": (
        lambda: RadcalcError("no answer", "another question"),
        *[("no answer", "another question")] * 3),
    "a number is refused with the same text at every gate": (
        lambda: NumberError("'1,5' has a comma in its number", "1.5"),
        *[("'1,5' has a comma in its number", "1.5")] * 3),
    "a number that is too large is refused with the same text at every gate": (
        lambda: OutOfRange("'1e400' is too large for a number", "less than 1.8e308"),
        *[("'1e400' is too large for a number", "less than 1.8e308")] * 3),
    "quantities are named at both gates": (
        lambda: ExpressionError(f"cannot add {measured('lx')} and {measured('lm')}", "one"),
        ("cannot add illuminance (lx) and luminous flux (lm)", "one"),
        ("cannot add 'lx' and 'lm'", "one"),
        ("cannot add illuminance (lx) and luminous flux (lm)", "one")),
    "a unit is refused with the same text at every gate": (
        lambda: UnitError("unknown unit 'zork'", "lx"), *[("unknown unit 'zork'", "lx")] * 3),
    "a failed write has no hint": (
        lambda: OutputError("cannot write: no space"), *[("cannot write: no space", "")] * 3),
    "a line is refused with the same text at every gate": (
        lambda: LineError("line 2: 'x' is not a number", "a number"),
        *[("line 2: 'x' is not a number", "a number")] * 3),
    "a conversion leads to another command": (
        lambda: errors.ConversionError("no condition links them",
                                       command("solid-angle", "cone", half_angle="1deg")),
        ("no condition links them", "radcalc solid-angle cone --half-angle 1deg"),
        ("no condition links them", "radcalc solid-angle cone half-angle=1deg"),
        # 2 pi (1 - cos 1 deg) sr
        ("no condition links them",
         'radcalc.solid_angle("cone", half_angle="1 deg")\n'
         "     solid_angle 0.00095696 sr, projected_solid_angle 0.000956887 sr")),
    "a condition leads to a Python function": (
        lambda: ConditionError("too near", command("lambertian", "disc", radius="1m")),
        ("too near", "radcalc lambertian disc --radius 1m"),
        ("too near", "radcalc lambertian disc radius=1m"),
        ("too near", 'radcalc.lambertian("disc", radius="1 m")')),
    "a range of too many values may be long in last place": (
        lambda: errors.TooMany("9 values", f"at most 8, or {option('distance')} last"),
        ("9 values", "at most 8, or --distance last"),
        ("9 values", "at most 8, or distance last"), ("9 values", "at most 8, or distance last")),
    "a result that is unknown has the names of those that are known": (
        lambda: errors.UnknownResult("unknown result 'x'", ["flux", "area"]),
        ("unknown result 'x'", "flux, area"), ("unknown result 'x'", "flux, area"),
        ("unknown result 'x'", "flux, area")),
    "an absent file has no mention": (
        lambda: errors.NoFile("there is no file 'lamp.ies'", "the path of a file"),
        *[("there is no file 'lamp.ies'", "the path of a file")] * 3),
    "a conversion of too many words may be a sentence": (
        lambda: errors.TooManyWords("too many words: 'lx to fc now'", errors.drop("now")),
        ("too many words: 'lx to fc now'", "leave out now"),
        ("too many words: 'lx to fc now'", "leave out now"),
        ("too many words: 'lx to fc now'", "leave out now")),
    "a patch that is near is refused with its distance and size": (
        lambda: TooNear(option("distance", "2m"), "source", "1.1", command("lambertian", "disc")),
        ("--distance 2m is too short: the size of the source is 1.1 m, and the inverse square "
         "law needs at least five times that", "radcalc lambertian disc"),
        ("distance 2m is too short: the size of the source is 1.1 m, and the inverse square "
         "law needs at least five times that", "radcalc lambertian disc"),
        ('distance="2 m" is too short: the size of the source is 1.1 m, and the inverse square '
         "law needs at least five times that", 'radcalc.lambertian("disc")')),
    "a tilt at which one patch cuts the other leads to a smaller tilt": (
        lambda: HorizonCuts("tilt", "89deg", "84.2deg", law="A1 A2 / d^2"),
        ("--tilt 89deg: the source's horizon may cut the receiver, and A1 A2 / d^2 does not hold",
         "--tilt 84.2deg, or as far past 90 deg, where there is no light"),
        ("tilt 89deg: the source's horizon may cut the receiver, and A1 A2 / d^2 does not hold",
         "tilt 84.2deg, or as far past 90 deg, where there is no light"),
        ('tilt="89 deg": the source\'s horizon may cut the receiver, and A1 A2 / d^2 does not '
         "hold", 'tilt="84.2 deg", or as far past 90 deg, where there is no light')),
    "a call leads to the manual": (
        lambda: UsageError("too little", manual("point-source")),
        ("too little", "radcalc point-source --help"), ("too little", "the help of point-source"),
        ("too little", "help(radcalc.point_source)")),
    "a missing condition is named with a placeholder": (
        lambda: MissingCondition(
            "a cone is missing", f"{option('half-angle', 'ANGLE')} or {option('isotropic')}",
            "lm", "cd", ["a cone"]),
        ("a cone is missing", "--half-angle ANGLE or --isotropic"),
        ("a cone is missing", "half-angle ANGLE or isotropic"),
        ("a cone is missing", "half_angle=ANGLE or isotropic=True")),
    "a missing input is named with an example": (
        lambda: MissingInput("the size is missing",
                             f"{option('radius', '10cm')} or {option('area', '1cm2')}"),
        ("the size is missing", "--radius 10cm or --area 1cm2"),
        ("the size is missing", "radius 10cm or area 1cm2"),
        ("the size is missing", 'radius="10 cm" or area="1 cm2"')),
    "a missing input is named alone if it has no example": (
        lambda: MissingInput("more is missing", options(("radius", "receiver-area"))),
        ("more is missing", "--radius or --receiver-area"),
        ("more is missing", "radius or receiver-area"),
        ("more is missing", "radius or receiver_area")),
    "a missing unit is written after the number": (
        lambda: MissingUnit("distance", "2", "2m"),
        ("the unit of --distance 2 is missing", "--distance 2m"),
        ("the unit of distance 2 is missing", "distance 2m"),
        ('the unit of distance="2" is missing', 'distance="2 m"')),
    "a value of another quantity goes to the option that takes it": (
        lambda: WrongQuantity(
            "--a takes a length, not time (s)", errors.add("time", "2s"), "distance", "2s"
        ),
        ("--a takes a length, not time (s)", "--time 2s"),
        ("--a takes a length, not time (s)", "time 2s"),
        ("--a takes a length, not time (s)", 'time="2 s"')),
    "an option that does not apply is left out": (
        lambda: Unused(("off-axis",), "to a disc"),
        ("--off-axis does not apply to a disc", "leave out --off-axis"),
        ("off-axis does not apply to a disc", "leave out off-axis"),
        ("off_axis does not apply to a disc", "leave out off_axis")),
    "two options that do not apply are left out": (
        lambda: Unused(("time", "width"), "here"),
        ("--time and --width do not apply here", "leave out --time and --width"),
        ("time and width do not apply here", "leave out time and width"),
        ("time and width do not apply here", "leave out time and width")),
    "an input that is not enough alone gets the inputs to add": (
        lambda: Idle(f"{option('half-angle', '30deg')} alone is not enough",
                     f"add {options(('flux', 'off-axis'))}"),
        ("--half-angle 30deg alone is not enough", "add --flux or --off-axis"),
        ("half-angle 30deg alone is not enough", "add flux or off-axis"),
        ('half_angle="30 deg" alone is not enough', "add flux or off_axis")),
    "a value out of range gets its limits": (
        lambda: Impossible("half-angle", "181deg", "at most 180 deg", "a turn"),
        ("--half-angle 181deg is out of range: a turn", "at most 180 deg"),
        ("half-angle 181deg is out of range: a turn", "at most 180 deg"),
        ('half_angle="181 deg" is out of range: a turn', "at most 180 deg")),
    "a range that is too narrow is to be wider": (
        lambda: TooNarrow("more than any light gives", f"a wider {option('photon-range')}"),
        ("more than any light gives", "a wider --photon-range"),
        ("more than any light gives", "a wider photon-range"),
        ("more than any light gives", "a wider photon_range")),
    "one of two exclusive options is enough": (
        lambda: Exclusive(("na", "f-number")),
        ("--na cannot be used with --f-number", "only one of them"),
        ("na cannot be used with f-number", "only one of them"),
        ("na cannot be used with f_number", "only one of them")),
    "a sentence with several readings has a call for each": (
        lambda: SeveralReadings("'24 deg beam' has 2 readings", "one of them"),
        ("'24 deg beam' has 2 readings", "one of them"),
        ("'24 deg beam' has 2 readings", "one of them"),
        ("'24 deg beam' has 2 readings", "one of them")),
    "a contradiction names the inputs": (
        lambda: Contradiction(f"{option('flux', '800lm')} contradicts the other inputs",
                              f"leave out one of {options(('flux', 'intensity'), ', ')}",
                              "flux", 800.0, 900.0),
        ("--flux 800lm contradicts the other inputs", "leave out one of --flux, --intensity"),
        ("flux 800lm contradicts the other inputs", "leave out one of flux, intensity"),
        ('flux="800 lm" contradicts the other inputs', "leave out one of flux, intensity")),
}  # fmt: skip


@for_each(product(GATES, ERRORS.values()))
def test_an_error_is_spelled_as_inputs_are_at_the_gate(gate, row):
    error, *said = row
    assert GATES[gate](error()) == said[list(GATES).index(gate)]


@for_each(ERRORS.values())
def test_an_error_reaches_another_process_unchanged(row):
    error = row[0]()
    arrived = pickle.loads(pickle.dumps(error))
    assert (type(arrived), arrived.args) == (type(error), error.args)
    assert vars(arrived) == vars(error)


def test_every_class_of_error_is_tested():
    classes = {one for one in vars(errors).values() if inspect.isclass(one)}
    classes -= {errors.Plain, errors.Try}
    assert {type(error()) for error, *_ in ERRORS.values()} == classes
    assert all(issubclass(one, RadcalcError) for one in classes)


def test_the_manual_lists_the_code_of_every_error():
    listed = (ROOT / "man" / "man1" / "radcalc.1").read_text().partition(".It Cm code")[2]
    codes = {error().code for error, *_ in ERRORS.values()}
    assert {*re.findall(r"^\.Cm ([a-z-]+)", listed.partition(".It")[0], re.M)} == codes


def test_an_error_has_attributes_for_programs():
    hint = f"{option('radius', '1m')} or {option('area')} (see {manual('ev')})"
    assert MissingInput("", hint).missing == {"an input": ("radius", "area")}
    assert Unused(["radius"], "here").symbols == Exclusive(["radius"]).symbols == ("radius",)
    impossible = Impossible("radius", "-1m", "more than 0")
    assert (impossible.symbol, impossible.text, impossible.limit) == (
        "radius", "-1m", "more than 0",
    )  # fmt: skip
    unit = MissingUnit("radius", "1", "1m")
    assert (unit.symbol, unit.text, unit.written) == ("radius", "1", "1m")
    missing = MissingCondition("", "", "lm", "cd", {"a cone": ("isotropic",)})
    assert (missing.source, missing.target) == ("lm", "cd")
    assert missing.missing == {"a cone": ("isotropic",)}
    assert (missing.code, MissingInput("", hint).code) == ("missing-condition", "missing-input")
    two = Contradiction("", "", "radius", 1.0, 2.0)
    assert (two.symbol, two.given, two.follows) == ("radius", 1.0, 2.0)


MARKS = START + VALUE + WORD + END


class Watcher:
    """Gate that accepts only radcalc's own mentions."""

    @staticmethod
    def option(name: str, value: str) -> str:
        assert name in SYMBOLS, name
        assert not set(value) & set(MARKS), value
        return ""

    @staticmethod
    def command(*words: str) -> str:
        assert words[0] in COMMANDS
        assert not set("".join(words)) & set(MARKS)
        return ""

    @staticmethod
    def manual(name: str) -> str:
        assert name in COMMANDS
        return ""

    @staticmethod
    def measured(unit: str) -> str:
        assert resolve(unit)
        return ""


LAMP = point_source({"flux": read("flux", "1lm")}).values
# Functions that take a user's text.
TAKES: dict[str, Callable[[str], Any]] = {
    "a number": parse_number,
    "a unit": resolve,
    "a unit to convert to": lambda text: plan(resolve(f"lx{text}"), resolve("cd")),
    "operands": lambda text: read_operands(["1", text, "to", "fc"]),
    "a value and its unit": lambda text: read_operands([text]),
    "a list": read_series,
    "an interval": lambda text: read_interval("polar", text),
    "a point": lambda text: read_point(text, "the vertex"),
    "a direction": lambda text: read_direction(text, "the direction"),
    "an expression": lambda text: integrate(text, {"sphere": read("sphere", True)}),
    "a result": lambda text: pick(LAMP, text),
    "a result's unit": lambda text: pick(LAMP, f"flux:{text}"),
    "a quantity's name": search.search,
    "a typical value's name": lookup.search_typical,
    "a shape's points": lambda text: solid_angle("polygon", {}, [read_point(text, "it")] * 3),
    **{f"--{name}": lambda text, name=name: read(name, text) for name in SYMBOLS},
    **{f"--{name} {symbol.example} and more":
       lambda text, symbol=symbol: read(symbol.name, symbol.example + text)
       for name, symbol in SYMBOLS.items() if symbol.example},
}  # fmt: skip
HOSTILE = st.one_of(
    st.text(alphabet=MARKS + "ax1:.,-m ", min_size=1, max_size=12),
    st.sampled_from([option("height", "6m"), command("convert"), manual("ev"), START, END + START]),
    st.builds("".join, st.lists(st.sampled_from([*MARKS, "height", "=", "6m"]), min_size=2)),
)


@given(text=HOSTILE)
@settings(max_examples=8)
def test_a_users_text_never_becomes_a_mention(text):
    for name, takes in TAKES.items():
        try:
            takes(text)
        except RadcalcError as error:
            said = [*error.spelled(Watcher)]
            said += [part for gate in GATES.values() for part in gate(error)]
            assert not set("".join(said)) & set(MARKS), name


@given(st.text(alphabet=st.characters(categories=["Co", "Cc", "L", "Zs"])))
def test_a_quoted_text_contains_no_marks(text):
    assert not set(quote(text)) & set(MARKS)


MENTION = option("height", "6m")


@for_each(
    [
        ("convert", "1", MENTION, "fc"),
        ("convert", MENTION),
        ("convert", "1", "lx", "nit", "--reflectance", MENTION),
        ("convert", "1", "lx", "W/m2", "--spectrum", MENTION),
        ("convert", "1", "lx", "nit", "--reflectance", "1", "--check", MENTION),
        ("convert", "1", "lx", "nit", "--reflectance", "1", "--tolerance", MENTION, "--check", "1"),
        ("convert", "-", "lx", "fc", "--column", MENTION),
        ("convert", "-", "lx", "fc", "-d", MENTION),
        ("point-source", "--flux", "1lm", "-g", MENTION),
        ("point-source", "--distribution", MENTION),
        ("point-source", MENTION),
        ("lambertian", MENTION, "--luminance", "1cd/m2"),
        ("solid-angle", MENTION),
        ("solid-angle", "cone", MENTION),
        ("solid-angle", "polygon", MENTION),
        ("direction", MENTION),
        ("integrate", MENTION, "--sphere"),
        ("photon", MENTION),
        ("spectrum", MENTION),
        ("units", MENTION),
        ("quantities", MENTION),
        ("typical", MENTION),
        (MENTION,),
        ("ev", f"--{MENTION}"),
    ]
)
def test_a_mention_on_the_command_line_is_not_spelled(words):
    done = run(*words, input="1\n")
    assert done.returncode == 2
    assert "--height" not in done.stdout + done.stderr
    assert not set(done.stdout + done.stderr) & set(MARKS)


def test_the_name_of_a_file_is_not_a_mention(tmp_path):
    path = tmp_path / f"{MENTION}.csv"
    path.write_text("nm,W\n400,1\n500,2\n600,1\n")
    for words in (
        "spectrum",
        "convert 1 lx W/m2 --spectrum",
        "mesopic --luminance 1cd/m2 --spectrum",
    ):
        for form in ("plain", "json", "csv", "table"):
            done = run(*words.split(), str(path), "--steps", "--format", form)
            assert done.returncode == 0, done.stderr
            assert "--height" not in done.stdout + done.stderr
            assert START not in done.stdout + done.stderr


# C0 and C1 controls, separators, formatting and bidirectional characters, surrogates, private use.
UNSEEN = (
    "\0\t\n\r\x1b\x7f\x85\x9b\xa0\xad\u061c\u200b\u200e\u200f\u2028\u2029\u202a\u202e\u2066\u2069"
)


@given(st.text(st.sampled_from(UNSEEN + "\ud800\udcff\ue000\ufeffa\u00e5\u03bb"), max_size=200))
def test_a_quoted_text_is_one_printable_line_of_bounded_length(text):
    shown = errors.quote(text)
    assert shown.isprintable()
    assert len(shown) <= 10 * errors.SHOWN
    assert not set(shown) & set(UNSEEN)
    if text.isprintable() and len(text) <= errors.SHOWN:
        assert shown == text


def test_only_a_few_names_are_listed():
    assert errors.listed(["a", "b\n"]) == "a, b\\n"
    names = [f"column {k}" for k in range(100_000)]
    assert errors.listed(names).endswith("column 9 and 99990 more")
