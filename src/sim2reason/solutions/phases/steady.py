"""Phases of constant acceleration: their contacts, their closed form, and the laws that the answer needs."""

import re
from collections.abc import Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import replace

import numpy as np

from sim2reason.scenes.dsl.state import Array
from sim2reason.solutions.algebra.evaluated import NumericRoot
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number, Symbol, multiply_factors, sum_terms
from sim2reason.solutions.algebra.functions import Power
from sim2reason.solutions.algebra.root_finding import solved_for, substitute
from sim2reason.solutions.laws.equations_of_motion import Names
from sim2reason.solutions.phases.equations import PhaseEquations
from sim2reason.solutions.phases.forces import explicit_formulas
from sim2reason.solutions.setting import capitalized, join_words
from sim2reason.solutions.solution import Relation, Step, with_unit
from sim2reason.solutions.writing.notation import SECONDS, split_name
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError

LAWS, STATE = "steady laws", "steady state"  # kinds of steps of which parts may be left out
WEIGHT_RTOL = 1e-9  # relative to the largest weight: rounding errors


def laws_text(relations: Sequence[Relation], values: Mapping[str, float]) -> str:
    """Return sentences with the laws, and with the accelerations that they give if they must be solved."""
    laws = [relation for relation in relations if relation.role == "law"]
    results = [r for r in relations if r.role != "law" and values[_name(r)]]
    turns = any(split_name(name)[0] == r"\alpha" for law in laws for name in law.symbols())
    by = "By Newton's second law and the law of torques" if turns else "By Newton's second law"
    text = f"{by}, the accelerations are constant: {join_words([law.latex() for law in laws])}."
    if not results or all(isinstance(law.left, Symbol) for law in laws):
        return text
    return f"{text} Hence {join_words([_write_result(r, values[_name(r)]) for r in results])}."


def _write_result(result: Relation, value: float) -> str:
    """Return a result in LaTeX as name = formula = value; without the formula if it is only a number."""
    if isinstance(result.right, Number):
        return f"${_name(result)} = {with_unit(value, result.unit)}$"
    return result.latex(value)


def state_text(relations: Sequence[Relation], values: Mapping[str, float]) -> str:
    """Return the sentence about the state at the end of a phase."""
    if not relations:
        return ""
    return f"At that instant, {join_words([relation.latex(values[_name(relation)]) for relation in relations])}."


def prune_steps(steps: Sequence[Step], goal: str, values: Mapping[str, float]) -> list[Step]:
    """Remove from steps the laws and final values on which the goal does not depend; step numbers are unchanged."""
    used, pruned = {goal}, list[Step]()
    for step in reversed(steps):
        kept = step
        if step.kind == STATE:
            relations = tuple(r for r in step.relations if _name(r) in used)
            kept = replace(
                step,
                relations=relations,
                gives=tuple(_name(r) for r in relations),
                text=state_text(relations, values),
            )
        elif step.kind == LAWS:
            kept = _with_needed_laws(step, used, values)
        used |= {*kept.symbols()}
        pruned.append(kept)
    return pruned[::-1]


def _with_needed_laws(step: Step, used: AbstractSet[str], values: Mapping[str, float]) -> Step:
    """Return a step reduced to the laws that determine the names in use."""
    laws = [relation for relation in step.relations if relation.role == "law"]
    wanted = [name for name in step.gives if name in used]
    matrix = _coefficients(laws, step.gives, values)
    targets = np.array([[float(name == goal) for name in step.gives] for goal in wanted]).reshape(-1, len(step.gives))
    if not _determines(matrix, targets):
        return step
    kept = [*range(len(laws))]
    for number in range(len(laws)):
        fewer = [n for n in kept if n != number]
        if _determines(matrix[fewer], targets):
            kept = fewer
    own = [laws[n] for n in kept]
    named = {name for law in own for name in law.symbols()}
    results = [r for r in step.relations if r.role != "law" and _name(r) in used]
    relations = (*own, *results)
    text = laws_text(relations, values) if own else ""
    return replace(step, relations=relations, gives=tuple(n for n in step.gives if n in named), text=text)


def _coefficients(laws: Sequence[Relation], unknowns: Sequence[str], values: Mapping[str, float]) -> Array:
    """Return the coefficient of each unknown in each law, (laws, unknowns); laws are linear in them."""

    def excess(at: Mapping[str, float]) -> Array:
        return np.array([float((law.left.value(at) - law.right.value(at)).real) for law in laws])

    zero = {**values, **dict.fromkeys(unknowns, 0.0)}
    return np.array([excess({**zero, name: 1.0}) - excess(zero) for name in unknowns]).reshape(-1, len(laws)).T


