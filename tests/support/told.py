"""Checks for tests of entities that their texts lead back to the same scene."""

from collections.abc import Iterator

import numpy as np

from sim2reason.errors import DrawError, SceneError, TextError
from sim2reason.scenes.dsl.entity import Entity, Named
from sim2reason.scenes.dsl.model import draw
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.files import dump, load
from sim2reason.simulation.scenes import certify
from sim2reason.text.parsing import parse_scene
from sim2reason.text.parsing.equivalence import Signature, signature
from sim2reason.text.parsing.sentences import split_pieces
from sim2reason.text.prose.description import Description, describe


def scene_of(entity: Entity) -> Scene:
    """Return a scene of one entity."""
    return Scene(entities=(Named(name="it", entity=entity),))


def drawn(kind: type[Entity], count: int, seed: int = 0) -> Iterator[Scene]:
    """Yield `count` random scenes of one entity, by its own ranges."""
    index = 0
    while count:
        try:
            yield scene_of(draw(kind, np.random.default_rng([seed, index]), {}))
            count -= 1
        except (DrawError, SceneError):
            pass
        index += 1


def check_told(scene: Scene, seed: int) -> None:
    """Assert that the text and the file of a scene lead back to it."""
    description = describe(scene, seed)
    assert understood(description.text) == meaning(description), description.text
    assert load(dump(scene)) == scene


def check_whole(scene: Scene, seed: int) -> None:
    """Assert that a text without any one sentence or table row has another meaning or none."""
    description = describe(scene, seed)
    for text in shortened(list(split_pieces(description.text))):
        try:
            found = understood(text)
        except TextError:
            continue
        assert found != meaning(description), text


def certified(scene: Scene) -> bool:
    """Return whether both engines agree on the whole motion."""
    _, certificate = certify(scene)
    whole = certificate.stable_until >= 0.999 * scene.horizon
    return whole and max(certificate.agreement.values()) <= certificate.tolerance


def meaning(description: Description) -> Signature:
    """Return the signature of a scene with the names of its text."""
    return signature(description.scene, {address: description.mention(address) for address in description.scene.bodies})


def understood(text: str) -> Signature:
    """Return the signature of the scene that a text describes."""
    reading = parse_scene(text)
    return signature(reading.scene, {address: name for name, address in reading.names.items()})


def shortened(parts: list[str]) -> Iterator[str]:
    """Yield the text without each of its sentences and each row of its table."""
    for index, part in enumerate(parts):
        yield _together(parts[:index] + parts[index + 1 :]) or " "
        rows = part.split("\n")
        for number in range(len(rows)) if len(rows) > 1 else ():
            fewer = "\n".join(rows[:number] + rows[number + 1 :])
            yield _together([*parts[:index], fewer, *parts[index + 1 :]])


def _together(parts: list[str]) -> str:
    return "".join(f"\n\n{part}\n\n" if part.startswith("|") else f" {part}" for part in parts).strip()
