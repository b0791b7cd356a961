"""Filters on the worked solution."""

from collections.abc import Iterator
from dataclasses import replace

from sim2reason.generation.filters import FILTERS, Candidate, Filter
from sim2reason.questions.difficulty import EVERY
from sim2reason.solutions import STRATEGIES, ProblemContext, solve_with
from sim2reason.solutions.difficulty import LABELS
from sim2reason.solutions.reverse import forward


class Derivable(Filter):
    """Filter for answers without a worked solution, for question kinds that require one."""

    order = 9

    def reason(self, candidate: Candidate) -> str:
        """Return a reason if no strategy derives the answer without numerical integration."""
        return "only an integration leads to it" if candidate.kind.derivable and not _derived(candidate) else ""

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield a report line with the strategy that derives the answer."""
        if candidate.kind.derivable and (found := _derived(candidate)):
            yield f"it is derived by: {found}"


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
    offered = (held for held in STRATEGIES.values() if query.kind in held.kinds and not held.integrates)
    tried = sorted(offered, key=lambda held: held.cost)
    return next((held.name for held in tried if solve_with(held, setting).answer is not None), "")


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
        found = candidate.measured
        if found is not None:
            yield f"laws {found.laws}, phases {found.phases}, unknowns together {found.unknowns}, score {found.score}"


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
