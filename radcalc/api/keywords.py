"""Types of keywords in signatures; None means not given.

An `Amount` is a text with its unit, such as "2 m", a `Quantity`, whose magnitude may be an array,
a list of these, or a column of pandas, Polars or xarray with its unit.  A `Number` may be bare.
"""

from collections.abc import Sequence
from datetime import date
from os import PathLike
from typing import Any, Literal, Protocol, TypeAlias

from numpy.typing import NDArray

from radcalc.api.arguments import Quantity

Array: TypeAlias = NDArray[Any]


class Column(Protocol):
    """A column of pandas, Polars or xarray."""

    @property
    def name(self) -> Any:
        """Its title."""

    def to_numpy(self) -> Any:
        """Its values alone."""


# A signature shows the names of these unions.
Amount: TypeAlias = str | Quantity | Sequence[str] | Sequence[Quantity] | Column | None
Unnamed: TypeAlias = str | Quantity | Sequence[str] | Sequence[Quantity]  # without a keyword
Number: TypeAlias = Amount | float | Sequence[float] | Array
Direction: TypeAlias = str | Quantity | Sequence[Quantity] | Sequence[float] | Array | None
Vector: TypeAlias = str | Sequence[float] | Array | None
Points: TypeAlias = str | Quantity | Sequence[float] | Sequence[Sequence[float]] | Array
Interval: TypeAlias = str | tuple[str, str] | tuple[Quantity, Quantity] | None
Numbers: TypeAlias = str | Sequence[float] | Array | None
Scalar: TypeAlias = str | Quantity | float
Pair: TypeAlias = str | Sequence[int] | None
Text: TypeAlias = str | None
Path: TypeAlias = str | PathLike[str]
Spectrum: TypeAlias = Path | Any  # a name, a file, arrays, a series or a data frame
Distribution: TypeAlias = Any  # a name, a file, an expression, or an object with its methods
Surroundings: TypeAlias = Path | Quantity | Array | Any
Diffuse: TypeAlias = Literal["patch", "disc", "sphere", "rectangle", "plane", "hemisphere"]
Shape: TypeAlias = Literal[
    "full",
    "hemisphere",
    "cone",
    "cap",
    "zone",
    "band",
    "sphere",
    "disc",
    "rectangle",
    "pyramid",
    "patch",
    "polygon",
    "triangle",
    "pixel",
]
Sky: TypeAlias = Literal["overcast", "uniform", "intermediate", "clear", "turbid"] | int | str
Projection: TypeAlias = Literal[
    "latlong",
    "mirror-ball",
    "angular",
    "fisheye",
    "equisolid",
    "orthographic",
    "stereographic",
    "perspective",
    "cylindrical",
]
Observer: TypeAlias = Literal[
    "photopic", "scotopic", "cie1964", "judd-vos", "cie2008-2", "cie2008-10"
]
Profile: TypeAlias = Literal["gaussian", "uniform"]
ElectricField: TypeAlias = Literal["peak", "rms"]
Readings: TypeAlias = Path | Quantity | Column | Sequence[str] | Sequence[float] | Array
Times: TypeAlias = (
    Quantity | Column | Sequence[str] | Sequence[date] | Sequence[float] | Array | None
)
Samples: TypeAlias = Literal["points", "means", "means-before", "means-centred"]
Invalid: TypeAlias = Literal["abort", "warn", "ignore"]
Period: TypeAlias = Literal["day", "hour"]
