"""Total angles of swings, small oscillations of rigid bodies, and forces of a fixed axle."""

from abc import abstractmethod
from collections.abc import Callable
from math import ceil, pi

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.questions.phrasing import PeriodQuery
from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.quantities.subjects.rotating_parts import ACROSS
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import PI, Call, Power, Root, sum_of_squares
from sim2reason.solutions.algebra.polynomials import Polynomial
from sim2reason.solutions.oscillations.harmonic import measured_period
from sim2reason.solutions.setting import join_words
from sim2reason.solutions.swings.angle import UP, SwingAngle
from sim2reason.solutions.swings.arm import Arm
from sim2reason.solutions.writing.notation import ANGULAR_ACCELERATION, ANGULAR_SPEED, METRES, latex
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError

FORCE, MASS = latex("N"), latex("kg")
RIGHT_ANGLE_TOLERANCE = 1e-12  # largest cosine of an angle that counts as a right angle
LINE = "the line from the centre of mass to the axle"
TOWARDS = f"By Newton's second law for the centre of mass, along {LINE}, the axle exerts the force component"
UPWARDS = "Perpendicular to that line and upwards, against the tangential acceleration, it exerts the component"
VERTICAL_FORCE_LEAD = (
    "With the centre of mass straight below or above the axle, gravity has no tangential component; by Newton's second "
    "law, the axle exerts the vertical force"
)
SIDEWAYS = (
    f"At rest, with {LINE} level, the axle exerts no force along this line; by Newton's second law, perpendicular to "
    "it, it exerts the force"
)
RIGHT_ANGLE = "The two components are perpendicular to each other, so the magnitude of the force is"
UPWARD = (
    "By Newton's second law, with the weight and with the upward parts of the centripetal and the tangential "
    "acceleration of the centre of mass, the upward component of the force is"
)
RIGHTWARD = (
    "The axle exerts the only horizontal force, so by Newton's second law, with the parts to the right of the "
    "centripetal and the tangential acceleration of the centre of mass, the rightward component is"
)


class AxleForces(SwingAngle):
    """A swing about a fixed axle, with the force that the axle exerts.

    Subclasses set `arm` and `gravity`, the acceleration of free fall.
    """

    arm: Arm
    gravity: Expression
    senses = UP, ACROSS

    @cached_property
    @abstractmethod
    def rate(self) -> Expression:
        """Return the angular speed at the moment, rad/s."""

    @cached_property
    def angular_acceleration(self) -> Expression:
        """Write the magnitude of the angular acceleration, rad/s², and return it."""
        if self.sine == ZERO:
            return ZERO
        moment = self.arm.moment
        size = self.book.magnitude(moment)
        formula = size * self.gravity * self.sine / self.arm.inertia
        text = "Apart from its sign, the angular acceleration is the torque of gravity over the moment of inertia,"
        return self.book.add_step("torque", text, self.book.fresh(r"\alpha"), formula, ANGULAR_ACCELERATION)

    # ---- all bodies as one

    @cached_property
    def whole(self) -> Expression:
        """Write the total mass, kg, and return it."""
        masses = [self.arm.piece(body).mass for body in self.arm.bodies]
        if len(masses) == 1:
            return masses[0]
        total: Expression = ZERO
        for mass in masses:
            total = total + mass
        return self.book.add_step("mass", "The total mass is", self.book.fresh("M"), total, MASS)

    @cached_property
    def lever(self) -> Expression:
        """Write the distance of the common centre of mass from the axle, m, and return it."""
        if len(self.arm.bodies) == 1:
            position = self.arm.piece(self.arm.bodies[0]).place
            return self.book.magnitude(position)
        moment = self.arm.moment
        formula = (moment if self.is_falling else -moment) / self.whole
        text = "The distance of the common centre of mass from the axle is"
        return self.book.add_step("place", text, self.book.fresh("d", r"\text{cm}"), formula, METRES)

    @property
    def _below(self) -> Expression:
        """Return the cosine of the angle of the centre of mass with the downward vertical; zero for a right angle."""
        cosine = self.cosine if self.is_falling else -self.cosine
        return (
            ZERO if not self.book.is_hidden(cosine) and abs(self.book.value(cosine)) < RIGHT_ANGLE_TOLERANCE else cosine
        )

    # ---- components

    @cached_property
    def _inward(self) -> Expression:
        """Return the force component F_r towards the axle, in N."""
        bend = self.lever * sum_of_squares([self.rate])
        return self.whole * (self.gravity * self._below + bend)

    @cached_property
    def _aside(self) -> Expression:
        """Return the force component F_t perpendicular to the line to the axle, in N."""
        if self.sine == ZERO:
            return ZERO
        return self.whole * (self.gravity * self.sine - self.lever * self.angular_acceleration)

    @cached_property
    def _both(self) -> tuple[Symbol, Symbol]:
        """Write the force components F_r and F_t, and return their symbols."""
        inward, aside = self._inward, self._aside
        one = self.book.add_step("force", TOWARDS, self.book.fresh("F", "r"), inward, FORCE)
        other = self.book.add_step("force", UPWARDS, self.book.fresh("F", "t"), aside, FORCE)
        return one, other

    @property
    def _projected(self) -> bool:
        """Return whether a component along an axis of the world frame is asked for."""
        target = self.setting.query.target
        return target is not None and target.sense is not None

    def axle_force(self) -> Expression:
        """Return the magnitude of the axle force, or the component that is asked for, in N."""
        if self._projected:
            return self._upward() if self.vertical else self._rightward()
        if ZERO in (self._inward, self._aside):
            return self._inward + self._aside
        inward, aside = self._both
        return Root(Power(inward, 2) + Power(aside, 2))

    @property
    def _moment(self) -> Expression:
        """Return M d, the total mass times the distance of the common centre of mass from the axle, kg m."""
        return self.arm.moment if self.is_falling else -self.arm.moment

    def _upward(self) -> Expression:
        rises = sum_of_squares([self.rate]) * self._below - self.angular_acceleration * self.sine
        return self.whole * self.gravity + self._moment * rises

    def _rightward(self) -> Expression:
        """Return the horizontal component of the axle force, N, in which M appears only within M d."""
        inward = self._moment * (sum_of_squares([self.rate]) * self.sine + self.angular_acceleration * self._below)
        first_on_right = (self.moment_angle >= 0.0) == self.arm.begins_right
        return -inward if first_on_right == self.is_falling else inward

    def axle_force_lead(self) -> str:
        """Return the words before the formula of the axle force."""
        if self._projected and not self.vertical:
            return RIGHTWARD
        if self.sine == ZERO:
            return VERTICAL_FORCE_LEAD
        if self._projected:
            return UPWARD
        return SIDEWAYS if self._inward == ZERO else RIGHT_ANGLE


