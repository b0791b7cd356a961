"""Nothing runs away: any simulation, also of what nobody should have built, takes under 5 s of CPU and 1 GB."""

import pytest

from runaway import KINDS, SPOILED, attempt

FEW, SOME = 3, 15


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore::RuntimeWarning")
@pytest.mark.parametrize("kind", KINDS)
def test_random_mechanisms_and_scenes(kind: str) -> None:
    for seed in range(FEW):
        found = attempt((kind, seed))
        assert not found.bad, found


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore::RuntimeWarning")
@pytest.mark.parametrize("kind", SPOILED)
def test_spoiled_ones(kind: str) -> None:
    for seed in range(SOME):
        found = attempt((kind, seed))
        assert not found.bad, found
