"""The worked solution that shows what a question needs, found before the question is written or its answer solved for.

Nothing is integrated numerically on the way: where only that would lead to the answer, the solution has none.
"""

from collections.abc import Hashable

from sim2reason.questions import Query, StatedResult, Study, Words
from sim2reason.questions.need import Need
from sim2reason.solutions.setting import Setting
from sim2reason.solutions.solution import Solution
from sim2reason.solutions.solve import solve
from sim2reason.solutions.strategies import closed

FOUND, SHORTEST = "shortest solution", "shortest"


def shortest(
    query: Query,
    study: Study,
    words: Words,
    unknown: str = "",
    stated: StatedResult | None = None,
    most: Need = Need.SPECIAL_FUNCTION,
) -> Solution:
    """Return the solution of a query, or of the question for the `unknown` that has the `stated` result.

    One that needs more than `most` is none. It is worked out once for a study. `unknown` is the address of a number of
    the scene.
    """
    most = min(most, Need.SPECIAL_FUNCTION)
    setting = Setting(study.scene, words, words.symbols, study, query, unknown, stated, most=most)
    found = study.once(_key(query, unknown, stated, most), lambda: solve(setting))
    if found.answer is not None and not unknown and stated is None:
        study.once((FOUND, query), lambda: found)
    return found


def is_solved(query: Query, study: Study, unknown: str, stated: StatedResult | None, most: Need) -> bool:
    """Return whether `shortest` was asked for this before, so that its solution costs nothing."""
    return study.knows(_key(query, unknown, stated, min(most, Need.SPECIAL_FUNCTION)))


def _key(query: Query, unknown: str, stated: StatedResult | None, most: Need) -> Hashable:
    return SHORTEST, query, unknown, stated, most


def shortest_known(query: Query, study: Study) -> Solution | None:
    """Return the solution of a query if one was found before."""
    return study.once((FOUND, query), lambda: Solution("")) if study.knows((FOUND, query)) else None


def may_have_solution(kind: str, study: Study, most: Need) -> bool:
    """Return whether any strategy that needs no more than `most` may have a way to questions of a kind."""
    found = study.once(("needed least", kind), lambda: [each.least_need for each in closed(kind, study.mechanism)])
    return min(found, default=Need.INTEGRATION) <= most
