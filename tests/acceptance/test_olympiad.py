"""Tests of olympiad problems in files, against published results and closed forms."""

from functools import cache
from math import cos, pi, radians, sqrt
from pathlib import Path

import numpy as np
import pytest

from joined_entities import Followed, close
from places_of_rest import equilibria
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.files import dump, load
from sim2reason.text.parsing import parse_scene
from sim2reason.text.prose import describe

FILES = sorted((Path(__file__).parents[2] / "examples" / "olympiad").glob("*.yaml"))
TEXTS = {path.stem: path.read_text() for path in FILES}
G = 9.8


@cache
def problem(name: str) -> Scene:
    """Return the scene of a problem."""
    return load(TEXTS[name])


@pytest.mark.parametrize("name", TEXTS)
def test_a_problem_is_told_and_read_back(name: str) -> None:
    scene = problem(name)
    assert load(dump(scene)) == scene
    text = describe(scene, seed=1).text
    assert describe(parse_scene(text).scene, seed=1).text == text


def test_fma_2024_17() -> None:
    """Published answer E: 11 mg/6k. The rope's tension is mg, and so is the force of each spring.

    The rope that carries the block goes over the lower pulley to the spring of 2k, whose stretch mg/2k lowers the block
    by as much. The pulley's hook pulls the upper pulley with 2 mg, whose rope ends at k and at 3k. They stretch by mg/k
    and mg/3k, so their pulley sinks by half the sum, the block by the sum: mg (1/k + 1/2k + 1/3k).
    """
    name, mass, stiffness = "load.system.blocks.0.slide", 2.0, 100.0
    text = TEXTS["fma_2024_17"]
    doubled = text.replace(f"[{{mass: {mass}}}]", f"[{{mass: {2.0 * mass}}}]")
    assert doubled != text
    (light,), (heavy,) = (equilibria(load(file).mechanism) for file in (text, doubled))
    assert light.stable
    assert heavy.stable
    close(light.coordinates[name] - heavy.coordinates[name], 11.0 / 6.0 * mass * G / stiffness)
    close(light.tensions["tendon_1"], mass * G)
    close(heavy.tensions["tendon_2"], 4.0 * mass * G)


def test_usapho_2019_b3() -> None:
    """R θ̇² = 4 g (cos θ₀ − cos θ)/(1 + sin² θ), θ from the upward vertical: the centre of mass only falls.

    Momentum along the rail is conserved: the ball is at (R/2) sin θ from the vertical of the centre of mass, on an
    ellipse of half-axes R/2 and R. Released from the top, both pass the lowest position with R θ̇/2 = √(2 g R).
    """
    length, tilt = 0.8, radians(0.1)
    found = Followed(problem("usapho_2019_b3"), 2.6, count=4001)
    turned, rate, slid = found.q("rod.bob.hinge"), found.v("rod.bob.hinge"), found.q("bead.carriage.slide")
    angle = tilt + turned
    close(rate**2, 4.0 * G / length * (cos(tilt) - np.cos(angle)) / (1.0 + np.sin(angle) ** 2))
    close(slid, -length / 2.0 * (np.sin(angle) - np.sin(tilt)))
    across, height = slid + length * np.sin(angle) - length / 2.0 * np.sin(tilt), length * np.cos(angle)
    close((2.0 * across / length) ** 2 + (height / length) ** 2, np.ones_like(angle))
    assert length / 2.0 * rate.max() == pytest.approx(sqrt(2.0 * G * length), rel=1e-5)


def test_jee_advanced_2019_paper_2() -> None:
    """Published: 2a₁ = a₂ + a₃, x₀ = 16 Mg/3k, and 2g/7 at x₀/4, ω x₀/2 at x₀/2, with ω² = 3k/14M.

    T = 4M(g − a₁)/3 on either side of the movable pulley: (2M + 8M/3) a₁ = 8Mg/3 − kx, a harmonic motion about x₀/2.
    """
    mass, stiffness = 0.5, 20.0
    rate, greatest = sqrt(3.0 * stiffness / (14.0 * mass)), 16.0 * mass * G / (3.0 * stiffness)
    found = Followed(problem("jee_advanced_2019_paper_2"), pi / rate, count=7)
    stretch, speed = found.q("spring.block.slide"), found.v("spring.block.slide")
    first, second, third = (
        found.a(name) for name in ("spring.block.slide", "pair.left.blocks.0.slide", "pair.right.blocks.0.slide")
    )
    close(2.0 * first, -second - third)  # heights are counted upwards
    close(stretch[[2, 3, 6]], greatest * np.array([0.25, 0.5, 1.0]))
    close(first[2], 2.0 * G / 7.0)
    close(speed[3], rate * greatest / 2.0)
    close(found.trace.state.tension["spring.spring"], stiffness * stretch)
