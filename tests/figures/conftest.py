from itertools import product

import numpy as np
import pytest

from sim2reason.generation.item_search import sample as sample_scene
from sim2reason.generation.recipes import RECIPES
from sim2reason.questions.difficulty import DIFFICULTIES
from sim2reason.scenes.dsl.connection import CONNECTIONS, Link
from sim2reason.scenes.dsl.entity import ENTITIES, Named
from sim2reason.scenes.dsl.model import draw
from sim2reason.scenes.dsl.scene import Scene

Ends = list[tuple[str, str]]
HANGING, WEDGE = {"system": ("Hanging",)}, {"system": ("OnWedge",)}
JOINED: dict[str, tuple[list[tuple[str, str, dict]], list[Ends]]] = {
    "two wedges": (
        [("a", "MassWithFixedPulley", WEDGE), ("b", "MassWithFixedPulley", WEDGE)],
        [[("a", "tail"), ("b", "tail")]],
    ),
    "ramp, bight and hook": (
        [
            ("a", "TwoSideMassPlane", {}),
            ("m", "MassWithReverseMovablePulley", {"load?": 1.0}),
            ("h", "FixedSupport", {}),
        ],
        [[("a", "right"), ("m", "under"), ("h", "end")]],
    ),
    "movable pulley and prism": (
        [("a", "MassWithMovablePulley", {}), ("p", "MassPrismPlane", {})],
        [[("a", "top"), ("p", "left")]],
    ),
    "movable pulley over wedges": (
        [
            ("a", "MassWithMovablePulley", {"left": ("OnWedge",), "right": ("OnWedge",)}),
            ("b", "MassWithFixedPulley", HANGING),
        ],
        [[("a", "top"), ("b", "tail")]],
    ),
    "two movable pulleys": (
        [
            ("a", "MassWithMovablePulley", {"left": ("Hanging",), "right": ("Hanging",)}),
            ("b", "MassWithMovablePulley", {"left": ("Hanging",), "right": ("OnPlane",)}),
        ],
        [[("a", "top"), ("b", "top")]],
    ),
    "prism, hand and load": (
        [("p", "MassPrismPlane", {}), ("a", "MassWithFixedPulley", HANGING), ("h", "ConstantForcePuller", {})],
        [[("p", "right"), ("a", "tail")], [("p", "left"), ("h", "end")]],
    ),
    "ramp between loads": (
        [("r", "TwoSideMassPlane", {}), ("a", "MassWithFixedPulley", HANGING), ("b", "MassWithFixedPulley", WEDGE)],
        [[("r", "right"), ("a", "tail")], [("r", "left"), ("b", "tail")]],
    ),
    "pucks": ([("t", "TwoDCollisionPlane", {})], []),
}


def joined(name: str, seed: int) -> Scene:
    rng = np.random.default_rng(seed)
    parts, strings = JOINED[name]
    entities = tuple(Named(name=n, entity=draw(ENTITIES[kind], rng, choices)) for n, kind, choices in parts)
    links = [tuple(Link(entity=entity, port=port) for entity, port in ends) for ends in strings]
    return Scene(entities=entities, connections=tuple(CONNECTIONS["tendon"](links=ends) for ends in links))


@pytest.fixture(scope="session", params=[1, pytest.param(3, marks=pytest.mark.slow)])
def scenes(request: pytest.FixtureRequest) -> list[Scene]:
    """Return random scenes of every recipe and difficulty, and entities joined in ways that no recipe draws."""
    random = [sample_scene(r, d, seed=5, index=n) for r, d, n in product(RECIPES, DIFFICULTIES, range(request.param))]
    return [*random, *(joined(name, seed) for name in JOINED for seed in range(2))]
