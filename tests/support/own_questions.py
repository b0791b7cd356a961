"""Worked solutions of users' questions about the scenes in `tests/data`."""

from pathlib import Path

import pytest

import sim2reason
from sim2reason.datasets.scene_questions import SolvedProblem
from sim2reason.solutions.checking import recompute
from sim2reason.solutions.data import as_data
from sim2reason.solutions.writing.notation import latex
from sim2reason.testing.solution_text import read
from sim2reason.testing.solution_verification import faults

DATA = Path(__file__).parent.parent / "data"
G = 9.8  # m/s², in all of these scenes but those on other planets


def solved(name: str, find: str, when: str = "", of: str = "") -> SolvedProblem:
    """Return a problem after checking that its solution leads to the answer from the motion."""
    found = sim2reason.solve(next(DATA.glob(f"*_scenes/{name}.yaml")), find=find, when=when, of=of)
    assert found.answer is not None
    assert found.solution.answer == pytest.approx(found.answer, rel=1e-9), found.reason
    assert found.solution.unit == latex(found.unit)
    assert not faults(found.solution, found.answer, 1e-6)
    assert not read(found.solution.text).broken
    assert recompute(as_data(found.solution)).agrees(found.answer, 1e-6)
    return found
