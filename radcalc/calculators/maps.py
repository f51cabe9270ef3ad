"""Maps of directions that a calculator made."""

from typing import TYPE_CHECKING, Any, NamedTuple

from radcalc.answer import Answer

if TYPE_CHECKING:
    from radcalc.distributions.maps.pictures import Picture


class RenderedMap(NamedTuple):
    """A picture that was made, what it is in words, and what is to be said of its values.

    `pixels` are the picture's with all their digits, in the `unit`.
    """

    picture: "Picture"
    pixels: Any
    unit: str
    what: str
    answer: Answer
