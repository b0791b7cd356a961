"""Tests of the values that are tried in variations of a scene."""

from math import radians

import pytest

from plain_scenes import arm
from sim2reason.generation.modes.problem_formula import ProblemSymbol
from sim2reason.generation.modes.variations import Variations
from sim2reason.generation.question_search import QuestionSearch
from sim2reason.questions import Query
from sim2reason.questions.moments.times import AtStart
from sim2reason.questions.query import Target


def test_an_acute_angle_is_tried_as_an_obtuse_one_too() -> None:
    """The symbol of an angle does not restrict it to acute ones, although three times 20° is acute."""
    study = QuestionSearch(arm(20.0), 0).study
    sphere = next(name for name, body in study.mechanism.body.items() if body.mass)
    query = Query("start", Target("acceleration", sphere), AtStart())
    varied = Variations(study, query, [ProblemSymbol(r"\theta", "deg", 20.0, "arm.angle")])
    angles = [other.values[r"\theta"] for other in varied.vary_one_by_one(1.0, [])]
    assert angles[-1] == pytest.approx(radians(160.0))
    assert len(angles) == 3
