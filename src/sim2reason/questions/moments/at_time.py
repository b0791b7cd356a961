"""A stated time after the start."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import islice
from typing import Self

import numpy as np

from sim2reason.questions.choices import apart, bears_from
from sim2reason.questions.moments import MOMENTS, Moment
from sim2reason.questions.spoken import round_number, spoken
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Trace

EARLIEST, LATEST = 0.15, 0.95  # of the stretch that can be asked about


@MOMENTS.register("at_time")
@dataclass(frozen=True, slots=True)
class AtTime(Moment):
    """A stated time after the start."""

    kind = "state"
    label = None

    after: float  # s, as spoken

    @classmethod
    def found(cls, study: Study, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """A time away from events and not before all that the text gives can bear: a round number if there is one."""
        del words
        earliest, latest = (share * study.trace.stable_until for share in (EARLIEST, LATEST))
        earliest = min(max(earliest, bears_from(study.trace)), latest)
        drawn = float(rng.uniform(earliest, latest))
        moments = (cls(after) for after in (round_number(drawn, earliest, latest), spoken(drawn)))
        fitting = (m for m in moments if m.time(study.trace) is not None and apart(m.after, study.trace))
        return [*islice(fitting, 1)]

    @classmethod
    def parsed(cls, text: str, trace: Trace, words: Words) -> Iterator[Self]:
        """Every number of seconds."""
        del trace
        return (cls(number) for number in words.heard(text, "s"))

    @property
    def stated(self) -> tuple[tuple[float, str], ...]:
        """The time."""
        return ((self.after, "s"),)

    def having(self, numbers: Sequence[float]) -> Self:
        """At another time."""
        return type(self)(*numbers)

    def time(self, trace: Trace) -> float | None:
        """The time itself, while the motion is described."""
        return self.after if self.after <= trace.stable_until else None

    def phrases(self, words: Words) -> tuple[str, ...]:
        """As in: 0.80 s after release."""
        if words.released:
            time = words.amount(self.after, "s")
            return (f"{time} after release", f"{time} after the release", f"{time} after the start")
        time = words.say(self.after, "s")
        return (f"at t = {time}", f"at the time t = {time}", f"at the instant t = {time}")

    def stretches(self, words: Words) -> tuple[str, ...]:
        """As in: in the first 0.80 s after release."""
        time, later = words.say(self.after, "s"), words.amount(self.after, "s")
        if words.released and later != time:
            return (f"between release and {later} later", f"from release until {later} later")
        if words.released:
            return (
                f"in the first {time} after release",
                f"during the first {time} after release",
                f"during the first {time}",
            )
        return (
            f"between t = 0 and t = {time}",
            f"from t = 0 to t = {time}",
            f"in the interval from t = 0 to t = {time}",
        )
