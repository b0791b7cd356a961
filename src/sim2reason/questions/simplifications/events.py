"""Misconceptions about collisions, about the burning of rockets' fuel, and about other events."""

from abc import abstractmethod
from collections.abc import Callable, Iterable
from dataclasses import replace
from math import inf, isfinite, log
from typing import ClassVar

import numpy as np

from sim2reason.questions.kinds import KINDS
from sim2reason.questions.moments.crossings import Passage, crossings
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, MisinterpretedMotion, misconception
from sim2reason.questions.study import SimulatedScene, Timed
from sim2reason.scenes.dsl.frames import initial_frames
from sim2reason.scenes.dsl.mechanism import Attraction, MassEjection, Mechanism
from sim2reason.scenes.dsl.state import Array, Dynamics, State
from sim2reason.scenes.dsl.structure import changing, is_gravity_relevant, replace_bodies
from sim2reason.scenes.dsl.vectors import Vector, scale, subtract_triples
from sim2reason.simulation.trace import Trace, events_before


def query_time(query: Query, study: SimulatedScene) -> float:
    """Return the time, s, of the query's moment; the end of the motion if it has none."""
    time = study.time(query.moment) if query.moment is not None else None
    return float(study.trace.state.times[-1]) if time is None else time


def asked_name(query: Query) -> str:
    """Return the name of the quantity or functional asked for, as in an item's answer."""
    return KINDS[query.kind].measured(query).name


Formulas = Callable[[Array, Array, Array], tuple[Array, Array]]
"""Coordinates and their rates from times (n, 1), rates and accelerations of the start (1, n)."""


def is_steady(query: Query, study: SimulatedScene) -> bool:
    """Return whether bodies start from rest and move with constant accelerations up to the query's moment."""
    if any(coordinate.speed for coordinate in study.mechanism.coordinates):
        return False
    return not events_before(study.trace.events, query_time(query, study)) and not changing(study.mechanism)


def with_formulas(trace: Trace, formulas: Formulas) -> Trace:
    """Return a motion by formulas from the initial state and the initial accelerations, with constant forces."""
    first = trace.sample(np.zeros(1))

    def sample(times: Array) -> State:
        repeated = np.zeros(len(times), dtype=int)
        moved, rates = formulas(times[:, None], first.v, first.a)
        dynamics = Dynamics(
            first.a[repeated],
            {name: values[repeated] for name, values in first.constraint_tension.items()},
            {name: values[repeated] for name, values in first.normal.items()},
            {name: values[repeated] for name, values in first.friction.items()},
        )
        return State.of(first.mechanism, times, (first.q + moved, rates), dynamics)

    times = trace.state.times
    end = float(times[-1])
    return Trace(trace.engine, sample(times), (), end, "", sample, lambda: np.array([0.0, end]))


class OneRestitution(ChangedMechanism):
    """The base class of misconceptions that assume one coefficient of restitution for all collisions.

    Class data:
        restitution: the coefficient.
    """

    restitution: ClassVar[float]

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the whole mechanism as the subject if a collision has another coefficient; else none."""
        del query
        return [""] if any(meeting.restitution != self.restitution for meeting in study.mechanism.meetings) else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with the assumed coefficient of restitution in all collisions."""
        del subject
        same = tuple(replace(meeting, restitution=self.restitution, sticks=False) for meeting in mechanism.meetings)
        return replace(mechanism, meetings=same)


@misconception
class ElasticCollisions(OneRestitution):
    """Collisions are taken as elastic."""

    name = "elastic collisions"
    reason = "every collision is taken as elastic"
    restitution = 1.0
    common = True


@misconception
class PerfectlyInelasticCollisions(OneRestitution):
    """Collisions are taken as perfectly inelastic."""

    name = "perfectly inelastic collisions"
    reason = "every collision is taken as perfectly inelastic"
    restitution = 0.0


@misconception
class LaterRoot(MisinterpretedMotion):
    """Where an equation for the time has two roots, the later one is taken."""

    name = "later root"
    reason = "the second time at which this happens is taken for the first"
    sound_if_same = True  # then what is asked hangs on the place alone, and who takes energies never asks for the time

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the whole mechanism as the subject if a quantity passes through a value at the moment; else none."""
        del study
        return [""] if _is_passage(query.moment) else []

    def read(self, study: SimulatedScene) -> SimulatedScene:
        """Return the same motion, in which each passage through a value counts only the second time."""
        return _Later(study.scene, study.trace)


def _is_passage(moment: object) -> bool:
    return isinstance(moment, Passage) and type(moment).time is Passage.time


class _Later(SimulatedScene):
    """A motion in which a quantity's passage through a value counts only when it occurs for the second time."""

    def time(self, moment: Timed) -> float | None:
        """Return the second time, s, at which a quantity passes its value; the first time of any other moment."""
        first = super().time(moment)
        if first is None or not (isinstance(moment, Passage) and _is_passage(moment)):
            return first
        back = crossings(self.trace, lambda state: -moment.excess(state))
        again = (
            next((time for time in side if time > first), inf) for side in (crossings(self.trace, moment.excess), back)
        )
        later = min(again)
        return later if isfinite(later) else None


@misconception
class NoCollisions(ChangedMechanism):
    """Collisions are left out, as if bodies went through each other."""

    name = "no collisions"
    reason = "collisions are left out"

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the whole mechanism as the subject if bodies can collide; else none."""
        del query
        return [""] if study.mechanism.meetings else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism without collisions."""
        del subject
        return replace(mechanism, meetings=())


