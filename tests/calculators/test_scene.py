"""`radcalc scene`: sources in rows, and their light at points and over grids."""

import csv
import io
import math
import sys

import numpy
import pytest
from conftest import python, run
from helpers import answers

import radcalc
from radcalc import Quantity
from radcalc.errors import RadcalcError

LAMPS = """name,x (m),y (m),z (m),distribution,intensity,exponent
west,-2,0,3,,100cd,
east,2,0,3,lobe,200cd,1
"""


def scene(tmp_path, text, *words, encoding="utf-8"):
    path = tmp_path / "rig.csv"
    path.write_bytes(text.encode(encoding))
    return run("scene", str(path), *words)


def lux(tmp_path, text, *words, asked="irradiance:lx"):
    done = scene(tmp_path, text, *words, "-q", "-g", asked)
    assert done.returncode == 0, done.stderr
    return [float(line) for line in done.stdout.split()]


def test_the_sum_equals_point_source_for_each_row(tmp_path):
    place = ("--height", "3m", "--offset", "2m", "-q", "-g", "irradiance:lx")
    west = float(run("point-source", "--intensity", "100cd", *place).stdout)
    east = float(run("point-source", "--intensity", "200cd", "--exponent", "1", *place).stdout)
    assert lux(tmp_path, LAMPS, "--at", "0,0,0") == pytest.approx([west + east], rel=1e-11)
    assert lux(tmp_path, LAMPS, "--at", "0,0,0", asked="share-east:lx") == pytest.approx([east])
    share = lux(tmp_path, LAMPS, "--at", "0,0,0", asked="share-west:%")
    assert share == pytest.approx([100 * west / (west + east)])


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("x,y,z,flux\n0,0,2,800lm\n", 800 / (4 * math.pi) / 4),
        ("x,y,z,flux (klm)\n0,0,2,0.8\n", 800 / (4 * math.pi) / 4),
        ("x,y,z_cm,luminous_flux [lm]\n0,0,200,800\n", 800 / (4 * math.pi) / 4),
        ("x / m,y / m,z / cm,flux / lm\n0,0,200,800\n", 800 / (4 * math.pi) / 4),
        ("x;y;z in cm;flux, lm\n0;0;200;800\n", 800 / (4 * math.pi) / 4),
        ("x,y,z (cm),flux\n0,0,400/2,800lm\n", 800 / (4 * math.pi) / 4),
        ("x,y,z (cm),flux\n0,0,2m,800 lm\n", 800 / (4 * math.pi) / 4),
        ("X;Y;Z;Flux\r\n0;0;2,5;800lm\r\n", 800 / (4 * math.pi) / 6.25),
        ("\ufeffx\ty\tz\tflux\n0\t0\t2\t800lm\n", 800 / (4 * math.pi) / 4),
        ("# a comment\n\nx,y,z,flux\n,,,\n0,0,2,800lm\n", 800 / (4 * math.pi) / 4),
        # a cone of 60 deg has pi sr; a lobe of exponent 3 has pi/2
        ("x,y,z,half angle,flux\n0,0,2,60deg,800lm\n", 800 / math.pi / 4),
        ("x,y,z,apex_angle (deg),flux\n0,0,2,120,800lm\n", 800 / math.pi / 4),
        ("x,y,z,distribution,exponent,flux\n0,0,2,Lobe,3,800lm\n", 1600 / math.pi / 4),
        # half of the peak at 60 deg is a Lambertian lobe: pi sr
        ("x,y,z,beam_angle,flux\n0,0,2,120deg,800lm\n", 800 / math.pi / 4),
        # aimed at the origin from the side at 45 deg, the receiver faces up
        (
            "x,y,z,aim_x,aim_y,aim_z,exponent,intensity\n2,0,2,0,0,0,5,100cd\n",
            100 / 8 / math.sqrt(2),
        ),
        (
            "x,y,z,direction_x,direction_y,direction_z,exponent,intensity\n2,0,2,-1,0,-1,5,100cd\n",
            100 / 8 / math.sqrt(2),
        ),
        # tabs, and a blank cell at the end
        ("x\ty\tz\tintensity\texponent\n0\t0\t2\t100cd\t\n", 25),
        ("x\ty\tz\tintensity\texponent\r\n0\t0\t2\t100cd\t\r\n \r\n\x1a", 25),
        # an expression, which is scaled, quoted where it has a comma
        ('x,y,z,distribution,intensity\n0,0,2,"max(z, 0)",100cd\n', 25),
        ("x,y,z,distribution\n0,0,2,50*(1 + z) cd\n", 25),
        ("x,y,z,distribution,flux\n0,0,2,(1 + z) cd,800lm\n", 800 / (4 * math.pi) / 2),
        # its x axis is turned towards +y, where the origin is, 45 deg from its own axis
        (
            "x,y,z,rotate,distribution\n0,-2,2,90deg,100 + 100*x cd\n",
            (100 + 100 / math.sqrt(2)) / 8 / math.sqrt(2),
        ),
        # far patches: L A / d^2
        ("x,y,z,distribution,area,luminance\n0,0,2,lambertian,1cm2,1e6cd/m2\n", 25),
        ("x,y,z,area,exitance\n0,0,2,1cm2,1e6lm/m2\n", 25 / math.pi),
        ("x,y,z,distribution,area,flux\n0,0,2,lambertian,1cm2,800lm\n", 800 / math.pi / 4),
        ("x,y,z,distribution,area,intensity\n0,0,2,lambertian,1cm2,100cd\n", 25),
    ],
)  # fmt: skip
def test_rows_are_read_in_all_forms(tmp_path, text, expected):
    assert lux(tmp_path, text, "--at", "0,0,0") == pytest.approx([expected], rel=1e-6)


