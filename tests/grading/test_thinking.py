"""Tests that the reasoning of models, in any of their public formats, is not an answer."""

import pytest

from sim2reason.grading import Outcome, number, opened

MARKS = [
    ("<think>", "</think>"),
    ("<THINK>", "</THINK>"),
    ("<thinking>", "</thinking>"),
    ("<thought>", "</thought>"),
    ("<reasoning>", "</reasoning>"),
    ("<seed:think>", "</seed:think>"),
    ("<longcat_think>", "</longcat_think>"),
    ("[THINK]", "[/THINK]"),
    ("◁think▷", "◁/think▷"),
    ("<|begin_of_thought|>", "<|end_of_thought|>"),
    ("<|START_THINKING|>", "<|END_THINKING|>"),
    ("<unused94>thought\n", "<unused95>"),
    ("<|inner_prefix|>", "<|inner_suffix|>"),
    ("<|channel>thought\n", "<channel|>"),
    ("<|channel|>analysis<|message|>", "<|end|><|start|>assistant<|channel|>final<|message|>"),
    ("analysis", "assistantfinal"),
    ("<reason>", "</reason>"),
    ("<|think_start|>", "<|think_end|>"),
    ("[unused16]", "[unused17]"),
    ("Here are my reasoning steps:\n", "\n[BEGIN FINAL RESPONSE]\n"),
    ("Here is my thought process:\n", "\n\nHere is my response:\n"),
    ("Here's my thought process: ", " Here's my response: "),
]


@pytest.mark.parametrize(("begin", "end"), MARKS, ids=[begin.strip() for begin, _ in MARKS])
def test_an_answer_counts_behind_the_thinking_alone(begin: str, end: str) -> None:
    assert number(rf"{begin}We try \boxed{{4.8}}.{end}It is \boxed{{9.6}}.", 9.6).outcome is Outcome.CORRECT
    assert number(rf"{begin}We try \boxed{{9.6}}.{end}I give up.", 9.6).outcome is Outcome.NO_ANSWER
    assert number(rf"{begin}We try \boxed{{9.6}}, but let me check", 9.6).outcome is Outcome.NO_ANSWER
    assert number(rf"We try \boxed{{9.6}}.{end}I give up.", 9.6).outcome is Outcome.NO_ANSWER


@pytest.mark.parametrize(
    "response",
    [
        r"\boxed{9.6} (as I said inside <think>)",
        r"<think>a</think>\boxed{9.6}, which I found within <think>",
        r"Analysis of the forces gives \boxed{9.6}.",
        r"analysis: the weight, so \boxed{9.6}",
        r"For x < 2 and y > 3 we get \boxed{9.6}",
    ],
)
def test_what_only_speaks_of_thinking_hides_nothing(response: str) -> None:
    assert number(response, 9.6).outcome is Outcome.CORRECT


@pytest.mark.parametrize(
    "response",
    [
        r"\boxed{9.6} or so. <think> No: \boxed{9.6}",
        "\\boxed{9.6}\n<think> wait",
        r"<think>a</think><think>\boxed{9.6}",
        r"Let me see <think> \boxed{9.6}",
    ],
)
def test_thinking_that_is_open_at_the_end_has_no_answer(response: str) -> None:
    assert number(response, 9.6).outcome is Outcome.NO_ANSWER


def test_thinking_may_have_been_opened_in_the_prompt() -> None:
    assert number(opened(r"We try \boxed{9.6}, but"), 9.6).outcome is Outcome.NO_ANSWER
    assert number(opened(r"We try.</think>\boxed{9.6}"), 9.6).outcome is Outcome.CORRECT
    assert number(opened(r"<think>We try.</think>\boxed{9.6}"), 9.6).outcome is Outcome.CORRECT


def test_a_flood_of_marks_takes_no_time_and_earns_nothing() -> None:
    for piece in ("<", "</", "<think>", "</think", "[THINK]", "[unused16]", "<|channel|>", "assistantfinal"):
        assert not number(piece * (900_000 // len(piece)), 9.6).reward
