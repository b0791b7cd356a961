"""Bodies in fields: thrown balls, planets about a star, and charged beads."""

from dataclasses import dataclass

import numpy as np

from sim2reason.generation.recipes import recipe
from sim2reason.generation.recipes.ranges import Idea, draw_idea
from sim2reason.questions.difficulty import Difficulty
from sim2reason.scenes.bodies.charges import Launched
from sim2reason.scenes.bodies.space import Planet
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.measures import Count, Range
from sim2reason.scenes.dsl.model import Choices, draw, replace_validated
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.fields import LinearElectric
from sim2reason.scenes.entities.particles import EmEntity
from sim2reason.scenes.entities.space import SolarSystem, orbiting

PROJECTILE = "Projectile"
THROWN = {"height": Range(1.0, 5.0), "speed": Range(3.0, 12.0), "angle": Range(15.0, 75.0)}
BOUNCING = {**THROWN, "restitution?": 1.0, "restitution": Range(0.3, 0.85)}
FLYING = {**THROWN, "restitution?": 0.0}
PROJECTILE_IDEAS = {
    "easy": (  # thrown horizontally it would only fall, were it not to bounce
        Idea(PROJECTILE, {**FLYING, "side": ("above",)}, 2.0),
        Idea(PROJECTILE, {**BOUNCING, "angle": 0.0}),
    ),
    "medium": (  # one flight after another, or one that begins downwards
        Idea(PROJECTILE, BOUNCING, 2.0),
        Idea(PROJECTILE, {**FLYING, "side": ("below",), "angle": Range(15.0, 75.0)}),
    ),
    "hard": (  # so lively that the flights add up, or thrown at the ground
        Idea(PROJECTILE, {**BOUNCING, "speed": Range(4.0, 10.0), "restitution": Range(0.6, 0.95)}),
        Idea(PROJECTILE, {**BOUNCING, "speed": Range(3.0, 10.0), "side": ("below",), "angle": Range(15.0, 75.0)}),
    ),
}


