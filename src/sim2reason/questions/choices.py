"""What is worth asking about a motion."""

from collections.abc import Mapping

import numpy as np

from sim2reason.quantities import QUANTITIES
from sim2reason.questions import Moment, Target, Words
from sim2reason.questions.moments import Collided, Moved, Stopped, spoken
from sim2reason.questions.targets import axes, rides
from sim2reason.simulation.trace import Trace

CLEAR = 1e-3  # of the duration: how far a time stays away from events
AT_ONCE = frozenset({"acceleration", "net force", "tension", "normal force", "friction force"})
WEIGHTS = {"velocity": 3.0, "displacement": 2.0, "acceleration": 2.0, "tension": 3.0}  # what a person would ask
FARTHEST = 0.9  # of how far a body gets
LONG = 3.0  # m; strings are not longer


def pick(targets: Mapping[str, Target], rng: np.random.Generator) -> Target | None:
    """A target, those that a person would ask about more often than others."""
    if not targets:
        return None
    found = list(targets.values())
    names = [target.quantity for target in found]
    weights = np.array([WEIGHTS.get(name, 1.0) / names.count(name) for name in names])
    return found[int(rng.choice(len(found), p=weights / weights.sum()))]


def immediate(targets: Mapping[str, Target]) -> dict[str, Target]:
    """What differs from zero at once."""
    return {phrase: target for phrase, target in targets.items() if target.quantity in AT_ONCE}


def apart(time: float, trace: Trace) -> bool:
    """Whether a time stays away from every event, so that before and after can not be mistaken."""
    clear = CLEAR * float(trace.state.times[-1])
    return all(abs(time - event.time) > clear for event in trace.events)


def happenings(trace: Trace, words: Words, rng: np.random.Generator) -> list[Moment]:
    """What happens while the motion is described, with a drawn distance for one body that gets somewhere."""
    found: list[Moment] = []
    for event in trace.events:
        if event.time >= trace.stable_until or event.time == 0.0:
            continue
        if event.kind == "collision" and all(name in words.mentions for name in event.subjects):
            a, b = event.subjects[0], event.subjects[1]
            found.extend(m for m in (Collided(a, b, after=True), Collided(a, b, after=False)) if m not in found)
    found.extend(Stopped(name) for name in _free(trace, words) if Stopped(name).time(trace) is not None)
    moved = _moved(trace, words, rng)
    return found if moved is None else [*found, moved]


def _free(trace: Trace, words: Words) -> list[str]:
    """Bodies of the text that move along one line in the room and ride on nothing."""
    mechanism = trace.mechanism
    return [
        n for n in mechanism.body if n in words.mentions and len(axes(mechanism, n)) == 1 and not rides(mechanism, n)
    ]


def _moved(trace: Trace, words: Words, rng: np.random.Generator) -> Moved | None:
    names = _free(trace, words)
    if not names:
        return None
    name = names[int(rng.integers(len(names)))]
    state = trace.sample(np.linspace(0.0, trace.stable_until, 17))
    reached = float(np.linalg.norm(QUANTITIES["displacement"].evaluate(state, name), axis=1).max())
    distance = rng.uniform(0.2, FARTHEST) * min(reached, LONG)
    if distance < 0.01:
        return None
    moment = Moved(name, spoken(distance))
    time = moment.time(trace)
    return moment if time is not None and apart(time, trace) else None
