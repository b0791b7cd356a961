"""Zero crossings of functions of the motion, and base classes of moments at which a quantity passes a value."""

import math
from abc import abstractmethod
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import ClassVar, NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from sim2reason.questions.choices import is_clear_of_events
from sim2reason.questions.moments import Clause
from sim2reason.questions.moments.occurrence import VerbHappening, when_phrases
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.fields import Magnetic, Push, Resistance
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.scenes.dsl.vectors import inner
from sim2reason.simulation.quantities.subjects import Subject
from sim2reason.simulation.quantities.subjects.bodies import AXES, Bodies
from sim2reason.simulation.trace import Channel, Trace

EventFunction = Callable[[State], Array]
"""A function of the state that is negative before and positive after what is looked for, (n,)."""

ZERO_RTOL = 1e-9  # of the function's largest value: smaller values are zero
EVENT_JUMP_RTOL = 1e-12  # of the duration: a sign change within less is a jump at an event
CROSSING_TIME_RTOL = 0.1  # of the error of a step: accuracy of a crossing time
MAX_ROOT_ITERATIONS = 16  # iterations of the refinement; three or four reach double precision
TOUCH_SAMPLES = 33  # instants in an interval where the function may touch zero
_START_FRACTIONS = 10.0 ** -np.arange(1.0, 9.0)
_NEAR = 2 * len(_START_FRACTIONS) + 1  # instants around the guess; the others divide the interval
_TRIED_FRACTIONS = np.concatenate([-_START_FRACTIONS, [0.0], _START_FRACTIONS, np.arange(0.0, 1.01, 0.125)])


def crossings(trace: Trace, excess: EventFunction) -> Iterator[float]:
    """Yield the times, s, in order, at which a function rises through zero without a jump.

    What begins at zero must fall below it first. NaN is neither below nor above.
    """
    times, values = _sampled(trace, excess)
    size = _largest(values)
    above, below = values >= 0.0, values < -ZERO_RTOL * size
    number = 0
    while True:
        start = _first_true(below, number)
        number = _first_true(above, start + 1)
        if number == len(times):
            return
        low, high = float(times[number - 1]), float(times[number])
        if values[number - 1] >= 0.0:
            continue  # it lost its value on the way, and has it again
        if high - low <= EVENT_JUMP_RTOL * float(times[-1]):
            if values[number] - values[number - 1] <= ZERO_RTOL * size:
                yield high  # an event, such as a turn, at which nothing jumps
        else:
            yield _refine_root(trace, excess, (low, float(values[number - 1])), (high, float(values[number])))


def _first_true(flags: NDArray[np.bool_], start: int) -> int:
    """Return the index of the first flag that is set, from an index on; the number of flags if none is."""
    rest = flags[start:]
    index = int(rest.argmax()) if len(rest) else 0
    return start + index if len(rest) and rest[index] else len(flags)


def _largest(values: Array) -> float:
    """Return the largest size of finite values; 0 if there are none."""
    return float(np.maximum.reduce(np.abs(values[np.isfinite(values)]), initial=0.0))


def first_crossing(trace: Trace, excess: EventFunction) -> float | None:
    """Return the first time, s, at which a function rises through zero in the simulated motion; else None."""
    return next(crossings(trace, excess), None)


def jumps(trace: Trace, excess: EventFunction) -> list[float]:
    """Return the times, s, in order, of events at which a function jumps from negative to positive."""
    times, values = trace.scan.times, excess(trace.scan)
    small = ZERO_RTOL * _largest(values)
    jumped = (np.diff(times) <= EVENT_JUMP_RTOL * float(times[-1])) & (values[:-1] < -small) & (values[1:] > small)
    jump_times: list[float] = times[1:][jumped].tolist()
    return jump_times


def rises_from_zero(trace: Trace, excess: EventFunction) -> bool:
    """Return whether a function is zero at the start and positive when it first differs from zero."""
    values = excess(trace.scan)
    size = _largest(values)
    clear = values[np.abs(values) > ZERO_RTOL * size]
    return bool(abs(values[0]) <= ZERO_RTOL * size and len(clear) and clear[0] > 0.0)


