"""Statics: balance of all forces on bodies at rest, including those of springs and friction.

See any textbook, such as Kleppner and Kolenkow, An Introduction to Mechanics, chapter 2.
"""

from collections.abc import Mapping

from sim2reason.base.records import cached_property
from sim2reason.questions.moments.times import AtStart
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.algebra.fractions import cramer, determinant
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial, total
from sim2reason.solutions.goals import GOALS
from sim2reason.solutions.oscillations.linear_motion import nonlinear_reason
from sim2reason.solutions.oscillations.linear_way import LinearMotionModel
from sim2reason.solutions.setting import ProblemContext, join_words
from sim2reason.solutions.strategies import Strategy, strategy
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError
from sim2reason.solutions.writing.unit_latex import METRES


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
        way = _AtRest(setting, book)
        way.balance()
        assert way.target is not None
        return GOALS[way.target.quantity].write(way.target, way).name


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
        said: list[str] = []
        if not determinant(rows):
            raise UnsolvedError("it has no place of its own to rest")
        step = self.book.begin_step("balance")
        for row, load in zip(rows, loads, strict=True):
            left = total(part * Polynomial.of(names[j]) for part, j in zip(row, free, strict=True))
            said.append(step.law(left.collected([names[j].name for j in free]), load.expression()))
        step.add_text(f"In equilibrium the net force {self._where} is zero: {join_words(said)}.")
        step.label("balance")
        step.close()
        for i, formula in zip(free, cramer(rows, loads), strict=True):
            step = self.book.begin_step("solve")
            step.rest_on("balance")
            held = formula if len(free) == 1 else self.book.worked(formula)
            step.add_text(f"So {step.result(names[i], held, METRES)}.")
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
        return Polynomial.of(self._places[i])

    def speed(self, i: int) -> Polynomial:
        """Return zero, since nothing moves."""
        del i
        return NIL

    def acceleration(self, i: int) -> Polynomial:
        """Return zero, since nothing moves."""
        del i
        return NIL
