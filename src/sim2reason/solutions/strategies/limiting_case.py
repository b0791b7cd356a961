"""Limiting case: balance of forces at the onset of slipping or rising, with friction at its greatest."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.questions.kinds.threshold import ThresholdQuery
from sim2reason.questions.outcomes.sliding import Slides
from sim2reason.questions.outcomes.strings import Rises
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.simulation.engines.exact.engine import motion
from sim2reason.simulation.engines.exact.motion import Segment
from sim2reason.solutions.algebra.evaluated import NumericRoot
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial, total
from sim2reason.solutions.algebra.root_finding import evaluate_known_parts, other_solutions, solved_for, substitute
from sim2reason.solutions.algebra.standard_equations import stated_equation
from sim2reason.solutions.closed_forms.symbolic_answers import BAR
from sim2reason.solutions.laws.directions import slip_direction_text
from sim2reason.solutions.laws.newton import Newton, Row
from sim2reason.solutions.laws.written_dynamics import WrittenDynamics
from sim2reason.solutions.reverse import Inversion
from sim2reason.solutions.setting import ProblemContext, capitalized
from sim2reason.solutions.solution import with_unit
from sim2reason.solutions.strategies import Strategy, strategy, varying_acceleration
from sim2reason.solutions.writing.notation import ACCELERATION
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError

MAX_FORMULA_LENGTH = 200  # characters of a formula for the unknown; longer ones are written with numbers
ACCELERATION_ATOL = 1e-6  # m/s²: smaller accelerations count as zero


class _AtLimit(Newton):
    """Newton's laws with the greatest static friction on a body that is about to slip."""

    def coefficient(self, face: int) -> Polynomial:
        """Return µ_s, the coefficient of static friction of a face."""
        return self.static_coefficient(face)


class LimitingDynamics(WrittenDynamics):
    """Newton's laws and their unknowns at the instant at which a body is about to move."""

    def __init__(self, setting: ProblemContext, book: SolutionBuilder, segment: Segment) -> None:
        """Prepare the laws of a segment at the limit; UnreadError for other kinds of mechanisms."""
        super().__init__(setting, book, segment)
        self.newton = _AtLimit(setting.lexicon, segment)

    @cached_property
    def values(self) -> dict[str, float]:
        """Return the values of all unknowns by the laws; the engine has none before the motion begins."""
        rows, unknowns = self.laws(["q0"])
        givens = {g.symbol: g.value for g in self.setting.lexicon.givens.values()}
        matrix = np.array([[row.zero.coefficient(name).value(givens) for name in unknowns] for row in rows])
        right = np.array([-row.zero.terms_without(unknowns).value(givens) for row in rows])
        solution = np.asarray(np.linalg.lstsq(matrix, right, rcond=1e-12)[0], dtype=np.float64)
        return {**self.newton.values, **dict(zip(unknowns, solution.tolist(), strict=True))}


