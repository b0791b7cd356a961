"""Outcomes for bodies on strings and for swinging bodies."""

from dataclasses import dataclass
from math import inf

import numpy as np

from sim2reason.questions.outcomes import OUTCOMES, SPEED_NOISE, Onset, Swinging, is_steady_release, rest_speed_noise
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import Inextensible
from sim2reason.simulation.quantities.kinematics import Acceleration, AngleTurned, Velocity
from sim2reason.simulation.quantities.subjects.bodies import (
    UP,
    Bodies,
    TurningBodies,
    center_path,
    moves_on_slider,
    turning_axes,
)
from sim2reason.simulation.quantities.subjects.rotating_parts import SwingingLines
from sim2reason.simulation.trace import Trace

SWING_TURNING_POINTS = 2  # turning points, left and right, of a swing that does not go round


@OUTCOMES.register("goes_slack")
@dataclass(frozen=True, slots=True)
class GoesSlack(Swinging):
    """The outcome that the string of a pendulum goes slack within its first swings."""

    of = SwingingLines()
    tells = False

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the swinging strings, with their phrases."""
        lines = words.mechanism.line
        called = words.subject_phrases(cls.of).items()
        return {n: phrase for n, phrase in called if n in lines and isinstance(lines[n].law, Inextensible)}

    def happens(self, trace: Trace) -> bool | None:
        """Return whether the string goes slack; False once the body has swung to both sides or gone round."""
        if any(event.kind == "slack" and event.subjects[0] == self.name for event in trace.events):
            return True
        level = {c.name for c in trace.mechanism.coordinates if c.axis[2] == 0.0}
        sides = sum(event.kind == "turn" and event.subjects[0] in level for event in trace.events)
        return False if sides >= SWING_TURNING_POINTS else None

    def excess(self, trace: Trace) -> float:
        """Return the least tension, N."""
        return float(trace.scan.tension[self.name].min())

    def does(self, words: Words) -> tuple[str, ...]:
        """Return the verb phrase, such as *the string goes slack*."""
        subject = self.subject(words)
        return (f"{subject} goes slack at some time", f"{subject} goes slack on the way")

    def does_not(self, words: Words) -> tuple[str, ...]:
        """Return the negated statement, such as *the string stays taut*."""
        subject = self.subject(words)
        return (f"{subject} stays taut throughout", f"{subject} never goes slack")


@OUTCOMES.register("lifts_off")
@dataclass(frozen=True, slots=True)
class LiftsOff(Onset):
    """The outcome that a body with an engine rises from the ground at once; never drawn by recipes."""

    of = Bodies()
    drawn_by_recipes = False

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the bodies that burn fuel, if gravity is uniform; else none."""
        mechanism = words.mechanism
        burning = {burn.body for burn in mechanism.burns} if any(mechanism.gravity) else set[str]()
        return {name: phrase for name, phrase in words.subject_phrases(cls.of).items() if name in burning}

    def happens(self, trace: Trace) -> bool:
        """Return whether the body is accelerated upwards at the start."""
        return self.excess(trace) > SPEED_NOISE

    def excess(self, trace: Trace) -> float:
        """Return the upward acceleration at the start, m/s²."""
        return float(Acceleration.evaluate(trace.at(0.0), self.name)[0, 2])

    def does(self, words: Words) -> tuple[str, ...]:
        """Return the clause *the probe rises at once*."""
        return (f"{self.subject(words)} rises at once",)

    def does_not(self, words: Words) -> tuple[str, ...]:
        """Return the clause *the probe does not rise at once*."""
        return (f"{self.subject(words)} does not rise at once",)


@OUTCOMES.register("rises")
@dataclass(frozen=True, slots=True)
class Rises(Onset):
    """The outcome that a body starts to move up its line."""

    of = Bodies()

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the bodies that can move along one line, which is not level, and that something could lift."""
        mechanism = words.mechanism
        if not is_steady_release(words) or not (mechanism.lines or mechanism.forces):
            return {}
        called = words.subject_phrases(cls.of).items()
        paths = {name: center_path(mechanism, name) for name, _ in called}
        return {
            n: phrase
            for n, phrase in called
            if paths[n].straight and paths[n].rises and not moves_on_slider(mechanism, n)
        }

    def happens(self, trace: Trace) -> bool:
        """Return whether the body moves upwards."""
        return self.excess(trace) > 0.0

    def excess(self, trace: Trace) -> float:
        """Return the upward velocity, m/s, less rounding noise."""
        return float(Velocity.evaluate(trace.state, self.name)[-1, 2]) - rest_speed_noise(trace)

    def does(self, words: Words) -> tuple[str, ...]:
        """Return the verb phrase, such as *block A starts to move up the slope*."""
        return (f"{self.subject(words)} starts to move {self._way(words)}",)

    def does_not(self, words: Words) -> tuple[str, ...]:
        """Return the negated statement, such as *block A does not start to move up the slope*."""
        return (f"{self.subject(words)} does not start to move {self._way(words)}",)

    def _way(self, words: Words) -> str:
        senses = self.of.senses(words.mechanism, self.name)
        return senses[0].positive if senses else UP


@OUTCOMES.register("sinks")
@dataclass(frozen=True, slots=True)
class Sinks(Onset):
    """The outcome that a body starts to move down its line; never drawn by recipes."""

    of = Bodies()
    drawn_by_recipes = False

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the bodies that may also rise, by name."""
        return Rises.candidates(words)

    def happens(self, trace: Trace) -> bool:
        """Return whether the body has a downward velocity."""
        return self.excess(trace) > 0.0

    def excess(self, trace: Trace) -> float:
        """Return the downward velocity, m/s, less rounding noise."""
        return -float(Velocity.evaluate(trace.state, self.name)[-1, 2]) - rest_speed_noise(trace)

    def does(self, words: Words) -> tuple[str, ...]:
        """Return the clause *block A starts to move down*."""
        return (f"{self.subject(words)} starts to move down",)

    def does_not(self, words: Words) -> tuple[str, ...]:
        """Return the clause *block A does not start to move down*."""
        return (f"{self.subject(words)} does not start to move down",)


