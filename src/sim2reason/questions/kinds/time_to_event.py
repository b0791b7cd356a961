"""When does something happen for the first time?"""

import numpy as np

from sim2reason.questions import KINDS, Query, Target, Words
from sim2reason.questions.choices import happenings
from sim2reason.questions.moments import Collided, Moved, Stopped, pair, say_metres
from sim2reason.simulation.trace import Trace


class TimeToEventKind:
    """The time from the start to an event."""

    def draw(self, trace: Trace, words: Words, targets: dict[str, Target], rng: np.random.Generator) -> Query | None:
        """An event of this motion."""
        del targets
        found = [m for m in happenings(trace, words, rng) if not isinstance(m, Collided) or m.after]
        return Query("time_to_event", None, found[int(rng.integers(len(found)))]) if found else None

    def shapes(self, ask: Query, words: Words, noun: str) -> tuple[str, ...]:
        """As in: how long after release is B first 0.50 m from its starting point?"""
        del noun
        since = "release" if words.released else "t = 0"
        match ask.moment:
            case Moved(body, distance):
                there = f"first {say_metres(distance)} from its starting point"
                return _shapes(since, "is", words.mentions[body], there, f"{words.mentions[body]} is {there}")
            case Collided(a, b, _):
                both = pair(words.mentions[a], words.mentions[b])
                return _shapes(since, "do", both, "first collide", f"{both} first collide")
            case Stopped(body):
                name = words.mentions[body]
                return _shapes(since, "does", name, "first come to rest", f"{name} first comes to rest")
            case _:
                return ()


def _shapes(since: str, verb: str, subject: str, happens: str, clause: str) -> tuple[str, ...]:
    return (
        f"how long after {since} {verb} {subject} {happens}?",
        f"what time passes from {since} until {clause}?",
        f"find the time from {since} until {clause}.",
        f"what is the time from {since} until {clause}?",
        f"determine how long after {since} {clause}.",
    )


KINDS.add("time_to_event", TimeToEventKind())
