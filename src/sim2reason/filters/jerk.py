"""Drops a question that hangs on how a string becomes taut again, of which the text says nothing."""

from sim2reason.filters import FILTERS, Candidate, Filter
from sim2reason.simulation.trace import happened


class Jerk(Filter):
    """A slack string becomes taut again before the moment, with a jerk: what it takes from the motion must be told.

    Engines take the velocity along the string. Texts say so of entities whose strings are expected to go slack.
    """

    order = 2

    def reason(self, candidate: Candidate) -> str:
        """Look for strings that become taut before the moment, or before the end of what is followed."""
        study = candidate.study
        time = candidate.time if candidate.time is not None else study.trace.stable_until
        told = {named.name for named in study.scene.entities if named.entity.slackens}
        again = (event for event in happened(study.trace.events, time) if event.kind == "taut")
        lines = (line for event in again for line in event.subjects)
        return next((f"{line} becomes taut again" for line in lines if line.partition(".")[0] not in told), "")


FILTERS.add("jerk", Jerk())
