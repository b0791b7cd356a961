"""Input of the scene of a command, from a file or standard input."""

import sys
from pathlib import Path

from sim2reason.base.yaml_text import MAX_BYTES
from sim2reason.errors import SceneError
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.files import decoded, loads

STDIN = Path("-")


def text(path: Path) -> str:
    """Return the content of a scene file or, for ``-``, of standard input; SceneError if too large or not UTF-8."""
    try:
        if path == STDIN:
            return decoded(sys.stdin.buffer.read(MAX_BYTES + 1))
        with path.open("rb") as file:
            return decoded(file.read(MAX_BYTES + 1))
    except SceneError as error:
        raise _in_file(path, error) from None


def scene(path: Path, content: str | None = None) -> Scene:
    """Return the scene of a file, or of its `content` if already read; errors name the file."""
    content = text(path) if content is None else content
    try:
        return loads(content)
    except SceneError as error:
        raise _in_file(path, error) from None


def _in_file(path: Path, error: SceneError) -> SceneError:
    name = "standard input" if path == STDIN else str(path)
    return SceneError(f"{name}: {error.place}", error.problem, error.remedy)
