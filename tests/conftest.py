"""Fixtures and hooks that all tests share."""

import os
import signal
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

from shared_items import SharedItems
from sim2reason.datasets.worker import tune_garbage_collection

if os.environ.pop("PYTHONDONTWRITEBYTECODE", ""):  # a hundred processes would compile the library anew
    sys.dont_write_bytecode = False
    beside = Path(__file__).parents[1] / ".pytest_cache" / "bytecode"
    sys.pycache_prefix = os.environ.setdefault("PYTHONPYCACHEPREFIX", str(beside))

# how fast a busy machine is at examples is no property of what is tested
settings.register_profile("busy", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("busy")


@pytest.hookimpl(trylast=True)
def pytest_collection_finish() -> None:
    """Exempt loaded objects from garbage collection, as workers do, since a run mostly makes items."""
    tune_garbage_collection()


@pytest.fixture(scope="session")
def numeric_items(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> SharedItems:
    """Return items of every recipe and difficulty, in a folder that parallel test processes share."""
    own = tmp_path_factory.getbasetemp()
    return SharedItems((own.parent if hasattr(request.config, "workerinput") else own) / "numeric-items")


@pytest.fixture
def pictures() -> None:
    """Enable pictures in a test's datasets; they take longer than the rest of a small dataset."""


@pytest.fixture(autouse=True)
def _no_pictures(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    if "pictures" not in request.fixturenames:
        monkeypatch.setattr("sim2reason.datasets.build.put_pictures", lambda *_: ())


@pytest.fixture
def heed_interrupts() -> Iterator[None]:
    """Restore SIGINT's default for a test and its children, since background jobs, as under nohup, ignore it."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)
