"""Tests of equation numbers that are unique over all parts of a problem."""

import re
from collections import Counter

from sim2reason.solutions.multipart.quoting import quote_earlier_parts
from sim2reason.solutions.solution import Solution, Step
from sim2reason.solutions.solve import renumber_times
from worked import solution_text

INERTIA = r"whose moment of inertia is $\tfrac{1}{2} m R^{2}$, divided by its radius $R$:"


def test_equations_about_one_moment_of_inertia_have_numbers_of_their_own() -> None:
    """Laws of the same form in two phases keep separate numbers, although a formula stands before each of them."""
    texts = [
        f"(1) The disc, down the slope: $F = m a$. (2) Torque on the disc, {INERTIA} $-f = m a_1$.",
        f"(3) The disc, down the slope: $F - f = m a_2$. (4) Torque on the disc, {INERTIA} $f = m a_2$.",
        "(3) + (4): $F = 2 m a_2$.",
    ]
    part = Solution("", tuple(Step(n, "newton", text, (), (), ()) for n, text in enumerate(texts)))
    found = "\n".join(step.text for step in quote_earlier_parts([part])[0].steps)
    numbers = Counter(re.findall(r"(?:^|\. )\((\d)\) [A-Z]", found, re.MULTILINE))
    assert numbers == {"1": 1, "2": 1, "3": 1, "4": 1}
    assert "(3) + (4)" in found


def test_times_are_numbered_as_they_are_introduced() -> None:
    steps = [Step(n, "time", f"${name} = 1$", (), (name,), ()) for n, name in enumerate(("t_3", "t_1", "t_2"))]
    found = renumber_times(Solution("", tuple(steps), {"t_1": 1.0, "t_2": 2.0, "t_3": 3.0}, "t_2", 2.0))
    assert [step.gives for step in found.steps] == [("t_1",), ("t_2",), ("t_3",)]
    assert found.values == {"t_2": 1.0, "t_3": 2.0, "t_1": 3.0}
    assert found.goal == "t_3"


def test_a_later_part_shows_that_no_further_collision_comes_before_its_moment() -> None:
    """The first part is about the collision itself, a later one about a later time."""
    early, _, late = solution_text("collision-hard-multipart-2-1").partition("\n\n(b) ")
    assert "no further collision before" not in early
    assert "so there is no further collision before" in late
