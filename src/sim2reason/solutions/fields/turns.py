"""Turning points of a charged body, and its greatest distance from an axis."""

from math import radians

from sim2reason.base.records import cached_property
from sim2reason.questions.functionals.kinematics import GreatestXAxisDistance, GreatestYAxisDistance
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.fields import AcrossField, VelocityReturned, VelocityTurned
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import PI, Call, Power, Root
from sim2reason.solutions.algebra.root_finding import SMALLEST, root_sentence
from sim2reason.solutions.fields.forces import AXES, MAGNETIC_SIGNS, Fields
from sim2reason.solutions.fields.magnetic_motion import RotatingMotion
from sim2reason.solutions.fields.motion import ElectricMotion, FieldMotion
from sim2reason.solutions.setting import capitalized
from sim2reason.solutions.writing.notation import DEGREES, METRES, SECONDS, SPEED
from sim2reason.solutions.writing.steps import UnsolvedError

HALF, TWO_AXES = Number(0.5), Number(2.0)
REACHES = {found.name: found.along for found in (GreatestYAxisDistance, GreatestXAxisDistance)}
"""The number of the coordinate whose greatest size each functional is."""


class Reach:
    """The greatest distance from an axis, by centre and amplitude of the motion along a coordinate."""

    def __init__(self, motion: FieldMotion, axis: int, launched: Expression) -> None:
        """Take the motion, the index of the coordinate, and the initial speed."""
        self.motion, self.axis, self.launched, self.book = motion, axis, launched, motion.book

    def write_distance(self) -> Symbol:
        """Write the steps and return the symbol of the distance."""
        if isinstance(self.motion, RotatingMotion):
            center, size = self._round(self.motion)
        elif isinstance(self.motion, ElectricMotion):
            center, size = self._to_and_fro(self.motion)
        else:
            raise UnsolvedError("it does not move about a fixed centre")
        along = AXES[self.axis]
        across = AXES[1 - self.axis]
        if center == ZERO:
            text = f"As the centre lies on the {across} axis, the greatest distance from this axis is"
            return self.book.add_step("extremum", text, self.book.fresh("d"), size, METRES)
        far = self.book.magnitude(center)
        if size == far:
            text = f"It starts from a turning point along {along} and turns back as far beyond the centre, so the"
            text = f"{text} greatest distance from the {across} axis is"
            return self.book.add_step("extremum", text, self.book.fresh("d"), TWO_AXES * far, METRES)
        most = "radius" if isinstance(self.motion, RotatingMotion) else "amplitude"
        text = f"The {along} coordinate differs from that of the centre by at most the {most}, so the greatest distance"
        return self.book.add_step(
            "extremum", f"{text} from the {across} axis is", self.book.fresh("d"), far + size, METRES
        )

    def _round(self, motion: RotatingMotion) -> tuple[Expression, Expression]:
        """Return, for the circle of a rotating motion, its centre along the coordinate and its radius."""
        drive, turns = motion.drive, motion.turning
        if motion.fields.linear_drag_rate is not None or (
            drive is not None and (drive.growth or drive.frequency is not None)
        ):
            raise UnsolvedError("what turns does so about no fixed centre")
        if motion.drift_displacement(self.axis, turns) != ZERO:
            raise UnsolvedError("it drifts along this coordinate")
        parts, along = motion.initial_rotating_velocity if drive is not None else motion.launch, AXES[self.axis]
        kept = [part for part in parts if part != ZERO]
        size = kept[0] if len(kept) == 1 else Root(Power(parts[0], 2) + Power(parts[1], 2))
        if drive is None:
            size = self.launched
        pace = self.book.magnitude(turns)
        size = self.book.magnitude(size)
        what = "The circle on which it moves" if drive is None else "The circle that the rotating part leads it round"
        size = self.book.add_step("circle", f"{what} has the radius", self.book.fresh("R"), size / pace, METRES)
        center = parts[1 - self.axis] * MAGNETIC_SIGNS[self.axis] / turns
        if center == ZERO:
            return ZERO, size
        what = "the velocity" if drive is None else "this part of the velocity"
        text = f"The radius to the centre is perpendicular to {what}, so the {along} coordinate of the centre is"
        return self.book.add_step("circle", text, self.book.fresh(along, "c"), center, METRES), size

    def _to_and_fro(self, motion: ElectricMotion) -> tuple[Expression, Expression]:
        """Return the centre and the amplitude of a harmonic oscillation along the field."""
        drive = motion.fields.electric_acceleration
        swings = drive is not None and drive.axis == self.axis == drive.along and drive.slope is not None
        if not swings or not motion.is_oscillating:
            raise UnsolvedError("it does not oscillate along this coordinate")
        center, first = motion.center, motion.launch[self.axis]
        if first == ZERO:
            size = self.book.magnitude(center)
            return center, size
        text = "With the initial velocity and displacement from the centre, the amplitude of the oscillation is"
        formula = Root(Power(center, 2) + Power(first / motion.frequency, 2))
        return center, self.book.add_step("extremum", text, self.book.fresh("A"), formula, METRES)


