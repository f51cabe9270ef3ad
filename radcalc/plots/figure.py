"""Pictures as Matplotlib figures, and as SVG or PNG; only this module imports Matplotlib."""

import io
import math
import os
import re
import sys
import warnings
from collections.abc import Callable, Sequence
from contextlib import suppress
from tempfile import TemporaryDirectory
from typing import Any

from radcalc.errors import ConditionError, printable
from radcalc.plots.data import (
    LINE,
    LINES,
    POINTS,
    REFERENCE,
    RIGHT,
    Axis,
    Chart,
    ColourDiagram,
    Disc,
    Field,
    Mark,
    Picture,
    Polar,
)
from radcalc.plots.ticks import levels, limits, rings, shades, texts

FORMATS = (".svg", ".png")
INSTALL = "pip install 'radcalc[plot]'"
SIZE = 7.2, 4.5  # inches
DOTS = 160  # per inch, in PNG
SQUARE, HALF = (6.4, 6.4), (7.2, 4.9)
WEDGE, CIRCLE = (0.09, -0.05, 0.82, 1.2), (0.14, 0.15, 0.72, 0.72)  # of a polar diagram
SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
POWER, INDEX = re.compile(r"(?<=[A-Za-z])-?\d+"), re.compile(r"\b(\w)_(\w+)")
GREY, NO_LIGHT, FAINT = "#6b7280", "#374151", "#d1d5db"
DASHES = ("-", (0, (4, 2)))  # of the planes of a polar diagram
STRIP = 0.03  # of the height of a chart, for the colours of its axis
TICKS = 6  # of an axis with round ends
COLORMAP = "viridis"
WHOLE = 0.9  # of the radius of a disc, within which its rim does not cut the contour numbers
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
    "font.family": "DejaVu Sans",  # included in Matplotlib
    "font.size": 10,
    "grid.color": "#e5e7eb",
    "grid.linewidth": 0.8,
    "legend.frameon": False,
    "lines.linewidth": 1.8,
    "lines.solid_capstyle": "round",
    "svg.hashsalt": "radcalc",  # makes the names in an SVG reproducible
    "xtick.color": GREY,
    "xtick.labelcolor": NO_LIGHT,
    "ytick.color": GREY,
    "ytick.labelcolor": NO_LIGHT,
}


def figure(picture: Picture) -> Any:
    """Return a Matplotlib figure; raise a ConditionError without Matplotlib."""
    matplotlib = _matplotlib()
    from matplotlib.figure import Figure

    drawers: dict[type, Callable[[Any, Any], None]] = {
        Chart: _chart,
        Polar: _polar,
        Field: _field,
        Disc: _disc,
        ColourDiagram: _colour_diagram,
    }
    with matplotlib.rc_context({**matplotlib.rcParamsDefault, **SETTINGS}):
        drawing = Figure(figsize=SIZE, layout="constrained")
        drawers[type(picture)](picture, drawing)
    return drawing


def data(picture: Picture, extension: str) -> bytes:
    """Return a picture as the bytes of an SVG or PNG file, which are reproducible."""
    matplotlib = _matplotlib()
    out = io.BytesIO()
    metadata = {"Date": None} if extension == ".svg" else {"Software": None}
    drawing = figure(picture)
    with matplotlib.rc_context(SETTINGS), warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # about letters missing in the font
        drawing.savefig(out, format=extension[1:], dpi=DOTS, metadata=metadata)
    return out.getvalue()


def check_place(path: str) -> str:
    """Return the extension of a file, after a check that a figure can be written to it.

    Raises
    ------
    ConditionError
        If the extension is not one of `FORMATS`, or Matplotlib is not installed.
    OutputError
        If the file cannot be written, as far as that is known in advance.
    """
    from radcalc.distributions import contents

    extension = contents.check_place(path, FORMATS, "a figure", ".svg or .png")
    _matplotlib()
    return extension


