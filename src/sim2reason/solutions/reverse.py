"""Reverse questions: the result is given, and the same laws are solved for one unknown parameter."""

from collections.abc import Sequence
from dataclasses import replace

from sim2reason.questions import Query
from sim2reason.questions.kinds.optimum import OptimumQuery
from sim2reason.questions.kinds.threshold import ThresholdQuery
from sim2reason.questions.moments.reached import Reached
from sim2reason.questions.moments.times import AtTime
from sim2reason.solutions.algebra.evaluated import (
    Chain,
    ImplicitRoot,
    NumericFormula,
    NumericRoot,
    SpecialFunction,
    loses_digits,
    numeric_parts,
)
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Quotient, Symbol, sum_terms
from sim2reason.solutions.algebra.polynomials import Polynomial
from sim2reason.solutions.algebra.root_finding import (
    evaluate_known_parts,
    numeric_root,
    other_solutions,
    solved_for,
    substitute,
)
from sim2reason.solutions.algebra.standard_equations import (
    as_one_fraction,
    as_power,
    closed_root,
    found_by_double_angle,
    fraction_in,
    half_angles,
    single_sine,
    stated_equation,
    trend,
)
from sim2reason.solutions.equivalent_questions import at_end, at_named_moment
from sim2reason.solutions.opposite_sign import write_sign_reason
from sim2reason.solutions.other_roots import OtherRoots, Sides
from sim2reason.solutions.setting import ProblemContext, join_words
from sim2reason.solutions.writing.arrangement import SOLVE_KIND
from sim2reason.solutions.writing.steps import SolutionBuilder, StepBuilder, UnsolvedError

SHORT_EQUATION_TERMS = 2  # number of terms of an equation whose root can be read off
MAX_FORMULA_LENGTH = 300  # maximum length of the LaTeX of a formula that is written out
MAX_SUBSTITUTIONS = 40  # maximum number of substitutions of one formula into another


def forward(setting: ProblemContext) -> ProblemContext:
    """Rewrite a question for a time, threshold or optimum as one for a quantity at a known moment; others unchanged.

    For *when is the speed 2.1 m/s?* it asks for the speed at the time t, the answer. For a threshold, the number whose
    limit is meant has its limiting value; if a result states that, another number is the unknown. For an optimum, the
    scene is the one that has it. For an extreme value at the end of a stretch it asks for the value at that moment, and
    for *how fast is it when its displacement is 2 m?* at the moment with a name of its own, that it has moved 2 m.
    """
    if isinstance(setting.query, ThresholdQuery) and setting.answer is not None and setting.sought is None:
        path, sought = setting.query.parameter, setting.answer
        limit = sought if setting.stated is None else setting.stated.value
        unknown = path if setting.stated is None else setting.unknown
        scene = setting.scene.having(path, limit)
        return replace(setting, scene=scene, unknown=unknown, stated=None, sought=sought)
    if isinstance(setting.query, OptimumQuery) and setting.answer is not None and setting.sought is None:
        optimum = setting.query.place(setting.study)
        if optimum is not None:
            scene = setting.scene.having(setting.query.path, optimum)
            return replace(setting, scene=scene, unknown=setting.query.path, stated=None, sought=setting.answer)
    moment = setting.query.moment
    if setting.query.kind == "extremum":
        return at_end(setting) or setting
    if not isinstance(moment, Reached) or setting.answer is None:
        return setting
    if setting.query.kind != "time_to_event":
        return at_named_moment(setting)
    query = Query("state", moment.target, AtTime(setting.answer))
    return replace(setting, query=query, stated=moment.given, sought=setting.answer)


