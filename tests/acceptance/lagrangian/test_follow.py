"""Tests of the integrator of the references, and of their independence from the engines that they check."""

import ast
import sys
from math import cos, pi, sin
from pathlib import Path

import numpy as np
import pytest

from lagrangian.follow import Array, Phase, follow, step

REFERENCES = Path(__file__).parents[2] / "support" / "lagrangian"


def test_the_references_import_nothing_of_the_library() -> None:
    found = set[str]()
    for path in REFERENCES.glob("*.py"):
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            if isinstance(node, ast.ImportFrom):
                found.add((node.module or "").split(".")[0])
            elif isinstance(node, ast.Import):
                found |= {alias.name.split(".")[0] for alias in node.names}
    assert found <= {"numpy", "lagrangian"} | set(sys.stdlib_module_names)


def test_a_step_is_of_order_twelve() -> None:
    def error(count: int) -> float:
        y, h = np.array([1.0, 0.0]), 3.0 / count
        for number in range(count):
            y = step(lambda _, z: [z[1], -z[0]], number * h, y, h)
        return abs(float(y[0]) - cos(3.0))

    assert error(2) / error(3) == pytest.approx(1.5**12, rel=0.05)


def test_events_are_found_to_the_last_digit() -> None:
    """The solution x = sin t crosses 1/2 upwards at t = π/6, downwards at 5π/6, and so on."""
    times = np.linspace(0.0, 10.0, 21)

    def phase(side: int) -> Phase:
        def after(_: str, __: float, y: Array) -> tuple[Phase, Array]:
            return phase(-side), y

        margins = {"half": lambda _, y: side * (0.5 - y[0])}
        return Phase(lambda _, y: [y[1], -y[0]], lambda _, y: list(y), margins, after)

    record = follow(phase(1), [0.0, 1.0], times, 2)
    expected = [pi / 6.0, 5.0 * pi / 6.0, 13.0 * pi / 6.0, 17.0 * pi / 6.0]
    assert [time for time, _ in record.events] == pytest.approx(expected, rel=1e-14)
    assert record.array[:, 0] == pytest.approx([sin(time) for time in times], abs=1e-13)
