"""The first time that the velocity of a body in a field has turned through a stated angle."""

from dataclasses import dataclass
from math import cos, hypot, radians, sin

import numpy as np

from sim2reason.dsl.state import Array, State
from sim2reason.quantities.kinematics import Velocity
from sim2reason.questions.moments import MOMENTS, Clause
from sim2reason.questions.moments.parts.charged import SLIGHT, ActingFields, FieldPassage, begins
from sim2reason.questions.moments.parts.passage import Threshold
from sim2reason.questions.moments.parts.verbs import when_phrases
from sim2reason.questions.words import Words
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.trace import Trace

ANGLES = (30.0, 45.0, 60.0, 90.0, 120.0, 150.0)  # degrees, such as teachers choose
MOST = 180.0  # degrees, which a turn is not told from one the other way round beyond


@MOMENTS.register("velocity_turned")
@dataclass(frozen=True, slots=True)
class VelocityTurned(FieldPassage, Threshold):
    """The first time that the direction of a velocity differs by a stated angle from that at the start."""

    label = "velocity turned"
    part = True
    hangs_on = "velocity"
    unit = "deg"

    @classmethod
    def suits(cls, acts: ActingFields) -> bool:
        """Return whether one field alone turns it, uniformly or as the ratio of two components of the velocity."""
        alone = not (acts.electric and acts.magnetic)
        return (
            alone
            and not (acts.electric and acts.medium)
            and all(law.profile.uniform for law in (*acts.electric, *acts.magnetic))
        )

    @classmethod
    def drawn(cls, name: str, trace: Trace, rng: np.random.Generator) -> float | None:
        """An angle that is reached."""
        met = [angle for angle in ANGLES if cls(name, angle).time(trace) is not None]
        return met[int(rng.integers(len(met)))] if met else None

    @property
    def tells(self) -> tuple[Channel, ...]:
        """Return how the force has turned, too; but the speed may have changed."""
        return tuple(Channel(self.name, told) for told in ("acceleration", "net force"))

    def time(self, trace: Trace) -> float | None:
        """Return when the velocity first has that direction, s; None if it never has, or does not turn."""
        velocity, acceleration = begins(trace.state, self.name)
        size = hypot(*velocity.tolist()) * hypot(*acceleration.tolist())
        square = abs(float(velocity @ acceleration)) <= SLIGHT * size or bool(trace.state.mechanism.forces[1:])
        turns = 0.0 < self.value < MOST and size > 0.0 and square
        return FieldPassage.time(self, trace) if turns else None

    def excess(self, state: State) -> Array:
        """Return the component of the velocity across the direction that it has then, m/s, (n,)."""
        (vx, vy, _), acceleration = begins(state, self.name)
        sign = 1.0 if vx * acceleration[1] >= vy * acceleration[0] else -1.0
        turn = sign * radians(self.value)
        x, y = vx * cos(turn) - vy * sin(turn), vx * sin(turn) + vy * cos(turn)
        now = Velocity.evaluate(state, self.name)
        return sign * (x * now[:, 1] - y * now[:, 0]) / hypot(vx, vy)

    def subject(self, words: Words) -> str:
        """Return how a question calls the velocity."""
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