def test_a_panel_equals_lambertian_rectangle_at_any_distance(tmp_path):
    text = "x,y,z,distribution,width,length,luminance\n1,2,3,lambertian,60cm,1.2m,3000cd/m2\n"
    for height, offset in (("20cm", "10cm"), ("3m", "4m")):
        words = ("--luminance", "3000cd/m2", "--width", "60cm", "--length", "1.2m")
        place = ("--height", height, "--offset", offset, "-q", "-g", "irradiance:lx")
        expected = float(run("lambertian", "rectangle", *words, *place).stdout)
        x, z = (
            1 + float(offset.rstrip("cm")) / (100 if "c" in offset else 1),
            3 - float(height.rstrip("cm")) / (100 if "c" in height else 1),
        )
        assert lux(tmp_path, text, "--at", f"{x},2,{z}") == pytest.approx([expected], rel=1e-9)


BAD = {
    "x,y,z,flux\n0,0,2,800\n": ("line 2, column 'flux': the unit of flux 800 is missing", "800lm"),
    "x,y,z,flux (lm)\n0,0,2,eight\n": ("line 2, column 'flux (lm)': ", ""),
    "x,y,z,flux\n0,0,2,800m\n": ("line 2, column 'flux': flux takes a flux, not length", "lm"),
    "x,y,z,flux (m)\n0,0,2,8\n": ("line 1, column 'flux (m)': takes a flux, not length", "flux ("),
    "x,y,z,flux (foo)\n0,0,2,8\n": ("line 1, column 'flux (foo)': unknown unit 'foo'", ""),
    # the numbers are not in that unit
    "x,y,z,flux [lm] x1000\n0,0,2,8\n": ("scales its numbers", "numbers in lm without a factor"),
    "x,y,z,flux (lm) / 1000\n0,0,2,8\n": ("scales its numbers", "numbers in lm without a factor"),
    "x,y,z (cm) (in),flux\n0,0,2,8lm\n": ("has two units, in and cm", "only one of them"),
    "x,y,z,flux (dBm)\n0,0,2,8\n": ("column 'flux (dBm)': dBm is a scale", "flux (lm)"),
    "x,y,z,flux (lm) of all\n0,0,2,8\n": ("unknown column 'flux (lm) of all'", "flux"),
    "x,y,z,exponent (1),flux\n0,0,2,1,8lm\n": ("takes a number, not number (1)", "exponent"),
    "x,y,z,fluks\n0,0,2,8lm\n": ("line 1: unknown column 'fluks'", "flux"),
    "x,y,z,flux,flux\n0,0,2,8lm,9lm\n": ("column 'flux' appears twice", "once"),
    "x,y,z,flux,\n0,0,2,8lm,9\n": ("line 1: column 5 has no title", ""),
    "x,y,z,flux\n0,0,2,8lm,9\n": ("line 2: 5 columns instead of 4", "a value in every"),
    "x,y,z,flux\n0,0,,8lm\n": ("line 2: z is blank", "x, y, z"),
    "x,y,flux\n0,0,8lm\n": ("line 2: z is missing", "x, y, z"),
    "x,y,z,aim_x,flux\n0,0,2,1,8lm\n": ("line 2: aim_y is missing", "aim_x, aim_y, aim_z"),
    "x,y,z,aim_x,aim_y,aim_z,flux\n0,0,2,0,0,2,8lm\n": ("aimed at its own position", "another"),
    "x,y,z,direction_x,direction_y,direction_z,exponent,flux\n0,0,2,0,0,0,1,8lm\n": (
        "line 2, column 'direction_x': 0,0,0 has no direction", "a vector other than 0"
    ),
    "x,y,z,distribution,flux\n0,0,2,lob,8lm\n": ("unknown distribution 'lob'", "lobe"),
    "x,y,z,distribution,flux\n0,0,2,lamp.ies,8lm\n": ("no such file", "path"),
    "x,y,z,distribution,flux\n0,0,2,lobe,8lm\n": ("line 2: the shape of the lobe", "exponent or"),
    "x,y,z,distribution,half_angle,flux\n0,0,2,lobe,9deg,8lm\n": ("not apply to lobe", "blank"),
    "x,y,z,half_angle,exponent,flux\n0,0,2,9deg,2,8lm\n": ("columns for cone and for lobe", "one"),
    "x,y,z,distribution\n0,0,2,isotropic\n": ("the flux or intensity of the source", "800lm"),
    "x,y,z,flux,intensity\n0,0,2,8lm,9cd\n": ("flux cannot be used with intensity", "only one"),
    "x,y,z,flux,luminous_flux\n0,0,2,8lm,9lm\n": ("cannot be used with", "only one of them"),
    "x,y,z,flux\n0,0,2,-8lm\n": ("flux -8lm is out of range", "more than 0"),
    "x,y,z,flux\n0,0,2,1,5lm\n": ("5 columns instead of 4", ""),
    "x;y;z;flux\n0;0;2;1,500lm\n": ("has a comma in its number", "1500lm"),
    "x;y;z;flux\n0;0;2;0,5lm\n1;0;2;1.234lm\n": (
        "line 3, column 'flux': a decimal point, but line 2 has a decimal comma", "in all"
    ),
    "x;y;z;flux\n0;0;2.5;8lm\n0;0;1;1,234lm\n": ("line 3, column 'flux': a decimal comma", "all"),
    "x,y,z,flux\n0,0,2,8lm\n0,0,1,8W\n": ("line 3, column 'flux': it is radiant", "--spectrum"),
    "x,y,z,flux,name\n0,0,2,8lm,a\n0,0,1,8lm,a\n": ("line 3, column 'name': 'a' is", "line 2"),
    "x,y,z,flux,name\n0,0,2,8lm,2\n0,0,1,8lm,\n": ("line 3, column 'name': '2' is", "line 2"),
    "x,y,z,area,luminance\n0,0,2,1m2,9cd/m2\n": ("nearer than five times its size", "width"),
    "x,y,z,width,luminance\n0,0,2,1m,9cd/m2\n": ("line 2: the size of the patch", "length"),
    "x,y,z,area,luminance\n0,0,2,,9cd/m2\n": ("line 2: the size of the patch", "length"),
    "x,y,z,area\n0,0,2,1cm2\n": ("line 2: a light quantity of the patch is missing", "luminance"),
    "x,y,z,distribution,flux\n0,0,2,0*z,8lm\n": ("the distribution has no flux", ""),
    "x,y,z,distribution,intensity\n0,0,2,1-z,8cd\n": ("no intensity on its axis", ""),
    "x,y,z,flux\n0,0,0,8lm\n": (
        "the point 0,0,0 is at the position of source '1' (",
        "another point",
    ),
    "x,y,z,flux\n": ("the file has a header but no source", "rows"),
    "flux\n8lm\n": ("line 2: x is missing", "x, y, z"),
    "0,0,2,8lm\n0,0,1,8lm\n": ("unknown column '0'", "x, y, z"),
    "0,0,2,9lm\nx,y,z,flux\n0,0,2,8lm\n": ("line 1: unknown column '0'", "x, y, z"),
    "x,y,z,flux\n0,0,nan,8lm\n": ("column 'z'", "finite"),
    "x,y,z,name (m),flux\n0,0,2,a,8lm\n": ("has a unit", "'name' alone"),
}  # fmt: skip


