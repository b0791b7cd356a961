"""Conversion of a worked solution to JSON values, with formulas as prefix trees that allow its recomputation."""

from collections.abc import Mapping
from functools import singledispatch
from typing import Any, TypeAlias

from sim2reason.solutions.algebra.evaluated import (
    Amplitude,
    Chain,
    CompleteElliptic,
    IncompleteElliptic,
    NumericFormula,
    NumericRoot,
)
from sim2reason.solutions.algebra.expressions import Expression, Number, Product, Quotient, Sum, Symbol
from sim2reason.solutions.algebra.functions import Absolute, Call, Pi, Power, Root
from sim2reason.solutions.algebra.rounded_numbers import round_to_digits
from sim2reason.solutions.solution import Integration, Relation, Solution, Step, with_unit

Tree: TypeAlias = float | str | list["Tree"]


@singledispatch
def tree(held: Expression) -> Tree:
    """Convert a formula to a prefix tree; TypeError for a class without a tree."""
    raise TypeError(f"{type(held).__name__} has no tree; register one in {__name__}")


@tree.register
def _(held: Number) -> Tree:
    return float(held.x)


@tree.register
def _(held: Symbol) -> Tree:
    return held.name


@tree.register
def _(held: Sum) -> Tree:
    return ["+", *map(tree, held.terms)]


@tree.register
def _(held: Product) -> Tree:
    return ["*", *map(tree, held.factors)]


@tree.register
def _(held: Quotient) -> Tree:
    return ["/", tree(held.above), tree(held.below)]


@tree.register
def _(held: Power) -> Tree:
    return ["^", tree(held.base), float(held.exponent)]


@tree.register
def _(held: Root) -> Tree:
    return ["sqrt", tree(held.inside)]


@tree.register
def _(held: Absolute) -> Tree:
    return ["abs", tree(held.inside)]


@tree.register
def _(held: Call) -> Tree:
    return [held.function, tree(held.argument)]


@tree.register
def _(held: Pi) -> Tree:
    del held
    return ["pi"]


@tree.register
def _(held: CompleteElliptic) -> Tree:
    return ["elliptic K", tree(held.modulus)]


@tree.register
def _(held: IncompleteElliptic) -> Tree:
    return ["elliptic F", tree(held.argument), tree(held.modulus)]


@tree.register
def _(held: Amplitude) -> Tree:
    return ["amplitude", tree(held.argument), tree(held.modulus)]


@tree.register
def _(held: NumericFormula) -> Tree:
    """Return the tree of a formula together with the rounded number in the text, so that both can be compared."""
    return ["worked", tree(held.inner), float(held.comes_to)]


@tree.register
def _(held: NumericRoot) -> Tree:
    """Return the tree of a numerical root: its equation and its value, rounded as in the text.

    For a chain of formulas in earlier relations, those relations are the equation.
    """
    near = round_to_digits(held.near)
    return ["solve", near] if _has_chain(held.residual) else ["root", held.name, tree(held.residual), near]


def _has_chain(expression: Expression) -> bool:
    """Return whether a formula contains a chain."""
    return isinstance(expression, Chain) or any(map(_has_chain, expression.parts))


Data = dict[str, Any]


def as_data(solution: Solution) -> Data:
    """Convert a solution with an answer to JSON values, from which the answer can be recomputed.

    `givens` are numbers by symbol; each step has its relations, whose sides are prefix trees as in
    `sim2reason.solutions.checking`, the `results` whose numbers its text states, by symbol in SI units, and the
    `integration` of a phase or None; `scale` is the value of the answer where that of the goal is 1; `whole` says that
    the answer is a count.
    """
    givens = {
        relation.left.name: float(relation.right.x)
        for relation in solution.relations
        if relation.role == "given" and isinstance(relation.left, Symbol) and isinstance(relation.right, Number)
    }
    return {
        "strategy": solution.strategy,
        "givens": givens,
        "phases": [{"begins": phase.begins, "ends": phase.ends} for phase in solution.phases],
        "steps": [_step(step, solution.values) for step in solution.steps],
        "goal": solution.goal,
        "unit": solution.unit,
        "scale": float(solution.in_answer_unit(1.0)),
        "whole": solution.whole,
        "formula": solution.formula,
        "answer": solution.answer,
    }


def _results(step: Step, values: Mapping[str, float]) -> dict[str, float]:
    """Return the values, in SI units by symbol, of the results whose numbers the text of a step contains."""
    units = {r.left.name: r.unit for r in step.relations if isinstance(r.left, Symbol)}
    results = {name: values[name] for name in step.gives if name in units and name in values}
    return {name: value for name, value in results.items() if f"= {with_unit(value, units[name])}" in step.text}


def _step(step: Step, values: Mapping[str, float]) -> Data:
    return {
        "id": step.id,
        "kind": step.kind,
        "phase": step.phase,
        "text": step.text,
        "relations": [_relation(relation) for relation in step.relations if relation.role != "given"],
        "gives": list(step.gives),
        "needs": list(step.needs),
        "results": _results(step, values),
        "integration": None if step.integration is None else _integration(step.integration),
    }


def _relation(relation: Relation) -> Data:
    return {"role": relation.role, "left": tree(relation.left), "right": tree(relation.right), "unit": relation.unit}


def _integration(integration: Integration) -> Data:
    coordinates = [
        {
            "place": c.place,
            "rate": c.rate,
            "acceleration": c.acceleration,
            "initial_place": tree(c.initial_place),
            "initial_rate": tree(c.initial_rate),
        }
        for c in integration.coordinates
    ]
    until = integration.until
    return {
        "time": integration.time,
        "begin": tree(integration.begin),
        "coordinates": coordinates,
        "unknowns": list(integration.unknowns),
        "equations": [_relation(relation) for relation in integration.equations],
        "until": {
            "expression": tree(until.expression),
            "direction": until.direction,
            "occurrence": until.occurrence,
        },
        "ends": [list(pair) for pair in integration.ends],
        "accumulated": [
            {"name": integration.name, "rate": tree(integration.rate), "initial": tree(integration.initial)}
            for integration in integration.accumulated
        ],
    }
