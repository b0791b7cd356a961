"""Limiting swing: the threshold at which a body goes right round, or a string goes slack.

By energy: a rigid body is at rest at the top; a string has no tension there, or at the height of the fixed point.
"""

from sim2reason.questions.kinds.threshold import ThresholdQuery
from sim2reason.questions.outcomes.strings import GoesRound, GoesSlack
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.solutions.algebra.expressions import ONE, ZERO, Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import Call, Power, sum_of_squares
from sim2reason.solutions.reverse import Inversion
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.strategies import Strategy, strategy
from sim2reason.solutions.swings.arm import Arm, lone_axle
from sim2reason.solutions.swings.pendulum import geometry, pivot
from sim2reason.solutions.writing.steps import SolutionBuilder
from sim2reason.solutions.writing.unit_latex import JOULES, latex

HALF, TWO, THREE = Number(0.5), Number(2.0), Number(3.0)
STEP = 1e-6  # relative change of a number to find how the result depends on it
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
        swings = pivot(mechanism) is not None or lone_axle(mechanism)
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
    first: Expression = Call("cos", arm.first)
    lift = arm.moment * (ONE + first) if book.value(arm.moment) > 0.0 else -arm.moment * (ONE - first)
    formula = HALF * arm.inertia * Power(arm.launch, 2) - lift * arm.gravity
    said = "By conservation of energy, the kinetic energy at the highest point of the centre of mass is"
    name = book.fresh("K")
    book.add_step("energy", said, name, formula, JOULES)
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
    values = {**book.values, varied: book.values[varied] * (1.0 + STEP)}
    for step in book.steps:
        for held in step.relations:
            if held.role in ("law", "result") and held.left.latex() in step.gives:
                values[held.left.latex()] = float(held.right.value(values).real)
    return values[name.name] > book.values[name.name]


def _of_body(setting: ProblemContext, book: SolutionBuilder) -> Symbol:
    """Write v² of a small body where it would turn or its string go slack, minus the critical value; return it."""
    lexicon, query = setting.lexicon, setting.query
    length, angle, launch = (lexicon.of(lambda m, n=n: geometry(m)[n]).expression() for n in range(3))
    gravity = lexicon.of(lambda m: -m.gravity[2]).expression()
    level = (sum_of_squares([launch])) - TWO * gravity * length * Call("cos", angle)
    assert isinstance(query, ThresholdQuery)
    if isinstance(query.outcome, GoesRound):
        said, formula = (
            "By conservation of energy, the square of the speed at the top is",
            level - TWO * gravity * length,
        )
    else:
        ways = (level, BELOW), (level - THREE * gravity * length, ON_TOP)
        formula, said = min(ways, key=lambda way: abs(book.value(way[0])))
    return book.add_step("energy", said, book.fresh("w"), formula, latex("m^2/s^2"))
