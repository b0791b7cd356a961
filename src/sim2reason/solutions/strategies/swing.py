"""Swing: a small body on a string or a light rod, by energy; thresholds of a full circle and of a slack string.

The thresholds follow from energy: a rigid body is at rest at the top; a string has no tension there, or at the height
of the fixed point.
"""

from collections.abc import Mapping
from typing import ClassVar

from sim2reason.questions.kinds.threshold import ThresholdQuery
from sim2reason.questions.outcomes.strings import GoesRound, GoesSlack
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.solutions.algebra.expressions import (
    ONE,
    ZERO,
    Expression,
    Number,
    Symbol,
    multiply_factors,
    ratio,
    sum_terms,
)
from sim2reason.solutions.algebra.functions import Call, Power, Root, sum_of_squares
from sim2reason.solutions.reverse import Inversion
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.strategies import Strategy, strategy
from sim2reason.solutions.swings.angle import FormulaMethod
from sim2reason.solutions.swings.arm import Arm, single_axle_body
from sim2reason.solutions.swings.asked import COMPONENT_LEADS, Ends, unsupported_reason
from sim2reason.solutions.swings.pendulum import SwingState, geometry, pivot
from sim2reason.solutions.swings.rigid_bodies import total_angle
from sim2reason.solutions.writing.notation import JOULES, latex
from sim2reason.solutions.writing.steps import SolutionBuilder, record_inequality


@strategy
class Swing(Strategy):
    """The strategy for one small body that swings about a fixed point, at a known or computable angle."""

    name = "energy and circular motion"
    cost = 1.0
    kinds = Strategy.kinds | {"extremum", "sum"}

    def why_unsuitable(self, mechanism: Mechanism) -> str:
        """Return the reason, in words, that no small body swings about a fixed point; empty if a body does."""
        return "it is no small body that swings about a fixed point" if pivot(mechanism) is None else ""

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        if unknown := unsupported_reason(setting, _Angular.METHOD_BY_QUANTITY):
            return unknown
        return "it leaves its circle" if setting.earlier_event_kinds & {"slack", "taut"} else ""

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the angle, the speed and the answer, and return the answer's symbol."""
        return _Angular(setting, book).write().name


