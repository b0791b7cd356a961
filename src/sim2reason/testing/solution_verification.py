"""Verification of worked solutions: laws determine the answer, none is redundant, and sums of equations hold.

If all equations of a text hold, so does any sum of them, as in *(1) + 2·(4)*. Therefore unknowns are displaced in all
directions that preserve the equations in no sum: inextensible strings, light pulleys, normal forces.
"""

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from sim2reason.scenes.dsl.state import Array
from sim2reason.solutions.algebra.evaluated import gradient
from sim2reason.solutions.algebra.expressions import Expression, Sum, Symbol
from sim2reason.solutions.algebra.rounded_numbers import DIGITS, round_to_digits
from sim2reason.solutions.checking import recompute
from sim2reason.solutions.data import as_data
from sim2reason.solutions.solution import CHECKS, RELATION_RTOL, Relation, Solution
from sim2reason.solutions.writing.arrangement import TIME

RESIDUAL_RTOL = 1e-8  # relative residual of a combination of laws for a row that follows from them
ROUNDING = 1e-13  # SI units: rounding error of numbers that cancel
ASIDE, ROUNDS = 0.03, 6  # relative displacement of free values; Newton steps back onto the laws
DISPLACEMENT_RATIO = 1e-3  # relative displacement of given values to detect coincidences
ROUNDED_RTOL = 5e-3  # relative error of the answer from numbers rounded to five digits
RTOL_BY_KIND = {"threshold": 1e-7, "optimum": 1e-6, "limit": 1e-7}
"""By kind: an engine holds by friction what pulls by 1e-10 of the loads more than it can; extremes are flat."""
KNOWN_ROLES = ("given",)  # roles of names that no law needs to determine
WORDS = {"easy": 150, "medium": 300, "hard": 600}


def words(text: str) -> int:
    """Return the number of words in a text; a formula counts as one."""
    return len(re.sub(r"\$[^$]*\$", "x", text).split())


def faults(solution: Solution, answer: float, within: float = RELATION_RTOL) -> list[str]:
    """Return all faults of a solution, in words; `answer` is the engine's, in the unit of the question.

    `within` is the engine's relative accuracy, see `RTOL_BY_KIND`, or that of the given result if a number is unknown.
    """
    if solution.answer is None:
        return [f"no answer: {solution.reason}"]
    problems: list[str] = []
    if abs(solution.answer - answer) > within / min(1.0, solution.condition_number or 1.0) * abs(answer):
        problems.append(f"it gives {solution.answer:.12g}, the engine {answer:.12g}")
    problems += [f"does not hold: {r.latex()}" for r in solution.relations if not holds(r, solution.values)]
    problems += [f"recomputed: {fault}" for fault in recompute(as_data(solution)).faults]
    if not solution.derived:  # an integration carries all digits, and states more of its end than is asked for
        return problems
    problems += undetermined(solution)
    carried = by_digits(solution)
    if not abs(carried - answer) <= ROUNDED_RTOL * abs(answer):  # also where it is not a number
        problems.append(f"with {DIGITS} digits it gives {carried:.6g}, not {answer:.6g}")
    return problems


def holds(relation: Relation, values: Mapping[str, float]) -> bool:
    """Return whether an equation holds within rounding, or a comparison is true, for the given values."""
    left, right = relation.left.value(values), relation.right.value(values)
    if relation.role == "exceeds":
        return left.real > right.real
    size = max(_size(relation.left, values), _size(relation.right, values))
    return abs(left - right) <= RELATION_RTOL * size + ROUNDING


def _size(expression: Expression, at: Mapping[str, float]) -> float:
    terms = expression.terms if isinstance(expression, Sum) else (expression,)
    return max((abs(term.value(at)) for term in terms), default=0.0)


