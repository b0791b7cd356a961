"""Files of JSON lines with prompts and completions, parsed strictly with a limit on line length."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Final, cast

from sim2reason.errors import TrainingError
from sim2reason.training.corpora import Row

__all__ = ["rows_in"]

LONGEST: Final = 2**24  # bytes of a line


def rows_in(path: Path, prompt: str = "prompt", completion: str = "completion") -> Iterator[Row]:
    """Yield the row in each line of a file, by the names of its two fields; empty lines are skipped.

    Raises:
        TrainingError: no such file, or a line that holds no such texts; it names the line.
    """
    if not path.is_file():
        raise TrainingError(f"{path}: no such file; say where the corpus lies")
    with path.open("rb") as file:
        for count, line in enumerate(iter(lambda: file.readline(LONGEST + 1), b""), start=1):
            if len(line) > LONGEST:
                raise TrainingError(f"{path}:{count}: more than {LONGEST} bytes; a line is one row")
            if line.strip():
                place = f"{path}:{count}"
                held = _object(line, place)
                yield Row(_text(held, prompt, place), _text(held, completion, place))


def _object(line: bytes, place: str) -> dict[str, object]:
    try:
        found = json.loads(line)
    except (ValueError, RecursionError) as error:
        raise TrainingError(f"{place}: no JSON: {' '.join(str(error).split())[:120]}; a line is one object") from None
    if not isinstance(found, dict):
        raise TrainingError(f"{place}: no object; a line is one, with a prompt and a completion")
    return cast("dict[str, object]", found)


def _text(held: dict[str, object], name: str, place: str) -> str:
    """Return a nonempty text field, with unpaired surrogates replaced."""
    found = held.get(name)
    if not isinstance(found, str) or not found.strip():
        raise TrainingError(f"{place}: its field {name[:80]!r} is no text; name the fields of the file")
    return found.encode(errors="replace").decode()