class _Angular(SwingState):
    """The quantities of a small body that swings."""

    def _velocity(self) -> Expression:
        """Return the velocity along the arc, or its upward component."""
        if not self.vertical:
            return self.speed
        rises = self.moment_angle * self.turning >= 0.0
        return multiply_factors(self.speed if rises else -self.speed, self.sine)

    def _kinetic(self) -> Expression:
        return multiply_factors(Number(0.5), multiply_factors(self.mass, self.squared))

    def _potential(self) -> Expression:
        lower = sum_terms(self.cosine_first, -self.cosine)
        return multiply_factors(multiply_factors(self.mass, multiply_factors(self.gravity, self.length)), lower)

    def _momentum(self) -> Expression:
        return multiply_factors(self.mass, self._velocity())

    def _pull(self) -> Expression:
        """Return the tension T = m g cos φ + m v²/ℓ."""
        if self.line is not None and self.extreme == "fastest" and not self.book.in_symbols:
            self.book.checks.setdefault(self, self._tell_taut)
        weight = multiply_factors(multiply_factors(self.mass, self.gravity), self.cosine)
        bend = multiply_factors(self.mass, ratio(self.squared, self.length))
        return sum_terms(weight, bend)

    def _tell_taut(self) -> None:
        """Write why the string never goes slack: the body stays below the fixed point, or is fast enough at the top."""
        book, step, length = self.book, self.book.begin_step("verify"), multiply_factors(self.gravity, self.length)
        low, high = multiply_factors(Number(2.0), length), multiply_factors(Number(5.0), length)
        if book.value(self.squared) < book.value(low):
            record_inequality(book, step, low, self.squared)
            step.add_text(
                f"As ${self.squared.latex()} < {low.latex()}$, the string never becomes horizontal and stays taut."
            )
        elif book.value(self.squared) > book.value(high):
            record_inequality(book, step, self.squared, high)
            step.add_text(
                f"As ${self.squared.latex()} > {high.latex()}$, the string is taut even at the highest point."
            )
        step.close()

    @property
    def components(self) -> tuple[Expression, Expression]:
        """Return the centripetal acceleration v²/ℓ and the tangential acceleration g sin φ."""
        return ratio(self.squared, self.length), multiply_factors(self.gravity, self.sine)

    @property
    def ends(self) -> Ends:
        """Return g, the initial angle, and v²/2gℓ, which give the accelerations at both ends of a swing."""
        excess = Power(self.launch, 2) / (2.0 * self.gravity * self.length) if self.launch != ZERO else ZERO
        return self.gravity, self.initial_angle, excess

    def _acceleration(self) -> Expression:
        inward, along = self.components
        if self.vertical:
            return sum_terms(multiply_factors(inward, self.cosine), -multiply_factors(along, self.sine))
        if ZERO in (inward, along):
            return sum_terms(inward, along)
        return Root(sum_terms(Power(inward, 2), Power(along, 2)))

    def _force(self) -> Expression:
        return multiply_factors(self.mass, self._acceleration())

    def _spin(self) -> Expression:
        return ratio(self.speed, self.length)

    def _spin_up(self) -> Expression:
        return ratio(multiply_factors(self.gravity, self.sine), self.length)

    def _height(self) -> Expression:
        return multiply_factors(self.length, sum_terms(self.cosine_first, -self.cosine))

    def _chord(self) -> Expression:
        if self.vertical:
            return multiply_factors(self.length, sum_terms(self.cosine_first, -self.cosine))
        half = ratio(self.between, Number(2.0))
        return multiply_factors(multiply_factors(Number(2.0), self.length), Call("sin", half))

    def _swept(self) -> Expression:
        return total_angle(self, self._engine_angles)

    def _travelled(self) -> Expression:
        return multiply_factors(self.length, self._swept())

    def _impulse(self) -> Expression:
        return multiply_factors(self.mass, self.change(self.launch, self.speed))

    METHOD_BY_QUANTITY: ClassVar[Mapping[str, FormulaMethod]] = {
        "velocity": ("_velocity", ""),
        "kinetic energy": ("_kinetic", "Its kinetic energy is"),
        "potential energy": ("_potential", "The change in potential energy is"),
        "momentum": ("_momentum", "Its momentum is"),
        "tension": ("_pull", "By Newton's second law along the string,"),
        "rod force": ("_pull", "By Newton's second law along the rod,"),
        "acceleration": ("_acceleration", COMPONENT_LEADS["acceleration"]),
        "net force": ("_force", COMPONENT_LEADS["net force"]),
        "angular velocity": ("_spin", "The angular velocity is the speed over the radius,"),
        "angular acceleration": (
            "_spin_up",
            "The angular acceleration is the tangential acceleration over the radius,",
        ),
        "deflection": ("_deflection", ""),
        "angle turned": ("_between", "The angle turned through is"),
        "total angle": ("_swept", "In all, it turns through"),
        "impulse of the net force": ("_impulse", "The impulse is the change in momentum, of magnitude"),
        "distance travelled": ("_travelled", "The distance is the radius times the total angle:"),
        "height": ("_height", "The height gained is"),
        "displacement": ("_chord", "The displacement is the chord"),
    }


HALF, TWO, THREE = Number(0.5), Number(2.0), Number(3.0)
RELATIVE_STEP = 1e-6  # relative change of a number to find how the result depends on it
TAUT = "The string stays taut if the body turns back below the fixed point."
BELOW = f"{TAUT} By conservation of energy, the square of the speed at that height is"
TENSE = "At the top the string stays taut if the centripetal force required is greater than the weight."
ON_TOP = f"{TENSE} By conservation of energy, the squared speed exceeds $g$ times the length of the string by"


