"""Derived values in any order of the laws, and contradictions."""

import math
import random
from functools import partial

import pytest
from helpers import for_each, number

from radcalc import lambertian, point_source, room, screen
from radcalc.errors import Contradiction
from radcalc.laws import CIRCLE, CONFIGURATION_FACTOR, HEAT_LAWS, beams, photometry, point, surface
from radcalc.laws.solver import Disagreement, Known, solve
from radcalc.units.numbers import rounding

PI = math.pi

LOBE = [*point.LAWS["lobe"], *point.ANY_LAWS, point.INVERSE_SQUARE]
CONE = [*point.LAWS["cone"], *point.ANY_LAWS, point.INVERSE_SQUARE]
SURFACE = [*surface.LAWS, surface.FLAT, CIRCLE]
BEAM = [beams.RADIANCE_FLUX, beams.PER_AREA, CONFIGURATION_FACTOR, CIRCLE]


def known(**values: float) -> dict[str, Known]:
    return {name.replace("_", "-"): Known(value) for name, value in values.items()}


@pytest.mark.parametrize(
    ("laws", "values"),
    [
        (LOBE, known(flux=900, beam_angle=0.5, distance=3, incidence=0.2, time=60, within=0.1)),
        (LOBE, known(irradiance=20, exponent=3, distance=3, cosine=0.5, receiver_area=0.01)),
        (LOBE, known(flux=500, intensity=900, height=3, lateral=1, incidence=0.3)),
        (CONE, known(flux=900, apex_angle=0.5, exposure=90, time=6, incidence=0.2)),
        (SURFACE, known(exposure=60, time=2, projected_solid_angle=0.3, radius=0.2)),
        (SURFACE, known(energy=60, time=2, radius=0.2, incident_irradiance=900)),
        (photometry.EXPOSURE_LAWS, known(luminance=512, k=12.5, c=250, iso=400, f_number=8)),
        (HEAT_LAWS, known(mass=0.1, specific_heat=385, temperature_rise=2, absorptance=0.9,
                          time=30, receiver_area=0.01)),
        ([*BEAM, beams.DISCS, beams.RECEIVER_CIRCLE, beams.FAR_FIELD],
         known(flux=3, radiance=2, radius=1, distance=3)),
        ([*BEAM, beams.CONE], known(etendue=0.3, radius=1, flux=9)),
        (photometry.MESOPIC_LAWS, known(mesopic_luminance=0.1, sp_ratio=2)),
    ],
)  # fmt: skip
def test_derived_values_do_not_depend_on_the_order_of_the_laws(laws, values):
    first = solve(laws, values)
    assert len(first.values) > len(values) + 2
    for seed in range(20):
        mixed = random.Random(seed).sample(laws, len(laws))
        other = solve(mixed, values)
        assert set(other.values) == set(first.values)
        for name, one in first.values.items():
            assert other.values[name].value == pytest.approx(one.value, rel=1e-9), name


@pytest.mark.parametrize("seed", range(6))
def test_a_surplus_value_is_checked_in_any_order_of_the_laws(seed):
    laws = random.Random(seed).sample(LOBE, len(LOBE))
    # 100 cd and n = 3: flux 2 pi 100 / 4 = 50 pi lm
    good = known(intensity=100, exponent=3, flux=50 * PI)
    assert solve(laws, good).values["solid-angle"].value == pytest.approx(PI / 2, rel=1e-12)
    for off in (1.001, 0.999, 2):
        bad = known(intensity=100, exponent=3, flux=50 * PI * off)
        with pytest.raises(Disagreement):
            solve(laws, bad)


@for_each([  # half a unit of the last digit, over the number; a single digit counts as three
    ("2m", 0.005 / 2), ("2.0m", 0.05 / 2), ("2.00m", 0.005 / 2), ("2.000m", 0.0005 / 2),
    ("10cm", 0.5 / 10), ("10.0cm", 0.05 / 10), ("15", 0.5 / 15), ("-15", 0.5 / 15),
    ("+1.5", 0.05 / 1.5), ("0.5", 0.0005 / 0.5), ("0.50", 0.005 / 0.5),
    ("0.0012m", 0.00005 / 0.0012), ("12.5deg", 0.05 / 12.5), ("4.5klm", 0.05 / 4.5),
    ("1e3lx", 0.005), ("1.2345e-7W", 0.00005 / 1.2345), ("999", 0.5 / 999),
    ("1000lx", 0.5 / 1000), ("0", 1e-9), ("0.0", 1e-9), ("1/100s", 1e-9), ("1/3", 1e-9),
    ("pi", 1e-9), ("2pi", 1e-9), ("4π", 1e-9),
])  # fmt: skip
def test_the_rounding_of_a_typed_number(text, off):
    assert rounding(text) == pytest.approx(off, rel=1e-12)


