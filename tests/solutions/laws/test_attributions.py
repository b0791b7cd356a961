"""Results of eliminations name all equations that they come from: those that were put into others, too."""

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
    """Each result with its symbol and the equations that it is said to come from."""
    equations = dict(LABELLED.findall(text))
    for labels, symbol in FROM.findall(text):
        yield text, symbol, [equations[label] for label in re.findall(r"\(\d+\)", labels)]


def test_a_result_stands_in_an_equation_that_it_is_attributed_to() -> None:
    """From (3), which holds T1, no T2 follows alone."""
    found = solve_prompt(HUNG)[0].text
    held = [result for text in (found, *_drawn()) for result in results(text)]
    assert len(held) > 2
    for text, symbol, equations in held:
        assert any(symbol in SYMBOL.findall(equation) for equation in equations), text


def test_equations_that_are_put_into_others_are_named() -> None:
    """Twice the first and the third have no tension left only by the balance at the pulley, (2)."""
    assert "(1) + (3), with (2)" in solve_prompt(HUNG)[0].text


def _drawn() -> Iterator[str]:
    for recipe in ("pulley", "incline"):
        yield from (solve(setting).text for setting in problems(recipe, "hard", 5, kinds=("start",)))
