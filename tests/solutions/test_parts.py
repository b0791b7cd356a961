"""Solutions of several parts, and of problems with options."""

from sim2reason.solutions.parts import chosen
from sim2reason.solutions.solution import Solution


def test_the_letter_of_an_option_stands_in_a_paragraph_of_its_own() -> None:
    text = chosen(Solution("", goal="v", answer=2.0, values={"v": 2.0}), "C").text
    assert text.split("\n\n") == [r"Answer: $v \approx 2.00$.", r"That is option $\boxed{\text{C}}$."]
