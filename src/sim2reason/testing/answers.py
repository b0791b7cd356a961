"""Comparison of the answers of two scenes: all possible queries, evaluated at the same moments."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from sim2reason.questions import SimulatedScene, Target
from sim2reason.questions.choices import is_clear_of_events
from sim2reason.scenes.dsl.units import Dimension, parse_unit
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.simulation.trace import Event, Trace
from sim2reason.testing.specimens import Specimen

ANSWER_RTOL = 1e-6  # relative to the largest value of the quantity
MOMENTS = (0.0, 0.19, 0.46, 0.73, 0.97)  # fractions of the common motion
SOON, LATE = 1e-6, 1.0 - 1e-4  # fractions of the common motion between which events are counted


@dataclass(frozen=True)
class Difference:
    """A question that two motions answer differently, with both answers."""

    asked: str
    expected: float
    found: float

    @property
    def text(self) -> str:
        """Return the query and both answers as text."""
        return f"{self.asked}: {self.found:.9g} in place of {self.expected:.9g}"


def unit_factor(dimension: Dimension) -> float:
    """Return 1, the expected ratio of two equal motions' answers, whatever the dimension."""
    del dimension
    return 1.0


def differences(
    specimen: Specimen,
    other: SimulatedScene,
    factor: Callable[[Dimension], float] = unit_factor,
    close: float = ANSWER_RTOL,
) -> Iterator[Difference]:
    """Yield the questions whose answers differ between two motions, beyond the expected `factor`.

    Only the common interval of both motions is compared.
    """
    stretch = factor(Dimension(time=1))
    end = min(specimen.end, min(other.trace.stable_until, float(other.trace.state.times[-1])) / stretch)
    times = [t for t in (part * end for part in MOMENTS) if t == 0.0 or is_clear_of_events(t, specimen.study.trace)]
    yield from _parted(_events(specimen.study.trace, end, 1.0), _events(other.trace, end, stretch), end, close)
    here = _values(list(specimen.targets), specimen.study.trace, times, 1.0)
    there = _values(list(specimen.targets), other.trace, times, stretch)
    scales: dict[str, float] = {}
    for target, values in here.items():
        scale = max((abs(value) for value in values if np.isfinite(value)), default=0.0)
        scales[target.quantity] = max(scales.get(target.quantity, QUANTITIES[target.quantity].least), scale)
    for target, values in here.items():
        times_as_large = factor(parse_unit(target.unit).dimension)
        for time, mine, its in zip(times, values, there[target], strict=True):
            its /= times_as_large  # noqa: PLW2901 - the same answer, in the units of the other motion
            if abs(mine - its) > close * scales[target.quantity] or np.isnan(mine) != np.isnan(its):
                yield Difference(f"{specimen.targets[target].phrase} at {time:.4g} s", mine, its)


def _values(targets: list[Target], trace: Trace, times: list[float], stretch: float) -> dict[Target, list[float]]:
    found: dict[Target, list[float]] = {target: [] for target in targets}
    for time in times:
        state = trace.sample(np.array([time * stretch]))
        for target in targets:
            found[target].append(target.value(state))
    return found


def _events(trace: Trace, end: float, stretch: float) -> list[Event]:
    """Return the events strictly inside the compared interval, in the first motion's time, without turning points.

    At both ends rounding errors may decide about an event, and for turning points everywhere.
    """
    events = [Event(event.time / stretch, event.kind, event.subjects) for event in trace.events]
    return [e for e in events if e.changes_motion and SOON * end < e.time < LATE * end]


def _parted(mine: list[Event], its: list[Event], end: float, close: float) -> Iterator[Difference]:
    """Yield the differences between the events of two motions: other times, or an event in only one of them."""
    order = sorted(mine, key=lambda event: (event.kind, event.subjects, event.time))
    other = sorted(its, key=lambda event: (event.kind, event.subjects, event.time))
    if [(e.kind, e.subjects) for e in order] != [(e.kind, e.subjects) for e in other]:
        yield Difference("the number of events (their kinds and subjects differ)", len(order), len(other))
        return
    for one, two in zip(order, other, strict=True):
        if abs(one.time - two.time) > close * end:
            yield Difference(f"the time of {one.kind} of {', '.join(one.subjects)}", one.time, two.time)
