"""Motion of a charged body in a plane, in fields with linear equations of motion, as functions of time."""

from abc import ABC, abstractmethod

from sim2reason.base.records import cached_property
from sim2reason.solutions.algebra.expressions import ONE, ZERO, Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import Call, Power, Root
from sim2reason.solutions.fields.forces import AXES, ElectricAcceleration, Fields
from sim2reason.solutions.writing.notation import ANGULAR_SPEED, METRES, PER_SECOND

HALF, SIXTH = Number(0.5), Number(1.0 / 6.0)


class FieldMotion(ABC):
    """Displacement and velocity as functions of time since a start with a known velocity."""

    def __init__(self, fields: Fields, launch: list[Expression]) -> None:
        """Take the fields and the initial velocity along x and y, `launch`."""
        self.fields, self.launch, self.book = fields, launch, fields.book

    @abstractmethod
    def displacement(self, axis: int, time: Expression) -> Expression:
        """Return the displacement along an axis after a time."""

    @abstractmethod
    def rate(self, axis: int, time: Expression) -> Expression:
        """Return the velocity along an axis after a time."""

    def lead_text(self, kind: str, axis: int, time: Expression) -> str:
        """Return the beginning of a sentence about a velocity ``v`` or a displacement ``s`` along an axis."""
        who, rate = self.fields.setting.display_name(self.fields.body), self.course(axis, time)
        if kind == "v":
            return f"The velocity of {who} along {AXES[axis]} is"
        if {*time.symbols()}.isdisjoint(rate.symbols()):
            return f"The displacement of {who} along {AXES[axis]} is"
        course = f"The velocity along {AXES[axis]}, ${rate.latex()}$, integrated from 0 to ${time.latex()}$,"
        return f"{course} gives the displacement of {who} along {AXES[axis]},"

    def course(self, axis: int, time: Expression) -> Expression:
        """Return the velocity along an axis as a formula that suits integration; by default the usual one."""
        return self.rate(axis, time)

    def named(self, said: str, base: str, mark: str, formula: Expression, unit: str) -> Expression:
        """Write a constant of the motion under a new name and return the name; zero and symbols need none."""
        if formula == ZERO or isinstance(formula, Symbol):
            return formula
        return self.book.add_step("motion", said, self.book.fresh(base, mark), formula, unit, rests=self.fields.law)


class ElectricMotion(FieldMotion):
    """Motion in an electric field alone."""

    def lead_text(self, kind: str, axis: int, time: Expression) -> str:
        """Return the beginning of a sentence about a displacement or velocity, with the law that gives it."""
        drive = self.fields.electric_acceleration
        if drive is None or drive.axis != axis:
            return super().lead_text(kind, axis, time)
        who, along = self.fields.setting.display_name(self.fields.body), AXES[axis]
        if drive.slope is not None and drive.along == axis:
            noun = "velocity" if kind == "v" else "displacement"
            return f"The solution that has the initial values gives the {noun} of {who} along {along},"
        if kind == "v":
            return f"Integrated from 0 to ${time.latex()}$, the equation of motion gives the velocity along {along},"
        return super().lead_text(kind, axis, time)

    def displacement(self, axis: int, time: Expression) -> Expression:
        """Return the displacement along an axis: the acceleration integrated twice."""
        drive, plain = self.fields.electric_acceleration, self.launch[axis] * time
        if drive is None or drive.axis != axis:
            return plain
        if drive.frequency is not None:
            swing = Call("cos", drive.phase) if drive.phase != ZERO else ONE
            begun = plain + drive.strength / Power(drive.frequency, 2) * (swing - Call("cos", drive.angle(time)))
            return begun - self._drift(drive) * time if drive.phase != ZERO else begun
        if drive.slope is not None and drive.along == axis:
            return self._departed(axis, time)
        third = drive.growth if drive.slope is None else drive.slope * self.launch[drive.along]
        displacement = plain + HALF * drive.strength * Power(time, 2)
        return displacement + SIXTH * third * Power(time, 3) if third is not None else displacement

    def rate(self, axis: int, time: Expression) -> Expression:
        """Return the velocity along an axis: the acceleration integrated once."""
        drive, plain = self.fields.electric_acceleration, self.launch[axis]
        if drive is None or drive.axis != axis:
            return plain
        if drive.frequency is not None:
            swung = plain + drive.strength / drive.frequency * Call("sin", drive.angle(time))
            return swung - self._drift(drive) if drive.phase != ZERO else swung
        if drive.slope is not None and drive.along == axis:
            return plain * self._even(time) + self.initial_acceleration * self._odd(time)
        second = drive.growth if drive.slope is None else drive.slope * self.launch[drive.along]
        velocity = plain + drive.strength * time
        return velocity + HALF * second * Power(time, 2) if second is not None else velocity

    def _drift(self, drive: ElectricAcceleration) -> Expression:
        """Return the reduction of the mean velocity by the initial phase of an oscillating field."""
        assert drive.frequency is not None
        return drive.strength / drive.frequency * Call("sin", drive.phase)

    # ---- a field that grows along its own direction

    @property
    def _drive(self) -> ElectricAcceleration:
        """Return the electric acceleration."""
        assert self.fields.electric_acceleration is not None
        return self.fields.electric_acceleration

    @cached_property
    def initial_acceleration(self) -> Expression:
        """Return the initial acceleration along the field."""
        return self._drive.strength

    @cached_property
    def slope(self) -> Expression:
        """Return the gradient of the acceleration along the field, 1/s²."""
        assert self._drive.slope is not None
        return self._drive.slope

    def _departed(self, axis: int, time: Expression) -> Expression:
        """Return the displacement along the field, m."""
        return self.center * (ONE - self._even(time)) + self.launch[axis] * self._odd(time)

    @cached_property
    def is_oscillating(self) -> bool:
        """Return whether the net force is a restoring force."""
        return self.book.value(self.slope) < 0.0

    @cached_property
    def frequency(self) -> Expression:
        """Return the angular frequency of the oscillation along the field, or the rate of its exponential growth."""
        along = AXES[self._drive.axis]
        if self.is_oscillating:
            text = f"The equation along {along} is that of a harmonic oscillation with the angular frequency"
            return self.named(text, r"\omega", "", Root(-self.slope), ANGULAR_SPEED)
        text = f"The equation along {along} is linear; apart from a constant its solutions are exponentials"
        text = f"{text} that grow and decay at the rate"
        return self.named(text, r"\lambda", "", Root(self.slope), PER_SECOND)

    @cached_property
    def center(self) -> Expression:
        """Return the position at which the component of the net force along the field is zero."""
        along = AXES[self._drive.axis]
        text = f"The {along} component of the net force is zero at {along} equal to"
        return self.named(text, along, "c", -(self.initial_acceleration / self.slope), METRES)

    def _even(self, time: Expression) -> Expression:
        """Return cos ωt for an oscillation along the field, or cosh λt for exponential growth."""
        phase = self.frequency * time
        return Call("cos", phase) if self.is_oscillating else HALF * (Call("exp", phase) + Call("exp", -phase))

    def _odd(self, time: Expression) -> Expression:
        """Return sin(ωt)/ω for an oscillation along the field, or sinh(λt)/λ for exponential growth."""
        phase = self.frequency * time
        if self.is_oscillating:
            return Call("sin", phase) / self.frequency
        return (Call("exp", phase) - Call("exp", -phase)) / (2.0 * self.frequency)
