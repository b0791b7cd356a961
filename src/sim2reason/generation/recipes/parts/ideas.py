"""Recipes of a single entity: ideas with narrower ranges, and a check that numbers matter."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any, TypeVar

import numpy as np
from pydantic import ValidationError

from sim2reason.errors import SceneError
from sim2reason.scenes.dsl.addresses import with_values, without_idle_fields
from sim2reason.scenes.dsl.entity import ENTITIES, Named
from sim2reason.scenes.dsl.model import Choice, Choices, Model, Parameter, draw, parameters
from sim2reason.scenes.dsl.scene import Scene

FACTORS, TURNS = (2.0, 0.5), (10.0, -10.0)  # a number is halved and doubled; an angle is changed by these degrees
MIN_RESPONSE_CHANGE = (
    0.12  # relative change of a response; smaller ones may stay within the tolerance after a square root
)
V = TypeVar("V", bound=Model)


def idle_numbers(
    value: V, response: Callable[[V], Sequence[float]], least: float = MIN_RESPONSE_CHANGE
) -> Iterator[str]:
    """Yield the addresses of numbers whose halving and doubling changes every response by less than `least`."""
    before = response(value)
    for number in parameters(value):
        if (
            number.value
            and not number.hidden
            and not any(
                abs(new - old) > least * abs(old)
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


REDRAWS = 200  # of scenes that do not fit an idea


@dataclass(frozen=True)
class Idea:
    """A specification of random scenes of one entity: ranges and parts to draw, a condition, and a weight."""

    entity: str
    choices: Choices = field(default_factory=dict[str, Choice])
    weight: float = 1.0
    suits: Callable[[Any], bool] = lambda _: True  # whether all of a drawn entity has a bearing on what it does


def one_of(ideas: Sequence[Idea], rng: np.random.Generator, name: str) -> Scene:
    """Return a scene of one entity, named `name`, drawn by a random idea.

    Raises:
        SceneError: the draw does not hold together, or nothing that was drawn suits the idea.
    """
    weights = np.array([idea.weight for idea in ideas])
    idea = ideas[int(rng.choice(len(ideas), p=weights / weights.sum()))]
    for _ in range(REDRAWS):
        entity = draw(ENTITIES[idea.entity], rng, idea.choices)
        if idea.suits(entity):
            return Scene(entities=without_idle_fields((Named(name=name, entity=entity),), ()))
    raise SceneError(idea.entity, f"none of {REDRAWS} draws suits what the recipe is about", "widen a range")
