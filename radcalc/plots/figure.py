"""Pictures as Matplotlib figures, and as SVG or PNG; only this module imports Matplotlib."""

import io
import math
import os
import sys
import warnings
from collections.abc import Callable, Sequence
from contextlib import chdir, suppress
from functools import cache
from importlib.util import find_spec
from itertools import product
from tempfile import TemporaryDirectory
from typing import Any

from radcalc import plots
from radcalc.errors import ConditionError, printable
from radcalc.plots import (
    GREY,
    LINE,
    LINES,
    NO_LIGHT,
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
    axis_title,
    levels,
    limits,
    nameless,
    rings,
    shades,
    span,
    texts,
)
from radcalc.terminal import cut, fold

FORMATS = (".svg", ".png")
INSTALL = "pip install 'radcalc[plot]'"


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
    with matplotlib.rc_context({**matplotlib.rcParamsDefault, **plots.SETTINGS}):
        drawing = Figure(figsize=plots.SIZE, layout="constrained")
        drawers[type(picture)](picture, drawing)
    return drawing


def data(picture: Picture, extension: str) -> bytes:
    """Return a picture as the bytes of an SVG or PNG file, which are reproducible."""
    matplotlib = _matplotlib()
    out = io.BytesIO()
    metadata = {"Date": None} if extension == ".svg" else {"Software": None}
    drawing = figure(picture)
    with matplotlib.rc_context(plots.SETTINGS), warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # about letters missing in the font
        drawing.savefig(out, format=extension[1:], dpi=plots.DOTS, metadata=metadata)
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
    """Load Matplotlib with its packaged settings and fonts alone.

    It reads a matplotlibrc of the current folder or the home folder otherwise, and keeps a list of
    the system's fonts there.  If MPLCONFIGDIR names a folder, that has the list of fonts.  This is
    for a process of radcalc alone.
    """
    found = find_spec("matplotlib")
    if not found or not found.origin or "matplotlib" in sys.modules:
        return
    settings = os.path.join(os.path.dirname(found.origin), "mpl-data", "matplotlibrc")
    kept = dict(os.environ)
    own = os.path.abspath(kept["MPLCONFIGDIR"]) if kept.get("MPLCONFIGDIR") else ""
    with suppress(OSError), TemporaryDirectory(prefix="radcalc-") as folder, chdir(folder):
        os.environ["MATPLOTLIBRC"] = settings
        os.environ["MPLCONFIGDIR"] = own or folder
        if not own:
            os.environ["MPL_IGNORE_SYSTEM_FONTS"] = "1"
        import matplotlib.font_manager

        matplotlib.get_configdir()  # it keeps what it returns first
    os.environ.clear()
    os.environ.update(kept)


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
    """Draw curves, marks and bands between axes."""
    axes = drawing.subplots()
    looks = iter(_looks(chart))
    drawn: list[Any] = []
    for series in chart.series:
        if series.style == REFERENCE:
            drawn += axes.plot(series.x, series.y, color=GREY, linestyle=(0, (2, 2)), lw=1.3)
            continue
        color, turn = next(looks)
        if series.style == LINES:
            drawn.append(axes.vlines(series.x, 0, series.y, color=color, lw=2))
        elif series.style == POINTS:
            look = {"marker": plots.MARKERS[turn], "ms": 6, "ls": ""}
            drawn += axes.plot(series.x, series.y, color=color, clip_on=False, zorder=3, **look)
        else:
            dots = {"marker": "o", "ms": 3} if len(series.x) < plots.DENSE else {}
            drawn += axes.plot(series.x, series.y, color=color, ls=plots.LINESTYLES[turn], **dots)
        if series.band and series.style == POINTS:
            axes.vlines(series.x, *series.band, color=color, lw=1.3)
        elif series.band:
            axes.fill_between(series.x, *series.band, color=color, alpha=plots.BAND, lw=0)
    for label, place in chart.marks:
        axes.axvline(place, color=GREY, lw=1)
        axes.annotate(
            _safe(label), (place, 1), (4, -4), xycoords=("data", "axes fraction"),
            textcoords="offset points", va="top", color=NO_LIGHT,
        )  # fmt: skip
    _axis(axes.xaxis, axes.set_xlim, axes.set_xscale, chart.x)
    _axis(axes.yaxis, axes.set_ylim, axes.set_yscale, chart.y)
    if not chart.y.is_log and chart.y.limits is None:
        axes.set_ylim(*limits([y for series in chart.series for y in series.heights], plots.TICKS))
    if chart.y.limits:
        axes.set_ylim(chart.y.limits[0], chart.y.limits[1] * 1.04)
    if chart.hues:
        _hues(chart, axes)
    _legend(chart, drawn, axes)
    axes.set_title(_folded(chart.title, axes.figure))
    _note(chart.note, axes)


