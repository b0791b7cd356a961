"""Kinds that ask for quantities at the start, at a stated time, and at an event."""

import numpy as np

from sim2reason.questions.choices import (
    has_formula_of_time,
    is_constant,
    is_large_enough,
    is_worth_asking_at,
    only_falls,
    pick,
)
from sim2reason.questions.kinds import ValueKind, draw_moment, kind
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.times import AllAlong, AtStart
from sim2reason.questions.query import Query, Targets
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.constancy import changing
from sim2reason.scenes.dsl.mechanism import Elastic, Mechanism
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.quantities import QUANTITIES


@kind
class EventKind(ValueKind):
    """The kind that asks for a quantity at an event, such as a collision or a stop."""

    name = "event"
    share = 0.3

    def draw(self, study: SimulatedScene, words: Words, targets: Targets, rng: np.random.Generator) -> Query | None:
        """Return a query for a random quantity at a random event that does not reveal the value; None without one."""
        moment = draw_moment(self.moments(), study, words, rng)
        return self.at(moment, study, words, targets, rng) if moment is not None else None

    def at(
        self, moment: Moment, study: SimulatedScene, words: Words, targets: Targets, rng: np.random.Generator
    ) -> Query | None:
        """Return a query for a quantity that varies near the moment and is not stated; None if there is none."""
        del words
        if moment.kind != self.name:
            return None
        offered = [
            target for target in targets if Channel(target.subject, target.quantity) not in moment.revealed_channels
        ]
        if moment.own:
            offered = [target for target in offered if target.subject in moment.subjects] or offered
        target = pick(offered, rng, is_worth_asking_at(study, moment))
        return Query(self.name, target, moment) if target is not None else None


FEW = 2  # greatest number of forces besides weight that act on a single point mass


@kind
class StartKind(ValueKind):
    """The kind that asks for an acceleration or a force at t = 0⁺."""

    name = "start"
    share = 0.25
    timeless = True

    def draw(self, study: SimulatedScene, words: Words, targets: Targets, rng: np.random.Generator) -> Query | None:
        """Return a query for a nonzero quantity at the start, or for a constant one; None if there is none.

        None if the text gives irrelevant data, such as fuel or a speed that no equation contains, or if the answer
        follows from Newton's second law in one line.
        """
        mechanism, trace = study.mechanism, study.trace
        if not draw_moment(self.moments(), study, words, rng) or mechanism.burns:
            return None
        if _one_line(mechanism) or _speeds_idle(mechanism):
            return None
        here, immediate = trace.at(0.0), [t for t in targets if QUANTITIES[t.quantity].immediate]
        target = pick(immediate, rng, lambda target: is_large_enough(target.value(here), target, study))
        if target is None:
            return None
        return Query(self.name, target, AllAlong() if is_constant(target, trace) else AtStart())

    def at(
        self, moment: Moment, study: SimulatedScene, words: Words, targets: Targets, rng: np.random.Generator
    ) -> Query | None:
        """Return a query for a random quantity at the start; None if the moment is not the start."""
        return self.draw(study, words, targets, rng) if moment.kind == self.name else None


def _one_line(mechanism: Mechanism) -> bool:
    """Return whether only weight acts, or at most two forces act on a single point mass."""
    massive = [body for body in mechanism.bodies if body.mass and not (body.parent is None and not body.coordinates)]
    alone = len(massive) == 1 and not any(massive[0].inertia) and not mechanism.contacts
    acting = (*mechanism.lines, *mechanism.forces, *mechanism.attractions)
    return only_falls(mechanism) or (alone and len(acting) <= FEW)


def _speeds_idle(mechanism: Mechanism) -> bool:
    """Return whether something moves at the start, while forces depend at most on positions."""
    if not any(coordinate.speed for coordinate in mechanism.coordinates):
        return False
    return _free(mechanism) or not changing(mechanism)


def _free(mechanism: Mechanism) -> bool:
    """Return whether there are no guides or friction, and only undamped springs and attractions act besides weight."""
    led = mechanism.constraints or mechanism.contacts or mechanism.forces or mechanism.feet
    elastic = (line.law for line in mechanism.lines if isinstance(line.law, Elastic))
    return not led and all(c.kind == "slide" for c in mechanism.coordinates) and not any(law.damping for law in elastic)


@kind
class StateKind(ValueKind):
    """The kind that asks for a quantity at a stated time."""

    name = "state"
    share = 0.06  # at most 30 % of all that passes the filters

    def draw(self, study: SimulatedScene, words: Words, targets: Targets, rng: np.random.Generator) -> Query | None:
        """Return a query at a random time away from events for a quantity that has changed by then; None without one.

        None where no short formula gives the motion as a function of time.
        """
        if not has_formula_of_time(study.mechanism):
            return None
        moment = draw_moment(self.moments(), study, words, rng)
        return self.at(moment, study, words, targets, rng) if moment is not None else None

    def at(
        self, moment: Moment, study: SimulatedScene, words: Words, targets: Targets, rng: np.random.Generator
    ) -> Query | None:
        """Return a query for a quantity that differs from its initial value at the moment; None if there is none."""
        del words
        target = pick(targets, rng, is_worth_asking_at(study, moment)) if moment.kind == self.name else None
        return Query(self.name, target, moment) if target is not None else None
