"""Reasons why an answer is not certified although two engines agree."""

from collections.abc import Iterable

from sim2reason.questions.moments import Moment
from sim2reason.simulation.certify import Certificate
from sim2reason.simulation.channels import Channel


def certification_gap(
    certificate: Certificate | None, time: float | None, moment: Moment | None, asked: Iterable[Channel]
) -> str:
    """Return why `asked` channels are not certified from the start to a time, s, or at a moment; empty if they are.

    Channels are compared at all samples up to there; at an event up to and beyond it.
    """
    if certificate is None or time is None:
        return "the engines do not agree that the moment comes"
    at_event = moment is not None and moment.event
    if time >= certificate.stable_until and time > 0.0 and not (at_event and _seen_by_both(certificate, time)):
        return certificate.reason or "the moment comes after the certified stretch"
    for channel in moment.channels if moment is not None else ():
        if not _agreed(certificate, channel, time, at_event=at_event):
            return f"the engines disagree on the {channel.quantity} that the moment hangs on"
    agreed = all(_agreed(certificate, channel, time, at_event=at_event) for channel in asked)
    return "" if agreed else "the engines disagree on what is asked"


def _seen_by_both(certificate: Certificate, time: float) -> bool:
    """Return whether the event at a time, s, is among those that both engines recorded."""
    return any(match.event.time == time for match in certificate.matched)


def _agreed(certificate: Certificate, channel: Channel, time: float, *, at_event: bool) -> bool:
    """Return whether both engines agree on a channel up to a time, s; samples at an event itself are not compared."""
    if not at_event:
        return certificate.covers(channel, time)
    until = certificate.trusted(channel)
    return until > time or (_seen_by_both(certificate, time) and until >= certificate.stable_until)