def write(path: str, picture: Picture) -> None:
    """Write a picture into a file accepted by `check_place`, completely or not at all."""
    from radcalc.distributions.contents import written

    drawn = data(picture, check_place(path))
    with written(path) as name, open(name, "wb") as file:
        file.write(drawn)


def load_apart() -> None:
    """Load Matplotlib without the settings and the list of fonts that it keeps in the home folder.

    It is for a process of radcalc alone, and does nothing if MPLCONFIGDIR names another folder.
    """
    if os.environ.get("MPLCONFIGDIR") or "matplotlib" in sys.modules:
        return
    with suppress(OSError, ImportError), TemporaryDirectory(prefix="radcalc-") as folder:
        os.environ |= {"MPLCONFIGDIR": folder, "MPL_IGNORE_SYSTEM_FONTS": "1"}
        import matplotlib.font_manager  # noqa: F401
    os.environ.pop("MPLCONFIGDIR", None)


def _matplotlib() -> Any:
    try:
        import matplotlib
    except ImportError:
        raise ConditionError(
            "figures need the package Matplotlib, which is missing", INSTALL
        ) from None
    return matplotlib


# -- charts ----------------------------------------------------------------------------------------


def _chart(chart: Chart, drawing: Any) -> None:
    axes = drawing.subplots()
    colors = iter(_colors(chart))
    drawn = []
    for series in chart.series:
        if series.style == REFERENCE:
            dashes: Any = (0, (2, 2))
            artist = axes.plot(series.x, series.y, color=GREY, linestyle=dashes, lw=1.3)[0]
        elif series.style == LINES:
            artist = axes.vlines(series.x, 0, series.y, color=next(colors), lw=2)
        else:
            look = {"marker": "o", "ls": "", "ms": 6} if series.style == POINTS else {}
            artist = axes.plot(series.x, series.y, color=next(colors), **look)[0]
        drawn.append(artist)
    for label, place in chart.marks:
        axes.axvline(place, color=GREY, lw=1)
        axes.annotate(
            _safe(label), (place, 1), (4, -4), xycoords=("data", "axes fraction"),
            textcoords="offset points", va="top", color=NO_LIGHT,
        )  # fmt: skip
    _axis(axes.xaxis, axes.set_xlim, axes.set_xscale, chart.x)
    _axis(axes.yaxis, axes.set_ylim, axes.set_yscale, chart.y)
    if not chart.y.is_log and chart.y.limits is None:
        axes.set_ylim(*limits([y for series in chart.series for y in series.y], TICKS))
    if chart.y.limits:
        axes.set_ylim(chart.y.limits[0], chart.y.limits[1] * 1.04)
    if chart.hues:
        _hues(chart, axes)
    if named := chart.named:
        entries = [drawn[k] for k in named], [_safe(chart.series[k].label) for k in named]
        axes.legend(*entries, title=chart.crowd or None)
    axes.set_title(_safe(chart.title), wrap=True)


def _colors(chart: Chart) -> Sequence[Any]:
    """Return a colour for each curve; many have ordered colours."""
    count = len(chart.curves)
    if not chart.crowd:
        return COLORS * count
    import matplotlib

    return [matplotlib.colormaps[COLORMAP](0.95 * k / (count - 1)) for k in range(count)]


def _hues(chart: Chart, axes: Any) -> None:
    """Draw colours below a single curve, else in a strip above the axis."""
    import numpy

    curves = chart.curves
    ends, heights = axes.get_xlim(), axes.get_ylim()
    places = numpy.array([hue.place for hue in chart.hues])
    if len(curves) == 1 and curves[0].style == LINE:
        x, y = curves[0].x, curves[0].y
        filled, shade, top = axes.fill_between(x, 0, y, lw=0, color="none"), 0.5, max(y)
        clipped = {"clip_path": (filled.get_paths()[0], axes.transData)}
    else:
        shade, top, clipped = 0.8, heights[1] * STRIP, {}
    half = (places[1] - places[0]) / 2
    axes.imshow(
        numpy.array([[hue[1:] for hue in chart.hues]]),
        extent=(places[0] - half, places[-1] + half, 0, top),
        aspect="auto",
        alpha=shade,
        interpolation="bilinear",
        zorder=1,
        **clipped,
    )
    axes.set_xlim(*ends)
    axes.set_ylim(*heights)


