"""Base classes of aggregates over an interval of the motion: extremes, integrals and numbers of events."""

from abc import abstractmethod
from collections.abc import Callable, Iterable, Sequence
from math import inf
from typing import ClassVar

import numpy as np
from numpy.polynomial.legendre import leggauss
from numpy.typing import NDArray

from sim2reason.questions.functionals import Functional
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.bounces import Bounced
from sim2reason.questions.moments.contacts import Collided
from sim2reason.questions.moments.times import WholeMotion
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words, ordinal_word
from sim2reason.scenes.dsl.mechanism import Inextensible, Mechanism, Prop, Rigid
from sim2reason.scenes.dsl.state import Array, State, row_lengths
from sim2reason.simulation.quantities import QUANTITIES, Quantity
from sim2reason.simulation.quantities.energy import KineticEnergy
from sim2reason.simulation.quantities.subjects import Sense
from sim2reason.simulation.trace import IMPACTS, Channel, Event, Trace, sorted_unique

ROUNDS, PIECES = 3, 64  # refinements of a maximum between neighbouring samples, and pieces per refinement
PLATEAU_RTOL = 1e-9  # of the value: values that differ by less form a plateau, which has no maximum
EVENT_SIDE_RTOL = 1e-9  # of the interval: nearer samples are the two sides of an event, of which the later one counts
END_MARGIN = 0.01  # of the value: least excess over the values at both ends of the interval


PLACELESS = frozenset(
    f"{size} {name}"
    for size in ("greatest", "least")
    for name in (
        "speed",
        "kinetic energy",
        "acceleration",
        "extension",
        "compression",
        "spring energy",
        "tension",
        "spring force",
    )
)
"""Functionals of what repeats itself where a motion drifts on, as two bodies on a spring do."""


class Extreme(Functional):
    """The base class of greatest and least values of a function of the state; answers are positive.

    There is no answer if the function is greatest at an end of the interval, at an event, or on a plateau: only a
    smooth maximum within the interval counts, so that no answer depends on the side of a jump or is stated in the text.
    A force or an acceleration has no greatest value in an interval with an impact.

    Class data:
        quantity: the quantity to maximize or minimize, by magnitude if it is a vector or has a sign.
        sense: the direction in which the component of a vector is taken; None for its magnitude.
        sign: 1 for the greatest value, −1 for the least.
        impulsive: whether an impact makes the quantity infinite.
    """

    kind = "extremum"
    quantity: ClassVar[type[Quantity]]
    sense: ClassVar[Sense | None] = None
    sign: ClassVar[float] = 1.0
    impulsive: ClassVar[bool] = False

    def __init_subclass__(cls) -> None:
        """Copy the unit, the type of subject and other class data from the quantity to the class."""
        if not hasattr(cls, "quantity"):
            return
        quantity = cls.quantity
        cls.unit, cls.of, cls.least, cls.needs = quantity.unit, quantity.of, quantity.least, quantity.needs
        cls.center = quantity.center

    def height(self, state: State, name: str) -> Array:
        """Return the function to be maximized, (n,): by default the quantity's magnitude, negated for a least value."""
        values = self.quantity.evaluate(state, name)
        if self.sense is not None:
            return self.sign * (values @ np.array(self.sense.vector))
        return self.sign * (np.abs(values) if values.ndim == 1 else row_lengths(values))

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """Return the channel of the quantity."""
        del mechanism
        return (Channel(name, self.quantity.name),)

    def present(self, words: Words, name: str) -> bool:
        """Return whether the subject has the quantity."""
        return QUANTITIES[self.quantity.name].present(words.mechanism, name)

    def when(self, moment: Moment, words: Words, name: str) -> tuple[str, ...]:
        """Return phrases for the interval; if the motion repeats elsewhere, none for a place-dependent quantity."""
        if not isinstance(moment, WholeMotion):
            return super().when(moment, words, name)
        return moment.phrases(words) if not moment.drifts or self.name in PLACELESS else ()

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """Return the greatest value in the quantity's unit, if it is a maximum inside the interval; else None."""
        if self._unbounded(trace, end):
            return None
        times, heights = self._sampled(trace, name, end)
        if not np.isfinite(heights).all():
            return None
        highest = float(heights.max())
        distinct = np.append(np.diff(times) > EVENT_SIDE_RTOL * end, True)
        times, heights = times[distinct], heights[distinct]
        if len(times) < 3:
            return None
        tops, reach = _tops(heights)
        ends = max(heights[0], heights[-1])
        if not len(tops) or ends > reach - END_MARGIN * abs(reach):
            return None
        at, top = self._highest(trace, name, times, tops)
        size = abs(top)
        jumps = any(event.changes_motion and times[at - 1] <= event.time <= times[at + 1] for event in trace.events)
        flat = max(heights[at - 1], heights[at + 1]) > top - PLATEAU_RTOL * size
        beyond = highest > top + PLATEAU_RTOL * size
        value = self.sign * top
        return value if value > 0.0 and not (jumps or flat or beyond or ends > top - END_MARGIN * size) else None

    def loose_value(self, trace: Trace, name: str, end: float) -> float | None:
        """Return the greatest value anywhere in the interval, its ends included."""
        return None if self._unbounded(trace, end) else self.extreme_between(trace, name, 0.0, end)

    def extreme_between(self, trace: Trace, name: str, began: float, end: float) -> float | None:
        """Return the greatest value between two times, s, ends included; None if it is not always defined."""
        times, heights = self._sampled(trace, name, end)
        within = times >= began
        times, heights = times[within], heights[within]
        if not np.isfinite(heights).all():
            return None
        distinct = np.append(np.diff(times) > EVENT_SIDE_RTOL * end, True)
        tops, _ = _tops(heights[distinct])
        top = self._highest(trace, name, times[distinct], tops)[1] if len(tops) else -inf
        return self.sign * max(float(heights.max()), top)

    def _unbounded(self, trace: Trace, end: float) -> bool:
        """Return whether an impact before a time, s, makes the quantity infinite."""
        return self.impulsive and any(event.kind in IMPACTS and event.time <= end for event in trace.events)

    def _sampled(self, trace: Trace, name: str, end: float) -> tuple[Array, Array]:
        """Return the sampled times before `end`, s, and `end` itself, with the values of the function there."""
        scan = trace.scan
        within = scan.times < end
        last = self.height(trace.at(end), name)
        return np.append(scan.times[within], end), np.append(self.height(scan, name)[within], last)

    def _highest(self, trace: Trace, name: str, times: Array, tops: NDArray[np.intp]) -> tuple[int, float]:
        """Return the index of the sample nearest to the highest maximum, and the value of that maximum."""
        low, high = times[tops - 1], times[tops + 1]
        shares = np.linspace(0.0, 1.0, PIECES + 1)
        best = np.zeros(len(tops))
        for _ in range(ROUNDS):
            grid = low[:, None] + (high - low)[:, None] * shares
            heights = self.height(trace.sample(grid.ravel()), name).reshape(grid.shape)
            number = np.clip(heights.argmax(axis=1), 1, PIECES - 1)
            rows = np.arange(len(tops))
            best, low, high = heights.max(axis=1), grid[rows, number - 1], grid[rows, number + 1]
        first = int(best.argmax())
        return int(tops[first]), float(best[first])


