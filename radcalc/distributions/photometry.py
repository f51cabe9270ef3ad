"""The contents of a photometric file: its distribution and its declared values."""

import math
from collections.abc import Iterator
from typing import NamedTuple

from radcalc.distributions.distribution import Distribution

ODD = 0.02  # [1] a larger difference between declared and computed figures is reported


class Photometry(NamedTuple):
    """A distribution as read from a file.

    Attributes
    ----------
    declared : dict of str to float
        Declared values [SI], by symbol: `lamp-flux` of all lamps and `output-ratio`, or the
        luminaire's `flux` for absolute photometry; `input-power`, `downward-fraction`.
    size : float [m]
        Longest side or diameter of the luminous area, if declared; else 0.
    assumptions, notes : tuple of str
        Assumptions of the reader, and oddities.
    """

    distribution: Distribution
    format: str
    name: str = ""
    declared: dict[str, float] = {}  # noqa: RUF012  it is never modified
    assumptions: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    size: float = 0.0

    def contradictions(self) -> Iterator[str]:
        """Yield the declared values that differ from those of the intensities by more than 2 %.

        Lamps may have more flux than the luminaire, but not less.
        """
        declared, flux = self.declared, self.distribution.flux().value
        if not (declared and flux):
            return
        template = "the file declares {} of {} {unit}, but its intensities give {} {unit}"
        lamps = declared.get("lamp-flux", math.inf)
        if flux > lamps * (1 + ODD):
            yield template.format("lamps", *_rounded(lamps, flux), unit="lm") + ", which is more"
        downward = self.distribution.flux((0.0, math.pi / 2)).value
        for symbol, label, computed, unit in (
            ("flux", "a luminaire", flux, "lm"),
            ("output-ratio", "a light output ratio", 100 * flux / lamps, "%"),
            ("downward-fraction", "a downward fraction", 100 * downward / flux, "%"),
        ):
            stated = declared.get(symbol, 0.0) * (100 if unit == "%" else 1)
            if stated and abs(computed - stated) > ODD * stated:
                yield template.format(label, *_rounded(stated, computed), unit=unit)


def _rounded(*figures: float) -> Iterator[str]:
    """Yield numbers with four significant digits."""
    return (f"{float(f'{figure:.4g}'):g}" for figure in figures)
