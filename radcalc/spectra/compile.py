"""Print colour-science's tables of the observers as package data.

`python -m radcalc.spectra.compile` writes `observers_data.py`.  The only module of radcalc
that imports colour-science.
"""

import warnings
from pathlib import Path
from typing import Any

DATA = Path(__file__).with_name("observers_data.py")
TABLES = {
    "PHOTOPIC": ("SDS_LEFS_PHOTOPIC", "CIE 1924 Photopic Standard Observer"),
    "SCOTOPIC": ("SDS_LEFS_SCOTOPIC", "CIE 1951 Scotopic Standard Observer"),
    "CIE_1964": ("SDS_LEFS_PHOTOPIC", "CIE 1964 Photopic 10 Degree Standard Observer"),
    "JUDD_VOS": ("SDS_LEFS_PHOTOPIC", "Judd-Vos Modified CIE 1978 Photopic Standard Observer"),
    "CIE_2008_2": ("SDS_LEFS_PHOTOPIC", "CIE 2008 2 Degree Physiologically Relevant LEF"),
    "CIE_2008_10": ("SDS_LEFS_PHOTOPIC", "CIE 2008 10 Degree Physiologically Relevant LEF"),
}


def table(group: str, name: str) -> tuple[int, tuple[float, ...]]:
    """Return the first wavelength [nm] of a table at 1 nm, and its values."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # colour-science warns of packages it can do without
        import colour.colorimetry

    observer: Any = getattr(colour.colorimetry, group)[name]
    if observer.shape.interval != 1:
        raise ValueError(f"{name} is not at 1 nm")
    # 12 digits: the tables have at most 8, the rest is the noise of a division
    return int(observer.shape.start), tuple(float(f"{v:.12g}") for v in observer.values)


def compile_observers() -> str:
    """Return the text of `observers_data.py`."""
    parts = [
        '"""Printed by `python -m radcalc.spectra.compile` from colour-science; do not edit."""\n'
    ]
    for constant, (group, name) in TABLES.items():
        start, values = table(group, name)
        lines = "".join(
            "        " + ", ".join(map(repr, values[i : i + 6])) + ",\n"
            for i in range(0, len(values), 6)
        )
        parts.append(f"\n# {name}, 1 nm\n{constant} = (\n    {start},\n    (\n{lines}    ),\n)\n")
    return "".join(parts)


if __name__ == "__main__":
    DATA.write_text(compile_observers(), encoding="utf-8")
