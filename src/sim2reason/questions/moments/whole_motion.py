"""The end of a whole motion: of its first period, its last movement, or its description."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from sim2reason.questions.moments import MOMENTS, Moment
from sim2reason.questions.recurrence import drift_return, first_return, rest_for_good, uniform_from
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Trace, ending


@MOMENTS.register("whole_motion")
@dataclass(frozen=True, slots=True)
class WholeMotion(Moment):
    """The end of the first period of a motion, or the instant from which all is at rest for good.

    For quantities that do not depend on positions, it is also the instant from which all moves uniformly for ever.
    A motion that `ends` may also end where its description does. Recipes only ask about one that repeats itself.
    """

    kind = "extremum"
    label = "whole motion"

    drifts: bool = False  # whether it may end elsewhere: for what does not depend on the place
    ends: bool = True  # whether it may end at all, and not only repeat itself

    @classmethod
    def found(cls, study: Study, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """Return the whole motion if it repeats itself, in place or displaced; else nothing."""
        del words, rng
        if study.time(cls(ends=False)) is not None:
            return [cls()]
        return [cls(drifts=True)] if study.time(cls(drifts=True, ends=False)) is not None else []

    @classmethod
    def parsed(cls, text: str, trace: Trace, words: Words) -> Iterator[Self]:
        """Yield the whole motion, which no word names; before it that with drift, if only that repeats itself."""
        del text, words
        if cls(ends=False).time(trace) is None and cls(drifts=True, ends=False).time(trace) is not None:
            yield cls(drifts=True)
        yield cls()

    @property
    def comes_round(self) -> bool:
        """All must be as it was."""
        return True

    def time(self, trace: Trace) -> float | None:
        """Return the end of the first period, s, or else of the motion; None if neither is known."""
        time = self._return(trace)
        if time is not None or not self.ends:
            return time
        if trace.cut:
            return trace.stable_until
        rest = rest_for_good(trace)
        return uniform_from(trace) if rest is None and self.drifts else rest

    def _return(self, trace: Trace) -> float | None:
        time = first_return(trace)
        return drift_return(trace) if time is None and self.drifts else time

    def told(self, trace: Trace) -> str:
        """Say how long the motion is, as in: over the whole motion, to rest at 10.2041 s."""
        until, unit = self.time(trace), trace.mechanism.units.time
        if until is None:
            return ""
        if self._return(trace) is not None:
            return f"over the whole motion, which repeats itself every {until:.6g} {unit}"
        if trace.cut:
            return f"over the whole motion, to {until:.6g} {unit}, where its description ends: {ending(trace)}"
        if rest_for_good(trace) is None:
            return f"over the whole motion, which is uniform from {until:.6g} {unit} on"
        return f"over the whole motion, to rest at {until:.6g} {unit}"

    def phrases(self, words: Words) -> tuple[str, ...]:
        """As in: in the motion that follows."""
        del words
        return ("in the motion that follows", "during the motion that follows", "in the course of the motion")