@pytest.mark.parametrize("text", BAD, ids=[text.replace("\n", "|")[:60] for text in BAD])
def test_the_error_of_a_bad_row_has_its_place(tmp_path, text):
    done = scene(tmp_path, text, "--at", "0,0,0")
    message, _, hint = done.stderr.partition("\ntry: ")
    assert (done.returncode, done.stdout) == (2, "")
    assert BAD[text][0] in message
    assert BAD[text][1] in message + hint
    assert hint
    assert "--flux" not in done.stderr  # a column is not an option


@pytest.mark.parametrize(
    ("words", "message", "hint"),
    [
        ((), "the points are missing", "--at"),
        (("--at", "0,0,0", "--grid", "0:1:2,0:1:2,0"), "--at cannot be used with --grid",
         "{} --at 0,0,0\nor:  radcalc scene {} --grid 0:1:2,0:1:2,0\n"),
        (("--at", "0,0"), "has 2 coordinates, not three", "X,Y,Z"),
        (("--at", "0,0,x"), "--at '0,0,x': 'x' is not a number", "1.5e3"),
        (("--at", "0,0,1s"), "a coordinate is a length", "without s"),
        (("--at", "0:2:1,0,0"), "--at 0:2:1,0,0 is a range", "--grid X0:X1:N"),
        (("--grid", "0:1:2,0"), "is not a grid", "X0:X1:N"),
        (("--grid", "0:1,0,0"), "is not a grid", "X0:X1:N"),
        (("--grid", "0:1:1,0,0"), "'1' is not a number of points", "X0:X1:N"),
        (("--grid", "0:1:2.5,0,0"), "not a number of points", "X0:X1:N"),
        (("--grid", "1:1:5,0,0"), "has no width", "X0:X1:N"),
        (("--grid", "0:1:9999,0:1:9999,0:1:9"), "has 899820009 points", "at most"),
        (("--at", "0,0,0", "--normal", "0,0,0"), "--normal '0,0,0' has no direction", "1,0,0.5"),
        (("--at", "0,0,0", "-g", "lux"), "unknown result 'lux'", ""),
        (("--at", "0,0,0", "--at", "0,1,0", "--steps"), "--steps", "once"),
        (("--grid", "0:1:2,0,0", "-g", "x", "-g", "uniformity"), "be used with x of", "one call"),
        (("--at", "0,0,0", "--at", "1,0,0", "-n"), "-n prints one number", "-g"),
        (("--at", "0,0,0", "--wavelength", "1nm,2nm"), "a list", "only one of them"),
        (("--at", "0,0,0", "--flux", "8lm"), "scene has no --flux option", ""),
        (("more", "--at", "0,0,0"), "unexpected argument", "FILE.csv"),
    ],
)  # fmt: skip
def test_senseless_calls_are_refused(tmp_path, words, message, hint):
    done = scene(tmp_path, LAMPS, *words)
    assert (done.returncode, done.stdout) == (2, "")
    assert message in done.stderr
    assert hint.replace("{}", str(tmp_path / "rig.csv")) in done.stderr


