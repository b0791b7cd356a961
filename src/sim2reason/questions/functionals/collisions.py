"""Numbers of collisions, and the energies lost and impulses exchanged in them."""

from collections.abc import Sequence

import numpy as np

from sim2reason.questions.functionals import Functional, functional
from sim2reason.questions.functionals.aggregates import (
    IMPULSE_BALANCE_RTOL,
    EventCount,
    collision_phrases,
    collision_times,
    energies,
    energy_lost,
    is_unconstrained,
    jumps,
    massive_bodies,
)
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.bounces import WALLS, obstacle_phrase
from sim2reason.questions.moments.contacts import LastCollision
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.simulation.quantities.kinematics import Velocity
from sim2reason.simulation.quantities.momentum import Momentum
from sim2reason.simulation.quantities.subjects.bodies import Bodies, WholeScene
from sim2reason.simulation.quantities.subjects.interactions import Pairs, members
from sim2reason.simulation.trace import Channel, Trace


@functional
class Bounces(EventCount):
    """The number of times that a body hits the ground, a wall or walls."""

    name = "number of bounces"
    of = Bodies()
    phrase = "the number of times that {body} hits {what}"
    how = "how many times does {body} hit {what} {when}?"
    fewest = 2  # a ball that is thrown is not followed for much longer
    indirect = "how many times {body} hits {what}"

    def placeholders(self, words: Words, name: str) -> dict[str, str]:
        """Return the placeholder for the fixed obstacle that the body hits."""
        return {"what": obstacle_phrase(words, name)}

    def present(self, words: Words, name: str) -> bool:
        """Return whether the body can hit a fixed obstacle."""
        return bool(obstacle_phrase(words, name))

    def times(self, trace: Trace, name: str) -> Sequence[float]:
        """Return the times, s, of the body's collisions with fixed obstacles."""
        return [event.time for event in trace.events if event.kind == "collision" and event.subjects == (name,)]

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """Return the channel of the body's velocity."""
        del mechanism
        return (Channel(name, Velocity.name),)


@functional
class CollisionImpulse(Functional):
    """The magnitude of the impulse that two free bodies exert on each other in a collision."""

    name, unit, kind, least = "impulse of a collision", "N s", "sum", 1e-3
    of, needs = Pairs(), ("mass",)
    phrase = "the magnitude of the impulse that {pair} exert on each other"
    how = "how large is the impulse that {pair} exert on each other {when}?"
    weight = 3.0

    def when(self, moment: Moment, words: Words, name: str) -> tuple[str, ...]:
        """Return the phrases for the moment, such as *in their second collision*."""
        return collision_phrases(moment, words, name)

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """Return the impulse m|Δv| of the collision, N s; None if a third body takes part at the same instant."""
        one, other = (jumps(trace, lambda s, n=n: Momentum.evaluate(s, n), [end])[0] for n in members(name))
        size = float(np.linalg.norm(one))
        return size if float(np.linalg.norm(one + other)) <= IMPULSE_BALANCE_RTOL * size else None

    def present(self, words: Words, name: str) -> bool:
        """Return whether both bodies are free, so that no string or axle takes part of the impulse."""
        return all(is_unconstrained(words.mechanism, body) for body in members(name))

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """Return the channels of both momenta."""
        del mechanism
        return tuple(Channel(body, Momentum.name) for body in members(name))


@functional
class CollisionLoss(Functional):
    """The kinetic energy that two bodies lose as they collide."""

    name, unit, kind, least = "energy lost in a collision", "J", "sum", 1e-3
    of, needs = Pairs(), ("mass",)
    phrase = "the kinetic energy that {pair} lose together"
    how = "how much kinetic energy do {pair} lose together {when}?"
    indirect = "how much kinetic energy {pair} lose together"
    weight = 5.0

    def when(self, moment: Moment, words: Words, name: str) -> tuple[str, ...]:
        """Return the phrases for the moment, such as *in their second collision*."""
        return collision_phrases(moment, words, name)

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """Return the kinetic energy lost by all bodies, J; None if another collision occurs at the same instant."""
        del name
        alone = collision_times(trace, end).count(end) == 1
        return energy_lost(trace, [end]) if alone else None

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """Return the channels of all kinetic energies."""
        del name
        return energies(mechanism)


