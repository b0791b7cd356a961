"""Random entities, and assertions about their text, their file and the agreement of both engines."""

import numpy as np

import sim2reason
from lone_entities import alone
from sim2reason.errors import SceneError
from sim2reason.scenes.dsl.entity import Entity
from sim2reason.scenes.dsl.model import Choices, draw

TRIES = 50


def drawn_entity(cls: type[Entity], seed: int, choices: Choices) -> Entity:
    """Return a random valid entity; refused draws are repeated, as in recipes."""
    rng = np.random.default_rng(seed)
    for _ in range(TRIES):
        try:
            return draw(cls, rng, choices)
        except SceneError:
            continue
    raise AssertionError(f"nothing valid in {TRIES} draws of {cls.__name__}")


def travels(entity: Entity, seed: int) -> None:
    """Assert that the text and the file of an entity lead back to it."""
    scene = alone(entity)
    text = sim2reason.describe(scene, seed).text
    assert sim2reason.parse_scene(text).scene.entities[0].entity == entity, text
    assert sim2reason.load(sim2reason.dump(scene)) == scene


def certified(entity: Entity) -> float:
    """Return the fraction of the scene's horizon for which both engines agree."""
    scene = alone(entity)
    return sim2reason.certify(scene)[1].stable_until / scene.horizon
