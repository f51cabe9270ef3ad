"""The picture of an answer: of each command its own, and of several answers their curves."""

from collections.abc import Callable, Sequence
from typing import Any

from radcalc.errors import UsageError, mention
from radcalc.plots.curves import RANGE, Solved, curves, varied
from radcalc.plots.data import Picture
from radcalc.spectra.observers import OBSERVERS
from radcalc.spectra.spectrum import WHOLE


def picture(
    command: str, solved: Sequence[Solved], wanted: Sequence[str] = (), operand: Any = None
) -> Picture:
    """What the answers of a command look like.

    Parameters
    ----------
    command : str
        Its name: "point-source".
    solved : sequence of Solved
        What was given for each answer, and the answers.
    wanted : sequence of str
        The results that are asked for, NAME[:UNIT], of which curves are drawn.
    operand : object, optional
        What the command works on beside its inputs.

    Returns
    -------
    Picture
        Curves over what varies, or else the picture of a single answer.

    Raises
    ------
    UsageError
        If there is nothing to draw.
    """
    names = varied(solved)
    if command in LISTS or not names:
        if command not in OF_ONE:
            problem = "a single answer has nothing to be drawn"
            raise UsageError(problem, mention(RANGE))
        return OF_ONE[command](solved, operand)
    return curves(solved, wanted)


def _spectrum(solved: Sequence[Solved], operand: None) -> Picture:
    from radcalc.plots.spectra import spectra

    given = solved[0].given
    eye = OBSERVERS[given["observer"].value if "observer" in given else "photopic"]
    limits = given["range"].value if "range" in given else WHOLE
    return spectra([one.given["spectrum"].value for one in solved], eye, limits)


def _photon(solved: Sequence[Solved], operand: None) -> Picture:
    from radcalc.plots.spectra import photon

    given = solved[0].given
    eye = OBSERVERS[given["observer"].value if "observer" in given else "photopic"]
    wave = given[next(iter(given))]
    (size,) = (v.amount for v in solved[0].answer.values if v.name == "wavelength")
    return photon([(wave.text, size * 1e9)], eye)


LISTS = ("spectrum",)  # of which several answers are one picture of their own
OF_ONE: dict[str, Callable[[Sequence[Solved], Any], Picture]] = {
    "spectrum": _spectrum,
    "photon": _photon,
}
