"""Tests that random pucks meet as the recipe intends, with simple numbers."""

from itertools import pairwise

import pytest

from sim2reason.generation.item_search import sample
from sim2reason.questions.difficulty import Difficulty
from sim2reason.scenes.entities.two_d_collision_plane import TwoDCollisionPlane
from sim2reason.simulation.scenes import simulate


def tables(difficulty: Difficulty, count: int) -> list[TwoDCollisionPlane]:
    scenes = [sample("collision", difficulty, seed=4, index=index) for index in range(count)]
    return [e for scene in scenes if isinstance(e := scene.entities[0].entity, TwoDCollisionPlane)]


@pytest.mark.parametrize("difficulty", ["easy", "medium", "hard"])
def test_pucks_move_along_an_axis_or_are_at_rest(difficulty: Difficulty) -> None:
    found = tables(difficulty, 30)
    assert found
    for table in found:
        assert any(puck.vx or puck.vy for puck in table.pucks)
        assert all(puck.vx == 0.0 or puck.vy == 0.0 for puck in table.pucks)
        assert len(table.pucks) == 2 or sum(puck.vx != 0.0 for puck in table.pucks) == 1


@pytest.mark.parametrize("difficulty", ["easy", "medium", "hard"])
def test_each_puck_meets_the_next(difficulty: Difficulty) -> None:
    for index in range(30):
        scene = sample("collision", difficulty, seed=4, index=index)
        table = scene.entities[0].entity
        if isinstance(table, TwoDCollisionPlane):
            met = [event.subjects for event in simulate(scene).events if event.kind == "collision"]
            names = [f"table.pucks.{number}" for number in range(len(table.pucks))]
            assert all(any({one, other} == {*pair} for pair in met) for one, other in pairwise(names)), index
