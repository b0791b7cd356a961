"""Equations of motion: equilibrium, Lagrange's equations, and integration phase by phase or numerically.

On equilibrium see any textbook, such as Kleppner and Kolenkow, An Introduction to Mechanics, chapter 2; on Lagrange's
equations see Goldstein, Poole and Safko, Classical Mechanics, chapter 1.
"""

from collections.abc import Mapping

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.questions.moments.distances import Moved
from sim2reason.questions.moments.times import AtStart, AtTime
from sim2reason.scenes.dsl.mechanism import Elastic, Mechanism
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number, Symbol
from sim2reason.solutions.algebra.fractions import cramer, determinant
from sim2reason.solutions.algebra.functions import Power, Root
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial, total
from sim2reason.solutions.goals import GOALS
from sim2reason.solutions.oscillations.linear_motion import nonlinear_reason
from sim2reason.solutions.oscillations.linear_way import LinearMotionModel
from sim2reason.solutions.phases import IntegratedPhases
from sim2reason.solutions.setting import ProblemContext, join_words
from sim2reason.solutions.strategies import Strategy, missing_goal, strategy, varying_acceleration
from sim2reason.solutions.writing.notation import ACCELERATION, METRES, SECONDS, SPEED
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError


@strategy
class Statics(Strategy):
    """The strategy for an equilibrium on springs along lines, or for a start at which nothing moves."""

    name = "statics"
    cost = 0.9
    kinds = frozenset({"equilibrium", "start"})

    def why_unsuitable(self, mechanism: Mechanism) -> str:
        """Return the reason, in words, that the strategy cannot apply to a mechanism; empty if it may apply."""
        return nonlinear_reason(mechanism)

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        target = setting.target
        if target is None or target.quantity not in GOALS:
            return f"no way to the quantity {target.quantity if target is not None else ''}"
        return ""

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the balance of forces and the answer, and return the answer's symbol."""
        model = _AtRest(setting, book)
        model.balance()
        assert model.target is not None
        return GOALS[model.target.quantity].write(model.target, model).name


class _AtRest(LinearMotionModel):
    """A motion model in which nothing is accelerated."""

    def balance(self) -> None:
        """Write that nothing moves at the start; UnsolvedError if a body moves, or an equilibrium has no spring."""
        free = self.motion.free
        if isinstance(self.query.moment, AtStart):
            if free or any(c.speed for c in self.mechanism.coordinates):
                raise UnsolvedError("something moves")
            step = self.book.begin_step("rest")
            step.add_text("Nothing moves, so the net force on each body is zero.")
            step.close()
        elif not free or not self.motion.springs:
            raise UnsolvedError("there is no restoring force")

    @cached_property
    def _places(self) -> Mapping[int, Symbol]:
        """Write the equilibrium values of the free coordinates and return their symbols."""
        free, motion = self.motion.free, self.motion
        names = {i: self.book.fresh("x", self._mark(i)) for i in free}
        self.introduce(names)
        rows = [[motion.stiffness(i, j) for j in free] for i in free]
        loads = [motion.load(i) for i in free]
        equations: list[str] = []
        if not determinant(rows):
            raise UnsolvedError("it has no place of its own to rest")
        step = self.book.begin_step("balance")
        for row, load in zip(rows, loads, strict=True):
            left = total(part * Polynomial.from_expression(names[j]) for part, j in zip(row, free, strict=True))
            equations.append(step.law(left.collected([names[j].name for j in free]), load.expression()))
        step.add_text(f"In equilibrium the net force {self._where} is zero: {join_words(equations)}.")
        step.label("balance")
        step.close()
        for i, formula in zip(free, cramer(rows, loads), strict=True):
            step = self.book.begin_step("solve")
            step.rest_on("balance")
            value = formula if len(free) == 1 else self.book.defer_to_number(formula)
            step.add_text(f"So {step.result(names[i], value, METRES)}.")
            step.close()
        return names

    @property
    def _where(self) -> str:
        """Return the words that follow *the net force*: *on each body*, or *along the motion* if tensions cancel."""
        moving = [body for body in self.mechanism.bodies if body.coordinates]
        slides = all(len(b.coordinates) == 1 and b.coordinates[0].kind == "slide" and b.parent is None for b in moving)
        if not slides or len(moving) != len(self.motion.free):
            return "along the motion"
        return "on each body" if len(moving) > 1 else f"on {self.setting.display_name(moving[0].name)}"

    def _mark(self, i: int) -> str:
        return self.setting.subscript_of(self.mechanism.coordinates[i].body) if len(self.motion.free) > 1 else ""

    def place(self, i: int) -> Polynomial:
        """Return the equilibrium value of a free coordinate."""
        return Polynomial.from_expression(self._places[i])

    def speed(self, i: int) -> Polynomial:
        """Return zero, since nothing moves."""
        del i
        return NIL

    def acceleration(self, i: int) -> Polynomial:
        """Return zero, since nothing moves."""
        del i
        return NIL