class Inversion:
    """The solver that goes from the given value of a goal back to the unknown parameter."""

    def __init__(
        self, book: SolutionBuilder, goal: str, value: float, unknown: str, *, magnitude: bool = False
    ) -> None:
        """Take the `value` of the goal in SI units; with `magnitude` the question states only its absolute value."""
        self.book, self.goal, self.unknown = book, goal, unknown
        if goal not in book.formulas:
            raise UnsolvedError("what is given does not hang on what is unknown")
        self.stated = value
        self._found: list[tuple[str, Expression]] = []  # names from the goal to the unknown, with their formulas
        self._guarded = False  # whether numbers are written with guard digits, since digits cancel
        self._inserted: list[str] = []  # names whose formulas were put in since the last name was found
        self._defined = book.formulas[goal]
        self._roots = OtherRoots(book, unknown, lambda name: self._chain(name, *self._leading(name)))
        signed = magnitude and not book.in_symbols
        self._signed = self._chain(goal, *self._leading(goal)) if signed else None  # the goal of either sign

    def write(self, spelled: str = "") -> str:
        """Write the steps to the unknown and return its symbol; `spelled` is the given result as text, "" for zero."""
        book, at = self.book, self.goal
        formula, value = self._initial_equation(spelled)
        for _ in range(MAX_SUBSTITUTIONS):
            if any(book.is_hidden(part) for part in numeric_parts(formula)):
                raise UnsolvedError("it would need numbers that are not known")
            names = [name for name in dict.fromkeys(formula.symbols()) if name in book.hidden]
            later = [name for name in names if name != self.unknown]
            if len(names) == 1 and not isinstance(formula, ImplicitRoot):
                solution = self._inverted(names[0], formula, value)
                if not isinstance(solution, NumericRoot) or names[0] == self.unknown:
                    book.check_need(solution)  # before the search for other roots, which costs more
                    others = self._others(names[0], formula, value)
                    behind = self._equation_behind(names[0], solution, formula, value)
                    self._close(names[0], solution, at, others, [*([behind] if behind else []), (value, formula)])
                    if names[0] == self.unknown:
                        return self.unknown
                    at, (formula, value), self._inserted = names[0], self._equation(names[0]), []
                    self._guarded = False
                    continue
            if any(isinstance(part, ImplicitRoot) for part in (formula, *(book.formulas[name] for name in later))):
                return self._numerically(at)
            if not later:
                raise UnsolvedError("what is given does not hang on what is unknown")
            formula = self._short(formula)
            if len(formula.latex()) > MAX_FORMULA_LENGTH:
                return self._numerically(at)
            last = max(later, key=list(book.formulas).index)
            formula = substitute(formula, last, book.formulas[last])
            self._inserted.append(last)
        return self._numerically(at)

    def _initial_equation(self, spelled: str) -> tuple[Expression, Expression]:
        """Return both sides of goal formula = given value; for a goal defined by an equation, its residual and zero."""
        book, formula = self.book, self._defined
        if spelled:
            book.make_given(self.goal, self.stated, spelled)
            return (formula.residual, ZERO) if isinstance(formula, ImplicitRoot) else (formula, Symbol(self.goal))
        del book.formulas[self.goal]  # it keeps the value that is set
        book.hidden.discard(self.goal)
        book.values[self.goal] = 0.0
        return formula, ZERO

    def _short(self, formula: Expression) -> Expression:
        """Return a formula, with numbers in place of known symbols if it is too long to read."""
        if len(formula.latex()) <= MAX_FORMULA_LENGTH:
            return formula
        plain = as_one_fraction(formula, self.unknown)
        if len(plain.latex()) <= MAX_FORMULA_LENGTH:
            return plain
        return evaluate_known_parts(formula, frozenset(self.book.hidden), self.book.defer_to_number)

    def _equation(self, name: str) -> tuple[Expression, Expression]:
        """Return both sides of formula = value for a name; for one defined by an equation, its residual and zero."""
        definition = self.book.formulas[name]
        return (definition.residual, ZERO) if isinstance(definition, ImplicitRoot) else (definition, Symbol(name))

    def _inverted(self, name: str, formula: Expression, value: Expression) -> Expression:
        """Return a formula solved for a name, with numbers in place of known symbols if it is too long to read."""
        book = self.book
        solution = solved_for(name, formula, value, book.values)
        if isinstance(solution, NumericRoot) or len(solution.latex()) > MAX_FORMULA_LENGTH:
            short = self._in_numbers(name, formula)
            power = as_power(short, name, book.defer_to_number)
            if power is not None:
                return solved_for(name, power, value, book.values)
            solution = solved_for(name, short, value, book.values, self._worked)
            if not isinstance(solution, NumericRoot) and loses_digits(solution, book.values):
                self._guarded = True
                solution = solved_for(name, short, value, book.values, self._worked)
        return (
            solution if len(solution.latex()) <= MAX_FORMULA_LENGTH else numeric_root(name, formula, value, book.values)
        )

    def _worked(self, held: Polynomial) -> Expression:
        """Return the value of a coefficient, with guard digits if a difference of such numbers would lose digits."""
        value = self.book.defer_to_number(held.factored())
        return replace(value, guarded=True) if self._guarded and isinstance(value, NumericFormula) else value

    def _in_numbers(self, name: str, formula: Expression) -> Expression:
        """Replace all symbols of a formula except one by their numerical values."""
        return evaluate_known_parts(formula, frozenset({name}), self.book.defer_to_number)

    def _others(self, name: str, formula: Expression, value: Expression) -> Sequence[float]:
        """Return the further values of a name that satisfy formula = value, besides its known one."""
        if self.book.in_symbols:
            return ()
        solutions = other_solutions(name, formula, value, self.book.values)
        return solutions or other_solutions(name, self._in_numbers(name, formula), value, self.book.values)

    def _equation_behind(self, name: str, found: Expression, formula: Expression, value: Expression) -> Sides | None:
        """Return both sides of the equation to show before its root; None if inverse operations alone give the root."""
        if isinstance(found, NumericRoot):
            already_stated = self.book.in_symbols or formula is self._defined or isinstance(formula, ImplicitRoot)
            hidden = already_stated or len(formula.latex()) > MAX_FORMULA_LENGTH or value == ZERO
            return None if hidden else (value, formula)
        if not any(part in found.latex() for part in (r"\sqrt", r"\arctan")):
            return self._put_together(name, found, formula, value)
        if next(numeric_parts(found), None) is None:
            sides = stated_equation(name, formula, value, Polynomial.factored)
        else:
            short = self._in_numbers(name, formula)
            sides = stated_equation(name, short, value, self._worked)
        return sides or self._put_together(name, found, formula, value)

    def _put_together(self, name: str, found: Expression, formula: Expression, value: Expression) -> Sides | None:
        """Return the sides of the equation that results from substitution; None if it is too long."""
        bare = isinstance(found, Quotient) and {type(part) for part in found.parts} == {NumericFormula}
        if not self._inserted and not bare:
            return None
        if next(numeric_parts(found), None) is not None:
            short = self._in_numbers(name, formula)
            formula = as_power(short, name, self.book.defer_to_number) or short
        formula = as_one_fraction(formula, name)
        return (value, formula) if len(formula.latex()) <= MAX_FORMULA_LENGTH else None

    def _only_root(self, name: str, formula: Expression, found: Expression) -> str:
        """Return a clause that an equation solved numerically has a single root, if its right side is monotonic."""
        how = trend(formula, name, self.book.values) if isinstance(found, NumericRoot) else ""
        return f". The right side {how} as ${name}$ increases, so it has only one root" if how else ""

    def _numerically(self, at: str) -> str:
        """Write the numerical solution of all formulas together for the unknown, and return its symbol."""
        book = self.book
        names = self._leading(at)
        chain = self._chain(at, *names)
        near = book.values[self.unknown]
        closed = closed_root(chain, Symbol(at), self.unknown, book.values)
        root = closed or NumericRoot(sum_terms(chain, -Symbol(at)), self.unknown, near)
        book.check_need(root)
        book.condition_number = abs(root.slope(book.values, near) * near / (book.values[at] or 1.0))
        book.refresh(self.unknown, book.value(root))
        step = book.begin_step(SOLVE_KIND)
        if not self.stated:
            step.rest_on(self.goal)
        if closed:
            sides = fraction_in(chain, Symbol(at), self.unknown, book.values)
            same = f", or ${closed.equation.latex()} = 0$" if len(closed.equation.parts) > SHORT_EQUATION_TERMS else ""
            how = f"{step.derived(*sides)}{same}, so"
            lead = f"{self._insertion(at, names[::-1])} gives, in {'SI units' if book.counts_in_si else 'numbers'},"
        else:
            lead, how = "These equations together", "have the numerical solution"
        step.add_text(f"{lead} {how} {step.closed(Symbol(self.unknown), root)}.")
        others = other_solutions(self.unknown, closed.equation, ZERO, book.values) if closed else []
        self._roots.drop(step, self.unknown, others)
        self._roots.schedule_exclusion(others)
        write_sign_reason(self._roots, step, self._signed, self._found)
        self._tell_implied(step, names)
        step.close()
        return self.unknown

    def _tell_implied(self, step: StepBuilder, names: Sequence[str]) -> None:
        """Write the values of names that have been defined without one: roots and special functions."""
        equations: list[str] = []
        for name in names:
            formula = self.book.formulas[name]
            if isinstance(formula, ImplicitRoot):
                equations.append(step.closed(Symbol(name), NumericRoot(formula.residual, formula.name, formula.near)))
            elif isinstance(formula, SpecialFunction):
                equations.append(step.closed(Symbol(name), formula))
        step.add_text(f"With it, {join_words(equations)}." if equations else "")

    def _leading(self, at: str) -> list[str]:
        """Return the unknown names on which a name depends, each after those on which it depends itself."""
        formulas, waiting, dependencies = self.book.formulas, [at], set[str]()
        while waiting:
            more = self._formula(waiting.pop()).names & (self.book.hidden & formulas.keys()) - dependencies
            dependencies |= more
            waiting += more
        return [name for name in formulas if name in dependencies]

    def _chain(self, at: str, *names: str) -> Chain:
        """Return the formulas of some names, and of one that depends on them, as a chain."""
        return Chain(tuple((name, self._formula(name)) for name in (*names, at)))

    def _formula(self, name: str) -> Expression:
        """Return the formula of a name, or of the goal, which may no longer be stored."""
        return self._defined if name == self.goal else self.book.formulas[name]

    def _lead(self, at: str, equation: Sides) -> str:
        """Return the words before an equation that results from substitution; empty for any other equation."""
        numeric, counted = any(next(numeric_parts(side), None) is not None for side in equation), self.book.counts_in_si
        units = f" in {'SI units' if counted else 'numbers'}," if numeric else ""
        if not self._inserted:
            return f"In{units[3:]} " if numeric else ""
        given = at == self.goal and self.stated and equation[0].latex() != at
        what, value = self._insertion(at, self._inserted), f", with the given ${at}$," if given else ""
        return f"{what}{value} gives{',' if units else ''}{units} "

    def _insertion(self, at: str, names: Sequence[str]) -> str:
        """Return the beginning of a sentence about formulas inserted into the equation for the name `at`."""
        inserted = [f"${name}$" for name in names if name not in (self.unknown, at)]
        if not inserted:
            return f"The equation for ${at}$"
        return f"Inserting {join_words(inserted)} into the equation for ${at}$"

    def _close(self, name: str, found: Expression, at: str, others: Sequence[float], written: Sequence[Sides]) -> None:
        """Write the value of a symbol after the equation that determines it, or a simpler form of that equation."""
        equation = written[0] if len(written) > 1 else None
        step = self.book.begin_step(SOLVE_KIND)
        given = at == self.goal and bool(self.stated)
        where, how = f"With the given ${at}$, " if given else "So ", ""
        if isinstance(found, NumericRoot):
            how = "the numerical solution is "
        if not self.stated:
            step.rest_on(self.goal)
        names = self._leading(self.goal) if name == self.unknown else []
        if equation is not None:
            derivation, end = step.derived(*equation), "; " if how else ", so "
            if self._inserted and given and not how and equation[0].latex() == at:
                end = f", so for the given ${at}$, "
            lead = self._lead(at, equation) or where.replace("So ", "Hence ", 1)
            sine = single_sine(name, found)
            end = f". {sine}, so " if sine and end == ", so " else end
            where = f"{lead}{derivation}{self._only_root(name, equation[1], found)}{end}"
            if found_by_double_angle(equation[1], found, name):
                where = f"{where}with {join_words([step.derived(*sides) for sides in half_angles(name)])}, "
        self.book.values[name] = self.book.value(found)
        if name == self.unknown:
            self.book.refresh(name, self.book.values[name])
        step.add_text(f"{where}{how}{step.closed(Symbol(name), found)}.")
        if not isinstance(found, NumericRoot):
            self._roots.write_exclusions(step, name, found, others, written)
        self._found.append((name, found))
        if name == self.unknown:
            write_sign_reason(self._roots, step, self._signed, self._found)
        self._tell_implied(step, names)
        step.close()
