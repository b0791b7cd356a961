"""Motion of a charge in a magnetic field: in crossed fields, or with drag."""

from functools import reduce

from sim2reason.base.records import cached_property
from sim2reason.solutions.algebra.expressions import ONE, ZERO, Expression, Number, Product, Symbol, multiply_factors
from sim2reason.solutions.algebra.functions import Call, Power, Root, vector_length
from sim2reason.solutions.fields.forces import AXES, MAGNETIC_SIGNS, ElectricAcceleration, Fields
from sim2reason.solutions.fields.motion import ElectricMotion, FieldMotion
from sim2reason.solutions.setting import join_words
from sim2reason.solutions.writing.notation import ACCELERATION, METRES, PER_SECOND_SQUARED, SPEED
from sim2reason.solutions.writing.steps import UnsolvedError

HALF = Number(0.5)


class CrossedFieldsMotion(ElectricMotion):
    """Motion in an electric field that varies along its own direction, across a uniform magnetic field.

    The velocity across the field changes by Ω times the displacement along it, so the force along it is linear.
    """

    _displacement: Expression | None = None

    @property
    def _turning(self) -> Symbol:
        assert self.fields.turning is not None
        return self.fields.turning

    @cached_property
    def initial_acceleration(self) -> Expression:
        """Return the initial acceleration along the electric field, with the magnetic force."""
        axis = self._drive.axis
        turned = self._turning * self.launch[1 - axis] * MAGNETIC_SIGNS[axis]
        if turned == ZERO:
            return self._drive.strength
        text = f"With the magnetic force, the initial acceleration along {AXES[axis]} is"
        return self.named(text, "a", "0", self._drive.strength + turned, ACCELERATION)

    @cached_property
    def slope(self) -> Expression:
        """Return the gradient of the acceleration along the electric field, reduced by the magnetic force, 1/s²."""
        assert self._drive.slope is not None
        along, across = AXES[self._drive.axis], AXES[1 - self._drive.axis]
        turned = self._turning * self.fields.places[self._drive.axis] * MAGNETIC_SIGNS[1 - self._drive.axis]
        other = (self.launch[1 - self._drive.axis] + turned).latex()
        text = f"The equation along {across}, integrated, gives the velocity ${other}$; with it, the acceleration along"
        text = f"{text} {along} changes with {along} at the rate"
        return self.named(text, "k", along, self._drive.slope - Power(self._turning, 2), PER_SECOND_SQUARED)

    def displacement(self, axis: int, time: Expression) -> Expression:
        """Return a displacement component: an oscillation along the electric field, an integral across it."""
        along = self._drive.axis
        if axis == along:
            return self._along(time)
        summed = self.center * (time - self._odd(time)) - self.launch[along] * (ONE - self._even(time)) / self.slope
        return self.launch[axis] * time + self._turning * MAGNETIC_SIGNS[axis] * summed

    def rate(self, axis: int, time: Expression) -> Expression:
        """Return a velocity component; that across the electric field is linear in the displacement along the field."""
        along = self._drive.axis
        if axis == along:
            return super().rate(axis, time)
        return self.launch[axis] + self._turning * MAGNETIC_SIGNS[axis] * self._along(time)

    def _along(self, time: Expression) -> Expression:
        """Return the displacement along the electric field, as a named symbol at the moment asked about."""
        if not isinstance(time, Symbol) or time.name not in self.book.values:
            return self._departed(self._drive.axis, time)
        if self._displacement is None:
            axis = self._drive.axis
            formula = self._departed(axis, time)
            self._displacement = self.named(self.lead_text("s", axis, time), "s", AXES[axis], formula, METRES)
        return self._displacement