def undetermined(solution: Solution) -> list[str]:
    """Return faults in words where the laws do not determine the answer, or one of the laws is redundant.

    Solutions with an integrated phase are not allowed.
    """
    relations = [r for r in solution.relations if r.role not in (*KNOWN_ROLES, *CHECKS)]
    known = {name for r in solution.relations if r.role in KNOWN_ROLES for name in r.left.symbols()}
    names = sorted({name for r in relations for name in r.symbols()} - known)
    index = {name: number for number, name in enumerate(names)}
    values = dict(solution.values)
    goals = [solution.goal]
    if unknown := [name for name in goals if name not in index and name not in known]:
        return [f"no relation speaks of {name}" for name in unknown]
    rows = [_row(r, values, index) for r in relations]
    laws = [number for number, r in enumerate(relations) if r.role == "law"]
    problems: list[str] = []
    law_rows = [rows[number] for number in laws]
    sought = goals, _since_when(solution)
    units, since = ([np.eye(len(names))[index[n]] for n in some if n in index] for some in sought)
    if not all(_spanned(law_rows, unit) for unit in units):
        problems.append("the laws that are told do not determine the answer")
    else:
        there = _elsewhere(solution)
        others = [_row(r, there, index) for r in relations]

        def are_enough(kept: list[int]) -> bool:
            spanned = all(_spanned([e[k] for k in kept], unit) for e in (rows, others) for unit in [*units, *since])
            return spanned and all(_spared([relations[k] for k in kept], values, index, unit) for unit in units)

        idle = [n for n in laws if are_enough([k for k in laws if k != n])] if units else []
        problems += [f"superfluous: {relations[number].latex()}" for number in idle]
    derived = (number for number, relation in enumerate(relations) if relation.role != "law")
    strays = [relations[number].latex() for number in derived if not _spanned(law_rows, rows[number])]
    return problems + [f"does not follow from what is told: {text}" for text in strays]


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
    time_relations = (r for step in solution.steps if step.kind == "time" and verified for r in step.relations)
    flown = [relation for step in solution.steps if step.kind == TIME for relation in step.relations]
    times = [relation.left.latex() for relation in (*(r for r in time_relations if r.role == "result"), *flown)]
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
        if relation.role in KNOWN_ROLES:
            values[name] *= 1.0 + DISPLACEMENT_RATIO * (1.0 + number % 7) / 7.0
        elif name not in known and all(other in known for other in relation.right.symbols()):
            values[name] = float(relation.right.value(values).real)
        else:
            continue
        known.add(name)
    return values


def _spared(laws: Sequence[Relation], values: dict[str, float], index: dict[str, int], goal: Array) -> bool:
    """Return whether the given laws alone determine the answer, also at another point that satisfies these laws.

    If that law states when something is greatest, the goal is stationary without it: so the solution set is followed
    for a short distance, with Newton's method back onto it, and the test is repeated there.
    """
    matrix = np.array([_row(law, values, index) for law in laws])
    if not len(matrix):
        return True
    sizes = _sizes(values, index)
    _, spread, ways = np.linalg.svd(matrix * sizes)
    free = ways[int((spread > RESIDUAL_RTOL * spread.max(initial=0.0)).sum()) :]
    direction = free.sum(axis=0)
    away = values | {name: values[name] + ASIDE * sizes[k] * float(direction[k]) for name, k in index.items()}
    for _ in range(ROUNDS):
        jacobian = np.array([_row(law, away, index, scaled=False) for law in laws]) * sizes
        off = np.array([complex(law.left.value(away) - law.right.value(away)).real for law in laws], dtype=np.float64)
        step: Array = np.asarray(np.linalg.lstsq(jacobian, off, rcond=1e-12)[0], dtype=np.float64) * sizes
        away |= {name: away[name] - float(step[k]) for name, k in index.items()}
    return _spanned([_row(law, away, index) for law in laws], goal)


def _row(relation: Relation, values: dict[str, float], index: dict[str, int], *, scaled: bool = True) -> Array:
    left, right = gradient(relation.left, values, index), gradient(relation.right, values, index)
    row = np.array(left) - np.array(right)
    if scaled:  # by relative changes: what is large and what is small weigh alike
        row = row * _sizes(values, index)
    scale = np.abs(row).max(initial=0.0)
    return row / scale if scaled and scale else row


def _sizes(values: Mapping[str, float], index: Mapping[str, int]) -> Array:
    """Return the magnitudes of the named values, SI units; 1 for values that are zero within rounding errors."""
    return np.array([abs(values[name]) if abs(values[name]) > ROUNDING else 1.0 for name in index])


def _spanned(rows: Sequence[Array], goal: Array) -> bool:
    """Return whether a row of coefficients is a linear combination of others."""
    size = float(np.abs(goal).max(initial=0.0))
    if not rows or not size:
        return not size
    matrix = np.array(rows).T
    weights, *_ = np.linalg.lstsq(matrix, goal, rcond=1e-12)
    return bool(np.abs(matrix @ weights - goal).max() <= RESIDUAL_RTOL * size)


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
    answer = values.get(solution.goal, float("nan"))
    return solution.in_answer_unit(answer)


TERM = r"(?:(?:\$[^$]*\$|[^\s$()·]+)·)?\(\w+\)"
SUBSTITUTION_PATTERN = r"(?:, with [^:$]*)?"  # names the equations that were substituted
SUM = re.compile(
    rf"(?<!\S)(?P<sum>[-−]?{TERM}(?: [+−-] {TERM})+){SUBSTITUTION_PATTERN}: (?:\(\w+\) )?\$(?P<out>[^$]*=[^$]*)\$"
)
PART = re.compile(r"(?P<sign>[+−-]?) ?(?:(?P<weight>\$[^$]*\$|[^\s$()·]+)·)?\((?P<label>\w+)\)")
LABEL = re.compile(r"(?<!\S)\((?P<label>\w+)\) (?:[^$().]*: )?\$(?P<formula>[^$]*=[^$]*)\$")
LIGHT = "is light"  # marks a balance of forces without acceleration
STEP, LOOSE = 1e-6, 3e-4  # relative: step of a derivative; error of a coefficient from five digits