class LimitingBalance(LimitingDynamics):
    """Newton's laws in a limiting case, with one vanishing acceleration as a condition on the unknown.

    The condition is the law of the body that is about to move; the others determine the forces in it.
    """

    def __init__(self, setting: ProblemContext, book: SolutionBuilder, segment: Segment, body: str) -> None:
        """Take the segment of the motion just beyond the limit, in which the `body` moves.

        Raises:
            UnreadError: forces other than weight, strings, contacts and constant forces act.
        """
        super().__init__(setting, book, segment)
        self._who = body
        self._beside = LimitingDynamics(setting, book, segment)

    @cached_property
    def frozen(self) -> set[int]:
        """Return the indices of coordinates with zero acceleration, or zero relative acceleration, at the limit."""
        beside = self._beside
        rates = {k: beside.values[f"q{k}"] for k in range(len(self.mechanism.coordinates)) if k not in beside.frozen}
        for k, (j, sign) in beside.carrier_coordinates.items():
            rates[k] -= sign * beside.values[f"q{j}"]
        return beside.frozen | {k for k, rate in rates.items() if abs(rate) < ACCELERATION_ATOL}

    @cached_property
    def _condition(self) -> Row:
        """Return Newton's law for the body along the line on which it may move."""
        own = [k for k in self.newton.moving_coordinates(self._who) if self.mechanism.coordinates[k].body == self._who]
        rows = [row for row in super().laws(())[0] if row.kind == "newton" and row.number in own]
        if len(rows) != 1 or not rows[0].forces or rows[0].number not in self.frozen:
            raise UnsolvedError("it moves along no line of its own")
        (row,) = rows
        normals = {name: self._pressing(int(name[1:])) for name in row.zero.names() if name[0] == "N"}
        return Row(row.kind, row.number, row.forces.substitute(normals), row.inertia)

    def _pressing(self, face: int) -> Polynomial:
        """Return the normal force at a contact as a formula of the other forces and the accelerations."""
        still = {f"q{k}": NIL for k in self.frozen}
        row = self.newton.normal(face)
        return (row.inertia - row.forces.terms_without((f"N{face}",))).substitute(still)

    def laws(self, goals: Sequence[str]) -> tuple[list[Row], list[str]]:
        """Return all laws except the condition on the body about to move, and the unknowns of these laws."""
        rows, unknowns = super().laws(goals)
        condition = self._condition
        return [row for row in rows if (row.kind, row.number) != (condition.kind, condition.number)], unknowns

    def write(self, *, slides: bool) -> str:
        """Write the laws and the condition of zero acceleration; return the symbol of the question's unknown.

        Raises:
            UnsolvedError: the forces are not determined, or the unknown has no closed form.
        """
        book, row, hidden = self.book, self._condition, Symbol(self.book.sought)
        self._introduce(slides=slides)
        self.reach(sorted(n for n in row.zero.names() if n[0] in "Tfq" and n[1:].isdigit()))
        step = book.begin_step("solve for the unknown")
        step.rest_on("limit")
        forces, inertia = row.forces.substitute(self.names), row.inertia.substitute(self.names)
        law, formula = step.law(forces.expression(), inertia.expression()), (forces - inertia).expression()
        plain = formula
        for name in reversed(book.formulas):
            if name != hidden.name and name in formula.symbols():
                formula = substitute(formula, name, book.formulas[name])
        root, solved = self._solved(hidden.name, formula)
        book.values[hidden.name] = book.value(root)
        book.refresh(hidden.name, book.values[hidden.name])
        who = capitalized(self.setting.display_name(self._who))
        in_numbers = solved != formula
        sides = stated_equation(hidden.name, solved, ZERO, self._worked if in_numbers else Polynomial.factored)
        others = () if book.in_symbols else other_solutions(hidden.name, solved, ZERO, book.values)
        so = ", so" if formula == plain else ". Together with the equations above, this gives"
        if sides is not None and all(len(side.latex()) <= MAX_FORMULA_LENGTH for side in sides):
            units = f", in {'SI units' if book.counts_in_si else 'numbers'}," if in_numbers else ""
            so = f"{', that is,' if formula == plain else so}{units} {step.derived(*sides)}, so"
        step.add_text(f"{who}, {self.moving(row.number, 1)}: {law}{so} {step.closed(hidden, root)}.")
        if len(others) == 1 and others[0] < 0.0 < book.values[hidden.name]:
            step.add_text(f"The other root, ${with_unit(others[0], book.units[hidden.name])}$, is negative.")
        step.close()
        return hidden.name

    def _worked(self, held: Polynomial) -> Expression:
        """Return the numerical value of a polynomial as a formula."""
        return self.book.defer_to_number(held.factored())

    def _solved(self, name: str, formula: Expression) -> tuple[Expression, Expression]:
        """Return the question's unknown, for which a formula vanishes, and this formula; long ones have numbers."""
        book = self.book
        if name not in formula.symbols():
            raise UnsolvedError("the limit does not depend on the unknown")
        root = solved_for(name, formula, ZERO, book.values)
        if isinstance(root, NumericRoot) or len(root.latex()) > MAX_FORMULA_LENGTH:
            formula = evaluate_known_parts(formula, frozenset({name}), book.defer_to_number)
            root = solved_for(name, formula, ZERO, book.values, self._worked)
        if isinstance(root, NumericRoot) or len(root.latex()) > MAX_FORMULA_LENGTH:
            raise UnsolvedError("the limit has no short closed form")
        return root, formula

    def _either_way(self) -> str:
        """Return the sentence that slip the other way only changes the sign, if the symbolic answer is a magnitude."""
        formula, direction = self.setting.formula, self._slip_direction_words()
        if not self.book.in_symbols or formula is None or BAR not in formula.latex or not direction or self._with_it():
            return ""
        unknown = f"${self.book.sought}$"
        return (
            f"The equations below are for slipping{direction}; for slipping the other way {unknown} has the opposite "
            f"sign in them, so that the magnitude of {unknown} is the answer in both cases."
        )

    def _slip_direction_words(self) -> str:
        """Return the words for the direction of impending slip, after a space; empty if it has no short name."""
        sides = self.newton.slip_directions.items()
        face, side = next((n, s) for n, s in sides if self.mechanism.faces[n].subject == self._who)
        direction = slip_direction_text(self, face, side) if side else ""
        return f" {direction}" if direction else ""

    def _with_it(self) -> str:
        """Return a clause, with the reason, that other bodies at rest also have limiting friction; may be empty."""
        faces = [self.mechanism.faces[n] for n, side in self.newton.slip_directions.items() if side]
        still = {self.mechanism.coordinates[k].name for k in self.frozen}
        others = [f.subject for f in faces if f.subject != self._who and all(name in still for name, _ in f.slip)]
        if not others:
            return ""
        strings, bound = self._bound()
        why = f"which {strings} slip together with it" if bound.issuperset(others) else "which would slip as it does"
        return f", and so has the friction on {self.setting.bodies_phrase(others)}, {why}"

    def _bound(self) -> tuple[str, set[str]]:
        """Return words for the taut strings, and the set of bodies that they bind to the one about to slip."""
        taut = [
            string for n, string in enumerate(self.newton.lines) if self.values.get(f"T{n}", 0.0) > ACCELERATION_ATOL
        ]
        tied, bound_bodies = (
            [{self._body_at(line.through[0]), self._body_at(line.through[-1])} - {None} for line in taut],
            {self._who},
        )
        for _ in tied:
            bound_bodies.update(
                body for bodies in tied if not bound_bodies.isdisjoint(bodies) for body in bodies if body
            )
        return "the taut string makes" if len(taut) == 1 else "the taut strings make", bound_bodies

    def _body_at(self, site: str) -> str | None:
        """Return the body to which an attachment point belongs; None for a fixed point."""
        return self.mechanism.site[site].body

    def _introduce(self, *, slides: bool) -> None:
        """Write the conditions of the limiting case: which body is about to slip or rise, and what is still at rest."""
        step, who = self.book.begin_step("limit"), self.setting.display_name(self._who)
        either = self._either_way() if slides else ""
        direction = self._slip_direction_words() if slides and not either else ""
        what = f"slip{direction}: friction on it has its greatest value{self._with_it()};" if slides else "rise:"
        rests = len(self.frozen) == len(self.mechanism.coordinates)
        still = "all bodies are still at rest" if rests else "its acceleration is still zero"
        parent = self.mechanism.body[self._who].parent
        if not rests and slides and parent is not None:
            still = f"its acceleration relative to {self.setting.display_name(parent)} is still zero"
        step.add_text(f"In the limiting case {who} is just about to {what} {still}.", either)
        step.label("limit")
        step.close()


