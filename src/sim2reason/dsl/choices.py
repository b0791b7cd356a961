"""Chances and special values with which a check or an example draws: everything optional half of the time."""

from collections.abc import Iterator

import numpy as np

from sim2reason.dsl.body import Body
from sim2reason.dsl.entity import Part
from sim2reason.dsl.model import Choice, Model, field_types

OPTIONAL = 0.5
SPECIAL = 0.2  # the chance of a value that a word tells, such as smooth or horizontal


def choices(cls: type[Model], rng: np.random.Generator) -> dict[str, Choice]:
    """Return random choices for one draw of a class and of all classes that it may hold."""
    found = chances(cls)
    for model in reachable(cls):
        for name, kind in field_types(model).items():
            special = specials(model, name)
            if kind.measure is not None and special and rng.random() < SPECIAL:
                found[f"{model.__name__}.{name}"] = special[int(rng.integers(len(special)))]
    return found


def chances(cls: type[Model]) -> dict[str, Choice]:
    """Return the chance that each optional field has a value, of a class and of all classes that it may hold."""
    return {
        f"{model.__name__}.{name}?": OPTIONAL
        for model in reachable(cls)
        for name, kind in field_types(model).items()
        if (kind.optional or not model.model_fields[name].is_required()) and (kind.drawn or kind.models or kind.words)
    }


def specials(model: type[Model], name: str) -> list[float]:
    """Return the values of a number that the text states by a word, such as 0 for *smooth*."""
    words = model.words.values() if issubclass(model, Body | Part) else ()
    return sorted(
        {value for word in words if word.parameter == name for value in word.special if isinstance(value, float)}
    )


def reachable(cls: type[Model]) -> list[type[Model]]:
    """Return a class and all classes that it may hold, each once."""
    found: list[type[Model]] = []
    waiting = [cls]
    while waiting:
        model = waiting.pop()
        if model not in found:
            found.append(model)
            waiting.extend(_held(model))
    return found


def _held(model: type[Model]) -> Iterator[type[Model]]:
    for kind in field_types(model).values():
        yield from kind.models
