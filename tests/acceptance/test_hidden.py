"""Tests that hidden numbers, which no text states, do not affect answers."""

from itertools import islice

import numpy as np
import pytest

from cells import asked
from sim2reason.questions import KINDS, SimulatedScene
from sim2reason.questions.difficulty import DIFFICULTIES, Difficulty
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.simulation.scenes import simulate

ITEMS = [2, pytest.param(12, marks=pytest.mark.slow)]  # of each cell: 108 in all
CLOSE = 1e-9
FREE_LENGTH = (2.0, 4.0)  # m, from which all that is hidden today is drawn


def redrawn(scene: Scene, rng: np.random.Generator) -> Scene:
    """Return the same scene with every hidden number drawn again."""
    for parameter in scene.parameters:
        if parameter.hidden:
            scene = scene.having(parameter.path, float(rng.uniform(*FREE_LENGTH)))
    return scene


@pytest.mark.parametrize("items", ITEMS)
@pytest.mark.parametrize("difficulty", DIFFICULTIES)
@pytest.mark.parametrize("recipe", ["pulley", "incline", "hybrid"])
def test_hidden_numbers_change_no_answer(recipe: str, difficulty: Difficulty, items: int) -> None:
    rng, compared = np.random.default_rng(3), 0
    hiding = ((scene, found) for scene, found in asked(recipe, difficulty) if any(p.hidden for p in scene.parameters))
    for scene, found in islice(hiding, items):
        other = redrawn(scene, rng)
        assert other != scene
        study, query = SimulatedScene(other, simulate(other)), found.question.query
        time, answer = KINDS[query.kind].time(query, study), KINDS[query.kind].answer(query, study)
        if time is None or answer is None or time > study.trace.stable_until:
            continue  # with shorter strings the motion ends before
        assert answer == pytest.approx(found.question.answer, rel=CLOSE, abs=1e-12), found.prompt
        compared += 1
    assert compared >= items // 2
