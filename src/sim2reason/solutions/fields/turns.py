"""When the velocity of a charged body has turned so far, is across the electric field, or is the initial one again."""

from math import radians

from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.across_field import AcrossField
from sim2reason.questions.moments.velocity_returned import VelocityReturned
from sim2reason.questions.moments.velocity_turned import VelocityTurned
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import PI, Call
from sim2reason.solutions.fields.forces import AXES, TURNS, Fields
from sim2reason.solutions.fields.magnetic_motion import Turning
from sim2reason.solutions.fields.motion import FieldMotion
from sim2reason.solutions.setting import capital
from sim2reason.solutions.writing.numeric_roots import SMALLEST, told_root
from sim2reason.solutions.writing.steps import UnsolvedError
from sim2reason.solutions.writing.unit_latex import DEGREES, METRES, SECONDS

TWO = Number(2.0)
TURNED = (AcrossField, VelocityReturned, VelocityTurned)


class FieldTurn:
    """One of these moments, and what components of a motion are then, where that is short."""

    def __init__(self, moment: Moment, fields: Fields, motion: FieldMotion) -> None:
        """Nothing is written yet."""
        self.moment, self.fields, self.motion = moment, fields, motion
        self.book, self.setting = fields.book, fields.setting
        self.angle: Symbol | None = None

    @property
    def _who(self) -> str:
        return self.setting.called(self.fields.body)

    @property
    def pace(self) -> Expression:
        """Return the size of the angular velocity of what a magnetic field turns."""
        turns = self.fields.turning
        if turns is None:
            raise UnsolvedError("nothing turns uniformly")
        return turns if self.book.value(turns) > 0.0 else -turns

    def time(self, name: Symbol, launched: Expression) -> Symbol:
        """Write when it is; `launched` is the speed at the start."""
        if isinstance(self.moment, VelocityTurned):
            return self._turned(name, launched, self.moment.value)
        if isinstance(self.moment, VelocityReturned):
            self.motion.rate(0, name)  # so that it is told first what turns
            said = f"When its rotating part has made a full turn, {self._who} has its initial velocity again, after"
            return self.book.told("turn", said, name, TWO * PI / self.pace, SECONDS)
        return self._across(name)

    def _turned(self, name: Symbol, launched: Expression, value: float) -> Symbol:
        """When the velocity has turned through an angle, in degrees."""
        self.angle = self.book.fresh(r"\alpha")
        self.book.say_given(self.angle.name, radians(value), DEGREES)
        drive, alpha = self.fields.drive, self.angle.latex()
        if drive is None:
            said = f"The velocity rotates uniformly, so it has turned through ${alpha}$ after"
            return self.book.told("turn", said, name, self.angle / self.pace, SECONDS)
        pull = drive.strength if self.book.value(drive.strength) > 0.0 else -drive.strength
        step = self.book.open("turn")
        step.rest_on(self.fields.law)
        law = step.law(pull * name, launched * Call("tan", self.angle))
        step.say(
            f"The electric force is perpendicular to the initial velocity, whose component ${launched.latex()}$ is"
        )
        step.say(f"kept, while the component along the force grows to ${(pull * name).latex()}$. So the velocity has")
        step.say(f"turned through ${alpha}$ when {law}, that is,")
        step.say(f"{step.result(name, launched * Call('tan', self.angle) / pull, SECONDS)}.")
        step.close()
        return name

    def _across(self, name: Symbol) -> Symbol:
        """When the component along the electric field has come to zero."""
        drive = self.fields.drive
        assert drive is not None
        rate = self.motion.rate(drive.axis, name)
        if self.halved:
            said = f"{self._who} moves perpendicular to the electric field when the rotating part of its velocity"
            return self.book.told("turn", f"{capital(said)} has made half a turn, after", name, PI / self.pace, SECONDS)
        step = self.book.open("turn")
        law = step.law(rate, ZERO)
        step.rest_on(self.fields.law)
        step.say(f"{capital(self._who)} moves perpendicular to the field when its velocity along {AXES[drive.axis]} is")
        step.say(f"zero: {law}.")
        step.say(told_root(self.book, step, name, rate, self.setting.time, SECONDS, SMALLEST))
        step.close()
        return name

    @property
    def halved(self) -> bool:
        """Whether the rotating part has made half a turn then: at the start, too, no velocity is along the field."""
        drive = self.fields.drive
        if drive is None or not isinstance(self.moment, AcrossField) or not isinstance(self.motion, Turning):
            return False
        return self.fields.launch[drive.axis] == ZERO and self.fields.damping is None

    def component(self, kind: str, axis: int, time: Expression) -> Expression | None:
        """Return a component of the displacement ``s`` or velocity ``v`` then, where it is a short one; else None."""
        drive, motion = self.fields.drive, self.motion
        if isinstance(self.moment, AcrossField) and kind == "v" and drive is not None and drive.axis == axis:
            return ZERO
        if not isinstance(motion, Turning):
            return None
        if isinstance(self.moment, VelocityReturned):
            return motion.carried(axis, time) if kind == "s" else None
        if not self.halved:
            return None
        if kind == "v":
            return self.fields.launch[axis] - TWO * motion.turned[axis]
        return motion.carried(axis, time) + TWO * motion.turned[1 - axis] * TURNS[axis] / motion.turning

    def told(self, kind: str) -> str:
        """Return the reason for a short component; empty for others."""
        if not isinstance(self.motion, Turning) or kind not in ("v", "s"):
            return ""
        if isinstance(self.moment, VelocityReturned):
            return "Over a whole turn, the rotating part adds nothing to the displacement of {who}, which"
        if not self.halved:
            return ""
        if kind == "v":
            return (
                "After half a turn, the rotating part of the velocity has the opposite direction; the velocity of {who}"
            )
        return "Over half a turn, the rotating part moves {who} by the diameter of a circle; the displacement"

    def chord(self, radius: Expression) -> Symbol:
        """Write the distance from the start where a velocity of constant size has turned through the angle."""
        assert self.angle is not None
        said = (
            "The distance from the starting point is the chord of the arc covered, which has this angle at the centre,"
        )
        formula = TWO * radius * Call("sin", self.angle / TWO)
        return self.book.told("chord", said, self.book.fresh("d"), formula, METRES)
