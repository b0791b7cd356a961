"""Fixture for comparisons with closed forms; the worst relative error is reported after the run."""

from collections.abc import Callable

import numpy as np
import pytest

WORST = pytest.StashKey[tuple[float, str]]()
CLOSE = 1e-9

Agree = Callable[..., None]


@pytest.fixture
def agree(request: pytest.FixtureRequest) -> Agree:
    """Return an assertion that values agree to 1e-9, or `close`, of the larger of `expected` and `scale`."""

    def compare(actual: object, expected: object, scale: float = 0.0, close: float = CLOSE) -> None:
        found, wanted = np.asarray(actual, dtype=float), np.asarray(expected, dtype=float)
        size = max(float(np.abs(wanted).max()), scale)
        error = float(np.abs(found - wanted).max()) / (size or 1.0)
        worst = request.config.stash.get(WORST, (0.0, ""))
        request.config.stash[WORST] = max(worst, (error, request.node.nodeid.rpartition("/")[2]))
        assert error <= close, f"{found} instead of {wanted}"

    return compare


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter, config: pytest.Config) -> None:
    error, where = config.stash.get(WORST, (0.0, ""))
    if where:
        terminalreporter.write_line(f"exact engine against closed forms: worst relative error {error:.1e} ({where})")
