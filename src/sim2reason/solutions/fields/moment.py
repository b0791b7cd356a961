"""Moments of a charged body in fields: given positions, and extremes of speed and distance."""

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.distances import Away
from sim2reason.questions.moments.times import AtTime
from sim2reason.questions.moments.turning_points import Stopped
from sim2reason.solutions.algebra.evaluated import NumericRoot
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import PI, Call, Power, Root, sum_of_squares
from sim2reason.solutions.algebra.root_finding import SMALLEST, root_sentence
from sim2reason.solutions.fields.forces import AXES, Fields
from sim2reason.solutions.fields.magnetic_motion import CrossedFieldsMotion, QuadraticDragMotion, RotatingMotion
from sim2reason.solutions.fields.motion import ElectricMotion, FieldMotion
from sim2reason.solutions.fields.turns import REACHES, TURN_MOMENTS, FieldTurn, Reach, fastest_at_center
from sim2reason.solutions.setting import ProblemContext, capitalized, join_words
from sim2reason.solutions.writing.notation import ACCELERATION, JOULES, METRES, SECONDS, SPEED
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError

TWO, HALF = Number(2.0), Number(0.5)
SAMPLES = 400


class FieldMoment:
    """The moment of a question about a charged body, written as it is needed."""

    def __init__(self, setting: ProblemContext, book: SolutionBuilder, fields: Fields) -> None:
        """Take the problem, the solution in progress and the fields."""
        self.setting, self.book, self.fields = setting, book, fields

    @cached_property
    def motion(self) -> FieldMotion:
        """Return displacement and velocity of the body as functions of time."""
        return motion_in(self.fields, self.fields.launch)

    @cached_property
    def time(self) -> Symbol:
        """Write the time of the moment and return its symbol."""
        moment, name = self.setting.query.moment, self.fields.instant
        if isinstance(moment, AtTime):
            self.book.state_given(name.name, moment.after, SECONDS)
            return name
        if isinstance(moment, Stopped):
            return self._stopped(name)
        if isinstance(moment, TURN_MOMENTS):
            return self.turn.time(name, self.launched)
        assert isinstance(moment, Away)
        distance = self.book.fresh("d")
        self.book.state_given(distance.name, moment.value, METRES)
        if self.fields.electric_acceleration is None and self.fields.linear_drag_rate is None:
            return self._chord(distance, name)
        square, level = self._distance(name), Power(distance, 2)
        step = self.book.begin_step("time")
        law = step.law(square, level)
        who = capitalized(self.setting.display_name(self.fields.body))
        step.rest_on(self.fields.law)
        step.add_text(self._course(moved=True))
        step.add_text(f"{who} is at the distance ${distance.latex()}$ from its starting point when {law}.")
        step.add_text(root_sentence(self.book, step, name, square - level, self.setting.time, SECONDS, SMALLEST))
        step.close()
        return name

    @cached_property
    def turn(self) -> FieldTurn:
        """Return the helper for moments at which the velocity has turned, with the formulas that are short then."""
        return FieldTurn(self.setting.query.moment or AtTime(0.0), self.fields, self.motion)

    def _stopped(self, name: Symbol) -> Symbol:
        """Write the time at which a body on a line comes to rest."""
        drive, rates = self.fields.electric_acceleration, [self.motion.rate(axis, name) for axis in (0, 1)]
        kept, turns = [rate for rate in rates if rate != ZERO], self.fields.turning
        if turns is not None and self._uniform and self._from_rest:
            size = self.book.magnitude(turns)
            return self.book.add_step(
                "stop",
                "The rotating part of the velocity cancels the drift again after",
                name,
                TWO * PI / size,
                SECONDS,
            )
        if len(kept) != 1 or drive is None or drive.frequency is not None:
            raise UnsolvedError("it does not move to and fro on a line by a constant force")
        step, who = self.book.begin_step("stop"), capitalized(self.setting.display_name(self.fields.body))
        step.add_text(f"{who} comes to rest when {step.law(kept[0], ZERO)}.")
        if drive.growth is None and drive.slope is None and self.fields.linear_drag_rate is None:
            formula = -(self.fields.launch[drive.axis] / drive.strength)
            step.add_text(f"So {step.result(name, formula, SECONDS)}.")
        else:
            step.add_text(
                root_sentence(self.book, step, name, kept[0], self.setting.time, SECONDS, "The numerical solution is")
            )
        step.close()
        return name

    def _course(self, *, moved: bool = False) -> str:
        """Return a sentence with the velocity as a function of time; with `moved`, also that its integral is used."""
        time = self.fields.running_time
        parts = [(axis, self.motion.course(number, time)) for number, axis in enumerate(AXES)]
        phrases = [f"${part.latex()}$ along {axis}" for axis, part in parts if part != ZERO]
        text = f"At the time ${time.latex()}$ the velocity is {join_words(phrases)}"
        return f"{text}; integrated from 0 on, this gives the displacement." if moved else f"{text}."

    def _distance(self, time: Symbol) -> Expression:
        """Return the squared distance from the start, m², as a function of time."""
        return sum_of_squares([self.motion.displacement(axis, time) for axis in (0, 1)])

    @cached_property
    def circle(self) -> Symbol:
        """Return the radius of the circle in a magnetic field alone."""
        turns = self.fields.turning
        assert turns is not None
        size = self.book.magnitude(turns)
        who = self.setting.display_name(self.fields.body)
        text = f"The radius of the circle on which {who} moves is the speed over the magnitude of the angular velocity,"
        return self.book.add_step("circle", text, self.book.fresh("R"), self.launched / size, METRES)

    @property
    def launched(self) -> Expression:
        """Return the body's initial speed."""
        given = self.setting.given(f"{self.fields.body.rpartition('.')[0]}.start.speed")
        return Symbol(given.symbol) if given is not None else self._size(self.fields.launch)

    def _size(self, parts: list[Expression]) -> Expression:
        """Return the magnitude of a vector; that of a single component has no root."""
        kept = [part for part in parts if part != ZERO]
        if len(kept) != 1:
            return Root(sum_of_squares(parts)) if kept else ZERO
        return kept[0] if self.book.value(kept[0]) > 0.0 else -kept[0]

    @cached_property
    def speed(self) -> Expression | None:
        """Return the speed at the moment if a short formula exists: without electric field, or after a known turn."""
        fields = self.fields
        if fields.has_field:
            return self.turn.speed(self.launched) if fields.turning is None else None
        if fields.linear_drag_rate is None and not fields.has_quadratic_drag:
            return self.launched
        text = "The magnetic force does no work, so only the drag changes the speed:"
        return self.book.add_step("speed", text, self.book.fresh("v"), fields.speed(self.launched, self.time), SPEED)

    @cached_property
    def acceleration_magnitude(self) -> Expression | None:
        """Return the magnitude of the acceleration at the moment in uniform fields; None in others."""
        fields = self.fields
        drive, first = fields.electric_acceleration, fields.launch
        changing = drive is not None and (drive.frequency, drive.growth, drive.slope) != (None,) * 3
        if changing or fields.turning is None or fields.has_quadratic_drag:
            return None
        parts = [fields.acceleration(axis, ZERO, lambda n: first[n], lambda _: ZERO) for axis in (0, 1)]
        begun, name = self._size(parts), self.book.fresh("a", "0")
        begun = self.book.add_step("newton", "The acceleration at the start is", name, begun, ACCELERATION)
        if fields.linear_drag_rate is None:
            return begun
        text = "In uniform fields the magnetic force only rotates the acceleration, and the drag makes"
        formula = fields.speed(begun, self.time)
        return self.book.add_step("newton", f"{text} it decay to", self.book.fresh("a"), formula, ACCELERATION)

    def _chord(self, distance: Symbol, name: Symbol) -> Symbol:
        """Write the time at which the body is at a distance from its start on a circle."""
        turns = self.fields.turning
        assert turns is not None
        size = self.book.magnitude(turns)
        half = Call("arcsin", distance / (TWO * self.circle))
        text = "The distance is the chord of the arc covered, which gives"
        return self.book.add_step("chord", text, name, TWO / size * half, SECONDS)

    @property
    def _uniform(self) -> bool:
        """Return whether the fields are uniform and constant, without drag."""
        drive = self.fields.electric_acceleration
        changing = drive is not None and (drive.frequency, drive.growth, drive.slope) != (None,) * 3
        return not changing and self.fields.linear_drag_rate is None

    def extreme(self, query: StretchQuery) -> Symbol:
        """Write the greatest or least value of a functional over the motion, and return its symbol."""
        fields = self.fields
        if query.functional in REACHES:
            return Reach(self.motion, REACHES[query.functional], self.launched).write_distance()
        if query.functional == "greatest displacement":
            if fields.electric_acceleration is None and fields.linear_drag_rate is None:
                text = "The greatest distance is the diameter of the circle,"
                return self.book.add_step("chord", text, self.book.fresh("d"), TWO * self.circle, METRES)
            return self._farthest()
        if self._uniform and isinstance(self.motion, RotatingMotion):
            speed = self.book.add_step(*self.motion.extreme(least=query.functional.startswith("least")), SPEED)
        else:
            speed = self._fastest(-1.0 if query.functional.startswith("least") else 1.0)
        if query.functional != "greatest kinetic energy":
            return speed
        energy = HALF * fields.mass * Power(speed, 2)
        return self.book.add_step("energy", "The kinetic energy is then", self.book.fresh("K"), energy, JOULES)

    def _farthest(self) -> Symbol:
        """Write the greatest distance, where the displacement is perpendicular to the velocity."""
        time = self.fields.instant
        parts = [self.motion.displacement(axis, time) for axis in (0, 1)]
        rates = [self.motion.rate(axis, time) for axis in (0, 1)]
        kept = [part * rate for part, rate in zip(parts, rates, strict=True) if part != ZERO]
        if len(kept) == 1:
            raise UnsolvedError("it moves to and fro on a line")
        text = "The distance is extreme where the displacement is perpendicular to the velocity"
        self._write_extreme_time(parts, 1.0, kept[0] + kept[1], text, moved=True)
        return self.book.add_step(
            "extremum", "There the distance is", self.book.fresh("d"), Root(sum_of_squares(parts)), METRES
        )

    def _fastest(self, sign: float) -> Symbol:
        """Write the extreme speed, where the total power of electric force and drag is zero."""
        time, drive = self.fields.instant, self.fields.electric_acceleration
        rates = [self.motion.rate(axis, time) for axis in (0, 1)]
        near = self._sampled(time, rates, sign)
        if drive is None:
            raise UnsolvedError("the medium only slows it")
        pull = drive.at(time, lambda axis: self.motion.displacement(axis, time))
        at = {**self.book.values, time.name: near}
        if self.fields.linear_drag_rate is not None:
            work = pull * rates[drive.axis] - self.fields.linear_drag_rate * sum_of_squares(rates)
            text = "The speed is extreme where the powers of the electric force and of the drag add up to zero"
            self._write_extreme_time(rates, sign, work, text)
        elif abs(pull.value(at)) * 10.0 < abs(drive.strength.value(at)) and drive.frequency is not None:
            halves = round(drive.angle(time).value(at).real / np.pi - 0.5)
            text = f"{self._course()} The speed is extreme when the electric force passes through zero, at"
            turned = Number(halves + 0.5) * PI
            turned = turned - drive.phase if drive.phase != ZERO else turned
            self.book.add_step("extremum", text, time, turned / drive.frequency, SECONDS)
        else:
            slow = abs(rates[drive.axis].value(at)) < 0.05 * float(sum_of_squares(rates).value(at).real) ** 0.5
            if slow and isinstance(self.motion, CrossedFieldsMotion) and self.motion.is_oscillating and self._from_rest:
                return self._at_far_end(self.motion, drive.axis)
            along = "velocity along the electric field is zero" if slow else "electric force is zero"
            if not slow and sign > 0.0 and (speed := fastest_at_center(self.fields, self.launched)) is not None:
                return speed
            text = f"The speed is extreme where the {along}"
            if not slow and drive.growth is not None:
                step = self.book.begin_step("extremum")
                law = step.law(pull, ZERO)
                equation = step.result(time, -(drive.strength / drive.growth), SECONDS)
                step.rest_on(self.fields.law)
                step.add_text(self._course(), f"{text}: {law}, so {equation}.")
                step.close()
            else:
                self._write_extreme_time(rates, sign, rates[drive.axis] if slow else pull, text)
        return self.book.add_step("extremum", "The speed is then", self.book.fresh("v"), self._size(rates), SPEED)

    @property
    def _from_rest(self) -> bool:
        """Return whether the body starts from rest."""
        return self.fields.launch == [ZERO, ZERO]

    def _at_far_end(self, motion: CrossedFieldsMotion, axis: int) -> Symbol:
        """Write the speed at the far end of an oscillation along the electric field, in crossed fields."""
        turning, along = self.fields.turning, AXES[axis]
        assert turning is not None
        text = (
            "The speed is greatest at the far end of the oscillation along "
            f"{along}, whose centre is where the {along} component of the net force is zero:"
        )
        far = self.book.add_step("extremum", text, self.book.fresh(along, "1"), TWO * motion.center, METRES)
        across = turning * far
        text = f"There the velocity along {along} is zero; across it, the angular velocity times the displacement gives"
        formula = across if self.book.value(turning) * self.book.value(far) > 0.0 else -across
        return self.book.add_step("extremum", text, self.book.fresh("v"), formula, SPEED)

    def _write_extreme_time(
        self, parts: list[Expression], sign: float, residual: Expression, said: str, *, moved: bool = False
    ) -> None:
        """Write the time at which a vector has its extreme magnitude, as a zero of the condition `residual`."""
        time = self.fields.instant
        start = self._sampled(time, parts, sign)
        near = NumericRoot(residual, time.name, start).value(self.book.values).real
        step = self.book.begin_step("extremum")
        law = step.law(residual, ZERO)
        step.rest_on(self.fields.law)
        step.add_text(self._course(moved=moved))
        step.add_text(f"{said}: {law}.")
        step.add_text(root_sentence(self.book, step, time, residual, near, SECONDS, "The numerical solution is"))
        step.close()

    def _sampled(self, name: Symbol, parts: list[Expression], sign: float) -> float:
        """Return the sampled time, s, at which the magnitude of a vector is greatest (`sign` 1) or least (−1)."""
        square = sum_of_squares(parts)
        times: list[float] = np.linspace(0.0, self.setting.time, SAMPLES).tolist()
        return max(times, key=lambda t: sign * square.value({**self.book.values, name.name: t}).real)


def motion_in(fields: Fields, launch: list[Expression]) -> FieldMotion:
    """Return the motion in given fields; UnsolvedError if it has no closed form here."""
    if fields.has_quadratic_drag:
        return QuadraticDragMotion(fields, launch)
    drive = fields.electric_acceleration  # evaluated first so that its sentence comes first
    if fields.turning is not None and drive is not None and drive.along == drive.axis and drive.slope is not None:
        return CrossedFieldsMotion(fields, launch)
    if fields.turning is not None:
        return RotatingMotion(fields, launch)
    if fields.linear_drag_rate is not None:
        raise UnsolvedError("a resistance without a magnetic field")
    return ElectricMotion(fields, launch)
