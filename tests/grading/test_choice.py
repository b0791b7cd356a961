import pytest
from hypothesis import given
from hypothesis import strategies as st

from sim2reason.grading import Outcome, choice


@pytest.mark.parametrize(
    "said",
    [r"\boxed{C}", r"$\boxed{\text{C}}$", r"\boxed{(C)}", r"\boxed{\mathrm{c}.}", r"A? No: \boxed{A}, \boxed{**C**}"],
)
def test_a_letter_is_read_in_its_usual_dress(said: str) -> None:
    assert choice(said, "C", "ABCDE").reward == 1.0


@pytest.mark.parametrize(
    ("said", "outcome"),
    [
        ("C", Outcome.NO_ANSWER),
        (r"\boxed{B}", Outcome.WRONG),
        (r"\boxed{AC}", Outcome.UNREADABLE),
        (r"\boxed{A, C}", Outcome.UNREADABLE),
        (r"\boxed{C: 4.9}", Outcome.UNREADABLE),
        (r"\boxed{E}", Outcome.UNREADABLE),
        (r"\boxed{}", Outcome.NO_ANSWER),
        (r"\boxed{ABCD}", Outcome.UNREADABLE),
        ("<think>\\boxed{C}", Outcome.NO_ANSWER),
        (None, Outcome.NO_ANSWER),
    ],
)
def test_anything_else_is_not_paid(said: object, outcome: Outcome) -> None:
    assert choice(said, "C", "ABCD").outcome == outcome


@given(st.text(max_size=40), st.sampled_from("ABCDE"))
def test_only_one_letter_is_ever_paid(text: str, letter: str) -> None:
    paid = [one for one in "ABCDE" if choice(rf"\boxed{{{text}}}", one, "ABCDE").reward]
    assert len(paid) <= 1
    assert choice(text, letter, "ABCDE").outcome in set(Outcome)
