"""Output of shapes with matplotlib, which only this module, `plot` and the histograms import."""

# pyright: reportUnknownMemberType=false
# matplotlib leaves its keyword arguments untyped.

import re
from collections.abc import Generator, Mapping
from contextlib import contextmanager
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sim2reason.base.optional import optional
from sim2reason.errors import UnsupportedError
from sim2reason.figures.shapes import MAX_LETTER_LENGTH, Arc, Area, Drawing, Label, LineShape, Shape, Weight, width

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.patches import Patch

INCHES_PER_UNIT = 0.42  # inches per unit of a drawing
MARGIN_UNITS = 0.35  # units around everything
TOP_ZORDER = 10_000  # labels lie over all shapes
WIDTHS = {"hair": 0.6, "thin": 0.8, "edge": 1.1, "string": 1.4, "rod": 2.6, "dots": 1.7}  # points
FILLS = {
    "": "white",
    "block": "#dbe7f3",
    "wedge": "#f4ead6",
    "fixed": "#ececec",
    "disc": "#d9d9d9",
    "ink": "black",
    "table": "#fbfaf6",
    "ball": "#7f9fc0",
    "star": "#f6d98b",
    "field": "#eef4e6",
}
STRING = "#8a3324"
DOT_PATTERN = (0, (0.01, 2.6))  # of a rough face, in widths of the line
ITALIC: dict[str, Any] = {"style": "italic", "family": "DejaVu Serif"}
SYMBOL = re.compile(r"([^\W\d_]{1,2})( [(=].*)")  # a letter and a number: *P (2 kg)*, *F = 3 N*
FORMATS = ("svg", "png", "pdf")
# Bytes must not change from run to run, and labels must stay text.
SETTINGS = {
    "svg.hashsalt": "sim2reason",
    "svg.fonttype": "none",
    "font.family": "DejaVu Sans",
    "mathtext.fontset": "dejavuserif",
    "pdf.fonttype": 42,
}
METADATA: dict[str, dict[str, Any]] = {
    "svg": {"Date": None},
    "png": {"Software": None},
    "pdf": {"CreationDate": None, "Producer": None, "Creator": None},
}


def matplotlib() -> Any:  # noqa: ANN401 - a module
    """Return the matplotlib package; MissingExtraError, with the install command, if it is missing."""
    return optional("matplotlib", "figures")


@contextmanager
def settings(more: Mapping[str, object] | None = None) -> Generator[None, None, None]:
    """Apply the matplotlib settings of all figures in a context, regardless of the user's settings."""
    package = matplotlib()
    with package.rc_context():
        package.rcdefaults()
        package.rcParams.update({**SETTINGS, **(more or {})})
        yield


def draw(drawing: Drawing, path: Path, dpi: int = 150) -> None:
    """Write a drawing as SVG, PNG or PDF, by the ending of `path`.

    Raises:
        MissingExtraError: matplotlib is not installed.
        UnsupportedError: `path` ends otherwise.
    """
    check(path)
    with settings():
        save(_page(drawing), path, dpi)


def png(drawing: Drawing, dpi: int = 100) -> bytes:
    """Return a drawing as the bytes of a PNG; MissingExtraError if matplotlib is not installed."""
    with settings():
        return png_bytes(_page(drawing), dpi)


def _page(drawing: Drawing) -> "Figure":
    from matplotlib.figure import Figure  # noqa: PLC0415 - heavy, and an extra

    left, low, right, high = drawing.box()
    left, low, right, high = left - MARGIN_UNITS, low - MARGIN_UNITS, right + MARGIN_UNITS, high + MARGIN_UNITS
    figure = Figure(figsize=(INCHES_PER_UNIT * (right - left), INCHES_PER_UNIT * (high - low)))
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    axes.set_xlim(left, right)
    axes.set_ylim(low, high)
    axes.axis("off")
    for order, shape in enumerate(drawing.shapes):
        _shape(axes, shape, order)
    for label in drawing.labels:
        _label(axes, label)
    return figure


def check(path: Path) -> str:
    """Return the file format by the suffix of a path; UnsupportedError for an unsupported one."""
    ending = path.suffix.removeprefix(".").lower()
    if ending not in FORMATS:
        raise UnsupportedError(f"{path}: no such format for a figure; end the name in .svg, .png or .pdf")
    return ending


