"""Base classes of integrals and event counts, and velocity jumps in collisions."""

from abc import abstractmethod
from collections.abc import Callable, Iterable, Sequence
from typing import ClassVar

import numpy as np

from sim2reason.questions.functionals import Functional
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.bounces import Bounced
from sim2reason.questions.moments.collisions import Collided
from sim2reason.questions.quadrature import integral
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words, ordinal
from sim2reason.scenes.dsl.mechanism import Inextensible, Mechanism, Prop, Rigid
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.quantities.energy import KineticEnergy
from sim2reason.simulation.trace import Event, Trace


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
    which = ordinal(number)
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
        return integral(trace, lambda state: self.rate(state, name), end, self.corners(trace, name))


IMPACTS = frozenset({"collision", "taut", "land"})
BALANCE = 1e-6  # relative: largest difference between equal impulses


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
        return np.sum([KineticEnergy.evaluate(state, body) for body in massive(state.mechanism)], axis=0)

    return -float(np.sum(jumps(trace, kinetic, times)))


def massive(mechanism: Mechanism) -> Sequence[str]:
    """Return the names of all bodies with a mass."""
    return [body.name for body in mechanism.bodies if body.mass > 0.0]


def energies(mechanism: Mechanism) -> tuple[Channel, ...]:
    """Return the channels on which a loss of kinetic energy depends."""
    return tuple(Channel(name, KineticEnergy.name) for name in massive(mechanism))


def is_unconstrained(mechanism: Mechanism, name: str) -> bool:
    """Return whether nothing constrains a body in an impact: no string, rod, hinge, carrier or rider."""
    tied = {mechanism.site[s].body for line in mechanism.lines if _holds(line.law) for s in line.through}
    body = mechanism.body[name]
    ridden = any(other.parent == name for other in mechanism.bodies)
    slides = all(c.kind == "slide" for c in body.coordinates) and body.parent is None
    return slides and not ridden and name not in tied


def _holds(law: object) -> bool:
    return isinstance(law, Inextensible | Rigid | Prop)