def _sampled(trace: Trace, excess: EventFunction) -> tuple[Array, Array]:
    """Return sampled times and values of a function, with more samples where it may touch zero between two of them."""
    times = trace.scan.times
    values = excess(trace.scan)
    if len(times) < 3:
        return times, values
    sizes = np.abs(values)
    nearest = ((sizes[1:-1] <= sizes[:-2]) & (sizes[1:-1] <= sizes[2:])).nonzero()[0]
    before, here, after = values[nearest], values[nearest + 1], values[nearest + 2]
    apart = ((before * here > 0.0) & (after * here > 0.0)).nonzero()[0]
    if not len(apart):
        return times, values
    before, here, after = before[apart], here[apart], after[apart]
    bend = before - 2.0 * here + after
    with np.errstate(divide="ignore", invalid="ignore"):
        rise = np.abs((after - before) ** 2 / (8.0 * bend)) + np.abs(bend) / 8.0  # of a parabola over its middle sample
    close = nearest[apart][(np.sign(bend) == np.sign(here)) & (np.abs(here) < 2.0 * rise)]
    if not len(close):
        return times, values
    closer: list[Array] = [np.linspace(times[i], times[i + 2], TOUCH_SAMPLES)[1:-1] for i in close.tolist()]
    more: Array = np.setdiff1d(np.concatenate(closer), times)
    order = np.argsort(joined := np.concatenate([times, more]))
    return joined[order], np.concatenate([values, excess(trace.sample(more))])[order]


def _refine_root(trace: Trace, excess: EventFunction, low: tuple[float, float], high: tuple[float, float]) -> float:
    """Return the time, s, of a sign change between two instants, by the secant method with bracketing."""
    (a, fa), (b, fb) = low, high
    for _ in range(MAX_ROOT_ITERATIONS):
        width = b - a
        if width <= max(4e-16, CROSSING_TIME_RTOL * trace.tolerance) * b:
            break
        guess = a - width * fa / (fb - fa)
        times = width * _TRIED_FRACTIONS
        times[:_NEAR] += guess
        times[_NEAR:] += a
        np.minimum(np.maximum(times, a, out=times), b, out=times)
        times.sort()  # what is there twice does no harm
        values = excess(trace.sample(times))
        reached = int(((values >= 0.0) | (times >= b)).argmax())
        if reached == 0:
            return float(times[0])
        a, b, fa, fb = (float(x) for x in (times[reached - 1], times[reached], values[reached - 1], values[reached]))
        if not fb > fa:
            break
    return b


