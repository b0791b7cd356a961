"""Quantities at the start, at a stated time, and at an event."""

import numpy as np

from sim2reason.questions.choices import changed, has_formula_of_time, is_something, lasts, only_falls, pick
from sim2reason.questions.kinds import ValueKind, drawn, kind
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.times import AllAlong, AtStart
from sim2reason.questions.query import Query, Targets
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.constancy import changing
from sim2reason.scenes.dsl.mechanism import Elastic, Mechanism
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.quantities import QUANTITIES


@kind
class EventKind(ValueKind):
    """What is the quantity when something happens: a collision, a body that stops, or that has moved so far?"""

    name = "event"
    share = 0.3

    def draw(self, study: Study, words: Words, targets: Targets, rng: np.random.Generator) -> Query | None:
        """Return a moment of this motion and a quantity that it bears on, but none that the question tells."""
        moment = drawn(self.moments(), study, words, rng)
        return self.at(moment, study, words, targets, rng) if moment is not None else None

    def at(
        self, moment: Moment, study: Study, words: Words, targets: Targets, rng: np.random.Generator
    ) -> Query | None:
        """Return a quantity that the moment bears on, but none that its words tell."""
        del words
        if moment.kind != self.name:
            return None
        offered = [target for target in targets if Channel(target.subject, target.quantity) not in moment.tells]
        if moment.own:
            offered = [target for target in offered if target.subject in moment.subjects] or offered
        target = pick(offered, rng, changed(study, moment))
        return Query(self.name, target, moment) if target is not None else None


FEW = 2  # forces beside weight


@kind
class StartKind(ValueKind):
    """What is an acceleration or a force at t = 0⁺, which the text does not give?"""

    name = "start"
    share = 0.25
    timeless = True

    def draw(self, study: Study, words: Words, targets: Targets, rng: np.random.Generator) -> Query | None:
        """Return a quantity that differs from zero before anything has moved; just then, if it does not last.

        None where the text gives what can not bear on it yet, fuel or a speed that changes no equation, and where it
        is Newton's second law in one line.
        """
        mechanism, trace = study.mechanism, study.trace
        if not drawn(self.moments(), study, words, rng) or mechanism.burns:
            return None
        if _one_line(mechanism) or _speeds_idle(mechanism):
            return None
        here, immediate = trace.at(0.0), [t for t in targets if QUANTITIES[t.quantity].immediate]
        target = pick(immediate, rng, lambda target: is_something(target.value(here), target, study))
        if target is None:
            return None
        return Query(self.name, target, AllAlong() if lasts(target, trace) else AtStart())

    def at(
        self, moment: Moment, study: Study, words: Words, targets: Targets, rng: np.random.Generator
    ) -> Query | None:
        """Return the same, since the start is the only moment that it asks about."""
        return self.draw(study, words, targets, rng) if moment.kind == self.name else None


def _one_line(mechanism: Mechanism) -> bool:
    """Return whether nothing but weight acts, or no more than two forces act on a lone point."""
    massive = [body for body in mechanism.bodies if body.mass and not (body.parent is None and not body.coordinates)]
    alone = len(massive) == 1 and not any(massive[0].inertia) and not mechanism.contacts
    acting = (*mechanism.lines, *mechanism.forces, *mechanism.attractions)
    return only_falls(mechanism) or (alone and len(acting) <= FEW)


def _speeds_idle(mechanism: Mechanism) -> bool:
    """Return whether something moves at the start, while forces hang on places alone, or on nothing."""
    if not any(coordinate.speed for coordinate in mechanism.coordinates):
        return False
    return _free(mechanism) or not changing(mechanism)


def _free(mechanism: Mechanism) -> bool:
    """Return whether nothing leads or rubs, and nothing but springs and attractions acts beside weight."""
    led = mechanism.constraints or mechanism.contacts or mechanism.forces or mechanism.feet
    elastic = (line.law for line in mechanism.lines if isinstance(line.law, Elastic))
    return not led and all(c.kind == "slide" for c in mechanism.coordinates) and not any(law.damping for law in elastic)


@kind
class StateKind(ValueKind):
    """What is the quantity at a stated time?"""

    name = "state"
    share = 0.06  # at most 30 % of all that passes the filters

    def draw(self, study: Study, words: Words, targets: Targets, rng: np.random.Generator) -> Query | None:
        """Draw a quantity at a time that is not close to an event, whose value differs then from the initial one.

        None where no short formula gives the motion as a function of time.
        """
        if not has_formula_of_time(study.mechanism):
            return None
        moment = drawn(self.moments(), study, words, rng)
        return self.at(moment, study, words, targets, rng) if moment is not None else None

    def at(
        self, moment: Moment, study: Study, words: Words, targets: Targets, rng: np.random.Generator
    ) -> Query | None:
        """Any quantity that is not then what it was at the start."""
        del words
        target = pick(targets, rng, changed(study, moment)) if moment.kind == self.name else None
        return Query(self.name, target, moment) if target is not None else None
