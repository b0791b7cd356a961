"""Tests of how many stated numbers must matter."""

import numpy as np
import pytest

from plain_scenes import half_atwood, ramp
from sim2reason.generation.filters import FILTERS, Candidate
from sim2reason.generation.filters.sensitivity import givens, shortfall
from sim2reason.questions import KINDS, Moment, Query, Question, SimulatedScene, Target
from sim2reason.questions.difficulty import Difficulty
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.times import AtStart, AtTime
from sim2reason.scenes.dsl.scene import Scene

MASSES = ["ramp.blocks.0.mass", "other.system.blocks.0.mass"]
ANGLE, FRICTION, SPEED = "ramp.plane.angle", "ramp.plane.friction", "ramp.speed"


def candidate(scene: Scene, query: Query, difficulty: Difficulty = "medium") -> Candidate:
    study = SimulatedScene.of(scene, np.linspace(0.0, 1.0, 21))
    answer = KINDS[query.kind].answer(query, study)
    assert answer is not None
    return Candidate(study, Question("numeric", query, "?", answer, ""), "", difficulty=difficulty)


@pytest.mark.parametrize(("time", "reason"), [(0.25, ""), (0.3, "idle numbers: "), (0.5, "idle numbers: ")])
def test_a_count_must_change_with_two_numbers(time: float, reason: str) -> None:
    """A block of 1 m/s on a slope of 30° turns back after 0.204 s.

    At twice the speed that is 0.408 s and, on a slope of 20°, 0.298 s; the mass cancels.
    """
    query = StretchQuery("count", None, AtTime(time), "number of reversals", "ramp.blocks.0")
    found = FILTERS["sensitivity"].reason(candidate(ramp(speed=1.0), query))
    assert found.startswith(reason)
    assert bool(found) is bool(reason)


@pytest.mark.parametrize(
    ("difficulty", "paths", "said"),
    [
        ("easy", MASSES, ""),
        ("easy", [MASSES[0], ANGLE], "1 masses matter"),
        ("easy", [MASSES[1]], "1 masses matter"),
        ("easy", [], "0 masses matter"),
        ("easy", [MASSES[0], ANGLE, FRICTION], ""),
        ("easy", [ANGLE, FRICTION], "2 numbers of 1 parts matter"),
        ("medium", [*MASSES, ANGLE], ""),
        ("medium", MASSES, "2 numbers of 2 parts matter"),
        ("medium", [ANGLE, FRICTION], "2 numbers of 1 parts matter"),
        ("hard", [*MASSES, ANGLE, FRICTION], ""),
        ("hard", [*MASSES, ANGLE], "3 numbers of 3 parts matter"),
    ],
)
def test_of_two_bodies_enough_numbers_must_matter(difficulty: Difficulty, paths: list[str], said: str) -> None:
    """In an easy problem, these are both masses, or three numbers with a coefficient of friction."""
    scene = half_atwood().having(FRICTION, 0.1)
    found = candidate(scene, Query("start", Target("acceleration", "ramp.blocks.0"), AtStart()), difficulty)
    stated = {given.paths[0]: given for given in givens(scene)}
    assert shortfall(found, [stated[path] for path in paths]) == said


@pytest.mark.parametrize(
    ("difficulty", "moment", "count", "said"),
    [
        ("easy", AtStart(), 2, ""),
        ("easy", AtStart(), 1, "1 numbers matter"),
        ("medium", AtStart(), 3, ""),
        ("medium", AtStart(), 2, "2 numbers matter"),
        ("hard", AtStart(), 3, ""),
        ("medium", AtTime(0.1), 2, ""),
        ("medium", AtTime(0.1), 1, "2 numbers matter"),
    ],
)
def test_of_one_body_the_time_that_is_asked_about_counts_too(
    difficulty: Difficulty, moment: Moment, count: int, said: str
) -> None:
    scene = ramp(friction=0.1, speed=1.0)
    query = Query(moment.kind, Target("velocity", "ramp.blocks.0"), moment)
    assert shortfall(candidate(scene, query, difficulty), givens(scene)[:count]) == said
