"""Tests of exports with their own libraries; `make test-exports` runs each file with its library installed."""

import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

import readme
import sim2reason
from sim2reason import rewards
from sim2reason.datasets.dataset import Dataset
from sim2reason.generation.item import Item

PAGES = Path(__file__).parents[4] / "docs/integrations"
LEAST = 100  # rows that each library must load and grade
REAL = "SIM2REASON_PROBLEMS"


@pytest.fixture(scope="session")
def real(problems: Path) -> Path:
    """Return the dataset that `make test-exports` has generated, or else the small one of the other tests."""
    return Path(os.environ.get(REAL) or problems)


@pytest.fixture(scope="session")
def items(real: Path) -> dict[str, Item]:
    """Return all problems by their ids."""
    found = {item.id: item for item in Dataset(real)}
    assert len(found) >= LEAST
    return found


@pytest.fixture
def exported(real: Path, tmp_path: Path) -> Callable[[str], Path]:
    """Return a function that writes an export and returns its folder."""
    return lambda to: sim2reason.export(real, tmp_path / to, to=to).folder


def _right(item: Item) -> str:
    """Return a response with the right answer."""
    return f"First I draw the forces. So the answer is $\\boxed{{{rewards.answered(item)}}}$."


def _wrong(item: Item) -> Iterator[str]:
    """Yield responses with the item's wrong answers."""
    return (f"Easy: $\\boxed{{{distractor.value:.6g}}}$." for distractor in item.distractors)


@pytest.fixture(scope="session")
def right() -> Callable[[Item], str]:
    return _right


@pytest.fixture(scope="session")
def wrong() -> Callable[[Item], Iterator[str]]:
    return _wrong


@pytest.fixture
def follow(real: Path, tmp_path: Path) -> Callable[[str], None]:
    """Return a function that runs a page of docs/integrations in a new folder: its commands, then its Python."""
    bin_ = Path(sys.executable).parent
    environ = {
        **os.environ,
        "PATH": f"{bin_}{os.pathsep}{os.environ['PATH']}",
        "HF_HOME": str(tmp_path / "cache"),
        "HF_HUB_OFFLINE": "1",
        "OMP_NUM_THREADS": "1",
        "COLUMNS": "100",
    }

    def run(command: str | list[str], folder: Path, **more: str) -> str:
        shell = isinstance(command, str)
        done = subprocess.run(
            command,
            shell=shell,
            cwd=folder,
            env=environ | more,
            capture_output=True,
            text=True,
            check=False,
            timeout=900,
        )
        assert done.returncode == 0, f"{command}: {done.stdout[-2000:]}{done.stderr[-4000:]}"
        return done.stdout

    def read(name: str) -> None:
        folder = tmp_path / "page"
        folder.mkdir()
        (folder / "problems").symlink_to(real)  # what the page's first command generates
        for own in ("examples", "experiments"):  # of a clone
            (folder / own).symlink_to(PAGES.parents[1] / own)
        path = folder / f"problems-{name}"
        for page, where in ((PAGES / f"{name}.md", folder), (path / "README.md", path)):
            for language, lines, start in readme._blocks(page.read_text(encoding="utf-8")):
                if language == "python":
                    run([sys.executable, "-c", "\n".join(lines)], where, PYTHONPATH=str(path))
                for shown in readme._commands(lines, start) if language.startswith("console") else ():
                    if not shown.command.startswith("sim2reason generate"):
                        printed = run(shown.command, where, PYTHONPATH=str(path))
                        assert readme.fits(shown.output, printed), printed

    return read
