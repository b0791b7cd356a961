"""Assumptions about events: collisions, slipping, the burn-out of engines and the lift-off of rockets."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import groupby, product
from math import inf
from typing import Self

import numpy as np

from sim2reason.questions.moments.bounces import GROUND, WALL, obstacle_phrase
from sim2reason.questions.moments.occurrence import slip_velocity
from sim2reason.questions.regimes import REGIMES, Regime
from sim2reason.questions.regimes.directions import CLEAR_SHARE, OPPOSITE, MovesOneWay, starts_evenly
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import Mechanism, Prop
from sim2reason.scenes.dsl.template import COUNT_WORDS
from sim2reason.simulation.quantities.kinematics import Acceleration, Velocity
from sim2reason.simulation.quantities.subjects.bodies import RIGHT, Bodies
from sim2reason.simulation.quantities.subjects.interactions import PAIR_SEPARATOR, Contacts, Pairs
from sim2reason.text.prose.phrases import join

MAX_COLLISIONS = 3  # greatest number of collisions in a clause
MAX_ORDERS = 100  # greatest number of sequences; if there are more, only shorter ones are considered


@REGIMES.register("collisions")
@dataclass(frozen=True, slots=True)
class CollideInTurn(Regime):
    """The assumption that exactly the given collisions occur, in the given order, before the moment of the question."""

    of = Pairs()
    stage = 2

    order: tuple[tuple[str, ...], ...]  # the bodies of each; one body alone meets what is fixed

    @classmethod
    def possible(cls, study: SimulatedScene, words: Words) -> Sequence[Self]:
        """Return one regime for each short sequence of possible collisions between bodies that the text can name."""
        met = [names for names in _meetings(study.mechanism) if _said(names, words)]
        lengths = [n for n in range(MAX_COLLISIONS + 1) if len(met) ** n <= MAX_ORDERS] if met else []
        return [cls("", order) for n in lengths for order in product(met, repeat=n)]

    def holds(self, study: SimulatedScene, until: float) -> bool:
        """Return whether exactly the assumed collisions, in the assumed order, occur before a time, s."""
        came = [subjects for kind, subjects in study.trace.story(until) if kind == "collision"]
        return [*map(set, came)] == [*map(set, self.order)]

    def never_holds(self, study: SimulatedScene) -> bool:
        """Return whether the collisions of a motion begin otherwise than assumed."""
        came = [event.subjects for event in study.trace.events if event.kind == "collision"]
        return any(set(met) != set(names) for met, names in zip(came, self.order, strict=False))

    def must_be_stated(self, study: SimulatedScene) -> bool:
        """Return True if several collisions are possible or two bodies collide: formulas do not show which ones."""
        return len(_meetings(study.mechanism)) > 1 or any(len(names) > 1 for names in self.order)

    def clause(self, words: Words) -> str:
        """Return a clause such as *the only collision before then is between balls A and B*."""
        phrases = [_said(names, words) for names in self.order]
        if not phrases:
            return "there is no collision before then"
        if len(phrases) == 1:
            lone = (
                words.subject_phrases(Pairs()).get(PAIR_SEPARATOR.join(self.order[0]))
                if len(_meetings(words.mechanism)) == 1
                else None
            )
            return f"{lone} have collided by then" if lone else f"the only collision before then is {phrases[0]}"
        if len(set(phrases)) == 1:
            return f"there are exactly {COUNT_WORDS[len(phrases)]} collisions before then, each {phrases[0]}"
        return f"the only collisions before then are, in this order, {join(phrases)}"


def _meetings(mechanism: Mechanism) -> list[tuple[str, ...]]:
    """Return the pairs of bodies that can collide, and the single ones that can hit a fixed obstacle."""
    return list(dict.fromkeys(meeting.names for meeting in mechanism.meetings))


def _said(names: Sequence[str], words: Words) -> str:
    """Return the phrase for the partners of a collision; empty if the text has no unique one."""
    if len(names) > 1:
        pair_phrase = words.subject_phrases(Pairs()).get(PAIR_SEPARATOR.join(names), "")
        return pair_phrase and f"between {pair_phrase}"
    (name,) = names
    what = obstacle_phrase(words, name)
    return f"between {words.mentions[name]} and {what}" if what in (GROUND, WALL) else ""


REST_SPEED = 1e-9  # m/s
LEVEL_RTOL = 1e-9  # of the steepness of a direction: smaller values are level
MIN_INTERVAL_FRACTION = 1e-9  # of the time asked about: shorter intervals are rounding
SlipSigns = tuple[int, ...]
"""1 and -1: a stretch of the one way and of the other, as the slip counts."""
SLIP_COURSES: tuple[SlipSigns, ...] = ((1,), (-1,), (1, -1), (-1, 1))
SLIDE_ONSET_FRACTION = 1e-3  # of the time asked about, or s: time in which a released body begins to slide


@REGIMES.register("sliding")
@dataclass(frozen=True, slots=True)
class SlidesThroughout(Regime):
    """The assumption that a body slides on a rough face from the start on, or never does.

    A body whose direction is in words turns back at most once.
    """

    of = Contacts()
    unseen = True

    slides: bool
    course: SlipSigns = ()  # its ways one after the other, where words tell them

    @classmethod
    def possible(cls, study: SimulatedScene, words: Words) -> Sequence[Self]:
        """Return, for each body on a rough face, a regime of sticking and one of sliding per sequence of directions."""
        mechanism = study.mechanism
        rough = [name for name in words.subject_phrases(cls.of) if mechanism.contacts[name].friction > 0.0]
        slides = [
            cls(name, slides=True, course=course)
            for name in rough
            for course in (SLIP_COURSES if _slip_direction_words(mechanism, name) else [()])
        ]
        return [*slides, *(cls(name, slides=False) for name in rough)]

    def holds(self, study: SimulatedScene, until: float) -> bool:
        """Return whether the body slides, or sticks, throughout."""
        observed = _slides(study, self.name, until)
        return observed[0] is self.slides and (
            observed[1] == self.course or not _slip_direction_words(study.mechanism, self.name)
        )

    def never_holds(self, study: SimulatedScene) -> bool:
        """Return whether the body clearly begins otherwise: at rest, sliding, or sliding in another direction."""
        early = max(CLEAR_SHARE * study.trace.stable_until, _soon(study, 0.0))
        if not starts_evenly(study, early):
            return False
        first, then = (float(slip_velocity(study.trace.at(time), self.name)[0]) for time in (0.0, early))
        if max(abs(first), abs(then)) <= REST_SPEED:
            return self.slides
        if abs(then) <= REST_SPEED or first * then < 0.0:
            return False
        if not self.slides:
            return abs(first) > REST_SPEED
        words = _slip_direction_words(study.mechanism, self.name)
        return bool(words) and self.course[:1] != (1 if then > 0.0 else -1,)

    def margin(self, study: SimulatedScene, until: float) -> float | None:
        """Return the slip velocity at a time, s, or soon after the start, relative to free fall; None for sticking."""
        if not self.slides:
            return None
        end = max(_soon(study, until), until)
        slip = float(slip_velocity(study.trace.at(end), self.name)[0])
        size = self.course[-1] * slip if self.course else abs(slip)
        return size / ((float(np.linalg.norm(study.mechanism.gravity)) * end) or 1.0)

    def clause(self, words: Words) -> str:
        """Return a clause such as *block A slides to the right on the plank*.

        A body that is not released from rest *keeps sliding*. A body that turns back has done so by the end: *block A
        first slides up the slope, turns back once and is sliding down it by then*. A rolling body only reverses its
        slip.
        """
        surface, called = words.fills(self.of, self.name)["surface"], words.subject_phrases(self.of)[self.name]
        rolls = len(words.mechanism.contacts[self.name].slip) > 1
        if not self.slides:
            return f"{called} rolls without slipping" if rolls else f"{called} does not slide on {surface}"
        ways = [_slip_direction_words(words.mechanism, self.name)[sign] for sign in self.course]
        where = f"{ways[0] if ways else 'on'} {surface}{' at the point of contact' * bool(rolls and ways)}"
        slides, sliding = ("slips", "slipping") if rolls else ("slides", "sliding")
        if len(ways) > 1:
            turned = "its slip reverses once, and it" if rolls else "turns back once and"
            return f"{called} first {slides} {where}, {turned} is {sliding} {ways[-1]} it by then"
        return f"{called} {slides if words.released else f'keeps {sliding}'} {where}"


def _slip_direction_words(mechanism: Mechanism, name: str) -> dict[int, str]:
    """Return the words for the directions of a body's slip by sign; empty if the text has none."""
    slides = [
        (slide, factor)
        for coordinate, factor in mechanism.contacts[name].slip
        if (slide := mechanism.coordinates[mechanism.number[coordinate]]).kind == "slide"
    ]
    if len(slides) != 1:
        return {}
    slide, factor = slides[0]
    steepness = factor * slide.axis[2]
    if abs(steepness) > LEVEL_RTOL:
        return {1: "up", -1: "down"} if steepness > 0.0 else {1: "down", -1: "up"}
    if slide.label != RIGHT:
        return {}
    ahead, back = (f"to the {side} on" for side in (RIGHT, OPPOSITE[RIGHT]))
    return {1: ahead, -1: back} if factor > 0.0 else {1: back, -1: ahead}


