"""Filters of texts: their length, and numbers that a figure or a word would have to give."""

from collections.abc import Iterable, Iterator
from typing import cast

from sim2reason.generation.filters import FILTERS, Candidate, Filter
from sim2reason.questions import Study
from sim2reason.questions.study import ENOUGH
from sim2reason.scenes.dsl.model import Model, field_types
from sim2reason.scenes.dsl.scene import Scene

SAME = 1e-6  # relative


class HiddenNumbers(Filter):
    """The answer changes, or there is none, with every hidden length at the low end of its range."""

    order = 5

    def reason(self, candidate: Candidate) -> str:
        """Solve the scene with its strings as short as they may be drawn, and ask again."""
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
        return "" if again is not None and abs(again - answer) <= SAME * abs(answer) else "a hidden length matters"

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield the answer then."""
        tight = _tight(candidate)
        again = candidate.response(tight) if tight is not candidate.study else None
        if again is not None:
            change = f"{candidate.change_to(again):.1e} of it away; {SAME:g} is allowed"
            yield f"with hidden lengths as short as may be the answer is {again:.4g}, {change}"


def _tight(candidate: Candidate) -> Study | None:
    """The motion with hidden lengths as short as may be; None if there is none, that of the scene if none is hidden."""
    study = candidate.study
    shorter = tightest(study.scene)
    return study if shorter is study.scene else study.variant(shorter, candidate.until, ENOUGH)


def tightest(scene: Scene) -> Scene:
    """Return the scene with every hidden number at the low end of what it may be drawn from."""
    for parameter in scene.parameters:
        if parameter.hidden and parameter.value is not None:
            owner, _, name = parameter.path.rpartition(".")
            held = field_types(cast("type[Model]", type(scene.value(owner))))[name]
            if held.drawn is not None and parameter.value != held.drawn.low:
                scene = scene.having(parameter.path, held.drawn.low)
    return scene


FILTERS.add("hidden numbers", HiddenNumbers())


LONGEST = 270  # words
LONGEST_STRING = 40  # words in a sentence about a string: more, and no finger can follow it


class Length(Filter):
    """The prompt has too many words."""

    order = 2

    def reason(self, candidate: Candidate) -> str:
        """Count words as a word processor does."""
        words = len(candidate.prompt.split())
        if words > LONGEST:
            return f"{words} words"
        return "" if followed(candidate.sentences) else f"more than {LONGEST_STRING} words about one string"

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield the count."""
        yield f"{len(candidate.prompt.split())} words of at most {LONGEST}"


def followed(sentences: Iterable[str]) -> bool:
    """Return whether no sentence about a string is so long that no finger can follow it."""
    return all(len(sentence.split()) <= LONGEST_STRING for sentence in sentences if "string" in sentence)


FILTERS.add("length", Length())