REVERSAL_SPEED_RTOL = 1e-3  # of the greatest speed: a slower body without vertical motion turns back


@OUTCOMES.register("circles")
@dataclass(frozen=True, slots=True)
class Circles(Swinging):
    """The outcome that a body on a taut string swings right round; never drawn by recipes."""

    of = SwingingLines()
    tells = False
    drawn_by_recipes = False

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the strings of bodies set moving, with their phrases; a released body never gets over the top."""
        return {} if words.released else GoesSlack.candidates(words)

    def happens(self, trace: Trace) -> bool | None:
        """Return whether the body gets over the top before the string goes slack or the body turns back."""
        upright = {c.name for c in trace.mechanism.coordinates if c.axis[2] != 0.0}
        turned = [event.time for event in trace.events if event.kind == "turn" and event.subjects[0] in upright]
        slack = [event.time for event in trace.events if event.kind == "slack" and event.subjects[0] == self.name]
        fastest = float(np.linalg.norm(trace.scan.v, axis=1).max())
        back = [time for time in turned if np.linalg.norm(trace.at(time).v[0]) <= REVERSAL_SPEED_RTOL * fastest]
        extremes = [time for time in turned if time not in back]
        end = min((*slack, *back), default=inf)
        over = extremes[1] if len(extremes) > 1 else inf  # the second of its lowest and its highest point
        return None if end == over else over < end

    def excess(self, trace: Trace) -> float:
        """Return the least tension, N."""
        return GoesSlack(self.name).excess(trace)

    def does(self, words: Words) -> tuple[str, ...]:
        """Return the clause *the string stays taut all the way round*."""
        return (f"{self.subject(words)} stays taut all the way round",)

    def does_not(self, words: Words) -> tuple[str, ...]:
        """Return the clause *the string does not stay taut all the way round*."""
        return (f"{self.subject(words)} does not stay taut all the way round",)


FULL_TURN_DEGREES = 360.0  # degrees


@OUTCOMES.register("goes_round")
@dataclass(frozen=True, slots=True)
class GoesRound(Swinging):
    """The outcome that a rod or another body on an axle goes right round."""

    of = TurningBodies()

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the bodies on one axle that swing under gravity and are set moving, with their phrases."""
        if not any(words.mechanism.gravity) or words.mechanism.feet or words.released:
            return {}
        turning = AngleTurned().subjects(words.mechanism)
        return {name: phrase for name, phrase in words.subject_phrases(cls.of).items() if name in turning}

    def happens(self, trace: Trace) -> bool | None:
        """Return whether the body goes round before it turns back; None if that takes longer."""
        hinges = {name for name, _ in turning_axes(trace.mechanism, self.name)}
        back = next(
            (event.time for event in trace.events if event.kind == "turn" and event.subjects[0] in hinges), None
        )
        state = trace.state if back is None else trace.at(back)
        round_once = bool(np.abs(AngleTurned.evaluate(state, self.name)).max() >= FULL_TURN_DEGREES)
        return round_once or (None if back is None else False)

    def excess(self, trace: Trace) -> float:
        """Return the square of the least angular speed, which is linear in the energy left at the top."""
        number = trace.mechanism.number
        hinges = [number[name] for name, _ in turning_axes(trace.mechanism, self.name)]
        return float(np.square(trace.scan.v[:, hinges].sum(axis=1)).min())

    def does(self, words: Words) -> tuple[str, ...]:
        """Return the verb phrase, such as *the rod makes a full turn*."""
        subject = self.subject(words)
        return (f"{subject} makes a full turn", f"{subject} goes right round")

    def does_not(self, words: Words) -> tuple[str, ...]:
        """Return the negated statement, such as *the rod does not make a full turn*."""
        subject = self.subject(words)
        return (f"{subject} does not make a full turn", f"{subject} does not go right round")