MOMENTS = (AtStart, AtTime, Moved)
HALF = Number(0.5)


@strategy
class Lagrange(Strategy):
    """The strategy for several free coordinates, with constant forces; with springs only at the start."""

    name = "Lagrange's equations"
    cost = 3.0
    kinds = frozenset({"start", "state", "event", "time_to_event"})

    def why_unsuitable(self, mechanism: Mechanism) -> str:
        """Return the reason that a mechanism is unsuitable: collisions or nonlinear equations; else empty."""
        return "something may collide" if mechanism.meetings else nonlinear_reason(mechanism)

    def formulas(self, mechanism: Mechanism) -> frozenset[str]:
        """Return the question kinds that have a compact formula: all, or with springs only ``start``."""
        return frozenset({"start"}) if _springy(mechanism) else self.kinds

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        if _springy(setting.mechanism) and not isinstance(setting.query.moment, AtStart):
            return "accelerations change as it moves"
        return missing_goal(setting, MOMENTS)

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the equations, the accelerations and the answer, and return the answer's symbol."""
        model = _Together(setting, book)
        if model.target is None or model.goal is None:
            return model.time.name
        return model.goal.write(model.target, model).name


def _springy(mechanism: Mechanism) -> bool:
    return any(isinstance(line.law, Elastic) for line in mechanism.lines)


