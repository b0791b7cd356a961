"""Moments of charged particles in fields, and crossings of the boundaries of fields."""

import math
from dataclasses import dataclass
from math import cos, hypot, radians, sin
from typing import ClassVar

import numpy as np

from sim2reason.questions.moments import MOMENTS, Clause
from sim2reason.questions.moments.crossings import (
    COMPONENT_RTOL,
    ActingFields,
    FieldPassage,
    Threshold,
    initial_rates,
)
from sim2reason.questions.moments.occurrence import Occurrence, Verb, when_phrases
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.fields import Push
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.state import Array, State, row_lengths
from sim2reason.scenes.dsl.vectors import Vector, inner
from sim2reason.simulation.quantities.kinematics import Velocity
from sim2reason.simulation.quantities.subjects.bodies import Bodies
from sim2reason.simulation.trace import Channel, Trace


@MOMENTS.register("across_field")
@dataclass(frozen=True, slots=True)
class AcrossField(FieldPassage):
    """The first time that a body reverses its motion along the electric field while it still moves across it."""

    label = "turning point along the field"
    hangs_on = "velocity"
    verb = Verb("moves perpendicular to the electric field", "move perpendicular to the electric field")
    again: ClassVar[Verb] = Verb(f"{verb.told} again", f"{verb.asked} again")

    @classmethod
    def suits(cls, acts: ActingFields) -> bool:
        """Return whether the only fields are a constant electric field and uniform magnetic ones, without a medium."""
        return len(acts.electric) == 1 and acts.electric[0].profile.steady and not acts.medium

    def does(self, words: Words) -> Verb:
        """Return the verb, with *again* for a body that is launched perpendicular to the field."""
        mechanism = words.mechanism
        direction = _field_direction(mechanism, self.name)
        own = mechanism.body[self.name].coordinates
        along = sum(inner(direction, one.axis) * one.speed for one in own)
        speed = math.hypot(*(one.speed for one in own))
        return self.again if abs(along) <= COMPONENT_RTOL * speed and speed else self.verb

    @property
    def revealed_channels(self) -> tuple[Channel, ...]:
        """Return the channels of forces and energies, which follow at once from the velocity or displacement."""
        quantities = ("acceleration", "net force", "electric potential energy")
        return tuple(Channel(self.name, quantity) for quantity in quantities)

    def time(self, trace: Trace) -> float | None:
        """Return the time, s, at which the velocity along the field is first zero; None if the body is at rest then."""
        time = FieldPassage.time(self, trace)
        if time is None:
            return None
        fastest = float(row_lengths(Velocity.evaluate(trace.scan, self.name)).max())
        here = float(np.linalg.norm(Velocity.evaluate(trace.at(time), self.name)))
        return time if here > COMPONENT_RTOL * fastest else None

    def excess(self, state: State) -> Array:
        """Return the velocity component along the field, m/s, (n,), with a sign that makes initial values negative."""
        direction = np.array(_field_direction(state.mechanism, self.name))
        velocity, acceleration = initial_rates(state, self.name)
        along = float(velocity @ direction)
        first = (
            along if abs(along) > COMPONENT_RTOL * float(np.linalg.norm(velocity)) else float(acceleration @ direction)
        )
        return -np.sign(first) * (Velocity.evaluate(state, self.name) @ direction)


def _field_direction(mechanism: Mechanism, name: str) -> Vector:
    """Return the direction of the electric force on a body."""
    laws = (force.law for force in mechanism.forces if force.body == name)
    return next(law.direction for law in laws if isinstance(law, Push))


@MOMENTS.register("entered_region")
@dataclass(frozen=True, slots=True)
class EnteredRegion(Occurrence):
    """The first time that a body enters the region of a field."""

    label = "entry"
    own = True
    kinds = ("enter",)
    of = Bodies()
    verb = Verb("enters the field", "enter the field")


@MOMENTS.register("left_region")
@dataclass(frozen=True, slots=True)
class LeftRegion(Occurrence):
    """The first time that a body leaves the region of a field."""

    label = "exit"
    own = True
    kinds = ("exit",)
    of = Bodies()
    verb = Verb("leaves the field", "leave the field")


