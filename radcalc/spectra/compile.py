"""Print the tables of observers and light sources as package data.

`python -m radcalc.spectra.compile` writes `data/observers.py`, `data/sources.py` and
`data/colours.py` from colour-science, and `data/suns.py` from the ASTM G173-03 table that pvlib
ships.
"""

import csv
import math
import warnings
from collections.abc import Iterable
from importlib.util import find_spec
from pathlib import Path
from typing import Any

HERE = Path(__file__).parent / "data"
HEAD = '"""Printed by `python -m radcalc.spectra.compile` from {}; do not edit."""\n'
TABLES = {
    "PHOTOPIC": ("SDS_LEFS_PHOTOPIC", "CIE 1924 Photopic Standard Observer"),
    "SCOTOPIC": ("SDS_LEFS_SCOTOPIC", "CIE 1951 Scotopic Standard Observer"),
    "CIE_1964": ("SDS_LEFS_PHOTOPIC", "CIE 1964 Photopic 10 Degree Standard Observer"),
    "JUDD_VOS": ("SDS_LEFS_PHOTOPIC", "Judd-Vos Modified CIE 1978 Photopic Standard Observer"),
    "CIE_2008_2": ("SDS_LEFS_PHOTOPIC", "CIE 2008 2 Degree Physiologically Relevant LEF"),
    "CIE_2008_10": ("SDS_LEFS_PHOTOPIC", "CIE 2008 10 Degree Physiologically Relevant LEF"),
}
DAYLIGHT = ("D50", "D55", "D60", "D65", "D75")
Table = tuple[float, float, tuple[float, ...]]


def load_colour() -> Any:
    """colour-science, without its warnings of packages that are missing.

    Importing it changes how NumPy prints arrays in the whole process: that is undone.
    """
    import numpy

    with warnings.catch_warnings(), numpy.printoptions():
        warnings.simplefilter("ignore")
        import colour
    return colour


def digits(values: Iterable[float]) -> tuple[float, ...]:
    """12 digits: the tables have at most 8, the rest is the noise of a division."""
    return tuple(float(f"{v:.12g}") for v in values)


def observer(group: str, name: str) -> tuple[int, tuple[float, ...]]:
    """Return the first wavelength [nm] of an observer's table at 1 nm, and its values."""
    table: Any = getattr(load_colour().colorimetry, group)[name]
    if table.shape.interval != 1:
        raise ValueError(f"{name} is not at 1 nm")
    return int(table.shape.start), digits(table.values)


def illuminant_a(nanometres: float) -> float:
    """CIE standard illuminant A by its formula (CIE 15): 100 at 560 nm, 2848 K, c2 0.01435 m K."""
    scale = 1.435e7 / 2848
    shape = math.expm1(scale / 560) / math.expm1(scale / nanometres)
    return 100 * (560 / nanometres) ** 5 * shape


def sources() -> dict[str, Table]:
    """Return every illuminant and light source of colour-science: start, step [nm] and values.

    A is taken from its formula and the D series is carried on from its components, 300 to
    830 nm both: colour-science's tables of them stop at 780 nm.
    """
    c = load_colour().colorimetry
    tables: dict[str, Table] = {}
    for name, table in [*c.SDS_ILLUMINANTS.items(), *c.SDS_LIGHT_SOURCES.items()]:
        shape = table.shape
        tables[name] = (float(shape.start), float(shape.interval), digits(table.values))
    grid = [300.0 + 5 * i for i in range(107)]
    tables["A"] = (300.0, 5.0, digits(illuminant_a(x) for x in grid))
    for name in DAYLIGHT:
        beyond = daylight(float(name[1:]) * 100 * 1.4388 / 1.4380)
        start, step, values = tables[name]
        tables[name] = (start, step, digits([*values, *beyond[len(values) :]]))
    return tables


def samples() -> list[tuple[float, ...]]:
    """Return the reflectances of the test colour samples 1 to 8 of CIE 13.3-1995, 360 to 830 nm."""
    c = load_colour()
    tables = c.quality.SDS_TCS["CIE 1995"]
    each_nanometre = c.SpectralShape(360, 830, 1)
    chosen = [tables[f"TCS{number:02d}"].copy() for number in range(1, 9)]
    return [digits(table.interpolate(each_nanometre).values) for table in chosen]


