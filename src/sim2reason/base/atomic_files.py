"""Atomic writing of files, checksums, and locks of folders."""

import fcntl
import hashlib
import json
import os
from collections.abc import Callable, Generator
from contextlib import contextmanager, suppress
from pathlib import Path

from sim2reason.errors import DatasetError

TEMPORARY, LOCK = ".tmp", ".lock"
FOLDER = ".sim2reason"
"""Where a folder that is being filled keeps what the next run needs to go on."""


def write_atomically(path: Path, write: Callable[[Path], object], scratch: Path) -> None:
    """Write a file atomically: `write` fills a temporary file in `scratch`, which is then renamed to `path`.

    If the process is killed, the old file, the new one or none exists. OSError names the file that could not be
    written; errors leave no partial file.
    """
    temporary = scratch / f"{path.name}.{os.getpid()}{TEMPORARY}"
    try:
        write(temporary)
        sync(temporary)
        path.parent.mkdir(exist_ok=True)
        temporary.replace(path)
        sync(path.parent)
    except BaseException as error:
        temporary.unlink(missing_ok=True)
        if isinstance(error, OSError) and error.filename in (None, str(temporary)):
            error.filename, error.filename2 = str(path), None
        raise


def put_text(path: Path, text: str, scratch: Path) -> None:
    """Write a text file atomically."""
    write_atomically(path, lambda temporary: temporary.write_text(text, encoding="utf-8", newline="\n"), scratch)


def remove_temporaries(scratch: Path) -> None:
    """Remove the temporary files of killed runs from a folder that no other process uses."""
    for suffix in (TEMPORARY, LOCK):
        for path in scratch.glob(f"*{suffix}"):
            path.unlink(missing_ok=True)


def sync(path: Path) -> None:
    """Flush a file or folder to disk, so that it survives a loss of power."""
    handle = os.open(path, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def checksum(path: Path) -> str:
    """Return the SHA-256 of a file, in hexadecimal; empty if the file does not exist."""
    if not path.is_file():
        return ""
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def canonical(value: object) -> str:
    """Return a value as canonical JSON: sorted keys, two spaces of indentation, one final line feed."""
    return json.dumps(value, indent=2, sort_keys=True, ensure_ascii=False, allow_nan=False) + "\n"


@contextmanager
def lock_folder(place: Path, *, shared: bool = False) -> Generator[None, None, None]:
    """Lock a folder while the block runs, exclusively, or with other shared holders only.

    The lock ends with the process in any case. DatasetError if another run holds it.
    """
    handle = os.open(place, os.O_RDONLY)
    try:
        try:
            fcntl.flock(handle, (fcntl.LOCK_SH if shared else fcntl.LOCK_EX) | fcntl.LOCK_NB)
        except BlockingIOError:
            raise DatasetError(f"{place}: another run is writing here; wait for it or choose another folder") from None
        yield
    finally:
        os.close(handle)


@contextmanager
def lock_work_folder(place: Path) -> Generator[None, None, None]:
    """Create and lock a folder while the block runs; remove it afterwards if it was created here and stays empty.

    DatasetError if another run holds the lock.
    """
    made = [folder for folder in (place, *place.parents) if not folder.exists()]
    place.mkdir(parents=True, exist_ok=True)
    try:
        with lock_folder(place):
            yield
    finally:
        for folder in made:
            with suppress(OSError):  # it holds something
                folder.rmdir()