@MOMENTS.register("velocity_returned")
@dataclass(frozen=True, slots=True)
class VelocityReturned(FieldPassage):
    """The first time that a velocity in crossed fields has its initial value again, after one cyclotron period."""

    label = "velocity again"
    hangs_on = "velocity"
    verb = Verb("has its initial velocity again", "have its initial velocity again")

    @classmethod
    def suits(cls, acts: ActingFields) -> bool:
        """Return whether the fields are crossed and uniform, so that the velocity is periodic."""
        return acts.uniform and bool(acts.electric) and bool(acts.magnetic)

    def time(self, trace: Trace) -> float | None:
        """Return the period of the velocity, s; None for a body that starts from rest and comes to rest again."""
        velocity, acceleration = initial_rates(trace.state, self.name)
        return FieldPassage.time(self, trace) if velocity.any() and acceleration.any() else None

    def excess(self, state: State) -> Array:
        """Return the change of the velocity times the initial acceleration, m²/s³, (n,)."""
        velocity, acceleration = initial_rates(state, self.name)
        return (Velocity.evaluate(state, self.name) - velocity) @ acceleration


TURN_ANGLES = (30.0, 45.0, 60.0, 90.0, 120.0, 150.0)  # degrees, such as teachers choose
MAX_TURN_ANGLE = 180.0  # degrees: larger turns are ambiguous


@MOMENTS.register("velocity_turned")
@dataclass(frozen=True, slots=True)
class VelocityTurned(FieldPassage, Threshold):
    """The first time that the direction of a velocity differs by a stated angle from the initial direction."""

    label = "velocity turned"
    part = True
    hangs_on = "velocity"
    unit = "deg"

    @classmethod
    def suits(cls, acts: ActingFields) -> bool:
        """Return whether a single field turns the velocity, as in circular motion or with a constant component."""
        alone = not (acts.electric and acts.magnetic)
        return (
            alone
            and not (acts.electric and acts.medium)
            and all(law.profile.uniform for law in (*acts.electric, *acts.magnetic))
        )

    @classmethod
    def drawn(cls, name: str, trace: Trace, rng: np.random.Generator) -> float | None:
        """Return a random usual angle that the velocity reaches, degrees; None if there is none."""
        met = [angle for angle in TURN_ANGLES if cls(name, angle).time(trace) is not None]
        return met[int(rng.integers(len(met)))] if met else None

    @property
    def revealed_channels(self) -> tuple[Channel, ...]:
        """Return the channels that the direction of the velocity determines; its magnitude may still be asked for."""
        return tuple(Channel(self.name, quantity) for quantity in ("acceleration", "net force"))

    def time(self, trace: Trace) -> float | None:
        """Return the time, s, at which the velocity has first turned through the angle; None if it never has."""
        velocity, acceleration = initial_rates(trace.state, self.name)
        size = hypot(*velocity.tolist()) * hypot(*acceleration.tolist())
        square = abs(float(velocity @ acceleration)) <= COMPONENT_RTOL * size or bool(trace.state.mechanism.forces[1:])
        turns = 0.0 < self.value < MAX_TURN_ANGLE and size > 0.0 and square
        return FieldPassage.time(self, trace) if turns else None

    def excess(self, state: State) -> Array:
        """Return the component of the velocity perpendicular to the direction to be reached, m/s, (n,)."""
        (vx, vy, _), acceleration = initial_rates(state, self.name)
        sign = 1.0 if vx * acceleration[1] >= vy * acceleration[0] else -1.0
        turn = sign * radians(self.value)
        x, y = vx * cos(turn) - vy * sin(turn), vx * sin(turn) + vy * cos(turn)
        now = Velocity.evaluate(state, self.name)
        return sign * (x * now[:, 1] - y * now[:, 0]) / hypot(vx, vy)

    def subject(self, words: Words) -> str:
        """Return the phrase for the velocity."""
        return f"the velocity of {self.candidates(words)[self.name]}"

    def phrases(self, words: Words) -> tuple[str, ...]:
        """Return phrases such as *when the velocity of the bead has turned through 60°*."""
        done = f"{self.subject(words)} has turned through {words.say(self.value, self.unit)}"
        return when_phrases(done)

    def clause(self, words: Words) -> Clause | None:
        """Return the clause *the velocity of the bead has turned through 60°*."""
        turned = f"turned through {words.say(self.value, self.unit)}"
        takes = f"to turn through {words.say(self.value, self.unit)}"
        return Clause(self.subject(words), "has", turned, f"has {turned}", takes)
