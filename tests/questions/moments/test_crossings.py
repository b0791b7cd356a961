"""Zero crossings of functions of the motion."""

import numpy as np
import pytest

from sim2reason import parse_scene
from sim2reason.questions.moments.crossings import crossings
from sim2reason.questions.study import SimulatedScene
from sim2reason.scenes.dsl.state import Array, State, row_lengths


@pytest.fixture(scope="module")
def study() -> SimulatedScene:
    scene = parse_scene("A 2 kg block is released from rest on a frictionless 30-degree incline.").scene
    return SimulatedScene.of(scene, np.linspace(0.0, 4.0, 41))


def test_every_rise_through_zero_is_found_in_order(study: SimulatedScene) -> None:
    def excess(state: State) -> Array:
        return np.sin(np.pi * state.times) - 0.5

    assert list(crossings(study.trace, excess)) == pytest.approx([1.0 / 6.0, 13.0 / 6.0], rel=1e-12)


def test_a_rise_between_two_samples_is_found_where_the_function_nearly_touches_zero(study: SimulatedScene) -> None:
    middle = float(study.trace.scan.times[20:22].mean())

    def excess(state: State) -> Array:
        return 1e-6 - (state.times - middle) ** 2

    assert list(crossings(study.trace, excess)) == pytest.approx([middle - 1e-3], rel=1e-9)


def test_what_begins_above_zero_must_fall_first(study: SimulatedScene) -> None:
    assert list(crossings(study.trace, lambda state: 1.0 + state.times)) == []
    assert list(crossings(study.trace, lambda state: (state.times - 1.0) * (state.times - 2.0))) == pytest.approx([2.0])


def test_equal_instants_share_a_state(study: SimulatedScene) -> None:
    times = np.array([0.5, 1.0])
    assert study.trace.sample(times) is study.trace.sample(times.copy())
    assert study.trace.sample(times) is not study.trace.sample(np.array([0.5, 1.5]))


def test_lengths_of_rows_are_those_of_the_norm() -> None:
    vectors = np.random.default_rng(0).normal(size=(100, 3))
    assert np.array_equal(row_lengths(vectors), np.linalg.norm(vectors, axis=1))
