"""The scene that a caller gives: itself, its file, its text, or a problem about it."""

from pathlib import Path
from typing import NamedTuple, Protocol, runtime_checkable

from sim2reason.dsl.scene import Scene
from sim2reason.scene_files.mapping import loads
from sim2reason.scene_files.source_text import source_text

__all__ = ["GivenScene", "SceneLike", "given_scene", "scene_of"]


@runtime_checkable
class AboutScene(Protocol):
    """What has a scene, or its YAML: an item, or a text that was read."""

    @property
    def scene(self) -> Scene | str:
        """The scene."""
        ...


SceneLike = Scene | Path | str | AboutScene
"""A scene, the path of its file, its YAML text, an item about it, or a text that was read."""


class GivenScene(NamedTuple):
    """A scene, and the text of its file; empty where there is none."""

    scene: Scene
    text: str = ""


def given_scene(source: SceneLike, function: str) -> GivenScene:
    """Return the scene that is given to a public `function`, and the text in which it stands.

    Raises:
        TypeError: something else is given.
        SceneError, OSError: as `load`.
    """
    if isinstance(source, Scene):
        return GivenScene(source)
    held = source.scene if isinstance(source, AboutScene) and not isinstance(source, type) else source
    if isinstance(held, Scene):
        return GivenScene(held)
    if isinstance(held, str | Path):
        text = source_text(held)
        return GivenScene(loads(text), text)
    raise TypeError(
        f"{function}() takes a scene, the path of its file, its YAML text or an item; "
        f"{type(source).__name__} is none of them"
    )


def scene_of(source: SceneLike, function: str) -> Scene:
    """Return the scene that is given to a public `function`; it raises what `given_scene` does."""
    return source if isinstance(source, Scene) else given_scene(source, function).scene
