"""Unknowns found by trial: the value close to the stated one with which a given result comes out."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

from sim2reason.solutions.checking.bracket import zero
from sim2reason.solutions.checking.recomputed import Recomputed
from sim2reason.solutions.checking.trees import ROUGH, TreeError

FOUND = 1e-13  # relative: how well the unknown is found
FULFILLED = 1e-9  # relative: how well the result then comes out, which excludes that it jumps there
TRIAL, CONDITION = "trial", "condition"  # roles of relations

Reader = Callable[[Mapping[str, Any]], Recomputed]


def sought(data: Mapping[str, Any]) -> tuple[str, float] | None:
    """Return the unknown that a solution finds by trial, with its stated value; None if there is none.

    Raises:
        TreeError: there are several.
    """
    found = _of_role(data, TRIAL)
    if len(found) > 1:
        raise TreeError("several unknowns are found by trial")
    return found[0] if found else None


def _of_role(data: Mapping[str, Any], role: str) -> list[tuple[str, float]]:
    relations = [held for step in data["steps"] for held in step["relations"] if held["role"] == role]
    return [(str(held["left"]), float(held["right"])) for held in relations]


def by_trial(data: Mapping[str, Any], unknown: tuple[str, float], read: Reader) -> Recomputed:
    """Recompute a solution that finds an unknown by trial.

    `read` recomputes the result that is given from data in which the unknown is a given.

    Raises:
        TreeError: no result is given, or none that comes out for a value close to the stated one.
    """
    (name, near), conditions = unknown, _of_role(data, CONDITION)
    if len(conditions) != 1:
        raise TreeError("no single result is given that would determine the unknown")
    result, value = conditions[0]

    def excess(at: float) -> float:
        found = read(_with(data, name, at, result))
        if result not in found.values:
            raise TreeError(next(iter(found.faults), f"{result} has no value"))
        return found.values[result] - value

    ends = near * (1.0 - 1.01 * ROUGH), near * (1.0 + 1.01 * ROUGH)
    failed = f"no value of {name} near {near:.6g} leads to {result} = {value:.6g}"
    if (excess(ends[0]) > 0.0) == (excess(ends[1]) > 0.0):
        raise TreeError(failed)
    found = zero(excess, *ends, within=FOUND)
    reached = read(_with(data, name, found, result))
    if abs(reached.values[result] - value) > FULFILLED * abs(value):
        raise TreeError(failed)
    goal = str(data["goal"])
    if goal not in reached.values:
        raise TreeError(f"no relation speaks of {goal}")
    return replace(reached, answer=reached.values[goal] * float(data["scale"]))


def _with(data: Mapping[str, Any], name: str, value: float, goal: str) -> dict[str, Any]:
    """Return the data of the forward problem: the unknown is a given, and the result is the goal."""
    steps = [
        {**step, "relations": [held for held in step["relations"] if held["role"] not in (TRIAL, CONDITION)]}
        for step in data["steps"]
    ]
    return {
        **data,
        "steps": steps,
        "givens": {**data["givens"], name: value},
        "goal": goal,
        "scale": 1.0,
        "whole": False,
    }
