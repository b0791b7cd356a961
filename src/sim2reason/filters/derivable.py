"""Drops a question of a kind that calls for a derivation where only a numerical integration leads to the answer."""

from collections.abc import Iterator
from dataclasses import replace

from sim2reason.filters import FILTERS, Candidate, Filter
from sim2reason.solutions import STRATEGIES, Setting, by
from sim2reason.solutions.reverse import forward


class Derivable(Filter):
    """No worked solution derives the answer, as nobody would on paper, though the kind of question calls for that."""

    order = 9

    def reason(self, candidate: Candidate) -> str:
        """Try every strategy that integrates nothing."""
        return "only an integration leads to it" if candidate.kind.derivable and not _derived(candidate) else ""

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """The strategy that leads to the answer."""
        if candidate.kind.derivable and (found := _derived(candidate)):
            yield f"it is derived by: {found}"


def _derived(candidate: Candidate) -> str:
    """The strategy by which it is; empty if there is none."""
    query, study = candidate.question.query, candidate.study
    return study.once(("derived by", query), lambda: _found(candidate))


def _found(candidate: Candidate) -> str:
    query, study, words = candidate.question.query, candidate.study, candidate.words
    if words is None or not words.symbols or study.mechanism is not study.scene.mechanism:
        return "none that is known"
    setting = forward(Setting(study.scene, words, words.symbols, study, query))
    if not query.hides:
        setting = replace(setting, unknown="", stated=None, sought=None)
    offered = (held for held in STRATEGIES.values() if query.kind in held.kinds and not held.integrates)
    tried = sorted(offered, key=lambda held: held.cost)
    return next((held.name for held in tried if by(held, setting).answer is not None), "")


FILTERS.add("derivable", Derivable())