Excess = Callable[[Mapping[str, float]], float | None]


@dataclass(frozen=True, slots=True)
class LabelSum:
    """A stated sum of labelled equations, as *(1) + 2·(4)*, with its result; equations as left minus right side."""

    text: str
    out: Excess
    parts: tuple[tuple[Excess, Excess], ...]  # weights, which may hold symbols, and equations
    equations: tuple[Excess, ...]  # what goes on holding
    changed: tuple[str, ...]

    def holds(self, values: Mapping[str, float]) -> bool:
        """Return whether the sum of the equations and its stated result depend equally on all unknowns."""
        names = [name for name in self.changed if name in values]
        rows = [row for excess in self.equations if (row := _gradient(excess, values, names)) is not None and row.any()]
        free = _free(rows, len(names))
        out = _gradient(self.out, values, names)
        terms = [_gradient(excess, values, names) for _, excess in self.parts]
        if out is None or any(term is None for term in terms):
            return True
        weights = [weight(values) for weight, _ in self.parts]
        if any(weight is None for weight in weights):
            return False
        pairs = zip(weights, terms, strict=True)
        known = [weight * term for weight, term in pairs if weight is not None and term is not None]
        off = (np.sum(known, axis=0) - out) @ free
        size = max(float(np.abs(row).max(initial=0.0)) for row in (*known, out))
        return bool(np.abs(off).max(initial=0.0) <= LOOSE * size)


def label_sums(
    text: str, read: Callable[[str], Excess | None], givens: Sequence[str], names: Sequence[str]
) -> list[LabelSum]:
    """Return all sums of equations in a text; `read` parses an equation as a function of its symbols."""
    labelled = {match["label"]: match["formula"] for match in LABEL.finditer(text)}
    sums = list(SUM.finditer(text))
    light_formulas = [match["formula"] for match in LABEL.finditer(text) if LIGHT in match[0]]
    outs = {match["out"] for match in sums}
    rows = {*labelled.values(), *outs}
    moved = tuple(name for name in names if name not in givens)
    parsed_sums: list[LabelSum] = []
    for match in sums:
        plain = re.findall(r"\$([^$]*=[^$]*)\$", text[: match.start()])  # what follows is free to move with it
        formulas = [
            f.rpartition("=")[0] if f.count("=") == 2 and _number(f) else f for f in plain
        ]  # a law and its result
        laws = [f for f in formulas if f not in rows and f.count("=") == 1 and not _number(f)]
        constraints = tuple(
            excess for formula in dict.fromkeys((*light_formulas, *laws)) if (excess := read(formula)) is not None
        )
        out = read(match["out"])
        parts = [_part(part, labelled, read) for part in PART.finditer(match["sum"])]
        if out is not None and all(part is not None for part in parts):
            kept = tuple(part for part in parts if part is not None)
            parsed_sums.append(LabelSum(match[0], out, kept, constraints, moved))
    return parsed_sums


def _number(formula: str) -> bool:
    """Return whether a formula assigns a number to a symbol: a result, not a law."""
    last = formula.rpartition("=")[2].strip()
    return re.fullmatch(r"-?[\d.]+(?: \\times 10\^\{-?\d+\})?(?:\\ \\text.*|\^\\circ)?", last) is not None


def _part(
    part: re.Match[str], labelled: Mapping[str, str], read: Callable[[str], Excess | None]
) -> tuple[Excess, Excess] | None:
    sign = 1.0 if part["sign"] in ("", "+") else -1.0
    formula = labelled.get(part["label"])
    excess = read(formula) if formula is not None else None
    weight = read(f"{part['weight'].strip('$')} = 0") if part["weight"] else None
    if excess is None or (part["weight"] and weight is None):
        return None

    def signed(values: Mapping[str, float]) -> float | None:
        size = weight(values) if weight is not None else 1.0
        return None if size is None else sign * size

    return signed, excess


def _gradient(excess: Excess, values: Mapping[str, float], names: Sequence[str]) -> Array | None:
    here, derivatives = excess(values), list[float]()
    for name in names:
        step = STEP * max(1.0, abs(values[name]))
        there = excess({**values, name: values[name] + step})
        if here is None or there is None:
            return None
        derivatives.append((there - here) / step)
    return np.array(derivatives)


def _free(rows: Sequence[Array], size: int) -> Array:
    """Return the directions in the space of the unknowns, as columns, along which all rows of gradients are zero."""
    if not rows:
        return np.eye(size)
    _, spread, ways = np.linalg.svd(np.array([row / np.abs(row).max() for row in rows]))
    rank = int((spread > LOOSE * spread.max(initial=0.0)).sum())
    return ways[rank:].T
