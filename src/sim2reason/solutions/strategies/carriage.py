"""Carriage: a swing on a freely sliding carriage, by momentum along the rail, energy and Newton's law."""

from collections.abc import Mapping
from typing import ClassVar

import numpy as np

from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.angles import Deflected, TurnedThrough
from sim2reason.questions.moments.distances import Moved
from sim2reason.questions.moments.times import AtStart
from sim2reason.questions.moments.turning_points import HighestPoint, LowestPoint, Stopped
from sim2reason.questions.phrasing import PeriodQuery
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol
from sim2reason.solutions.algebra.functions import Power, Root, sum_of_squares
from sim2reason.solutions.oscillations.harmonic import measured_period
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.strategies import Strategy, strategy
from sim2reason.solutions.swings.angle import FormulaMethod
from sim2reason.solutions.swings.asked import quantity_of
from sim2reason.solutions.swings.carriage import carriage_system
from sim2reason.solutions.swings.carriage_angle import TWO
from sim2reason.solutions.swings.carriage_laws import HALF, CarriageLaws
from sim2reason.solutions.writing.notation import (
    ANGULAR_SPEED,
    INERTIA,
    KILOGRAMS,
)
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError

MOMENTS = (AtStart, Deflected, HighestPoint, LowestPoint, Moved, Stopped, TurnedThrough)
PATH_LENGTH_RTOL = 1e-6  # relative tolerance between path length and displacement of a motion without turning back
PATH_SAMPLES = 401


@strategy
class OnACarriage(Strategy):
    """The strategy for swings on a carriage, at the start or at a known angle; it gives no times."""

    name = "momentum and energy on a carriage"
    cost = 1.1
    kinds = frozenset({"start", "event", "extremum", "period", "sum"})

    def why_unsuitable(self, mechanism: Mechanism) -> str:
        """Return the reason, in words, that no body swings on a sliding carriage; empty if a body does."""
        return "" if carriage_system(mechanism) is not None else "nothing swings on a carriage that slides freely"

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        query = setting.query
        if isinstance(query, PeriodQuery):
            return "" if query.small else "only integration gives the time of a large swing"
        if quantity_of(setting) not in _Asked.METHOD_BY_QUANTITY:
            return f"no way to the quantity {quantity_of(setting)}"
        known = isinstance(query.moment, MOMENTS) or (isinstance(query, StretchQuery) and query.kind == "extremum")
        if "slack" in setting.earlier_event_kinds:
            return "a string goes slack"
        return "" if known else "only integration gives the angle"

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the angle, the conserved quantities and the answer, and return the answer's symbol."""
        return _Asked(setting, book).write().name


