"""Plots of a motion: a panel for each quantity, a line for each body, events marked and the part cut off shaded."""

# pyright: reportUnknownMemberType=false
# matplotlib leaves its keyword arguments untyped.

from pathlib import Path
from typing import TYPE_CHECKING

from sim2reason.figures.canvas import SETTINGS, check, matplotlib, save
from sim2reason.figures.curves import MotionCurves, Panel, motion_curves
from sim2reason.prose.writer import Description
from sim2reason.simulation.trace import Trace

if TYPE_CHECKING:
    from matplotlib.axes import Axes

WIDE, TALL, ROW = 8.0, 1.75, 0.19  # inches: the figure, a panel, a line of the list of events
COLORS = ("#1b5e9b", "#c2571a", "#2e7d4f", "#8a3d8f", "#7a5a12", "#555555", "#c01f4e", "#0f8b8d")
STYLES = ("-", "--", "-.", ":")
SHADE = "#dddddd"
FLAT, MANY = 0.05, 7  # a span that is too small to be looked at; more curves than one column of names holds
MOST = 12  # events in the list; more are only marked
REASONS = {
    "certificate": "the two engines part",
    "statistics": "something jumps that no event explains",
    "reach": "something reaches a pulley or an edge",
    "limit": "something reaches the end of its way",
    "lift": "something leaves its face",
    "crowd": "impacts come too close together",
    "indeterminate": "nothing holds a part any more",
}


def plot(trace: Trace, description: Description, path: Path, dpi: int = 120) -> None:
    """Write all quantities that have a panel over time as SVG, PNG or PDF, by the ending of `path`.

    Raises:
        MissingExtraError: matplotlib is not installed.
        UnsupportedError: `path` ends otherwise.
    """
    check(path)
    package = matplotlib()
    shown = motion_curves(trace, description)
    with package.rc_context({**SETTINGS, "font.size": 8.0}):
        from matplotlib.figure import Figure  # noqa: PLC0415 - heavy, and an extra

        listed = shown.marks[:MOST]
        below = 0.55 + ROW * len(listed)
        height = 0.3 + TALL * len(shown.panels) + below
        figure = Figure(figsize=(WIDE, height))
        grid = figure.add_gridspec(
            len(shown.panels), 1, left=0.085, right=0.74, top=1.0 - 0.3 / height, bottom=below / height, hspace=0.16
        )
        for number, panel in enumerate(shown.panels):
            axes = figure.add_subplot(grid[number, 0])
            _panel(axes, panel, shown)
            if number == 0:
                _numbers(axes, shown)
            if number < len(shown.panels) - 1:
                axes.tick_params(labelbottom=False)
            else:
                axes.set_xlabel("time (s)")
        for row, mark in enumerate(listed):
            line = f"{row + 1}   {mark.time:.3f} s   {mark.text}"
            figure.text(0.085, (0.1 + ROW * (len(listed) - row - 1)) / height, line, fontsize=8)
        save(figure, path, dpi)


def _panel(axes: "Axes", panel: Panel, shown: MotionCurves) -> None:
    for number, curve in enumerate(panel.curves):
        style = STYLES[(number // len(COLORS)) % len(STYLES)] if len(panel.curves) > len(COLORS) else "-"
        # Curves that coincide are drawn ever thinner, so that all can be seen.
        width = max(1.0, 3.0 - 0.5 * number)
        axes.plot(
            shown.times, curve.values, style, color=COLORS[number % len(COLORS)], linewidth=width, label=curve.name
        )
    for mark in shown.marks:
        axes.axvline(mark.time, color="black", linewidth=0.6, linestyle=(0, (3, 3)), zorder=0.5)
    if shown.stable_until < shown.duration:
        axes.axvspan(
            shown.stable_until, shown.duration, facecolor=SHADE, edgecolor="#999999", hatch="//", linewidth=0.0
        )
    axes.set_xlim(0.0, shown.duration)
    axes.set_ylabel(panel.title)
    axes.axhline(0.0, color="#888888", linewidth=0.5, zorder=0.4)
    axes.margins(y=0.1)
    low, high = axes.get_ylim()
    if high - low < FLAT:  # rounding is no motion
        axes.set_ylim(low - 1.0, high + 1.0)
    axes.yaxis.set_label_coords(-0.09, 0.5)
    axes.ticklabel_format(axis="y", useOffset=False)
    many = len(panel.curves) > MANY
    axes.legend(
        loc="upper left",
        bbox_to_anchor=(1.01, 1.03),
        frameon=False,
        handlelength=1.6,
        fontsize=6.5 if many else 7.5,
        ncols=2 if many else 1,
        columnspacing=1.0,
    )


def _numbers(axes: "Axes", shown: MotionCurves) -> None:
    """The numbers of events above the first panel, and why the end is cut off."""
    raised, last = 0, -1.0
    for number, mark in enumerate(shown.marks[:MOST], start=1):
        raised = (raised + 1) % 3 if mark.time - last < 0.02 * shown.duration else 0
        last = mark.time
        axes.annotate(
            str(number),
            (mark.time, 1.0),
            (8.0 * raised, 3.0),
            xycoords=("data", "axes fraction"),
            textcoords="offset points",
            ha="center",
            fontsize=7.5,
        )
    if shown.stable_until < shown.duration:
        middle = 0.5 * (shown.stable_until + shown.duration)
        if shown.duration - shown.stable_until > 0.25 * shown.duration:
            why = f"cut off:\n{REASONS.get(shown.cut, shown.cut)}".replace(" a pulley", "\na pulley")
            box = {"facecolor": "white", "edgecolor": "none", "pad": 2.0}
            axes.text(
                middle, 0.5, why, transform=axes.get_xaxis_transform(), ha="center", va="center", fontsize=7, bbox=box
            )
