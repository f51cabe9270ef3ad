"""Maps of directions as results of calculators."""

from typing import TYPE_CHECKING, Any, NamedTuple

from radcalc.answer import Answer

if TYPE_CHECKING:
    from radcalc.distributions.maps.pictures import Picture


class RenderedMap(NamedTuple):
    """A picture in full precision in the `unit`, its description, and its answer."""

    picture: "Picture"
    pixels: Any
    unit: str
    what: str
    answer: Answer
