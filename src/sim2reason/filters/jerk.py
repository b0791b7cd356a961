"""Drops a question that hangs on how a string becomes taut again, of which the text says nothing."""

from collections.abc import Iterator

from sim2reason.filters import FILTERS, Candidate, Filter
from sim2reason.simulation.trace import happened


class Jerk(Filter):
    """A slack string becomes taut again before the moment, with a jerk: what it takes from the motion must be told.

    Engines take the velocity along the string. Texts say so of entities whose strings are expected to go slack.
    """

    order = 2

    def reason(self, candidate: Candidate) -> str:
        """Look for strings that become taut before the moment, or before the end of what is followed."""
        told = {named.name for named in candidate.study.scene.entities if named.entity.slackens}
        lines = (line for _, line in _again(candidate))
        return next((f"{line} becomes taut again" for line in lines if line.partition(".")[0] not in told), "")

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """When strings become taut again, or until when none does."""
        if not candidate.study.mechanism.strings:
            return
        again = [f"{line} becomes taut again at {time:.4g} s" for time, line in _again(candidate)]
        yield from again or [f"until {_end(candidate):.4g} s no string becomes taut again"]


def _end(candidate: Candidate) -> float:
    """The moment, or the end of what is followed, s."""
    return candidate.time if candidate.time is not None else candidate.study.trace.stable_until


def _again(candidate: Candidate) -> Iterator[tuple[float, str]]:
    """The strings that become taut again before that, with the times, s."""
    for event in happened(candidate.study.trace.events, _end(candidate)):
        if event.kind == "taut":
            yield from ((event.time, line) for line in event.subjects)


FILTERS.add("jerk", Jerk())