@strategy
class LimitingSwing(Strategy):
    """The strategy for the threshold at which a swing goes right round, or its string goes slack."""

    name = "limiting swing"
    cost = 1.0
    kinds = frozenset({"threshold"})

    def why_unsuitable(self, mechanism: Mechanism) -> str:
        """Return the reason, in words, that no body swings alone about a fixed point or axle; empty if a body does."""
        swings = pivot(mechanism) is not None or single_axle_body(mechanism)
        return "" if swings else "nothing swings about a fixed point by itself"

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        query = setting.query
        if not isinstance(query, ThresholdQuery) or not isinstance(query.outcome, GoesRound | GoesSlack):
            return "it is not about going round or slack"
        return "" if setting.sought is not None else "there is no such value"

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the energy left at the critical point, zero at the threshold, and return the threshold's symbol."""
        left = _of_body(setting, book) if pivot(setting.mechanism) is not None else _of_axle(setting, book)
        step = book.begin_step("limit")
        step.add_text(f"In the limiting case, {step.law(left, ZERO)}.")
        step.close()
        return Inversion(book, left.name, 0.0, book.sought).write()


def _of_axle(setting: ProblemContext, book: SolutionBuilder) -> Symbol:
    """Write the kinetic energy of a rigid body at the top, J, and return its symbol."""
    arm = Arm(setting, book)
    first: Expression = Call("cos", arm.initial_angle)
    lift = arm.moment * (ONE + first) if book.value(arm.moment) > 0.0 else -arm.moment * (ONE - first)
    formula = HALF * arm.inertia * Power(arm.launch, 2) - lift * arm.gravity
    text = "By conservation of energy, the kinetic energy at the highest point of the centre of mass is"
    name = book.fresh("K")
    book.add_step("energy", text, name, formula, JOULES)
    step = book.begin_step("extreme")
    varied = _varied(setting, book)
    changes = "increases" if _grows(book, name, varied) else "decreases"
    step.add_text(f"{arm.noun()} goes right round if ${name.name}$ is positive.")
    step.add_text(f"Near the limiting case ${name.name}$ {changes} when ${varied}$ increases.")
    step.close()
    return name


def _varied(setting: ProblemContext, book: SolutionBuilder) -> str:
    """Return the symbol of the parameter whose threshold the question is about, whether it is given or asked for."""
    assert isinstance(setting.query, ThresholdQuery)
    given = setting.given(setting.query.parameter)
    return given.symbol if given is not None else book.sought


def _grows(book: SolutionBuilder, name: Symbol, varied: str) -> bool:
    """Return whether the last result increases with a parameter."""
    values = {**book.values, varied: book.values[varied] * (1.0 + RELATIVE_STEP)}
    for step in book.steps:
        for relation in step.relations:
            if relation.role in ("law", "result") and relation.left.latex() in step.gives:
                values[relation.left.latex()] = float(relation.right.value(values).real)
    return values[name.name] > book.values[name.name]


def _of_body(setting: ProblemContext, book: SolutionBuilder) -> Symbol:
    """Write v² of a small body where it would turn or its string go slack, minus the critical value; return it."""
    lexicon, query = setting.lexicon, setting.query
    length, angle, launch = (lexicon.formula_for(lambda m, n=n: geometry(m)[n]).expression() for n in range(3))
    gravity = lexicon.formula_for(lambda m: -m.gravity[2]).expression()
    level = (sum_of_squares([launch])) - TWO * gravity * length * Call("cos", angle)
    assert isinstance(query, ThresholdQuery)
    if isinstance(query.outcome, GoesRound):
        text, formula = (
            "By conservation of energy, the square of the speed at the top is",
            level - TWO * gravity * length,
        )
    else:
        ways = (level, BELOW), (level - THREE * gravity * length, ON_TOP)
        formula, text = min(ways, key=lambda condition: abs(book.value(condition[0])))
    return book.add_step("energy", text, book.fresh("w"), formula, latex("m^2/s^2"))