class _Asked(CarriageLaws):
    """The quantities of the arm, of bodies on it, or of bodies that move with the carriage."""

    def write(self) -> Symbol:
        """Write the answer to the query and return the answer's symbol."""
        query = self.setting.query
        if isinstance(query, PeriodQuery):
            return self._period(query)
        return super().write()

    @property
    def subject(self) -> str:
        """Return the subject of the question."""
        return self.setting.query.subject

    @property
    def _rides(self) -> bool:
        """Return whether the subject moves along with the carriage."""
        return self.subject in self.carriage.moving_along

    @property
    def _weighs(self) -> Expression:
        """Return the mass of the subject, kg."""
        return self.carriage.mass(self.subject)

    @property
    def _radius(self) -> Expression:
        return self.arm.piece(self.subject).place

    # ---- small oscillations

    def _period(self, query: PeriodQuery) -> Symbol:
        """Write the period of small oscillations, in which arm and carriage swing against each other."""
        self.unloaded()
        book, c = self.book, self.carriage
        if self.is_single_body:
            text = "The relative motion is that of a body with the reduced mass"
            reduced = book.add_step(
                "reduced", text, book.fresh(r"\mu"), c.sliding_mass * self.mass / c.total_mass, KILOGRAMS
            )
            text = "For small oscillations the restoring force is proportional to the displacement, so"
            formula = Root(self.mass * self.gravity / (self.length * reduced))
        else:
            text = "As the momentum along the rail is zero, the carriage recoils; the effective moment of inertia is"
            formula = self.arm.inertia - Power(self.moment, 2) / c.total_mass
            reduced = book.add_step("reduced", text, book.fresh("I", r"\text{r}"), formula, INERTIA)
            text = "For small angles the restoring torque is proportional to the angle, so"
            formula = Root(book.magnitude(self.moment) * self.gravity / reduced)
        rate = book.add_step("oscillation", text, book.fresh(r"\omega"), formula, ANGULAR_SPEED)
        return measured_period(book, query, rate)

    # ---- how fast

    def _ahead(self) -> Expression:
        """Return the velocity of the subject on the arm along the rail, m/s, positive against the carriage's motion."""
        if self._straight:
            return self.carriage.sliding_mass * self.speed / self.mass
        return self._radius * self.rate * self.cosine - self.speed

    @property
    def _straight(self) -> bool:
        """Return whether momentum alone gives the velocity of a single swinging body, as at its lowest point."""
        return (
            self.is_single_body
            and self.sine == ZERO
            and self.driving_force == ZERO
            and ZERO not in (self.rate, self.speed)
        )

    def lead_text(self, quantity: str) -> str:
        """Return the words before the formula of a quantity, such as *By conservation of momentum, the velocity is*."""
        lead = f"By conservation of momentum, {self.setting.display_name(self.subject)} has the velocity "
        if (
            self._rides
            or quantity not in ("velocity", "kinetic energy", "momentum")
            or self.vertical
            or not self._straight
        ):
            return super().lead_text(quantity)
        if quantity == "velocity":
            return f"By conservation of momentum, the velocity of {self.setting.display_name(self.subject)} is"
        return f"{lead}${self._ahead().latex()}$, so its {quantity} is"

    def _rising(self) -> Expression:
        """Return the upward velocity of the subject on the arm, m/s."""
        if self._rides:
            raise UnsolvedError("what rides is asked along the rail")
        up = self._radius * self.rate * self.sine
        return up if self.moment_angle * self.turning >= 0.0 else -up

    def _squared(self) -> Expression:
        if self._rides:
            return sum_of_squares([self.speed])
        up = self._radius * self.rate * self.sine
        return sum_of_squares([self._ahead(), up])

    def _velocity(self) -> Expression:
        if self.vertical:
            return self._rising()
        if self._rides:
            return self.speed
        return self._ahead() if self.sine == ZERO else Root(self._squared())

    def _momentum(self) -> Expression:
        return self._weighs * self._velocity()

    def _kinetic(self) -> Expression:
        spinning = ZERO if self._rides else self._spinning()
        return self._moving_energy() + spinning

    def _moving_energy(self) -> Expression:
        return HALF * self._weighs * self._squared()

    def _spinning(self) -> Expression:
        inertia = self.arm.piece(self.subject).inertia
        return HALF * inertia * Power(self.rate, 2) if ZERO not in (inertia, self.rate) else ZERO

    def _turning(self) -> Expression:
        return self.rate

    def _angular_momentum(self) -> Expression:
        return self.arm.piece(self.subject).inertia * self.rate

    # ---- where

    def _chord(self) -> Expression:
        if self.vertical:
            return self._height()
        if self._rides:
            return self.place
        r = self._radius
        across, up = r * (self.sine_first - self.signed_sine) - self.place, r * (self.cosine - self.cosine_first)
        return across if self.angle == -self.initial_angle else Root(sum_of_squares([across, up]))

    def _height(self) -> Expression:
        if self._rides:
            raise UnsolvedError("how high it is follows from no angle")
        return self._radius * (self.cosine_first - self.cosine)

    def _potential(self) -> Expression:
        return self._weighs * self.gravity * self._height()

    def _travelled(self) -> Expression:
        """Return the distance travelled by the carriage; UnsolvedError if it turns back."""
        if not self._rides:
            raise UnsolvedError("a curved path")
        m = self.setting.mechanism
        times = np.linspace(0.0, self.setting.time, PATH_SAMPLES)
        ways = self.setting.study.trace.sample(times).q[:, m.number[m.body[self.subject].coordinates[0].name]]
        if float(np.abs(np.diff(ways)).sum()) > (1.0 + PATH_LENGTH_RTOL) * abs(float(ways[-1])):
            raise UnsolvedError("it turns back on the way")
        return self.place

    def _impulse(self) -> Expression:
        return self._momentum()

    # ---- forces

    def _acceleration(self) -> Expression:
        if self.vertical and not self._rides:
            return self._parts()[1]
        if self._rides:
            return self.carriage_acceleration
        if self.is_single_body:
            return self._force() / self._weighs
        return Root(sum_of_squares(self._parts())) if ZERO not in self._parts() else sum(self._parts(), ZERO)

    def _parts(self) -> tuple[Expression, Expression]:
        """Return the components, along the rail and upward, of the acceleration of the subject on the arm."""
        r, bend = self._radius, sum_of_squares([self.rate])
        turned = self.angular_acceleration * self.cosine + bend * self.signed_sine
        up = bend * self.cosine
        up = (
            up - self.angular_acceleration * self.signed_sine
            if ZERO not in (self.angular_acceleration, self.sine)
            else up
        )
        return self.carriage_acceleration - r * turned, r * up

    def _force(self) -> Expression:
        if self._rides:
            return self._weighs * self.carriage_acceleration
        if not self.is_single_body:
            return self._weighs * self._acceleration()
        weight, rod = self._weighs * self.gravity, self.rod
        if self.sine == ZERO:
            return rod - weight
        return Root(Power(rod, 2) + Power(weight, 2) - TWO * rod * weight * self.cosine)

    def _pull(self) -> Expression:
        """Return the tension in the string of a hanging block; UnsolvedError for a string pulled by a hand."""
        pull = next((pull for pull in self.carriage.riding.pulls if pull.line == self.subject), None)
        if pull is None or not pull.body:
            raise UnsolvedError("a hand says what the tension is")
        a = self.carriage_acceleration
        down = a if self.carriage.towards(pull.line) > 0.0 else -a
        mass = self.carriage.mass(pull.body)
        return mass * (self.gravity - down)

    def _rod(self) -> Expression:
        if self.is_single_body:
            return self.rod
        pulled = self.gravity * self.cosine
        if ZERO not in (self.sine, self.carriage_acceleration):
            pulled = pulled - self.carriage_acceleration * self.signed_sine
        bent = self.moment * sum_of_squares([self.rate])
        return self.mass * pulled + bent

    def _growing(self) -> Expression:
        return self.angular_acceleration

    def _torque(self) -> Expression:
        return self.arm.piece(self.subject).inertia * self.angular_acceleration

    METHOD_BY_QUANTITY: ClassVar[Mapping[str, FormulaMethod]] = {
        "velocity": ("_velocity", "From the horizontal and vertical components relative to the ground,"),
        "momentum": ("_momentum", "The momentum is"),
        "kinetic energy": ("_kinetic", "The kinetic energy is"),
        "translational kinetic energy": ("_moving_energy", "The kinetic energy of the motion of the centre of mass is"),
        "rotational kinetic energy": ("_spinning", "The kinetic energy of the rotation about the centre of mass is"),
        "potential energy": ("_potential", "The change in potential energy is"),
        "angular velocity": ("_turning", ""),
        "angular momentum": ("_angular_momentum", "The angular momentum about the centre of mass is"),
        "displacement": ("_chord", "From the horizontal and vertical components, the displacement is"),
        "height": ("_height", "The height gained is"),
        "deflection": ("_deflection", ""),
        "angle turned": ("_between", "The angle turned through is"),
        "acceleration": ("_acceleration", "Relative to the ground, the acceleration is"),
        "net force": ("_force", "The net force is"),
        "tension": ("_pull", "By Newton's second law for what hangs from the string,"),
        "rod force": ("_rod", "By Newton's second law for what it carries,"),
        "angular acceleration": ("_growing", ""),
        "torque": ("_torque", "The torque about the centre of mass is"),
        "distance travelled": ("_travelled", ""),
        "impulse of the net force": ("_impulse", "Starting from rest, the impulse is equal to the momentum,"),
    }