def _axis(mpl_axis: Any, set_ends: Any, set_scale: Any, axis: Axis) -> None:
    mpl_axis.set_label_text(_text(axis))
    if axis.is_log:
        set_scale("log")
    if axis.limits:
        set_ends(*axis.limits)


# -- polar diagrams --------------------------------------------------------------------------------


def _polar(polar: Polar, drawing: Any) -> None:
    """Draw the axis downwards, and only the lower half if the upper half is dark."""
    is_half, circles = polar.is_half, rings(polar.most)
    drawing.set_layout_engine("none")
    drawing.set_size_inches(*(HALF if is_half else SQUARE))
    axes = drawing.add_axes(WEDGE if is_half else CIRCLE, projection="polar")
    axes.set_theta_zero_location("S")
    for color, plane, dashes in zip(COLORS, polar.planes, DASHES, strict=False):
        turns = [math.radians(angle) for angle in plane.angles]
        axes.plot(turns, plane.values, color=color, linestyle=dashes, label=plane.label)
        axes.fill(turns, plane.values, color=color, alpha=0.08, lw=0)
    rays = range(-180, 180, 30)
    if is_half:
        axes.set_thetamin(-RIGHT)
        axes.set_thetamax(RIGHT)
        rays = range(-90, 91, 30)
    places = [math.radians(angle if is_half else angle % 360) for angle in rays]
    axes.set_xticks(places, [f"{abs(angle)}\u00b0" for angle in rays])
    axes.set_ylim(0.0, circles[-1])
    axes.set_yticks(circles, texts(circles))
    axes.set_rlabel_position(RIGHT if is_half else 75)
    axes.spines["polar"].set_color(FAINT)
    drawing.legend(title=_text(polar.radius), loc="lower center", ncols=2)
    drawing.suptitle(_safe(polar.title), fontsize=11, wrap=True)


# -- fields and discs ------------------------------------------------------------------------------


def _field(field: Field, drawing: Any) -> None:
    axes = drawing.subplots()
    axes.grid(visible=False)
    axes.set_aspect("equal")
    _filled(drawing, axes, field.xs, field.ys, field.rows, field.value)
    _marks(axes, field.marks)
    axes.set_xlabel(_text(field.x))
    axes.set_ylabel(_text(field.y))
    axes.set_title(_safe(field.title), wrap=True)


def _disc(disc: Disc, drawing: Any) -> None:
    import numpy
    from matplotlib.patches import Circle

    drawing.set_size_inches(*SQUARE)
    axes = drawing.subplots()
    axes.set_aspect("equal")
    axes.axis("off")
    places = numpy.linspace(-1.0, 1.0, len(disc.rows))
    x, y = numpy.meshgrid(places, places)
    rows = numpy.asarray(disc.rows, float)
    inside = rows[numpy.hypot(x, y) <= 1]
    if disc.is_image:
        from matplotlib.colors import LogNorm

        norm = LogNorm(*shades(inside.tolist()))
        drawn = axes.pcolormesh(places, places, rows, cmap=COLORMAP, norm=norm, rasterized=True)
        drawing.colorbar(drawn, ax=axes, shrink=0.8, label=_text(disc.value), extend="both")
    else:
        _filled(drawing, axes, places, places, rows, disc.value, numpy.hypot(x, y) < WHOLE)
    for drawn in axes.collections:
        drawn.set_clip_path(Circle((0, 0), 1, transform=axes.transData))
    axes.add_patch(Circle((0, 0), 1, fill=False, color=GREY))
    for label, angle in disc.rim:
        turn = math.radians(angle)
        axes.text(
            1.09 * math.sin(turn), 1.09 * math.cos(turn), label, color=NO_LIGHT,
            ha="center", va="center",
        )  # fmt: skip
    _marks(axes, disc.marks)
    axes.figure.suptitle(_safe(disc.title), fontsize=11, wrap=True)


