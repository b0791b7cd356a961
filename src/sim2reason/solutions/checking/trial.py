"""Unknowns found by trial: the value with which a given result comes out, found afresh by the secant method."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

from sim2reason.solutions.checking.recomputed import Recomputed

APART = 1e-3, -1e-3  # relative: the values from which the search starts, on both sides of the stated one
ROUNDS = 25  # of the secant method
CLOSE = 1e-11  # relative: how little the unknown changes in the last round
TRIAL, CONDITION = "trial", "condition"  # roles of relations

Reader = Callable[[Mapping[str, Any]], Recomputed]


def sought(data: Mapping[str, Any]) -> tuple[str, float] | None:
    """Return the unknown that a solution finds by trial, with its stated value; None if there is none."""
    found = [held for step in data["steps"] for held in step["relations"] if held["role"] == TRIAL]
    return (str(found[0]["left"]), float(found[0]["right"])) if len(found) == 1 else None


def by_trial(data: Mapping[str, Any], unknown: tuple[str, float], read: Reader) -> Recomputed:
    """Recompute a solution that finds an unknown by trial, from values of the unknown near the stated one.

    `read` recomputes the result that is given from data in which the unknown is a given.
    """
    name, near = unknown
    conditions = [held for step in data["steps"] for held in step["relations"] if held["role"] == CONDITION]
    if len(conditions) != 1:
        return Recomputed(None, ("no single result is given that would determine the unknown",))
    result, value = str(conditions[0]["left"]), float(conditions[0]["right"])

    def excess(at: float) -> tuple[float, Recomputed]:
        found = read(_with(data, name, at, result))
        reached = found.values.get(result)
        return (reached - value if reached is not None else float("nan")), found

    one, other = (near * (1.0 + part) for part in APART)
    before, here = excess(one)[0], excess(other)
    for _ in range(ROUNDS):
        if not here[0] - before:
            break
        one, other, before = other, other - here[0] * (other - one) / (here[0] - before), here[0]
        here = excess(other)
        if not abs(other - one) > CLOSE * abs(other):
            break
    if not abs(other - one) <= CLOSE * abs(other):
        return Recomputed(None, ("the search for the unknown does not converge", *here[1].faults))
    values = {**here[1].values, name: other}
    return replace(here[1], answer=other * float(data["scale"]), values=values)


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
