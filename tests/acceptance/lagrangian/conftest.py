"""Fixtures of the comparisons with Lagrangian references, and a summary of the measured errors after a run."""

import pytest

from agreement import MEASURED, Agreement


@pytest.fixture
def agree(request: pytest.FixtureRequest) -> Agreement:
    return Agreement(request)


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter, config: pytest.Config) -> None:
    measured = config.stash.get(MEASURED, [])
    if measured:
        terminalreporter.write_line("exact engine against references: columns, events (how many), reference itself")
    for each in measured:
        line = f"  {each.name:62} {each.columns:.0e}  {each.events:.0e} ({each.happened})  {each.own:.0e}"
        terminalreporter.write_line(line)
