"""Tests of boxes with answers to several labelled parts: fewer right parts never earn more."""

import time

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sim2reason.grading import Outcome, Score, number, parts
from sim2reason.grading.parts import Grader

RIGHT = {"a": "2.1", "b": "-34", "c": "0.5"}
WRONG = {"a": "3", "b": "34", "c": "1 m"}


def graders() -> list[Grader]:
    return [
        lambda said: number(said, 2.1, "m/s"),
        lambda said: number(said, -34.0, "N", positive="up"),
        lambda said: number(said, 0.5, "s"),
    ]


def score(answer: str, *, partial: bool = False) -> Score:
    return parts(rf"\boxed{{{answer}}}", graders(), partial=partial)


@pytest.mark.parametrize(
    "said",
    [
        "(a) 2.1; (b) -34; (c) 0.5",
        "(c) 0.5; (a) 2.1; (b) -34",
        r"(a)\ 2.1\ \mathrm{m/s},\quad (b)\ -34\ \mathrm{N},\quad (c)\ 500\ \mathrm{ms}",
        r"\text{(a) } 2.1\text{ m/s}, \text{(b) } -34\text{ N}, \text{ and (c) } 0.5\text{ s}",
        r"\text{(a) 2.1 m/s; (b) 34 N down; (c) 0.5 s}",
        r"\text{(a) speed = }2.1\text{ m/s; (b) }-34\text{; (c) }0.5",
        r"\textbf{(a)}~2.1;\ \textbf{(b)}~-34;\ \textbf{(c)}~0.5",
        r"(\text{a}) 2.1 \text{ and } (\text{b}) -34 \text{, and } (\text{c}) 0.5",
        r"\begin{aligned}(a)\ & v = 2.1\ \mathrm{m/s}\\ (b)\ & T = -34\\ (c)\ & t = 0.5\end{aligned}",
        "(a): 2.1\n(b): -34\n(c): 0.5.",
    ],
)
def test_labels_are_read_as_people_write_them(said: str) -> None:
    found = score(said)
    assert (found.reward, found.outcome, len(found.parts)) == (1.0, Outcome.CORRECT, 3)
    assert all(part.reward == 1.0 for part in found.parts)


@pytest.mark.parametrize(
    ("said", "outcome", "right"),
    [
        ("(a) 2.1; (b) 34; (c) 0.5", Outcome.WRONG, 2),
        ("(a) 2.1; (b) -34", Outcome.NO_ANSWER, 2),
        ("(a) 2.1; (b) -34; (c)", Outcome.NO_ANSWER, 2),
        ("(a) 2.1 or 3; (b) -34; (c) 0.5", Outcome.WRONG, 2),
        ("(a) 2.1, 3; (b) -34; (c) 0.5", Outcome.WRONG, 2),
        ("(a) 2.1 kg; (b) -34; (c) 0.5", Outcome.WRONG_UNIT, 2),
        ("(a) 2.1; (a) 3; (b) -34; (c) 0.5", Outcome.UNREADABLE, 0),
        ("(a) 2.1; (b) -34; (c) 0.5; (d) 7", Outcome.UNREADABLE, 0),
        ("2.1; (b) -34; (c) 0.5", Outcome.UNREADABLE, 0),
        ("2.1, -34, 0.5", Outcome.UNREADABLE, 0),
        (r"\phantom{(a) 2.1}(a) 3; (b) -34; (c) 0.5", Outcome.UNREADABLE, 0),
        (r"(a) 2.1 \text{ or (a) } 3; (b) -34; (c) 0.5", Outcome.UNREADABLE, 0),
    ],
)
def test_what_is_not_right_in_all_parts_is_not_paid_but_for_the_share_on_demand(
    said: str, outcome: Outcome, right: int
) -> None:
    whole, share = score(said), score(said, partial=True)
    assert (whole.reward, whole.outcome) == (0.0, outcome)
    assert (share.reward, share.outcome) == (pytest.approx(right / 3), outcome)


def test_only_the_last_box_counts_so_that_boxes_can_not_be_collected() -> None:
    assert parts(r"\boxed{(a) 2.1} \boxed{(b) -34} \boxed{(c) 0.5}", graders(), partial=True).reward == pytest.approx(
        1 / 3
    )
    assert parts(r"\boxed{2.1} \boxed{-34} \boxed{0.5}", graders(), partial=True).reward == 0.0
    assert parts(r"\boxed{(a) 2.1; (b) -34; (c) 0.5} or \boxed{(a) 3; (b) -34; (c) 0.5}", graders()).reward == 0.0


STATED = st.lists(st.sampled_from([f"({name}) {said}" for some in (RIGHT, WRONG) for name, said in some.items()]))


@given(STATED, st.sampled_from(["; ", ", ", r" \quad ", " and ", "\n", r" \\ "]))
def test_fewer_right_parts_never_earn_more(said: list[str], between: str) -> None:
    """A box earns at most the share of labels with the right answer, and none counts twice."""
    right = sum(f"({name}) {value}" in said for name, value in RIGHT.items())
    share = score(between.join(said), partial=True)
    assert share.reward <= right / 3 + 1e-12
    assert score(between.join(said)).reward in (0.0, float(share.reward == 1.0))
    once = len({text[:3] for text in said}) == len(said)
    if said and once:
        assert share.reward == pytest.approx(right / 3)
    elif said:
        assert share.reward == 0.0


@given(st.text(max_size=80), st.text(max_size=20))
def test_what_stands_before_or_between_never_helps(junk: str, more: str) -> None:
    said = rf"\boxed{{{junk}(a) 3; (b) 34{more}; (c) 0.7}}"
    assert parts(said, graders(), partial=True).reward <= sum(text in junk + more for text in ("2.1", "34", "0.5"))
    assert parts(said, graders()).reward == 0.0 or "2.1" in junk


@pytest.mark.parametrize(
    "hostile", [r"\text{" * 90, "(a)" * 300, " " * 990, "(a) " + ";" * 900, r"\ " * 480 + "x", r"\text{(a)" * 100]
)
def test_hostile_boxes_take_no_long(hostile: str) -> None:
    begin = time.process_time()
    assert parts(rf"\boxed{{{hostile}}}", graders()).reward == 0.0
    assert parts(hostile, graders()).reward == 0.0
    assert time.process_time() - begin < 0.5