@recipe("projectile", weights={"extremum": 0.03, "state": 0.5, "optimum": 2.0})  # which hang on few of the numbers
def draw_projectile(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """A ball thrown from a height, which may bounce."""
    return draw_idea(PROJECTILE_IDEAS[difficulty], rng, "throw")


@dataclass(frozen=True)
class OrbitTier:
    """The difficulty settings of orbits: number of planets and eccentricity.

    Planets do not attract each other, because heavy ones would also move the star; several planets allow comparisons.
    """

    planets: Count
    eccentricity: Range


ORBIT_TIERS = {
    "easy": (OrbitTier(Count(1, 1), Range(0.0, 0.3)),),
    "medium": (*5 * (OrbitTier(Count(1, 1), Range(0.2, 0.6)),), OrbitTier(Count(2, 2), Range(0.0, 0.3))),
    "hard": (  # one on a long ellipse, of which laws of conservation tell much, or two on ellipses
        *5 * (OrbitTier(Count(1, 1), Range(0.5, 0.8)),),
        OrbitTier(Count(2, 2), Range(0.3, 0.6)),
    ),
}

# of other speeds at the start, which give other orbits, no text says for how long they are followed
ORBIT_WEIGHTS = {
    "optimum": 0.0,
    "numeric.state": 0.3,
    "sum": 0.1,
    "reverse.extremum": 0.2,
    "reverse.sum": 0.3,
    "symbolic.extremum": 0.3,
}


@recipe("orbital", share=2, weights=ORBIT_WEIGHTS)
def draw_orbital(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """Planets on circles or ellipses about a fixed star."""
    tiers = ORBIT_TIERS[difficulty]
    tier = tiers[int(rng.integers(len(tiers)))]
    many = int(rng.integers(tier.planets.low, tier.planets.high + 1))
    system = draw(SolarSystem, rng, {"planets": (Planet.__name__,)})
    planets = tuple(draw(Planet, rng, {}) for _ in range(many))
    planets = orbiting(planets, system.star.mass, tier.eccentricity, rng)
    return Scene(entities=(Named(name="system", entity=replace_validated(system, planets=planets)),))


def _oscillates(entity: EmEntity) -> bool:
    """Return whether a field that varies along its own direction drives the particle back, so that it oscillates."""
    field = entity.electric
    assert isinstance(field, LinearElectric)
    return field.drives_back(entity.particle.signed_charge)


def _is_launched(entity: EmEntity) -> bool:
    """Return whether a bead moves at the start; only then is it aimed at the region."""
    return isinstance(entity.start, Launched)


BEAD = "EmEntity"
PLAIN = {"medium?": 0.0, "region?": 0.0, "electric": ("UniformElectric",), "magnetic": ("UniformMagnetic",)}
ELECTRIC = {**PLAIN, "electric?": 1.0, "magnetic?": 0.0}
MAGNETIC = {**PLAIN, "electric?": 0.0, "magnetic?": 1.0}
CROSSED_CHOICES = {**PLAIN, "electric?": 1.0, "magnetic?": 1.0}
LAUNCHED: Choices = {"start": ("Launched",)}
RELEASED: Choices = {"start": ("Released",)}
RIGHT: Choices = {**LAUNCHED, "angle": 0.0}  # a start whose angle texts do not state
UP: Choices = {**LAUNCHED, "angle": 90.0}
ALONG_X = ("positive x", "negative x")
ALONG_Y = ("positive y", "negative y")

BEAD_IDEAS = {
    "easy": (
        Idea(BEAD, {**MAGNETIC, **LAUNCHED}, 1.5),
        Idea(BEAD, {**ELECTRIC, **RIGHT, "way": ALONG_Y}),
        Idea(BEAD, {**ELECTRIC, **UP, "way": ALONG_X}),
        Idea(BEAD, {**ELECTRIC, **LAUNCHED}, 2.0),
        Idea(BEAD, {**CROSSED_CHOICES, **RELEASED}, 0.8),
    ),
    "medium": (  # crossed fields, and a field that depends on the place, or that has an end
        Idea(BEAD, {**CROSSED_CHOICES, **RELEASED}),
        Idea(BEAD, {**CROSSED_CHOICES, **RIGHT}, 1.5),
        Idea(BEAD, {**CROSSED_CHOICES, **UP}, 1.5),
        Idea(BEAD, {**CROSSED_CHOICES, **LAUNCHED}, 1.5),
        Idea(BEAD, {**ELECTRIC, "electric": ("LinearElectric",)}, 1.5, suits=_oscillates),
        Idea(BEAD, {**MAGNETIC, "magnetic": ("LinearMagnetic", "DipoleMagnetic")}, 0.05),
        Idea(BEAD, {**PLAIN, "region?": 1.0}, 0.1, suits=_is_launched),
    ),
    "hard": (  # one that depends on time, or on the velocity; and regions of crossed fields
        Idea(BEAD, {**CROSSED_CHOICES, **LAUNCHED}, 2.0),
        Idea(BEAD, {**CROSSED_CHOICES, **LAUNCHED, "electric": ("LinearElectric",)}, 1.5, suits=_oscillates),
        Idea(BEAD, {**CROSSED_CHOICES, **RIGHT, "electric": ("LinearElectric",)}, 0.4, suits=_oscillates),
        Idea(BEAD, {**CROSSED_CHOICES, **UP, "electric": ("LinearElectric",)}, 0.4, suits=_oscillates),
        Idea(BEAD, {**ELECTRIC, "electric": ("GrowingElectric", "OscillatingElectric")}, 0.2),
        Idea(BEAD, {**PLAIN, "magnetic?": 1.0, "electric?": 0.5, "medium?": 1.0, "medium": ("LinearDrag",)}, 0.3),
        Idea(BEAD, {**MAGNETIC, "medium?": 1.0, "medium": ("QuadraticDrag",)}, 0.05),
        Idea(BEAD, {**CROSSED_CHOICES, "region?": 1.0}, 0.1, suits=_is_launched),
    ),
}

BEAD_WEIGHTS = {
    "comparison": 0.05,
    "state": 0.0,  # fields offer turning points and extremes enough: no instant need be named
    "start": 0.1,
    "sum": 0.0,
    "event": 1.0,
    "time_to_event": 0.5,
    "extremum": 0.8,
    "optimum": 0.0,
}


@recipe("electromagnetic", weights=BEAD_WEIGHTS)
def draw_electromagnetic(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """A charged bead in uniform or variable fields, with or without boundaries."""
    return draw_idea(BEAD_IDEAS[difficulty], rng, "fields")
