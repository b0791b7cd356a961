"""Integrals of rates, counts of events, and jumps of velocity in collisions."""

from abc import abstractmethod
from collections.abc import Callable, Iterable, Sequence
from typing import ClassVar

import numpy as np

from sim2reason.questions.functionals import Functional
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.bounces import Bounced
from sim2reason.questions.moments.collisions import Collided
from sim2reason.questions.quadrature import integral
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words, ordinal
from sim2reason.scenes.dsl.mechanism import Inextensible, Mechanism, Prop, Rigid
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.quantities.energy import KineticEnergy
from sim2reason.simulation.trace import Event, Trace


def encounter(moment: Moment, words: Words, name: str) -> tuple[str, ...]:
    """Return a text such as *in their second collision, when A hits the ground for the second time*.

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


MOST = 12  # that are worth counting
CLEAR = 0.03  # of the stretch: how far its end must be from what is counted, unless that is the end itself


class EventCount(Functional):
    """How often something happens from the start to a moment, that moment included.

    Class data:
        fewest: from how many on it is asked; two is what most people would guess.
    """

    kind, unit, least = "count", "", 1.5
    fewest: ClassVar[int] = 3

    @abstractmethod
    def times(self, trace: Trace, name: str) -> Sequence[float]:
        """Return when it happens, s, in order."""

    def when(self, moment: Moment, words: Words, name: str) -> tuple[str, ...]:
        """Not of a stretch that ends with a collision by its number, which may tell the answer."""
        return () if isinstance(moment, Collided | Bounced) else super().when(moment, words, name)

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """Return how many there are."""
        return float(sum(time <= end for time in self.times(trace, name)))

    def worth(self, study: Study, name: str, end: float) -> bool:
        """Return whether there are some, and none where no one could tell by stated numbers whether it counts."""
        times = self.times(study.trace, name)
        near = any(0.0 < abs(time - end) < CLEAR * end for time in times)
        return self.fewest <= (self.value(study.trace, name, end) or 0.0) <= MOST and not near


LATE, NOTHING = 0.9, 1e-6  # of the stretch; of the greatest rate


class Integral(Functional):
    """The integral of a rate, which has no impulses, from the start to a moment."""

    kind = "sum"

    @abstractmethod
    def rate(self, state: State, name: str) -> Array:
        """Return what is integrated, (n,), in the unit per second."""

    def corners(self, trace: Trace, name: str) -> Iterable[float]:
        """Return when the rate has a corner though nothing happens, s; by default never."""
        del trace, name
        return ()

    def worth(self, study: Study, name: str, end: float) -> bool:
        """Return whether it still grows shortly before the end of the stretch: else that end decorates the question."""
        scan = study.trace.scan
        rates, within = np.abs(self.rate(scan, name)), scan.times <= end
        late = rates[within & (scan.times >= LATE * end)]
        return float(late.max(initial=0.0)) > NOTHING * float(rates[within].max(initial=0.0))

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """By Gauss's rule on the engine's steps."""
        return integral(trace, lambda state: self.rate(state, name), end, self.corners(trace, name))


IMPACTS = frozenset({"collision", "taut", "land"})
BALANCE = 1e-6  # of an impulse: by how much two may differ that are one


def jumps(trace: Trace, of: Callable[[State], Array], times: Iterable[float]) -> list[Array]:
    """By how much a function of the state differs just after each of some instants, s, from just before."""
    return [
        np.asarray(of(trace.at(time))[0] - of(trace.at(float(np.nextafter(time, 0.0))))[0])
        for time in dict.fromkeys(times)  # several events may share an instant
    ]


def hits(trace: Trace, end: float, chosen: Callable[[Event], bool] = lambda _: True) -> list[float]:
    """Return the times, s, of collisions of a kind up to an instant, in order, each event for itself."""
    return [event.time for event in trace.events if event.kind == "collision" and event.time <= end and chosen(event)]


def is_smooth(trace: Trace, end: float) -> bool:
    """Return whether no impact happens up to an instant, so that no force is greater than any."""
    return not any(event.kind in IMPACTS and event.time <= end for event in trace.events)


def energy_lost(trace: Trace, times: Iterable[float]) -> float:
    """Return the kinetic energy, J, that all bodies lose together at some instants."""

    def kinetic(state: State) -> Array:
        return np.sum([KineticEnergy.evaluate(state, body) for body in massive(state.mechanism)], axis=0)

    return -float(np.sum(jumps(trace, kinetic, times)))


def massive(mechanism: Mechanism) -> Sequence[str]:
    """Return the names of all bodies with a mass."""
    return [body.name for body in mechanism.bodies if body.mass > 0.0]


def energies(mechanism: Mechanism) -> tuple[Channel, ...]:
    """Return what a loss of kinetic energy hangs on."""
    return tuple(Channel(name, KineticEnergy.name) for name in massive(mechanism))


def is_loose(mechanism: Mechanism, name: str) -> bool:
    """Return whether nothing but faces holds a body at an impact: no line, no hinge, no rider."""
    tied = {mechanism.site[s].body for line in mechanism.lines if _holds(line.law) for s in line.through}
    body = mechanism.body[name]
    ridden = any(other.parent == name for other in mechanism.bodies)
    slides = all(c.kind == "slide" for c in body.coordinates) and body.parent is None
    return slides and not ridden and name not in tied


def _holds(law: object) -> bool:
    return isinstance(law, Inextensible | Rigid | Prop)
