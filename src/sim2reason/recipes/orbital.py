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
    """How hard: how many planets, how long their ellipses, and what part of the star's mass each has, if any.

    Light planets do not bear on each other: two of them are there to be asked about together.
    """

    planets: Count
    eccentricity: Range
    ratio: Range | None = None
    gap: Range | None = None  # from an aphelion to the next perihelion, as a ratio; by default that of the entity


TIERS = {
    "easy": (OrbitTier(Count(1, 1), Range(0.0, 0.3)),),
    "medium": (*2 * (OrbitTier(Count(1, 1), Range(0.2, 0.6)),), OrbitTier(Count(2, 2), Range(0.0, 0.3))),
    "hard": (  # two that disturb each other, or one on a long ellipse, of which laws of conservation tell much
        *2 * (OrbitTier(Count(2, 2), Range(0.1, 0.3), Range(0.25, 0.4), Range(1.3, 1.6)),),
        OrbitTier(Count(1, 1), Range(0.6, 0.8)),
    ),
}


@recipe("orbital", share=2, weights={"optimum": 0.0})
def draw_orbital(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """Planets on circles or ellipses about a fixed star; heavy ones disturb each other."""
    tiers = TIERS[difficulty]
    tier = tiers[int(rng.integers(len(tiers)))]
    kind = Planet if tier.ratio is None else HeavyPlanet
    many = int(rng.integers(tier.planets.low, tier.planets.high + 1))
    system = draw(SolarSystem, rng, {"planets": (kind.__name__,)})
    planets = tuple(draw(kind, rng, {}) for _ in range(many))
    if tier.ratio is not None:
        parts = rng.uniform(tier.ratio.low, tier.ratio.high, many) * system.star.mass
        planets = tuple(rebuilt(p, mass=float(f"{m:.1e}")) for p, m in zip(planets, parts, strict=True))
    planets = orbiting(planets, system.star.mass, tier.eccentricity, rng, tier.gap)
    return Scene(entities=(Named(name="system", entity=rebuilt(system, planets=planets)),))