class QuadraticDragMotion(FieldMotion):
    """Motion in a magnetic field with quadratic drag."""

    def rate(self, axis: int, time: Expression) -> Expression:
        """Return a component of the initial velocity, rotated and divided by 1 + γ t, as quadratic drag reduces it."""
        component, turning = self.launch[axis], self.fields.turning
        if turning is not None:
            across = self.launch[1 - axis] * MAGNETIC_SIGNS[axis]
            component = component * Call("cos", turning * time) + across * Call("sin", turning * time)
        return component / (ONE + self.fields.drag * time)

    def displacement(self, axis: int, time: Expression) -> Expression:
        """Raise UnsolvedError: the displacement has no closed form."""
        del axis, time
        raise UnsolvedError("the way in such a medium has no closed form")


class RotatingMotion(FieldMotion):
    """Motion in a uniform magnetic field, perhaps with a uniform electric field and linear drag.

    The velocity is the sum of a drift, such as E/B, and a part that rotates at the rate Ω and decays with drag.
    """

    def __init__(self, fields: Fields, launch: list[Expression]) -> None:
        """Take the fields and the initial velocity; UnsolvedError for an electric field that depends on position."""
        super().__init__(fields, launch)
        turning, drive = fields.turning, fields.electric_acceleration
        assert turning is not None
        changing = drive is not None and (drive.growth is not None or drive.frequency is not None)
        if drive is not None and (drive.slope is not None or (changing and fields.linear_drag_rate is not None)):
            raise UnsolvedError("a magnetic field with an electric one that depends on the place")
        self.turning: Symbol = turning
        self.drive = drive

    @cached_property
    def _drift(self) -> list[Expression]:
        """Return the drift velocity along x and y, or its amplitudes in a varying field."""
        drift: list[Expression] = [ZERO, ZERO]
        drive = self.drive
        if drive is None:
            return drift
        i, f, turns = drive.axis, drive.strength, self.turning
        if self.fields.linear_drag_rate is not None:
            both = Power(self.fields.linear_drag_rate, 2) + Power(turns, 2)
            drift[i], drift[1 - i] = self.fields.linear_drag_rate * f / both, -(turns * f / both) * MAGNETIC_SIGNS[i]
        elif drive.frequency is not None:
            gap = Power(drive.frequency, 2) - Power(turns, 2)
            drift[i], drift[1 - i] = f * drive.frequency / gap, f * turns / gap * MAGNETIC_SIGNS[i]
        else:
            drift[1 - i] = -(f / turns) * MAGNETIC_SIGNS[i]
            if drive.growth is not None:
                drift[i] = drive.growth / Power(turns, 2)
        return self._told_drift(drive, drift)

    def _told_drift(self, drive: ElectricAcceleration, formulas: list[Expression]) -> list[Expression]:
        """Write the drift velocity and its derivation from the equations of motion; return its components."""
        step = self.book.begin_step("motion")
        step.rest_on(self.fields.law)
        names: list[Expression] = [self.book.fresh("u", AXES[n]) if formulas[n] != ZERO else ZERO for n in (0, 1)]
        laws = [step.law(*sides) for sides in self._kept_laws(drive, names) if sides[0] != sides[1]]
        step.add_text(f"{self._said_drift(drive, names)} {join_words(laws)},")
        equations = [
            step.result(name, formula, SPEED)
            for name, formula in zip(names, formulas, strict=True)
            if isinstance(name, Symbol)
        ]
        step.add_text(f"so {join_words(equations)}.")
        step.close()
        return names

    def _said_drift(self, drive: ElectricAcceleration, names: list[Expression]) -> str:
        """Return the beginning of a sentence about the form of the drift velocity."""
        if drive.frequency is not None:
            what = "a forced velocity"
        elif drive.growth is not None:
            what = "a drift velocity"
        elif ZERO in names:
            axis = 1 - drive.axis
            return f"Their constant solution is the drift velocity ${names[axis].latex()}$ along {AXES[axis]}, with"
        else:
            what = "a constant drift velocity"
        parts = [self._drift_velocity_of(drive, names[n], n, self.fields.running_time).latex() for n in (0, 1)]
        return (
            f"A particular solution is {what} with the components ${parts[0]}$ along x and ${parts[1]}$ along y, where"
        )

    def _kept_laws(self, drive: ElectricAcceleration, names: list[Expression]) -> list[tuple[Expression, Expression]]:
        """Return both equations of motion for the drift velocity, without their common time dependence."""
        equations: list[tuple[Expression, Expression]] = []
        for axis in (0, 1):
            right: Expression = drive.strength if axis == drive.axis else ZERO
            right = right + self.turning * names[1 - axis] * MAGNETIC_SIGNS[axis]
            if self.fields.linear_drag_rate is not None:
                right = right - self.fields.linear_drag_rate * names[axis]
            if drive.frequency is not None:
                left = drive.frequency * names[axis]
                equations.append((left if axis == drive.axis else -left, right))
            elif drive.growth is not None and axis != drive.axis:
                equations.append((-(drive.growth / self.turning) * MAGNETIC_SIGNS[drive.axis], right))
            else:
                equations.append((right, ZERO))
        return equations

    @cached_property
    def initial_rotating_velocity(self) -> list[Expression]:
        """Write and return the initial components of the velocity relative to the drift, which rotates."""
        still = [self._drift_velocity(axis, None) for axis in (0, 1)]
        formulas = [begins - kept for begins, kept in zip(self.launch, still, strict=True)]
        step, phrases = self.book.begin_step("motion"), list[str]()
        step.rest_on(self.fields.law)
        components: list[Expression] = []
        for axis, formula in zip(AXES, formulas, strict=True):
            if formula == ZERO or isinstance(formula, Symbol):
                components.append(formula)
                rendered = "zero" if formula == ZERO else f"${formula.latex()}$"
            else:
                components.append(name := self.book.fresh("w", axis))
                rendered = step.result(name, formula, SPEED, law=True)
            phrases.append(f"the {axis} component {rendered}")
        decays = (
            ""
            if self.fields.linear_drag_rate is None
            else f" and decays as ${self._left(self.fields.running_time).latex()}$"
        )
        turns = f"rotates at ${self.turning.latex()}${decays}"
        if self.drive is None:
            step.add_text(f"The velocity {turns}.")
        else:
            step.add_text(f"Added to it is a velocity that, as without the electric field, {turns}.")
        step.add_text(f"It initially has {join_words(phrases)}.")
        step.close()
        return components

    def _left(self, time: Expression) -> Expression:
        """Return the factor by which linear drag has reduced the rotating part of the velocity at a time."""
        assert self.fields.linear_drag_rate is not None
        return Call("exp", -(self.fields.linear_drag_rate * time))

    def _drift_velocity(self, axis: int, time: Expression | None) -> Expression:
        """Return the drift velocity along an axis at a time; for None, the drift velocity at the start."""
        return ZERO if self.drive is None else self._drift_velocity_of(self.drive, self._drift[axis], axis, time)

    def _drift_velocity_of(
        self, drive: ElectricAcceleration, drift: Expression, axis: int, time: Expression | None
    ) -> Expression:
        """Return the drift velocity along an axis at a time, given its amplitude."""
        if drive.frequency is not None:
            if time is None:
                return ZERO if axis == drive.axis else drift
            return drift * Call("sin" if axis == drive.axis else "cos", drive.frequency * time)
        if drive.growth is not None and axis != drive.axis and time is not None:
            return drift - drive.growth / self.turning * time * MAGNETIC_SIGNS[drive.axis]
        return drift

    def drift_displacement(self, axis: int, time: Expression) -> Expression:
        """Return the displacement along an axis, m, due to the drift velocity."""
        drive, drift = self.drive, self._drift[axis]
        if drive is None:
            return ZERO
        if drive.frequency is not None:
            phase = drive.frequency * time
            part = ONE - Call("cos", phase) if axis == drive.axis else Call("sin", phase)
            return drift / drive.frequency * part
        displacement = drift * time
        if drive.growth is not None and axis != drive.axis:
            displacement = (
                displacement - HALF * drive.growth / self.turning * Power(time, 2) * MAGNETIC_SIGNS[drive.axis]
            )
        return displacement

    @cached_property
    def _heading(self) -> tuple[Expression, Expression] | None:
        """Return the initial speed and direction if only the magnetic force acts; None otherwise."""
        alone = self.drive is None and self.fields.linear_drag_rate is None
        x, y = (component.factors if isinstance(component, Product) else () for component in self.launch)
        if not alone or not x or not y or x[:-1] != y[:-1]:
            return None
        one, other = x[-1], y[-1]
        if not (isinstance(one, Call) and isinstance(other, Call) and one.argument == other.argument):
            return None
        return (
            (reduce(multiply_factors, x[:-1]), one.argument)
            if (one.function, other.function) == ("cos", "sin")
            else None
        )

    def lead_text(self, kind: str, axis: int, time: Expression) -> str:
        """Return the beginning of a sentence about a displacement or velocity."""
        if kind == "v" and self._heading is not None:
            return f"The magnetic force only rotates the velocity, so the {AXES[axis]} component of the velocity is"
        return super().lead_text(kind, axis, time)

    def rate(self, axis: int, time: Expression) -> Expression:
        """Return a velocity component, m/s: the drift plus the rotating part."""
        if self._heading is not None:
            speed, angle = self._heading
            return speed * Call("sin" if axis else "cos", angle - self.turning * time)
        return self.course(axis, time)

    def course(self, axis: int, time: Expression) -> Expression:
        """Return a velocity component in terms of the initial components."""
        here, other = (
            self.initial_rotating_velocity[axis],
            self.initial_rotating_velocity[1 - axis] * MAGNETIC_SIGNS[axis],
        )
        phase = self.turning * time
        turned = here * Call("cos", phase) + other * Call("sin", phase)
        if self.fields.linear_drag_rate is not None:
            turned = self._left(time) * turned
        return self._drift_velocity(axis, time) + turned

    def displacement(self, axis: int, time: Expression) -> Expression:
        """Return the displacement along an axis, m: the integral of the velocity."""
        here, other = (
            self.initial_rotating_velocity[axis],
            self.initial_rotating_velocity[1 - axis] * MAGNETIC_SIGNS[axis],
        )
        turns, damping, phase = self.turning, self.fields.linear_drag_rate, self.turning * time
        sine, cosine = Call("sin", phase), Call("cos", phase)
        if damping is None:
            return self.drift_displacement(axis, time) + (here * sine + other * (ONE - cosine)) / turns
        left, both = self._left(time), Power(damping, 2) + Power(turns, 2)
        even = damping - left * (damping * cosine - turns * sine)
        odd = turns - left * (turns * cosine + damping * sine)
        return self.drift_displacement(axis, time) + (here * even + other * odd) / both

    def extreme(self, *, least: bool) -> tuple[str, str, Symbol, Expression]:
        """Return step kind, sentence, symbol and formula of the extreme speed in uniform fields: drift ± rotation."""
        if all(part == ZERO for part in self._drift):
            text = "The magnetic force is perpendicular to the velocity and does no work, so the speed is always"
            return "extremum", text, self.book.fresh("v"), vector_length(self.initial_rotating_velocity)
        sizes: list[Expression] = []
        for parts in (self._drift, self.initial_rotating_velocity):
            kept = [part for part in parts if part != ZERO]
            square = Power(parts[0], 2) + Power(parts[1], 2)
            size = kept[0] if self.book.value(kept[0]) > 0.0 else -kept[0]
            sizes.append(size if len(kept) == 1 else Root(square))
        one, other = sizes if self.book.value(sizes[0]) >= self.book.value(sizes[1]) else sizes[::-1]
        text = (
            "The velocity goes round a circle about the drift velocity, whose radius is the size of the rotating part; "
        )
        text += "this is alternately parallel and opposite to the drift, so the "
        text += "least speed is" if least else "greatest speed is"
        return "extremum", text, self.book.fresh("v"), one - other if least else one + other
