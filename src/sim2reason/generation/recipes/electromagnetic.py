"""Charged beads in electric and magnetic fields."""

import numpy as np

from sim2reason.generation.recipes import recipe
from sim2reason.generation.recipes.parts.ideas import Idea, one_of
from sim2reason.questions.difficulty import Difficulty
from sim2reason.scenes.bodies.charges import Launched
from sim2reason.scenes.dsl.model import Choices
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.fields import LinearElectric
from sim2reason.scenes.entities.particles import EmEntity


def _oscillates(entity: EmEntity) -> bool:
    """Return whether a field that varies along its own direction drives the particle back, so that it oscillates."""
    field = entity.electric
    assert isinstance(field, LinearElectric)
    return field.drives_back(entity.particle.signed_charge)


def _is_launched(entity: EmEntity) -> bool:
    """Return whether a bead moves at the start; only then is it aimed at the region."""
    return isinstance(entity.start, Launched)


KIND = "EmEntity"
PLAIN = {"medium?": 0.0, "region?": 0.0, "electric": ("UniformElectric",), "magnetic": ("UniformMagnetic",)}
ELECTRIC = {**PLAIN, "electric?": 1.0, "magnetic?": 0.0}
MAGNETIC = {**PLAIN, "electric?": 0.0, "magnetic?": 1.0}
CROSSED = {**PLAIN, "electric?": 1.0, "magnetic?": 1.0}
LAUNCHED: Choices = {"start": ("Launched",)}
RELEASED: Choices = {"start": ("Released",)}
RIGHT: Choices = {**LAUNCHED, "angle": 0.0}  # a start whose angle texts do not state
UP: Choices = {**LAUNCHED, "angle": 90.0}
ALONG_X = ("positive x", "negative x")
ALONG_Y = ("positive y", "negative y")

IDEAS = {
    "easy": (
        Idea(KIND, {**MAGNETIC, **LAUNCHED}, 1.5),
        Idea(KIND, {**ELECTRIC, **RIGHT, "way": ALONG_Y}),
        Idea(KIND, {**ELECTRIC, **UP, "way": ALONG_X}),
        Idea(KIND, {**ELECTRIC, **LAUNCHED}, 2.0),
        Idea(KIND, {**CROSSED, **RELEASED}, 0.8),
    ),
    "medium": (  # crossed fields, and a field that depends on the place, or that has an end
        Idea(KIND, {**CROSSED, **RELEASED}),
        Idea(KIND, {**CROSSED, **RIGHT}, 1.5),
        Idea(KIND, {**CROSSED, **UP}, 1.5),
        Idea(KIND, {**CROSSED, **LAUNCHED}, 1.5),
        Idea(KIND, {**ELECTRIC, "electric": ("LinearElectric",)}, 1.5, suits=_oscillates),
        Idea(KIND, {**MAGNETIC, "magnetic": ("LinearMagnetic", "DipoleMagnetic")}, 0.05),
        Idea(KIND, {**PLAIN, "region?": 1.0}, 0.1, suits=_is_launched),
    ),
    "hard": (  # one that depends on time, or on the velocity; and regions of crossed fields
        Idea(KIND, {**CROSSED, **LAUNCHED}, 2.0),
        Idea(KIND, {**CROSSED, **LAUNCHED, "electric": ("LinearElectric",)}, 1.5, suits=_oscillates),
        Idea(KIND, {**CROSSED, **RIGHT, "electric": ("LinearElectric",)}, 0.4, suits=_oscillates),
        Idea(KIND, {**CROSSED, **UP, "electric": ("LinearElectric",)}, 0.4, suits=_oscillates),
        Idea(KIND, {**ELECTRIC, "electric": ("GrowingElectric", "OscillatingElectric")}, 0.2),
        Idea(KIND, {**PLAIN, "magnetic?": 1.0, "electric?": 0.5, "medium?": 1.0, "medium": ("LinearDrag",)}, 0.3),
        Idea(KIND, {**MAGNETIC, "medium?": 1.0, "medium": ("QuadraticDrag",)}, 0.05),
        Idea(KIND, {**CROSSED, "region?": 1.0}, 0.1, suits=_is_launched),
    ),
}

WEIGHTS = {
    "comparison": 0.05,
    "state": 0.0,  # fields offer turning points and extremes enough: no instant need be named
    "start": 0.1,
    "sum": 0.0,
    "event": 1.0,
    "time_to_event": 0.5,
    "extremum": 0.8,
    "optimum": 0.0,
}


@recipe("electromagnetic", weights=WEIGHTS)
def draw_electromagnetic(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """A charged bead in uniform or variable fields, with or without boundaries."""
    return one_of(IDEAS[difficulty], rng, "fields")
