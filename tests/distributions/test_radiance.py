"""Illuminances under photometric files, compared with Radiance.

Radiance's ies2rad reads the files by itself; rtrace then interpolates between their angles.  It
gets the lamp type "default", so that no lamp table takes a share away.
"""

import math
import os
import platform

import numpy
import pytest

import radcalc
from radcalc.distributions.distribution import Pose
from radcalc.distributions.sources import read_file

try:
    import pyradiance
except ImportError:
    if platform.machine() != "aarch64":  # there is no wheel for aarch64
        raise
    pytest.skip("pyradiance is not installed", allow_module_level=True)

Q = radcalc.Quantity
EFFICACY = 179  # [lm/W] of Radiance's white
WHITE = 0.265, 0.670, 0.065  # the shares of red, green and blue in it
CLOSE = 1e-3
POLAR = (0, 5, 12.5, 20, 30, 45, 60, 75, 90)
SPHERE = (*POLAR, 100, 120, 150, 180)
QUADRANT = (0, 10, 30, 45, 70, 90)
HALF = (*QUADRANT, 110, 140, 180)
BACK = tuple(90 + angle for angle in HALF)  # 90 to 270
WHOLE = (*HALF, 200, 260, 300, 360)


def table(azimuth, polar, seed=1):
    """Return intensities that differ except at the pole and the end of the circle."""
    values = numpy.random.default_rng(seed).uniform(50, 150, (len(azimuth), len(polar))).round(2)
    values[:, 0] = 100
    if azimuth[-1] == 360:
        values[-1] = values[0]
    return values


def lines(*rows):
    return "".join(" ".join(map(str, row)) + "\n" for row in rows)


def ies(azimuth, polar, values, edition="IESNA:LM-63-2002", system=1, factors=(1, 1, 1)):
    """Return a photometric file with a multiplier, a ballast factor and the factor after it."""
    multiplier, ballast, last = factors
    counts = (1, 1000, multiplier, len(polar), len(azimuth), system, 2, 0, 0, 0)
    label = f"{edition}\n[TEST] none\n[LAMP] metal halide\nTILT=NONE\n"
    return label + lines(counts, (ballast, last, 50), polar, azimuth, *values)


def eulumdat(symmetry, planes, polar, values):
    """A file of cd per 1000 lm, for a lamp of 1000 lm."""
    head = ["", 1, symmetry, len(planes), 0, len(polar), 0, "", "", "", "", "", *[0] * 9]
    lamps = [50, 100, 1, 0, 1, 1, "", 1000, "", "", 50, *[0] * 10]
    return "\n".join(map(str, [*head, *lamps, *planes, *polar, *values.ravel()])) + "\n"


def points(below=True, count=40, seed=2):
    """Return points about a source, and the normals of small surfaces at them."""
    random = numpy.random.default_rng(seed)
    at, faces = random.normal(size=(2, count, 3))
    at[:, 2] = -abs(at[:, 2]) - 0.2 if below else at[:, 2]
    at *= random.uniform(2, 5, (count, 1)) / numpy.linalg.norm(at, axis=1, keepdims=True)
    faces -= at  # towards the source, more or less
    return at, faces / numpy.linalg.norm(faces, axis=1, keepdims=True)


def of_radiance(text, at, faces, monkeypatch, folder, *turns):
    """Illuminances [lx] at the points, under point sources of a photometric file."""
    monkeypatch.chdir(folder)
    monkeypatch.setenv("RAYPATH", os.pathsep.join([os.environ["RAYPATH"], "."]))
    (folder / "lamp.ies").write_text(text)
    pyradiance.ies2rad("lamp.ies", outname="source", lamp_type="default")
    sources = [turn(pyradiance.Xform("source.rad"))() for turn in turns or [lambda source: source]]
    (folder / "scene.rad").write_bytes(b"".join(sources))
    (folder / "scene.oct").write_bytes(pyradiance.oconv("scene.rad"))
    rays = lines(*numpy.concatenate([at, faces], axis=1))
    options = ("-ab", "0", "-dj", "0", "-ds", "0", "-dt", "0")
    found = pyradiance.rtrace(
        rays.encode(), "scene.oct", header=False, irradiance=True, params=options
    )
    return EFFICACY * numpy.array(found.split(), float).reshape(-1, 3) @ WHITE


