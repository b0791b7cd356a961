"""Recipes of one entity: ideas that narrow how it is drawn, and numbers that have to matter."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any, TypeVar

import numpy as np
from pydantic import ValidationError

from sim2reason.errors import SceneError
from sim2reason.scenes.dsl.addresses import changed, vacated
from sim2reason.scenes.dsl.entity import ENTITIES, Named
from sim2reason.scenes.dsl.model import Choice, Choices, Model, Parameter, draw, parameters
from sim2reason.scenes.dsl.scene import Scene

FACTORS, TURNS = (2.0, 0.5), (10.0, -10.0)  # a number is halved and doubled, an angle in degrees turned either way
LEAST = 0.12  # of a response: less may move a speed, which goes with a root, by less than its tolerance
V = TypeVar("V", bound=Model)


def idle(value: V, response: Callable[[V], Sequence[float]], least: float = LEAST) -> Iterator[str]:
    """Yield the addresses of the numbers that move none of the responses of an entity by `least`, relative."""
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
    """Yield the same with a number halved and doubled, as far as it is valid then."""
    assert number.value is not None
    turned = number.measure.unit == "deg"
    for new in (number.value + turn for turn in TURNS) if turned else (number.value * factor for factor in FACTORS):
        try:
            yield changed(value, {number.path: new})
        except (ValidationError, SceneError):
            continue


REDRAWS = 200  # of what does not suit an idea


@dataclass(frozen=True)
class Idea:
    """What a problem is about: the type of its entity, what its numbers and parts are drawn from, and how often."""

    entity: str
    choices: Choices = field(default_factory=dict[str, Choice])
    weight: float = 1.0
    suits: Callable[[Any], bool] = lambda _: True  # whether all of a drawn entity has a bearing on what it does


def one_of(ideas: Sequence[Idea], rng: np.random.Generator, name: str) -> Scene:
    """Return a scene of one entity, called `name` in its file, drawn by one of the ideas.

    Raises:
        SceneError: the draw does not hold together, or nothing that was drawn suits the idea.
    """
    weights = np.array([idea.weight for idea in ideas])
    idea = ideas[int(rng.choice(len(ideas), p=weights / weights.sum()))]
    for _ in range(REDRAWS):
        entity = draw(ENTITIES[idea.entity], rng, idea.choices)
        if idea.suits(entity):
            return Scene(entities=vacated((Named(name=name, entity=entity),), ()))
    raise SceneError(idea.entity, f"none of {REDRAWS} draws suits what the recipe is about", "widen a range")
