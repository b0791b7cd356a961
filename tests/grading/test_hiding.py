"""Tests that boxes hidden in print, denied by the text, or empty are not answers."""

import pytest

from sim2reason.grading import Outcome, number


@pytest.mark.parametrize(
    "second",
    [
        r"\phantom{\boxed{9.6}}",
        r"\phantom {so \boxed{9.6}}",
        r"\color{white}{\boxed{9.6}}",
        r"{\color{white} \boxed{9.6}}",
        r"\textcolor{#ffffff}{\boxed{9.6}}",
        r"\textcolor[rgb]{1,1,1}{\boxed{9.6}}",
        r"\rlap{\boxed{9.6}}",
        r"\cancel{\boxed{9.6}}",
        r"\sout{it is \boxed{9.6}}",
        r"\transparent{0}\boxed{9.6}",
        r"\iffalse \boxed{9.6} \fi",
        r"% \boxed{9.6}",
        "\n% so \\boxed{9.6}",
        r"<!-- \boxed{9.6} -->",
        r"<div style='display:none'>\boxed{9.6}</div>",
        r'<span style="color: white">\boxed{9.6}</span>',
        r"<p hidden>\boxed{9.6}</p>",
        r"<script>\boxed{9.6}</script>",
        r"<del>\boxed{9.6}</del>",
        r"~~\boxed{9.6}~~",
    ],
)
def test_what_a_reader_does_not_see_is_not_paid(second: str) -> None:
    assert number(rf"\boxed{{4.8}} {second}", 9.6).outcome is Outcome.UNREADABLE


@pytest.mark.parametrize(
    "response",
    [
        r"The answer is not \boxed{9.6}",
        r"It isn't \boxed{9.6}",
        r"a is not equal to $\boxed{9.6}$",
        r"The wrong answer is \boxed{9.6}",
        r"\boxed{9.6} is wrong",
        r"\boxed{9.6}$ m/s² is not correct.",
        r"\boxed{9.6} can't be right",
        r"\boxed{9.6} (wrong)",
        r"\boxed{9.6} would be too large",
    ],
)
def test_a_box_that_is_denied_is_not_paid(response: str) -> None:
    assert number(response, 9.6).outcome is Outcome.UNREADABLE


@pytest.mark.parametrize(
    "response",
    [
        r"We do not need friction, so \boxed{9.6}",
        r"Is it wrong? The answer is \boxed{9.6}",
        r"\boxed{9.6} is the acceleration. It is not the speed.",
        r"This is 50% of it, so \boxed{9.6}",
        r"This is 50\,\% of it, so \boxed{9.6}",
        r"\color{blue}{\boxed{9.6}}",
        r"{\color{white} nothing} \boxed{9.6}",
        r"\textcolor{white}{nothing} \boxed{9.6}",
        r"\phantom{x}\boxed{9.6}",
        r"\cancel{m} a = \cancel{m} g \Rightarrow \boxed{9.6}",
        r"<div>\boxed{9.6}</div>",
        r"<!-- a --> \boxed{9.6}",
        r"<p style='display:none'>a</p> \boxed{9.6}",
        r"F = m~~a, so~~\boxed{9.6}",
        r"\boxed{9.6} (the task asked for \boxed{})",
        r"\boxed{9.6}. The answer stands in \boxed{ }.",
    ],
)
def test_what_stands_elsewhere_does_not_matter(response: str) -> None:
    assert number(response, 9.6).outcome is Outcome.CORRECT