def test_other_files_are_refused(tmp_path):
    missing = run("scene", str(tmp_path / "none.csv"), "--at", "0,0,0")
    folder = run("scene", str(tmp_path), "--at", "0,0,0")
    nothing = run("scene", "--at", "0,0,0")
    assert [done.returncode for done in (missing, folder, nothing)] == [2, 2, 2]
    assert "cannot read" in missing.stderr
    assert "cannot read" in folder.stderr
    assert "the file of the scene is missing" in nothing.stderr


@pytest.mark.parametrize(
    "points", [("--grid", "0:2:3,0:2:3,0"), ("--at", "0,0,0", "--at", "1,2,0")]
)
@pytest.mark.parametrize(
    ("names", "heads"),
    [
        (("x", "y", "illuminance"), ["x:m", "y:m", "illuminance:lx"]),
        (("illuminance", "z:cm"), ["illuminance:lx", "z:cm"]),
        (("illuminance",), ["x:m", "y:m", "z:m", "illuminance:lx"]),
    ],
)
def test_csv_has_the_requested_columns_or_all_of_them(tmp_path, points, names, heads):
    words = [word for name in names for word in ("-g", name)]
    done = scene(tmp_path, LAMPS, *points, *words, "--format", "csv", "-q")
    assert done.stdout.splitlines()[0].split(",") == heads


