"""Tests of later parts that start from a result of an earlier part and are read alone."""

from plain_scenes import nested_atwood
from sim2reason.solutions import Solution, solve
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.multipart import sequential_solutions
from sim2reason.solutions.multipart.quoting import without_unused
from sim2reason.solutions.solution import Relation, Step
from worked import asked

GIVEN = Step(0, "givens", "Given: $a = 1$ and $b = 2$.", (), (), ())
FORCES = Step(2, "newton", "(1) Block A: $x = a$. (2) Block B: $y = b$.", (), ("newton",), (1,))


def part(*steps: Step) -> Solution:
    return Solution("", (GIVEN, *steps), {}, "x", 1.0)


def relation(left: str, right: str) -> Relation:
    return Relation(Symbol(left), Symbol(right), "law", "")


def test_equations_that_the_text_does_not_use_are_left_out() -> None:
    earlier = Step(1, "earlier part", "From part (a), $c = 3$.", (relation("c", "c"),), ("c",), ())
    forces = Step(2, "newton", FORCES.text, (relation("x", "a"), relation("y", "b")), ("newton",), (1,))
    goal = Step(3, "solve", "From (2), $z = y$.", (relation("z", "y"),), ("z",), (2,))
    found = without_unused(part(earlier, forces, goal), lambda _: True)
    assert [step.text for step in found.steps[2:]] == ["(1) Block B: $y = b$.", "From (1), $z = y$."]
    assert found.steps[2].relations == (relation("y", "b"),)
    assert without_unused(part(earlier, forces, goal), lambda _: False).steps[2].text == FORCES.text
    assert without_unused(part(forces, goal), lambda _: True).steps[1].text == FORCES.text


def test_a_tension_from_an_acceleration_needs_two_equations_alone() -> None:
    """Part (a) solves four equations for the acceleration of a block; the tension in part (b) takes two."""
    questions = (
        "What is the magnitude of the acceleration of block C after release?",
        "What is the tension in the string between block A and block B after release?",
    )
    settings = [asked(nested_atwood(0.55, 0.65, 0.82), question) for question in questions]
    first, second = sequential_solutions(settings, [solve(setting) for setting in settings])
    assert "(4) Block B" in first.text
    laws = [relation for step in second.steps for relation in step.relations if relation.role == "law"]
    assert len(laws) == 2
    assert second.text.startswith(r"Given: $m_C = 0.55\ \text{kg}$ and $g = 9.8\ \text{m/s}^2$.")
    assert r"$a_A$" not in second.text
