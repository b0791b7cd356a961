"""What is the quantity just after the start?"""

import numpy as np

from sim2reason.dsl.constancy import changing
from sim2reason.dsl.frames import start
from sim2reason.dsl.mechanism import Elastic, Mechanism
from sim2reason.quantities import QUANTITIES
from sim2reason.questions.choices import at, least, only_falls, pick
from sim2reason.questions.kinds import ValueKind, drawn, kind
from sim2reason.questions.query import Query
from sim2reason.questions.study import Study
from sim2reason.questions.targets import Target, Targets
from sim2reason.questions.words import Words

FEW = 2  # forces beside weight


@kind
class StartKind(ValueKind):
    """What is an acceleration or a force at t = 0⁺, which the text does not give?"""

    name = "start"
    share = 0.25
    timeless = True

    def draw(self, study: Study, words: Words, targets: Targets, rng: np.random.Generator) -> Query | None:
        """A quantity that differs from zero before anything has moved.

        None where the text gives what can not bear on it yet, fuel or a speed that changes no equation, and where it
        is Newton's second law in one line.
        """
        moment, mechanism, here = drawn(self.moments(), study, words, rng), study.mechanism, at(study.trace, 0.0)
        if moment is None or mechanism.burns or _one_line(mechanism) or _speeds_idle(mechanism):
            return None

        def is_something(target: Target) -> bool:
            return abs(target.value(here)) > least(mechanism, QUANTITIES[target.quantity])

        target = pick([t for t in targets if QUANTITIES[t.quantity].immediate], rng, is_something)
        return Query(self.name, target, moment) if target is not None else None


def _one_line(mechanism: Mechanism) -> bool:
    """Whether nothing but weight acts, or no more than two forces act on a lone point."""
    massive = [body for body in mechanism.bodies if body.mass and not (body.parent is None and not body.coordinates)]
    alone = len(massive) == 1 and not any(massive[0].inertia) and not mechanism.contacts
    acting = (*mechanism.lines, *mechanism.forces, *mechanism.attractions)
    return only_falls(mechanism) or (alone and len(acting) <= FEW)


def _speeds_idle(mechanism: Mechanism) -> bool:
    """Whether something moves at the start, while forces hang on places alone, or on nothing."""
    if not any(coordinate.speed for coordinate in mechanism.coordinates):
        return False
    return _free(mechanism) or not changing(mechanism, start(mechanism))


def _free(mechanism: Mechanism) -> bool:
    """Whether nothing leads or rubs, and nothing but springs and attractions acts beside weight."""
    led = mechanism.constraints or mechanism.contacts or mechanism.forces or mechanism.feet
    elastic = (line.law for line in mechanism.lines if isinstance(line.law, Elastic))
    return not led and all(c.kind == "slide" for c in mechanism.coordinates) and not any(law.damping for law in elastic)
