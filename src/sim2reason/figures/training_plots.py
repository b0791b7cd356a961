"""Plots of training: what each step measured, and what came of it."""

# pyright: reportUnknownMemberType=false
# matplotlib leaves its keyword arguments untyped.

from collections.abc import Mapping, Sequence
from pathlib import Path

from sim2reason.figures.canvas import SETTINGS, check, matplotlib, save

__all__ = ["curves"]

COLORS = "#1b5e9b", "#c2571a", "#2e7d4f", "#8a3d8f", "#7a5a12", "#555555"
DPI = 150
SMOOTH = 0.9  # of an exponential average
Series = Mapping[str, Sequence[float | None]]
"""Of each run, a number for each step; None where there is none."""


def curves(path: Path, panels: Mapping[str, Series]) -> None:
    """A panel for each quantity with a line for each run over its steps: pale as measured, strong as averaged."""
    check(path)
    with matplotlib().rc_context({**SETTINGS, "font.size": 8.0}):
        from matplotlib.figure import Figure  # noqa: PLC0415 - heavy, and an extra

        columns = 2
        rows = -(-len(panels) // columns)
        figure = Figure(figsize=(8.0, 1.9 * rows + 0.6), layout="constrained")
        places = figure.subplots(rows, columns, sharex=True, squeeze=False).ravel()
        for axes, (title, series) in zip(places, panels.items(), strict=False):
            for number, (name, values) in enumerate(series.items()):
                points = [(step, value) for step, value in enumerate(values, start=1) if value is not None]
                steps, held = [step for step, _ in points], [value for _, value in points]
                color = COLORS[number % len(COLORS)]
                axes.plot(steps, held, color=color, alpha=0.25, linewidth=0.8)
                axes.plot(steps, averaged(held), color=color, linewidth=1.4, label=name)
            axes.set_title(title, fontsize=8.5)
            axes.grid(color="#dddddd", linewidth=0.5)
        for axes in places[len(panels) :]:
            axes.set_visible(False)
        shown = [axes.get_legend_handles_labels() for axes in places]
        lines = {name: line for held, names in shown for line, name in zip(held, names, strict=True)}
        figure.legend(lines.values(), lines, loc="outside upper center", ncols=6, frameon=False, fontsize=7.5)
        figure.supxlabel("step", fontsize=8.5)
        save(figure, path, DPI)


def averaged(values: Sequence[float]) -> list[float]:
    """Return an exponential average, without bias at the start."""
    found, total, weight = list[float](), 0.0, 0.0
    for value in values:
        total = SMOOTH * total + (1.0 - SMOOTH) * value
        weight = SMOOTH * weight + 1.0 - SMOOTH
        found.append(total / weight)
    return found
