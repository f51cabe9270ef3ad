from radcalc.quantities import (
    AXIS,
    FLUX,
    GEOMETRIES,
    GRID,
    OTHERS,
    describe,
    light_dimension,
    name_of,
    read,
    symbol_of,
)
from radcalc.units.table import resolve


def test_no_two_quantities_share_a_dimension():
    dimensions = [
        light_dimension(kind, geometry, axis)
        for kind in FLUX
        for geometry in GEOMETRIES
        for axis in AXIS
    ]
    assert len(dimensions) == 3 * 8 * 4
    assert len(set(dimensions)) == len(dimensions)
    assert len({*dimensions, *OTHERS}) == len(dimensions) + len(OTHERS)


def test_the_facts_are_read_back_from_every_dimension():
    for kind in FLUX:
        for geometry in GEOMETRIES:
            for axis in AXIS:
                assert GRID[light_dimension(kind, geometry, axis)] == (kind, *geometry, axis)


NAMES = {
    "J": ("radiant energy", "Q_e"),
    "W": ("radiant flux", "Φ_e"),
    "W/sr": ("radiant intensity", "I_e"),
    "W/m2": ("irradiance", "E_e"),
    "W/m2/sr": ("radiance", "L_e"),
    "J/cm2": ("radiant exposure", "H_e"),
    "talbot": ("luminous energy", "Q_v"),
    "lm": ("luminous flux", "Φ_v"),
    "cd": ("luminous intensity", "I_v"),
    "lx": ("illuminance", "E_v"),
    "radlux": ("luminous exitance", "M_v"),
    "fL": ("luminance", "L_v"),
    "lx.s": ("luminous exposure", "H_v"),
    "mol": ("photon number", "Q_p"),
    "umol/s": ("photon flux", "Φ_p"),
    "umol/m2/s": ("photon irradiance", "E_p"),
    "rayleigh": ("photon radiance", "L_p"),
    "W/m2/nm": ("spectral irradiance (per wavelength)", "E_e,λ"),
    "Jy": ("spectral irradiance (per frequency)", "E_e,ν"),
    "mW/(m2 sr cm-1)": ("spectral radiance (per wavenumber)", "L_e,σ"),
    "photon/s/cm2/keV": ("spectral photon irradiance (per photon energy)", "E_p,Q"),
    "W/m2/J": ("spectral irradiance (per photon energy)", "E_e,Q"),
    "flick": ("spectral radiance (per wavelength)", "L_e,λ"),
    "lm/m": ("luminous flux per length", ""),
    "lm/nm": ("spectral luminous flux (per wavelength)", "Φ_v,λ"),
    "td": ("retinal illuminance", "E_T"),
    "lm/W": ("luminous efficacy", "K"),
    "umol/J": ("photon efficacy", "K_p"),
    "mm2.sr": ("etendue", "G"),
    "deg2": ("solid angle", "Ω"),
    "deg": ("angle", "α"),
    "Hz": ("frequency", "ν"),
    "cm-1": ("wavenumber", "σ"),
    "eV/photon": ("photon energy", "Q"),
}


def test_units_are_named_after_what_they_measure():
    for text, (name, symbol) in NAMES.items():
        unit = resolve(text)
        assert (name_of(unit), symbol_of(unit)) == (name, symbol), text


def test_a_quantity_without_a_name_is_shown_as_its_unit():
    assert describe(resolve("kg.m5")) == "'kg.m5'"
    assert read(resolve("kg.m5")) is None
