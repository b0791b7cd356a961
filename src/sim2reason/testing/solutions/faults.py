"""Verification of a worked solution: relations hold, laws determine the answer, and none is redundant."""

import re
from collections.abc import Mapping, Sequence

import numpy as np

from sim2reason.scenes.dsl.state import Array
from sim2reason.solutions.algebra.digits import DIGITS, round_to_digits
from sim2reason.solutions.algebra.evaluated import gradient
from sim2reason.solutions.algebra.expressions import Expression, Sum, Symbol
from sim2reason.solutions.checking import recompute
from sim2reason.solutions.collisions.long_chains import TIME
from sim2reason.solutions.data import as_data
from sim2reason.solutions.solution import CHECKS, RELATION_RTOL, Relation, Solution

FAINT = 1e-8  # relative residual of a combination of laws for a row that follows from them
ROUNDING = 1e-13  # SI units: rounding error of numbers that cancel
ASIDE, ROUNDS = 0.03, 6  # relative displacement of free values; Newton steps back onto the laws
AWAY = 1e-3  # relative displacement of given values to detect coincidences
CARRIED = 5e-3  # relative error of the answer from numbers rounded to five digits
SEEN = {"threshold": 1e-7, "optimum": 1e-6, "limit": 1e-7}
"""By kind: an engine holds by friction what pulls by 1e-10 of the loads more than it can; extremes are flat."""
KNOWN = ("given",)  # roles of names that no law needs to determine
WORDS = {"easy": 150, "medium": 300, "hard": 600}


def words(text: str) -> int:
    """Return the number of words in a text; a formula counts as one."""
    return len(re.sub(r"\$[^$]*\$", "x", text).split())


def faults(solution: Solution, answer: float, within: float = RELATION_RTOL) -> list[str]:
    """Return all faults of a solution, in words; `answer` is the engine's, in the unit of the question.

    `within` is the engine's relative accuracy, see `SEEN`, or that of the given result if a number is unknown.
    """
    if solution.answer is None:
        return [f"no answer: {solution.reason}"]
    found: list[str] = []
    if abs(solution.answer - answer) > within / min(1.0, solution.keen or 1.0) * abs(answer):
        found.append(f"it gives {solution.answer:.12g}, the engine {answer:.12g}")
    found += [f"does not hold: {r.latex()}" for r in solution.relations if not holds(r, solution.values)]
    found += [f"recomputed: {fault}" for fault in recompute(as_data(solution)).faults]
    if not solution.derived:  # an integration carries all digits, and states more of its end than is asked for
        return found
    found += undetermined(solution)
    carried = by_digits(solution)
    if not abs(carried - answer) <= CARRIED * abs(answer):  # also where it is not a number
        found.append(f"with {DIGITS} digits it gives {carried:.6g}, not {answer:.6g}")
    return found


def holds(relation: Relation, values: Mapping[str, float]) -> bool:
    """Return whether an equation holds within rounding, or a comparison is true, for the given values."""
    left, right = relation.left.value(values), relation.right.value(values)
    if relation.role == "exceeds":
        return left.real > right.real
    size = max(_size(relation.left, values), _size(relation.right, values))
    return abs(left - right) <= RELATION_RTOL * size + ROUNDING


def _size(held: Expression, at: Mapping[str, float]) -> float:
    terms = held.terms if isinstance(held, Sum) else (held,)
    return max((abs(term.value(at)) for term in terms), default=0.0)


def undetermined(solution: Solution) -> list[str]:
    """Return faults in words where the laws do not determine the answer, or one of the laws is redundant.

    Solutions with an integrated phase are not allowed.
    """
    relations = [r for r in solution.relations if r.role not in (*KNOWN, *CHECKS)]
    known = {name for r in solution.relations if r.role in KNOWN for name in r.left.symbols()}
    names = sorted({name for r in relations for name in r.symbols()} - known)
    place = {name: number for number, name in enumerate(names)}
    values = dict(solution.values)
    goals = [solution.goal]
    if unknown := [name for name in goals if name not in place and name not in known]:
        return [f"no relation speaks of {name}" for name in unknown]
    rows = [_row(r, values, place) for r in relations]
    laws = [number for number, r in enumerate(relations) if r.role == "law"]
    found: list[str] = []
    told = [rows[number] for number in laws]
    sought = goals, _since_when(solution)
    units, since = ([np.eye(len(names))[place[n]] for n in some if n in place] for some in sought)
    if not all(_spanned(told, unit) for unit in units):
        found.append("the laws that are told do not determine the answer")
    else:
        there = _elsewhere(solution)
        others = [_row(r, there, place) for r in relations]

        def are_enough(kept: list[int]) -> bool:
            spanned = all(_spanned([e[k] for k in kept], unit) for e in (rows, others) for unit in [*units, *since])
            return spanned and all(_spared([relations[k] for k in kept], values, place, unit) for unit in units)

        idle = [n for n in laws if are_enough([k for k in laws if k != n])] if units else []
        found += [f"superfluous: {relations[number].latex()}" for number in idle]
    derived = (number for number, relation in enumerate(relations) if relation.role != "law")
    strays = [relations[number].latex() for number in derived if not _spanned(told, rows[number])]
    return found + [f"does not follow from what is told: {text}" for text in strays]


