"""Arguments that each function of the geometry refuses, and arrays against floats."""

import math

import numpy as np
import pytest
from helpers import by_law, for_each

from radcalc import geometry
from radcalc.errors import ConditionError
from radcalc.geometry import numerics, projections, solid
from radcalc.laws.beams import APERTURE, LENS, PATCHES
from radcalc.maths import CHUNK, in_chunks

REFUSED = [
    (geometry.cone, (-1e-9,)), (geometry.cone, (3.15,)), (geometry.cone_of, (-1.0,)),
    (geometry.cone_of, (12.6,)), (solid.zone, (1.0, 0.5)), (solid.zone, (-0.1, 0.5)),
    (solid.zone, (0.1, 3.2)), (solid.zone, (0.1, 1.0, 6.4)), (solid.sphere, (1.0, 1.0)),
    (solid.sphere, (2.0, 1.0)), (solid.sphere, (-1.0, 1.0)),
    (solid.sphere_distance, (1.0, 6.3)),
    (solid.sphere_radius, (1.0, 0.0)), (solid.disc, (1.0, 0.0)), (solid.disc, (-1.0, 1.0)),
    (solid.rectangle, (1.0, -1.0, 1.0)), (solid.rectangle, (1.0, 1.0, 0.0)),
    (solid.pyramid, (3.2, 1.0)), (solid.patch, (1.0, 0.0)), (solid.patch, (-1.0, 1.0)),
    (solid.projected_cone, (1.0, 3.2)), (solid.projected_sphere, (1.0, 1.0)),
    (solid.projected_disc, (1.0, -1.0)),
    (solid.projected_zone, (1.0, 0.5)), (solid.projected_pyramid, (-1.0, 1.0)),
    (solid.projected_rectangle, (1.0, 1.0, 1.0, 0.0, 0.0, (0.0, 0.0, 0.0))),
    (geometry.projected_cone, (-1e-9,)), (geometry.projected_cone, (3.15,)),
    (geometry.projected_cone_of, (-1e-9,)), (geometry.projected_cone_of, (3.15,)),
    (solid.rim_of, (0.0,)), (solid.rim_of, (6.3,)), (solid.pyramid_side, (2.5, 1.0)),
    (solid.pyramid_side, (-0.1, 1.0)), (solid.pyramid_side, (6.3, math.pi)),
    (solid.pyramid_side, (1.0, 3.2)), (solid.patch_and_cone, (1.0, 1.6)),
    (solid.coaxial_discs, (1.0, 1.0, 0.0)), (solid.discs_distance, (1.0, 2.0, 0.0)),
    (solid.discs_distance, (1.0, 2.0, 10.0)), (solid.discs_radius, (1.0, 2.0, 10.0)),
    (projections.spherical, (0.0, 0.0, 0.0)),
    (projections.cartesian, (-0.1, 0.0)),
]  # fmt: skip


@for_each(REFUSED)
def test_impossible_arguments_are_refused(function, arguments):
    with pytest.raises(ConditionError) as caught:
        function(*arguments)
    assert caught.value.hint
    with pytest.raises(ConditionError):
        function(np.array([arguments[0]] * 2), *arguments[1:])


