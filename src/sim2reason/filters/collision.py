"""Drops a question about bodies that may collide, asked before anything has."""

from collections.abc import Iterator

from sim2reason.filters import FILTERS, Candidate, Filter

AT_ONCE = 1e-9  # of the time
SHOWN = 5  # collisions


class Collision(Filter):
    """Something may collide, but nothing has when the question is asked, so that the collision has no bearing."""

    order = 1

    def reason(self, candidate: Candidate) -> str:
        """A collision must come before the moment, or be what has just happened."""
        time, trace, moment = candidate.time, candidate.study.trace, candidate.question.query.moment
        if time is None or not candidate.study.mechanism.meetings:
            return ""
        just_after = moment is not None and moment.sided
        end = time * (1.0 + (AT_ONCE if just_after else -AT_ONCE))
        hit = any(event.kind == "collision" and event.time <= end for event in trace.events)
        return "" if hit else "nothing has collided before"

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """When the first collisions are."""
        hits = [event for event in candidate.study.trace.events if event.kind == "collision"]
        yield from (f"{' and '.join(hit.subjects)} collide at {hit.time:.4g} s" for hit in hits[:SHOWN])


FILTERS.add("collision", Collision())