def _slides(study: SimulatedScene, name: str, until: float) -> tuple[bool | None, SlipSigns]:
    """Return whether the body slides throughout, None if only for a time; and its sequence of directions."""
    soon = _soon(study, until)
    scan = study.trace.scan
    within = (scan.times > soon) & (scan.times < until)
    end = max(soon, until)
    times = np.concatenate([[soon], scan.times[within], [end]])
    first, last = (slip_velocity(study.trace.at(time), name) for time in (soon, end))
    slips = np.concatenate([first, slip_velocity(scan, name)[within], last])
    still = np.abs(slips) <= REST_SPEED
    if still.all():
        return False, ()
    course = tuple(sense for sense, _ in groupby(np.sign(slips[~still]).astype(int).tolist()))
    stays = (
        still[1:] & still[:-1] & (np.diff(times) > MIN_INTERVAL_FRACTION * until)
    )  # what turns back is still for no time
    return (None if still[0] or stays.any() else True), course


def _soon(study: SimulatedScene, until: float) -> float:
    """Return the time, s, by which a released body has begun to slide."""
    return min(SLIDE_ONSET_FRACTION * (until or 1.0), float(study.trace.state.times[-1]))


BURNOUT_RTOL = 1e-9  # relative: a moment closer to burn-out coincides with it


