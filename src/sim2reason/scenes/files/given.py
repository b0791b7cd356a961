"""Conversion of arguments of public functions to scenes: objects, file paths, YAML texts or problems."""

from pathlib import Path
from typing import NamedTuple, Protocol, runtime_checkable

from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.files.mapping import loads
from sim2reason.scenes.files.source_text import source_text

__all__ = ["GivenScene", "SceneLike", "given_scene", "scene_of"]


@runtime_checkable
class AboutScene(Protocol):
    """An object with a scene or the scene's YAML text: an item, or a parsed text."""

    @property
    def scene(self) -> Scene | str:
        """Return the scene, or its YAML text."""
        ...


SceneLike = Scene | Path | str | AboutScene
"""A scene, the path of its file, its YAML text, an item about it, or a parsed text."""


class GivenScene(NamedTuple):
    """A scene, and the text of its file; the text is empty if there is none."""

    scene: Scene
    text: str = ""


def given_scene(source: SceneLike, function: str) -> GivenScene:
    """Return the scene passed to the public `function`, with the text of its file.

    Raises:
        TypeError: `source` is none of the types in `SceneLike`.
        SceneError, OSError: as in `load`.
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
    """Return the scene passed to the public `function`; errors as in `given_scene`."""
    return source if isinstance(source, Scene) else given_scene(source, function).scene