def fastest_at_center(fields: Fields, launched: Expression) -> Symbol | None:
    """Write the greatest speed in a restoring field, by energy, where the field vanishes; None in other fields.

    `launched` is the initial speed.
    """
    drive, book = fields.electric_acceleration, fields.book
    if drive is None or drive.slope is None or drive.along != drive.axis or book.value(drive.slope) >= 0.0:
        return None
    along, step = AXES[drive.axis], book.begin_step("extremum")
    step.rest_on(fields.law)
    position, speed = book.fresh(along, "0"), book.fresh("v")
    found = step.result(position, -(drive.strength / drive.slope), METRES, law=True)
    step.add_text(f"The electric force does positive work up to where it is zero, at {along} equal to {found}.")
    magnetic = "and the magnetic force does no work" if fields.turning is not None else "and no other force acts"
    step.add_text(
        f"It depends linearly on {along}, so its mean on the way there is half of that at the start, {magnetic}."
    )
    gained = drive.strength * position
    square = Power(launched, 2) + gained if launched != ZERO else gained
    found = step.result(speed, Root(square), SPEED, law=True)
    step.add_text(
        f"By the work-energy theorem, ${(HALF * gained).latex()}$ is what half the squared speed gains in this way,"
    )
    step.add_text(f"so the greatest speed is {found}.")
    step.close()
    return speed


TWO_TURNS = Number(2.0)
TURN_MOMENTS = (AcrossField, VelocityReturned, VelocityTurned)


