"""Results cannot be changed through the arrays that they show, or through those of a user."""

import numpy as np
import pytest

import radcalc
from radcalc.distributions.maps import RadianceMap
from radcalc.spectra.sources import spectrum

Q = radcalc.Quantity
CALLS = {
    "point_source": lambda x: radcalc.point_source(intensity="100 cd", distance=Q(x, "m")),
    "bare numbers": lambda x: radcalc.ev(f_number=x, time="1/60 s", iso="100"),
    "photon": lambda x: radcalc.photon(Q(500 + x, "nm")),
    "lambertian": lambda x: radcalc.lambertian(
        "disc", luminance="1e4 cd/m2", radius="25 cm", height=Q(x, "m")
    ),
    "solid_angle": lambda x: radcalc.solid_angle("cone", half_angle=Q(10 * x, "deg")),
    "room": lambda x: radcalc.room(area=Q(10 * x, "m2"), illuminance="500 lx", flux="3600 lm",
                                   utilance="0.6"),
    "sky": lambda x: radcalc.sky("overcast", zenith_luminance=Q(x, "kcd/m2")),
    "a list": lambda x: radcalc.point_source(flux="800 lm", distance=[f"{d} m" for d in x]),
}  # fmt: skip


def arrays_of(result):
    """Yield every array that a result shows."""
    yield from (quantity.magnitude for quantity in result.values())
    yield from (row.value for row in result.rows)
    yield from (shown.value for shown in result.inputs)


@pytest.mark.parametrize("name", CALLS)
def test_an_array_of_a_result_cannot_be_changed(name):
    typed = np.array([1.0, 2.0, 3.0])
    found = CALLS[name](typed)
    again = repr(CALLS[name](typed.copy()))
    seen = [array for array in arrays_of(found) if isinstance(array, np.ndarray) and array.ndim]
    assert seen
    for array in seen:
        with pytest.raises(ValueError, match="read-only"):
            array[...] = 999
        assert not np.shares_memory(array, typed)
    assert repr(found) == again


@pytest.mark.parametrize("name", CALLS)
def test_the_array_of_a_user_stays_free_and_apart(name):
    typed = np.array([1.0, 2.0, 3.0])
    found, again = CALLS[name](typed), repr(CALLS[name](typed.copy()))
    typed[:] = 999  # before the result shows itself for the first time
    assert repr(found) == again


def test_several_solutions_are_read_only():
    found = radcalc.point_source(intensity="100 cd", offset="1 m", illuminance="10 lx")
    assert found.height.magnitude.shape == (2,)
    assert not any(array.flags.writeable for array in arrays_of(found) if hasattr(array, "flags"))


def test_converted_arrays_maps_and_samples_are_read_only():
    typed = np.linspace(1.0, 2.0, 5)
    image = np.ones((32, 64))
    around = RadianceMap(image, "latlong")
    made = [
        radcalc.convert(Q(typed, "lx"), "fc").magnitude,
        radcalc.convert(Q(typed, "lx"), "lx").magnitude,
        radcalc.convert(Q(typed, "mW"), "dBm"),
        radcalc.irradiance_map("sky:overcast", size=(8, 4), zenith_luminance="9 kcd/m2").magnitude,
        around.pixels,
    ]
    for array in made:
        assert not array.flags.writeable
    assert typed.flags.writeable
    assert image.flags.writeable


def test_the_samples_of_a_file_are_read_only(tmp_path):
    rows = "".join(f"{400 + k / 1000:.3f},{1 + k % 7}\n" for k in range(20_000))
    (tmp_path / "fine.csv").write_text(f"nm,W/m2/nm\n{rows}")
    found = spectrum(str(tmp_path / "fine.csv"))
    for array in (found.grid, found.values):
        assert not getattr(array, "flags", None) or not array.flags.writeable
