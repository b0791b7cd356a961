"""Tests of tied rough bodies at rest: their forces are undetermined, but not the time at which they slip."""

from math import asin, inf, sqrt

import numpy as np
import pytest

from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.mechanism import Mechanism, X, Z
from sim2reason.simulation.engines.exact.margins import maximize_least
from sim2reason.simulation.trace import ENGINES

G, STIFFNESS, CART, SPEED = 9.8, 40.0, 6.0, 2.0


def train(masses: tuple[float, ...], frictions: tuple[float, ...]) -> Mechanism:
    """Build tied rough blocks in a row, the first on a spring that a smooth cart stretches."""
    builder = Builder()
    room = builder.room()
    for number, (mass, friction) in enumerate(zip(masses, frictions, strict=True)):
        block = room.body(f"block{number}", mass, at=(-float(number), 0.0, 0.0)).rest(X, Z, friction)
        block.site(f"hook{number}")
        if number:
            room.string(f"link{number}", f"hook{number}", f"hook{number - 1}")
    room.body("cart", CART, at=(1.0, 0.0, 0.0)).rest(X, Z, speed=SPEED).site("eye")
    room.spring("spring", "hook0", "eye", stiffness=STIFFNESS)
    return builder.finish()


@pytest.mark.parametrize("engine", list(ENGINES))
@pytest.mark.parametrize(
    ("masses", "frictions"),
    [((1.0, 2.0), (0.3, 0.3)), ((0.2, 3.0), (0.6, 0.25)), ((2.0, 0.3, 1.0), (0.1, 0.5, 0.3)), ((1.0,) * 4, (0.2,) * 4)],
)
def test_a_train_gives_way_when_all_friction_is_used_up(
    engine: str, masses: tuple[float, ...], frictions: tuple[float, ...]
) -> None:
    """The spring pulls with k (v/ω) sin ωt, as k x = −M ẍ for the cart, until that reaches Σ µ m g."""
    omega = sqrt(STIFFNESS / CART)
    most = G * sum(mu * m for mu, m in zip(frictions, masses, strict=True))
    expected = asin(most * omega / (STIFFNESS * SPEED)) / omega
    trace = ENGINES[engine](train(masses, frictions), np.linspace(0.0, expected + 0.02, 21))
    slips = [event for event in trace.events if event.kind == "slip"]
    assert [event.subjects for event in slips] == [(f"block{number}",) for number in range(len(masses))]
    assert [event.time for event in slips] == pytest.approx([expected] * len(masses), rel=1e-9)
    assert len(trace.events) == len(slips)


def test_the_greatest_least_margin() -> None:
    assert maximize_least([3.0, 1.0], [[1.0], [-1.0]]) == (2.0, {0, 1})
    assert maximize_least([3.0, 1.0, 0.5], [[1.0], [-1.0], [0.0]]) == (0.5, {2})
    assert maximize_least([1.0], [[1.0]])[0] == inf
    value, tight = maximize_least([4.0, 2.0, 3.0], [[1.0, 0.0], [-1.0, 1.0], [0.0, -1.0]])
    assert (value, tight) == (pytest.approx(3.0), {0, 1, 2})
