"""Input and output files of commands: scenes to read, and results written atomically.

Scenes are read from a file or from standard input. Results are never written through a link or over a special file.
"""

import os
import sys
import warnings
from collections.abc import Callable, Generator
from contextlib import contextmanager, suppress
from itertools import count
from pathlib import Path
from shutil import copyfileobj
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

import click

from sim2reason.cli import console
from sim2reason.errors import FigureWarning, SceneError

if TYPE_CHECKING:  # scenes are loaded where one is read, so that --help is fast
    from sim2reason.scenes.dsl.scene import Scene

STDIN = STDOUT = Path("-")


def text(path: Path) -> str:
    """Return the content of a scene file or, for ``-``, of standard input; SceneError if too large or not UTF-8."""
    from sim2reason.base.yaml_text import MAX_BYTES
    from sim2reason.scenes.files import decode_file

    try:
        if path == STDIN:
            return decode_file(sys.stdin.buffer.read(MAX_BYTES + 1))
        with path.open("rb") as file:
            return decode_file(file.read(MAX_BYTES + 1))
    except SceneError as error:
        raise _error_in_file(path, error) from None


def scene(path: Path, content: str | None = None) -> "Scene":
    """Return the scene of a file, or of its `content` if already read; errors name the file."""
    from sim2reason.scenes.files import loads

    content = text(path) if content is None else content
    try:
        return loads(content)
    except SceneError as error:
        raise _error_in_file(path, error) from None


def _error_in_file(path: Path, error: SceneError) -> SceneError:
    name = "standard input" if path == STDIN else str(path)
    return SceneError(f"{name}: {error.place}", error.problem, error.remedy)


def tell(text: str, out: Path | None) -> None:
    """Write a text to a file, or to standard output for None or a dash."""
    if out in (None, STDOUT):
        click.echo(text, nl=False)
        return
    with written(out) as path:
        path.write_text(text, encoding="utf-8", newline="\n")


@contextmanager
def written(out: Path) -> Generator[Path, None, None]:
    """Return a context with the path of a temporary file that becomes `out` on success.

    It is beside `out` under a unique name, so a kill loses nothing. Special files, such as devices and pipes, are
    written directly. OSError names `out`.
    """
    if out == STDOUT:
        raise click.UsageError("-: what is written is no text for standard output; give it a file.")
    try:
        if out.exists() and not out.is_file():
            with _spooled(out) as path:
                yield path
            return
        path = _new(out)
        try:
            yield path
            path.replace(out)
        finally:
            path.unlink(missing_ok=True)
    except OSError as error:
        error.filename, error.filename2 = str(out), None
        raise


@contextmanager
def lines(out: Path | None) -> Generator[Callable[[str], object], None, None]:
    """Return a context with a function that writes lines to the file `out`; for None the function does nothing."""
    if out is None:
        yield lambda _: None
    elif out == STDOUT:
        yield click.echo
    else:
        with written(out) as path, path.open("w", encoding="utf-8", newline="\n") as file:
            yield lambda line: file.write(f"{line}\n")


@contextmanager
def warnings_told() -> Generator[None, None, None]:
    """Print the warnings of the block on stderr, one line each."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", FigureWarning)
        yield
    for warning in caught:
        console.explain(f"sim2reason: warning: {warning.message}")


def _new(out: Path) -> Path:
    """Return the path of a new empty file beside `out`."""
    for number in count():
        path = out.with_name(f".sim2reason-{os.getpid()}-{number}{out.suffix}")
        with suppress(FileExistsError):
            os.close(os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o666))
            return path
    raise AssertionError


@contextmanager
def _spooled(out: Path) -> Generator[Path, None, None]:
    """Return a context with a temporary file whose content is written to a stream at the end."""
    with TemporaryDirectory() as folder:
        path = Path(folder) / f"whole{out.suffix}"
        path.touch()
        yield path
        with path.open("rb") as source, out.open("wb") as stream:
            copyfileobj(source, stream)