THRESHOLD_OFFSET = 1e-5  # relative distance from the threshold at which the motion is simulated
SIMULATED_TIME = 1e-6  # s, duration of that simulation
THRESHOLD_RTOL = 1e-3  # relative tolerance between the thresholds of the laws and of the engine


@strategy
class LimitingCase(Strategy):
    """The strategy for the threshold value at which a body begins to slip on its face or to rise."""

    name = "limiting case"
    cost = 1.0
    kinds = frozenset({"threshold"})

    def why_unsuitable(self, mechanism: Mechanism) -> str:
        """Return the reason, in words, that no body released at rest could slip or be lifted; empty if a body could."""
        lifted = mechanism.lines or mechanism.forces
        if any(c.speed for c in mechanism.coordinates) or not (lifted or any(f.friction for f in mechanism.faces)):
            return "nothing is let go that could stay at rest"
        return varying_acceleration(mechanism)

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        query = setting.query
        if not isinstance(query, ThresholdQuery) or not isinstance(query.outcome, Slides | Rises):
            return "the outcome does not show at once"
        return "" if setting.sought is not None else "there is no such value"

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write Newton's laws for impending motion with zero acceleration; return the symbol of the threshold."""
        path, sought = setting.unknown, book.sought
        query = setting.query
        assert isinstance(query, ThresholdQuery)
        draft = book.copy()
        try:
            self._balanced(setting, query, draft)
            write = self._balanced
        except UnsolvedError:
            draft = book.copy()
            self._accelerated(setting, query, draft)
            write = self._accelerated
        if abs(draft.values[sought] - book.values[sought]) > THRESHOLD_RTOL * abs(book.values[sought]):
            raise UnsolvedError("in the limiting case the unknown has another value")
        value = draft.values[sought] / setting.lexicon.givens[path].scale
        book.values[sought] = draft.values[sought]  # the engine has it as well as it sees what moves
        return write(replace(setting, scene=setting.scene.having(path, value)), query, book)

    def _balanced(self, setting: ProblemContext, query: ThresholdQuery, book: SolutionBuilder) -> str:
        """Write Newton's laws without the acceleration that is zero at the threshold; return the threshold's symbol."""
        assert query.outcome is not None
        balance = LimitingBalance(setting, book, _moving(setting, query), query.outcome.name)
        return balance.write(slides=isinstance(query.outcome, Slides))

    def _accelerated(self, setting: ProblemContext, query: ThresholdQuery, book: SolutionBuilder) -> str:
        """Write the acceleration of a body that just moves, and that it is zero at the threshold; return its symbol."""
        assert query.outcome is not None
        dynamics, name = LimitingDynamics(setting, book, _moving(setting, query)), query.outcome.name
        goals = _rate(dynamics, name, slides=isinstance(query.outcome, Slides))
        dynamics.reach([f"q{k}" for k in goals])
        rate = total(dynamics.names[f"q{k}"] * part for k, part in goals.items())
        who = setting.display_name(name)
        step = book.begin_step("limit")
        what = "slip: friction has its greatest value" if isinstance(query.outcome, Slides) else "move up"
        step.add_text(f"In the limiting case {who} is just about to {what}, and its acceleration is still zero:")
        symbol = rate.symbol
        if symbol is None:
            symbol = book.fresh("a", r"\text{rel}")
            step.add_text(f"{step.result(symbol, rate.expression(), ACCELERATION, law=True)}, and")
        step.add_text(f"{step.law(symbol, ZERO)}.")
        step.close()
        return Inversion(book, symbol.name, 0.0, book.sought).write()