def save(figure: "Figure", path: Path, dpi: int) -> None:
    """Write a figure to a file, with identical bytes on every run."""
    ending = check(path)
    figure.savefig(path, format=ending, dpi=dpi, metadata=METADATA[ending], facecolor="white")


def png_bytes(figure: "Figure", dpi: int) -> bytes:
    """Return the PNG bytes of a figure, identical on every run."""
    buffer = BytesIO()
    figure.savefig(buffer, format="png", dpi=dpi, metadata=METADATA["png"], facecolor="white")
    return buffer.getvalue()


def _shape(axes: "Axes", shape: Shape, order: int) -> None:
    if isinstance(shape, LineShape) and not shape.arrow:
        across, up = [p.real for p in shape.points], [p.imag for p in shape.points]
        style: dict[str, Any] = {"linewidth": WIDTHS[shape.weight], "solid_capstyle": "round", "zorder": order}
        strokes: Any = DOT_PATTERN if shape.weight == "dots" else "--" if shape.dashed else "-"
        if shape.weight == "dots":
            style["dash_capstyle"] = "round"
        axes.plot(across, up, linestyle=strokes, color=_ink(shape.weight), **style)
    else:
        axes.add_patch(_patch(shape, order))


def _patch(shape: Shape, order: int) -> "Patch":
    """Return the matplotlib patch of a filled or curved shape."""
    from matplotlib import patches  # noqa: PLC0415 - the same
    from matplotlib.path import Path as Path2D  # noqa: PLC0415 - the same

    match shape:
        case LineShape(points, weight):
            vertices = [(p.real, p.imag) for p in points]
            look: dict[str, Any] = {"arrowstyle": "-|>", "mutation_scale": 9.0, "color": "black", "zorder": order}
            if len(points) > 2:  # a curved one: filled, its shaft would be too
                bent = Path2D(vertices)
                return patches.FancyArrowPatch(path=bent, linewidth=WIDTHS[weight], fill=False, **look)
            look |= {"shrinkA": 0.0, "shrinkB": 0.0}
            return patches.FancyArrowPatch(vertices[0], vertices[-1], linewidth=WIDTHS[weight], **look)
        case Area(points, fill, weight):
            corners = [(p.real, p.imag) for p in points]
            look = {"facecolor": FILLS[fill], "edgecolor": "black", "linewidth": WIDTHS[weight]}
            look["linestyle"] = "--" if shape.dashed else "-"
            return patches.Polygon(corners, closed=True, zorder=order, **look)
        case Arc(center, radius, start, stop, weight, fill):
            at, width = (center.real, center.imag), WIDTHS[weight]
            if shape.whole:
                look = {"facecolor": FILLS[fill], "edgecolor": "black", "linewidth": width}
                return patches.Circle(at, radius, zorder=order, **look)
            look = {"theta1": start, "theta2": stop, "color": _ink(weight), "linewidth": width}
            return patches.Arc(at, 2.0 * radius, 2.0 * radius, zorder=order, **look)


def _ink(weight: Weight) -> str:
    return STRING if weight == "string" else "black"


def _label(axes: "Axes", label: Label) -> None:
    style: dict[str, Any] = {
        "ha": "center",
        "va": "center",
        "zorder": TOP_ZORDER,
        "fontsize": label.size * INCHES_PER_UNIT * 72.0,
    }
    if label.crossed:
        style["bbox"] = {"facecolor": "white", "edgecolor": "none", "pad": 1.0}
    both, middle = SYMBOL.fullmatch(label.text), label.at
    if both is not None:  # the letter as in print, the number upright
        letter, rest = both[1], both[2].removeprefix(" ")
        left, right = label.box[0], label.box[2]
        split = left + width(f"{letter} ", label.size)
        axes.text(0.5 * (left + split) - 0.17 * label.size, middle.imag, letter, **style, **ITALIC)
        axes.text(0.5 * (split + right), middle.imag, rest, **style)
        return
    if len(label.text) <= MAX_LETTER_LENGTH and label.text.isalpha():
        style |= ITALIC
    axes.text(middle.real, middle.imag, label.text, **style)
