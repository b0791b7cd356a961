"""The text of a scene, given directly or in a file, read only up to the size limit of a scene."""

import re
from pathlib import Path

from sim2reason.base.yaml_text import MAX_BYTES
from sim2reason.errors import SceneError

__all__ = ["decoded", "source_text"]

_PATH = re.compile(r"[^\n\0{\[]*\.(?:yaml|yml|json)")


def source_text(source: str | Path) -> str:
    """Return a scene's text, given directly or read from a file up to the size limit; errors as in `load`."""
    if isinstance(source, str) and not _PATH.fullmatch(source):
        return source
    with Path(source).open("rb") as file:
        return decoded(file.read(MAX_BYTES + 1))


def decoded(data: bytes) -> str:
    """Return the text of a file's bytes; raise SceneError if they are too many or not UTF-8."""
    if len(data) > MAX_BYTES:
        raise SceneError("the file", f"it has more than {MAX_BYTES} bytes", "give a smaller scene")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        raise SceneError(f"line {line}", "the file is not UTF-8", "save it as UTF-8") from None
