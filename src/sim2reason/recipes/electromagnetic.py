"""Charged beads in electric and magnetic fields."""

import numpy as np

from sim2reason.dsl.scene import Scene
from sim2reason.entities.em_entity import EmEntity
from sim2reason.entities.parts.fields import along
from sim2reason.entities.parts.fields.linear_electric import LinearElectric
from sim2reason.recipes import Difficulty, recipe
from sim2reason.recipes.parts.ideas import Idea, one_of


def _oscillates(entity: EmEntity) -> bool:
    """Return whether the force of a field that changes along its direction drives the particle back."""
    field = entity.electric
    assert isinstance(field, LinearElectric)
    toward = along(field.way)["xy".index(field.axis)]
    return entity.particle.signed_charge * field.signed * toward < 0.0


KIND = "EmEntity"
PLAIN = {"medium?": 0.0, "region?": 0.0, "electric": ("UniformElectric",), "magnetic": ("UniformMagnetic",)}
IDEAS = {
    "easy": (
        Idea(KIND, {**PLAIN, "electric?": 0.0, "magnetic?": 1.0}),
        Idea(KIND, {**PLAIN, "electric?": 1.0, "magnetic?": 0.0}),
    ),
    "medium": (  # crossed fields, and a field that depends on the place, or that has an end
        Idea(KIND, {**PLAIN, "electric?": 1.0, "magnetic?": 1.0}),
        Idea(
            KIND,
            {**PLAIN, "electric?": 1.0, "magnetic?": 0.0, "electric": ("LinearElectric",)},
            suits=_oscillates,
        ),
        Idea(
            KIND, {**PLAIN, "electric?": 0.0, "magnetic?": 1.0, "magnetic": ("LinearMagnetic", "DipoleMagnetic")}, 0.2
        ),
        Idea(KIND, {**PLAIN, "region?": 1.0, "start": ("Launched",)}, 2.0),
    ),
    "hard": (  # one that depends on time, or on the velocity; and regions of crossed fields
        Idea(
            KIND,
            {**PLAIN, "electric?": 1.0, "magnetic?": 0.0, "electric": ("GrowingElectric", "OscillatingElectric")},
        ),
        Idea(KIND, {**PLAIN, "magnetic?": 1.0, "electric?": 0.5, "medium?": 1.0, "medium": ("LinearDrag",)}, 1.5),
        Idea(KIND, {**PLAIN, "magnetic?": 1.0, "electric?": 0.0, "medium?": 1.0, "medium": ("QuadraticDrag",)}, 0.5),
        Idea(KIND, {**PLAIN, "region?": 1.0, "electric?": 1.0, "magnetic?": 1.0, "start": ("Launched",)}),
    ),
}

WEIGHTS = {
    "comparison": 0.1,
    "state": 0.3,
    "sum": 0.15,
    "numeric.sum": 0.0,
    "event": 0.4,
    "time_to_event": 0.1,
    "extremum": 0.1,
    "optimum": 0.0,
}


@recipe("electromagnetic", weights=WEIGHTS)
def draw_electromagnetic(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """A charged bead in fields that are uniform, or depend on place, velocity and time, with or without an end."""
    return one_of(IDEAS[difficulty], rng, "fields")
