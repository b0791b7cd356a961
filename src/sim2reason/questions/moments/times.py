"""Moments at stated times, at the start and at burn-out, and intervals without an event at their end."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import islice
from typing import Self

import numpy as np

from sim2reason.questions.choices import data_relevant_from, is_clear_of_events
from sim2reason.questions.moments import MOMENTS, Moment
from sim2reason.questions.moments.occurrence import Occurrence, Verb
from sim2reason.questions.recurrence import drift_return, first_return, rest_for_good, uniform_from
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words, round_number, rounded_as_written
from sim2reason.simulation.quantities.subjects.bodies import Bodies
from sim2reason.simulation.trace import Channel, Trace, ending


@MOMENTS.register("at_start")
@dataclass(frozen=True, slots=True)
class AtStart(Moment):
    """The moment just after the start."""

    kind = "start"
    label = "start"

    @classmethod
    def found(cls, study: SimulatedScene, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """Return the only moment of this class."""
        del study, words, rng
        return [cls()]

    @classmethod
    def parsed(cls, text: str, trace: Trace, words: Words) -> Iterator[Self]:
        """Yield the only moment of this class."""
        del text, trace, words
        yield cls()

    def time(self, trace: Trace) -> float | None:
        """Return the time of the start, zero."""
        del trace
        return 0.0

    def phrases(self, words: Words) -> tuple[str, ...]:
        """Return the phrases for the moment, such as *just after release*."""
        if words.released:
            return ("just after release", "immediately after release", "at the instant of release")
        return ("just after t = 0", "immediately after t = 0", "at t = 0")


@MOMENTS.register("all_along")
@dataclass(frozen=True, slots=True)
class AllAlong(AtStart):
    """Any time after the start, for a constant quantity, which is evaluated at the start."""

    label = "all along"

    def phrases(self, words: Words) -> tuple[str, ...]:
        """Return the phrases for the moment, such as *after release*."""
        if words.released:
            return ("after release", "after the release", "in the motion after release")
        return ("during the motion", "throughout the motion", "while the motion lasts")


EARLIEST, LATEST = 0.15, 0.95  # of the simulated interval: range of random times


@MOMENTS.register("at_time")
@dataclass(frozen=True, slots=True)
class AtTime(Moment):
    """The moment at a stated time after the start."""

    kind = "state"
    label = None

    after: float  # s, as spoken

    @classmethod
    def found(cls, study: SimulatedScene, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """Return a random time away from events and late enough for all given data to matter, rounded if possible."""
        del words
        earliest, latest = (share * study.trace.stable_until for share in (EARLIEST, LATEST))
        earliest = min(max(earliest, data_relevant_from(study.trace)), latest)
        drawn = float(rng.uniform(earliest, latest))
        moments = (cls(after) for after in (round_number(drawn, earliest, latest), rounded_as_written(drawn)))
        fitting = (m for m in moments if m.time(study.trace) is not None and is_clear_of_events(m.after, study.trace))
        return [*islice(fitting, 1)]

    @classmethod
    def parsed(cls, text: str, trace: Trace, words: Words) -> Iterator[Self]:
        """Yield a moment for every number of seconds in a sentence."""
        del trace
        return (cls(number) for number in words.find_numbers(text, "s"))

    @property
    def stated(self) -> tuple[tuple[float, str], ...]:
        """Return the time with its unit."""
        return ((self.after, "s"),)

    def having(self, numbers: Sequence[float]) -> Self:
        """Return the moment at another time."""
        return type(self)(*numbers)

    def time(self, trace: Trace) -> float | None:
        """Return the stated time, s; None after the end of the simulated motion."""
        return self.after if self.after <= trace.stable_until else None

    def phrases(self, words: Words) -> tuple[str, ...]:
        """Return the phrases for the moment, such as *0.80 s after release*."""
        if words.released:
            time = words.amount(self.after, "s")
            return (f"{time} after release", f"{time} after the release", f"{time} after the start")
        time = words.say(self.after, "s")
        return (f"at t = {time}", f"at the time t = {time}", f"at the instant t = {time}")

    def stretches(self, words: Words) -> tuple[str, ...]:
        """Return the phrases for the interval up to that time, such as *in the first 0.80 s after release*."""
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


@MOMENTS.register("whole_motion")
@dataclass(frozen=True, slots=True)
class WholeMotion(Moment):
    """The end of the first period of a motion, or the time from which everything is at rest for good.

    For quantities that do not depend on positions, it is also the time from which all motion is uniform. A motion that
    `ends` may also end with the simulation. Recipes only ask about periodic motions.
    """

    kind = "extremum"
    label = "whole motion"

    drifts: bool = False  # whether it may end elsewhere: for what does not depend on the place
    ends: bool = True  # whether it may end at all, and not only repeat itself

    @classmethod
    def found(cls, study: SimulatedScene, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """Return the whole motion if it is periodic, even if each period begins at another place; else nothing."""
        del words, rng
        if study.time(cls(ends=False)) is not None:
            return [cls()]
        return [cls(drifts=True)] if study.time(cls(drifts=True, ends=False)) is not None else []

    @classmethod
    def parsed(cls, text: str, trace: Trace, words: Words) -> Iterator[Self]:
        """Yield the whole motion, also as one that repeats at another place if it does so; the text is ignored."""
        del text, words
        if cls(ends=False).time(trace) is None and cls(drifts=True, ends=False).time(trace) is not None:
            yield cls(drifts=True)
        yield cls()

    @property
    def requires_return(self) -> bool:
        """Return True, as the initial state must recur."""
        return True

    def time(self, trace: Trace) -> float | None:
        """Return the end of the first period, s, or the time of permanent rest; None if neither is known."""
        time = self._return_time(trace)
        if time is not None or not self.ends:
            return time
        if trace.cut:
            return trace.stable_until
        rest = rest_for_good(trace)
        return uniform_from(trace) if rest is None and self.drifts else rest

    def _return_time(self, trace: Trace) -> float | None:
        time = first_return(trace)
        return drift_return(trace) if time is None and self.drifts else time

    def told(self, trace: Trace) -> str:
        """Return a note on the duration, such as *over the whole motion, to rest at 10.2041 s*."""
        until, unit = self.time(trace), trace.mechanism.units.time
        if until is None:
            return ""
        if self._return_time(trace) is not None:
            return f"over the whole motion, which repeats itself every {until:.6g} {unit}"
        if trace.cut:
            return f"over the whole motion, to {until:.6g} {unit}, where its description ends: {ending(trace)}"
        if rest_for_good(trace) is None:
            return f"over the whole motion, which is uniform from {until:.6g} {unit} on"
        return f"over the whole motion, to rest at {until:.6g} {unit}"

    def phrases(self, words: Words) -> tuple[str, ...]:
        """Return the phrases for the moment, such as *in the motion that follows*."""
        del words
        return ("in the motion that follows", "during the motion that follows", "in the course of the motion")


@MOMENTS.register("burned_out")
@dataclass(frozen=True, slots=True)
class BurnedOut(Occurrence):
    """Burn-out: the instant at which all fuel is used up."""

    label = "burn-out"
    own = True
    kinds = ("burn-out",)
    of = Bodies()
    most = 0
    verb = Verb("runs out of fuel", "run out of fuel")

    def phrases(self, words: Words) -> tuple[str, ...]:
        """Return the phrases for the moment, such as *when the rocket runs out of fuel*."""
        rocket = self.subject(words)
        return (
            f"when {rocket} has burnt all its fuel",
            f"when {rocket} runs out of fuel",
            f"at the moment when {rocket} has used up its fuel",
        )

    @property
    def revealed_channels(self) -> tuple[Channel, ...]:
        """Return the channel of the body's mass, which the text gives."""
        return (Channel(self.name, "mass"),)

    def is_plain(self, study: SimulatedScene) -> bool:
        """Return True: the fuel mass divided by the burn rate is the time, which needs no physics."""
        del study
        return True
