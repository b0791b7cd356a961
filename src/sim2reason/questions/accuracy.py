"""Accuracy of answers: their tolerance, the rounding of stated results, and their certification."""

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cache
from math import floor, log10
from typing import Self

from sim2reason.questions.moments import Moment
from sim2reason.scenes.dsl.measures import join_unit
from sim2reason.simulation.certify import Certificate
from sim2reason.simulation.trace import Channel

TOLERANCE = 0.05
"""The relative error that an answer may have, by default: that of the paper."""
MIN_TOLERANCE = 0.005
"""The smallest one that is of use: answers are asked for to three digits."""
CLEAR_ERROR_FACTOR = 1.2  # of the tolerance: larger errors are clearly incorrect


def out_of_range(tolerance: float) -> str:
    """Return why a relative tolerance is invalid; empty if it is valid."""
    if MIN_TOLERANCE <= tolerance <= TOLERANCE:
        return ""
    return f"{tolerance!r} is none; give a number from {MIN_TOLERANCE} to {TOLERANCE}"


SMALLEST, LARGEST = -3, 4  # powers of ten between which a number needs no scientific notation
MINUS = "\N{MINUS SIGN}"


@dataclass(frozen=True, slots=True)
class StatedResult:
    """A number as the text states it, with its unit."""

    digits: str
    unit: str

    @classmethod
    def rounded(cls, value: float, unit: str, digits: int) -> Self | None:
        """Return a number rounded to significant digits; None if it would need scientific notation."""
        power = floor(log10(abs(float(f"{value:.{digits - 1}e}")))) if value else LARGEST + 1
        if not SMALLEST <= power <= LARGEST:
            return None
        places = digits - 1 - power
        return cls(f"{round(value, places):.{max(0, places)}f}".replace("-", MINUS), unit)

    @classmethod
    def find_in_text(cls, text: str, unit: str) -> Iterator[Self]:
        """Return all numbers with a given unit in a text."""
        return (cls(number, unit) for number in _number(unit).findall(text))

    @property
    def value(self) -> float:
        """Return the number as a float."""
        return float(self.digits.replace(MINUS, "-"))

    @property
    def half(self) -> float:
        """Return the largest rounding error that the digits imply; in large integers, only three digits count."""
        integer_part, _, decimals = self.digits.removeprefix(MINUS).partition(".")
        return 0.5 * 10.0 ** (-len(decimals) if decimals else max(0, len(integer_part) - 3))

    @property
    def text(self) -> str:
        """Return the number with its unit."""
        return join_unit(self.digits, self.unit)


@cache
def _number(unit: str) -> re.Pattern[str]:
    """Return a pattern for a number with its unit or, without a unit, one followed by no letter."""
    shown = join_unit("", unit)
    return re.compile(rf"(?<![\w.])({MINUS}?\d{{1,5}}(?:\.\d{{1,6}})?){re.escape(shown)}(?![\w/]|\.\d)")


def certification_gap(
    certificate: Certificate | None, time: float | None, moment: Moment | None, channels: Iterable[Channel]
) -> str:
    """Return why `channels` channels are not certified from the start to a time, s, or at a moment; empty if they are.

    Channels are compared at all samples up to there; at an event up to and beyond it.
    """
    if certificate is None or time is None:
        return "the engines do not agree that the moment comes"
    at_event = moment is not None and moment.event
    if time >= certificate.stable_until and time > 0.0 and not (at_event and _seen_by_both(certificate, time)):
        return certificate.reason or "the moment comes after the certified stretch"
    for channel in moment.channels if moment is not None else ():
        if not _engines_agree(certificate, channel, time, at_event=at_event):
            return f"the engines disagree on the {channel.quantity} that the moment hangs on"
    agreed = all(_engines_agree(certificate, channel, time, at_event=at_event) for channel in channels)
    return "" if agreed else "the engines disagree on what is asked"


def _seen_by_both(certificate: Certificate, time: float) -> bool:
    """Return whether the event at a time, s, is among those that both engines recorded."""
    return any(match.event.time == time for match in certificate.matched)


def _engines_agree(certificate: Certificate, channel: Channel, time: float, *, at_event: bool) -> bool:
    """Return whether both engines agree on a channel up to a time, s; samples at an event itself are not compared."""
    if not at_event:
        return certificate.covers(channel, time)
    until = certificate.trusted(channel)
    return until > time or (_seen_by_both(certificate, time) and until >= certificate.stable_until)
