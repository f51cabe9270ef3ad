"""Arrays of spectra give the same results as single spectra."""

import numpy as np
import pytest

from radcalc import spectra
from radcalc.errors import RadcalcError
from radcalc.spectra.observers import OBSERVERS
from radcalc.spectra.spectrum import Table

PHOTOPIC = OBSERVERS["photopic"]


def test_arrays_of_spectra_give_the_same_as_single_spectra():
    grid = np.linspace(390, 720, 34)
    cube = np.random.default_rng(1).random((3, 4, 34))
    lumens = spectra.luminous(grid, cube)
    efficacies = spectra.luminous_efficacy(grid, cube, limits=(400, 700))
    assert lumens.shape == efficacies.shape == (3, 4)
    for index in np.ndindex(3, 4):
        table = Table("", list(grid), list(cube[index]))
        seen = PHOTOPIC.maximum * table.seen(PHOTOPIC)
        assert lumens[index] == pytest.approx(seen, rel=1e-12)
        assert efficacies[index] == pytest.approx(seen / table.power((400, 700)), rel=1e-12)


def test_dask_arrays_stay_lazy_and_give_the_same_results():
    import dask.array

    grid = np.linspace(380, 780, 41)
    cube = np.random.default_rng(2).random((20, 30, 41))
    lazy = dask.array.from_array(cube, chunks=(5, 10, 41))
    for function in (spectra.luminous, spectra.luminous_efficacy):
        result = function(grid, lazy)
        assert isinstance(result, dask.array.Array)
        np.testing.assert_allclose(result.compute(), function(grid, cube), rtol=1e-12)


@pytest.mark.parametrize(
    ("grid", "shape", "observer"),
    [
        ([500.0, 400.0], (2,), "photopic"),
        ([400.0, 500.0], (3,), "photopic"),
        ([400.0], (1,), "photopic"),
        ([-1.0, 500.0], (2,), "photopic"),
        ([400.0, 500.0], (2,), "owl"),
    ],
)
def test_arrays_of_incompatible_shapes_are_refused(grid, shape, observer):
    with pytest.raises(RadcalcError):
        spectra.luminous(grid, np.ones(shape), observer)
