"""Tests of the texts of solutions by normal modes: equations of motion first, then the mode coordinates."""

import re

import numpy as np
import pytest

from plain_scenes import row
from sim2reason.questions import Query, Target
from sim2reason.questions.moments.times import AtTime
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.solutions import STRATEGIES, ProblemContext, Solution, solve_with
from sim2reason.testing.solution_text import read
from worked import asked

TIME, STEP = 0.3, 1e-4  # s


def by_modes(scene: Scene, quantity: str) -> tuple[Solution, ProblemContext]:
    """Return the solution by normal modes for a quantity of the last cart at a given time, and its problem."""
    cart = [body.name for body in scene.mechanism.bodies if body.mass][-1]
    setting = asked(scene, Query("state", Target(quantity, cart), AtTime(TIME)))
    solution = solve_with(STRATEGIES["normal modes"], setting)
    assert solution.answer is not None, solution.reason
    return solution, setting


def pair(**start: float) -> Scene:
    return row((2.3, 2.2), (79.0, 93.0), "right", **start)  # type: ignore[arg-type]


@pytest.mark.parametrize(("masses", "wall"), [((2.3, 2.2), "right"), ((1.0, 1.4, 0.8), "both"), ((1.0, 1.5), "free")])
def test_the_equations_of_motion_are_those_of_the_engine(masses: tuple[float, ...], wall: str) -> None:
    """Both sides of each equation agree for positions and accelerations of the engine at another instant."""
    springs = (79.0, 93.0, 60.0, 85.0)[: len(masses) + {"both": 1, "free": -1}.get(wall, 0)]
    scene = row(masses, springs, wall, speed=1.4)
    solution, setting = by_modes(scene, "displacement")
    assert "The equations of motion are" in solution.text
    sentence = solution.text.partition("The equations of motion are ")[2].partition(".\n")[0]
    known = {name: value for name, value in solution.values.items() if name[0] in "mkg"}
    before, now, after = (setting.motion.state(np.array([0.5 * TIME + d])) for d in (-STEP, 0.0, STEP))
    for k, coordinate in enumerate(scene.mechanism.coordinates):
        mark = setting.subscript_of(coordinate.body)
        acceleration = (after.v[0, k] - before.v[0, k]) / (2.0 * STEP)
        known |= {f"x_{mark}": float(now.q[0, k]), f"a_{mark}": float(acceleration)}
    equations = re.sub(r"\\ddot\{x\}", "a", sentence)
    reading = read(f"Here {equations}.", known)
    assert not reading.unread
    assert len(reading.equalities) == len(masses)
    assert not reading.broken


@pytest.mark.parametrize("quantity", ["velocity", "acceleration"])
def test_a_rate_is_derived_from_a_displacement_that_is_written(quantity: str) -> None:
    """Only functions that stand in the text are differentiated, and no coefficient is called an amplitude."""
    text = by_modes(pair(speed=1.4), quantity)[0].text
    assert "amplitude" not in text
    assert text.index("The displacement of") < text.index("differentiating")
    assert text.index("The equations of motion") < text.index("In normal mode 1")
    assert not re.search(r"\bIts (mass|equilibrium|derivative)\b", text)


def test_the_determinant_of_two_carts_is_written_once_and_in_symbols() -> None:
    text = by_modes(pair(speed=1.4), "velocity")[0].text
    assert text.count("determinant") == 1
    assert r"m_A m_B \lambda_1^{2}" in text