ARRAYS = [
    (geometry.cone, [0.0, 1e-9, 1.0, 3.0]),
    (geometry.cone_of, [0.0, 1e-9, 1.0, 12.566370614360]),
    (solid.zone, [0.0, 0.1, 0.5], [0.5, 1.0, 3.0], [1.0, 6.0]),
    (solid.angular_radius, [0.1, 1.0], [1.5, 1e9]),
    (solid.sphere, [0.0, 0.1, 1.0], [1.0000001, 2.0, 1e9]),
    (solid.sphere_distance, [0.1, 1.0], [1e-9, 1.0, 6.0]),
    (solid.sphere_radius, [0.1, 1.0], [1e-9, 1.0, 6.0]),
    (solid.disc, [0.0, 1.0, 2.0], [1e-3, 0.5, 100.0], [-3.0, 0.0, 1.0, 2.0]),
    (solid.rectangle, [1e-3, 1.0], [0.5, 2.0], [0.1, 1.0], [0.0, 0.5], [0.0, 3.0]),
    (solid.pyramid, [0.0, 1e-9, 1.0, 3.14], [1e-9, 1.0, 3.1]),
    (solid.patch, [0.0, 1.0], [1.0, 2.0], [0.0, 1.0, 2.0]),
    (solid.projected_cone, [1e-9, 0.5, 1.5, 2.5], [0.0, 0.4, -1.4, 2.0, 3.1]),
    (solid.projected_zone, [0.0, 0.1, 0.5], [0.5, 1.0, 3.0], [1.0, 6.0]),
    (solid.projected_sphere, [0.1, 1.0], [1.1, 2.0], [0.0, 1.0, 2.0]),
    (solid.projected_disc, [0.1, 1.0], [1e-3, 0.5], [0.0, 1.0, 2.0], [0.0, 0.5, 1.5, -1.5, 3.0]),
    (solid.projected_disc, [0.1, 1.0], [1e-3, 0.5], [0.0, 1.0, 2.0]),
    (solid.projected_rectangle, [1e-3, 1.0], [0.5, 2.0], [0.1, 1.0], [0.0, 0.5], [0.0, 3.0]),
    (solid.projected_pyramid, [0.0, 1e-9, 1.0, 3.14], [1e-9, 1.0, 3.1]),
    (solid.patch_and_cone, [1.0, 2.0], [0.0, 1.0, 1.5]),
    (by_law(APERTURE), [1.0, 2.0], [0.1, 1.0]),
    (by_law(LENS), [1.0, 2.0], [0.5, 4.0]),
    (by_law(PATCHES), [1.0, 2.0], [0.0, 1.0], [1.0, 3.0], [0.0, 0.5], [1.0, 9.0]),
    (geometry.projected_cone, [0.0, 1e-9, 1.0, 2.0, 3.0]),
    (geometry.projected_cone_of, [0.0, 1e-9, 1.0, 3.1, 3.141592653590]),
    (geometry.facing, [0.0, 1.0, -1.0, 2.0, 3.0]),
    (geometry.lobe, [0.0, 1.0, 150.0]),
    (solid.rim_of, [1e-9, 1.0, 6.0]),
    (solid.pyramid_side, [0.0, 1e-9, 1.0, 1.9], [1.0, 3.1]),
    (solid.discs_distance, [0.5, 1.0], [0.7, 2.0], [1e-3, 1.0, 2.4]),
    (solid.discs_radius, [0.7, 2.0], [1e-3, 1.0, 1e6], [1e-3, 1.0, 4.0]),
    (solid.coaxial_discs, [0.1, 1.0], [0.2, 1.0], [1e-3, 1.0, 1e6]),
    (numerics.cel, [1e-3, 1.0], [0.5, 1.0], [1.0], [0.0, 1.0]),
    (numerics.less_arctangent, [0.0, 0.1, 0.25, 2.0]),
    (numerics.arc_excess, [0.0, 0.1, 0.25, 1.0]),
]


@pytest.mark.usefixtures("_few_integrals")
@pytest.mark.parametrize(("function", "axes"), [(f, axes) for f, *axes in ARRAYS])
def test_arrays_give_the_same_as_floats(function, axes):
    grids = np.meshgrid(*axes, indexing="ij")
    floats = [function(*map(float, at)) for at in zip(*(g.ravel() for g in grids), strict=True)]
    want = np.reshape(floats, grids[0].shape)
    np.testing.assert_allclose(function(*grids), want, rtol=2e-13, atol=0)
    # open axes, which broadcast, and a float for the last axis
    np.testing.assert_allclose(function(*np.ix_(*axes)), want, rtol=2e-13, atol=0)
    if len(axes) > 1:
        part = function(*np.ix_(*axes[:-1]), float(axes[-1][-1]))
        np.testing.assert_allclose(part, want[..., -1], rtol=2e-13, atol=0)


@pytest.mark.parametrize("count", [3, CHUNK, CHUNK + 1, 3 * CHUNK])
def test_a_long_row_is_computed_in_parts(count):
    row = np.arange(count, dtype=float)
    assert (in_chunks(lambda x, y: x + 2 * y, row, row) == 3 * row).all()
    assert (in_chunks(lambda x, y: x + 2 * y, row, 1.0) == row + 2).all()
