"""Checks that strings stay taut, balances of light pulleys, and the choice of laws for an answer."""

from collections.abc import Collection, Mapping, Sequence
from collections.abc import Set as AbstractSet

import numpy as np
from numpy.typing import NDArray

from sim2reason.solutions.algebra.elimination import Equation, solve_linear
from sim2reason.solutions.algebra.expressions import ZERO, Symbol
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial
from sim2reason.solutions.laws.dynamics import Dynamics
from sim2reason.solutions.laws.newton import Row
from sim2reason.solutions.setting import capitalized, join_words
from sim2reason.solutions.solution import Relation, Step
from sim2reason.solutions.writing.notation import NEWTONS
from sim2reason.solutions.writing.steps import StepBuilder, UnsolvedError

DOUBLE_RATIO = 2.0


def balanced_tensions(
    light: Sequence[Equation], known: Collection[str], unknown: AbstractSet[str], goals: Collection[str]
) -> tuple[dict[str, Polynomial], dict[str, frozenset[str]]]:
    """Return tensions in terms of others by the balance of light pulleys, and the labels of these balances.

    `goals` are eliminated last. UnsolvedError if a balance has a varying ratio.
    """
    tensions: dict[str, Polynomial] = {}
    labels: dict[str, frozenset[str]] = {}
    for equation in light:
        used = {name for name in equation.zero.names() if name in tensions}
        zero = equation.forces.substitute(tensions)
        names = [n for n in sorted(zero.names() & unknown) if n not in known]
        name = min(names, key=lambda n: (n in goals, abs(zero.coefficient(n).number or 0.0) != 1.0, n))
        before = zero.coefficient(name).number
        if not before:
            raise UnsolvedError("a light pulley balances at a ratio that changes")
        tensions[name] = zero.terms_without((name,)).scale(-1.0 / before)
        labels[name] = frozenset({equation.label}).union(*(labels[n] for n in used))
        labels |= {n: labels[n] | labels[name] for n, tension in tensions.items() if name in tension.names()}
        tensions = {n: p.substitute({name: tensions[name]}) for n, p in tensions.items()}
    return tensions, labels


def doubling_reason(dynamics: Dynamics, row: Row) -> str:
    """Return a clause with the reason why a pulley's acceleration has the factor 2 in a law; "" if none has."""
    indices = [int(name[1:]) for name in row.inertia.names() if name[1:].isdigit()]
    twice = [k for k in indices if abs(row.inertia.coefficient(f"q{k}").number or 0.0) == DOUBLE_RATIO]
    bodies = [dynamics.mechanism.coordinates[k].body for k in sorted(twice)]
    pulleys = [body for body in bodies if body in dynamics.setting.pulleys]
    if not pulleys:
        return ""
    return f", and moving {dynamics.setting.bodies_phrase(pulleys)} changes the two parts beside it equally"


WEIGHT_RTOL = 1e-9  # relative to the largest weight: laws with smaller weights are not needed


def needed_laws(
    rows: Sequence[Row], unknowns: Sequence[str], values: Mapping[str, float], goals: Sequence[str]
) -> list[Row]:
    """Return the laws that determine the goals, in order; UnsolvedError if all laws together do not.

    If the laws are independent, the weights of their sum for a goal are unique, and laws of weight 0 are omitted. If
    they are not (two friction forces of which only the sum is determined), laws are omitted one by one.
    """
    matrix = np.array([[row.zero.coefficient(name).value(values) for name in unknowns] for row in rows])
    matrix = matrix.reshape(len(rows), len(unknowns))
    kept: set[int] = set()
    for goal in goals:
        target = np.array([1.0 if name == goal else 0.0 for name in unknowns])
        kept |= _taking_part(matrix, target, goal)
    return [row for number, row in enumerate(rows) if number in kept]


def _taking_part(matrix: NDArray[np.float64], target: NDArray[np.float64], goal: str) -> set[int]:
    """Return the indices of the laws that determine one goal."""
    everything = list(range(len(matrix)))
    weights = _weights(matrix, target)
    if weights is None:
        raise UnsolvedError(f"the laws do not determine {goal}")
    if np.linalg.matrix_rank(matrix) == len(matrix):
        return {n for n in everything if abs(weights[n]) > WEIGHT_RTOL * np.abs(weights).max()}
    kept = everything
    for number in everything:
        fewer = [n for n in kept if n != number]
        if fewer and _weights(matrix[fewer], target) is not None:
            kept = fewer
    return set(kept)


def _weights(matrix: NDArray[np.float64], target: NDArray[np.float64]) -> NDArray[np.float64] | None:
    """Return weights of laws, the rows of a matrix, whose weighted sum has the target coefficients; else None."""
    if not len(matrix):
        return None
    weights = np.asarray(np.linalg.lstsq(matrix.T, target, rcond=1e-12)[0], dtype=np.float64)
    return weights if np.abs(matrix.T @ weights - target).max() <= 1e-8 else None


TAUT = "tension check"  # kind of these steps


