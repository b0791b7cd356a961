"""Tests of the equations that results of eliminations are attributed to, substituted ones included."""

import re
from collections.abc import Iterator

from sim2reason.solutions import solve, solve_prompt
from worked import problems

SYMBOL = re.compile(r"[A-Za-z](?:_\{[^{}]*\}|_[A-Za-z0-9])?(?![a-z])")
LABELLED = re.compile(r"(?<!\S)(\(\d+\)) (?:[^$()]*: )?\$([^$]*=[^$]*)\$")
FROM = re.compile(r"From ((?:\(\d+\)(?:, | and )?)+),? \$([^$=]*) = ")

HUNG = """Crate A (3.7 kg) rests on a rough, fixed plane inclined at 51° to the horizontal. The coefficient of \
friction (static and kinetic) on this plane is 0.19. Crate B (7.6 kg) is tied by a light string to the axle of a light \
movable pulley P. Another light string is tied to crate A; it runs up the slope, passes over a light fixed \
pulley Q, goes straight down, under P and straight up again and ends at a fixed hook. All bodies are held at \
rest with all strings taut, and let go together. The pulleys are frictionless, and no body reaches a pulley. \
Take g = 9.8 m/s². After the release, what is the tension in the string between the axle of pulley P and crate \
B? Give your answer in N, to three significant figures, inside \\boxed{}."""


def results(text: str) -> Iterator[tuple[str, str, list[str]]]:
    """Yield each result as its text, its symbol and the equations that the text attributes it to."""
    equations = dict(LABELLED.findall(text))
    for labels, symbol in FROM.findall(text):
        yield text, symbol, [equations[label] for label in re.findall(r"\(\d+\)", labels)]


def test_a_result_stands_in_an_equation_that_it_is_attributed_to() -> None:
    """A result for T2 isn't attributed to equation (3) alone, which has only T1."""
    found = solve_prompt(HUNG)[0].text
    held = [result for text in (found, *_drawn()) for result in results(text)]
    assert len(held) > 2
    for text, symbol, equations in held:
        assert any(symbol in SYMBOL.findall(equation) for equation in equations), text


def test_equations_that_are_put_into_others_are_named() -> None:
    """The tensions cancel in twice (1) plus (3) only by the balance at the pulley, (2), so the text names (2)."""
    assert "(1) + (3), with (2)" in solve_prompt(HUNG)[0].text


def _drawn() -> Iterator[str]:
    for recipe in ("pulley", "incline"):
        yield from (solve(setting).text for setting in problems(recipe, "hard", 5, kinds=("start",)))
