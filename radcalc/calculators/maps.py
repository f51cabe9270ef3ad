"""Maps of directions as results of calculators."""

from typing import TYPE_CHECKING, Any, NamedTuple

from radcalc.answer import Answer

if TYPE_CHECKING:
    from radcalc.distributions.maps.pictures import Picture


class RenderedMap(NamedTuple):
    """A rendered picture, its description, and the answer with results and remarks.

    `pixels` are those of the picture in full precision, in the `unit`.
    """

    picture: "Picture"
    pixels: Any
    unit: str
    what: str
    answer: Answer
