"""Other spellings that files may use, those of the paper's figure, brought to this format's own.

    - name: entity1
      type: MassWithFixedPulley
      position: [0, 2, 0]
      parameters: {mass_type: Mass, mass_values: [10]}

The position is for looks only. The masses hang, lie on a plane or on a wedge: `mass_type` is `Mass` or one of the
kinds of this format, whose other keys may stand beside it. Pulleys of which nothing is said are light.
"""

import re
from collections.abc import Collection
from dataclasses import dataclass
from typing import NamedTuple

from sim2reason.dsl.entity import Entity
from sim2reason.dsl.model import Model, field_types
from sim2reason.errors import SceneError
from sim2reason.scene_files.schema import holders, snake
from sim2reason.scene_files.yaml_text import Plain, shown

HANGING = "Mass"
MASS_TYPE, MASS_VALUES = "mass_type", "mass_values"
LONGEST = 40  # letters of a name


@dataclass(frozen=True, slots=True)
class Respelled:
    """Parameters in this format's spelling, and where the file has what now stands elsewhere."""

    parameters: Plain
    places: dict[str, str]

    def in_file(self, place: str) -> str:
        """The path in the file of a path in the parameters."""
        for new, old in self.places.items():
            if place == new or place.startswith((f"{new}.", f"{new}[")):
                return old + place.removeprefix(new).removesuffix(".mass")
        return place


def plain_name(name: Plain) -> Plain:
    """A title such as ``Pulley System`` as a name, ``pulley_system``; what is none already is left as it is."""
    if not isinstance(name, str):
        return name
    return re.sub(r"[^a-z0-9]+", "_", name.lower()).strip("_")[:LONGEST] if re.search(r"[A-Z ]", name) else name


def check_position(position: Plain, place: str) -> None:
    """Three numbers, m; they are for looks, and nothing follows from them."""
    numbers = position if isinstance(position, list) else []
    if len(numbers) != 3 or not all(isinstance(n, int | float) and not isinstance(n, bool) for n in numbers):
        raise SceneError(place, f"it is {shown(position)}, not a place", "give three numbers, as [0, 2, 0]")


def respelled(cls: type[Entity], parameters: Plain, place: str) -> Respelled:
    """Parameters with the masses where the class has them."""
    if not isinstance(parameters, dict) or not {MASS_TYPE, MASS_VALUES} & set(parameters):
        return Respelled(parameters, {})
    held = holders(cls)
    if not held:
        key = MASS_VALUES if MASS_VALUES in parameters else MASS_TYPE
        raise SceneError(f"{place}.{key}", f"{cls.__name__} has no masses of a type", "give its own parameters")
    for name in held:
        if name in parameters:
            raise SceneError(f"{place}.{name}", f"{MASS_VALUES} says the same", "give one of the two")
    own = {key: value for key, value in parameters.items() if key in field_types(cls)}
    beside = {key: value for key, value in parameters.items() if key not in (*own, MASS_TYPE, MASS_VALUES)}
    kinds = _shared(parameters.get(MASS_TYPE, HANGING), len(held), f"{place}.{MASS_TYPE}")
    masses = _masses(parameters.get(MASS_VALUES), len(held), f"{place}.{MASS_VALUES}")
    known = {key for models in held.values() for model in models.values() for key in field_types(model)}
    places: dict[str, str] = {}
    for (name, models), kind, (told, values) in zip(held.items(), kinds, masses, strict=True):
        system = _system(models, kind, f"{place}.{MASS_TYPE}")
        fits = {key: value for key, value in beside.items() if key in system.keys or key not in known}
        own[name] = system.said | fits | {"blocks": _blocks(values)}
        places |= {f"{place}.{name}.blocks": told, f"{place}.{name}": place}
    light: dict[str, Plain] = {name: {} for name in field_types(cls) if name == "pulley" and name not in own}
    return Respelled({**own, **light}, places)


def _blocks(masses: list[Plain]) -> Plain:
    return [{"mass": mass} for mass in masses]


def _shared(value: Plain, count: int, place: str) -> list[str]:
    """One word for all systems, or a list with one for each."""
    words = value if isinstance(value, list) else [value] * count
    if len(words) != count:
        raise SceneError(place, f"it has {len(words)} members for {count} systems", "give one word, or one for each")
    for word in words:
        if not isinstance(word, str):
            raise SceneError(place, f"it is {shown(word)}, not a word", f"write {HANGING}, or a kind")
    return [str(word) for word in words]


def _masses(value: Plain, count: int, place: str) -> list[tuple[str, list[Plain]]]:
    """The masses of each system with the path in the file; of several systems each may be a number or a list."""
    if not isinstance(value, list):
        problem = "it is missing" if value is None else f"it is {shown(value)}, not a list"
        raise SceneError(place, problem, "list the masses in kg, as [10] or [2.0, 3.0]")
    if count == 1:
        return [(place, value)]
    if len(value) != count:
        problem = f"it has {len(value)} members for {count} systems"
        raise SceneError(place, problem, "give each its mass or a list of masses, as [1.0, [2.0, 3.0]]")
    return [(f"{place}[{i}]", one if isinstance(one, list) else [one]) for i, one in enumerate(value)]


class _System(NamedTuple):
    """The kind of a system as a file says it, and the keys that it has."""

    said: dict[str, Plain]
    keys: Collection[str]


def _system(models: dict[str, type[Model]], word: str, place: str) -> _System:
    kind = "hanging" if word == HANGING else snake(word)
    if kind not in models:
        raise SceneError(
            place, f"there is no type {shown(word)} here", f"give it one of: {HANGING}, {', '.join(models)}"
        )
    return _System({"kind": kind} if len(models) > 1 else {}, field_types(models[kind]))