def _determines(matrix: Array, targets: Array) -> bool:
    """Return whether every target is a linear combination of the rows of a matrix."""
    if not len(targets):
        return True
    if not len(matrix):
        return False
    weights = np.linalg.lstsq(matrix.T, targets.T, rcond=1e-12)[0]
    return bool(np.abs(matrix.T @ weights - targets.T).max() <= WEIGHT_RTOL)


def _name(relation: Relation) -> str:
    return relation.left.name if isinstance(relation.left, Symbol) else ""


CONTACT = "contact"  # kind of the steps about one face
_NAMED = re.compile(r"\$([^$]*)\$")


def write_contacts(inner: PhaseEquations, book: SolutionBuilder, forces: Mapping[str, Symbol]) -> None:
    """Write for each rough face whether it slips or sticks, the direction of friction, and the symbols."""
    for face, side in inner.rough.items():
        step, who = book.begin_step(CONTACT), inner.setting.display_name(inner.mechanism.faces[face].subject)
        step.add_text(_slipping(inner, face, side, who, forces) if side else _sticking(inner, face, who, forces))
        turning = inner.turning_inertia(face)
        if turning:
            step.add_text(f"The moment of inertia of {who} about its axis is ${turning}$.")
        step.close()


def _slipping(inner: PhaseEquations, face: int, side: int, who: str, forces: Mapping[str, Symbol]) -> str:
    """Return a sentence with the directions of slip and of friction, and the symbol of the normal force."""
    ways, under = [_slip_direction_words(inner, face, sign) for sign in (side, -side)], _under(inner, face)
    slides, where = ("slips", " at the point of contact") if inner.is_round(face) else ("slides", "")
    normal = f"the normal force on {who} is ${forces[f'normal{face}'].latex()}$."
    if not all(ways):
        return capitalized(normal)
    return f"{capitalized(who)} {slides} {ways[0]}{where}{under}, so the friction on it acts {ways[1]}; {normal}"


def _sticking(inner: PhaseEquations, face: int, who: str, forces: Mapping[str, Symbol]) -> str:
    """Return a sentence that a contact sticks, with the symbol and positive direction of the friction."""
    direction, holds = (
        _slip_direction_words(inner, face, 1),
        "rolls without slipping" if inner.is_round(face) else "does not slip",
    )
    counted = f", counted positive {direction}," if direction else ""
    return f"{capitalized(who)} {holds}; the static friction on it{counted} is ${forces[f'friction{face}'].latex()}$."


def with_used_contacts(steps: Sequence[Step]) -> list[Step]:
    """Return the steps, with an empty text for each contact whose forces the next step with laws does not use."""
    updated: list[Step] = []
    for number, step in enumerate(steps):
        if step.kind == CONTACT:
            laws = next((later for later in steps[number:] if later.kind == LAWS), None)
            used = {*laws.symbols()} if laws is not None else set[str]()
            if used.isdisjoint(_NAMED.findall(step.text)):
                step = replace(step, text="")  # noqa: PLW2901
        updated.append(step)
    return updated


def _slip_direction_words(inner: PhaseEquations, face: int, sense: int) -> str:
    """Return the direction in which a body slips on a face, in words; empty if it has none."""
    m = inner.mechanism
    slides = [(m.number[name], part) for name, part in m.faces[face].slip]
    slides = [(k, part) for k, part in slides if m.coordinates[k].kind == "slide"]
    if not slides:
        return ""
    k, part = slides[0]
    sign = 1.0 if sense * part > 0.0 else -1.0
    x, y, z = m.coordinates[k].axis
    body = m.coordinates[k].body
    return inner.setting.direction_words((sign * x, sign * y, sign * z), on=m.body[body].parent)


def _under(inner: PhaseEquations, face: int) -> str:
    """Return a phrase that the slip is relative to a moving surface; empty if the surface is fixed."""
    m = inner.mechanism
    slides = [name for name, _ in m.faces[face].slip if m.coordinates[m.number[name]].kind == "slide"]
    return " relative to the surface under it" if len(slides) > 1 else ""


Start = tuple[Expression, Sequence[Expression], Sequence[Expression]]
"""The time at which a phase begins, and the coordinates and rates at that time."""
HALF = Number(0.5)
MAX_DURATION_LENGTH = 200  # maximum length of the LaTeX of a duration that is written as a formula


