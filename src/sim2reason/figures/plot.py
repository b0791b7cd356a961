"""Plots of a motion, and histograms."""

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from sim2reason.figures.canvas import check, matplotlib, save, settings
from sim2reason.figures.curves import Mark, MotionCurves, Panel, Trajectories, motion_curves
from sim2reason.scenes.dsl.measures import show_unit
from sim2reason.simulation.trace import Trace
from sim2reason.text.prose.description import Description

if TYPE_CHECKING:
    from matplotlib.axes import Axes
from collections.abc import Mapping
from dataclasses import dataclass

from sim2reason.figures.canvas import png_bytes

# pyright: reportUnknownMemberType=false
# matplotlib leaves its keyword arguments untyped.


PLOT_WIDTH, PLOT_HEIGHT, PLANE, ROW = (
    8.0,
    1.75,
    3.4,
    0.19,
)  # inches: the figure, a panel, one of paths, a line of events
TOP, GAP, PLOT_LEFT, PLOT_RIGHT = (
    0.4,
    0.2,
    0.095,
    0.74,
)  # inches above and between panels; their sides as parts of the width
COLORS = ("#1b5e9b", "#c2571a", "#2e7d4f", "#8a3d8f", "#7a5a12", "#555555", "#c01f4e", "#0f8b8d")
STYLES = ("-", "--", "-.", ":")
SHADE = "#dddddd"
FLAT, MANY = (
    1e-6,
    7,
)  # a span, as a part of the values, that is too small to be looked at; more curves than one column of names holds
MAX_EVENTS = 12  # events in the list; the rest are counted
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
    """Plot all quantities with a panel over time, as SVG, PNG or PDF by the suffix of `path`.

    Raises:
        MissingExtraError: matplotlib is not installed.
        UnsupportedError: `path` ends otherwise.
    """
    check(path)
    matplotlib()  # says at once if it is missing
    shown = motion_curves(trace, description)
    second = show_unit(shown.units.time)
    with settings({"font.size": 8.0}):
        from matplotlib.figure import Figure  # noqa: PLC0415 - heavy, and an extra

        rows = event_lines(shown.marks, second)
        below = 0.55 + ROW * len(rows)
        height = TOP + PLANE * len(shown.trajectories) + PLOT_HEIGHT * len(shown.panels) + below
        figure, colors = Figure(figsize=(PLOT_WIDTH, height)), Colors()
        low = height - 0.15
        for group in shown.trajectories:
            low -= PLANE
            _paths(figure.add_axes(_area(low + 0.45, PLANE - 0.5, height)), group, shown, colors)
        low = below + PLOT_HEIGHT * len(shown.panels)
        for number, panel in enumerate(shown.panels):
            low -= PLOT_HEIGHT
            axes = figure.add_axes(_area(low, PLOT_HEIGHT - GAP, height))
            _panel(axes, panel, shown, colors)
            if number == 0:
                _numbers(axes, shown)
            if number < len(shown.panels) - 1:
                axes.tick_params(labelbottom=False)
            else:
                axes.set_xlabel(f"time ({second})")
        for row, line in enumerate(rows):
            figure.text(PLOT_LEFT, (0.1 + ROW * (len(rows) - row - 1)) / height, line, fontsize=8)
        save(figure, path, dpi)


def event_lines(marks: Sequence[Mark], second: str) -> list[str]:
    """Return the lines of the list of events with their times; the last line counts the omitted events."""
    lines = [f"{row}   {mark.time:.3f} {second}   {mark.text}" for row, mark in enumerate(marks[:MAX_EVENTS], start=1)]
    more = marks[MAX_EVENTS:]
    if more:
        lines.append(f"and {len(more)} more, until {more[-1].time:.3f} {second}")
    return lines


def _area(low: float, tall: float, height: float) -> tuple[float, float, float, float]:
    """Return a panel's rectangle as fractions of the figure, from bottom, height and figure height in inches."""
    return PLOT_LEFT, low / height, PLOT_RIGHT - PLOT_LEFT, tall / height