def aimed(source, rotated, tilt, turned):
    """A source turned about its axis, then tilted from straight down towards an azimuth [deg]."""
    return source.rotatez(rotated).rotatez(-turned).rotatey(-tilt).rotatez(turned)


def of_radcalc(text, at, faces, folder, pose=None, name="lamp.ies"):
    path = folder / name
    path.write_text(text)
    lamp = read_file(str(path)).distribution
    theta, phi, distance = (pose or Pose()).angles(tuple(at.T))
    cosine = -(at * faces).sum(axis=1) / distance
    return lamp.intensity(theta, phi) * cosine.clip(min=0) / distance**2


@pytest.fixture
def agree(tmp_path, monkeypatch):
    """Check that both agree on a file, or on two files of one luminaire."""

    def compare(text, below=True, other="", name="lamp.ies", mirror=(1, 1, 1)):
        at, faces = points(below)
        ours = of_radcalc(other or text, at, faces, tmp_path, name=name)
        theirs = of_radiance(text, at * mirror, faces * mirror, monkeypatch, tmp_path)
        assert (ours > 0).sum() > len(ours) / 2
        assert ours == pytest.approx(theirs, rel=CLOSE)

    return compare


@pytest.mark.parametrize("azimuth", [(0,), QUADRANT, HALF, WHOLE])
@pytest.mark.parametrize("polar", [POLAR, SPHERE])
def test_every_symmetry_of_type_c(azimuth, polar, agree):
    agree(ies(azimuth, polar, table(azimuth, polar)), below=polar is POLAR)


def test_a_file_of_90_to_270_degrees(agree):
    """Radiance has the mirror image, with C90 at C270."""
    agree(ies(BACK, POLAR, table(BACK, POLAR)), mirror=(1, -1, 1))


@pytest.mark.parametrize(
    "edition",
    ["Lamps of 1986", "IESNA91", "IESNA:LM-63-1995", "IESNA:LM-63-2002", "IES:LM-63-2019"],
)
def test_the_factors_of_every_edition(edition, agree):
    """The last factor applies to the editions of 1986 and 1991 only."""
    values = table(QUADRANT, POLAR)
    agree(ies(QUADRANT, POLAR, values, edition, factors=(1.7, 0.9, 0.8)))


@pytest.mark.parametrize("angle", ["vertical", "horizontal"])
def test_type_b(angle, tmp_path, monkeypatch):
    """Compare two planes through the axis; only there are Radiance's angles those of type B."""
    azimuth, polar = (-90, -60, -25, 0, 40, 90), (-90, -50, -20, 0, 15, 60, 90)
    text = ies(azimuth, polar, table(azimuth, polar), system=2)
    at, faces = points()
    at[:, 1 if angle == "vertical" else 0] = 0
    ours = of_radcalc(text, at, faces, tmp_path)
    theirs = of_radiance(text, at, faces, monkeypatch, tmp_path)
    assert (ours > 0).sum() > len(ours) / 2
    assert ours == pytest.approx(theirs, rel=CLOSE)


@pytest.mark.parametrize("symmetry", range(5))
def test_every_symmetry_of_eulumdat(symmetry, agree):
    """Compare with the same table as an LM-63 file in Radiance."""
    planes = tuple(range(0, 360, 30))
    kept = {0: planes, 1: (0,), 2: planes[:7], 3: (-90, -60, -30, 0, 30, 60, 90), 4: planes[:4]}
    values = table(kept[symmetry], SPHERE)
    ldt = eulumdat(symmetry, planes, SPHERE, values)
    if symmetry == 0:
        text = ies((*planes, 360), SPHERE, numpy.concatenate([values, values[:1]]))
    elif symmetry == 3:  # C270 over C0 to C90, as all planes
        half = numpy.concatenate([values[3:], values[5::-1], values[1:4]])
        text = ies((*planes, 360), SPHERE, half)
    else:
        text = ies(kept[symmetry], SPHERE, values)
    agree(text, below=False, other=ldt, name="lamp.ldt")


