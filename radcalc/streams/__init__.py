"""Standard input, line by line, through a plan or a calculator."""

from collections.abc import Callable
from typing import TYPE_CHECKING

from radcalc.tuples import NamedTuple

if TYPE_CHECKING:
    from radcalc.inputs import Input
    from radcalc.units import Unit


class Source(NamedTuple):
    """An input whose values come from standard input: bare numbers of a unit, or texts with one.

    `read` reads a text like one on the command line; `check` refuses an impossible unit.
    """

    name: str
    unit: str
    is_bare: bool
    read: "Callable[[str], Input]"
    check: "Callable[[Unit], object]"