@functional
class Collisions(EventCount):
    """The number of all collisions, of bodies with one another and with walls."""

    name = "number of collisions"
    of = WholeScene()
    phrase = "the number of collisions{walls} that take place"
    how = "how many collisions{walls} take place {when}?"
    indirect = "how many collisions{walls} take place"
    weight = 3.0

    def placeholders(self, words: Words, name: str) -> dict[str, str]:
        """Return the placeholder for words that include collisions with walls in the count, if there are walls."""
        del name
        walls = sum(meeting.a is None for meeting in words.mechanism.meetings)
        return {"walls": f", those with the wall{'s' if walls > 1 else ''} included," if walls else ""}

    def present(self, words: Words, name: str) -> bool:
        """Return whether two bodies can collide, and no buffer spring makes the number of collisions ambiguous."""
        del name
        pairs = any(len(meeting.names) == 2 for meeting in words.mechanism.meetings)
        return pairs and not words.mechanism.half_springs

    def when(self, moment: Moment, words: Words, name: str) -> tuple[str, ...]:
        """Return phrases for the interval up to a moment; for all future motion if the moment is the last collision."""
        if isinstance(moment, LastCollision):
            return ("in all", "altogether", f"from {words.since} on")
        return super().when(moment, words, name)

    def times(self, trace: Trace, name: str) -> Sequence[float]:
        """Return the times, s, of all collisions."""
        del name
        return [event.time for event in trace.events if event.kind == "collision"]

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """Return the channels of all velocities."""
        del name
        return tuple(Channel(body, Velocity.name) for body in massive_bodies(mechanism))


MIN_IMPACTS = 2  # least number of impacts in a sum


class FromFixed(Functional):
    """The base class of functionals of a body's impacts on a fixed obstacle."""

    unit, kind, least = "N s", "sum", 1e-3
    of, needs = Bodies(), ("mass",)

    def present(self, words: Words, name: str) -> bool:
        """Return whether the body is free and can hit the ground or exactly one wall."""
        return obstacle_phrase(words, name) not in {"", WALLS} and is_unconstrained(words.mechanism, name)

    def placeholders(self, words: Words, name: str) -> dict[str, str]:
        """Return the placeholder for the obstacle that the body hits."""
        return {"what": obstacle_phrase(words, name)}

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """Return the channel of the body's momentum."""
        del mechanism
        return (Channel(name, Momentum.name),)

    def sum(self, trace: Trace, name: str, times: list[float]) -> float | None:
        """Return the total impulse |Σ mΔv| of impacts, N s; None if another body takes part in one of the impacts."""
        others = (
            collision_times(trace, times[-1], lambda e: name in e.subjects and len(e.subjects) > 1) if times else []
        )
        if not times or set(others) & set(times):
            return None
        return float(np.linalg.norm(np.sum(jumps(trace, lambda s: Momentum.evaluate(s, name), times), axis=0)))


@functional
class ImpactImpulse(FromFixed):
    """The magnitude of the impulse of one impact."""

    name = "impulse of an impact"
    phrase = "the magnitude of the impulse that {what} exerts on {body}"
    how = "how large is the impulse that {what} exerts on {body} {when}?"
    weight = 3.0

    def when(self, moment: Moment, words: Words, name: str) -> tuple[str, ...]:
        """Return the phrases for the moment, such as *in their second collision*."""
        return collision_phrases(moment, words, name)

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """Return the impulse m|Δv| of the impact, N s; None if another body takes part in the impact."""
        return self.sum(trace, name, [end])


@functional
class TotalImpactImpulse(FromFixed):
    """The magnitude of the total impulse of several impacts in one direction."""

    name = "total impulse of impacts"
    phrase = "the magnitude of the total impulse that {what} exerts on {body}"
    how = "how large is the total impulse that {what} exerts on {body} {when}?"

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """Return the total impulse |Σ mΔv| of all impacts up to a time, N s; None if another body takes part in one."""
        return self.sum(trace, name, collision_times(trace, end, lambda event: event.subjects == (name,)))

    def worth(self, study: SimulatedScene, name: str, end: float) -> bool:
        """Return whether several impacts occur up to the time, so that the total differs from a single impulse."""
        return len(collision_times(study.trace, end, lambda event: event.subjects == (name,))) >= MIN_IMPACTS


@functional
class TotalCollisionLoss(Functional):
    """The kinetic energy lost in all collisions up to a moment."""

    name, unit, kind, least = "energy lost in collisions", "J", "sum", 1e-3
    of, needs = WholeScene(), ("mass",)
    phrase = "the total kinetic energy lost in collisions"
    how = "how much kinetic energy is lost in collisions altogether {when}?"
    weight = 4.0

    def when(self, moment: Moment, words: Words, name: str) -> tuple[str, ...]:
        """Return phrases for the interval up to a moment; for the whole motion if the moment is the last collision."""
        if isinstance(moment, LastCollision):
            return (f"from {words.since} on", "in the motion that follows", "in the whole motion")
        return super().when(moment, words, name)

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """Return the kinetic energy lost in all collisions, J."""
        del name
        return energy_lost(trace, collision_times(trace, end))

    def worth(self, study: SimulatedScene, name: str, end: float) -> bool:
        """Return whether several collisions occur up to the time, so that the total differs from a single loss."""
        del name
        return len(collision_times(study.trace, end)) >= MIN_IMPACTS

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """Return the channels of all kinetic energies."""
        del name
        return energies(mechanism)
