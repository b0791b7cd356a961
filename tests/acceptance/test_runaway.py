"""Tests that no simulation, even of a senseless mechanism, takes more than 5 s of CPU time or 1 GB."""

import pytest

from runaway import KINDS, SPOILED, attempt

FEW = [1, pytest.param(3, marks=pytest.mark.slow)]
SOME = [3, pytest.param(15, marks=pytest.mark.slow)]


@pytest.mark.filterwarnings("ignore::RuntimeWarning")
@pytest.mark.parametrize("seeds", FEW)
@pytest.mark.parametrize("kind", KINDS)
def test_random_mechanisms_and_scenes(kind: str, seeds: int) -> None:
    for seed in range(seeds):
        found = attempt((kind, seed))
        assert not found.bad, found


@pytest.mark.filterwarnings("ignore::RuntimeWarning")
@pytest.mark.parametrize("seeds", SOME)
@pytest.mark.parametrize("kind", SPOILED)
def test_spoiled_ones(kind: str, seeds: int) -> None:
    for seed in range(seeds):
        found = attempt((kind, seed))
        assert not found.bad, found
