from collections.abc import Callable
from pathlib import Path

import pytest

from sim2reason.datasets.build import build
from sim2reason.datasets.manifest import Manifest
from sim2reason.datasets.plan import Config

Make = Callable[..., Manifest]


@pytest.fixture
def config() -> Config:
    return Config(items=95, recipes=("incline", "pulley"), difficulties=("easy",), shard=20, maker="fake_makers:steady")


@pytest.fixture
def make(tmp_path: Path, config: Config) -> Make:
    """Build tmp_path/NAME with changes to the usual configuration."""

    def run(name: str = "data", workers: int = 1, patience: float = 60.0, **changes: object) -> Manifest:
        return build(tmp_path / name, config.model_copy(update=changes), workers=workers, patience=patience)

    return run


@pytest.fixture
def data(tmp_path: Path, make: Make) -> Path:
    make()
    return tmp_path / "data"


def content(folder: Path) -> dict[str, bytes]:
    """Return the bytes of every file of a dataset by path."""
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


@pytest.fixture
def contents() -> Callable[[Path], dict[str, bytes]]:
    return content
