"""Equations that a later part does not use, because the result of an earlier part replaces them."""

import re
from collections.abc import Callable, Sequence
from dataclasses import replace

from sim2reason.solutions.multipart.quantities import introduced, names_of
from sim2reason.solutions.multipart.quoting import DEFINED, SENTENCE, labelled, referred, shortened
from sim2reason.solutions.multipart.recall import EARLIER, given_for, renumbered
from sim2reason.solutions.multipart.renaming import spoken
from sim2reason.solutions.solution import Solution, Step

_HEADING = re.compile(r"(?:In numbers|With numbers for the coefficients): ")  # of one equation, and of those after it
_UNLABELLED = frozenset(("constraint", "combine"))  # kinds of steps of one equation each


def without_unused(solution: Solution, accepted: Callable[[Solution], bool]) -> Solution:
    """Return a part without the equations to which it does not refer and without which the check accepts it.

    A solution that recalls no earlier result is returned unchanged.
    """
    if not any(step.kind == EARLIER for step in solution.steps):
        return solution
    steps = solution.steps
    while (shorter := _shorter(steps, lambda trial: accepted(replace(solution, steps=trial)))) != steps:
        steps = shorter
    found = replace(solution, steps=_tidied(steps))
    return found if accepted(found) else solution


def _shorter(steps: tuple[Step, ...], accepted: Callable[[tuple[Step, ...]], bool]) -> tuple[Step, ...]:
    """Return the steps without idle equations, from the last one on.

    The text does not say on which equations those in numbers rest; where some remain, so do all before them.
    """
    for place in reversed(range(len(steps))):
        headed = _HEADING.match(steps[place].text)
        if headed and any(DEFINED.search(step.text) for step in steps[place + 1 :]):
            break
        for equation in reversed(_equations(steps[place])):
            others = (*steps[:place], *steps[place + 1 :])
            if any(label in referred(step.text) for step in others for label, _ in DEFINED.findall(equation)):
                continue
            trial = (*steps[:place], _without(steps[place], equation), *steps[place + 1 :])
            steps = trial if accepted(trial) else steps
        if headed and steps[place].text:
            break
    return steps


def _equations(step: Step) -> list[str]:
    """Return the equations of a step that may be left out, each with its label."""
    sentences = SENTENCE.split(_HEADING.sub("", step.text))
    return sentences if step.kind in _UNLABELLED or all(map(DEFINED.match, sentences)) else []


def _without(step: Step, equation: str) -> Step:
    """Return a step without one of its equations; one without a text if none is left."""
    text = " ".join(each for each in _equations(step) if each != equation)
    return replace(step, text=text, relations=tuple(r for r in step.relations if r.latex() in text))


def _tidied(steps: Sequence[Step]) -> tuple[Step, ...]:
    """Return the steps that have a text, with givens and introductions of the names in use, and new labels."""
    left = [step for step in steps if step.text]
    rest = [step for step in left if step.kind not in ("givens", "names")]
    used = spoken(" ".join(step.text for step in rest)) | {*names_of(rest)}
    left = [_in_use(step, used) for step in left]
    labels = dict.fromkeys(label for step in left for label, _ in DEFINED.findall(step.text))
    names = {label: f"({number})" for number, label in enumerate(labels, start=1)}
    return renumbered([labelled(step, names) for step in left if step.text])


def _in_use(step: Step, used: frozenset[str]) -> Step:
    """Return a step that introduces names, given or in words, without those that are not in use."""
    if step.kind == "givens":
        return given_for(step, used)
    if step.kind != "names":
        return step
    sentences = (
        shortened(each, lambda item: not used.isdisjoint(introduced(item))) for each in SENTENCE.split(step.text)
    )
    return replace(step, text=" ".join(sentence for sentence in sentences if sentence))
