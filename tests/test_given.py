"""Reading inputs that are not quantities: directions, points, sizes, lists."""

import math

import pytest

from radcalc.errors import START, RadcalcError, option
from radcalc.inputs import Input
from radcalc.inputs.places import read_direction, read_place
from radcalc.inputs.reading import read, read_as, read_interval, split_values
from radcalc.quantities.symbols import DIRECTION, SYMBOLS, VECTOR
from radcalc.units.table import resolve

TOWARD = SYMBOLS["normal"]._replace(name="toward", form=DIRECTION)

# text, polar angle and azimuth [deg]; by hand: (1, 1, sqrt 2) is half way up, half way round
DIRECTIONS = {
    "60deg": (60, 0),
    "60deg,90deg": (60, 90),
    " 60 deg , 90 deg ": (60, 90),
    "pi/3 rad,0.25turn": (60, 90),
    "60°,-90°": (60, 270),
    "60deg,-1e-300deg": (60, 0),
    "60deg,750deg": (60, 30),
    "180deg": (180, 0),
    "3.14159265359rad": (180, 0),
    "0,0,1": (0, 0),
    "0,0,-2": (180, 0),
    "1,1,1.4142135623730951": (45, 45),
    "0,-1e-3,0": (90, 270),
    "-1/2,0,0": (90, 180),
}


@pytest.mark.parametrize("text", DIRECTIONS)
def test_a_direction_is_angles_or_a_vector(text):
    found = read_direction(text, "the direction")
    assert [math.degrees(angle) for angle in found] == pytest.approx(DIRECTIONS[text], abs=1e-12)
    assert 0 <= found[0] <= math.pi
    assert 0 <= found[1] < 2 * math.pi


# text, part of the message
NO_DIRECTIONS = {
    "": "a number is missing",
    "60": "a bare number, not an angle",
    "1,0": "a bare number, not an angle",
    "1,5deg": "a bare number, not an angle",
    "60deg,2m": "length (m), not an angle",
    "1sr": "solid angle (sr), not an angle",
    "60deg,north": "'north' is not a number",
    "60furlongs": "furlongs",
    "-1deg": "its polar angle must be from 0 to 180 deg",
    "180.001deg": "its polar angle must be from 0 to 180 deg",
    "10deg,1e200rad": "too large an angle",
    "1deg,2deg,3deg": "'1deg' is not a number",
    "1,2,3,4": "4 coordinates, not three",
    "0,0,0": "no direction",
}


@pytest.mark.parametrize("text", NO_DIRECTIONS)
def test_a_malformed_direction_is_refused(text):
    with pytest.raises(RadcalcError) as error:
        read_direction(text, "the direction")
    assert NO_DIRECTIONS[text] in error.value.message
    assert error.value.message.startswith("the direction '")
    assert error.value.hint


@pytest.mark.parametrize("text", ["0,0,0", "0,-0,0.0", "1,2", "1,2,x", "nan,0,1", "1m,0m,2m", "up"])
@pytest.mark.parametrize("name", [name for name, one in SYMBOLS.items() if one.form == VECTOR])
def test_a_malformed_vector_is_refused_with_its_option(name, text):
    with pytest.raises(RadcalcError) as error:
        read(name, text)
    assert error.value.message.startswith(f"{option(name)} '{text}'")
    assert error.value.hint


def test_a_symbol_takes_a_direction():
    assert read_as(TOWARD, "90deg,90deg").value == (math.pi / 2, math.pi / 2)
    assert read_as(TOWARD, (90.0, resolve("deg"))) == Input(TOWARD, "90.0 deg", (math.pi / 2, 0.0))


def test_directions_are_a_range_of_polar_angles(monkeypatch):
    monkeypatch.setitem(SYMBOLS, "toward", TOWARD)
    assert split_values("toward", "0deg:60deg:30deg") == ["0deg", "30deg", "60deg"]
    assert split_values("toward", "0deg:60deg:30deg,90deg") == [
        "0deg,90deg",
        "30deg,90deg",
        "60deg,90deg",
    ]
    assert split_values("toward", "60deg,90deg") == ["60deg,90deg"]


def test_an_interval_without_a_unit_is_quoted_in_its_hint():
    with pytest.raises(RadcalcError) as error:
        read_interval("polar", f"1:1{START}")
    assert START not in error.value.hint[1:]  # except for the mention of the option itself


def test_a_coordinate_of_0_needs_no_unit_next_to_lengths():
    assert read_place("point", "0,0,100cm").value == (0.0, 0.0, 1.0)
    assert read_place("point", "1cm,0,0").unit.text == "cm"