@pytest.mark.parametrize(
    ("given_values", "fits"),
    [  # 800/(16 pi) = 15.9155 lx
        ({"illuminance": "15.9lx"}, True), ({"illuminance": "16lx"}, True),
        ({"illuminance": "15.92lx"}, True), ({"illuminance": "15.5lx"}, False),
        ({"illuminance": "17lx"}, False), ({"intensity": "63.7cd"}, True),
        ({"intensity": "63.66cd"}, True), ({"intensity": "64.5cd"}, False),
    ],
)  # fmt: skip
def test_surplus_values_are_compared_to_the_digits_typed(given_values, fits):
    def call():
        return point_source(flux="800lm", distance="2m", incidence="0deg", **given_values)

    if fits:
        assert number(call(), "intensity", "cd") == pytest.approx(200 / PI, rel=5e-3)
    else:
        with pytest.raises(Contradiction, match=r"contradicts .*\(ratio "):
            call()


def test_two_derivations_of_zero_light_do_not_contradict_each_other():
    # from the intensity and from the radiance, with the source behind the receiver
    found = lambertian(
        luminance="100cd/m2", area="1cm2", distance="1m", incidence="120deg", time="3s"
    )
    assert number(found, "irradiance", "lx") == number(found, "exposure", "lx s") == 0


def test_a_wrong_value_does_not_widen_the_tolerance_of_the_others():
    # I = 40.654 cd and 13.28 lm: n = 18.23; 40.654 cos(47.47 deg)^19.23 / 19.75^2 = 5.6e-5 lx
    with pytest.raises(Contradiction):
        point_source(
            distribution="lobe", exposure="0.3577lx.s", flux="13.28lm", height="13.35m",
            intensity="40.654cd", offset="14.552m", time="3679.1s",
        )  # fmt: skip


@pytest.mark.parametrize("off", [0.9985, 1, 1.0015])
@pytest.mark.parametrize(
    ("work_out", "area", "name", "size", "unit"),
    [
        # 6 x 9 m2, and 12 (3600) (0.7) (0.9) / 54 = 504 lx
        (
            partial(room, width="6m", length="9m", luminaires="12", flux="3600lm",
                    utilance="0.7", maintenance="0.9"),
            54, "illuminance", 504, "lx",
        ),
        # pi 0.25^2 m2, and pi (100) pi 0.25^2 = 61.685 lm
        (partial(lambertian, "disc", luminance="100cd/m2", radius="25cm"),
         PI / 16, "flux", 61.685, "lm"),
        # 0.25^2 m2, and pi (100) 0.25^2 = 19.635 lm
        (partial(lambertian, "rectangle", luminance="100cd/m2", width="25cm", length="25cm"),
         0.0625, "flux", 19.635, "lm"),
        # 2 x 1.2 m2, and 3000 / 2.4 = 1250 lx
        (partial(screen, flux="3000lm", width="2m", height="1.2m"),
         2.4, "illuminance", 1250, "lx"),
    ],
    ids=["room", "disc", "rectangle", "screen"],
)  # fmt: skip
def test_an_area_is_derived_from_sizes_not_from_rounded_light(
    work_out, area, name, size, unit, off
):
    found = work_out(**{name: f"{size * off:.4g}{unit}"})
    assert number(found, "area", "m2") == pytest.approx(area, rel=1e-12)


@pytest.mark.parametrize("redundant", [{}, {"area": "54m2"}])
def test_counts_are_exact(redundant):
    # 12 (3600) (0.7) (0.9) / 54 = 504 lx; 500 lx would be 11.9 luminaires
    with pytest.raises(Contradiction, match="504 lx"):
        room(
            width="6m", length="9m", luminaires="12", flux="3600lm", utilance="0.7",
            maintenance="0.9", illuminance="500lx", **redundant,
        )  # fmt: skip