def components() -> dict[str, tuple[float, ...]]:
    """Return the mean and the two characteristic vectors of daylight, 300 to 830 nm at 5 nm."""
    basis = load_colour().colorimetry.SDS_BASIS_FUNCTIONS_CIE_ILLUMINANT_D_SERIES
    return {name: digits(basis[name].values) for name in ("S0", "S1", "S2")}


def daylight(temperature: float) -> list[float]:
    """A CIE daylight from its components, by the same function that serves at run time."""
    from radcalc.spectra.daylight import combine

    return combine(temperature, **components())


def suns() -> tuple[tuple[float, ...], ...]:
    """ASTM G173-03: wavelengths [nm], extraterrestrial, global tilt and direct [W/m2/nm]."""
    package = find_spec("pvlib")  # its data, without importing what it needs
    if package is None or package.origin is None:
        raise ModuleNotFoundError("pvlib, which ships ASTM G173-03: pip install --no-deps pvlib")
    text = Path(package.origin).with_name("data").joinpath("ASTMG173.csv").read_text("utf-8")
    rows = [tuple(map(float, row)) for row in list(csv.reader(text.splitlines()))[2:]]
    return tuple(zip(*rows, strict=True))


def lines(values: Iterable[float], indent: int = 8) -> str:
    """Numbers, eight a line."""
    texts = [repr(value) for value in values]
    pad = " " * indent
    rows = (", ".join(texts[i : i + 8]) for i in range(0, len(texts), 8))
    return "".join(f"{pad}{row},\n" for row in rows)


def compile_observers() -> str:
    """Return the text of `data/observers.py`."""
    parts = [HEAD.format("colour-science")]
    for constant, (group, name) in TABLES.items():
        start, values = observer(group, name)
        parts.append(
            f"\n# {name}, 1 nm\n{constant} = (\n    {start},\n    (\n{lines(values)}    ),\n)\n"
        )
    return "".join(parts)


def compile_sources() -> str:
    """Return the text of `data/sources.py`."""
    parts = [
        HEAD.format("colour-science"),
        "\n# name: (start [nm], step [nm], values)\nSOURCES = {\n",
    ]
    for name, (start, step, values) in sources().items():
        parts.append(
            f"    {name!r}: (\n        {start},\n        {step},\n"
            f"        (\n{lines(values, 12)}        ),\n    ),\n"
        )
    parts.append("}\n\n# The components of CIE daylight, 300 nm to 830 nm at 5 nm\n")
    parts += [f"{name} = (\n{lines(values, 4)})\n" for name, values in components().items()]
    return "".join(parts)


def compile_colours() -> str:
    """Return the text of `data/colours.py`."""
    parts = [HEAD.format("colour-science")]
    functions = load_colour().colorimetry.MSDS_CMFS["CIE 1931 2 Degree Standard Observer"]
    for name, values in zip("XYZ", functions.values.T, strict=True):
        if name == "Y":
            continue  # V(lambda), of data/observers.py
        parts.append(
            "\n# CIE 1931 colour-matching function, 360 nm to 830 nm at 1 nm\n"
            f"{name} = (\n{lines(digits(values), 4)})\n"
        )
    parts.append(
        "\n# The test colour samples 1 to 8 of CIE 13.3-1995: reflectances at 5 nm, between\n"
    )
    parts.append("# which CIE 167:2005 has Sprague's interpolation, 360 nm to 830 nm at 1 nm\n")
    parts.append("SAMPLES = (\n")
    for values in samples():
        parts.append(f"    (\n{lines(values)}    ),\n")
    return "".join([*parts, ")\n"])


def compile_suns() -> str:
    """Return the text of `data/suns.py`."""
    names = ("WAVELENGTHS", "AM0", "AM1_5G", "AM1_5D")
    parts = [HEAD.format("ASTM G173-03, as pvlib ships it")]
    parts += [f"\n{name} = (\n{lines(v, 4)})\n" for name, v in zip(names, suns(), strict=True)]
    return "".join(parts)


FILES = {
    "observers.py": compile_observers,
    "sources.py": compile_sources,
    "colours.py": compile_colours,
    "suns.py": compile_suns,
}


if __name__ == "__main__":
    for name, text in FILES.items():
        (HERE / name).write_text(text(), encoding="utf-8")
