"""Assumptions about directions of motion, sides and angles."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import isclose
from typing import Self

import numpy as np

from sim2reason.errors import SceneError
from sim2reason.questions.regimes import REGIMES, Regime
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.state import Array
from sim2reason.scenes.dsl.structure import changing
from sim2reason.scenes.dsl.vectors import Vector, inner
from sim2reason.simulation.quantities.kinematics import Acceleration, Velocity
from sim2reason.simulation.quantities.positions import Deflection, deflection_at_start
from sim2reason.simulation.quantities.subjects import Sense
from sim2reason.simulation.quantities.subjects.bodies import OPPOSITE, RIGHT, Bodies, center_path
from sim2reason.simulation.quantities.subjects.rotating_parts import (
    SwingingLines,
    has_bodies_on_both_sides,
    is_light_rod,
    load_center,
    welded_bodies,
)

RIGHT_ANGLE = 90.0  # degrees
CLEAR_SHARE = 1e-3  # of free fall, and of a motion: larger accelerations and longer intervals are beyond rounding


@REGIMES.register("acute")
@dataclass(frozen=True, slots=True)
class StartsAcute(Regime):
    """The assumption that a line makes an acute angle with the downward vertical at the start."""

    of = SwingingLines()
    stage = 0
    at_start = True

    @classmethod
    def possible(cls, study: SimulatedScene, words: Words) -> Sequence[Self]:
        """Return one regime per string, spring or rod; none for an arm, whose described masses show the direction."""
        bodies = study.mechanism.body
        extended = {name for name, body in bodies.items() if not body.mass or any(body.inertia)}
        return [cls(name) for name in words.subject_phrases(cls.of) if name not in extended]

    def holds(self, study: SimulatedScene, until: float) -> bool:
        """Return whether the initial angle is acute in a motion."""
        del until
        return deflection_at_start(study.trace.at(0.0), self.name) < RIGHT_ANGLE

    def never_holds(self, study: SimulatedScene) -> bool:
        """Return whether the initial angle is not acute."""
        return not self.holds(study, 0.0)

    def clause(self, words: Words) -> str:
        """Return the clause, such as *the rod makes an acute angle with the downward vertical at the start*."""
        return (
            f"{words.subject_phrases(self.of)[self.name]} makes an acute angle with the downward vertical at the start"
        )


ANGLE_ROUNDING = 1e-6  # degrees: smaller differences are rounding


@REGIMES.register("beyond_start")
@dataclass(frozen=True, slots=True)
class DeflectedBeyondStart(Regime):
    """The assumption that a line makes a larger, or a smaller, angle with the vertical than at the start."""

    of = SwingingLines()
    stage = 2

    larger: bool

    @classmethod
    def possible(cls, study: SimulatedScene, words: Words) -> Sequence[Self]:
        """Return a regime of a larger and one of a smaller angle for each line if the question has a symbol for one."""
        del study
        return [
            cls(name, larger)
            for name in words.subject_phrases(cls.of)
            for larger in (True, False)
            if "deg" in words.own
        ]

    def holds(self, study: SimulatedScene, until: float) -> bool:
        """Return whether the angle at a time, s, has changed as assumed since the start; False for a slack string."""
        state = study.trace.at(until)
        more = float(Deflection.evaluate(state, self.name)[0]) - deflection_at_start(state, self.name)
        return more > ANGLE_ROUNDING if self.larger else more < -ANGLE_ROUNDING

    def clause(self, words: Words) -> str:
        """Return a clause such as *the string then makes a larger angle with the vertical than at the start*."""
        size = "larger" if self.larger else "smaller"
        line = words.subject_phrases(self.of)[self.name]
        return f"{line} then makes a {size} angle with the downward vertical than at the start"


REST_SPEED_RTOL = 1e-9  # of the greatest speed: lower speeds are rest
MIN_REST_FRACTION = 1e-9  # of the time asked about: a reversing body is at rest for less


@REGIMES.register("direction")
@dataclass(frozen=True, slots=True)
class MovesOneWay(Regime):
    """The assumption that a body moves in one direction along a line, or is about to."""

    of = Bodies()

    positive: str  # the sense of the line, as the text has it
    ahead: bool

    @classmethod
    def possible(cls, study: SimulatedScene, words: Words) -> Sequence[Self]:
        """Return two regimes, one per direction of motion, for each body on a line for which the text has words."""
        senses = [(name, sense) for name in words.subject_phrases(cls.of) for sense in _senses(study, name)]
        return [cls(name, sense.positive, ahead) for name, sense in senses for ahead in (True, False)]

    def holds(self, study: SimulatedScene, until: float) -> bool:
        """Return whether the body moves in the assumed direction throughout, up to a time, s."""
        return (until > 0.0 or not changing(study.mechanism)) and self.begins(study, until)

    def begins(self, study: SimulatedScene, until: float = 0.0) -> bool:
        """Return whether the body moves in the assumed direction at a time, s, whatever it does later."""
        sense = next((s for s in _senses(study, self.name) if s.positive == self.positive), None)
        return sense is not None and _side(study, self.name, sense.vector, until) == (1 if self.ahead else -1)

    def never_holds(self, study: SimulatedScene) -> bool:
        """Return whether the body is clearly accelerated from rest against the assumed direction."""
        moves = any(coordinate.speed for coordinate in study.mechanism.coordinates)
        if moves or not starts_evenly(study, CLEAR_SHARE * study.trace.stable_until):
            return False
        margin = self.margin(study, 0.0)
        return margin is not None and margin < -CLEAR_SHARE

    def margin(self, study: SimulatedScene, until: float) -> float | None:
        """Return the velocity or initial acceleration in the assumed direction, relative to free fall; else None."""
        sense = next((s for s in _senses(study, self.name) if s.positive == self.positive), None)
        if sense is None:
            return None
        rate = (Velocity if until else Acceleration).evaluate(study.trace.at(until), self.name)[0] @ np.array(
            sense.vector
        )
        return (1.0 if self.ahead else -1.0) * float(rate) / _of_free_fall(study, until)

    def clause(self, words: Words) -> str:
        """Return a clause such as *block A moves down the slope*, or *keeps moving* if it may turn or stop.

        A body that may collide *moves only* in that direction.
        """
        kept = "moves only" if words.mechanism.meetings else "keeps moving" if words.turns_back else "moves"
        return f"{words.subject_phrases(self.of)[self.name]} {self.motion.replace('moves', kept, 1)}"

    @property
    def motion(self) -> str:
        """Return the predicate, such as *moves down the slope*."""
        first, space, rest = self.positive.partition(" ")
        direction = first if self.ahead else OPPOSITE[first]
        towards = f"to the {direction}" if first == RIGHT else direction
        return f"moves {towards}{space}{rest}"


def starts_evenly(study: SimulatedScene, until: float) -> bool:
    """Return whether accelerations are constant up to a time, s."""
    return not changing(study.mechanism) and all(event.time > until for event in study.trace.events)


def _of_free_fall(study: SimulatedScene, until: float) -> float:
    """Return the velocity of free fall at a time, s, its acceleration at the start, or 1 if there is no gravity."""
    return float(np.linalg.norm(study.mechanism.gravity)) * (until or 1.0) or 1.0


def _senses(study: SimulatedScene, name: str) -> list[Sense]:
    """Return the direction of a body's line, if the text has words for it; else none."""
    if not center_path(study.mechanism, name).straight:
        return []
    senses = Bodies().senses(study.mechanism, name)
    return [sense for sense in senses if sense.positive.partition(" ")[0] in OPPOSITE and not sense.axis]