def verify_taut(dynamics: Dynamics, rows: Sequence[Row]) -> None:
    """Schedule the check that strings stay taut whose tensions the solution does not compute otherwise.

    `rows` are the laws. No other step depends on the check; in symbolic problems the text states it.
    """
    book = dynamics.book
    if dynamics.taut and not dynamics.measure.values and not book.in_symbols:
        phase = book.phase
        book.checks.setdefault(dynamics, lambda: _write_taut_check(dynamics, rows, phase))


def after_what_they_rest_on(steps: Sequence[Step], late: AbstractSet[str]) -> list[Step]:
    """Move checks that strings are taut directly behind the steps they depend on, except checks with `late` symbols."""
    ordered = [step for step in steps if step.kind != TAUT or not late.isdisjoint(step.symbols())]
    for step in (step for step in steps if step.kind == TAUT and step not in ordered):
        ordered.insert(
            max((n for n, earlier in enumerate(ordered) if earlier.id in step.needs), default=len(ordered) - 1) + 1,
            step,
        )
    return ordered


def _write_taut_check(dynamics: Dynamics, rows: Sequence[Row], phase: int) -> None:
    """Write the check that strings stay taut."""
    book, rows = dynamics.book, _with_weights(dynamics, rows)
    now, book.phase = book.phase, phase
    step, tensions = book.begin_step(TAUT), list[tuple[int, str]]()
    waiting, symbols = [n for n in dynamics.taut if not _is_told(dynamics, n)], dict(dynamics.names)
    while (ready := _ready(dynamics, rows, waiting, symbols)) is not None:
        index, law = ready
        waiting.remove(index)
        new = _positive(dynamics, step, index, law, symbols)
        if not new:
            break
        tensions += new
    if len(tensions) == 1:
        ((index, formula),) = tensions
        alone = len(dynamics.newton.lines) == 1 and f"T{index}" in dynamics.names
        who, what = ("The string", "") if alone else (capitalized(_line(dynamics, index)), "its tension ")
        step.add_text(f"{who} stays taut, as {what}{formula} is positive.")
    elif tensions:
        named = [
            formula if f"T{index}" in dynamics.names else f"the tension {formula} in {_line(dynamics, index)}"
            for index, formula in tensions
        ]
        every = "The" if len(tensions) == len(dynamics.taut) else "These"
        step.add_text(f"{every} strings stay taut, as {join_words(named)} are positive.")
    step.close()
    book.phase = now


def _line(dynamics: Dynamics, index: int) -> str:
    """Return the name of a string."""
    return dynamics.setting.string_phrases[dynamics.newton.lines[index].name]


def _positive(
    dynamics: Dynamics, step: StepBuilder, index: int, law: Polynomial, symbols: dict[str, Polynomial]
) -> list[tuple[int, str]]:
    """Record that a tension is positive; return a list with index and equation, empty if the tension is zero."""
    own = next(iter(symbols[f"T{index}"].names())) if f"T{index}" in symbols else f"T{index}"
    formula, book = solve_linear(law, own), dynamics.book
    line = dynamics.newton.lines[index]
    bodies = [dynamics.mechanism.site[site].body or "" for site in (line.through[0], line.through[-1])]
    symbol = (
        Symbol(own) if f"T{index}" in symbols else book.fresh("T", "".join(map(dynamics.setting.subscript_of, bodies)))
    )
    symbols[f"T{index}"] = Polynomial.from_expression(symbol)
    equation = step.verified(symbol, formula, NEWTONS)
    if book.observed[symbol.name] <= 0.0:
        step.relations.pop()
        return []
    step.relations.append(Relation(symbol, ZERO, "exceeds"))
    return [(index, equation)]


def _ready(
    dynamics: Dynamics, rows: Sequence[Row], waiting: Sequence[int], symbols: Mapping[str, Polynomial]
) -> tuple[int, Polynomial] | None:
    """Return a string's index and the shortest law with only its tension unknown; None if there is none."""
    known = dynamics.book.values.keys() | {
        name for n in dynamics.taut if n not in waiting for name in symbols.get(f"T{n}", NIL).names()
    }
    candidates: list[tuple[int, Polynomial]] = []
    for index in waiting:
        name = next(iter(symbols[f"T{index}"].names())) if f"T{index}" in symbols else f"T{index}"
        for row in rows:
            if f"T{index}" in row.zero.names():
                law = row.zero.substitute(symbols).substitute(dynamics.bound)
                if name in law.names() and law.names() - {name} <= known:
                    candidates.append((index, law))
    return min(candidates, key=lambda pair: len(pair[1].terms), default=None)


def _is_told(dynamics: Dynamics, index: int) -> bool:
    """Return whether the solution already computes the tension of a string."""
    named = dynamics.names.get(f"T{index}")
    return named is not None and named.names() <= dynamics.book.values.keys()


def _with_weights(dynamics: Dynamics, rows: Sequence[Row]) -> list[Row]:
    """Return all laws except those of normal forces, with normal forces due to weights alone substituted."""
    pressed: dict[str, Polynomial] = {}
    for row in rows:
        name = f"N{row.number}"
        if row.kind == "normal" and not row.inertia.substitute(dynamics.names):
            pressed[name] = row.forces.terms_without((name,)).scale(-1.0)
    return [Row(r.kind, r.number, r.forces.substitute(pressed), r.inertia) for r in rows if r.kind != "normal"]