@pytest.mark.parametrize("size", ["1024x512", " 1024 X 512 ", "1024×512", (1024, 512)])
def test_a_size_is_two_whole_numbers(size):
    assert read("size", size).value == (1024, 512)
    assert read("pixel", "0,7").value == (0, 7)


# text, part of the message
NO_SIZES = {
    "1024,512": "is not two whole numbers with 'x' between them",
    "1024x512x3": "is not two whole numbers",
    "1e3x512": "is not two whole numbers",
    "-1x512": "is not two whole numbers",
    "²x512": "is not two whole numbers",
    "x": "is not two whole numbers",
    "0x512": "is out of range",
    "1000001x1": "is out of range",
    "1x" + "9" * 5000: "is out of range",
    (2.0, 1.0): "is not two whole numbers",
    5: "is not two whole numbers",
}


@pytest.mark.parametrize("size", NO_SIZES)
def test_a_malformed_size_is_refused(size):
    with pytest.raises(RadcalcError) as error:
        read("size", size)
    assert NO_SIZES[size] in error.value.message
    assert error.value.hint


@pytest.mark.parametrize(
    ("name", "text", "values"),
    [
        ("distance", "1,2,5m", ["1m", "2m", "5m"]),
        ("distance", "1:5:2 m", ["1 m", "3 m", "5 m"]),
        ("distance", "1.5,2+-0.1m", ["1.5m", "2+-0.1m"]),
        ("time", "1/60,1/125s", ["1/60s", "1/125s"]),
        ("time", "1/60,1/125", ["1/60", "1/125"]),
        ("distance", "1,5m", ["1,5m"]),
        ("reflectance", "20%,80%", ["20%", "80%"]),
        ("reflectance", "0.1,0.3 OD", ["0.1 OD", "0.3 OD"]),
    ],
)
def test_a_list_may_have_its_unit_after_the_last_value(name, text, values):
    assert split_values(name, text) == values


@pytest.mark.parametrize("text", ["0.2,80%", "0.5,0.6%", "0.1:0.3:0.1%", "0.1:0.9:40%"])
def test_a_percentage_at_the_end_of_a_list_of_fractions_is_refused(text):
    with pytest.raises(RadcalcError, match="ambiguous"):
        split_values("reflectance", text)


@pytest.mark.parametrize("name", ["f-number", "nd", "iso", "stops", "ev100", "exponent"])
def test_a_number_that_is_not_a_fraction_takes_no_percentage(name):
    with pytest.raises(RadcalcError, match="takes a number"):
        read(name, "12.5%")


def test_a_long_range_may_have_its_unit_last():
    [(numbers, unit, text)] = split_values("distance", "1:3000:1m", arrays=True)
    assert (len(numbers), numbers[-1], unit.text, text) == (3000, 3000, "m", "1:3000:1m")


# By the definition of the degree Fahrenheit, a difference of 9 degF is one of 5 K.
@pytest.mark.parametrize(
    ("text", "kelvins", "uncertainty"),
    [
        ("2°C", 2.0, 0.0),
        ("2±0.1 °C", 2.0, 0.1),
        ("2 °C ± 0.1 °C", 2.0, 0.1),
        ("2.0(1) degC", 2.0, 0.1),
        ("9.0+-0.9°F", 5.0, 0.5),
    ],
)
def test_a_difference_of_temperature_may_be_in_degrees(text, kelvins, uncertainty):
    given = read("temperature-rise", text, uncertain=True)
    assert given.value == pytest.approx(kelvins)
    assert given.uncertainty == pytest.approx(uncertainty)


@pytest.mark.parametrize("text", ["°C", "2 K ± 0.1 °F", "300K-25°C", "25°C-23°C", "2 °F ± 1 °C"])
def test_degrees_with_anything_else_are_not_a_difference(text):
    with pytest.raises(RadcalcError):
        read("temperature-rise", text, uncertain=True)


def test_differences_may_be_a_range():
    values = split_values("temperature-rise", "2°C:4°C:1°C")
    assert [read("temperature-rise", one).value for one in values] == [2.0, 3.0, 4.0]
    with pytest.raises(RadcalcError, match="not accepted as a unit"):
        read("temperature", split_values("temperature", "2°C:4°C:1°C")[0])


def test_the_values_of_a_long_range_have_the_decimals_of_typed_ones():
    [(numbers, *_)] = split_values("distance", "0.1m:200.1m:0.1m", arrays=True)
    assert [float(number) for number in numbers] == [float(f"{k / 10:.1f}") for k in range(1, 2002)]
    [(numbers, *_)] = split_values("distance", "1e-30m:2e-27m:1e-30m", arrays=True)
    assert numbers[-1] == pytest.approx(2e-27, rel=1e-12)
