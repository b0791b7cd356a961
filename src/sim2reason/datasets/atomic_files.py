"""Files that are there whole or not at all, checksums, and the lock of a folder."""

import fcntl
import hashlib
import json
import os
from collections.abc import Callable, Generator
from contextlib import contextmanager
from pathlib import Path

from sim2reason.errors import DatasetError


def put(path: Path, write: Callable[[Path], object]) -> None:
    """Let `write` fill a temporary file, then give it its name: a kill leaves the old file, the new or none."""
    temporary = path.with_name(f".{path.name}.tmp")
    write(temporary)
    sync(temporary)
    temporary.replace(path)
    sync(path.parent)


def put_text(path: Path, text: str) -> None:
    """Put a text file."""
    put(path, lambda temporary: temporary.write_text(text, encoding="utf-8", newline="\n"))


def sweep(folder: Path) -> None:
    """Remove the temporary files that a kill left behind."""
    for path in folder.glob(".*.tmp"):
        path.unlink()


def sync(path: Path) -> None:
    """Make a file's content, or a folder's names, survive a loss of power."""
    handle = os.open(path, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def checksum(path: Path) -> str:
    """The SHA-256 of a file, in hexadecimal; empty if it is not there."""
    if not path.is_file():
        return ""
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def canonical(value: object) -> str:
    """JSON with one spelling: sorted keys, two spaces, one line feed at the end."""
    return json.dumps(value, indent=2, sort_keys=True, ensure_ascii=False, allow_nan=False) + "\n"


@contextmanager
def locked(folder: Path) -> Generator[None, None, None]:
    """Keep a second run out of `folder` while the block runs; the lock ends with the process, however it ends."""
    handle = os.open(folder, os.O_RDONLY)
    try:
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise DatasetError(f"{folder}: another run is writing here; wait for it or choose another folder") from None
        yield
    finally:
        os.close(handle)
