"""Tests that each check finds the fault that it is for, planted in a sound solution."""

from dataclasses import replace
from math import cos, radians, sin

import pytest

from plain_scenes import atwood
from sim2reason.questions import Query, Target
from sim2reason.questions.moments.times import AtTime
from sim2reason.scenes.bodies.blocks import Slab
from sim2reason.scenes.bodies.simple_machines import Plane
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.stacked_mass_plane import StackedMassPlane
from sim2reason.solutions import Relation, Solution, solve
from sim2reason.solutions.algebra.expressions import Number, Symbol, multiply_factors, sum_terms
from sim2reason.solutions.solve import solve_prompt
from sim2reason.testing.solution_text import read
from sim2reason.testing.solution_verification import faults, undetermined
from worked import asked


def sound() -> Solution:
    return solve(asked(atwood(), "What is the tension in the string just after release?"))


def altered(solution: Solution, kind: str, change: "object") -> Solution:
    """Return a copy with the relations of all steps of a kind changed."""
    steps = tuple(
        replace(step, relations=change(step.relations)) if step.kind == kind else step  # type: ignore[operator]
        for step in solution.steps
    )
    return replace(solution, steps=steps)


def test_a_sound_solution_has_no_faults() -> None:
    found = sound()
    assert found.answer is not None
    assert not faults(found, found.answer)


def test_a_wrong_answer() -> None:
    found = sound()
    assert found.answer is not None
    assert any("the engine" in fault for fault in faults(found, found.answer * 1.001))


def test_a_relation_that_does_not_hold() -> None:
    found = sound()

    def wrong(relations: tuple[Relation, ...]) -> tuple[Relation, ...]:
        return tuple(replace(r, right=sum_terms(r.right, Number(0.1))) for r in relations)

    assert any("does not hold" in fault for fault in faults(altered(found, "combine", wrong), found.answer or 0.0))


def test_a_law_that_is_missing() -> None:
    found = altered(sound(), "newton", lambda relations: relations[:1])
    assert any("do not determine" in fault for fault in faults(found, found.answer or 0.0))


def test_a_law_that_is_superfluous() -> None:
    found = sound()
    idle = Relation(Symbol("x"), multiply_factors(Number(2.0), Symbol("a")), "law")
    found = altered(found, "newton", lambda relations: (*relations, idle))
    found = replace(found, values={**found.values, "x": 2.0 * found.values["a"]})
    assert any("superfluous" in fault for fault in faults(found, found.answer or 0.0))


def test_what_tells_since_when_bodies_stick_is_not_superfluous() -> None:
    """The common momentum gives the speed of two boards that stick together, whatever their friction was before."""
    boards = StackedMassPlane(
        plane=Plane(angle=50.0, friction=0.3), lower=Slab(mass=3.0), upper=Slab(mass=2.0), friction=0.4, speed=2.0
    )
    scene = Scene(entities=(Named(name="boards", entity=boards),))
    found = solve(asked(scene, Query("state", Target("velocity", "boards.lower"), AtTime(1.0))))
    slope = radians(50.0)  # down the slope, the momentum of both changes by what their weight and the plane give
    assert found.answer == pytest.approx(9.8 * (sin(slope) - 0.3 * cos(slope)) - 2.0 * 2.0 / (3.0 + 2.0))
    assert not undetermined(found)
    unverified = altered(found, "verify", lambda _: ())
    assert [fault.partition(":")[0] for fault in undetermined(unverified)] == ["superfluous"]


def test_what_holds_but_does_not_follow() -> None:
    found = sound()
    stray = Relation(Symbol("T"), Number(found.values["T"]), "derived")
    laws = [step.kind for step in found.steps]
    assert "newton" in laws
    lone = altered(found, "newton", lambda relations: (*relations, replace(stray, right=Symbol("y"))))
    lone = replace(lone, values={**found.values, "y": found.values["T"]})
    assert any("does not follow" in fault for fault in faults(lone, found.answer or 0.0))