def _moving(setting: ProblemContext, query: ThresholdQuery) -> Segment:
    """Return the initial segment of the motion for a parameter just beyond the threshold, where the body moves."""
    trial, limit = query.trial(setting.study), float(setting.scene.value(query.parameter))
    for side in (1.0 + THRESHOLD_OFFSET, 1.0 - THRESHOLD_OFFSET):
        if trial(limit * side):
            scene = setting.scene.having(query.parameter, limit * side)
            return motion(scene.mechanism, SIMULATED_TIME).segments[0]
    raise UnsolvedError("it comes about on neither side of the limit")


def _rate(dynamics: WrittenDynamics, name: str, *, slides: bool) -> dict[int, Polynomial]:
    """Return weights, by coordinate, of the accelerations that add up to that of a slip or of a body on its line."""
    if slides:
        face = next(n for n, candidate in enumerate(dynamics.mechanism.faces) if candidate.subject == name)
        weights = dynamics.newton.slip(face)
        for k in list(weights):
            if k in dynamics.carrier_coordinates:
                j, sign = dynamics.carrier_coordinates[k]
                weights[j] = weights.get(j, Polynomial({})) - weights[k].scale(sign)
        return weights
    own = dynamics.sufficient_coordinates(dynamics.newton.moving_coordinates(name))
    if len(own) != 1:
        raise UnsolvedError("it moves along no line of its own")
    return {own[0]: Polynomial.from_expression(1.0)}