class FieldTurn:
    """A moment at which the velocity has turned, with the components of the motion that have short formulas then."""

    def __init__(self, moment: Moment, fields: Fields, motion: FieldMotion) -> None:
        """Take the moment, the fields and the motion."""
        self.moment, self.fields, self.motion = moment, fields, motion
        self.book, self.setting = fields.book, fields.setting
        self._timed = False  # whether the text states the time of half a turn

    @property
    def _who(self) -> str:
        """Return the name of the body."""
        return self.setting.display_name(self.fields.body)

    @property
    def angular_speed(self) -> Expression:
        """Return the magnitude of the angular velocity of the rotating velocity."""
        turns = self.fields.turning
        if turns is None:
            raise UnsolvedError("nothing turns uniformly")
        return self.book.magnitude(turns)

    @cached_property
    def angle(self) -> Symbol:
        """Return the symbol of the angle through which the velocity has turned."""
        assert isinstance(self.moment, VelocityTurned)
        name = self.book.fresh(r"\alpha")
        self.book.state_given(name.name, radians(self.moment.value), DEGREES)
        return name

    def speed(self, launched: Expression) -> Symbol | None:
        """Write the speed after an electric field has turned the velocity; None at other moments."""
        if not isinstance(self.moment, VelocityTurned):
            return None
        text = "The electric force is perpendicular to the initial velocity, so the component across the field"
        text = f"{text} does not change: it is the speed times the cosine of the angle turned, so the speed is"
        formula = launched / Call("cos", self.angle)
        return self.book.add_step("speed", text, self.book.fresh("v"), formula, SPEED)

    def time(self, name: Symbol, launched: Expression) -> Symbol:
        """Write the time of the moment; `launched` is the initial speed."""
        if isinstance(self.moment, VelocityTurned):
            return self._write_turn_time(name, launched)
        if isinstance(self.moment, VelocityReturned):
            self.motion.rate(0, name)  # so that the rotating part is introduced first
            text = f"When its rotating part has made a full turn, {self._who} has its initial velocity again, after"
            return self.book.add_step("turn", text, name, TWO_TURNS * PI / self.angular_speed, SECONDS)
        return self._across(name)

    def _write_turn_time(self, name: Symbol, launched: Expression) -> Symbol:
        """Write the time after which the velocity has turned through the angle."""
        drive, alpha = self.fields.electric_acceleration, self.angle.latex()
        if drive is None:
            text = f"The velocity rotates uniformly, so it has turned through ${alpha}$ after"
            return self.book.add_step("turn", text, name, self.angle / self.angular_speed, SECONDS)
        pull = self.book.magnitude(drive.strength)
        step = self.book.begin_step("turn")
        step.rest_on(self.fields.law)
        law = step.law(pull * name, launched * Call("tan", self.angle))
        step.add_text(
            f"The electric force is perpendicular to the initial velocity, so the component ${launched.latex()}$ across"
        )
        step.add_text(
            f"it does not change, while the component along it grows to ${(pull * name).latex()}$. The velocity has"
        )
        step.add_text(f"turned through ${alpha}$ when {law}, that is,")
        step.add_text(f"{step.result(name, launched * Call('tan', self.angle) / pull, SECONDS)}.")
        step.close()
        return name

    def _across(self, name: Symbol) -> Symbol:
        """Write the time after which the velocity component along the electric field is zero."""
        drive = self.fields.electric_acceleration
        assert drive is not None
        if (swing := self._swing) is not None:
            self._timed = True
            axis = AXES[drive.axis]
            text = f"{capitalized(self._who)} is at an end of its oscillation along {axis} at the start, so its"
            text = f"{text} velocity is perpendicular to the field again after half an oscillation,"
            return self.book.add_step("turn", text, name, PI / swing.frequency, SECONDS)
        rate = self.motion.rate(drive.axis, name)
        if self.is_half_turn:
            self._timed = True
            text = f"{self._who} moves perpendicular to the electric field when the rotating part of its velocity"
            return self.book.add_step(
                "turn", f"{capitalized(text)} has made half a turn, after", name, PI / self.angular_speed, SECONDS
            )
        step = self.book.begin_step("turn")
        law = step.law(rate, ZERO)
        step.rest_on(self.fields.law)
        step.add_text(
            f"{capitalized(self._who)} moves perpendicular to the field when its velocity along {AXES[drive.axis]} is"
        )
        step.add_text(f"zero: {law}.")
        step.add_text(root_sentence(self.book, step, name, rate, self.setting.time, SECONDS, SMALLEST))
        step.close()
        return name

    @property
    def is_half_turn(self) -> bool:
        """Return whether the rotating part has made half a turn: the launch has no component along the field."""
        drive = self.fields.electric_acceleration
        if drive is None or not isinstance(self.moment, AcrossField) or not isinstance(self.motion, RotatingMotion):
            return False
        return self.fields.launch[drive.axis] == ZERO and self.fields.linear_drag_rate is None

    @property
    def _swing(self) -> ElectricMotion | None:
        """Return the motion if, up to the question's moment, it is half an oscillation along the field; else None."""
        drive, motion = self.fields.electric_acceleration, self.motion
        if drive is None or not isinstance(self.moment, AcrossField) or not isinstance(motion, ElectricMotion):
            return None
        along = drive.slope is not None and drive.along == drive.axis and self.fields.launch[drive.axis] == ZERO
        return motion if along and motion.is_oscillating else None

    def _swung(self, swing: ElectricMotion, kind: str, axis: int, time: Expression) -> Expression | None:
        """Return a displacement ``s`` or velocity ``v`` after half an oscillation; None if no short formula exists."""
        drive, turning = self.fields.electric_acceleration, self.fields.turning
        if drive is not None and axis == drive.axis:
            return TWO_TURNS * swing.center if kind == "s" else None
        if turning is None:
            return None
        bent = turning * MAGNETIC_SIGNS[axis] * swing.center
        launched = self.fields.launch[axis]
        return launched + TWO_TURNS * bent if kind == "v" else (launched + bent) * time if kind == "s" else None

    def component(self, kind: str, axis: int, time: Expression) -> Expression | None:
        """Return a component of displacement ``s`` or velocity ``v`` if its formula is short; else None."""
        drive, motion = self.fields.electric_acceleration, self.motion
        if isinstance(self.moment, AcrossField) and kind == "v" and drive is not None and drive.axis == axis:
            return ZERO
        if (swing := self._swing) is not None:
            return self._swung(swing, kind, axis, time)
        return self._rotated(motion, kind, axis, time) if isinstance(motion, RotatingMotion) else None

    def _rotated(self, motion: RotatingMotion, kind: str, axis: int, time: Expression) -> Expression | None:
        """Return a displacement ``s`` or velocity ``v`` after a whole or half turn; None at other times."""
        if isinstance(self.moment, VelocityReturned):
            return motion.drift_displacement(axis, time) if kind == "s" else None
        if not self.is_half_turn:
            return None
        if kind == "v":
            return self.fields.launch[axis] - TWO_TURNS * motion.initial_rotating_velocity[axis]
        return (
            motion.drift_displacement(axis, time)
            + TWO_TURNS * motion.initial_rotating_velocity[1 - axis] * MAGNETIC_SIGNS[axis] / motion.turning
        )

    def lead_text(self, kind: str, axis: int) -> str:
        """Return the first words of a sentence about ``s`` or ``v`` after a turn; empty if no special law applies."""
        motion = self.motion
        if kind in ("v", "s") and self._swing is not None:
            return self._half_oscillation_lead(kind, axis)
        if not isinstance(motion, RotatingMotion) or kind not in ("v", "s"):
            return ""
        if isinstance(self.moment, VelocityReturned) and kind == "s":
            whose = f"the displacement of {self._who}, which along {AXES[axis]} is"
            return f"Over a whole turn, the rotating part adds nothing to {whose}"
        if not self.is_half_turn:
            return ""
        when = "" if self._timed else ", after which the velocity is perpendicular to the electric field,"
        if kind == "v":
            turned = f"Over half a turn{when} the rotating part of the velocity is reversed"
            return f"{turned}; the velocity of {self._who} along {AXES[axis]} is then"
        alone = motion.initial_rotating_velocity[1 - axis] == ZERO
        moved = f"only along {AXES[1 - axis]}" if alone else "by the diameter of its circle"
        text = f"Over half a turn{when} the rotating part moves {self._who} {moved}"
        return f"{text}; along {AXES[axis]} the displacement is"

    def _half_oscillation_lead(self, kind: str, axis: int) -> str:
        """Return the first words of a sentence about ``s`` or ``v`` after half an oscillation; empty if none apply."""
        drive, along = self.fields.electric_acceleration, AXES[axis]
        if drive is not None and axis == drive.axis:
            when = "" if self._timed else ", after which the velocity is perpendicular to the electric field,"
            text = f"Over half an oscillation{when} {self._who} moves from one end to the other"
            return f"{text}; along {along} the displacement is"
        if self.fields.turning is None:
            return ""
        if kind == "s":
            return (
                f"The mean velocity along {along} over half an oscillation is that at the centre; the displacement is"
            )
        field = AXES[1 - axis]
        ends = f"At the other end of the oscillation along {field}, twice as far along {field} as the centre"
        return f"{ends}, the velocity along {along} is"

    def chord(self, radius: Expression) -> Symbol:
        """Write the distance from the start after the velocity, of constant speed, has turned through the angle."""
        text = (
            "The distance from the starting point is the chord of the arc covered, which has this angle at the centre,"
        )
        formula = TWO_TURNS * radius * Call("sin", self.angle / TWO_TURNS)
        return self.book.add_step("chord", text, self.book.fresh("d"), formula, METRES)
