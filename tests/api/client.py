"""Program that uses radcalc, runs, and passes mypy in strict mode."""

import numpy as np

import radcalc
from radcalc import Quantity, RadcalcError, Result


def lamp(distance: Quantity) -> Result:
    return radcalc.point_source(luminous_flux="800 lm", distance=distance, isotropic=True)


def brightest(distances: list[str]) -> float:
    found = radcalc.point_source(intensity="100 cd", distance=distances, exponent=2)
    values: list[float] = found.illuminance.to("lx").magnitude.tolist()
    return max(values)


def footcandles(illuminance: Quantity) -> Quantity:
    assert radcalc.convert(500, "lx", "fc") == radcalc.convert("500 lx", "fc")
    return radcalc.convert(illuminance, "fc")


def told(result: Result) -> list[str]:
    names = [f"{name} [{quantity.units}]" for name, quantity in result.items()]
    return [*names, *result.assumptions, *(step.law for step in result.steps)]


def candelas(text: str) -> str:
    try:
        return str(radcalc.convert(text, "cd"))
    except radcalc.UnitError as error:
        return error.hint
    except RadcalcError as error:
        return error.message


def main() -> None:
    near = lamp(Quantity(np.array([1.0, 2.0]), "m"))
    print(footcandles(near.irradiance), near.illuminance.units, *told(near))
    print(brightest(["1 m", "2 m"]), candelas("800 lm"), candelas("1 zork"))
    print(radcalc.factor("lx", "ppfd", spectrum="D65") * 2)
    print(radcalc.lambertian("disc", luminance="1 cd/m2", radius="1 m", height="2 m").irradiance)
    print(radcalc.uberlight([[0, 0, 1], [0, 0, 2]], intensity="1 cd", superellipse=(1, 1, 2, 2)))
    sky = radcalc.sky(12, sun_elevation="40 deg", zenith_luminance="9 kcd/m2")
    print(sky.horizontal_illuminance.round(), sky.to_dict()["command"])
    print(radcalc.photon("555 nm", observer="scotopic").to_dict()["results"].keys())
    print(radcalc.solid_angle("zone", polar=("30 deg", "60 deg")).solid_angle.m_as("sr"))
    print(radcalc.ev(f_number=16, time=Quantity(10, "ms")).ev.magnitude)
    assert radcalc.point_source("100 cd", Quantity(2, "m")).illuminance.m_as("lx") == 25
    lux, stamps = [0.0, 500.0, 0.0], ["2024-06-01 08:00", "2024-06-01 12:00", "2024-06-01 20:00"]
    print(radcalc.dose(lux, Quantity([0.0, 4.0, 12.0], "h"), unit="lx").exposure.m_as("lx h"))
    days = radcalc.dose(lux, stamps, unit="lx", by="day")
    print({day: result.exposure.m_as("lx h") for day, result in days.items()})
    print(radcalc.typical("office")[0].source, radcalc.examples("museum")[0].title)
    print(radcalc.integrate("cos(theta)", half_angle="90 deg").integral.m_as("sr"))
    lamps = [{"x": 0, "y": 0, "z": 2, "intensity": "100 cd"}]
    print(radcalc.scene(lamps, np.zeros((1, 3)), normal=(0, 0, 1)).irradiance.shape)


if __name__ == "__main__":
    main()
