"""Plots of training runs and of evaluations."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from sim2reason.figures.canvas import SETTINGS, check, matplotlib, save

__all__ = ["Bar", "Point", "bars", "curves", "over_steps", "scatter"]

# pyright: reportUnknownMemberType=false
# matplotlib leaves its keyword arguments untyped.


RUN_COLORS = "#1b5e9b", "#c2571a", "#2e7d4f", "#8a3d8f", "#7a5a12", "#555555"
DPI = 150
SMOOTHING = 0.9  # decay factor of the exponential average
Series = Mapping[str, Sequence[float | None]]
"""Of each run, a number for each step; None where there is none."""


def curves(path: Path, panels: Mapping[str, Series]) -> None:
    """Plot a panel for each quantity with a line per run: raw values in pale, averages in strong colour."""
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
                steps, plotted = [step for step, _ in points], [value for _, value in points]
                color = RUN_COLORS[number % len(RUN_COLORS)]
                axes.plot(steps, plotted, color=color, alpha=0.25, linewidth=0.8)
                axes.plot(steps, averaged(plotted), color=color, linewidth=1.4, label=name)
            axes.set_title(title, fontsize=8.5)
            axes.grid(color="#dddddd", linewidth=0.5)
        for axes in places[len(panels) :]:
            axes.set_visible(False)
        shown = [axes.get_legend_handles_labels() for axes in places]
        lines = {name: line for plotted, names in shown for line, name in zip(plotted, names, strict=True)}
        figure.legend(lines.values(), lines, loc="outside upper center", ncols=6, frameon=False, fontsize=7.5)
        figure.supxlabel("step", fontsize=8.5)
        save(figure, path, DPI)


def averaged(values: Sequence[float]) -> list[float]:
    """Return the exponential average of values, with bias correction at the start."""
    averages, total, weight = list[float](), 0.0, 0.0
    for value in values:
        total = SMOOTHING * total + (1.0 - SMOOTHING) * value
        weight = SMOOTHING * weight + 1.0 - SMOOTHING
        averages.append(total / weight)
    return averages


# pyright: reportUnknownMemberType=false
# matplotlib leaves its keyword arguments untyped.


SERIES_COLORS = "#1b5e9b", "#c2571a", "#2e7d4f", "#8a3d8f", "#7a5a12", "#555555", "#c01f4e", "#0f8b8d"
MAX_NAME_LENGTH = 24  # characters of a name on an axis


class Bar(NamedTuple):
    """A fraction from 0 to 1, with the ends of its uncertainty interval."""

    value: float
    low: float
    high: float


class Point(NamedTuple):
    """A named point of a plot, with an uncertainty interval in both coordinates."""

    name: str
    x: Bar
    y: Bar


def _shorten_name(name: str) -> str:
    return name if len(name) <= MAX_NAME_LENGTH else f"{name[: MAX_NAME_LENGTH - 1]}…"


def _errors(held: Sequence[Bar]) -> list[list[float]]:
    """Return the lower and upper lengths of the error bars, in per cent."""
    below = [100 * max(0.0, bar.value - bar.low) for bar in held]
    return [below, [100 * max(0.0, bar.high - bar.value) for bar in held]]


def bars(path: Path, title: str, groups: Sequence[str], bars_by_policy: Mapping[str, Sequence[Bar | None]]) -> None:
    """Plot a bar for each policy in each group, in per cent with its interval; None leaves a gap."""
    check(path)
    with matplotlib().rc_context({**SETTINGS, "font.size": 9.0}):
        from matplotlib.figure import Figure  # noqa: PLC0415 - heavy, and an extra

        wide = 0.8 / max(len(bars_by_policy), 1)
        figure = Figure(
            figsize=(max(5.0, 1.2 + 0.9 * len(groups) * max(1.0, 0.45 * len(bars_by_policy))), 3.8),
            layout="constrained",
        )
        axes = figure.subplots()
        for number, (name, row) in enumerate(bars_by_policy.items()):
            places = [index + wide * (number + 0.5) - 0.4 for index, bar in enumerate(row) if bar is not None]
            there = [bar for bar in row if bar is not None]
            color = SERIES_COLORS[number % len(SERIES_COLORS)]
            axes.bar(places, [100 * b.value for b in there], wide, color=color, label=_shorten_name(name))
            axes.errorbar(
                places, [100 * b.value for b in there], _errors(there), fmt="none", ecolor="black", capsize=2.5
            )
        axes.set_xticks(
            range(len(groups)), [_shorten_name(name) for name in groups], rotation=30 * (len(groups) > 4), ha="center"
        )
        axes.set_ylim(0.0, 100.0)
        axes.set_ylabel("accuracy (%)")
        axes.set_title(title)
        axes.grid(axis="y", color="#dddddd", linewidth=0.5)
        axes.set_axisbelow(True)
        figure.legend(loc="outside lower center", ncols=min(4, len(bars_by_policy)), frameon=False, fontsize=8)
        save(figure, path, DPI)


def over_steps(
    path: Path, steps: Sequence[int], accuracy: Mapping[str, Sequence[Bar]], length: Mapping[str, Sequence[float]]
) -> None:
    """Plot accuracy with its interval, and below it the response length, over training steps."""
    check(path)
    with matplotlib().rc_context({**SETTINGS, "font.size": 9.0}):
        from matplotlib.figure import Figure  # noqa: PLC0415 - the same

        figure = Figure(figsize=(6.0, 5.0), layout="constrained")
        upper, lower = figure.subplots(2, 1, sharex=True)
        for number, (name, row) in enumerate(accuracy.items()):
            color = SERIES_COLORS[number % len(SERIES_COLORS)]
            upper.plot(
                steps, [100 * bar.value for bar in row], "o-", color=color, label=_shorten_name(name), markersize=4
            )
            upper.fill_between(steps, [100 * b.low for b in row], [100 * b.high for b in row], color=color, alpha=0.15)
            lower.plot(steps, length[name], "o-", color=color, markersize=4)
        upper.set_ylabel("accuracy (%)")
        lower.set_ylabel("length (tokens)")
        lower.set_xlabel("steps of training")
        upper.legend(frameon=False, fontsize=8)
        for axes in (upper, lower):
            axes.grid(color="#dddddd", linewidth=0.5)
        save(figure, path, DPI)


def scatter(path: Path, points: Sequence[Point], across: str, up: str, title: str) -> None:
    """Plot a point for each model, with its intervals in both coordinates."""
    check(path)
    with matplotlib().rc_context({**SETTINGS, "font.size": 9.0}):
        from matplotlib.figure import Figure  # noqa: PLC0415 - the same

        figure = Figure(figsize=(5.2, 4.6), layout="constrained")
        axes = figure.subplots()
        for number, point in enumerate(points):
            at, color = (
                (100 * point.x.value, 100 * point.y.value),
                SERIES_COLORS[number % len(SERIES_COLORS)],
            )
            axes.errorbar(
                [at[0]], [at[1]], _errors([point.y]), _errors([point.x]), fmt="o", color=color, capsize=2, markersize=5
            )
            axes.annotate(_shorten_name(point.name), at, (5.0, 4.0), textcoords="offset points", fontsize=7.5)
        axes.set_xlabel(f"{across}, accuracy (%)")
        axes.set_ylabel(f"{up}, accuracy (%)")
        axes.set_title(title, fontsize=9)
        axes.grid(color="#dddddd", linewidth=0.5)
        axes.margins(0.15)
        save(figure, path, DPI)
