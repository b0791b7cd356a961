"""Axle: a rigid body that swings about a fixed horizontal axle, by torque, moment of inertia and energy."""

from collections.abc import Mapping
from math import cos
from typing import ClassVar

from sim2reason.base.records import cached_property
from sim2reason.questions.moments.times import AtStart
from sim2reason.questions.phrasing import PeriodQuery
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.state import Array
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import PI, Call, Power, Root, sum_of_squares
from sim2reason.solutions.oscillations.harmonic import measured_period
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.strategies import Strategy, strategy
from sim2reason.solutions.swings.angle import SMALL_OSCILLATIONS_LEAD, FormulaMethod
from sim2reason.solutions.swings.arm import Arm, Piece, single_axle_body
from sim2reason.solutions.swings.asked import (
    COMPONENT_LEADS,
    Ends,
    by_energy,
    straight_clause,
    turns_back,
    unsupported_reason,
)
from sim2reason.solutions.swings.rigid_bodies import AxleForces, small_oscillations, total_angle
from sim2reason.solutions.writing.notation import (
    ANGULAR_SPEED,
    DEGREES,
)
from sim2reason.solutions.writing.steps import SolutionBuilder

HALF, TWO = Number(0.5), Number(2.0)


@strategy
class Axle(Strategy):
    """The strategy for bodies fixed together on one axle, at the start or at a known or computable angle."""

    name = "energy and torque about an axle"
    cost = 1.1
    kinds = Strategy.kinds | {"extremum", "period", "sum"}

    def why_unsuitable(self, mechanism: Mechanism) -> str:
        """Return the reason, in words, that the strategy cannot apply to a mechanism; empty if it may apply."""
        return "" if single_axle_body(mechanism) else "nothing turns about a fixed axle by itself"

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        if isinstance(setting.query, PeriodQuery):
            return ""
        return unsupported_reason(setting, _Turning.METHOD_BY_QUANTITY)

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the moment of inertia, the angle, the angular speed and the answer, and return the answer's symbol."""
        query = setting.query
        if isinstance(query, PeriodQuery) and query.small:
            return small_oscillations(Arm(setting, book), book, query).name
        return _Turning(setting, book).write().name


