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


VALUES = (4.5, 9.0, -4.5, 13.0)


@pytest.mark.parametrize(
    "said",
    [
        "B",
        "(B) 9.00",
        "B. 9.00 m/s",
        r"\text{B. }9.00\text{ m/s}",
        r"\text{(B) } 9.0",
        r"9.0\ \mathrm{m/s}",
        "900 cm/s",
    ],
)
def test_the_number_of_an_option_may_stand_beside_its_letter_or_for_it(said: str) -> None:
    assert choice(rf"\boxed{{{said}}}", "B", "ABCD", VALUES, "m/s").reward == 1.0


@pytest.mark.parametrize(
    ("said", "outcome"),
    [
        ("C: 9.0", Outcome.UNREADABLE),
        ("A. 9", Outcome.UNREADABLE),
        ("9.0 or 4.5", Outcome.UNREADABLE),
        ("8.5", Outcome.UNREADABLE),
        ("13", Outcome.WRONG),
        ("D. 13.0 m/s", Outcome.WRONG),
        ("B, C", Outcome.UNREADABLE),
        (r"\text{B. 9.0} 4.5", Outcome.UNREADABLE),
    ],
)
def test_numbers_that_say_another_option_or_none_are_not_paid(said: str, outcome: Outcome) -> None:
    assert choice(rf"\boxed{{{said}}}", "B", "ABCD", VALUES, "m/s").outcome == outcome


@given(st.text(st.sampled_from("ABCD().: 0123459-;"), max_size=12))
def test_with_numbers_only_one_option_is_ever_paid(text: str) -> None:
    paid = [one for one in "ABCD" if choice(rf"\boxed{{{text}}}", one, "ABCD", VALUES, "m/s").reward]
    assert len(paid) <= 1
