"""Numbers that a scene does not declare, such as the speed of a planet, whose velocity it declares by components."""

from collections import defaultdict
from collections.abc import Mapping
from math import hypot
from typing import NamedTuple

from sim2reason.errors import SceneError
from sim2reason.scenes.dsl.scene import Scene

VELOCITY, SPEED = "velocity", "speed"
NOWHERE = "a speed of zero has no direction"


class DerivedNumber(NamedTuple):
    """A speed, in `unit`, that a scene declares by the velocity components at the addresses `parts`."""

    path: str
    unit: str
    parts: tuple[str, ...]

    def value(self, scene: Scene) -> float:
        """Return the speed in a scene."""
        return hypot(*(float(scene.value(part) or 0.0) for part in self.parts))

    def at(self, scene: Scene, value: float) -> Mapping[str, float]:
        """Return the components of a velocity with another speed and the same direction; SceneError if all are zero."""
        now = self.value(scene)
        if not now:
            raise SceneError(self.path, NOWHERE, "change one of the components")
        return {part: float(scene.value(part) or 0.0) * value / now for part in self.parts}


def derived_numbers(scene: Scene) -> Mapping[str, DerivedNumber]:
    """Return all derived numbers of a scene by address, such as *system.planets.0.speed*."""
    parts = defaultdict[str, list[str]](list)
    units = dict[str, str]()
    for parameter in scene.parameters:
        if parameter.measure.noun == VELOCITY and parameter.value is not None:
            owner = parameter.path.rpartition(".")[0]
            parts[owner].append(parameter.path)
            units[owner] = parameter.measure.unit
    found = (DerivedNumber(f"{owner}.{SPEED}", units[owner], tuple(held)) for owner, held in parts.items())
    return {number.path: number for number in found}


def number_at(scene: Scene, path: str) -> float:
    """Return the value of the number at an address, which may be a derived one; zero where it is left out."""
    derived = derived_numbers(scene).get(path)
    return derived.value(scene) if derived is not None else float(scene.value(path) or 0.0)


def with_numbers(scene: Scene, values: Mapping[str, float]) -> Scene:
    """Return a scene with other values of some numbers, by address, derived numbers included."""
    derived: Mapping[str, DerivedNumber] = {}
    if any(path.endswith(f".{SPEED}") for path in values):
        derived = derived_numbers(scene)
    news = dict[str, float]()
    for path, value in values.items():
        news |= derived[path].at(scene, value) if path in derived else {path: value}
    return scene.having_all(news)


def with_number(scene: Scene, path: str, value: float) -> Scene:
    """Return a scene with another value of the number at an address, which may be a derived one."""
    return with_numbers(scene, {path: value})
