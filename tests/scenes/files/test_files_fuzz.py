"""Tests of malformed files: each can be simulated or raises one error with path and remedy."""

import re
import time
import warnings
from collections import Counter

import numpy as np
import pytest

from scene_files import composed, drawn, spoiled
from sim2reason.base.yaml_text import write
from sim2reason.errors import MotionEndsWarning, SceneError, Sim2ReasonError
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.files import dump, load
from sim2reason.simulation.scenes import simulate
from sim2reason.text.prose.description import describe

PLACE = re.compile(r"(scene|[A-Za-z][\w.]*|\[\d+\])[\w.\[\]]*( \(line \d+\))?|line \d+|the file")
CHUNKS, SIZE = 10, 60


@pytest.fixture(scope="module")
def scenes() -> list[Scene]:
    return list(drawn(48, seed=5))


def check(error: SceneError) -> None:
    """Assert that the message names place, problem and remedy in one line."""
    assert PLACE.fullmatch(error.place), error
    assert error.problem
    assert error.remedy
    assert "\n" not in str(error)
    assert len(str(error)) < 400


def outcome(text: str) -> str:
    """Load, describe and simulate a scene; assert that any refusal is well-formed and fast."""
    begun = time.perf_counter()
    try:
        scene = load(text)
    except SceneError as error:
        check(error)
        return "refused"
    finally:
        assert time.perf_counter() - begun < 5.0
    again = dump(scene)
    assert load(again) == scene
    assert dump(load(again)) == again
    try:
        describe(scene)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", MotionEndsWarning)
            simulate(scene, 1.0, samples=11)
    except Sim2ReasonError as error:
        return type(error).__name__
    finally:
        assert time.perf_counter() - begun < 5.0
    return "simulated"


@pytest.mark.parametrize("chunk", range(CHUNKS))
def test_spoiled_files_are_scenes_or_one_error(chunk: int, scenes: list[Scene]) -> None:
    found = Counter(outcome(spoiled(seed, scenes)) for seed in range(chunk * SIZE, (chunk + 1) * SIZE))
    assert found["refused"] > SIZE // 3
    assert found["simulated"] > 1


@pytest.mark.parametrize("chunk", range(5))
def test_scenes_that_no_recipe_would_draw_are_simulated_or_refused(chunk: int) -> None:
    texts = [write(composed(np.random.default_rng([chunk, n]))) for n in range(40)]
    found = Counter(map(outcome, texts))
    assert found["simulated"] > 3