@pytest.mark.parametrize(
    ("old", "new"),
    [("m_B a", "m_A a"), ("T - m_B g", "T + m_B g"), ("1.9600", "1.9700"), (r"\boxed{23.5", r"\boxed{24.5")],
)
def test_the_reader_finds_a_fault_in_the_text(old: str, new: str) -> None:
    text = sound().text
    assert not read(text).broken
    assert old in text
    assert read(text.replace(old, new, 1)).broken


@pytest.mark.parametrize(
    ("old", "new"), [("(1) + 2·(2)", "(1) − 2·(2)"), ("(a) − 0.50000·(b)", "(a) − 0.53500·(b)"), ("4.0000", "5.0000")]
)
def test_the_reader_adds_labelled_equations_up(old: str, new: str) -> None:
    text = (
        "(1) Block B, upward: $2\\,T - 3 = a$. (2) Block A: $5 - T = a$.\n\n(1) + 2·(2): $7 = 3\\,a$.\n\n"
        "(a) $5.0000\\,x + 2.0000\\,y = 9.0000$; (b) $2.0000\\,x + 4.0000\\,y = 10.000$.\n\n"
        "(a) − 0.50000·(b): (c) $4.0000\\,x = 4.0000$.\n\n"
        "So $a = \\frac{7}{3} = 2.3333$, $x = 1.0000$, and $y = 2.0000$."
    )
    assert not read(text).broken
    assert read(text.replace(old, new, 1)).broken


def test_what_rounding_leaves_of_zero_does_not_make_a_law_idle() -> None:
    """In a limiting case both accelerations are zero, one of them up to 1e-16, but its law is still needed."""
    a, b, m = Symbol("a"), Symbol("b"), Symbol("m")
    laws = (
        Relation(m, sum_terms(Number(2.0), a), "law"),
        Relation(a, multiply_factors(Number(-2.0), b), "law"),
        Relation(b, Number(0.0), "law"),
    )
    step = replace(sound().steps[-1], relations=laws, gives=("m",))
    solution = Solution("limit", (step,), {"m": 2.0, "a": -1e-16, "b": 5e-17}, "m", 2.0)
    assert not undetermined(solution)
    assert undetermined(replace(solution, steps=(replace(step, relations=laws[:2]),)))


def test_a_name_without_a_number_is_taken_from_where_rounding_counts_least() -> None:
    """a_P is 0.766; as a small difference, (a) has it to 1e-3 only, (b) to 6e-5."""
    text = """So $a_A = 2.2372\\ \\text{m/s}^2$. In numbers: (a) $21.500\\,a_A + 1.2000\\,a_P = 49.019$; \
(b) $1.2000\\,a_A + 11.850\\,a_P = 11.760$."""
    found = read(text)
    assert not found.broken
    assert found.values["a_P"] == pytest.approx((11.760 - 1.2 * 2.2372) / 11.850, rel=1e-12)
    assert read(text.replace("49.019", "49.190")).broken


STACK = """Slab A of mass 7.2 kg is on top of slab B of mass 9.1 kg, which lies on a fixed smooth plane \
inclined at 36° to the horizontal. Slab A in turn carries slab C of mass 5.9 kg. Static and kinetic \
friction between B and A have the same coefficient, 0.18. Between A and C the coefficient of \
friction, static and kinetic, is 0.20. Slab A is launched up the slope at t = 0 with a speed of 3.4 \
m/s, all else being at rest. No body reaches an edge. The free-fall acceleration is g = 9.8 m/s². \
Find the magnitude of the change in slab A's gravitational potential energy from t = 0 \
until slab B has moved 3.5 m. Write the answer in J, to three significant figures, in \\boxed{}."""


def test_what_an_assumption_is_verified_by_is_told() -> None:
    """Slab A sticks to B while C still slides on A, which depends on accelerations that the answer doesn't need."""
    found, setting = solve_prompt(STACK)
    assert "$a_{B,1} = " in found.text
    assert not read(found.text).broken
    assert setting.answer is not None
    assert not faults(found, setting.answer)
