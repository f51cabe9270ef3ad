"""Standard input, line by line, through a plan or a calculator."""

from collections.abc import Callable
from typing import TYPE_CHECKING

from radcalc.tuples import NamedTuple

if TYPE_CHECKING:
    from radcalc.inputs.given import Input
    from radcalc.units.unit import Unit


class Source(NamedTuple):
    """An input of which standard input has the values: bare numbers of a unit, or texts with one.

    `read` reads a text as that of a call of its own, and `check` refuses a unit that it cannot
    have; `is_bare` where the texts are numbers.
    """

    name: str
    unit: str
    is_bare: bool
    read: "Callable[[str], Input]"
    check: "Callable[[Unit], object]"