def test_a_grid_of_four_lamps_is_symmetric_and_its_statistics_match_its_rows(tmp_path):
    text = "x,y,z,exponent,flux\n" + "".join(
        f"{x},{y},2.5,2,500lm\n" for x in (1, 3) for y in (1, 2)
    )
    grid = ("--grid", "0:4:9,0:3:7,0.5")
    done = scene(tmp_path, text, *grid, "--format", "csv", "-q")
    rows = list(csv.DictReader(io.StringIO(done.stdout)))
    assert list(rows[0]) == ["x:m", "y:m", "z:m", "illuminance:lx"]
    values = {(float(r["x:m"]), float(r["y:m"])): float(r["illuminance:lx"]) for r in rows}
    assert len(values) == 63
    for (x, y), value in values.items():
        assert values[4 - x, y] == pytest.approx(value)
        assert values[x, 3 - y] == pytest.approx(value)
    mean = math.fsum(values.values()) / 63
    lights = ("mean-illuminance:lx", "minimum-irradiance", "maximum-irradiance:klx")
    words = [w for name in (*lights, "uniformity", "minimum-to-maximum") for w in ("-g", name)]
    found = [float(x) for x in scene(tmp_path, text, *grid, "-q", *words).stdout.split("\t")]
    low, high = min(values.values()), max(values.values())
    assert found == pytest.approx([mean, low, high / 1000, low / mean, low / high])
    assert lux(tmp_path, text, *grid) == pytest.approx(list(values.values()))


def test_several_points_have_a_row_each_and_statistics(tmp_path):
    done = scene(tmp_path, LAMPS, "--at", "0,0,0", "--at", "2m,0m,100cm", "-q", "--json")
    first, second, told = answers(done.stdout)
    value = {name: row["value"] for name, row in told["results"].items()}
    lights = [one["results"]["illuminance"]["value"] for one in (first, second)]
    # 100*3/13^1.5 + 200*9/13^2; 100*2/20^1.5 + 200/4
    expected = [300 / 13**1.5 + 1800 / 169, 200 / 20**1.5 + 50]
    assert lights == pytest.approx(expected)
    assert value["mean-illuminance"] == pytest.approx(sum(expected) / 2)
    assert value["uniformity"] == pytest.approx(2 * min(expected) / sum(expected))
    assert [second["inputs"][axis]["value"] for axis in "xyz"] == [2, 0, 1]
    assert [second["results"][axis]["value"] for axis in "xyz"] == [2, 0, 1]


def test_kinds_are_linked_and_shown(tmp_path):
    text = "x,y,z,flux\n0,0,2,800lm\n0,0,-2,5W\n"
    words = ("--at", "0,0,0", "--at", "0,0,1", "--wavelength", "555nm", "-q")
    done = scene(tmp_path, text, *words, "-g", "irradiance:lx", "-g", "irradiance:W/m2")
    rows = [[float(x) for x in line.split()] for line in done.stdout.splitlines()]
    # watts below the horizon do not count; 683.002 lm/W at 555 nm, where V is 1
    assert rows[0] == pytest.approx([800 / 16 / math.pi, 800 / 16 / math.pi / 683.002], rel=1e-6)
    down = (*words, "--normal", "0,0,-1", "-g", "irradiance:W/m2")
    assert [float(x) for x in scene(tmp_path, text, *down).stdout.split()] == pytest.approx(
        [5 / 16 / math.pi, 5 / 36 / math.pi], rel=1e-6
    )


