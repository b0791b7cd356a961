"""Drops a question whose answer only one engine vouches for."""

from sim2reason.filters import FILTERS, Candidate
from sim2reason.questions.moments import Collided, Moved, Stopped
from sim2reason.simulation.channels import Channel


class Agreement:
    """The two engines part, on what is asked or on what happens before it."""

    needs_witness = True
    order = 0

    def reason(self, candidate: Candidate) -> str:
        """The asked channel must be certified at the asked moment; at an event, up to and beyond it."""
        certificate, ask = candidate.certificate, candidate.question.ask
        time = ask.time(candidate.trace)
        if certificate is None or time is None:
            return "the engines do not agree that the moment comes"
        if time >= certificate.stable_until and time > 0.0:
            return certificate.reason or "the moment comes after the certified stretch"
        if isinstance(ask.moment, Moved) and not certificate.covers(Channel(ask.moment.body, "displacement"), time):
            return "the engines disagree on how far the body gets"
        if ask.target is None:
            return ""
        channel = Channel(ask.target.subject, ask.target.quantity)
        if isinstance(ask.moment, Collided | Stopped):  # the samples right at an event are not compared
            return "" if certificate.until.get(channel, -1.0) > time else "the engines disagree on what is asked"
        return "" if certificate.covers(channel, time) else "the engines disagree on what is asked"


FILTERS.add("agreement", Agreement())
