"""Tests of the arrangement of texts about long chains of collisions, with rows of like results."""

from dataclasses import replace

import pytest

from sim2reason.solutions import solve
from sim2reason.solutions.algebra.expressions import Number, Symbol
from sim2reason.solutions.solution import Relation, Step
from sim2reason.solutions.writing.arrangement import MIN_NAMES_FOR_ROWS, ROWS, TIME, VELOCITY, group_steps, merge_steps
from sim2reason.testing.solution_text import read
from sim2reason.testing.solution_verification import WORDS, faults, words
from worked import settings_of, solution_text


def velocity(number: int, *needs: int) -> Step:
    name = f"v_{number}"
    relation = Relation(Symbol(name), Number(2.0), "law")
    text = f"Then the velocity of ball A is {relation.latex()}."
    return Step(number, VELOCITY, text, (relation,), (name,), needs)


def test_few_sentences_stay_as_they_are() -> None:
    steps = [velocity(number) for number in range(MIN_NAMES_FOR_ROWS - 1)]
    assert group_steps(steps) == steps


def test_a_row_holds_what_follows_from_what_was_told() -> None:
    """The eleventh velocity rests on a law after the row, so it's stated later."""
    law = Step(MIN_NAMES_FOR_ROWS, "law", "A law.", (), ("x",), (0,))
    steps = [
        *(velocity(number) for number in range(MIN_NAMES_FOR_ROWS)),
        law,
        velocity(MIN_NAMES_FOR_ROWS + 1, MIN_NAMES_FOR_ROWS),
        velocity(MIN_NAMES_FOR_ROWS + 2, 3),
    ]
    row, between, last = group_steps(steps)
    assert row.text.startswith("The velocities are $v_0 = 2$, ")
    assert row.gives == (*(f"v_{number}" for number in range(MIN_NAMES_FOR_ROWS)), f"v_{MIN_NAMES_FOR_ROWS + 2}")
    assert len(row.relations) == MIN_NAMES_FOR_ROWS + 1
    assert (row.needs, between.needs, last.needs) == ((), (0,), (MIN_NAMES_FOR_ROWS,))
    assert last.text == "Then the velocity of ball A is $v_7 = 2$."


def test_a_row_says_when_its_displacements_are_so() -> None:
    """Displacements at two instants give two clauses."""
    steps = [
        replace(velocity(number), text=f"At $t_{number % 2}$ the velocity of ball A is $v_{number} = 2$.")
        for number in range(MIN_NAMES_FOR_ROWS)
    ]
    (row,) = group_steps(steps)
    assert row.text == (
        "At $t_0$ the velocities are $v_0 = 2$, $v_2 = 2$ and $v_4 = 2$; "
        "at $t_1$ the velocities are $v_1 = 2$, $v_3 = 2$ and $v_5 = 2$."
    )


def test_each_row_has_steps_of_its_own_kind_only() -> None:
    steps = [velocity(number) for number in range(MIN_NAMES_FOR_ROWS)]
    other = Step(MIN_NAMES_FOR_ROWS, TIME, "That is at $t = 1$.", (), ("t",), ())
    assert [step.kind for step in group_steps([*steps, other])] == [VELOCITY, TIME]


def test_sentences_that_rest_on_one_step_are_one_sentence_and_so_are_those_that_rest_on_it() -> None:
    """Velocities along x and y after one impact are an example."""
    steps = [velocity(0), velocity(1), velocity(2, 0), velocity(3, 1)]
    assert [step.gives for step in merge_steps(steps)] == [("v_0", "v_1"), ("v_2", "v_3")]


@pytest.mark.parametrize(("difficulty", "index"), [("medium", 8), ("hard", 2)])
def test_long_chains_are_told_in_few_words(difficulty: str, index: int) -> None:
    (setting,) = settings_of(f"collision-{difficulty}-numeric-804-{index}")
    solution = solve(setting)
    assert f"the {ROWS[VELOCITY]} are" in solution.text
    assert setting.answer is not None
    assert not faults(solution, setting.answer)
    assert not read(solution.text).broken
    assert words(solution.text) <= WORDS[difficulty]


def test_times_are_told_by_the_event_from_which_they_are_counted() -> None:
    text = solution_text("collision-hard-choice-301933-0")
    assert "The time since the start is $t_3 = t_1 + t_2 = 0.56987" in text
    assert "The time since the collision of pucks A and B is $t_4 = t - t_1 = 0.53852" in text
    assert "have the same acceleration, so their relative velocities are constant between collisions." in text
