"""Drops a question about bodies that may collide, asked before anything has."""

from sim2reason.filters import FILTERS, Candidate

AT_ONCE = 1e-9  # of the time


class Collision:
    """Something may collide, but nothing has when the question is asked, so that the collision has no bearing."""

    needs_witness = False
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


FILTERS.add("collision", Collision())
