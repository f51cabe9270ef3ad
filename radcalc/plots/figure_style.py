"""Sizes, colours, settings and titles of figures."""

import math
import re

from radcalc.plots import Axis

SIZE = 7.2, 4.5  # inches
AREA, LONGEST = 20.0, 8.0  # of a plan [square inches, inches]
FRAME = 1.5, 1.0  # room for its numbers and its scale [inches]
FLAT = 2.0  # ratio of the width to the height above which the scale is below the plan
DOTS = 160  # per inch, in PNG
SQUARE, HALF = (6.4, 6.4), (7.2, 4.9)
LONG = 5  # characters of a radius of a polar diagram
WEDGE, CIRCLE = (0.09, -0.05, 0.82, 1.2), (0.14, 0.15, 0.72, 0.72)  # of a polar diagram
SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
POWER, INDEX = re.compile(r"(?<=[A-Za-z])-?\d+"), re.compile(r"\b(\w)_(\w+)")
SHIFTS = (0.8, 0.9, 1.1, 1.2)  # chroma relative to the reference of TM-30
GREY, NO_LIGHT, FAINT = "#6b7280", "#374151", "#d1d5db"
ARROW = {"arrowstyle": "->", "color": NO_LIGHT, "lw": 1.2, "shrinkA": 0, "shrinkB": 0}
DASHES = ("-", (0, (4, 2)))  # of the planes of a polar diagram
LINESTYLES = ("-", (0, (5, 1.5)), (0, (5, 1.5, 1, 1.5)), (0, (1, 1.5)))  # of curves of one colour
MARKERS = "os^D"  # of points of one colour
DENSE = 50  # least number of points of a curve without markers
BESIDE = 8  # longest legend inside a chart
LABEL = 40  # most letters of a label in a legend
LETTERS, MARGINS, MOST_LINES = 11, 1.0, 3  # of a title: letters an inch; inches; lines
BAND = 0.25  # opacity
MARK, POINT = 6, 72  # size of a mark [points]; points per inch
REACHES = (5, 20, 35, 50)  # distances of a label from its mark [points]
AROUND = ((1, 1), (1, -1), (-1, 1), (-1, -1), (1, 0), (-1, 0), (0, 1), (0, -1))
ACROSS, UP = ("center", "left", "right"), ("center", "bottom", "top")  # for the sides 0, 1 and -1
OVER = "white"  # brighter than the scale
STRIP = 0.03  # of the height of a chart, for the colours of its axis
TICKS = 6  # of an axis with round ends
ANGLES = (1, 1.5, 3, 4.5, 6, 9, 10)  # steps of an axis in degrees, times a power of ten
COLORMAP = "viridis"
ROUND = 1.01  # of the radius of a disc: room for its rim
WHOLE = 0.9  # of the radius of a disc, within which its rim does not cut the contour numbers
COLORS = ("#0f766e", "#b45309", "#7c3aed", "#be123c", "#1d4ed8", "#4d7c0f")
FONT = "DejaVu Sans"  # included in Matplotlib
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
    "font.family": FONT,
    "font.size": 10,
    "grid.color": "#e5e7eb",
    "grid.linewidth": 0.8,
    "legend.framealpha": 0.8,
    "legend.edgecolor": "none",
    "lines.linewidth": 1.8,
    "lines.solid_capstyle": "round",
    "svg.hashsalt": "radcalc",  # makes the names in an SVG reproducible
    "xtick.color": GREY,
    "xtick.labelcolor": NO_LIGHT,
    "ytick.color": GREY,
    "ytick.labelcolor": NO_LIGHT,
}


def plan_size(ratio: float) -> tuple[float, float]:
    """Return the size of a figure [inches] for a plan of a ratio of width to height."""
    high = min(math.sqrt(AREA / ratio), LONGEST, LONGEST / ratio)
    across, down = FRAME if ratio <= FLAT else FRAME[::-1]
    return max(high * ratio + across, SIZE[1]), high + down


def axis_title(axis: Axis) -> str:
    """Return the title of an axis, with exponents above the line and indices below it."""
    unit = POWER.sub(lambda match: match[0].translate(SUPERSCRIPTS), axis.unit)
    return INDEX.sub(r"$\1_{\\mathrm{\2}}$", axis._replace(unit=unit).title)
