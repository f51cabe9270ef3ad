"""The picture of a result, for notebooks and files."""

import os
from functools import cached_property
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from radcalc.plots.data import Picture


class Drawing:
    """A picture for a notebook, as a Matplotlib figure, or in a file."""

    def __init__(self, picture: "Picture") -> None:
        self.picture = picture

    def __repr__(self) -> str:
        """Return the picture in characters, or a text if it is drawn in a file only."""
        from radcalc.plots.characters import draw, style_of
        from radcalc.plots.data import IN_A_FILE

        if kind := IN_A_FILE.get(type(self.picture)):
            return f"{kind}: .save('plot.png') writes it into a file"
        return draw(self.picture, style_of()).rstrip("\n")

    @cached_property
    def figure(self) -> Any:
        from radcalc.plots.figure import figure

        return figure(self.picture)

    def _repr_svg_(self) -> str:
        from radcalc.plots.figure import data

        return data(self.picture, ".svg").decode()

    def save(self, path: "str | os.PathLike[str]") -> None:
        """Write it into an SVG or PNG file, by the ending of the name.

        Raises
        ------
        radcalc.RadcalcError
            If the file has another ending, or cannot be written.
        """
        from radcalc.plots.figure import write

        if not isinstance(path, os.PathLike):
            from radcalc.api.reading import require_texts

            require_texts(path=path)
        write(os.fspath(path), self.picture)