@pytest.mark.parametrize("tilt", [0, 25, 90, 155, 180])
@pytest.mark.parametrize(("turned", "rotated"), [(0, 40), (65, 0), (200, 310)])
def test_aimed_and_rotated(tilt, turned, rotated, tmp_path, monkeypatch):
    """From straight down by an angle, towards an azimuth, about the level line across both."""
    text = ies(WHOLE, SPHERE, table(WHOLE, SPHERE))
    at, faces = points(below=False)
    a, b = math.radians(tilt), math.radians(turned)
    aim = (math.sin(a) * math.cos(b), math.sin(a) * math.sin(b), -math.cos(a))
    if tilt == 180:
        aim, turned = (0.0, 0.0, 1.0), 90  # about x
    ours = of_radcalc(text, at, faces, tmp_path, Pose(aim, math.radians(rotated)))

    def turn(source):
        return aimed(source, rotated, tilt, turned)

    assert ours == pytest.approx(
        of_radiance(text, at, faces, monkeypatch, tmp_path, turn), rel=CLOSE
    )


@pytest.mark.parametrize("name", ["lamp.ies", "lamp.ldt"])
def test_the_command(name, tmp_path, monkeypatch):
    """Compare a lamp that shines down and is rotated about its axis."""
    planes = tuple(range(0, 360, 30))
    values = table(planes, POLAR)
    text = ies((*planes, 360), POLAR, numpy.concatenate([values, values[:1]]))
    (tmp_path / name).write_text(text if name == "lamp.ies" else eulumdat(0, planes, POLAR, values))
    at, faces = points()
    at[:, 2], faces[:] = -2.5, (0, 0, 1)
    found = radcalc.point_source(
        distribution=str(tmp_path / name),
        height="2.5 m",
        offset=Q(at[:, 0], "m"),
        offset_y=Q(at[:, 1], "m"),
        rotate="35 deg",
    )["irradiance"]
    theirs = of_radiance(text, at, faces, monkeypatch, tmp_path, lambda lamp: lamp.rotatez(35))
    assert found.to("lx").magnitude == pytest.approx(theirs, rel=CLOSE)


def test_a_scene(tmp_path, monkeypatch):
    """Lamps at three places, two of them aimed and turned."""
    text = ies(WHOLE, SPHERE, table(WHOLE, SPHERE))
    path = tmp_path / "lamp.ies"
    path.write_text(text)
    lamps, turns = [], []
    for place, rotated, tilt, turned in [
        ((0.5, 0, 2), 0, 0, 0), ((-1, 0.3, 2.5), 80, 35, 120), ((0.2, -2, 1.8), 200, 60, 300)
    ]:  # fmt: skip
        a, b = math.radians(tilt), math.radians(turned)
        aim = (math.sin(a) * math.cos(b), math.sin(a) * math.sin(b), -math.cos(a))
        names = ("x", "y", "z", "direction_x", "direction_y", "direction_z")
        row = dict(zip(names, (*place, *aim), strict=True))
        lamps.append({**row, "rotate": f"{rotated} deg", "distribution": str(path)})

        def turn(source, turns=(rotated, tilt, turned), place=place):
            return aimed(source, *turns).translate(*place)

        turns.append(turn)
    at, faces = points()
    at[:, 2], faces[:] = 0, (0, 0, 1)
    found = radcalc.scene(lamps, at)["irradiance"]
    theirs = of_radiance(text, at, faces, monkeypatch, tmp_path, *turns)
    assert found.to("lx").magnitude == pytest.approx(theirs, rel=CLOSE)
