"""One text with the solutions of two questions about one motion; the second uses results of the first."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

from sim2reason.grading.parts import LABELS
from sim2reason.solutions.multipart.in_sequence import UNCLEAR, sequential_solutions
from sim2reason.solutions.multipart.quantities import are_same_meaning, meanings, unit_of
from sim2reason.solutions.multipart.quoting import AS_IN_PART, SO, cited_labels
from sim2reason.solutions.multipart.recall import EARLIER
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.solution import Solution, Step
from sim2reason.solutions.writing.steps import SolutionBuilder

REFERENCES = EARLIER, "equations", "reference", "givens"
"""Kinds of steps that only quote an earlier part or the givens, and are left out in one text."""


def merge_into_one_text(
    settings: Sequence[ProblemContext], solutions: Sequence[Solution]
) -> tuple[list[Solution], list[Step]]:
    """Merge solutions into one text: return the solutions with consistent names, and all steps without given numbers.

    If a name is ambiguous, the solutions have no answer, and there are no steps.
    """
    parts, steps = sequential_solutions(settings, solutions, whole=True), list[Step]()
    if any(part.answer is None for part in parts) or not _have_clear_names(parts):
        return [replace(part, answer=None, reason=part.reason or UNCLEAR) for part in parts], []
    for part in parts:
        source = {name: step.id for step in steps for name in step.gives}
        if part.goal in source:  # with the same value, or names would not be clear
            continue
        kept = [step for step in part.steps if step.kind not in REFERENCES]
        places = {step.id: len(steps) + number for number, step in enumerate(kept)}
        steps += [_placed(step, places, source) for step in kept]
    return parts, steps


def _have_clear_names(parts: Sequence[Solution]) -> bool:
    """Return whether no symbol is introduced twice with different words."""
    said: dict[str, str] = {}
    introduced = (pair for part in parts for pair in meanings(part).items())
    return all(are_same_meaning(name, said.setdefault(name, words), words) for name, words in introduced)


def _placed(step: Step, places: Mapping[int, int], source: Mapping[str, int]) -> Step:
    """Return a step renumbered for the whole text, with the new numbers of the steps that it needs."""
    needs = {places[need] for need in step.needs if need in places}
    needs |= {source[name] for name in (*step.symbols(), *cited_labels(step.text)) if name in source}
    text = step.text.replace(AS_IN_PART.format(LABELS[0]), SO)
    return replace(step, id=places[step.id], needs=tuple(sorted(needs)), text=text)


def enter(part: Solution, book: SolutionBuilder) -> None:
    """Record the names, values and stated numbers of a solution in a solution builder."""
    said = {name: text for step in part.steps if step.kind == "givens" for name, text in _stated(part, step.text)}
    book.stated |= {name: said[name] for name in part.stated if name in said}
    book.constants |= part.constants
    for name, value in part.values.items():
        if name not in book.values:
            book.reserve(name)
            book.set_value(name, value, unit_of(name, part))
    book.keen = max(book.keen, part.keen)


def _stated(part: Solution, givens: str) -> list[tuple[str, str]]:
    """Return name and value with unit of each number that the question states, from the list of given numbers."""
    equations = (formula.partition(" = ") for formula in givens.split("$")[1::2])
    return [(name, said) for name, _, said in equations if name in part.stated]