class Colors:
    """The colours of names: the same in all panels, explained in the legend of the first."""

    def __init__(self) -> None:
        """Start without assigned colours."""
        self._order: list[str] = []
        self._explained: set[str] = set()

    def of(self, name: str) -> str:
        """Return the colour of a body; a direction after its name is ignored."""
        own = name.partition(",")[0]
        if own not in self._order:
            self._order.append(own)
        return COLORS[self._order.index(own) % len(COLORS)]

    def unexplained(self, names: Iterable[str]) -> bool:
        """Return whether a legend is needed for some of these names; all of them then count as explained."""
        distinct = set(names)
        new = bool(distinct - self._explained)
        self._explained |= distinct
        return new

    def style(self, name: str) -> str:
        """Return the line style of a name, different from other names with the same colour."""
        self.of(name)
        return STYLES[(self._order.index(name.partition(",")[0]) // len(COLORS)) % len(STYLES)]


def _paths(axes: "Axes", group: Trajectories, shown: MotionCurves, colors: Colors) -> None:
    """Draw trajectories at equal scales, with a dot at each start and the numbers of events."""
    for member in group.members:
        color = colors.of(member.name)
        axes.plot(member.x, member.y, colors.style(member.name), color=color, linewidth=1.2, label=member.name)
        axes.plot(member.x[:1], member.y[:1], "o", color=color, markersize=4.0)
        taken: list[float] = []
        for number, mark in enumerate(shown.marks[:MAX_EVENTS], start=1):
            if any(subject == member.body or subject.startswith(f"{member.body}.") for subject in mark.bodies):
                at = (
                    float(np.interp(mark.time, shown.times, member.x)),
                    float(np.interp(mark.time, shown.times, member.y)),
                )
                axes.plot(at[0], at[1], "o", markersize=3.0, markerfacecolor="white", markeredgecolor=color)
                near = sum(abs(mark.time - time) < 0.02 * shown.duration for time in taken)
                taken.append(mark.time)
                offset = (4.0 + 8.0 * near, 3.0)
                axes.annotate(str(number), (at[0], at[1]), offset, textcoords="offset points", fontsize=7, color=color)
    axes.set_xlabel(group.across)
    axes.set_ylabel(group.up)
    axes.margins(0.08)
    axes.set_aspect("equal", adjustable="datalim")
    axes.grid(color="#dddddd", linewidth=0.4)
    if colors.unexplained(member.name for member in group.members):
        _legend(axes, len(group.members))


def _legend(axes: "Axes", count: int) -> None:
    """Draw the legend to the right of a panel."""
    axes.legend(
        loc="upper left",
        bbox_to_anchor=(1.01, 1.03),
        frameon=False,
        handlelength=1.6,
        fontsize=6.5 if count > MANY else 7.5,
        ncols=2 if count > MANY else 1,
        columnspacing=1.0,
    )


def _panel(axes: "Axes", panel: Panel, shown: MotionCurves, colors: Colors) -> None:
    for number, curve in enumerate(panel.curves):
        # Curves that coincide are drawn ever thinner, so that all can be seen.
        width = max(1.0, 3.0 - 0.5 * number)
        style, color = colors.style(curve.name), colors.of(curve.name)
        axes.plot(shown.times, curve.values, style, color=color, linewidth=width, label=curve.name)
    for mark in shown.marks:
        axes.axvline(mark.time, color="black", linewidth=0.6, linestyle=(0, (3, 3)), zorder=0.5)
    if shown.stable_until < shown.duration:
        axes.axvspan(
            shown.stable_until, shown.duration, facecolor=SHADE, edgecolor="#999999", hatch="//", linewidth=0.0
        )
    axes.set_xlim(0.0, shown.duration)
    axes.set_ylabel(panel.title.replace(" (", "\n("))
    axes.axhline(0.0, color="#888888", linewidth=0.5, zorder=0.4)
    axes.margins(y=0.1)
    _upright(axes, panel)
    axes.yaxis.set_label_coords(-0.075, 0.5)
    axes.ticklabel_format(axis="y", useOffset=False, scilimits=(-3, 4))
    if colors.unexplained(curve.name for curve in panel.curves):
        _legend(axes, len(panel.curves))


def _upright(axes: "Axes", panel: Panel) -> None:
    """Set the vertical range of a panel so that rounding errors of a constant are not magnified."""
    values = np.concatenate([[0.0], *(curve.values[np.isfinite(curve.values)] for curve in panel.curves)])
    size = float(np.abs(values).max()) or 1.0
    if all(np.ptp(finite) < FLAT * size for c in panel.curves if (finite := c.values[np.isfinite(c.values)]).size):
        axes.set_ylim(float(values.min()) - 0.2 * size, float(values.max()) + 0.2 * size)


def _numbers(axes: "Axes", shown: MotionCurves) -> None:
    """Draw the numbers of events above the first panel, and the reason why the end is cut off."""
    raised, last = 0, -1.0
    for number, mark in enumerate(shown.marks[:MAX_EVENTS], start=1):
        raised = (raised + 1) % 3 if mark.time - last < 0.02 * shown.duration else 0
        last = mark.time
        axes.annotate(
            str(number),
            (mark.time, 1.0),
            (0.0, 3.0 + 8.0 * raised),
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


# pyright: reportUnknownMemberType=false
# matplotlib leaves its keyword arguments untyped.


HISTOGRAM_WIDTH, HISTOGRAM_HEIGHT, BAR = 6.4, 3.0, 0.2  # inches: the figure, one with upright bars, a bar that lies
HISTOGRAM_LEFT, BELOW, ABOVE, HISTOGRAM_RIGHT = (
    0.6,
    0.45,
    0.3,
    0.1,
)  # inches around the axes; the names of the series stand above
LETTER_WIDTH = 0.062  # inches of a letter of a label, about
MAX_TICKS = 16  # labels below upright bars, at most


@dataclass(frozen=True)
class Histogram:
    """The counts for each label in named series; `lying` draws horizontal bars for long labels."""

    axis: str
    """What upright bars stand for; of those that lie, the labels say it."""
    labels: Sequence[str]
    series: Mapping[str, Sequence[int]]
    lying: bool = False


def png(histogram: Histogram, dpi: int = 100) -> bytes:
    """Return the PNG bytes of a histogram, identical on every run; MissingExtraError without matplotlib."""
    with settings({"font.size": 8.0}):
        from matplotlib.figure import Figure  # noqa: PLC0415 - heavy, and an extra

        lying, count = histogram.lying, len(histogram.labels)
        left = HISTOGRAM_LEFT + LETTER_WIDTH * max(map(len, histogram.labels), default=0) if lying else HISTOGRAM_LEFT
        tall = BELOW + ABOVE + BAR * (count + 1) if lying else HISTOGRAM_HEIGHT
        figure = Figure(figsize=(HISTOGRAM_WIDTH, tall))
        area = (
            left / HISTOGRAM_WIDTH,
            BELOW / tall,
            1.0 - (left + HISTOGRAM_RIGHT) / HISTOGRAM_WIDTH,
            1.0 - (BELOW + ABOVE) / tall,
        )
        axes = figure.add_axes(area)
        places, below = range(count), [0] * count
        for number, (name, values) in enumerate(histogram.series.items()):
            color = COLORS[number % len(COLORS)]
            if lying:
                axes.barh(places, values, left=below, color=color, label=name)
            else:
                axes.bar(places, values, bottom=below, color=color, label=name)
            below = [low + value for low, value in zip(below, values, strict=True)]
        shown = range(0, count, 1 if lying else -(-count // MAX_TICKS) or 1)
        ticks = [histogram.labels[index] for index in shown]
        if lying:
            axes.set_yticks(shown, ticks)
            axes.invert_yaxis()
            axes.set_xlabel("problems")
        else:
            axes.set_xticks(shown, ticks)
            axes.set(xlabel=histogram.axis, ylabel="problems")
        if len(histogram.series) > 1:
            names = len(histogram.series)
            axes.legend(frameon=False, ncols=names, loc="lower right", bbox_to_anchor=(1.0, 1.0), borderaxespad=0.2)
        axes.spines[["top", "right"]].set_visible(False)
        return png_bytes(figure, dpi)
