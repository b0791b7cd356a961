"""Histograms: how many there are of each sort, in bars that are stacked by another."""

# pyright: reportUnknownMemberType=false
# matplotlib leaves its keyword arguments untyped.

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from sim2reason.figures.canvas import as_png, settings
from sim2reason.figures.plot import COLORS

WIDE, TALL, BAR = 6.4, 3.0, 0.2  # inches: the figure, one with upright bars, a bar that lies
LEFT, BELOW, ABOVE, RIGHT = 0.6, 0.45, 0.3, 0.1  # inches around the axes; the names of the series stand above
LETTER = 0.062  # inches of a letter of a label, about
TICKS = 16  # labels below upright bars, at most


@dataclass(frozen=True)
class Histogram:
    """Numbers of things for each label, in series of one name; `lying` gives long labels room."""

    axis: str
    """What upright bars stand for; of those that lie, the labels say it."""
    labels: Sequence[str]
    series: Mapping[str, Sequence[int]]
    lying: bool = False


def png(histogram: Histogram, dpi: int = 100) -> bytes:
    """Return the bytes of a PNG, the same every time; MissingExtraError if matplotlib is not installed."""
    with settings({"font.size": 8.0}):
        from matplotlib.figure import Figure  # noqa: PLC0415 - heavy, and an extra

        lying, count = histogram.lying, len(histogram.labels)
        left = LEFT + LETTER * max(map(len, histogram.labels), default=0) if lying else LEFT
        tall = BELOW + ABOVE + BAR * (count + 1) if lying else TALL
        figure = Figure(figsize=(WIDE, tall))
        area = left / WIDE, BELOW / tall, 1.0 - (left + RIGHT) / WIDE, 1.0 - (BELOW + ABOVE) / tall
        axes = figure.add_axes(area)
        places, below = range(count), [0] * count
        for number, (name, values) in enumerate(histogram.series.items()):
            color = COLORS[number % len(COLORS)]
            if lying:
                axes.barh(places, values, left=below, color=color, label=name)
            else:
                axes.bar(places, values, bottom=below, color=color, label=name)
            below = [low + value for low, value in zip(below, values, strict=True)]
        shown = range(0, count, 1 if lying else -(-count // TICKS) or 1)
        ticks = [histogram.labels[place] for place in shown]
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
        return as_png(figure, dpi)