class _Together(LinearMotionModel):
    """A motion model with all accelerations from one system of equations."""

    @cached_property
    def _free(self) -> list[int]:
        free, motion = self.linear.free, self.linear
        if len(free) < 2:
            raise UnsolvedError("only one thing moves by itself")
        if motion.damped and any(self.initial_rate(i) for i in free):
            raise UnsolvedError("it is damped")
        if motion.springs and not isinstance(self.query.moment, AtStart):
            raise UnsolvedError("accelerations change as it moves")
        return free

    @cached_property
    def _accelerations(self) -> Mapping[int, Symbol]:
        """Write Lagrange's equations and their solution by Cramer's rule; return the symbols."""
        free = self._free
        marks = {i: self.setting.subscript_of(self.mechanism.coordinates[i].body) for i in free}
        places = {i: self.book.fresh("x", mark) for i, mark in marks.items()}
        names = {i: self.book.fresh("a", mark) for i, mark in marks.items()}
        self.introduce(places)
        rows = [[self.linear.mass(i, j) for j in free] for i in free]
        loads = [self.linear.load(i) for i in free]
        laws: list[str] = []
        step = self.book.begin_step("newton")
        for row, load in zip(rows, loads, strict=True):
            left = total(part * Polynomial.from_expression(names[j]) for part, j in zip(row, free, strict=True))
            laws.append(step.law(left.collected([names[j].name for j in free]), load.factored()))
        step.add_text(
            f"With the accelerations {join_words([f'${name.name}$' for name in names.values()])}, Lagrange's equations"
        )
        step.add_text(f"are {join_words(laws)}.")
        step.label("equations")
        step.close()
        for i, formula in zip(free, cramer(rows, loads), strict=True):
            step = self.book.begin_step("solve")
            step.rest_on("equations")
            step.add_text(
                f"By Cramer's rule {step.result(names[i], self.book.defer_to_number(formula), ACCELERATION)}."
            )
            step.close()
        return names

    # ---- the moment

    @cached_property
    def time(self) -> Symbol:
        """Write the time of the moment, s, and return its symbol; UnsolvedError for the start."""
        moment, name = self.query.moment, self.book.fresh("t")
        if isinstance(moment, AtTime):
            self.book.state_given(name.name, moment.after, SECONDS)
            return name
        if not isinstance(moment, Moved):
            raise UnsolvedError("it is the start")
        k, *_ = self.moving([moment.name])
        if any(self.initial_rate(i) for i in self.linear.ratios[k]):
            raise UnsolvedError("it does not begin at rest")
        far = self.book.fresh("d")
        self.book.state_given(far.name, moment.value, METRES)
        rise = self.rate("a", k)
        there = self.setting.motion.state(np.array([self.setting.time])).q[0, k]
        rise = rise if there > 0.0 else rise.scale(-1.0)
        step = self.book.begin_step("time")
        law = step.law(far, HALF * rise.expression() * Power(name, 2))
        who = self.setting.display_name(moment.name)
        step.add_text(f"Starting from rest, {who} has covered this distance when {law},")
        step.add_text(f"so {step.result(name, Root(2.0 * far / rise.expression()), SECONDS)}.")
        step.close()
        return name

    @cached_property
    def _known(self) -> dict[tuple[str, int], Polynomial]:
        return {}

    def _write_coordinate(self, base: str, i: int, formula: Expression, unit: str, said: str) -> Polynomial:
        if formula == ZERO:
            return NIL
        if (base, i) not in self._known:
            mark = self.setting.subscript_of(self.mechanism.coordinates[i].body)
            name = self.book.fresh(base, mark)
            self._known[base, i] = Polynomial.from_expression(self.book.add_step(base, said, name, formula, unit))
        return self._known[base, i]

    def place(self, i: int) -> Polynomial:
        """Return the displacement v₀ t + ½ a t²."""
        if isinstance(self.query.moment, AtStart):
            return NIL
        rise, first = self._accelerations[i], self.initial_rate(i)
        formula = HALF * rise * Power(self.time, 2)
        formula = first.expression() * self.time + formula if first else formula
        return self._write_coordinate("s", i, formula, METRES, "The displacement is then")

    def speed(self, i: int) -> Polynomial:
        """Return the velocity v₀ + a t."""
        first = self.initial_rate(i)
        if isinstance(self.query.moment, AtStart):
            return first
        formula = self._accelerations[i] * self.time
        formula = first.expression() + formula if first else formula
        return self._write_coordinate("v", i, formula, SPEED, "The velocity is then")

    def acceleration(self, i: int) -> Polynomial:
        """Return the constant acceleration."""
        return Polynomial.from_expression(self._accelerations[i])


@strategy
class PhaseByPhase(Strategy):
    """The strategy for motions that stick, slip or collide in any order, at constant accelerations."""

    name = "phase by phase"
    cost = 50.0
    kinds = frozenset({"state", "event", "time_to_event", "extremum"})

    def why_unsuitable(self, mechanism: Mechanism) -> str:
        """Return the reason, in words, that accelerations vary between events; empty if the strategy may apply."""
        return varying_acceleration(mechanism)

    def formulas(self, mechanism: Mechanism) -> frozenset[str]:
        """Return the question kinds that have a compact formula: none, since several phases give no single formula."""
        del mechanism
        return frozenset()

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        if setting.formula is not None or setting.unknown:
            return "equations of phases lead to numbers, and to no unknown"
        return "" if setting.answer is not None else "there is no answer"

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the phases in order and the answer, and return its symbol; UnsolvedError if `book` is not empty."""
        if book.steps:
            raise UnsolvedError("phases begin a solution")
        return IntegratedPhases(setting, book, integrates=False).write()


@strategy
class NumericalIntegration(Strategy):
    """The strategy for any motion with equations in the numbers of the text, integrated phase by phase."""

    name = "integration"
    cost = 100.0
    kinds = frozenset({"state", "event", "time_to_event", "sum", "extremum"})
    integrates = True

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        if setting.formula is not None:
            return "integration gives no formula"
        return "" if setting.answer is not None else "there is no answer"

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the phases in order and the answer, and return the answer's symbol."""
        return IntegratedPhases(setting, book).write()