def _legend(chart: Chart, drawn: Sequence[Any], axes: Any) -> None:
    """Name the curves: a few in the chart, more of them on its right."""
    named = chart.named
    handles = [drawn[k] for k in named]
    labels = [_safe(chart.series[k].label, plots.LABEL) for k in named]
    if chart.more:
        handles.append(axes.plot([], [], ls="")[0])
        labels.append(chart.more)
    if len(named) > plots.BESIDE:
        axes.figure.legend(handles, labels, loc="outside right upper", fontsize=8.5)
    elif named:
        axes.legend(handles, labels)


def _looks(chart: Chart) -> list[tuple[Any, int]]:
    """Return a colour and a line style for each curve; too many to name have ordered colours."""
    count = len(chart.curves)
    if not chart.is_crowd:
        return [(plots.COLORS[k % len(plots.COLORS)], k // len(plots.COLORS)) for k in range(count)]
    import matplotlib

    return [(matplotlib.colormaps[plots.COLORMAP](0.95 * k / (count - 1)), 0) for k in range(count)]


def _note(note: str, axes: Any) -> None:
    """Write the note of a picture below it."""
    if note:
        axes.figure.supxlabel(_folded(note, axes.figure), fontsize=8.5, color=NO_LIGHT)


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
        shade, top, clipped = 0.8, heights[1] * plots.STRIP, {}
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
    mpl_axis.set_label_text(axis_title(axis))
    if axis.is_log:
        set_scale("log")
    else:
        mpl_axis.set_major_formatter(_numbers())
    if axis.unit == "deg" and not axis.is_log:
        from matplotlib.ticker import MaxNLocator

        mpl_axis.set_major_locator(MaxNLocator(steps=plots.ANGLES))
    if axis.limits:
        set_ends(*axis.limits)


def _numbers() -> Any:
    """Return a formatter of the numbers of an axis that writes no common factor above it."""
    from matplotlib.ticker import ScalarFormatter

    class Numbers(ScalarFormatter):
        def format_ticks(self, values: Any) -> list[str]:
            return texts([float(value) for value in values])

    return Numbers()


# -- polar diagrams --------------------------------------------------------------------------------


def _polar(polar: Polar, drawing: Any) -> None:
    """Draw the axis downwards, and only the lower half if the upper half is dark."""
    is_half, circles = polar.is_half, rings(polar.most)
    drawing.set_layout_engine("none")
    drawing.set_size_inches(*(plots.HALF if is_half else plots.SQUARE))
    axes = drawing.add_axes(plots.WEDGE if is_half else plots.CIRCLE, projection="polar")
    axes.set_theta_zero_location("S")
    for color, plane, dashes in zip(plots.COLORS, polar.planes, plots.DASHES, strict=False):
        turns = [math.radians(angle) for angle in plane.angles]
        axes.plot(turns, plane.values, color=color, linestyle=dashes, label=plane.label)
        axes.fill(turns, plane.values, color=color, alpha=0.08, lw=0)
        if plane.band:
            axes.fill_between(turns, *plane.band, color=color, alpha=plots.BAND, lw=0)
    rays = range(-180, 180, 30)
    if is_half:
        axes.set_thetamin(-RIGHT)
        axes.set_thetamax(RIGHT)
        rays = range(-90, 91, 30)
    places = [math.radians(angle if is_half else angle % 360) for angle in rays]
    axes.set_xticks(places, [f"{abs(angle)}\u00b0" for angle in rays])
    axes.set_ylim(0.0, circles[-1])
    names = texts(circles)
    if max(map(len, names)) > plots.LONG:  # they would cover each other
        names = ["" if k % 2 else name for k, name in enumerate(reversed(names))][::-1]
    axes.set_yticks(circles, names)
    axes.set_rlabel_position(RIGHT if is_half else 75)
    axes.spines["polar"].set_color(plots.FAINT)
    above = 0.04 if polar.note else 0.0
    drawing.legend(
        title=axis_title(polar.radius), loc="lower center", ncols=2, bbox_to_anchor=(0.5, above)
    )
    drawing.suptitle(_folded(polar.title, drawing), fontsize=11)
    _note(polar.note, axes)


# -- fields and discs ------------------------------------------------------------------------------


def _field(field: Field, drawing: Any) -> None:
    ratio = (field.xs[-1] - field.xs[0]) / (field.ys[-1] - field.ys[0])
    drawing.set_size_inches(*plots.plan_size(ratio))
    axes = drawing.subplots()
    axes.grid(visible=False)
    axes.set_aspect("equal")
    _filled(drawing, axes, field.xs, field.ys, field.rows, field.value, is_flat=ratio > plots.FLAT)
    axes.set_xlabel(axis_title(field.x))
    axes.set_ylabel(axis_title(field.y))
    axes.set_title(_folded(field.title, drawing))
    _marks(axes, field.marks, field.note)


def _disc(disc: Disc, drawing: Any) -> None:
    """Draw a hemisphere of directions: an image is shaded, anything else has contours."""
    import numpy
    from matplotlib.patches import Circle

    drawing.set_size_inches(*plots.SQUARE)
    axes = drawing.subplots()
    axes.set_aspect("equal")
    axes.set(xlim=(-plots.ROUND, plots.ROUND), ylim=(-plots.ROUND, plots.ROUND))
    axes.axis("off")
    places = numpy.linspace(-1.0, 1.0, len(disc.rows))
    x, y = numpy.meshgrid(places, places)
    rows = numpy.asarray(disc.rows, float)
    inside = rows[numpy.hypot(x, y) <= 1]
    if disc.is_image and inside.min() < inside.max():
        _shaded(drawing, axes, places, rows, inside, disc.value)
    else:
        _filled(drawing, axes, places, places, rows, disc.value, numpy.hypot(x, y) < plots.WHOLE)
    for drawn in axes.collections:
        drawn.set_clip_path(Circle((0, 0), 1, transform=axes.transData))
    axes.add_patch(Circle((0, 0), 1, fill=False, color=GREY))
    for label, angle in disc.rim:
        turn = math.radians(angle)
        axes.text(
            1.09 * math.sin(turn), 1.09 * math.cos(turn), label, color=NO_LIGHT,
            ha="center", va="center",
        )  # fmt: skip
    axes.figure.suptitle(_folded(disc.title, drawing), fontsize=11)
    _marks(axes, disc.marks, "; ".join(disc.notes))


def _shaded(drawing: Any, axes: Any, places: Any, rows: Any, inside: Any, value: Axis) -> None:
    """Draw an image in colours; parts that are brighter than the scale are white."""
    import matplotlib
    from matplotlib.colors import LogNorm, Normalize

    scale = shades(inside.tolist())
    norm = (LogNorm if scale.is_log else Normalize)(scale.low, scale.high)
    ends = bool(inside.min() < scale.low), bool(inside.max() > scale.high)
    extend = {(True, True): "both", (True, False): "min", (False, True): "max"}.get(ends, "neither")
    colormap = matplotlib.colormaps[plots.COLORMAP]
    colormap = colormap.with_extremes(bad=colormap(0.0), over=plots.OVER)  # bad: the logarithm of 0
    drawn = axes.pcolormesh(places, places, rows, cmap=colormap, norm=norm, rasterized=True)
    label = f"{axis_title(value)}, {scale.kind}"
    drawing.colorbar(drawn, ax=axes, shrink=0.8, label=label, extend=extend)


def _colour_diagram(diagram: ColourDiagram, drawing: Any) -> None:
    """Draw curves and points over the colours of the plane."""
    drawing.set_size_inches(*plots.SQUARE)
    axes = drawing.subplots()
    axes.grid(visible=False)
    if diagram.arrows:
        _vectors(diagram, axes)
    else:
        from radcalc.spectra.colorimetry import draw_chromaticities

        draw_chromaticities(axes)
    for series in diagram.series:
        dashes: Any = (0, (2, 2)) if series.style == REFERENCE else "-"
        label = _safe(series.label)
        axes.plot(series.x, series.y, color=NO_LIGHT, linestyle=dashes, lw=1.4, label=label)
    _axis(axes.xaxis, axes.set_xlim, axes.set_xscale, diagram.x)
    _axis(axes.yaxis, axes.set_ylim, axes.set_yscale, diagram.y)
    axes.legend(loc="upper right")
    axes.set_aspect("equal")
    axes.set_title(_folded(diagram.title, drawing))
    _marks(axes, [] if diagram.arrows else diagram.marks, diagram.note)


def _vectors(diagram: ColourDiagram, axes: Any) -> None:
    """Draw arrows over the colours of the hues, and the names of the hue bins."""
    from matplotlib.image import imread
    from matplotlib.patches import Circle

    from radcalc.spectra.colorimetry import vector_background

    (left, right), (low, high) = diagram.limits
    axes.imshow(imread(vector_background()), extent=(left, right, low, high))
    for radius in plots.SHIFTS:
        axes.add_patch(Circle((0, 0), radius, fill=False, color="white", lw=0.8))
        axes.text(0, -radius, f"{radius - 1:+.0%}", color=NO_LIGHT, fontsize=7, ha="center")
    for start, end in diagram.arrows:
        axes.annotate("", end, start, arrowprops=plots.ARROW)
    for mark in diagram.marks:
        axes.text(mark.x, mark.y, _safe(mark.label), color=NO_LIGHT, ha="center", va="center")


def _filled(
    drawing: Any,
    axes: Any,
    xs: Any,
    ys: Any,
    rows: Any,
    value: Axis,
    inside: Any = None,
    is_flat: bool = False,
) -> None:
    """Draw contours with numbers inside a region, and colours between them."""
    import matplotlib
    import numpy
    from matplotlib.patheffects import withStroke

    values = numpy.asarray(rows, float)
    contour_levels = levels(values.ravel().tolist())
    if not contour_levels:
        axes.pcolormesh(xs, ys, values, cmap=plots.COLORMAP)
        even = values if inside is None else values[inside]
        axes.annotate(
            f"{axis_title(value)}, {span(even.ravel().tolist())}",
            (0.5, 0.5),
            xycoords="axes fraction",
            ha="center",
            color="white",
        )
        return
    bounds = [
        min(float(values.min()), contour_levels[0]),
        *contour_levels,
        max(float(values.max()), contour_levels[-1]),
    ]
    shades = matplotlib.colormaps[plots.COLORMAP](numpy.linspace(0.05, 0.95, len(bounds) - 1))
    filled = axes.contourf(xs, ys, values, bounds, colors=shades)
    lines = axes.contour(xs, ys, values, contour_levels, colors="white", linewidths=0.9)
    names = texts(contour_levels)
    how: dict[str, Any] = {"fmt": dict(zip(contour_levels, names, strict=True)), "fontsize": 8.5}
    if inside is not None:
        within = axes.contour(xs, ys, numpy.where(inside, values, math.nan), contour_levels)
        how["manual"] = [number.get_position() for number in axes.clabel(within, **how)]
        within.remove()
    for number in axes.clabel(lines, **how):
        number.set_path_effects([withStroke(linewidth=1.5, foreground=NO_LIGHT)])
    place = {"orientation": "horizontal", "aspect": 40} if is_flat else {"shrink": 0.8}
    bar = drawing.colorbar(filled, ax=axes, label=axis_title(value), spacing="uniform", **place)
    bar.set_ticks(contour_levels, labels=names)


def _safe(text: str, width: int = sys.maxsize) -> str:
    """Cut a user's text; escape letters that the font lacks, and formulas of Matplotlib."""
    return cut(_shown(text), width).replace("$", r"\$")


def _folded(text: str, drawing: Any) -> str:
    """Fold a text to the width of the figure, and cut it if it has too many lines."""
    width = int(plots.LETTERS * (drawing.get_figwidth() - plots.MARGINS))
    lines = [cut(line, width) for line in fold(_shown(text), width)]
    if len(lines) > plots.MOST_LINES:
        *first, last = lines[: plots.MOST_LINES]
        lines = [*first, f"{cut(last, width - 4)} ..."]
    return "\n".join(lines).replace("$", r"\$")


def _shown(text: str) -> str:
    known = _letters()
    return "".join([c if ord(c) in known else ascii(c)[1:-1] for c in printable(text)])


@cache
def _letters() -> frozenset[int]:
    from matplotlib.font_manager import findfont, get_font

    return frozenset(get_font(findfont(plots.FONT)).get_charmap())


def _marks(axes: Any, marks: Sequence[Mark], note: str) -> None:
    """Draw marks with their labels, and write the note below them: the last step of a picture.

    A label covers neither a mark nor another text; the note names the marks without room for one.
    """
    from matplotlib.transforms import Bbox

    for mark in marks:
        look = {"color": "white", "mec": NO_LIGHT, "ms": plots.MARK}
        axes.plot(mark.x, mark.y, "o", clip_on=False, **look)
    _note(note, axes)
    if not marks:
        return
    axes.figure.draw_without_rendering()  # the layout moves the axes
    points = [axes.transData.transform((mark.x, mark.y)) for mark in marks]
    half = plots.MARK * axes.figure.dpi / plots.POINT / 2
    taken = [Bbox([point - half, point + half]) for point in points]
    others = [*axes.texts, *filter(None, [axes.get_legend()])]
    taken += [other.get_window_extent() for other in others]
    unnamed = [mark.label for mark in marks if not _is_named(axes, mark, taken)]
    if unnamed:
        _note("\n".join(filter(None, [nameless(unnamed), note])), axes)


def _is_named(axes: Any, mark: Mark, taken: list[Any]) -> bool:
    """Write the label of a mark where it covers nothing; return whether there is room for it.

    A distant label has a line to its mark.
    """
    from matplotlib.patheffects import withStroke
    from matplotlib.text import Text

    halo = [withStroke(linewidth=2.5, foreground="white")]
    for reach, (across, up) in product(plots.REACHES, plots.AROUND):
        has_leader = reach > plots.REACHES[0]
        leader = {"arrowstyle": "-", "color": NO_LIGHT, "lw": 0.7} if has_leader else None
        label = axes.annotate(
            _safe(mark.label), (mark.x, mark.y), (reach * across, reach * up),
            textcoords="offset points", ha=plots.ACROSS[across], va=plots.UP[up], color=NO_LIGHT,
            fontsize=9, path_effects=halo, arrowprops=leader,
        )  # fmt: skip
        label.get_window_extent()  # moves it to its place; with the line to its mark
        box = Text.get_window_extent(label)
        corners = (box.x0, box.y0), (box.x1, box.y1)
        if all(axes.bbox.contains(*at) for at in corners) and not box.count_overlaps(taken):
            taken.append(box)
            return True
        label.remove()
    return False
