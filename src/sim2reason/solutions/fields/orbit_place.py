"""Position and velocity of a body in an elliptic orbit, also after its polar angle has grown by 90° or 180°."""

from abc import ABC, abstractmethod

from sim2reason.base.records import cached_property
from sim2reason.solutions.algebra.expressions import ONE, ZERO, Expression, Symbol
from sim2reason.solutions.algebra.functions import PI, Call, Power, Root
from sim2reason.solutions.fields.kepler import TWO, KeplerOrbit
from sim2reason.solutions.writing.notation import ACCELERATION, METRES, RADIANS, SPEED

FIELDS = ("x", "y")


class OrbitPlace(ABC):
    """The position of a body on its ellipse, with velocity and acceleration."""

    def __init__(self, orbit: KeplerOrbit) -> None:
        """Take the orbit."""
        self.orbit = orbit
        self._names: dict[tuple[str, int], Symbol] = {}

    @cached_property
    def anomaly_increase(self) -> Expression:
        """Return the increase of the eccentric anomaly since the start, in radians."""
        return self._anomaly()

    @cached_property
    def radius(self) -> Symbol:
        """Return the distance of the body from the central body."""
        return self._distance()

    @abstractmethod
    def _anomaly(self) -> Expression:
        """Write the increase of the eccentric anomaly since the start."""

    @abstractmethod
    def _distance(self) -> Symbol:
        """Write the distance of the body from the central body."""

    @abstractmethod
    def _moved(self, axis: int) -> Expression:
        """Return the displacement along an axis."""

    @abstractmethod
    def _rate(self, axis: int) -> Expression:
        """Return the velocity along an axis."""

    def component(self, kind: str, axis: int) -> Symbol:
        """Return the displacement ``s``, velocity ``v`` or acceleration ``a`` along an axis, 0 or 1."""
        known = self._names.get((kind, axis))
        if known is None:
            known = self._names[kind, axis] = self._written(kind, axis)
        return known

    def _written(self, kind: str, axis: int) -> Symbol:
        """Write a component of displacement, velocity or acceleration."""
        orbit, label = self.orbit, FIELDS[axis]
        if kind == "s":
            formula, unit, text = self._moved(axis), METRES, f"The displacement of {self._who} along {label} is"
        elif kind == "v":
            formula, unit, text = self._rate(axis), SPEED, f"The velocity of {self._who} along {label} is"
        else:
            position = orbit.place[axis] + self.component("s", axis)
            formula, unit = -(orbit.parameter * position / Power(self.radius, 3)), ACCELERATION
            text = f"The acceleration of {self._who} points to {self._star}; along {label} it is"
        rests = self._reason(kind)
        return orbit.book.add_step("component", text, orbit.named(kind, label), formula, unit, rests=rests)

    def _reason(self, kind: str) -> str:
        """Return the label of the step that gives displacements or velocities; by default ""."""
        del kind
        return ""

    @property
    def _who(self) -> str:
        """Return the name of the body."""
        return self.orbit.setting.display_name(self.orbit.body)

    @property
    def _star(self) -> str:
        """Return the name of the central body."""
        return self.orbit.setting.display_name(self.orbit.center)

    @cached_property
    def speed(self) -> Symbol:
        """Return the speed by the vis-viva equation."""
        orbit = self.orbit
        formula = Root(orbit.parameter * (TWO / self.radius - ONE / orbit.axis))
        text = f"By conservation of energy, the speed of {self._who} is"
        return orbit.book.add_step("energy", text, orbit.named("v"), formula, SPEED)

    @cached_property
    def pull(self) -> Symbol:
        """Return the magnitude of the acceleration."""
        orbit, formula = self.orbit, self.orbit.parameter / Power(self.radius, 2)
        text = f"The acceleration of {self._who} is"
        return orbit.book.add_step("attraction", text, orbit.named("a"), formula, ACCELERATION)


DIRECTION, VELOCITY = "direction of the line", "components of the velocity"  # labels of steps


