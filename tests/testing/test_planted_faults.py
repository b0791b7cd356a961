"""Tests that faults planted in the data of solutions change them and are rejected."""

import random
from collections import Counter
from math import sqrt

import pytest

from plain_scenes import atwood
from sim2reason.solutions import solve
from sim2reason.solutions.checking import recompute
from sim2reason.solutions.data import as_data
from sim2reason.solutions.solution import ANSWER_RTOL
from sim2reason.solutions.verification import verification_fault
from sim2reason.testing.planted_faults import INVENTED, KINDS, Data, planted_faults
from solution_data import coordinate, phase, relation, solution, step
from worked import asked


def twice_thrown() -> Data:
    """Return the data of a ball that falls by h and rebounds to e² h, in the time √(2 h/g) (1 + e)."""
    falling = relation("a", ["+", 0.0, ["*", -1.0, "g"]])
    fall = phase([coordinate("y", "v", "a", "h", 0.0)], [falling], "y", {"\\tau": "t_1", "v": "u"}, direction=-1)
    rise = phase([coordinate("y", "v", "a", 0.0, "w")], [falling], "v", {"\\tau": "t_2", "y": "H"}, begin="t_1")
    both = step(relation("X", ["*", "t_2", "H"]), relation("h", "H", "exceeds"))
    rebound = step(relation("w", ["*", -1.0, "e", "u"])) | {"kind": "rebound"}
    return solution(
        {"h": 1.5, "g": 9.8, "e": 0.8}, "X", step(integration=fall), rebound, step(integration=rise, phase=1), both
    )


@pytest.mark.parametrize("seed", range(3))
def test_each_kind_is_refused_in_phases(seed: int) -> None:
    data = twice_thrown()
    right = recompute(data)
    assert not right.faults
    assert right.answer == pytest.approx(sqrt(2.0 * 1.5 / 9.8) * 1.8 * 0.64 * 1.5, rel=1e-12)
    count = Counter[str]()
    for kind, spoiled in planted_faults(data, right.values, random.Random(seed), 5):
        count[kind] += 1
        assert spoiled != data
        if kind == INVENTED:  # from which the answer does follow
            assert len(spoiled["givens"].keys() - data["givens"].keys()) == 1
        else:
            assert not recompute(spoiled).agrees(right.answer, ANSWER_RTOL), (kind, spoiled)
    assert count.keys() == KINDS.keys()
    assert data == twice_thrown()


def test_each_fault_in_an_elimination_is_refused() -> None:
    setting = asked(atwood(), "What is the tension in the string just after release?")
    data = as_data(solve(setting))
    assert not verification_fault(data, setting)
    count = Counter[str]()
    for kind, spoiled in planted_faults(data, recompute(data).values, random.Random(0), 1000):
        count[kind] += 1
        assert verification_fault(spoiled, setting), (kind, spoiled)
    assert count["a law dropped"] >= 2
    assert count["a given left out"] >= 3
    assert count[INVENTED] >= 2  # the tension, and the acceleration on the way to it
    assert min(count["a sign turned"], count["a number changed"]) >= 5


def test_what_has_no_effect_is_not_planted() -> None:
    """A zero term may have either sign, nothing depends on i and j, and a repeated law is dropped twice."""
    law = relation("x", ["+", "y", ["*", "z", "y"]])
    idle = relation("i", ["*", 2.0, "x"]), relation("j", ["+", "i", 1.0])
    data = solution({"y": 2.0, "z": 0.0}, "x", step(law), step(law), step(*idle))
    found = [*planted_faults(data, recompute(data).values, random.Random(0), 100)]
    assert [kind for kind, _ in found].count("a sign turned") == 2  # that of the first term, in both
    dropped = [spoiled for kind, spoiled in found if kind == "a law dropped"]
    assert dropped
    assert all(not step["relations"] for spoiled in dropped for step in spoiled["steps"][:2])
    assert all([*idle] == spoiled["steps"][2]["relations"] for _, spoiled in found)
