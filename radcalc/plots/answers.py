"""The picture of an answer, by command, and the curves of several answers."""

from collections.abc import Callable, Sequence
from typing import Any

from radcalc.calculators.results import name_of, pick
from radcalc.errors import UsageError, mention
from radcalc.inputs import Inputs
from radcalc.plots import Picture
from radcalc.plots.curves import RANGE, Solved, curves, ranged, varied, without_band
from radcalc.spectra.observers import OBSERVERS, Observer
from radcalc.spectra.spectrum import WHOLE


def picture(
    command: str, solved: Sequence[Solved], wanted: Sequence[str] = (), operand: Any = None
) -> Picture:
    """Return the curves over a varied input, or else the picture of a single answer.

    `wanted` are the results to draw as curves, NAME[:UNIT].  `operand` is what the command works on
    in addition to its inputs: the name of a sky; the `radcalc.calculators.environment.Source` of an
    environment; an expression and the text of its unit; the `radcalc.plots.space.Surveyed` of a
    scene.  Raise a UsageError if there is no such picture.
    """
    along = varied(solved)
    if along and command not in LISTS:
        return curves(solved, wanted)
    if command not in OF_ONE:
        hint = ranged(solved[0].given) or mention(RANGE)
        raise UsageError("there is no picture of a single answer for this command", hint)
    drawn = OF_ONE[command](solved, wanted, operand)
    return drawn if command in WITH_BANDS else _of_values(drawn, solved)


def _of_values(drawn: Picture, solved: Sequence[Solved]) -> Picture:
    """Return a picture with a note of the uncertain inputs, whose uncertainty it does not show."""
    uncertain = [item for each in solved for item in each.given.values() if item.is_uncertain]
    return drawn._replace(note=without_band(uncertain)) if uncertain else drawn


def depends(command: str, solved: Solved, name: str) -> bool:
    """Return whether the picture depends on a requested result, NAME[:UNIT]."""
    if varied([solved]) and command not in LISTS:
        return True
    from radcalc.plots.curves import explains
    from radcalc.plots.space import is_intensity

    if command == "spectrum":
        return explains(name_of(name))
    return command == "point-source" and is_intensity(name)


def _spectrum(solved: Sequence[Solved], wanted: Sequence[str], operand: Any) -> Picture:
    from radcalc.plots.curves import diagram, spectra

    sources = [answer.given["spectrum"].value for answer in solved]
    if picture := diagram(sources, [*map(name_of, wanted)]):
        return picture
    given = solved[0].given
    limits = given["range"].value if "range" in given else WHOLE
    return spectra(sources, _eye(given), limits)


def _photon(solved: Sequence[Solved], wanted: Sequence[str], operand: Any) -> Picture:
    from radcalc.plots.curves import photon

    given = solved[0].given
    wave = given[next(iter(given))]
    return photon([(wave.text, pick(solved[0].answer.values, "wavelength:nm").value)], _eye(given))


def _eye(given: Inputs) -> Observer:
    return OBSERVERS[given["observer"].value if "observer" in given else "photopic"]


def _point_source(solved: Sequence[Solved], wanted: Sequence[str], operand: Any) -> Picture:
    from radcalc.plots.space import of_point_source

    return of_point_source(solved[0], wanted)


def _scene(solved: Sequence[Solved], wanted: Sequence[str], operand: Any) -> Picture:
    from radcalc.plots.space import over_grid

    return over_grid(operand)


def _sky(solved: Sequence[Solved], wanted: Sequence[str], operand: Any) -> Picture:
    from radcalc.plots.space import of_sky

    return of_sky(operand, solved[0])


def _environment(solved: Sequence[Solved], wanted: Sequence[str], operand: Any) -> Picture:
    from radcalc.plots.space import of_environment

    return of_environment(operand, solved[0])


def _integrate(solved: Sequence[Solved], wanted: Sequence[str], operand: Any) -> Picture:
    from radcalc.calculators.integrate import directions
    from radcalc.plots.space import integrand

    text, unit = operand
    polar, azimuths = directions(solved[0].given)
    return integrand(text, unit, polar, azimuths)


# commands that draw several answers in a picture other than curves
LISTS = ("spectrum", "scene")
WITH_BANDS = ("point-source",)  # whose single picture shows uncertainties, or has its own note
OF_ONE: dict[str, Callable[[Sequence[Solved], Sequence[str], Any], Picture]] = {
    "spectrum": _spectrum,
    "photon": _photon,
    "point-source": _point_source,
    "scene": _scene,
    "sky": _sky,
    "environment": _environment,
    "integrate": _integrate,
}
