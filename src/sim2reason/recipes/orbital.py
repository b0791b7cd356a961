"""Planets about a star."""

from dataclasses import dataclass

import numpy as np

from sim2reason.bodies.star import HeavyPlanet, Planet
from sim2reason.dsl.entity import Named
from sim2reason.dsl.measures import Count, Range
from sim2reason.dsl.model import draw, rebuilt
from sim2reason.dsl.scene import Scene
from sim2reason.entities.solar_system import SolarSystem, orbiting
from sim2reason.recipes import Difficulty, recipe


@dataclass(frozen=True)
class OrbitTier:
    """How hard: how many planets, how long their ellipses, and how often they attract one another."""

    planets: Count
    eccentricity: Range
    heavy: float = 0.0


HEAVY = Count(2, 3)  # planets that attract one another; more would hardly move in a period of the first
TIERS = {
    "easy": OrbitTier(Count(1, 2), Range(0.0, 0.0)),
    "medium": OrbitTier(Count(2, 4), Range(0.0, 0.3)),
    "hard": OrbitTier(Count(3, 6), Range(0.1, 0.5), heavy=0.5),
}


@recipe("orbital", share=2)
def draw_orbital(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """Planets on circles or ellipses about a fixed star; heavy ones disturb each other."""
    tier = TIERS[difficulty]
    heavy = bool(rng.random() < tier.heavy)
    count = HEAVY if heavy else tier.planets
    kind = HeavyPlanet if heavy else Planet
    many = int(rng.integers(count.low, count.high + 1))
    system = draw(SolarSystem, rng, {"planets": (kind.__name__,)})
    planets = tuple(draw(kind, rng, {}) for _ in range(many))
    if heavy:
        light = [rng.uniform(0.01, 0.05) * system.star.mass for _ in planets]
        planets = tuple(rebuilt(p, mass=float(f"{m:.1e}")) for p, m in zip(planets, light, strict=True))
    planets = orbiting(planets, system.star.mass, tier.eccentricity, rng)
    return Scene(entities=(Named(name="system", entity=rebuilt(system, planets=planets)),))