def _side(study: SimulatedScene, name: str, direction: Vector, until: float) -> int:
    """Return 1 or −1 for motion along or against a direction, 0 for both or for a later standstill.

    What starts from rest moves the way in which it is accelerated.
    """
    scan = study.trace.scan
    within = scan.times < until
    times = np.append(scan.times[within], until)
    last = Velocity.evaluate(study.trace.at(until), name)
    speeds: Array = np.concatenate([Velocity.evaluate(scan, name)[within], last]) @ np.array(direction)
    fastest = float(np.abs(speeds).max(initial=0.0))
    if fastest <= REST_SPEED_RTOL:
        begins = float((Acceleration.evaluate(study.trace.at(0.0), name) @ np.array(direction))[0])
        return int(begins > REST_SPEED_RTOL) - int(begins < -REST_SPEED_RTOL)
    idle = np.abs(speeds) <= REST_SPEED_RTOL * fastest
    rests = idle[1:] & idle[:-1] & (np.diff(times) > MIN_REST_FRACTION * until)
    if rests[int(np.argmin(idle)) :].any():
        return 0
    ahead, back = bool((speeds[~idle] > 0.0).any()), bool((speeds[~idle] < 0.0).any())
    return int(ahead) - int(back)


@REGIMES.register("direction_at_first")
@dataclass(frozen=True, slots=True)
class MovesFirst(Regime):
    """The assumption that a released body first moves in one direction along a line, whatever it does later."""

    of = Bodies()
    stage = 0

    way: MovesOneWay

    @classmethod
    def possible(cls, study: SimulatedScene, words: Words) -> Sequence[Self]:
        """Return two regimes, one per direction of motion, for each body on a line; none unless all start from rest."""
        return [cls(regime.name, regime) for regime in MovesOneWay.possible(study, words)] if words.released else []

    def holds(self, study: SimulatedScene, until: float) -> bool:
        """Return whether the body begins to move in the assumed direction."""
        del until
        return self.way.begins(study)

    def never_holds(self, study: SimulatedScene) -> bool:
        """Return whether the body does not begin to move in the assumed direction."""
        return not self.way.begins(study)

    def clause(self, words: Words) -> str:
        """Return the clause, such as *block A first moves down the slope*."""
        return f"{words.subject_phrases(self.of)[self.name]} first {self.way.motion}"