def _since_when(solution: Solution) -> list[str]:
    """Return the names besides the answer whose values the laws must determine, such as the time of an event.

    They are the names of verifications, of times from which a condition or free flight holds, and of formulas of which
    a limit or an extreme value is taken.

    Laws for them are not redundant even if the answer is independent of their values: two boards that stick to each
    other move with their common momentum, whatever the friction was, but only after they stick; and free fall changes a
    velocity equally before and after an impact.
    """
    verified = [relation for relation in solution.relations if relation.role in CHECKS]
    checked = {r.left.latex() for r in verified if r.role == "verified"}
    told = (r for step in solution.steps if step.kind == "time" and verified for r in step.relations)
    flown = [relation for step in solution.steps if step.kind == TIME for relation in step.relations]
    times = [relation.left.latex() for relation in (*(r for r in told if r.role == "result"), *flown)]
    times += [name for r in _formulas(solution) for name in r.left.symbols()]
    return times + [name for r in verified for name in r.symbols() if name not in checked]


def _formulas(solution: Solution) -> list[Relation]:
    """Return the equations of which the solution takes a limit or a derivative."""
    steps = (step for step in solution.steps if step.kind in ("limit", "derivative"))
    return [relation for step in steps for relation in step.relations if relation.role == "derived"]


def _elsewhere(solution: Solution) -> dict[str, float]:
    """Return the values of all names for slightly different given numbers, to exclude coincidences."""
    values = dict(solution.values)
    known: set[str] = set()
    for number, relation in enumerate(solution.relations):
        if not isinstance(relation.left, Symbol) or relation.role in CHECKS:  # that may be so here alone
            continue
        name = relation.left.name
        if relation.role in KNOWN:
            values[name] *= 1.0 + AWAY * (1.0 + number % 7) / 7.0
        elif name not in known and all(other in known for other in relation.right.symbols()):
            values[name] = float(relation.right.value(values).real)
        else:
            continue
        known.add(name)
    return values


def _spared(laws: Sequence[Relation], values: dict[str, float], place: dict[str, int], goal: Array) -> bool:
    """Return whether the given laws alone determine the answer, also at another point that satisfies these laws.

    If that law states when something is greatest, the goal is stationary without it: so the solution set is followed
    for a short distance, with Newton's method back onto it, and the test is repeated there.
    """
    matrix = np.array([_row(law, values, place) for law in laws])
    if not len(matrix):
        return True
    sizes = _sizes(values, place)
    _, spread, ways = np.linalg.svd(matrix * sizes)
    free = ways[int((spread > FAINT * spread.max(initial=0.0)).sum()) :]
    way = free.sum(axis=0)
    away = values | {name: values[name] + ASIDE * sizes[k] * float(way[k]) for name, k in place.items()}
    for _ in range(ROUNDS):
        jacobian = np.array([_row(law, away, place, scaled=False) for law in laws]) * sizes
        off = np.array([complex(law.left.value(away) - law.right.value(away)).real for law in laws], dtype=np.float64)
        step: Array = np.asarray(np.linalg.lstsq(jacobian, off, rcond=1e-12)[0], dtype=np.float64) * sizes
        away |= {name: away[name] - float(step[k]) for name, k in place.items()}
    return _spanned([_row(law, away, place) for law in laws], goal)


def _row(relation: Relation, values: dict[str, float], place: dict[str, int], *, scaled: bool = True) -> Array:
    left, right = gradient(relation.left, values, place), gradient(relation.right, values, place)
    row = np.array(left) - np.array(right)
    if scaled:  # by relative changes: what is large and what is small weigh alike
        row = row * _sizes(values, place)
    scale = np.abs(row).max(initial=0.0)
    return row / scale if scaled and scale else row


def _sizes(values: Mapping[str, float], place: Mapping[str, int]) -> Array:
    """Return the magnitudes of the named values, SI units; 1 for values that are zero within rounding errors."""
    return np.array([abs(values[name]) if abs(values[name]) > ROUNDING else 1.0 for name in place])


def _spanned(rows: Sequence[Array], goal: Array) -> bool:
    """Return whether a row of coefficients is a linear combination of others."""
    size = float(np.abs(goal).max(initial=0.0))
    if not rows or not size:
        return not size
    matrix = np.array(rows).T
    weights, *_ = np.linalg.lstsq(matrix, goal, rcond=1e-12)
    return bool(np.abs(matrix @ weights - goal).max() <= FAINT * size)


def by_digits(solution: Solution, digits: int = DIGITS) -> float:
    """Return the answer computed with intermediate results rounded to `digits` digits; NaN if that fails."""
    values: dict[str, float] = {}
    for relation in solution.relations:
        if not isinstance(relation.left, Symbol) or relation.role == "exceeds":
            continue
        name = relation.left.name
        if relation.role == "given":
            values[name] = solution.values[name]
        elif name not in values and all(other in values for other in relation.right.symbols()):
            try:
                values[name] = round_to_digits(float(relation.right.value(values, digits).real), digits)
            except (ValueError, ArithmeticError):  # such as the arccosine of what rounding has made more than 1
                return float("nan")
    found = values.get(solution.goal, float("nan"))
    return solution.in_answer_unit(found)