class _Turning(AxleForces):
    """The quantities of a rigid body on an axle."""

    one_point = False

    def __init__(self, setting: ProblemContext, book: SolutionBuilder) -> None:
        """Read the parameters; raise UnreadError if one is not a simple function of the numbers in the text."""
        super().__init__(setting, book)
        self.arm = Arm(setting, book)
        self.initial_angle, self.launch, self.gravity = self.arm.initial_angle, self.arm.launch, self.arm.gravity
        self.initial_angle_value = book.value(self.initial_angle)
        moment = setting.query.moment
        self.moment_angle, self.turned, self.turning = self.arm.at(
            moment.evaluation_time(setting.time) if moment is not None else 0.0
        )
        self.initial_rate_sign = 1.0 if self.arm.at(0.0)[2] >= 0.0 else -1.0

    # ---- what is asked

    def write(self) -> Symbol:
        """Write the answer to the query and return the answer's symbol."""
        query = self.setting.query
        if isinstance(query, PeriodQuery):
            return measured_period(self.book, query, self.times.frequency)
        return super().write()

    @cached_property
    def piece(self) -> Piece:
        """Return the body on the axle that is the subject of the question, with its mass and position."""
        return self.arm.piece(self.setting.query.subject)

    @property
    def size(self) -> Expression:
        """Return the distance from the axle to the centre of mass of the piece, in m."""
        position = self.piece.place
        return self.book.magnitude(position)

    # ---- the laws

    @cached_property
    def small_oscillation_frequency(self) -> Symbol:
        """Write the angular frequency of small oscillations, √(S g/I) with S = Σ m r, and return its symbol."""
        moment = self.arm.moment
        size = moment if self.is_falling else -moment
        formula = Root(size * self.gravity / self.arm.inertia)
        return self.book.add_step(
            "natural", SMALL_OSCILLATIONS_LEAD, self.book.fresh(r"\omega", "0"), formula, ANGULAR_SPEED
        )

    @cached_property
    def initial_angular_speed(self) -> Expression:
        """Return the angular speed at the start, rad/s."""
        return self.launch

    @property
    def is_falling(self) -> bool:  # type: ignore[override]
        """Return whether the common centre of mass is on the same side of the axle as the first body."""
        return self.book.value(self.arm.moment) > 0.0

    @property
    def goes_round(self) -> bool:
        """Return whether the energy ½ I ω₀² suffices to pass the highest point."""
        inertia, moment, g, rate = (
            self.book.value(part) for part in (self.arm.inertia, self.arm.moment, self.gravity, self.launch)
        )
        lift = abs(moment) + moment * cos(self.initial_angle_value)
        return 0.5 * inertia * rate**2 > g * lift

    def _write_turning_angle(self) -> Expression:
        """Write the angle of the turning point, and return it with its sign."""
        arm, g, rate = self.arm, self.gravity, self.launch
        if rate == ZERO:
            return -self.initial_angle  # as far on the other side
        name, step = self.book.fresh(r"\phi", r"\text{max}"), self.book.begin_step("energy")
        inertia, moment = arm.inertia, arm.moment
        law = step.law(HALF * inertia * Power(rate, 2), moment * g * (self.cosine_first - Call("cos", name)))
        formula = Call("arccos", self.cosine_first - inertia * Power(rate, 2) / (2.0 * moment * g))
        step.add_text(f"{turns_back(self.setting, arm.noun())} {law}, so {step.result(name, formula, DEGREES)}.")
        step.close()
        return -name if self.extreme or self.moment_angle < 0.0 else name

    @cached_property
    def rate(self) -> Expression:
        """Write the angular speed at the moment, rad/s, and return it."""
        if isinstance(self.setting.query.moment, AtStart) and not self.extreme:
            return self.launch
        if self.is_at_rest:
            return ZERO
        arm, there = self.arm, self.cosine
        inertia, moment = arm.inertia, arm.moment
        step, name = self.book.begin_step("energy"), self.book.fresh(r"\omega")
        law = step.law(HALF * inertia * Power(name, 2), self._energy(there))
        square = 2.0 * moment * self.gravity * (there - self.cosine_first) / inertia
        square = sum_of_squares([self.launch]) + square
        where = straight_clause(self.setting, below=self.book.value(moment * there) > 0.0)
        text = by_energy(self.setting, "angular velocity", name, extreme=bool(self.extreme), where=where)
        step.add_text(f"{text} {law}, so {step.result(name, Root(square), ANGULAR_SPEED)}.")
        step.close()
        return name

    @property
    def _swinging(self) -> bool:
        """Return whether the angular speed follows from conservation of energy: neither zero nor that at the start."""
        return not self.is_at_rest and not isinstance(self.setting.query.moment, AtStart)

    def _energy(self, there: Expression) -> Expression:
        """Return the kinetic energy, in J, at an angle with the given cosine."""
        gained = self.arm.moment * self.gravity * (there - self.cosine_first)
        return HALF * self.arm.inertia * sum_of_squares([self.launch]) + gained

    # ---- quantities

    def _velocity(self) -> Expression:
        speed = self.size * self.rate
        if not self.vertical:
            return speed
        rises = self.moment_angle * self.turning * self.book.value(self.piece.place) >= 0.0
        return (speed if rises else -speed) * self.sine

    @property
    def components(self) -> tuple[Expression, Expression]:
        """Return the centripetal and tangential acceleration of the centre of mass, d ω² and d α."""
        return self.size * sum_of_squares([self.rate]), self.size * self.angular_acceleration

    @property
    def ends(self) -> Ends:
        """Return d·Sg/I, the initial angle and Iω₀²/2Sg (S = Σ m r), for the accelerations at both ends of a swing."""
        moment, inertia, rate = self.arm.moment, self.arm.inertia, self.launch
        torque = (moment if self.is_falling else -moment) * self.gravity
        excess = inertia * Power(rate, 2) / (2.0 * torque) if rate != ZERO else ZERO
        return self.size * torque / inertia, self.initial_angle if self.is_falling else PI - self.initial_angle, excess

    def _acceleration(self) -> Expression:
        inward, along = self.components
        if self.vertical:
            sign = 1.0 if self.book.value(self.piece.place) > 0.0 else -1.0
            falls = sign * (1.0 if self.is_falling else -1.0)
            return sign * inward * self.cosine - falls * along * self.sine
        if ZERO in (inward, along):
            return inward + along
        return Root(Power(inward, 2) + Power(along, 2))

    def _force(self) -> Expression:
        return self.piece.mass * self._acceleration()

    def _momentum(self) -> Expression:
        return self.piece.mass * self._velocity()

    def _moving(self) -> Expression:
        return HALF * self.piece.mass * Power(self.size * self.rate, 2)

    def _spinning(self) -> Expression:
        return HALF * self.piece.inertia * Power(self.rate, 2)

    def lead_text(self, quantity: str) -> str:
        """Return the words before the formula of a quantity, with the name of the body if there are several."""
        if quantity == "kinetic energy":
            return f"The kinetic energy of {self.setting.display_name(self.piece.body)}, which turns about the axle, is"
        return self.axle_force_lead() if quantity == "axle force" else super().lead_text(quantity)

    def _kinetic(self) -> Expression:
        if len(self.arm.bodies) == 1 and self._swinging:
            return self._energy(self.cosine)  # that of all is its own
        piece = self.piece
        about = piece.mass * Power(self.size, 2) + piece.inertia
        return HALF * about * Power(self.rate, 2)

    def _potential(self) -> Expression:
        return self.piece.mass * self.gravity * self._rise()

    def _rise(self) -> Expression:
        return self.piece.place * (self.cosine_first - self.cosine)

    def _chord(self) -> Expression:
        if self.vertical:
            return self._rise()
        return 2.0 * self.size * Call("sin", self.between / TWO)

    def _own(self) -> Expression:
        return self.piece.inertia

    def _angular_momentum(self) -> Expression:
        return self.piece.inertia * self.rate

    def _torque(self) -> Expression:
        return self.piece.inertia * self.angular_acceleration

    def _rate(self) -> Expression:
        return self.rate

    def _growth(self) -> Expression:
        return self.angular_acceleration

    def _swept(self) -> Expression:
        def seen(times: Array) -> tuple[Array, Array]:
            angles, _, rates = self.arm.seen(times)
            return angles, rates

        return total_angle(self, seen)

    def _travelled(self) -> Expression:
        return self.size * self._swept()

    def _impulse(self) -> Expression:
        begun = self.size * self.launch
        speed = self.size * self.rate
        return self.piece.mass * self.change(begun, speed)

    METHOD_BY_QUANTITY: ClassVar[Mapping[str, FormulaMethod]] = {
        "velocity": ("_velocity", "The speed is the angular speed times the distance from the axle:"),
        "acceleration": ("_acceleration", COMPONENT_LEADS["acceleration"]),
        "net force": ("_force", COMPONENT_LEADS["net force"]),
        "momentum": ("_momentum", "The momentum is"),
        "kinetic energy": ("_kinetic", ""),
        "translational kinetic energy": ("_moving", "The kinetic energy of the motion of the centre of mass is"),
        "rotational kinetic energy": ("_spinning", "The kinetic energy of the rotation about the centre of mass is"),
        "potential energy": ("_potential", "The change in potential energy is"),
        "angular momentum": ("_angular_momentum", "The angular momentum about the centre of mass is"),
        "moment of inertia": ("_own", ""),
        "torque": ("_torque", "The torque about the centre of mass is"),
        "angular velocity": ("_rate", ""),
        "angular acceleration": ("_growth", ""),
        "axle force": ("axle_force", ""),
        "deflection": ("_deflection", ""),
        "angle turned": ("_between", "The angle turned through is"),
        "total angle": ("_swept", "In all, it turns through"),
        "impulse of the net force": ("_impulse", "The impulse is the change in momentum, of magnitude"),
        "distance travelled": (
            "_travelled",
            "The path is as long as the distance from the axle times the total angle:",
        ),
        "displacement": ("_chord", "The displacement is the chord"),
        "height": ("_rise", "The height gained is"),
    }
