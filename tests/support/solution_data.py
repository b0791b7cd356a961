"""Data of worked solutions written by hand: steps with relations and with integrated phases."""

from collections.abc import Mapping, Sequence
from typing import Any

from sim2reason.solutions.checking.trees import Tree

Data = dict[str, Any]


def relation(left: Tree, right: Tree, role: str = "law") -> Data:
    return {"role": role, "left": left, "right": right, "unit": ""}


def step(*relations: Data, integration: Data | None = None, phase: int = 0) -> Data:
    return {
        "id": 0,
        "kind": "",
        "phase": phase,
        "text": "",
        "relations": list(relations),
        "gives": [],
        "needs": [],
        "integration": integration,
    }


def solution(givens: Mapping[str, float], goal: str, *steps: Data, scale: float = 1.0, whole: bool = False) -> Data:
    return {
        "strategy": "by hand",
        "givens": dict(givens),
        "phases": [],
        "steps": list(steps),
        "goal": goal,
        "unit": "",
        "scale": scale,
        "whole": whole,
        "formula": "",
        "answer": None,
    }


def coordinate(place: str, rate: str, acceleration: str, initial_place: Tree, initial_rate: Tree) -> Data:
    return {
        "place": place,
        "rate": rate,
        "acceleration": acceleration,
        "initial_place": initial_place,
        "initial_rate": initial_rate,
    }


def phase(
    coordinates: Sequence[Data],
    equations: Sequence[Data],
    until: Tree,
    ends: Mapping[str, str],
    *,
    direction: int = 0,
    occurrence: int = 1,
    begin: Tree = 0.0,
    unknowns: Sequence[str] = (),
    accumulated: Sequence[Data] = (),
) -> Data:
    return {
        "time": "\\tau",
        "begin": begin,
        "coordinates": list(coordinates),
        "unknowns": list(unknowns),
        "equations": list(equations),
        "until": {"expression": until, "direction": direction, "occurrence": occurrence},
        "ends": [list(pair) for pair in ends.items()],
        "accumulated": list(accumulated),
    }