def test_assumptions_and_unusual_inputs_are_stated(tmp_path):
    done = scene(tmp_path, "x,y,z,flux\n0,0,2,8lm\n0,0,-2,8lm\n", "--at", "0,0,0")
    assert "assumed: coordinates without a unit are in metres" in done.stderr
    assert "assumed: a source without a distribution is isotropic" in done.stderr
    assert "assumed: the receivers face up" in done.stderr
    assert "note: light from behind the receiver does not count" in done.stderr
    dark = scene(tmp_path, "x,y,z,half_angle,flux\n0,0,2,9deg,8lm\n", "--grid", "5:6:2,0,0")
    assert "no light reaches any of the points" in dark.stderr
    assert "uniformity" not in dark.stdout


def test_a_skipped_row_is_noted(tmp_path):
    text = "# my rig\nname;x;y;z;flux\n#1;0;0;2;8lm\n;;;;\n;0;0;3;8lm\n"
    done = scene(tmp_path, text, "--at", "0,0,0", "-g", "irradiance:lx")
    assert float(done.stdout) == pytest.approx(8 / (4 * math.pi) / 9)
    assert "rig.csv: comments with as many cells as the rows, skipped: lines 3\n" in done.stderr


def test_the_line_of_titles_below_lines_of_text_is_noted(tmp_path):
    text = "my room\nmeasured in May\nx,y,z,flux\nm,m,m,lm\n0,0,2,8\n0,0,3,8\n"
    done = scene(tmp_path, text, "--at", "0,0,0", "-g", "irradiance:lx")
    assert float(done.stdout) == pytest.approx(8 / (4 * math.pi) * (1 / 4 + 1 / 9))
    assert "the titles are in line 3; the lines of text above are skipped\n" in done.stderr


def test_a_row_with_blank_first_cells_is_not_a_comment(tmp_path):
    text = "name;aim_x;aim_y;aim_z;x;y;z;flux\n;;;;0;0;2;8lm\nb;;;;0;0;3;8lm\n"
    expected = 8 / (4 * math.pi) * (1 / 4 + 1 / 9)
    assert lux(tmp_path, text, "--at", "0,0,0") == pytest.approx([expected])


def test_a_name_makes_one_column(tmp_path):
    text = 'name,x,y,z,flux\n"desk, left: 1",0,0,2,8lm\nc,0,0,3,8lm\n'
    done = scene(tmp_path, text, "--at", "0,0,0", "--format", "csv", "-q")
    (row,) = csv.DictReader(io.StringIO(done.stdout))
    assert list(row)[4:] == [
        "share-desk-left-1:lx",
        "share-desk-left-1:%",
        "share-c:lx",
        "share-c:%",
    ]


def test_a_long_bad_cell_has_a_message(tmp_path):
    done = scene(tmp_path, f'x,y,z,flux\n0,0,2,"{"a" * 200_000}"\n', "--at", "0,0,0")
    assert done.returncode == 2
    assert "line 2, column 'flux'" in done.stderr


def test_the_derivation_has_the_term_of_each_source(tmp_path):
    done = scene(tmp_path, LAMPS, "--at", "-2,0,1", "--steps", "-q", "-g", "irradiance:lx")
    assert "100 cd * 1 / (2 m)^2 = 25 lx" in done.stderr
    # 20 = 4^2 + 2^2; 200 cos / 20 * cos = 200 * (2/sqrt(20))^2 / 20 = 2
    assert "25 + 2 = 27 lx" in done.stderr
    assert float(done.stdout) == pytest.approx(27)


def test_an_answer_is_checked(tmp_path):
    right = scene(tmp_path, LAMPS, "--at", "-2,0,1", "--check", "irradiance=27lx")
    wrong = scene(tmp_path, LAMPS, "--at", "-2,0,1", "--check", "irradiance=30lx")
    assert (right.returncode, wrong.returncode) == (0, 1)


def test_files_of_distributions_are_searched_in_the_folder_of_the_scene(tmp_path):
    (tmp_path / "lamps").mkdir()
    (tmp_path / "lamps" / "flood.csv").write_text("angle (deg),intensity (cd)\n0,100\n90,0\n")
    text = "x,y,z,distribution,intensity\n0,0,2,lamps/flood.csv,\n9,9,-1,lamps/flood.csv,10cd\n"
    assert lux(tmp_path, text, "--at", "0,0,0") == pytest.approx([25])
    # half of the intensity at 45 deg from the axis
    assert lux(tmp_path, text, "--at", "2,0,0") == pytest.approx([50 / 8 / math.sqrt(2)])


