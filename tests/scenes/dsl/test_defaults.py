"""Tests of the default duration of a simulation."""

from math import cos, pi, sin, sqrt

import pytest

from sim2reason.datasets.scene_questions import solve
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.files import loads
from sim2reason.simulation.scenes import certify

STIFF, LIGHT, FREE, START = 1e6, 1e-3, 0.5, 0.6
RATE = sqrt(STIFF / LIGHT)


def spring(support: str, stiffness: float = STIFF, mass: float = LIGHT) -> Scene:
    """Build a block on a spring that is initially stretched by 0.1 m."""
    parameters = f"spring: {{stiffness: {stiffness}, length: {FREE}}}, block: {{mass: {mass}}}, start: {START}"
    kind = f"type: AnchoredSpring, parameters: {{{parameters}, support: {support}}}"
    return loads(f"scene: {{entities: [{{name: it, {kind}}}]}}")


@pytest.mark.parametrize("support", ["wall", "ceiling"])
def test_a_stiff_spring_on_a_small_mass_is_followed_by_both_engines(support: str) -> None:
    """A spring of 1 MN/m with a mass of 1 g is followed for 40 periods; x − x₀ = A cos ω t."""
    held = spring(support)
    trace, certificate = certify(held)
    assert certificate.stable_until == held.horizon == pytest.approx(80.0 * pi / RATE), certificate.reason
    middle = FREE + (LIGHT * 9.8 / STIFF if support == "ceiling" else 0.0)
    for time, moved in zip(trace.state.times, abs(trace.state.q[:, 0]), strict=True):
        assert moved == pytest.approx((START - middle) * (1.0 - cos(RATE * time)), abs=1e-7)


@pytest.mark.parametrize(
    ("find", "when", "answer"),
    [
        ("period", "", 2.0 * pi / RATE),
        ("greatest speed", "0.005 s", RATE * (START - FREE)),
        ("speed", "0.0005 s", abs(RATE * (START - FREE) * sin(RATE * 0.0005))),
    ],
)
def test_it_is_asked_about(find: str, when: str, answer: float) -> None:
    """The answers agree with the closed form."""
    assert solve(spring("wall"), find=find, of="it.block", when=when).answer == pytest.approx(answer, rel=1e-6)


def test_ordinary_springs_keep_their_horizon() -> None:
    """The horizon is two seconds, the default of an entity."""
    assert spring("wall", 250.0, 0.1).horizon == 2.0
    assert spring("wall", 2e4, 1.0).horizon == 2.0
