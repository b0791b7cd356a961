"""Scenes like another one but for some numbers, and what a text says of its numbers."""

from collections.abc import Mapping
from typing import Any, cast

import numpy as np
from pydantic import ValidationError

from sim2reason.errors import SceneError, SimulationError, UnsupportedError
from sim2reason.questions import Study
from sim2reason.scenes.dsl.body import Body
from sim2reason.scenes.dsl.entity import Part
from sim2reason.scenes.dsl.model import Model, Parameter, rebuilt
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.text.prose.description import describe
from sim2reason.text.prose.voices import numeric


def changed(scene: Scene, numbers: Mapping[str, float]) -> Scene | None:
    """Return a scene with several numbers changed at once, by address; None if that can not be."""
    try:
        entities = tuple(rebuilt(n, entity=_with(n.entity, n.name, numbers)) for n in scene.entities)
        joined = tuple(_with(c, f"{c.key}_{i}", numbers) for i, c in enumerate(scene.connections, 1))
        return rebuilt(scene, entities=entities, connections=joined, world=_with(scene.world, "world", numbers))
    except (SceneError, ValidationError):
        return None


def _with(value: Any, address: str, numbers: Mapping[str, float]) -> Any:  # noqa: ANN401 - a field holds anything
    if address in numbers:
        return numbers[address]
    if isinstance(value, tuple):
        held = cast("tuple[Any, ...]", value)
        return tuple(_with(member, f"{address}.{index}", numbers) for index, member in enumerate(held))
    if not isinstance(value, Model) or not any(path.startswith(f"{address}.") for path in numbers):
        return value
    fields = {name: _with(getattr(value, name), f"{address}.{name}", numbers) for name in type(value).model_fields}
    return type(value)(**fields)


def studied(scene: Scene | None, duration: float) -> Study | None:
    """Return a scene with its motion; None if it has none."""
    if scene is None:
        return None
    try:
        return Study.of(scene, np.array([0.0, duration]))
    except (SceneError, SimulationError, UnsupportedError):
        return None


def spoken(scene: Scene, seed: int = 0) -> dict[str, Parameter]:
    """Return the numbers that a text speaks as numbers, by address; what a word tells is not among them."""
    found: dict[str, Parameter] = {}

    def heard(parameter: Parameter, symbol: str) -> str:
        found[parameter.path] = parameter
        return numeric(parameter, symbol)

    describe(scene, seed, heard)
    return found


def told_by_word(scene: Scene, path: str) -> bool:
    """Return whether a word tells a number, as *smooth* tells a friction of zero."""
    owner, _, name = path.rpartition(".")
    body = scene.bodies.get(owner)
    if body is not None:
        return _worded(body, name) or body.told_by_word(name)
    part = scene.value(owner) if owner != "world" else None
    return isinstance(part, Part) and (_worded(part, name) or type(part).told_by_word(name, getattr(part, name)))


def _worded(value: Body | Part, name: str) -> bool:
    held = getattr(value, name)
    return any(word.parameter == name and held in word.special for word in value.words.values())
