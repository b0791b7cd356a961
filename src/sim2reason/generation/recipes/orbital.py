"""Planets about a star."""

from dataclasses import dataclass

import numpy as np

from sim2reason.generation.recipes import recipe
from sim2reason.questions.difficulty import Difficulty
from sim2reason.scenes.bodies.space import Planet
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.measures import Count, Range
from sim2reason.scenes.dsl.model import draw, replace_validated
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.space import SolarSystem, orbiting


@dataclass(frozen=True)
class OrbitTier:
    """The difficulty settings of orbits: number of planets and eccentricity.

    Planets do not attract each other, because heavy ones would also move the star; several planets allow comparisons.
    """

    planets: Count
    eccentricity: Range


TIERS = {
    "easy": (OrbitTier(Count(1, 1), Range(0.0, 0.3)),),
    "medium": (*5 * (OrbitTier(Count(1, 1), Range(0.2, 0.6)),), OrbitTier(Count(2, 2), Range(0.0, 0.3))),
    "hard": (  # one on a long ellipse, of which laws of conservation tell much, or two on ellipses
        *5 * (OrbitTier(Count(1, 1), Range(0.5, 0.8)),),
        OrbitTier(Count(2, 2), Range(0.3, 0.6)),
    ),
}

# of other speeds at the start, which give other orbits, no text says for how long they are followed
WEIGHTS = {
    "optimum": 0.0,
    "numeric.state": 0.3,
    "sum": 0.1,
    "reverse.extremum": 0.2,
    "reverse.sum": 0.3,
    "symbolic.extremum": 0.3,
}


@recipe("orbital", share=2, weights=WEIGHTS)
def draw_orbital(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """Planets on circles or ellipses about a fixed star."""
    tiers = TIERS[difficulty]
    tier = tiers[int(rng.integers(len(tiers)))]
    many = int(rng.integers(tier.planets.low, tier.planets.high + 1))
    system = draw(SolarSystem, rng, {"planets": (Planet.__name__,)})
    planets = tuple(draw(Planet, rng, {}) for _ in range(many))
    planets = orbiting(planets, system.star.mass, tier.eccentricity, rng)
    return Scene(entities=(Named(name="system", entity=replace_validated(system, planets=planets)),))