SHIFTED, SAME = 1.01, 1e-9  # factor on a number, to test dependence on it; relative difference that is rounding


@REGIMES.register("side_of_center_of_mass")
@dataclass(frozen=True, slots=True)
class SideOfCenterOfMass(Regime):
    """The assumption about which side of a light arm, relative to its first body, has the centre of mass."""

    of = Bodies()
    at_start = True
    stage = 0

    same: bool

    @classmethod
    def possible(cls, study: SimulatedScene, words: Words) -> Sequence[Self]:
        """Return two regimes, one per side of the centre of mass, for each arm with bodies on both sides of an axle."""
        mechanism, named = study.mechanism, words.subject_phrases(cls.of)
        rods = [body.name for body in mechanism.bodies if is_light_rod(body)]
        firsts = [welded_bodies(mechanism, rod)[0].name for rod in rods if has_bodies_on_both_sides(mechanism, rod)]
        return [cls(name, same) for name in firsts if name in named for same in (True, False)]

    def holds(self, study: SimulatedScene, until: float) -> bool:
        """Return whether the centre of mass is on the assumed side of the arm in a motion."""
        del until
        side = self._side(study.mechanism)
        return side > 0.0 if self.same else side < 0.0

    def never_holds(self, study: SimulatedScene) -> bool:
        """Return whether the centre of mass is not on the assumed side."""
        return not self.holds(study, 0.0)

    def _side(self, mechanism: Mechanism) -> float:
        """Return the position of the centre of mass on the side of the body, times the body's distance, m²."""
        body = mechanism.body[self.name]
        return inner(load_center(mechanism, mechanism.body[body.parent or ""]), body.at)

    def regardless_of(self, study: SimulatedScene, path: str) -> bool:
        """Return whether a number does not affect the centre of mass, as an angle or a speed."""
        value = study.scene.value(path)
        if not value:
            return False
        try:
            other = study.scene.having(path, value * SHIFTED).mechanism
        except SceneError:
            return False
        return isclose(self._side(other), self._side(study.mechanism), rel_tol=SAME)

    def clause(self, words: Words) -> str:
        """Return a clause such as *the centre of mass of the bodies on the arm is on the same side as disc A*."""
        where = "on the same side of the axle as" if self.same else "on the side of the axle opposite to"
        return f"the centre of mass of the bodies on the arm is {where} {words.subject_phrases(self.of)[self.name]}"