class SteadyPhase:
    """A phase in which all accelerations and forces are constant."""

    def __init__(
        self, inner: PhaseEquations, start: tuple[Expression, Sequence[Expression], Sequence[Expression]]
    ) -> None:
        """Take the equations of the phase, and its initial time, coordinates and rates."""
        self._inner, self._names = inner, inner.names
        self._begin, self._places, self._rates = start

    def write(
        self, book: SolutionBuilder, names: Names, forces: dict[str, Symbol], formula: Expression, said: str
    ) -> None:
        """Write the accelerations, the duration until a formula vanishes, and the state at the end.

        The builder knows the final values of `names` and `forces` already.

        Raises:
            UnsolvedError: the formula contains a force or an acceleration.
        """
        write_contacts(self._inner, book, forces)
        self._accelerate(book, names, forces)
        span = self._last(book, names, formula, said)
        step = book.begin_step(STATE)
        if span != names.time:
            step.defined(names.time, sum_terms(self._begin, span))
        for k in range(len(names.places)):
            step.defined(names.places[k], self._place(k, names, span))
            step.defined(names.rates[k], self._rate(k, names, span))
        step.add_text(state_text(step.relations, book.values))
        step.close()

    def _accelerate(self, book: SolutionBuilder, names: Names, forces: dict[str, Symbol]) -> None:
        """Write the laws, which determine the constant accelerations and forces."""
        step, inner = book.begin_step(LAWS), self._inner
        own = {old.name: new for old, new in zip(self._names.accelerations, names.accelerations, strict=True)}
        own |= {inner.forces[key].name: symbol for key, symbol in forces.items()}
        for law in inner.laws:
            step.law(_renamed(law.left, own), _renamed(law.right, own))
        symbols = [symbol for symbol in own.values() if symbol.name in book.values]
        for symbol in symbols:
            step.label(symbol.name)
        plain = all(isinstance(relation.left, Symbol) for relation in step.relations)
        formulas = (
            explicit_formulas(step.relations, [symbol.name for symbol in symbols], book.values) if not plain else {}
        )
        for symbol in symbols if not plain else ():
            if symbol.name in formulas and book.values[symbol.name]:
                step.relations.append(Relation(symbol, formulas[symbol.name], "derived", book.units[symbol.name]))
            elif book.values[symbol.name]:
                step.stated(symbol, book.units[symbol.name])
        step.add_text(laws_text(step.relations, book.values))
        step.close()

    def _last(self, book: SolutionBuilder, names: Names, formula: Expression, said: str) -> Symbol:
        """Write the duration of the phase, s, and return its symbol."""
        first = self._begin == ZERO  # what lasts until an instant is its time
        span = names.time if first else book.fresh(r"\tau")
        near = book.values[names.time.name] - book.value(self._begin)
        for k, (position, rate) in enumerate(zip(self._names.places, self._names.rates, strict=True)):
            formula = substitute(
                substitute(formula, rate.name, self._rate(k, names, span)), position.name, self._place(k, names, span)
            )
        formula = substitute(formula, self._names.time.name, sum_terms(self._begin, span))
        if not {*formula.symbols()} <= {*book.values, span.name}:
            raise UnsolvedError("the end of a phase of constant acceleration depends on a force")
        duration = solved_for(span.name, formula, ZERO, {**book.values, span.name: near})
        if not isinstance(duration, NumericRoot) and len(duration.latex()) > MAX_DURATION_LENGTH:
            duration = NumericRoot(formula, span.name, near)
        step = book.begin_step("duration")
        law = step.law(formula, ZERO)
        step.add_text(f"{self._how()} for a time ${span.name}$, until {said}: {law},")
        step.add_text(f"so that {step.closed(span, duration) if first else step.result(span, duration, SECONDS)}.")
        step.close()
        return span

    def _how(self) -> str:
        """Return how the phase proceeds, in words, such as *All velocities remain constant*."""
        inner = self._inner
        if not all(inner.is_still(k) for k in range(len(inner.mechanism.coordinates))):
            return "This goes on"
        rolls = [face for face, side in inner.rough.items() if side == 0 and len(inner.mechanism.faces[face].slip) > 1]
        if not rolls:
            return "All velocities remain constant"
        who = capitalized(inner.setting.display_name(inner.mechanism.faces[rolls[0]].subject))
        return f"{who} now rolls, which on level ground needs no friction, so all velocities remain constant"

    def _place(self, k: int, names: Names, span: Symbol) -> Expression:
        gained = sum_terms(
            multiply_factors(self._rates[k], span), self._bent(k, names, multiply_factors(HALF, Power(span, 2)))
        )
        return sum_terms(self._places[k], gained)

    def _rate(self, k: int, names: Names, span: Symbol) -> Expression:
        return sum_terms(self._rates[k], self._bent(k, names, span))

    def _bent(self, k: int, names: Names, factor: Expression) -> Expression:
        """Return the acceleration of a coordinate times a factor; zero if the coordinate is not accelerated."""
        zero = self._inner.is_still(k)
        return ZERO if zero else multiply_factors(names.accelerations[k], factor)


def _renamed(formula: Expression, names: dict[str, Symbol]) -> Expression:
    for old, new in names.items():
        formula = substitute(formula, old, new)
    return formula
