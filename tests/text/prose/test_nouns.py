"""Tests that nouns suit the bodies that they name."""

import pytest

from lone_entities import alone
from sim2reason.scenes.bodies.oscillators import Ball
from sim2reason.scenes.bodies.space import Planet, Star
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.particles import Projectile
from sim2reason.scenes.entities.space import SolarSystem
from sim2reason.text.prose.description import describe

SEEDS = range(24)


def thrown(mass: float) -> Scene:
    """Return a scene with a thrown ball of some mass."""
    return alone(Projectile(ball=Ball(mass=mass), height=1.0))


def orbiting(speed: float) -> Scene:
    """Return a scene with a planet at 1 au, moving at right angles to its star; 2π au/yr gives a circle."""
    return alone(SolarSystem(star=Star(mass=1.0), planets=(Planet(x=1.0, y=0.0, vx=0.0, vy=speed),)))


@pytest.mark.parametrize(
    ("scene", "noun", "apt"),
    [
        (thrown(0.1), "bead", True),
        (thrown(3.5), "bead", False),
        (orbiting(6.28), "comet", False),
        (orbiting(8.2), "comet", True),
        (orbiting(3.0), "comet", True),
    ],
)
def test_a_noun_is_drawn_only_where_it_suits(scene: Scene, noun: str, apt: bool) -> None:
    """Beads are light, and the orbits of comets have eccentricities v²r/GM − 1 of 0.7 or 0.77, not 0."""
    assert any(f"{noun} " in describe(scene, seed).text for seed in SEEDS) is apt
