"""Pictures as figures of Matplotlib, and these as SVG or PNG; the only module that imports it."""

import io
import os
from collections.abc import Callable
from typing import Any

from radcalc.errors import ConditionError
from radcalc.plots.data import LINES, REFERENCE, Axis, Chart, Picture

FORMATS = (".svg", ".png")
INSTALL = "pip install 'radcalc[plot]'"
SIZE = 7.2, 4.5  # inches
DOTS = 160  # of PNG, an inch
GREY = "#6b7280"
COLORS = ("#0f766e", "#b45309", "#7c3aed", "#be123c", "#1d4ed8", "#4d7c0f")
SETTINGS = {
    "axes.edgecolor": GREY,
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.labelcolor": "#1f2937",
    "axes.spines.right": False,
    "axes.spines.top": False,
    "axes.titlelocation": "left",
    "axes.titlesize": 11,
    "figure.facecolor": "white",
    "font.family": "DejaVu Sans",  # which comes with Matplotlib
    "font.size": 10,
    "grid.color": "#e5e7eb",
    "grid.linewidth": 0.8,
    "legend.frameon": False,
    "lines.linewidth": 1.8,
    "lines.solid_capstyle": "round",
    "svg.hashsalt": "radcalc",  # with which the names in an SVG are the same every time
    "xtick.color": GREY,
    "xtick.labelcolor": "#374151",
    "ytick.color": GREY,
    "ytick.labelcolor": "#374151",
}


def figure(picture: Picture) -> Any:
    """A picture as a Matplotlib figure, which a notebook shows.

    Raises
    ------
    ConditionError
        If Matplotlib is not installed.
    """
    matplotlib = _matplotlib()
    from matplotlib.figure import Figure

    ways: dict[type, Callable[[Any, Any], None]] = {Chart: _chart}
    with matplotlib.rc_context({**matplotlib.rcParamsDefault, **SETTINGS}):
        made = Figure(figsize=SIZE, layout="constrained")
        ways[type(picture)](picture, made)
    return made


def data(picture: Picture, extension: str) -> bytes:
    """A picture as the bytes of an SVG or a PNG file; the same ones every time.

    Parameters
    ----------
    picture : Picture
    extension : {".svg", ".png"}
    """
    matplotlib = _matplotlib()
    out = io.BytesIO()
    metadata = {"Date": None} if extension == ".svg" else {"Software": None}
    made = figure(picture)
    with matplotlib.rc_context(SETTINGS):
        made.savefig(out, format=extension[1:], dpi=DOTS, metadata=metadata)
    return out.getvalue()


def require() -> None:
    """Refuse to go on where Matplotlib is not installed.

    Raises
    ------
    ConditionError
        If it is not.
    """
    _matplotlib()


def _matplotlib() -> Any:
    try:
        import matplotlib
    except ImportError:
        raise ConditionError("a figure takes Matplotlib, which is not installed", INSTALL) from None
    return matplotlib


# -- charts ----------------------------------------------------------------------------------------


def _chart(chart: Chart, made: Any) -> None:
    axes = made.subplots()
    colors = iter(COLORS * len(chart.series))
    for one in chart.series:
        if one.style == REFERENCE:
            axes.plot(one.x, one.y, color=GREY, linestyle=(0, (2, 2)), lw=1.3, label=one.label)
        elif one.style == LINES:
            axes.vlines(one.x, 0, one.y, color=next(colors), lw=2, label=one.label)
        else:
            axes.plot(one.x, one.y, color=next(colors), label=one.label)
    for label, place in chart.marks:
        axes.axvline(place, color=GREY, lw=1)
        axes.annotate(
            label, (place, 1), (4, -4), xycoords=("data", "axes fraction"),
            textcoords="offset points", va="top", color="#374151",
        )  # fmt: skip
    _axis(axes.xaxis, axes.set_xlim, axes.set_xscale, chart.x)
    _axis(axes.yaxis, axes.set_ylim, axes.set_yscale, chart.y)
    if not chart.y.is_log and chart.y.limits is None and axes.get_ylim()[0] > 0:
        axes.set_ylim(bottom=0)
    if chart.y.limits:
        axes.set_ylim(chart.y.limits[0], chart.y.limits[1] * 1.04)
    if any(one.label for one in chart.series):
        axes.legend()
    axes.set_title(chart.title)


def _axis(own: Any, set_ends: Any, set_scale: Any, axis: Axis) -> None:
    own.set_label_text(axis.title)
    if axis.is_log:
        set_scale("log")
    if axis.limits:
        set_ends(*axis.limits)


def extension_of(path: str) -> str:
    """The extension of a file, in lower case."""
    return os.path.splitext(path)[1].lower()
