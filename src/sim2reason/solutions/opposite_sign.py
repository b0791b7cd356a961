"""The sign of a quantity of which a question states only the magnitude: why the opposite sign is excluded."""

from collections.abc import Iterator, Sequence

from sim2reason.solutions.algebra.evaluated import Chain
from sim2reason.solutions.algebra.expressions import ONE, ZERO, Expression, Sum, Symbol
from sim2reason.solutions.algebra.functions import Absolute, Call, Root
from sim2reason.solutions.algebra.root_finding import (
    is_explicit,
    is_restitution,
    range_text,
    substitute_all,
    values_with,
)
from sim2reason.solutions.other_roots import OtherRoots
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.solution import with_unit
from sim2reason.solutions.writing.steps import SolutionBuilder, StepBuilder, UnsolvedError, record_inequality

SQUARES = frozenset({"kinetic energy", "rotational kinetic energy", "translational kinetic energy"})  # never negative
MAGNITUDE_ONLY = "Only a magnitude is given;"
"""Beginning of the sentence that excludes the opposite sign."""
SINES = {"arcsin": "sine", "arccos": "cosine"}


def states_only_magnitude(setting: ProblemContext, book: SolutionBuilder, goal: str) -> bool:
    """Return whether the question states only the magnitude of the goal, a quantity that could have either sign."""
    target = setting.target
    if target is None or target.sense is not None or target.quantity in SQUARES:
        return False
    slides = goal in book.formulas and any(name.startswith(r"\mu") for name in book.formulas[goal].symbols())
    return book.sign_chosen != 0 or (target.quantity == "friction force" and not slides)


def exclude_opposite_sign(
    book: SolutionBuilder, step: StepBuilder, goal: str, inverse_chain: Sequence[tuple[str, Expression]]
) -> bool:
    """Write why the goal with the opposite sign allows no value of the unknown; return whether a reason was found.

    `inverse_chain` has the formulas from the goal to the unknown: each name with its formula, the unknown last.
    """
    values: dict[str, Expression] = {goal: -Symbol(goal)}
    for number, (name, original) in enumerate(inverse_chain):
        try:
            formula = substitute_all(original, values)
        except TypeError:  # a number that is not written as a formula
            return False
        reason = _impossible(book, step, goal, name, formula)
        if reason is None and number == len(inverse_chain) - 1:
            reason = _out_of_range(book, step, goal, name, formula)
        if reason is not None:
            step.add_text(f"{MAGNITUDE_ONLY} with $-{goal}$ in place of ${goal}$, {reason}." if reason else "")
            return bool(reason)
        values[name] = formula
    return False


def _impossible(book: SolutionBuilder, step: StepBuilder, goal: str, name: str, formula: Expression) -> str | None:
    """Return why a formula has no real value, in words; empty if this is obvious; None if the formula has a value."""
    for part in _inner_first(formula):
        if isinstance(part, Root):
            if goal not in part.names:
                continue
            if book.value(part.inside) >= 0.0:
                return None  # of either sign
            if not any(isinstance(inner, Sum) for inner in _inner_first(part)):
                return ""  # whoever sees the formula sees its sign
            record_inequality(book, step, ZERO, part.inside)
            return f"${name}$ would not be real, as what stands under the square root would be negative"
        if isinstance(part, Call) and part.function in SINES and abs(book.value(part.argument)) > 1.0:
            size = book.value(part.argument)
            record_inequality(book, step, Absolute(part.argument), ONE)
            whose = "its" if part in (formula, -formula) else "the"  # of the angle, or of a sum with it
            clause = f"{whose} {SINES[part.function]} would be ${with_unit(size, '')}$"
            return f"there would be no angle ${name}$, as {clause}"
    return None


def _out_of_range(book: SolutionBuilder, step: StepBuilder, goal: str, name: str, formula: Expression) -> str:
    """Return the clause that the unknown would be negative, or a restitution coefficient above 1; empty if neither."""
    try:
        branches = _of_either_sign(goal, formula)
        numbers = list(dict.fromkeys(with_unit(book.value(branch), book.units[name]) for branch in branches))
        value = max(map(book.value, branches))
    except UnsolvedError:  # a branch has no value, or there are more than two
        return ""
    given = " or ".join(f"${number}$" for number in numbers)  # maybe no solutions, as the formula comes from squares
    would = f"the formula would give {given} for ${name}$"
    if value < 0.0 < book.values[name]:
        for branch in branches:
            record_inequality(book, step, ZERO, branch)
        return f"{would}, which is negative" if len(numbers) == 1 else f"{would}, both negative"
    if len(branches) > 1:
        return ""
    if is_restitution(name, book) and value > 1.0:
        record_inequality(book, step, formula, ONE)
        return f"{would}, which is more than 1"
    return ""


def _of_either_sign(goal: str, formula: Expression) -> list[Expression]:
    """Return a formula and, if a square root in it contains the goal, the same with the root's sign reversed.

    Raises:
        UnsolvedError: several square roots contain the goal.
    """
    roots = (part for part in _inner_first(formula) if isinstance(part, Root) and goal in part.names)
    distinct_roots = list(dict.fromkeys(roots))
    if len(distinct_roots) > 1:
        raise UnsolvedError("several roots have more than two branches")
    return [formula, _with(formula, distinct_roots[0], -distinct_roots[0])] if distinct_roots else [formula]


def _with(formula: Expression, old: Expression, new: Expression) -> Expression:
    if formula == old:
        return new
    return formula.built_of([_with(part, old, new) for part in formula.parts]) if formula.parts else formula


def _inner_first(formula: Expression) -> Iterator[Expression]:
    for part in formula.parts:
        yield from _inner_first(part)
    yield formula


OPPOSITE_SIGN_LEAD = f"{MAGNITUDE_ONLY} with the opposite sign, for which {{}} would be {{}}"
"""Beginning of the sentence that excludes a value of the unknown with which the goal has the opposite sign."""


def write_sign_reason(
    roots: OtherRoots, step: StepBuilder, chain: Chain | None, inverse_chain: Sequence[tuple[str, Expression]]
) -> None:
    """Write why the opposite sign of the goal is excluded: the unknown would have no value or an impossible value.

    The `chain` leads from the unknown to the goal, and is None where the sign is known. If one of its formulas is a
    root that was found numerically, no other values are searched for.
    """
    if chain is None:
        return
    goal, _ = chain.formulas[-1]
    if exclude_opposite_sign(roots.book, step, goal, inverse_chain) or not is_explicit(chain):
        return
    others = values_with(chain, -float(chain.value(roots.book.values).real), roots.unknown, roots.book)
    if not others:
        what = range_text(roots.unknown, roots.book)
        step.add_text(f"{MAGNITUDE_ONLY} no {what} gives $-{goal}$ in place of ${goal}$.")
    roots.schedule_exclusion(others, OPPOSITE_SIGN_LEAD)
