"""Ranges of the numbers in random scenes, by difficulty, and random scenes of a single entity."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, TypeVar

import numpy as np
from pydantic import ValidationError

from sim2reason.base.draws import draw_index
from sim2reason.errors import SceneError
from sim2reason.questions.difficulty import Difficulty
from sim2reason.scenes.dsl.addresses import with_values, without_idle_fields
from sim2reason.scenes.dsl.entity import ENTITIES, Named
from sim2reason.scenes.dsl.measures import Count, Range
from sim2reason.scenes.dsl.model import Choice, Choices, Model, Parameter, draw, parameters
from sim2reason.scenes.dsl.scene import Scene

FACTORS, TURNS = (2.0, 0.5), (10.0, -10.0)  # a number is halved and doubled; an angle is changed by these degrees
MIN_RESPONSE_CHANGE = (
    0.12  # relative change of a response; smaller ones may stay within the tolerance after a square root
)
V = TypeVar("V", bound=Model)


def idle_numbers(
    value: V, response: Callable[[V], Sequence[float]], threshold: float = MIN_RESPONSE_CHANGE
) -> Iterator[str]:
    """Yield the addresses of numbers whose halving and doubling changes every response by less than `threshold`."""
    before = response(value)
    for number in parameters(value):
        if (
            number.value
            and not number.hidden
            and not any(
                abs(new - old) > threshold * abs(old)
                for other in _moved(value, number)
                for old, new in zip(before, response(other), strict=True)
            )
        ):
            yield number.path


def _moved(value: V, number: Parameter) -> Iterator[V]:
    """Yield the models with one number halved and doubled, or an angle turned by ±10°, as far as they are valid."""
    assert number.value is not None
    turned = number.measure.unit == "deg"
    for new in (number.value + turn for turn in TURNS) if turned else (number.value * factor for factor in FACTORS):
        try:
            yield with_values(value, {number.path: new})
        except (ValidationError, SceneError):
            continue


MAX_REDRAWS = 200  # of scenes that do not fit an idea


@dataclass(frozen=True)
class Idea:
    """A specification of random scenes of one entity: ranges and parts to draw, a condition, and a weight."""

    entity: str
    choices: Choices = field(default_factory=dict[str, Choice])
    weight: float = 1.0
    suits: Callable[[Any], bool] = lambda _: True  # whether all of a drawn entity has a bearing on what it does


def draw_idea(ideas: Sequence[Idea], rng: np.random.Generator, name: str) -> Scene:
    """Return a scene of one entity, named `name`, drawn by a random idea.

    Raises:
        SceneError: the draw does not hold together, or nothing that was drawn suits the idea.
    """
    idea = ideas[draw_index(rng, [idea.weight for idea in ideas])]
    for _ in range(MAX_REDRAWS):
        entity = draw(ENTITIES[idea.entity], rng, idea.choices)
        if idea.suits(entity):
            return Scene(entities=without_idle_fields((Named(name=name, entity=entity),), ()))
    raise SceneError(idea.entity, f"none of {MAX_REDRAWS} draws suits what the recipe is about", "widen a range")


WORDS: Mapping[Difficulty, int] = {"easy": 66, "medium": 135, "hard": 205}
"""The longest text of a scene, without its question."""
PRISM_WORDS = 25
"""Words more for scenes that else have no room for a prism."""
SECOND_BODY_WORDS = 18
"""Words more for easy scenes that are always of two entities."""

NUMBERS: Mapping[Difficulty, Mapping[str, Choice]] = {
    "easy": {
        "mass": Range(0.5, 3.0),
        "pulley mass": Range(0.1, 3.0),
        "friction": Range(0.2, 0.6),
        "angle": Range(25.0, 39.0),
        "blocks": Count(1, 1),
        "left_blocks": Count(1, 1),
        "right_blocks": Count(1, 1),
    },
    "medium": {
        "mass": Range(1.0, 8.0),
        "pulley mass": Range(0.2, 8.0),
        "friction": Range(0.2, 0.5),
        "angle": Range(25.0, 65.0),
        "blocks": Count(1, 1),  # blocks that move as one add nothing but a sum of masses
        "left_blocks": Count(1, 1),
        "right_blocks": Count(1, 2),
    },
    "hard": {
        "mass": Range(2.0, 20.0),
        "pulley mass": Range(0.5, 20.0),
        "friction": Range(0.15, 0.4),
        "angle": Range(25.0, 65.0),
        "blocks": Count(1, 2),
        "left_blocks": Count(1, 2),
        "right_blocks": Count(1, 2),
    },
}

SIZES: Mapping[str, Choice] = {
    "UniformRod.length": Range(0.4, 1.2),
    "Bar.length": Range(0.4, 0.9),
    "Bar.width": Range(0.15, 0.3),
    "radius": Range(0.08, 0.2),
    "height": Range(0.2, 0.5),
    "SphericalCap.height": Range(0.06, 0.15),
    "hole": Range(0.05, 0.1),
    "offset": Range(0.05, 0.1),
    "RoundPiece.body": ("Sphere", "SphericalShell"),  # the thickness of a wall would hardly count
    "CappedPiece.body": ("Hemisphere", "SphericalCap"),
    "HoledPiece.body": ("SphereWithHole",),
}
"""Pieces of what swings, so large that their moments of inertia about their own centres count."""