def _tops(heights: Array) -> tuple[NDArray[np.intp], float]:
    """Return the indices of samples that may be next to the highest maximum, and an estimate of this maximum.

    Maxima are estimated by parabolas through three samples; two equal samples around a maximum may both be returned.
    """
    before, here, after = heights[:-2], heights[1:-1], heights[2:]
    size = PLATEAU_RTOL * np.abs(here)
    peaks = np.flatnonzero((here >= before) & (here >= after) & ((here > before + size) | (here > after + size)))
    if not len(peaks):
        return peaks, 0.0
    slope, bend = (after - before)[peaks] / 2.0, (2.0 * here - before - after)[peaks]
    reach = here[peaks] + slope**2 / (2.0 * bend)
    highest = float(reach.max())
    return peaks[reach >= highest - END_MARGIN * abs(highest)] + 1, highest


QUADRATURE_POINTS = 6  # of Gaussian quadrature per interval: exact up to degree 11, without points at the ends
_NODES, _WEIGHTS = leggauss(QUADRATURE_POINTS)


def borders(trace: Trace, end: float) -> Array:
    """Return times, s, from 0 to `end`, between which the motion is smooth and no coordinate reverses."""
    events = [event.time for event in trace.events]
    times = sorted_unique(np.concatenate([[0.0, end], trace.knots(), events]))
    return times[(times >= 0.0) & (times <= end)]


def integral(trace: Trace, rate: Callable[[State], Array], end: float, corners: Iterable[float] = ()) -> float:
    """Return ∫ rate dt from 0 to `end`, s, by Gaussian quadrature; NaN if the rate, (n,), is NaN anywhere."""
    limits = borders(trace, end)
    inner = [time for time in corners if 0.0 < time < end]
    if inner:
        limits = sorted_unique(np.append(limits, inner))
    if len(limits) < 2:
        return 0.0
    widths = np.diff(limits)
    times = limits[:-1, None] + widths[:, None] * (0.5 + 0.5 * _NODES)
    values = rate(trace.sample(times.ravel())).reshape(times.shape)
    return float((values @ (0.5 * _WEIGHTS)) @ widths)


def collision_phrases(moment: Moment, words: Words, name: str) -> tuple[str, ...]:
    """Return phrases such as *in their second collision* for a moment just after a collision of `name`; else none.

    Empty for a moment that is not just after one of `name`.
    """
    if not (isinstance(moment, Collided | Bounced) and moment.after and moment.name == name):
        return ()
    if isinstance(moment, Bounced):
        return moment.does(words).phrases(moment.subject(words), moment.number)
    number = moment.count(words)
    if number is None:
        return ("in their collision", "when they collide", "in the collision of the two")
    which = ordinal_word(number)
    return (
        f"in their {which} collision",
        f"when they collide for the {which} time",
        f"in the {which} collision of the two",
    )