HARMONIC = "This is the moment of inertia times the angular acceleration, so"


def small_oscillations(arm: Arm, book: SolutionBuilder, query: PeriodQuery) -> Symbol:
    """Write the period of small oscillations, with ω² = m g d/I, and return its symbol."""
    size = book.magnitude(arm.moment)
    torque, inertia, angle = size * arm.gravity, arm.inertia, book.fresh(r"\varphi")
    step, exact, near = book.begin_step("torque"), -(torque * Call("sin", angle)), -(torque * angle)
    step.add_text(
        f"At the angle ${angle.name}$ from the stable equilibrium the torque of gravity is ${exact.latex()}$, nearly "
        f"${near.latex()}$ where the angle is small."
    )
    step.close()
    text = f"{HARMONIC} the oscillation is harmonic with the angular frequency"
    rate = book.add_step("oscillation", text, book.fresh(r"\omega"), Root(torque / inertia), ANGULAR_SPEED)
    return measured_period(book, query, rate)


SAMPLES = 48  # minimum number of samples per period of small oscillations
DOUBLE_RATIO = 2
REST_RATE_RTOL = 1e-7  # relative to the greatest rate: below it the body counts as at rest

Seen = Callable[[Array], tuple[Array, Array]]
"""Angles and their rates at times, each (n,)."""


def total_angle(swing: SwingAngle, seen: Seen) -> Expression:
    """Return the total angle turned, with all reversals; the engine's motion `seen` only decides signs and counts."""
    end = swing.setting.time
    count = SAMPLES * max(1, ceil(end * swing.book.value(swing.small_oscillation_frequency) / (2.0 * pi)))
    angles, rates = seen(np.linspace(0.0, end, count + 1))
    kept = np.sign(rates[np.abs(rates) > REST_RATE_RTOL * np.abs(rates).max()])
    turns = int((kept[1:] != kept[:-1]).sum()) + swing.is_at_rest
    if swing.goes_round:
        return _round(swing, float(np.unwrap(angles)[-1]))
    if not swing.is_falling:
        raise UnsolvedError("its centre of mass is on the other side of the axle")
    if not turns:
        return swing.between
    sense = float(kept[0])
    _write_swing_range(swing, turns, sense)
    reach, angle = Polynomial.from_expression(swing.reach), _place(swing.initial_angle).scale(-sense)
    angle = angle + reach.scale(2.0 * turns - 1.0)
    if not swing.is_at_rest:
        angle = angle + reach - _place(swing.angle).scale(sense if turns % 2 else -sense)
    return angle.factored()


def _write_swing_range(swing: SwingAngle, turns: int, sense: float) -> None:
    """Write the angles between which the body swings in turn, up to its position at the moment."""
    inward, ends = sense < 0.0 and swing.initial_angle != ZERO, ZERO if swing.is_at_rest else swing.angle
    reach, through = f"${swing.reach.latex()}$", " through the lowest point"
    begins = f"${swing.initial_angle.latex()}$" if swing.initial_angle != ZERO else "the lowest point"
    clauses = [f"From {begins} it swings{through if inward else ''} to {reach}{' on the other side' if inward else ''}"]
    if turns > 1:
        often = "once" if turns == DOUBLE_RATIO else f"{turns - 1} times"
        clauses.append(f"{often} from one turning point to the other")
    if not swing.is_at_rest:
        side = sense if turns % 2 else -sense
        crosses = ends != ZERO and side * swing.book.value(ends) < 0.0
        size = f"${(-ends if ends.negative else ends).latex()}$" if ends != ZERO else "the lowest point"
        clauses.append(f"back{through if crosses else ''} to {size}")
    step = swing.book.begin_step("names")
    step.add_text(f"{join_words(clauses)}.")
    step.close()


def _round(swing: SwingAngle, end: float) -> Expression:
    """Return the angle turned by a swing that goes right round, in half turns if it ends upright."""
    halves = round(end / pi)
    there = swing.angle
    if there == ZERO or isinstance(there, Number):
        there = Number(float(halves)) * PI if halves else ZERO
    difference = there - swing.initial_angle
    return difference if swing.book.value(difference) >= 0.0 else -difference


def _place(angle: Expression) -> Polynomial:
    """Convert an angle, or its negative, to a polynomial with that sign."""
    if angle == ZERO:
        return Polynomial({})
    negative = angle.latex().startswith("-")
    return Polynomial.from_expression(-angle).scale(-1.0) if negative else Polynomial.from_expression(angle)
