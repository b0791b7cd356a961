"""Drops a question about bodies that may collide, asked before anything has."""

from collections.abc import Iterator

from sim2reason.filters import FILTERS, Candidate, Filter
from sim2reason.questions.choices import has_met

SHOWN = 5  # collisions


class Collision(Filter):
    """Something may collide, but nothing has when the question is asked, so that the collision has no bearing."""

    order = 1

    def reason(self, candidate: Candidate) -> str:
        """A collision must come before the moment, or be what has just happened."""
        time, moment = candidate.time, candidate.question.query.moment
        just_after = moment is not None and bool(moment.sided)
        met = time is None or has_met(candidate.study.trace, time, just_after=just_after)
        return "" if met else "nothing has collided before"

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """When the first collisions are."""
        hits = [event for event in candidate.study.trace.events if event.kind == "collision"]
        yield from (f"{' and '.join(hit.subjects)} collide at {hit.time:.4g} s" for hit in hits[:SHOWN])


FILTERS.add("collision", Collision())
