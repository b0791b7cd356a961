"""The pictures beside the card of a dataset: their names, their bytes, and how they come and go."""

from collections.abc import Iterator, Mapping, Sequence
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from sim2reason.base.atomic_files import checksum, put
from sim2reason.datasets.examples import Example
from sim2reason.datasets.histograms import SHOWN, Counted, histogram
from sim2reason.errors import MissingExtraError
from sim2reason.figures.histogram import png

FIGURES = "figures"
"""The folder of all pictures."""
PACKAGE = "matplotlib"


def of_histogram(name: str) -> str:
    """Return the file of a histogram."""
    return f"{FIGURES}/{name}.png"


def of_example(number: int) -> str:
    """Return the file of an example's figure, counted from 1."""
    return f"{FIGURES}/example-{number}.png"


def drawn_by() -> str:
    """Return the package that draws, with its version, which decides about the bytes; empty without one."""
    try:
        return f"{PACKAGE} {version(PACKAGE)}"
    except PackageNotFoundError:
        return ""


def put_pictures(
    out: Path, scratch: Path, histograms: Mapping[str, Counted], examples: Sequence[Example]
) -> tuple[str, ...]:
    """Write the pictures of a dataset, and give their names; none where no package is there to draw."""
    try:
        found = dict(_pictures(histograms, examples))
    except MissingExtraError:
        return ()
    for name, data in found.items():
        put(out / name, lambda path, data=data: path.write_bytes(data), scratch)
    return tuple(found)


def _pictures(histograms: Mapping[str, Counted], examples: Sequence[Example]) -> Iterator[tuple[str, bytes]]:
    for name in SHOWN:
        if histograms.get(name):
            yield of_histogram(name), png(histogram(name, histograms[name]))
    for number, example in enumerate(examples, start=1):
        if example.picture is not None:
            yield of_example(number), example.picture


def remove_pictures(out: Path, files: Mapping[str, str]) -> None:
    """Remove those that a manifest lists among its `files`, if they still are as it says."""
    ours = [name for name in files if Path(name).parent == Path(FIGURES) and checksum(out / name) == files[name]]
    for name in ours:
        (out / name).unlink()
    if ours and not any((out / FIGURES).iterdir()):
        (out / FIGURES).rmdir()
