"""Tests of the least number of symbols in a formula, as of numbers that affect a numeric answer."""

import numpy as np
import pytest

from plain_scenes import atwood, ramp
from sim2reason.generation.filters import FILTERS, Candidate
from sim2reason.questions import Formula, Query, Question, SimulatedScene, Target
from sim2reason.questions.difficulty import Difficulty
from sim2reason.questions.moments.times import AtTime
from sim2reason.scenes.dsl.scene import Scene


def reason(scene: Scene, difficulty: Difficulty, within: tuple[str, ...], without: tuple[str, ...] = ()) -> str:
    study = SimulatedScene.of(scene, np.linspace(0.0, 1.0, 11))
    symbols = (*within, *without, "g")
    formula = Formula(
        " ".join(symbols), symbols, ("",) * len(symbols), ((1.0,) * len(symbols),), (1.0,), within, without
    )
    query = Query("state", Target("velocity", study.mechanism.bodies[-1].name), AtTime(0.5))
    question = Question("symbolic", query, "?", 1.0, "m/s", formula=formula)
    return FILTERS["few symbols"].reason(Candidate(study, question, "a b c", difficulty=difficulty))


@pytest.mark.parametrize(
    ("scene", "difficulty", "wanted"),
    [(ramp(), "easy", 2), (ramp(), "hard", 3), (atwood(), "easy", 2), (atwood(), "medium", 3), (atwood(), "hard", 4)],
)
def test_one_symbol_less_than_must_count_is_too_few(scene: Scene, difficulty: Difficulty, wanted: int) -> None:
    names = ("a", "b", "c", "d")
    assert reason(scene, difficulty, names[:wanted]) == ""
    assert reason(scene, difficulty, names[: wanted - 1]) == f"{wanted - 1} symbols of {wanted}"


def test_a_formula_that_lacks_more_than_two_in_five_symbols_is_no_problem() -> None:
    assert reason(ramp(), "easy", ("a", "b", "c"), ("d", "e")) == ""  # 2 of 6
    assert reason(ramp(), "easy", ("a", "b"), ("d", "e")) == ""  # 2 of 5
    assert reason(ramp(), "easy", ("a", "b"), ("d", "e", "f")) == "idle symbols: 3 of 6"
