"""What a file says of a luminaire: its distribution, and figures beside it."""

from typing import NamedTuple

from radcalc.distributions.distribution import Distribution


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
        What it declares, by the names of symbols [SI]: `lamp-flux` of all lamps (not where the
        photometry is absolute), `output-ratio`, `input-power`, `downward-fraction`.
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
