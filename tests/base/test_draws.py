"""Random draws with unequal probabilities."""

import numpy as np
import pytest

from sim2reason.base.draws import draw_index


def test_an_index_and_the_numbers_that_follow_are_those_of_a_weighted_choice() -> None:
    weights = np.random.default_rng(0).random((50, 7)) * np.array([1.0, 0.0, 1.0, 1e-9, 1.0, 30.0, 1.0])
    for seed, row in enumerate(weights):
        rng, other = np.random.default_rng(seed), np.random.default_rng(seed)
        assert draw_index(rng, row.tolist()) == other.choice(len(row), p=row / row.sum())
        assert rng.random() == other.random()


def test_weights_that_are_all_zero_are_refused() -> None:
    with pytest.raises(ValueError, match="nothing can be drawn"):
        draw_index(np.random.default_rng(0), [0.0, 0.0])