class PositionAfterTurn(OrbitPlace):
    """The position after the line to a body has turned by 90° or 180°, by the polar equation of the conic."""

    def __init__(self, orbit: KeplerOrbit, quarters: int) -> None:
        """Take the orbit and the number of quarter turns, 1 or 2."""
        super().__init__(orbit)
        self._quarters = quarters
        self._sense = 1.0 if orbit.book.value(orbit.momentum) > 0.0 else -1.0

    @cached_property
    def _rectum(self) -> Symbol:
        """Return the semi-latus rectum."""
        orbit, formula = self.orbit, Power(self.orbit.momentum, 2) / self.orbit.parameter
        text = "The orbit is a conic section, whose semi-latus rectum is"
        return orbit.book.add_step("conic", text, orbit.named(r"\ell"), formula, METRES)

    @cached_property
    def _outward(self) -> Symbol:
        """Return the initial radial velocity, m/s."""
        orbit = self.orbit
        text = "The initial radial velocity is"
        return orbit.book.add_step(
            "recedes", text, orbit.named("u", "0"), orbit.position_dot_velocity / orbit.radius, SPEED
        )

    def _distance(self) -> Symbol:
        """Write the distance from ℓ/r = 1 + e cos ν: 180° later cos ν has the other sign, 90° later it is −sin ν."""
        orbit, e = self.orbit, self.orbit.eccentricity_symbol.latex()
        if self._quarters == 2:
            formula = self._rectum / (TWO - self._rectum / orbit.radius)
            begun = (self._rectum / orbit.radius - ONE).latex()
            text = rf"{self._conic}, so initially ${e} \cos\nu$ is ${begun}$. Half a turn later the cosine has the"
            text = f"{text} opposite sign:"
        else:
            formula = self._rectum / (ONE - self._across)
            swift = (self.orbit.parameter / self._swift).latex()
            text = rf"{self._conic}. The radial velocity is ${swift}\,{e} \sin\nu$, so initially ${e} \sin\nu$ is"
            text = rf"{text} ${self._across.latex()}$. A quarter turn later, $-\sin\nu$ replaces the cosine:"
        return orbit.book.add_step("conic", text, orbit.named("r"), formula, METRES)

    @property
    def _across(self) -> Expression:
        """Return e sin ν: the orbit's eccentricity times the sine of the true anomaly at the start."""
        return self._swift * self._outward / self.orbit.parameter

    @property
    def _swift(self) -> Expression:
        """Return the magnitude of the angular momentum per unit mass."""
        return self.orbit.momentum if self._sense > 0.0 else -self.orbit.momentum

    @property
    def _conic(self) -> str:
        """Return the beginning of a sentence with the equation of the conic."""
        e, rectum = self.orbit.eccentricity_symbol.latex(), self._rectum.latex()
        text = rf"On the conic section the distance is $\frac{{{rectum}}}{{1 + {e} \cos\nu}}$, with the eccentricity"
        return rf"{text} ${e}$ and the angle $\nu$ turned since the nearest point"

    def _reason(self, kind: str) -> str:
        """Return the label of the step with the direction, or with the components of the velocity."""
        return {"s": DIRECTION, "v": VELOCITY}.get(kind, "")

    @cached_property
    def _told_direction(self) -> str:
        """Write the direction from the star to the body; return the label of that step."""
        step, (x, y) = self.orbit.book.begin_step("direction"), self._direction
        line = f"The line from {self._star} to {self._who} then has the direction of"
        step.add_text(
            rf"{line} $\left({x.latex()}, {y.latex()}\right)$, which has the length ${self.orbit.radius.name}$."
        )
        step.label(DIRECTION)
        step.close()
        return DIRECTION

    @cached_property
    def _told_velocity(self) -> str:
        """Write the radial and tangential components of the velocity; return the label of that step."""
        label, outward, step = self._told_direction, self._outward_now, self.orbit.book.begin_step("direction")
        step.rest_on(label)
        across = self.orbit.momentum / self.radius
        if self._quarters == 2:
            step.add_text(
                "The radial velocity is proportional to the sine of the angle turned since the nearest point, so"
            )
            step.add_text("after half a turn it is the opposite of the initial one.")
        step.add_text(
            f"The velocity is ${outward.latex()}$ along the line from {self._star} and, by the conservation of"
        )
        step.add_text(f"angular momentum, ${across.latex()}$ at right angles to it, counted counter-clockwise.")
        step.label(VELOCITY)
        step.close()
        return VELOCITY

    @cached_property
    def _outward_now(self) -> Expression:
        """Return the radial velocity after the turn, m/s."""
        if self._quarters == 2:
            return -self._outward
        orbit = self.orbit
        cosine, e = self._rectum / orbit.radius - ONE, orbit.eccentricity_symbol.latex()
        formula = orbit.parameter / self._swift * cosine
        text = rf"The sine is what $\cos\nu$ was, and ${e} \cos\nu$ was ${cosine.latex()}$, so the radial"
        return orbit.book.add_step("recedes", f"{text} velocity is", orbit.named("u"), formula, SPEED)

    @property
    def _direction(self) -> tuple[Expression, Expression]:
        """Return both components of the direction from the centre to the body, times the initial distance."""
        x, y = self.orbit.place
        if self._quarters == 2:
            return -x, -y
        return (-y, x) if self._sense > 0.0 else (y, -x)

    def _moved(self, axis: int) -> Expression:
        _ = self.radius, self._told_direction
        return self.radius / self.orbit.radius * self._direction[axis] - self.orbit.place[axis]

    def _rate(self, axis: int) -> Expression:
        _ = self.radius, self._told_velocity
        along, across = self._direction[axis], (-self._direction[1], self._direction[0])[axis]
        first = self._outward_now / self.orbit.radius * along
        return first + self.orbit.momentum / (self.radius * self.orbit.radius) * across

    def _anomaly(self) -> Expression:
        """Return the increase of the eccentric anomaly, in radians, by Lagrange's formulas."""
        if self._quarters == 2:
            return self._opposite_end()
        return self._perpendicular() if self.orbit.position_dot_velocity != ZERO else self._from_apsis()

    def _lagrange(self, name: Symbol) -> str:
        """Return a sentence with the position after the eccentric anomaly has increased by an angle."""
        orbit = self.orbit
        less, more = orbit.weights(name)
        text = f"When ${orbit.anomaly.latex()}$ has increased by ${name.latex()}$, the position is, by Lagrange's"
        text = f"{text} formulas, the sum of the initial position times ${(ONE + less).latex()}$"
        return f"{text} and the initial velocity times ${more.latex()}$."

    def _from_apsis(self) -> Expression:
        """Return the increase of the eccentric anomaly, in radians, over a quarter turn that starts at an apsis."""
        orbit, name = self.orbit, self.orbit.named(r"\eta")
        step = orbit.book.begin_step("anomaly")
        step.add_text(self._lagrange(name))
        law = step.law(ONE + orbit.weights(name)[0], ZERO)
        step.add_text("The initial velocity is perpendicular to the initial position, so the line has turned through")
        step.add_text(rf"$90^\circ$ when {law}:")
        step.add_text(f"{step.result(name, Call('arccos', ONE - orbit.radius / orbit.axis), RADIANS)}.")
        step.close()
        return name

    def _perpendicular(self) -> Expression:
        """Return the increase η of the eccentric anomaly over a quarter turn, by a quadratic equation for cot(η/2)."""
        orbit, book, name, cot = self.orbit, self.orbit.book, self.orbit.named(r"\eta"), self.orbit.named("c")
        (less, more), r, a, q = orbit.weights(name), orbit.radius, orbit.axis, orbit.e_sin_anomaly
        step, half = book.begin_step("anomaly"), name / TWO
        step.add_text(self._lagrange(name))
        across = step.derived(Power(r, 2) * (ONE + less) + orbit.position_dot_velocity * more, ZERO)
        step.add_text("The line has turned through one or three right angles when the scalar product of this with the")
        step.add_text(
            f"initial position is zero: {across}. Let {step.law(cot, Call('cos', half) / Call('sin', half))}."
        )
        rest = TWO * r * a - Power(r, 2)
        quadratic = step.law(Power(r, 2) * Power(cot, 2) + TWO * a * q * r * cot + TWO * Power(a * q, 2), rest)
        begun = step.derived(orbit.position_dot_velocity, Root(orbit.parameter * a) * q)
        root = (Root(rest - Power(a * q, 2)) - a * q) / r
        step.add_text(
            f"Divided by {_halved(name)}, with {begun} this is {quadratic}. As ${cot.latex()}$ decreases while"
        )
        step.add_text(f"the line turns, one right angle belongs to the larger root, {step.result(cot, root, '')}.")
        step.add_text(f"So {step.result(name, PI - TWO * Call('arctan', cot), RADIANS)}.")
        step.close()
        return name

    def _opposite_end(self) -> Expression:
        """Return the increase of the eccentric anomaly, in radians, by which the line has turned through 180°."""
        orbit, name = self.orbit, self.orbit.named(r"\eta")
        if orbit.position_dot_velocity == ZERO:
            return PI
        more, half = orbit.weights(name)[1], name / TWO
        step = orbit.book.begin_step("anomaly")
        step.add_text(self._lagrange(name))
        step.add_text("The line has turned through $180^\\circ$ when the initial velocity has no part in it:")
        step.add_text(f"{step.derived(more, ZERO)}.")
        sine = rf"$\sin{name.latex()} = 2\,\sin\left({half.latex()}\right) \cos\left({half.latex()}\right)$"
        near = step.law(orbit.radius / orbit.axis * Call("cos", half) + orbit.e_sin_anomaly * Call("sin", half), ZERO)
        formula = PI + TWO * Call("arctan", orbit.axis * orbit.e_sin_anomaly / orbit.radius)
        step.add_text(f"As {sine} and {_halved(name)}, this means that {near},")
        step.add_text(f"so {step.result(name, formula, RADIANS)}.")
        step.close()
        return name


def _halved(angle: Symbol) -> str:
    """Return the formula for a cosine in terms of the half angle, in words."""
    return rf"$1 - \cos{angle.latex()} = 2\,\sin^{{2}} \left({(angle / TWO).latex()}\right)$"