@misconception
class NoEvents(MisinterpretedMotion):
    """The motion is assumed to continue as it begins, without any events such as stops or collisions."""

    name = "no events"
    reason = "the motion is taken to go on as it begins"

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the whole mechanism as the subject if forces are constant and an event comes earlier; else none."""
        end = query_time(query, study)
        changes = any(event.time > 0.0 for event in events_before(study.trace.events, end))
        return [""] if changes and not changing(study.mechanism) else []

    def read(self, study: SimulatedScene) -> SimulatedScene:
        """Return the motion with the accelerations and forces of the start throughout."""
        return SimulatedScene(study.scene, with_formulas(study.trace, _continued))


def _continued(t: Array, v: Array, a: Array) -> tuple[Array, Array]:
    return v * t + 0.5 * a * t * t, v + a * t


BURN_RATE_FACTOR = (
    1e-6  # factor on the burn rate; its inverse multiplies the exhaust speed, so that the thrust stays equal
)


class BurnMisconception(ChangedMechanism):
    """The base class of misconceptions about the burn of one rocket."""

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the bodies that burn fuel."""
        del query
        return [burn.body for burn in study.mechanism.burns]

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with the altered burn."""
        burns = tuple(self.burnt(mechanism, burn) if burn.body == subject else burn for burn in mechanism.burns)
        return replace(mechanism, burns=burns)

    @abstractmethod
    def burnt(self, mechanism: Mechanism, burn: MassEjection) -> MassEjection:
        """Return the burn of a rocket under the misconception."""


def without_loss(burn: MassEjection) -> MassEjection:
    """Return a burn of the same thrust and duration that ejects almost no mass."""
    return replace(burn, rate=BURN_RATE_FACTOR * burn.rate, exhaust=burn.exhaust / BURN_RATE_FACTOR)


@misconception
class CommonLogarithm(BurnMisconception):
    """The velocity change is computed with the logarithm to base ten of the mass ratio."""

    name = "common logarithm"
    reason = "the logarithm to base ten is taken for the natural one"

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the bodies that burn fuel if their thrust is the only force; else none."""
        mechanism = study.mechanism
        return [] if is_gravity_relevant(mechanism) or mechanism.attractions else super().subjects(query, study)

    def burnt(self, mechanism: Mechanism, burn: MassEjection) -> MassEjection:
        """Return a burn whose exhaust is slower by ln 10, which has the same effect on the velocity."""
        del mechanism
        return replace(burn, exhaust=burn.exhaust / log(10.0))


@misconception
class ConstantMass(BurnMisconception):
    """A rocket is assumed to keep its mass as it burns fuel."""

    name = "constant mass"
    reason = "the mass of {subject} is taken as constant"

    def burnt(self, mechanism: Mechanism, burn: MassEjection) -> MassEjection:
        """Return a burn of the same thrust that ejects almost no mass."""
        del mechanism
        return without_loss(burn)


@misconception
class FuelAsRest(BurnMisconception):
    """The empty mass of a rocket is mistaken for the mass of its fuel."""

    name = "fuel mass for empty mass"
    reason = "the mass of {subject} without fuel is taken for the mass of its fuel"

    def burnt(self, mechanism: Mechanism, burn: MassEjection) -> MassEjection:
        """Return the burn of a rocket that takes its mass without fuel for the mass of its fuel."""
        left = mechanism.body[burn.body].mass - burn.rate * burn.until
        return replace(burn, until=left / burn.rate)


@misconception
class FuelLeftOut(BurnMisconception):
    """A rocket is assumed to have its empty mass from the start."""

    name = "fuel left out"
    reason = "the mass of the fuel of {subject} is left out"

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism in which one rocket has the same thrust but carries no fuel."""
        spent = {burn.body: burn.rate * burn.until for burn in mechanism.burns}
        lighter = replace_bodies(mechanism, [subject], lambda body: replace(body, mass=body.mass - spent[subject]))
        return super().changed(lighter, subject)

    def burnt(self, mechanism: Mechanism, burn: MassEjection) -> MassEjection:
        """Return a burn of the same thrust that ejects almost no mass."""
        del mechanism
        return without_loss(burn)


@misconception
class UniformGravity(ChangedMechanism):
    """The weight of a body that leaves a planet is assumed to stay constant."""

    name = "uniform gravity"
    reason = "gravity is taken to be everywhere what it is at the start"

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the whole mechanism as the subject if a rocket is attracted by one other body; else none."""
        del query
        return [""] if len(study.mechanism.attractions) == 1 and study.mechanism.burns else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with uniform gravity in place of the attraction."""
        del subject
        (pull,) = mechanism.attractions
        return replace(mechanism, attractions=(), gravity=_free_fall(mechanism, pull))


def _free_fall(mechanism: Mechanism, pull: Attraction) -> Vector:
    """Return the initial acceleration, m/s², of the rocket due to the attraction."""
    falling = mechanism.burns[0].body
    other = pull.b if falling == pull.a else pull.a
    frames = initial_frames(mechanism)
    x, y, z = (float(part) for part in subtract_triples(frames.center(other).place, frames.center(falling).place))
    distance = (x * x + y * y + z * z) ** 0.5
    return scale(pull.constant * mechanism.body[other].mass / distance ** (pull.power + 1.0), (x, y, z))


@misconception
class WeightAlongThrust(ChangedMechanism):
    """The weight of a rocket is added to its thrust, not subtracted from it."""

    name = "weight along the thrust"
    reason = "the weight of {subject} is added to the thrust instead of being subtracted"

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the bodies that burn fuel if there is gravity; else none."""
        del query
        mechanism = study.mechanism
        return [burn.body for burn in mechanism.burns] if is_gravity_relevant(mechanism) else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with gravity reversed."""
        del subject
        return replace(mechanism, gravity=scale(-1.0, mechanism.gravity))
