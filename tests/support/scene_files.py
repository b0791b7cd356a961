"""Random scenes, and ways to corrupt their files."""

import copy
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import yaml

from sim2reason.base.yaml_text import write
from sim2reason.errors import SceneError
from sim2reason.generation.recipes import RECIPES
from sim2reason.questions.difficulty import DIFFICULTIES
from sim2reason.scenes.dsl.entity import ENTITIES
from sim2reason.scenes.dsl.model import draw
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.files import dump, to_plain
from sim2reason.scenes.files.sections import directions

Rng = np.random.Generator
REQUIRED = ("tail", "top")
KINDS = (  # pinned: what a seed stands for must not change when an entity is added
    "MassPrismPlane",
    "MassWithFixedPulley",
    "MassWithMovablePulley",
    "MassWithReverseMovablePulley",
    "TwoDCollisionPlane",
    "TwoSideMassPlane",
)
CLOSERS = ("FixedSupport", "ConstantForcePuller")


def drawn(count: int, seed: int = 0) -> Iterator[Scene]:
    """Yield random scenes, cycling through all recipes and difficulties."""
    kinds = [(recipe, difficulty) for recipe in RECIPES for difficulty in DIFFICULTIES]
    made = 0
    for attempt in range(20 * count):
        recipe, difficulty = kinds[attempt % len(kinds)]
        try:
            yield RECIPES[recipe](difficulty, np.random.default_rng([seed, attempt]))
        except SceneError:
            continue
        made += 1
        if made == count:
            return


def composed(rng: Rng) -> dict[str, Any]:
    """Return the data of a scene file with random entities whose ends are joined at random and all closed."""
    entities = [_entity(KINDS[rng.integers(len(KINDS))], f"e{n}", rng) for n in range(rng.integers(1, 4))]
    ends = [
        {"entity": entity["name"], "direction": direction}
        for entity in entities
        for direction, point in directions(ENTITIES[entity["type"]])
        if not point and (direction in REQUIRED or "Reverse" in entity["type"] or rng.random() < 0.8)
    ]
    rng.shuffle(ends)
    connections: list[Any] = []
    while ends:
        one = ends.pop()
        others = [end for end in ends if end["entity"] != one["entity"]]
        if others and rng.random() < 0.5:
            other = others[rng.integers(len(others))]
            ends.remove(other)
        else:
            closer = _entity(CLOSERS[rng.integers(2)], f"c{len(entities)}", rng)
            entities.append(closer)
            other = {"entity": closer["name"], "direction": "end"}
        connections.append({"tendon": [one, other]})
    return {"scene": {"entities": entities, "connections": connections}}


def _entity(kind: str, name: str, rng: Rng) -> dict[str, Any]:
    choices = {"friction": float(rng.choice([0.0, 0.3])), "mass?": 0.5, "load?": 0.5, "speed?": 0.3}
    for _ in range(100):
        try:
            entity = draw(ENTITIES[kind], rng, choices)
        except ValueError:  # pucks that overlap
            continue
        return {"name": name, "type": kind, "parameters": to_plain(entity)}
    raise AssertionError(kind)


# ---- spoiling data

VALUES = (
    *(None, True, "yes", "", "NaN", "1.0", "\N{SNOWMAN}", [], {}, [1.0], {"kind": "hanging"}, {"mass": 1}),
    *(0, -1, 0.0, -0.0, 1e-300, 1e300, -2.5, 89.99999999, 1e6, 10**30, 7, 1e-6, 2, 1),
)


def _places(data: object) -> list[tuple[Any, Any]]:
    """Return every container with each of its keys."""
    found: list[tuple[Any, Any]] = []
    for key in list(data) if isinstance(data, dict) else range(len(data)) if isinstance(data, list) else ():
        found.append((data, key))
        found.extend(_places(data[key]))
    return found


def _pick(data: object, rng: Rng) -> tuple[Any, Any]:
    places = _places(data)
    return places[rng.integers(len(places))]


def _delete(data: object, rng: Rng) -> None:
    held, key = _pick(data, rng)
    del held[key]


def _replace(data: object, rng: Rng) -> None:
    held, key = _pick(data, rng)
    held[key] = copy.deepcopy(VALUES[rng.integers(len(VALUES))])


def _swap(data: object, rng: Rng) -> None:
    (one, key), (other, place) = _pick(data, rng), _pick(data, rng)
    one[key], other[place] = copy.deepcopy(other[place]), copy.deepcopy(one[key])


def _copy(data: object, rng: Rng) -> None:
    held, key = _pick(data, rng)
    value = copy.deepcopy(held[key])
    if isinstance(held, list):
        held.insert(key, value)
    else:
        held[f"{key}2"] = value


def _rename(data: object, rng: Rng) -> None:
    held, key = _pick(data, rng)
    if isinstance(held, dict):
        held[("x", "mass", "kind", "tendon", f"{key}s")[rng.integers(5)]] = held.pop(key)


def _scale(data: object, rng: Rng) -> None:
    """Multiply a number by a random factor, a change with which files most often still load."""
    numbers = [(held, key) for held, key in _places(data) if isinstance(held[key], float)]
    if numbers:
        held, key = numbers[rng.integers(len(numbers))]
        held[key] *= float(rng.choice([-1.0, 0.0, 1e-6, 1e-3, 0.5, 2.0, 10.0, 1e3, 1e6]))


DATA: tuple[Callable[[Any, Rng], None], ...] = (_delete, _replace, _swap, _copy, _rename, _scale, _scale, _scale)

# ---- spoiling text

JUNK = (
    *("&a ", "*a", "!!python/object:os.system ", "!x ", "<<: ", "? ", "%YAML 1.1\n", "---\n", "...\n", "- - - -"),
    *(
        "[" * 30,
        "{a: " * 30,
        "\x00",
        "\x07",
        "\N{SNOWMAN}",
        "\u2028",
        "\ufeff",
        "\t",
        "'",
        '"',
        "|\n",
        ">\n",
        "#",
        ": ",
    ),
    *("1_000", "0x10", "1:30", "2001-01-01", ".nan", ".inf", "-.inf", "yes", "1e999", "010", "9" * 5000, "a" * 5000),
)


def spoiled_text(text: str, rng: Rng) -> str:
    """Return a text with a line or some characters removed, doubled, moved or replaced by junk."""
    lines = text.splitlines(keepends=True)
    at, other = (int(rng.integers(len(lines))) for _ in range(2))
    match int(rng.integers(6)):
        case 0:
            del lines[at]
        case 1:
            lines.insert(other, lines[at])
        case 2:
            lines[at], lines[other] = lines[other], lines[at]
        case 3:
            lines[at] = "  " * int(rng.integers(1, 4)) + lines[at]
        case 4:
            start = int(rng.integers(len(text)))
            return text[:start] + text[start + int(rng.integers(1, 20)) :]
        case _:
            start = int(rng.integers(len(text)))
            return text[:start] + JUNK[rng.integers(len(JUNK))] + text[start:]
    return "".join(lines)


def spoiled(seed: int, scenes: list[Scene]) -> str:
    """Return a corrupted scene file, recorded or composed at random, with one to three changes."""
    rng = np.random.default_rng([seed, 77])
    data = composed(rng) if rng.random() < 0.3 else yaml.safe_load(dump(scenes[rng.integers(len(scenes))]))
    in_text = rng.random() < 0.4
    for _ in range(0 if in_text else rng.integers(1, 3)):
        if _places(data):
            DATA[rng.integers(len(DATA))](data, rng)
    text = write(data)
    return spoiled_text(text, rng) if in_text and text.strip() else text
