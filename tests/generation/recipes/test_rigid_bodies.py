"""Tests that the parts of a random arm neither overlap nor lie on the axle."""

from itertools import combinations

import pytest

from sim2reason.generation.item_search import sample
from sim2reason.generation.recipes.rigid_bodies import are_clear
from sim2reason.questions.difficulty import Difficulty
from sim2reason.scenes.bodies.oscillators import FixedBall, UniformRod
from sim2reason.scenes.entities.pendulums import WeldedArm
from sim2reason.scenes.entities.pieces import OTHER_SIDE, AxialPiece, BallPiece, Side


def rod(length: float, distance: float) -> AxialPiece:
    return AxialPiece(body=UniformRod(mass=2.0, length=length), distance=distance, axis="along the arm")


@pytest.mark.parametrize(
    ("length", "distance", "side", "clear"),
    [
        (0.4, 0.3, "from the axle", True),  # the ball at 0.6 m is beyond its end
        (0.8, 0.5, "from the axle", False),  # it covers the place of the ball
        (1.2, 0.1, OTHER_SIDE, False),  # it reaches past the axle
        (0.4, 0.3, OTHER_SIDE, True),
    ],
)
def test_a_rod_along_the_arm_and_a_ball(length: float, distance: float, side: Side, clear: bool) -> None:
    ball = BallPiece(body=FixedBall(mass=1.0), distance=0.6, side=side)
    assert are_clear(rod(length, distance), ball) is clear
    assert are_clear(ball, rod(length, distance)) is clear


@pytest.mark.parametrize("difficulty", ["medium", "hard"])
def test_pieces_that_are_drawn_are_clear_of_each_other(difficulty: Difficulty) -> None:
    for index in range(40):
        arm = sample("rotation", difficulty, seed=5, index=index).entities[0].entity
        assert isinstance(arm, WeldedArm)
        assert all(are_clear(one, other) for one, other in combinations(arm.pieces, 2))


@pytest.mark.parametrize("difficulty", ["easy", "medium", "hard"])
def test_distances_are_rounded_where_the_share_of_inertia_limits_them(difficulty: Difficulty) -> None:
    for index in range(40):
        for parameter in sample("rotation", difficulty, seed=6, index=index).parameters:
            if parameter.value is not None and not parameter.hidden:
                assert parameter.measure.round(parameter.value) == parameter.value, (index, parameter.path)
