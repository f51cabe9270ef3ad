"""What a file says of a luminaire: its distribution, and figures beside it."""

import math
from collections.abc import Iterator
from typing import NamedTuple

from radcalc.distributions.distribution import Distribution

ODD = 0.02  # [1] from which on a declared figure and the intensities' are said to differ


class Photometry(NamedTuple):
    """A distribution as a file has it.

    Attributes
    ----------
    distribution : Distribution
        Intensities as emitted: all factors of the file are applied.
    format : str
        What the file is, such as "IES LM-63-2002, type C".
    name : str
        What it says the luminaire is; may be empty, and has no control characters.
    declared : dict of str to float
        What it declares, by the names of symbols [SI]: `lamp-flux` of all lamps and
        `output-ratio`, or where the photometry is absolute `flux` of the luminaire;
        `input-power`, `downward-fraction`.
    size : float [m]
        The longest side or the diameter of what shines, where it says that; else 0.
    assumptions, notes : tuple of str
        What was assumed in reading it, and what is odd.

    Examples
    --------
    >>> from radcalc.distributions.shapes import Isotropic
    >>> Photometry(Isotropic(), "IES LM-63-2002, type C").declared
    {}
    """

    distribution: Distribution
    format: str
    name: str = ""
    declared: dict[str, float] = {}  # noqa: RUF012  nobody writes into it
    assumptions: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    size: float = 0.0

    def contradictions(self) -> Iterator[str]:
        """What it declares, where its intensities have more than 2 % less or more of it.

        Lamps may have more light than leaves the luminaire, and not less.

        Examples
        --------
        >>> from radcalc.distributions.shapes import Isotropic
        >>> [*Photometry(Isotropic(), "a file", declared={"lamp-flux": 10.0}).contradictions()]
        ['the file declares lamps of 10 lm, and its intensities have 12.57 lm, which is more']
        """
        declared, flux = self.declared, self.distribution.flux().value
        if not (declared and flux):
            return
        template = "the file declares {} of {} {unit}, and its intensities have {} {unit}"
        lamps = declared.get("lamp-flux", math.inf)
        if flux > lamps * (1 + ODD):
            yield template.format("lamps", *_rounded(lamps, flux), unit="lm") + ", which is more"
        downward = self.distribution.flux((0.0, math.pi / 2)).value
        for symbol, label, computed, unit in (
            ("flux", "a luminaire", flux, "lm"),
            ("output-ratio", "a light output ratio", 100 * flux / lamps, "%"),
            ("downward-fraction", "a downward part", 100 * downward / flux, "%"),
        ):
            stated = declared.get(symbol, 0.0) * (100 if unit == "%" else 1)
            if stated and abs(computed - stated) > ODD * stated:
                yield template.format(label, *_rounded(stated, computed), unit=unit)


def _rounded(*figures: float) -> Iterator[str]:
    """Numbers of four digits."""
    return (f"{float(f'{figure:.4g}'):g}" for figure in figures)
