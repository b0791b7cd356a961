"""Phases of constant acceleration without the laws and values on which nothing later rests."""

from collections.abc import Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import replace

import numpy as np

from sim2reason.dsl.state import Array
from sim2reason.solutions.algebra.expressions import Number, Symbol
from sim2reason.solutions.setting import joined
from sim2reason.solutions.solution import Relation, Step, with_unit
from sim2reason.solutions.writing.subscripts import split

LAWS, STATE = "steady laws", "steady state"  # the kinds of steps of which parts may be left out
HELD = 1e-9  # of the largest weight: rounding


def laws_text(relations: Sequence[Relation], values: Mapping[str, float]) -> str:
    """Return the sentences about laws, and what they lead to where they do not give it by themselves."""
    laws = [relation for relation in relations if relation.role == "law"]
    found = [r for r in relations if r.role != "law" and values[_name(r)]]
    turns = any(split(name)[0] == r"\alpha" for law in laws for name in law.symbols())
    by = "By Newton's second law and the law of torques" if turns else "By Newton's second law"
    text = f"{by}, the accelerations are constant: {joined([law.latex() for law in laws])}."
    if not found or all(isinstance(law.left, Symbol) for law in laws):
        return text
    return f"{text} Hence {joined([_told(r, values[_name(r)]) for r in found])}."


def _told(found: Relation, value: float) -> str:
    """Return a name with its number, and with the formula that it has."""
    if isinstance(found.right, Number):
        return f"${_name(found)} = {with_unit(value, found.unit)}$"
    return found.latex(value)


def state_text(relations: Sequence[Relation], values: Mapping[str, float]) -> str:
    """Return the sentence about the state at the end of a phase."""
    if not relations:
        return ""
    return f"At that instant, {joined([relation.latex(values[_name(relation)]) for relation in relations])}."


def pruned(steps: Sequence[Step], goal: str, values: Mapping[str, float]) -> list[Step]:
    """Return the steps without what the goal does not rest on; their numbers stay."""
    used, found = {goal}, list[Step]()
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
        found.append(kept)
    return found[::-1]


def _with_needed_laws(step: Step, used: AbstractSet[str], values: Mapping[str, float]) -> Step:
    """Return a step with the laws that determine what is used, and no others."""
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
    told = [r for r in step.relations if r.role != "law" and _name(r) in used]
    relations = (*own, *told)
    text = laws_text(relations, values) if own else ""
    return replace(step, relations=relations, gives=tuple(n for n in step.gives if n in named), text=text)


def _coefficients(laws: Sequence[Relation], unknowns: Sequence[str], values: Mapping[str, float]) -> Array:
    """Return what stands before each unknown in each law, (laws, unknowns); laws are linear in them."""

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
    return bool(np.abs(matrix.T @ weights - targets.T).max() <= HELD)


def _name(relation: Relation) -> str:
    return relation.left.name if isinstance(relation.left, Symbol) else ""