MAX_COUNT = 12  # greatest number worth counting
END_CLEARANCE = 0.03  # of the interval: least distance of its end from a counted event, unless it is that event


class EventCount(Functional):
    """The base class of counts of events from the start to a moment, inclusive.

    Class data:
        fewest: the smallest count asked for; two would be easy to guess.
    """

    kind, unit, least = "count", "", 1.5
    fewest: ClassVar[int] = 3

    @abstractmethod
    def times(self, trace: Trace, name: str) -> Sequence[float]:
        """Return the times of the counted events, s, in order."""

    def when(self, moment: Moment, words: Words, name: str) -> tuple[str, ...]:
        """Return phrases for the interval; none for one up to a numbered collision, which may reveal the count."""
        return () if isinstance(moment, Collided | Bounced) else super().when(moment, words, name)

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """Return the number of events up to the end."""
        return float(sum(time <= end for time in self.times(trace, name)))

    def worth(self, study: SimulatedScene, name: str, end: float) -> bool:
        """Return whether the count is in the usual range and no event is too close to the end of the interval."""
        times = self.times(study.trace, name)
        near = any(0.0 < abs(time - end) < END_CLEARANCE * end for time in times)
        return self.fewest <= (self.value(study.trace, name, end) or 0.0) <= MAX_COUNT and not near


LATE, ZERO_RATE_RTOL = 0.9, 1e-6  # of the interval; of the greatest rate


class Integral(Functional):
    """The base class of integrals, from the start to a moment, of a rate that always stays finite."""

    kind = "sum"

    @abstractmethod
    def rate(self, state: State, name: str) -> Array:
        """Return the integrand, (n,), in the unit of the integral per second."""

    def corners(self, trace: Trace, name: str) -> Iterable[float]:
        """Return the times, s, at which the rate has a kink although no event occurs; by default none."""
        del trace, name
        return ()

    def worth(self, study: SimulatedScene, name: str, end: float) -> bool:
        """Return whether the integral still grows near the end of the interval, so that the end matters."""
        scan = study.trace.scan
        rates, within = np.abs(self.rate(scan, name)), scan.times <= end
        late = rates[within & (scan.times >= LATE * end)]
        return float(late.max(initial=0.0)) > ZERO_RATE_RTOL * float(rates[within].max(initial=0.0))

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """Return the integral by Gaussian quadrature on the engine's steps."""
        return trace.memoize(
            (self.name, name, end),
            lambda: integral(trace, lambda state: self.rate(state, name), end, self.corners(trace, name)),
        )


IMPULSE_BALANCE_RTOL = 1e-6  # relative: largest difference between equal impulses


def jumps(trace: Trace, of: Callable[[State], Array], times: Iterable[float]) -> list[Array]:
    """Return the jump of a function of the state at each of some times, s."""
    return [
        np.asarray(of(trace.at(time))[0] - of(trace.at(float(np.nextafter(time, 0.0))))[0])
        for time in dict.fromkeys(times)  # several events may share an instant
    ]


def collision_times(trace: Trace, end: float, chosen: Callable[[Event], bool] = lambda _: True) -> list[float]:
    """Return the times, s, of all collision events up to a time that satisfy a predicate, in order."""
    return [event.time for event in trace.events if event.kind == "collision" and event.time <= end and chosen(event)]


def is_smooth(trace: Trace, end: float) -> bool:
    """Return whether no impact occurs up to a time, s, so that forces stay finite."""
    return not any(event.kind in IMPACTS and event.time <= end for event in trace.events)


def energy_lost(trace: Trace, times: Iterable[float]) -> float:
    """Return the kinetic energy, J, that all bodies together lose at some times, s."""

    def kinetic(state: State) -> Array:
        return np.sum([KineticEnergy.evaluate(state, body) for body in massive_bodies(state.mechanism)], axis=0)

    return -float(np.sum(jumps(trace, kinetic, times)))


def massive_bodies(mechanism: Mechanism) -> Sequence[str]:
    """Return the names of all bodies with a mass."""
    return [body.name for body in mechanism.bodies if body.mass > 0.0]


def energies(mechanism: Mechanism) -> tuple[Channel, ...]:
    """Return the channels on which a loss of kinetic energy depends."""
    return tuple(Channel(name, KineticEnergy.name) for name in massive_bodies(mechanism))


def is_unconstrained(mechanism: Mechanism, name: str) -> bool:
    """Return whether nothing constrains a body in an impact: no string, rod, hinge, carrier or rider."""
    tied = {mechanism.site[s].body for line in mechanism.lines if _holds(line.law) for s in line.through}
    body = mechanism.body[name]
    ridden = any(other.parent == name for other in mechanism.bodies)
    slides = all(c.kind == "slide" for c in body.coordinates) and body.parent is None
    return slides and not ridden and name not in tied


def _holds(law: object) -> bool:
    return isinstance(law, Inextensible | Rigid | Prop)
