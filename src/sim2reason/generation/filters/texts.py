"""Filters on the texts of a problem: its prompt and its worked solution."""

from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import cast

from sim2reason.generation.filters import FILTERS, Candidate, Filter
from sim2reason.questions import SimulatedScene
from sim2reason.questions.difficulty import EVERY
from sim2reason.questions.study import EXACT_STEP_ERROR
from sim2reason.scenes.dsl.model import Model, field_types
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.solutions import STRATEGIES, ProblemContext, solve_with
from sim2reason.solutions.difficulty import LABELS
from sim2reason.solutions.reverse import forward

UNCHANGED_RTOL = 1e-6  # relative


class HiddenNumbers(Filter):
    """Filter for answers that depend on lengths which the text does not state."""

    order = 5

    def reason(self, candidate: Candidate) -> str:
        """Return a reason if the answer changes when all hidden lengths are at their minimum."""
        answer, query, kind = candidate.question.answer, candidate.question.query, candidate.kind
        tight = _tight_motion(candidate)
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
        tight = _tight_motion(candidate)
        again = candidate.response(tight) if tight is not candidate.study else None
        if again is not None:
            change = f"{candidate.change_to(again):.1e} of it away; {UNCHANGED_RTOL:g} is allowed"
            yield f"with hidden lengths as short as may be the answer is {again:.4g}, {change}"


def _tight_motion(candidate: Candidate) -> SimulatedScene | None:
    """Return the motion with hidden lengths at their minimum; None if there is none."""
    study = candidate.study
    shorter = with_minimum_lengths(study.scene)
    return study if shorter is study.scene else study.variant(shorter, candidate.until, EXACT_STEP_ERROR)


def with_minimum_lengths(scene: Scene) -> Scene:
    """Return the scene with every hidden number at the lower end of its range."""
    for parameter in scene.parameters:
        if parameter.hidden and parameter.value is not None:
            owner, _, name = parameter.path.rpartition(".")
            field = field_types(cast("type[Model]", type(scene.value(owner))))[name]
            if field.drawn is not None and parameter.value != field.drawn.low:
                scene = scene.having(parameter.path, field.drawn.low)
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


class Derivable(Filter):
    """Filter for answers without a worked solution, for question kinds that require one."""

    order = 9

    def reason(self, candidate: Candidate) -> str:
        """Return a reason if no strategy derives the answer without numerical integration."""
        return "only an integration leads to it" if candidate.kind.derivable and not _derived(candidate) else ""

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield a report line with the strategy that derives the answer."""
        if candidate.kind.derivable and (strategy := _derived(candidate)):
            yield f"it is derived by: {strategy}"


def _derived(candidate: Candidate) -> str:
    """Return the name of the strategy that derives the answer; empty if there is none."""
    query, study = candidate.question.query, candidate.study
    return study.memoize(("derived by", query), lambda: _found(candidate))


def _found(candidate: Candidate) -> str:
    query, study, words = candidate.question.query, candidate.study, candidate.words
    if words is None or not words.symbols or study.mechanism is not study.scene.mechanism:
        return "none that is known"
    setting = forward(ProblemContext(study.scene, words, words.symbols, study, query))
    if not query.hides:
        setting = replace(setting, unknown="", stated=None, sought=None)
    offered = (strategy for strategy in STRATEGIES.values() if query.kind in strategy.kinds and not strategy.integrates)
    strategies = sorted(offered, key=lambda strategy: strategy.cost)
    return next((strategy.name for strategy in strategies if solve_with(strategy, setting).answer is not None), "")


FILTERS.add("derivable", Derivable())


TOO_EASY, TOO_HARD = "too easy", "too hard"
COUNTED = frozenset({f"difficulty: {TOO_EASY}", f"difficulty: {TOO_HARD}"})
"""Under which names a manifest counts what it refuses."""


class FitsLabel(Filter):
    """Filter for questions whose difficulty score lies outside the range of the difficulty label.

    Questions without a label pass, and so do those that only an integration answers.
    """

    order = 5

    def ready(self, candidate: Candidate) -> bool:
        """Return whether the shortest solution is cached; if so, this filter is cheap enough to run first."""
        return candidate.is_solved

    def reason(self, candidate: Candidate) -> str:
        """Return a reason if the difficulty score lies outside the range of the difficulty label."""
        if not candidate.labelled or candidate.measured is None:
            return ""
        score, band = candidate.measured.score, LABELS[candidate.difficulty]
        if score in band:
            return ""
        return f"{TOO_HARD if score > band.most else TOO_EASY}: a score of {score} for {candidate.difficulty}"

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield a report line with the laws, phases, unknowns and difficulty score of the worked solution."""
        difficulty = candidate.measured
        if difficulty is not None:
            sizes = f"laws {difficulty.laws}, phases {difficulty.phases}, unknowns together {difficulty.unknowns}"
            yield f"{sizes}, score {difficulty.score}"


FILTERS.add("difficulty", FitsLabel())


class Needs(Filter):
    """Filter for questions whose shortest worked solution needs mathematics that is not allowed.

    By default only a small share of questions may need more than elementary mathematics; see `datasets.needs`.
    """

    order = 5

    def ready(self, candidate: Candidate) -> bool:
        """Return whether the shortest solution is cached; if so, this filter is cheap enough to run first."""
        return candidate.is_solved

    def reason(self, candidate: Candidate) -> str:
        """Return a reason if the worked solution needs mathematics that is not allowed."""
        if candidate.needs == EVERY or candidate.solution is None:
            return ""
        need = candidate.solution.needs
        return "" if need in candidate.needs else f"{need.label}: it needs that"

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield a report line with the mathematics that the worked solution needs."""
        if candidate.solution is not None:
            strategy = candidate.solution.strategy
            yield f"{candidate.solution.needs.label}, by {strategy or 'nothing but integration'}"


FILTERS.add("needs", Needs())