def test_python_gets_arrays_and_statistics(tmp_path):
    lamps = [
        {"name": "west", "x": -2, "y": 0, "z": 3, "intensity": "100cd"},
        {"name": "east", "x": "2m", "y": 0.0, "z": Quantity(300, "cm"), "distribution": "lobe",
         "exponent": 1, "intensity": Quantity(0.2, "kcd"), "aim_x": None},
    ]  # fmt: skip
    points = numpy.array([[0.0, 0.0, 0.0], [2.0, 0.0, 1.0]])
    found = radcalc.scene(lamps, points, shares=True)
    expected = [300 / 13**1.5 + 1800 / 169, 200 / 20**1.5 + 50]
    assert found["irradiance"].to("lx").magnitude == pytest.approx(expected)
    total = found["share_west"] + found["share_east"]
    assert total.magnitude == pytest.approx(found["irradiance"].magnitude)
    assert found["uniformity"].magnitude == pytest.approx(2 * min(expected) / sum(expected))
    (tmp_path / "rig.csv").write_text(LAMPS)
    of_file = radcalc.scene(tmp_path / "rig.csv", Quantity(100 * points, "cm"))
    assert of_file["irradiance"].magnitude == pytest.approx(expected)
    with pytest.raises(RadcalcError, match="source 2: unknown column 'fluks'"):
        radcalc.scene([lamps[0], {"fluks": 1}], points)
    for bad in (True, [1, 2], numpy.array([1.0, 2.0]), Quantity([1, 2], "m"), object()):
        with pytest.raises(RadcalcError, match="source 1, column 'x'"):
            radcalc.scene([lamps[0] | {"x": bad}], points)
    with pytest.raises(TypeError, match="flux"):
        radcalc.scene(lamps, points, flux="8lm")


MEMORY = """
import resource, subprocess, sys
subprocess.run(sys.argv[1:], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="no resource")
def test_a_million_points_take_no_more_memory_than_a_tenth_of_them(tmp_path):
    path = tmp_path / "rig.csv"
    path.write_text(LAMPS)
    command = [sys.executable, "-m", "radcalc", "scene", str(path), "-g", "irradiance:lx"]
    sizes = [
        int(python(MEMORY, *command, "--grid", f"0:1:{n},0:1:1000,0").stdout) for n in (100, 1000)
    ]
    assert sizes[1] < sizes[0] + 20_000  # KiB; the answers alone would be 8 MB, as text 13


@pytest.mark.parametrize(
    "source",
    [
        {"x (cm)": 0, "y": 0, "z (cm)": 200, "Intensity [cd]": 100},
        {"x_m": "0", "y_m": "0", "z_m": "2", "intensity": "100 cd"},
    ],
)
def test_the_keys_of_a_dict_are_read_as_titles(source):
    """100 cd at 2 m: 100 / 2^2 = 25 lx."""
    found = radcalc.scene([source], "0,0,0")
    assert found.illuminance.m_as("lx") == pytest.approx([25])
    with pytest.raises(RadcalcError, match="appears twice"):
        radcalc.scene([source | {"Y": 1, "y": 1, "y (m)": 1}], "0,0,0")


def test_the_assumptions_about_the_points_of_a_scene_in_python_are_stated():
    lamp = [{"x": "0 m", "y": "0 m", "z": "2 m", "intensity": "100 cd"}]
    told = {"coordinates without a unit are in metres", "the receivers face up"}
    assert told <= {*radcalc.scene(lamp, [0, 0, 0]).assumptions}
    assert not told & {*radcalc.scene(lamp, "0m,0m,0m", (0, 0, 1)).assumptions}


def test_a_result_of_each_point_is_checked_at_one(tmp_path):
    """100 cd at 2 m: 25 lx."""
    file = tmp_path / "lamp.csv"
    file.write_text("x,y,z,intensity\n0,0,2,100cd\n")
    places = ["scene", str(file), "--at", "0,0,0", "--at", "1,0,0"]
    refused = run(*places, "--check", "irradiance=25lx")
    assert refused.returncode == 2
    assert "--check irradiance takes one point, but there are 2" in refused.stderr
    assert run(*places, "--check", "maximum-irradiance=25lx").returncode == 0
