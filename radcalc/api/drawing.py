"""A picture of a result, which a notebook shows."""

import os
from functools import cached_property
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from radcalc.plots.data import Picture


class Drawing:
    """A picture, as a notebook shows it, as a figure of Matplotlib, or in a file.

    Parameters
    ----------
    picture : radcalc.plots.data.Picture
        What is drawn.
    """

    def __init__(self, picture: "Picture") -> None:
        self.picture = picture

    def __repr__(self) -> str:
        """The picture in characters, as an interpreter shows it."""
        from radcalc.plots.characters import draw, style_of

        return draw(self.picture, style_of()).rstrip("\n")

    @cached_property
    def figure(self) -> Any:
        """The figure of Matplotlib, to be changed further."""
        from radcalc.plots.figure import figure

        return figure(self.picture)

    def _repr_svg_(self) -> str:
        """The picture in a notebook."""
        from radcalc.plots.figure import data

        return data(self.picture, ".svg").decode()

    def save(self, path: "str | os.PathLike[str]") -> None:
        """Write it into a file: SVG or PNG, by the end of the name.

        Raises
        ------
        radcalc.RadcalcError
            Of another file, or one that cannot be written.
        """
        from radcalc.plots.figure import write

        write(os.fspath(path), self.picture)
