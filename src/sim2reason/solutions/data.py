"""Conversion of a worked solution to JSON values, from which its answer can be recomputed."""

from collections.abc import Mapping
from typing import Any

from sim2reason.solutions.algebra.expressions import Number, Symbol
from sim2reason.solutions.algebra.trees import tree
from sim2reason.solutions.solution import Integration, Relation, Solution, Step, with_unit

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
    found = {name: values[name] for name in step.gives if name in units and name in values}
    return {name: value for name, value in found.items() if f"= {with_unit(value, units[name])}" in step.text}


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


def _integration(held: Integration) -> Data:
    coordinates = [
        {
            "place": c.place,
            "rate": c.rate,
            "acceleration": c.acceleration,
            "initial_place": tree(c.initial_place),
            "initial_rate": tree(c.initial_rate),
        }
        for c in held.coordinates
    ]
    until = held.until
    return {
        "time": held.time,
        "begin": tree(held.begin),
        "coordinates": coordinates,
        "unknowns": list(held.unknowns),
        "equations": [_relation(relation) for relation in held.equations],
        "until": {
            "expression": tree(until.expression),
            "direction": until.direction,
            "occurrence": until.occurrence,
        },
        "ends": [list(pair) for pair in held.ends],
        "accumulated": [
            {"name": held.name, "rate": tree(held.rate), "initial": tree(held.initial)} for held in held.accumulated
        ],
    }
