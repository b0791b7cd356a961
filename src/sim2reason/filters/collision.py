"""Drops a question about bodies that may collide: before anything has, before all that is said bears, or long after."""

from collections.abc import Iterator

from sim2reason.filters import FILTERS, Candidate, Filter
from sim2reason.questions.choices import AT_ONCE, has_met
from sim2reason.recipes import Difficulty
from sim2reason.simulation.trace import Trace

SHOWN = 5  # collisions
MOST: dict[Difficulty, int] = {"easy": 5, "medium": 8, "hard": 12}  # that one has to follow, unless they are counted


class Collision(Filter):
    """Something may collide, but nothing has when the question is asked, so that the collision has no bearing.

    Or where pairs have a restitution of their own, only these have collided: that of *all others* has no bearing. Or
    more collisions come before than anybody would follow.
    """

    order = 1

    def reason(self, candidate: Candidate) -> str:
        """A collision must come before the moment, or be what has just happened; and one of every restitution."""
        time, moment = candidate.time, candidate.question.query.moment
        just_after = moment is not None and bool(moment.sided)
        met = time is None or has_met(candidate.study.trace, time, just_after=just_after)
        if not met:
            return "nothing has collided before"
        if time is not None and not _all_bear(candidate.study.trace, time):
            return "restitution: that of some pairs has no bearing"
        hits = sum(kind == "collision" for kind, _ in candidate.study.trace.story(0.0 if time is None else time))
        if hits > MOST[candidate.difficulty] and not candidate.kind.measured(candidate.question.query).whole:
            return f"many: {hits} collisions"
        return ""

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """When the first collisions are."""
        hits = [event for event in candidate.study.trace.events if event.kind == "collision"]
        yield from (f"{' and '.join(hit.subjects)} collide at {hit.time:.4g} s" for hit in hits[:SHOWN])


def _all_bear(trace: Trace, time: float) -> bool:
    """Whether there has been a collision, up to a time, of every restitution that pairs have."""
    told = {frozenset(meeting.names): meeting.restitution for meeting in trace.mechanism.meetings}
    if len(set(told.values())) == 1:
        return True
    hits = (event for event in trace.events if event.kind == "collision" and event.time <= time * (1.0 + AT_ONCE))
    return {told.get(frozenset(hit.subjects)) for hit in hits} >= {*told.values()}


FILTERS.add("collision", Collision())
