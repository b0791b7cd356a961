"""What is worth asking about a motion."""

from collections.abc import Iterable

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.quantities import QUANTITIES
from sim2reason.quantities.subjects.bodies import axes, rides
from sim2reason.questions.targets import Target
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Trace

CLEAR = 1e-3  # of the duration: how far a time stays away from events


def pick(targets: Iterable[Target], rng: np.random.Generator) -> Target | None:
    """A target by the weight of its quantity, which all targets of that quantity share; None if there is none."""
    found = list(targets)
    if not found:
        return None
    names = [target.quantity for target in found]
    weights = np.array([QUANTITIES[name].weight / names.count(name) for name in names])
    return found[int(rng.choice(len(found), p=weights / weights.sum()))]


def apart(time: float, trace: Trace) -> bool:
    """Whether a time stays away from every event, so that before and after can not be mistaken."""
    clear = CLEAR * float(trace.state.times[-1])
    return all(abs(time - event.time) > clear for event in trace.events)


def free_bodies(mechanism: Mechanism, words: Words) -> list[str]:
    """Bodies of the text that move along one line in the room and ride on nothing."""
    return [
        n for n in mechanism.body if n in words.mentions and len(axes(mechanism, n)) == 1 and not rides(mechanism, n)
    ]


def named(text: str, mechanism: Mechanism, words: Words) -> list[str]:
    """Bodies that a sentence names."""
    return [name for name in mechanism.body if name in words.mentions and words.mentions[name] in text]