def _colour_diagram(diagram: ColourDiagram, drawing: Any) -> None:
    from radcalc.spectra.rendition import draw_chromaticities, draw_vectors

    drawing.set_size_inches(*SQUARE)
    axes = drawing.subplots()
    if diagram.report:
        draw_vectors(diagram.report, axes)
    else:
        draw_chromaticities(axes)
        for series in diagram.series:
            dashes: Any = (0, (2, 2)) if series.style == REFERENCE else "-"
            label = _safe(series.label)
            axes.plot(series.x, series.y, color=NO_LIGHT, linestyle=dashes, lw=1.2, label=label)
        _marks(axes, diagram.marks)
        _axis(axes.xaxis, axes.set_xlim, axes.set_xscale, diagram.x)
        _axis(axes.yaxis, axes.set_ylim, axes.set_yscale, diagram.y)
        axes.legend(loc="upper right")
    axes.set_aspect("equal")
    axes.set_title(_safe(diagram.title), wrap=True)


def _filled(
    drawing: Any, axes: Any, xs: Any, ys: Any, rows: Any, value: Axis, inside: Any = None
) -> None:
    """Draw contours with numbers inside a region, and colours between them."""
    import matplotlib
    import numpy

    values = numpy.asarray(rows, float)
    contour_levels = levels(values.ravel().tolist())
    if not contour_levels:
        drawing.colorbar(
            axes.pcolormesh(xs, ys, values, cmap=COLORMAP), ax=axes, label=_text(value)
        )
        return
    bounds = [
        min(float(values.min()), contour_levels[0]),
        *contour_levels,
        max(float(values.max()), contour_levels[-1]),
    ]
    shades = matplotlib.colormaps[COLORMAP](numpy.linspace(0.05, 0.95, len(bounds) - 1))
    filled = axes.contourf(xs, ys, values, bounds, colors=shades)
    lines = axes.contour(xs, ys, values, contour_levels, colors="white", linewidths=0.9)
    names = texts(contour_levels)
    how: dict[str, Any] = {"fmt": dict(zip(contour_levels, names, strict=True)), "fontsize": 8.5}
    if inside is not None:
        within = axes.contour(xs, ys, numpy.where(inside, values, math.nan), contour_levels)
        how["manual"] = [number.get_position() for number in axes.clabel(within, **how)]
        within.remove()
    axes.clabel(lines, **how)
    bar = drawing.colorbar(filled, ax=axes, shrink=0.8, label=_text(value), spacing="uniform")
    bar.set_ticks(contour_levels, labels=names)


def _safe(text: str) -> str:
    """Escape a user's text, which Matplotlib would read as a formula."""
    return printable(text).replace("$", r"\$")


def _text(axis: Axis) -> str:
    unit = POWER.sub(lambda match: match[0].translate(SUPERSCRIPTS), axis.unit)
    return INDEX.sub(r"$\1_{\\mathrm{\2}}$", axis._replace(unit=unit).title)


def _marks(axes: Any, marks: Sequence[Mark]) -> None:
    from matplotlib.patheffects import withStroke

    for mark in marks:
        axes.plot(mark.x, mark.y, "o", color="white", mec=NO_LIGHT, ms=6)
        axes.annotate(
            _safe(mark.label),
            (mark.x, mark.y),
            (6, 5),
            textcoords="offset points",
            color=NO_LIGHT,
            fontsize=9,
            path_effects=[withStroke(linewidth=2.5, foreground="white")],
        )