@REGIMES.register("burnt out")
@dataclass(frozen=True, slots=True)
class BurntOut(Regime):
    """The assumption that all fuel is used up before the moment asked about, or that it is not.

    A rocket that may come down again has not yet done so, as the simulated motion ends there.
    """

    of = Bodies()
    stage = 2

    out: bool
    falls: bool = False

    @classmethod
    def possible(cls, study: SimulatedScene, words: Words) -> Sequence[Self]:
        """Return two regimes for each body that burns fuel: all of the fuel is used up before the moment, or not."""
        named = [burn.body for burn in study.mechanism.burns if burn.body in words.subject_phrases(cls.of)]
        body = study.mechanism.body
        falls = {name: "s" in words.own and any(c.lower > -inf for c in body[name].coordinates) for name in named}
        return [regime for name in named for regime in (cls(name, out=True, falls=falls[name]), cls(name, out=False))]

    def holds(self, study: SimulatedScene, until: float) -> bool:
        """Return whether a time, s, is on the assumed side of burn-out, before or after; True at burn-out itself."""
        end = self._end(study)
        return until > end * (1.0 + BURNOUT_RTOL) if self.out else 0.0 < until < end * (1.0 - BURNOUT_RTOL)

    def margin(self, study: SimulatedScene, until: float) -> float | None:
        """Return the interval between the time and burn-out, relative to the burn time; None without a burn."""
        later = until / self._end(study) - 1.0
        return later if self.out else -later

    def _end(self, study: SimulatedScene) -> float:
        return max(burn.until for burn in study.mechanism.burns if burn.body == self.name)

    def must_be_stated(self, study: SimulatedScene) -> bool:
        """Return True, as formulas do not show the burn time."""
        del study
        return True

    def clause(self, words: Words) -> str:
        """Return a clause such as *it has burned all its fuel by that moment but has not yet fallen back*."""
        return f"{self.short_clause(words)}{' but has not yet fallen back' * (self.out and self.falls)}"

    def short_clause(self, words: Words) -> str:
        """Return the part about fuel only, such as *the rocket has burned all its fuel by that moment*."""
        called = words.subject_phrases(self.of)[self.name]
        return (
            f"{called} has burned all its fuel by that moment"
            if self.out
            else f"{called} still has fuel at that moment"
        )

    def clause_beside(self, words: Words, others: Sequence[Regime]) -> str:
        """Return the clause without *but has not yet fallen back* if another clause says that the rocket only rises."""
        rises = any(isinstance(other, MovesOneWay) and other.name == self.name for other in others)
        return self.short_clause(words) if rises else self.clause(words)


