"""Tests of solutions of problems with several parts: consistent symbols, and no repeated derivation."""

from collections import Counter
from functools import cache

import pytest

from sim2reason.generation.item import Item
from sim2reason.generation.make import make
from sim2reason.generation.request import Request
from sim2reason.testing.solution_text import part_faults

CELLS = [("collision", "hard"), ("rocket", "hard"), ("hybrid", "hard"), ("pulley", "hard"), ("projectile", "medium")]


@cache
def made(recipe: str, difficulty: str) -> Item:
    """Return a problem with several parts."""
    item = make(Request(recipe, difficulty, "multipart", 77, 0, solutions=True)).item
    assert item is not None
    return item


@pytest.mark.parametrize(("recipe", "difficulty"), CELLS)
def test_a_name_means_the_same_in_all_parts(recipe: str, difficulty: str) -> None:
    solution = made(recipe, difficulty).solution
    assert solution is not None
    assert part_faults(solution.text) == []


@pytest.mark.parametrize(("recipe", "difficulty"), CELLS)
def test_no_equation_is_told_twice(recipe: str, difficulty: str) -> None:
    solution = made(recipe, difficulty).solution
    assert solution is not None
    own = (step for step in solution.steps if not step.text.startswith("As in part ("))
    steps = [step for step in own if step.kind not in ("givens", "earlier part", "equations", "verify")]
    count = Counter(relation for step in steps for relation in step.relations)
    assert [relation for relation, times in count.items() if times > 1] == []
    assert all(needed < number for number, step in enumerate(solution.steps) for needed in step.needs)
