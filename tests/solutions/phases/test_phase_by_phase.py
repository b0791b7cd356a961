"""Tests of phases of constant acceleration without integration, against closed forms."""

from math import cos, radians, sin

import pytest

from sim2reason.questions import Query, Target
from sim2reason.questions.difficulty import ELEMENTARY
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.contacts import StoppedSlipping
from sim2reason.questions.moments.distances import Away
from sim2reason.questions.moments.times import AtTime
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.files import loads
from sim2reason.solutions import STRATEGIES, Solution, solve_with
from sim2reason.solutions.solve import solve_prompt
from sim2reason.testing.solution_text import read
from sim2reason.testing.solution_verification import faults
from worked import asked

SLABS = (
    "Slab A (15 kg) lies on a rough, fixed plane inclined at 38° to the horizontal and carries slab B of mass 17 kg. "
    "The coefficients of static and of kinetic friction on this plane are both 0.30. Static and kinetic friction "
    "between A and B have the same coefficient, 0.31. At t = 0 B has a velocity of 4.7 m/s, directed up the slope, and "
    "all else is at rest. What is the time from t = 0 until slab A first begins to slip? There is ample room to move. "
    "Here g = 9.8 m/s². Give your answer in s, to three significant figures, inside \\boxed{}."
)


def test_a_slab_slips_when_the_one_on_it_has_come_to_rest() -> None:
    """B decelerates by g (sin θ + µ cos θ), and the elimination with numbers includes its weight."""
    found, setting = solve_prompt(SLABS)
    assert found.strategy == "phase by phase", found.reason
    slowed = 9.8 * (sin(radians(38)) + 0.31 * cos(radians(38)))
    assert found.answer == pytest.approx(4.7 / slowed, rel=1e-9)
    assert found.derived
    assert found.needs <= ELEMENTARY
    assert setting.answer is not None
    assert not faults(found, setting.answer), found.text
    assert "numerical" not in found.text


STICKING_PUCKS = """scene:
  name: scene
  entities:
  - name: table
    type: TwoDCollisionPlane
    parameters:
      table: {angle: 29.0}
      radius: 0.3
      pucks:
      - {mass: 7.6, x: 1.42, y: 1.22, vx: 0.5, vy: -0.63}
      - {mass: 8.9, x: -0.45, y: -0.26, vx: 4.2, vy: 2.36}
      - {mass: 8.4, x: 0.34, y: -1.48, vx: 1.66, vy: 1.71}
      - {mass: 9.6, x: 0.82, y: 0.18, vx: 2.66, vy: 1.24}
      restitution: 0.0
  world: {gravity: 9.8}
"""


def test_what_has_no_numbers_in_the_text_is_refused_in_words() -> None:
    setting = asked(loads(STICKING_PUCKS), Query("time_to_event", None, Away("table.pucks.1", 6.9)))
    found = solve_with(STRATEGIES["phase by phase"], setting)
    assert found.answer is None
    assert "the text does not give" in found.reason


SPINNING, SLIDING = "{kind: spinning, way: to the right, spin: 12.0}", "{kind: sliding, way: to the right, speed: 2.1}"


def rolling(start: str, angle: float = 0.0, friction: float = 0.3) -> Scene:
    """Return a scene with a thick pipe on a plane."""
    return loads(f"""
scene:
  entities:
  - name: roller
    type: RollingEntity
    parameters:
      body: {{kind: thick_pipe, mass: 2.0, radius: 0.2, bore: 0.1}}
      plane: {{angle: {angle}}}
      grip: {{kind: rough, friction: {friction}}}
      start: {start}
""")


def phases(scene: Scene, moment: Moment, quantity: str = "") -> Solution:
    target = Target(quantity, "roller.body") if quantity else None
    kind = "time_to_event" if target is None else "event" if isinstance(moment, StoppedSlipping) else "state"
    setting = asked(scene, Query(kind, target, moment))
    found = solve_with(STRATEGIES["phase by phase"], setting)
    assert found.answer is not None, found.reason
    assert setting.answer is not None
    assert not faults(found, setting.answer), found.text
    assert not read(found.text).broken
    return found


def test_a_phase_says_which_way_friction_acts_and_solves_its_laws() -> None:
    """The point of contact slips to the left, so friction µ m g acts to the right and slows the rotation."""
    found = phases(rolling(SPINNING), StoppedSlipping("roller.body"))
    text = found.text
    assert "has turned clockwise" in text
    assert "slips to the left at the point of contact, so the friction on it acts to the right;" in text
    assert "is $N_1$. The moment of inertia of the " in text
    assert r"about its axis is $\tfrac{1}{2} m R^{2} + \tfrac{1}{2} m r^{2}$." in text
    assert r"$a_1 = \mu g = 2.9400\ \text{m/s}^2$" in text
    assert r"$\alpha_1 = -\frac{2\,\mu R g}{R^{2} + r^{2}}" in text
    assert text.index("so the friction on it") < text.index("By Newton's second law and the law of torques")


def test_only_symbols_that_are_used_are_declared() -> None:
    found = phases(rolling(SPINNING), StoppedSlipping("roller.body"))
    assert r"and let $a = \ddot{s}$ and $\alpha = \ddot{\psi}$." in found.text
    assert r"\dot{\psi}$" not in found.text.replace(r"\ddot{\psi}$", "")
    assert r"\tau" not in found.text  # the time at the end of the first phase needs no second name


def test_a_velocity_has_another_letter_than_a_given_one() -> None:
    found = phases(rolling(SLIDING), AtTime(0.7), "displacement")
    assert r"$u = \dot{s}$" in found.text
    assert "v_1" not in found.text
    assert r"$a_1 = -\mu g" in found.text


def test_what_begins_to_roll_on_a_slope_is_held_by_static_friction() -> None:
    """A body that rolls down the slope has α R = −a and a = g sin θ/(1 + I/(m R²))."""
    scene = rolling("{kind: sliding, way: down the slope, speed: 2.1}", 10.0, 0.4)
    found = phases(scene, AtTime(2.0), "displacement")
    assert "rolls without slipping; the static friction on it, counted positive up the slope, is $f_2$." in found.text
    assert any(r.left.latex() == "a_2" and r.role == "derived" for r in found.relations)