@dataclass(frozen=True, slots=True)
class Passage(VerbHappening):
    """The base class of moments at which a function of the motion of one subject first rises through zero.

    Class data:
        of: the kind of subject.
        hangs_on: the name of the quantity that must be certified.
    """

    of: ClassVar[Subject]
    hangs_on: ClassVar[str]

    name: str

    @abstractmethod
    def excess(self, state: State) -> Array:
        """Return the function, (n,), which is negative before the moment and positive after it."""

    @classmethod
    def found(cls, study: SimulatedScene, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """Return this class's moments for all subjects, if they occur and coincide with no event."""
        del rng
        return [moment for name in cls.candidates(words) if (moment := cls(name)).comes(study)]

    def comes(self, study: SimulatedScene) -> bool:
        """Return whether the moment occurs in the motion, and not close to an event."""
        time = study.time(self)
        return time is not None and is_clear_of_events(time, study.trace)

    @classmethod
    def parsed(cls, text: str, trace: Trace, words: Words) -> Iterator[Self]:
        """Yield the moment of every subject that a sentence names."""
        del trace
        return (cls(name) for name, phrase in cls.candidates(words).items() if phrase in text)

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the possible subjects, with their phrases."""
        return dict(words.subject_phrases(cls.of))

    @property
    def subjects(self) -> tuple[str, ...]:
        """Return the name of the subject."""
        return (self.name,)

    def possible(self, mechanism: Mechanism) -> bool:
        """Return whether the mechanism has the subject of the moment, as a changed mechanism may not."""
        return self.name in self.of.names(mechanism)

    @property
    def channels(self) -> tuple[Channel, ...]:
        """Return the channel on which the moment depends."""
        return (Channel(self.name, self.hangs_on),)

    def time(self, trace: Trace) -> float | None:
        """Return the time, s, at which the function first rises through zero; None if it never does."""
        return first_crossing(trace, self.excess)

    def subject(self, words: Words) -> str:
        """Return the phrase for the subject."""
        return self.candidates(words)[self.name]

    def phrases(self, words: Words) -> tuple[str, ...]:
        """Return phrases such as *when the ball first passes through the lowest point of its path*."""
        return self.does(words).phrases(self.subject(words), 1)

    def clause(self, words: Words) -> Clause | None:
        """Return the clause, such as *the ball first passes through the lowest point of its path*."""
        return self.does(words).clause(self.subject(words), 1)


@dataclass(frozen=True, slots=True)
class Threshold(Passage):
    """The base class of moments at which a quantity first has a stated value, drawn with two digits.

    Class data:
        unit: of the value, in the SI.
    """

    unit: ClassVar[str]

    value: float  # in the units of the text, as spoken

    @classmethod
    def found(cls, study: SimulatedScene, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """Return the moment of one random subject with a random value."""
        names = list(cls.candidates(words))
        if not names:
            return []
        name = names[int(rng.integers(len(names)))]
        value = cls.drawn(name, study.trace, rng)
        return [moment] if value is not None and (moment := cls(name, value)).comes(study) else []

    @classmethod
    @abstractmethod
    def drawn(cls, name: str, trace: Trace, rng: np.random.Generator) -> float | None:
        """Return a random value that is reached, rounded as stated; None if there is none."""

    @classmethod
    def parsed(cls, text: str, trace: Trace, words: Words) -> Iterator[Self]:
        """Yield a moment for every subject that a sentence names and every number in the quantity's unit."""
        del trace
        numbers = words.find_numbers(text, cls.unit)
        for name, phrase in cls.candidates(words).items():
            if phrase in text:
                yield from (cls(name, number) for number in numbers)

    @property
    def stated(self) -> tuple[tuple[float, str], ...]:
        """Return the value with its unit."""
        return ((self.value, self.unit),)

    @property
    def revealed_channels(self) -> tuple[Channel, ...]:
        """Return the channel of the quantity, whose value is stated."""
        return self.channels

    def having(self, numbers: Sequence[float]) -> Self:
        """Return the same moment with another value."""
        (value,) = numbers
        return replace(self, value=value)

    def said(self, words: Words) -> str:
        """Return the value with its unit as text."""
        return words.amount(self.value, self.unit)


COMPONENT_RTOL = 0.02  # of a velocity or an acceleration: smaller components are zero


class ActingFields(NamedTuple):
    """The fields that act on a body in a plane."""

    electric: tuple[Push, ...]
    magnetic: tuple[Magnetic, ...]
    medium: tuple[Resistance, ...]

    @property
    def turning(self) -> bool:
        """Return whether the fields turn or reverse the velocity in a way that short formulas describe."""
        return bool(self.magnetic) or all(law.profile.uniform or _drives_back(law) for law in self.electric)

    @property
    def uniform(self) -> bool:
        """Return whether all fields are uniform and constant, and there is no medium."""
        return not self.medium and all(law.profile.uniform for law in (*self.electric, *self.magnetic))


def _drives_back(law: Push) -> bool:
    """Return whether a field is a restoring one, whose force points to the position where it vanishes."""
    return law.profile.steady and law.profile.slope * inner(law.profile.axis, law.direction) < 0.0


def acting_on(mechanism: Mechanism, name: str) -> ActingFields | None:
    """Return the fields that act on a body with axes x and y; None if anything else acts, or a field has a boundary."""
    own = mechanism.body[name].coordinates
    alone = not (mechanism.lines or mechanism.meetings or mechanism.attractions or mechanism.burns or mechanism.faces)
    level = all(inner(mechanism.gravity, c.axis) == 0.0 for c in own)
    if not alone or len(own) != 2 or any(c.label not in AXES for c in own) or not level:
        return None
    forces = [force for force in mechanism.forces if force.body == name]
    if any(force.region is not None for force in forces):
        return None
    laws = [force.law for force in forces]
    electric = tuple(law for law in laws if isinstance(law, Push))
    magnetic = tuple(law for law in laws if isinstance(law, Magnetic))
    medium = tuple(law for law in laws if isinstance(law, Resistance))
    return ActingFields(electric, magnetic, medium) if electric or magnetic else None


@dataclass(frozen=True, slots=True)
class FieldPassage(Passage):
    """The base class of moments of a body on which only fields act."""

    of = Bodies()

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the bodies in suitable fields, with their phrases."""
        called, mechanism = words.subject_phrases(cls.of).items(), words.mechanism
        return {name: phrase for name, phrase in called if (acts := acting_on(mechanism, name)) and cls.suits(acts)}

    def time(self, trace: Trace) -> float | None:
        """Return the time, s, of the first occurrence; None if the acting fields are not those of the text."""
        acts = acting_on(trace.mechanism, self.name)
        return Passage.time(self, trace) if acts is not None and self.suits(acts) else None

    def phrases(self, words: Words) -> tuple[str, ...]:
        """Return phrases such as *when the bead first has its initial velocity again*."""
        first = f"{self.subject(words)} first {self.does(words).told}"
        return when_phrases(first)

    @classmethod
    @abstractmethod
    def suits(cls, acts: ActingFields) -> bool:
        """Return whether a question may ask for a moment of this class if the given fields act on the body."""


def initial_rates(state: State, name: str) -> tuple[Array, Array]:
    """Return the initial velocity, m/s, and acceleration, m/s², of a body in fields, (3,) each."""
    mechanism = state.mechanism
    body = mechanism.body[name]
    velocity = sum((c.speed * np.array(c.axis) for c in body.coordinates), np.zeros(3))
    vx, vy, vz = velocity.tolist()
    x, y, z = np.array(state.began.center(name).place, dtype=float).tolist()
    laws = [force.law for force in mechanism.forces if force.body == name]
    pushes = [np.array(law.force((x, y, z), (vx, vy, vz), 0.0, math), dtype=float) for law in laws]
    return velocity, sum(pushes, np.zeros(3)) / body.mass
