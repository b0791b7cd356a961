"""Filters on texts: their length, and numbers that only a figure could give."""

from collections.abc import Iterable, Iterator
from typing import cast

from sim2reason.generation.filters import FILTERS, Candidate, Filter
from sim2reason.questions import SimulatedScene
from sim2reason.questions.study import EXACT_STEP_ERROR
from sim2reason.scenes.dsl.model import Model, field_types
from sim2reason.scenes.dsl.scene import Scene

UNCHANGED_RTOL = 1e-6  # relative


class HiddenNumbers(Filter):
    """Filter for answers that depend on lengths which the text does not state."""

    order = 5

    def reason(self, candidate: Candidate) -> str:
        """Return a reason if the answer changes when all hidden lengths are at their minimum."""
        answer, query, kind = candidate.question.answer, candidate.question.query, candidate.kind
        tight = _tight(candidate)
        if tight is candidate.study:
            return ""
        if tight is None:
            return "with shorter strings there is no motion"
        time = kind.time(query, tight)
        if time is None or time > tight.trace.stable_until:
            return "with shorter strings the moment does not come"
        again = candidate.response(tight)
        return (
            ""
            if again is not None and abs(again - answer) <= UNCHANGED_RTOL * abs(answer)
            else "a hidden length matters"
        )

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield a report line with the answer for which all hidden lengths are at their minimum."""
        tight = _tight(candidate)
        again = candidate.response(tight) if tight is not candidate.study else None
        if again is not None:
            change = f"{candidate.change_to(again):.1e} of it away; {UNCHANGED_RTOL:g} is allowed"
            yield f"with hidden lengths as short as may be the answer is {again:.4g}, {change}"


def _tight(candidate: Candidate) -> SimulatedScene | None:
    """Return the motion with hidden lengths at their minimum; None if there is none."""
    study = candidate.study
    shorter = with_minimum_lengths(study.scene)
    return study if shorter is study.scene else study.variant(shorter, candidate.until, EXACT_STEP_ERROR)


def with_minimum_lengths(scene: Scene) -> Scene:
    """Return the scene with every hidden number at the lower end of its range."""
    for parameter in scene.parameters:
        if parameter.hidden and parameter.value is not None:
            owner, _, name = parameter.path.rpartition(".")
            held = field_types(cast("type[Model]", type(scene.value(owner))))[name]
            if held.drawn is not None and parameter.value != held.drawn.low:
                scene = scene.having(parameter.path, held.drawn.low)
    return scene


FILTERS.add("hidden numbers", HiddenNumbers())


MAX_WORDS = 270  # words
MAX_STRING_WORDS = 40  # words in a sentence about a string; longer ones are hard to follow


class Length(Filter):
    """Filter for prompts with too many words."""

    order = 2

    def reason(self, candidate: Candidate) -> str:
        """Return a reason if the prompt has too many words, counted as a word processor does."""
        words = len(candidate.prompt.split())
        if words > MAX_WORDS:
            return f"{words} words"
        return "" if is_followable(candidate.sentences) else f"more than {MAX_STRING_WORDS} words about one string"

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield a report line with the number of words in the prompt."""
        yield f"{len(candidate.prompt.split())} words of at most {MAX_WORDS}"


def is_followable(sentences: Iterable[str]) -> bool:
    """Return whether all sentences about strings are short enough to follow."""
    return all(len(sentence.split()) <= MAX_STRING_WORDS for sentence in sentences if "string" in sentence)


FILTERS.add("length", Length())