ZERO_MOTION_TOL = 1e-9  # m/s², m/s


@REGIMES.register("waits")
@dataclass(frozen=True, slots=True)
class DelayedLiftoff(Regime):
    """The assumption that a rocket on the ground burns some of its fuel before it lifts off, or none."""

    of = Bodies()
    stage = 0
    unseen = True

    waits: bool

    @classmethod
    def possible(cls, study: SimulatedScene, words: Words) -> Sequence[Self]:
        """Return two regimes for each rocket that stands on the ground: lift-off after some burning, or at once."""
        if not any(isinstance(line.law, Prop) for line in study.mechanism.lines):
            return []
        named = words.subject_phrases(cls.of)
        rockets = [burn.body for burn in study.mechanism.burns if burn.body in named]
        return [cls(body, waits) for body in rockets for waits in (True, False)]

    def holds(self, study: SimulatedScene, until: float) -> bool:
        """Return whether the rocket is accelerated at ignition or, for a delay, only later but before burn-out."""
        del until
        trace = study.trace
        burnt = min(*(burn.until for burn in trace.mechanism.burns if burn.body == self.name), trace.stable_until)
        pushed = Acceleration.evaluate(trace.at(0.0), self.name)
        moves = Velocity.evaluate(trace.at(burnt), self.name)
        lifted = float(np.linalg.norm(pushed)) > ZERO_MOTION_TOL
        return (not lifted and float(np.linalg.norm(moves)) > ZERO_MOTION_TOL) if self.waits else lifted

    def must_be_stated(self, study: SimulatedScene) -> bool:
        """Return True, as formulas do not show whether the thrust exceeds the weight."""
        del study
        return True

    def margin(self, study: SimulatedScene, until: float) -> float | None:
        """Return the difference of initial thrust and weight, relative to the weight; None without gravity."""
        del until
        mechanism = study.mechanism
        weight = float(mechanism.body[self.name].mass * np.linalg.norm(mechanism.gravity))
        thrust = sum(burn.rate * burn.exhaust for burn in mechanism.burns if burn.body == self.name)
        return (thrust / weight - 1.0) * (-1.0 if self.waits else 1.0) if weight else None

    def clause(self, words: Words) -> str:
        """Return the clause, such as *the rocket lifts off as soon as its engine starts*."""
        called = words.subject_phrases(self.of)[self.name]
        if not self.waits:
            return f"{called} lifts off as soon as its engine starts"
        return f"{called} lifts off only after its engine has burned part of its fuel"
