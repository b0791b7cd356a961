"""What all tests share."""

import pytest

from sim2reason.datasets.worker import collect_seldom


@pytest.hookimpl(trylast=True)
def pytest_collection_finish() -> None:
    """Let the collector of garbage pass over what was loaded, as workers do: most of a run is the making of items."""
    collect_seldom()
