"""The shortest worked solution of a question, found before the question is written or inverted.

Numerical integration is not used: if only that would lead to the answer, the solution has none.
"""

from collections.abc import Hashable

from sim2reason.questions import Query, StatedResult, Study, Words
from sim2reason.questions.need import Need
from sim2reason.solutions.reverse import forward
from sim2reason.solutions.setting import Setting
from sim2reason.solutions.solution import Solution
from sim2reason.solutions.solve import solve
from sim2reason.solutions.strategies import closed
from sim2reason.solutions.verification import verified

FOUND, SHORTEST = "shortest solution", "shortest"


def shortest(
    query: Query,
    study: Study,
    words: Words,
    unknown: str = "",
    stated: StatedResult | None = None,
    most: Need = Need.SPECIAL_FUNCTION,
) -> Solution:
    """Return the solution of a query, or of the question for the `unknown` with the `stated` result; cached.

    The mathematics of a solution may not exceed `most`. `unknown` is the address of a parameter of the scene. The data
    of the solution are only recomputed by `shortest_checked`, since filters reject most questions before.
    """
    setting = _setting(query, study, words, unknown, stated, most)
    found = study.once(_key(query, unknown, stated, setting.most), lambda: solve(setting, checked=False))
    if found.answer is not None and not unknown and stated is None:
        study.once((FOUND, query), lambda: found)
    return found


def shortest_checked(
    query: Query, study: Study, words: Words, unknown: str, stated: StatedResult | None, most: Need
) -> Solution:
    """Return the shortest solution whose answer is recomputed from its own data."""
    found = shortest(query, study, words, unknown, stated, most)
    setting = _setting(query, study, words, unknown, stated, most)
    if found.answer is None or verified(found, forward(setting)).answer is not None:
        return found
    return study.keep(_key(query, unknown, stated, setting.most), solve(setting))


def _setting(
    query: Query, study: Study, words: Words, unknown: str, stated: StatedResult | None, most: Need
) -> Setting:
    most = min(most, Need.SPECIAL_FUNCTION)
    return Setting(study.scene, words, words.symbols, study, query, unknown, stated, most=most)


def is_solved(query: Query, study: Study, unknown: str, stated: StatedResult | None, most: Need) -> bool:
    """Return whether `shortest` has a cached solution for these arguments."""
    return study.knows(_key(query, unknown, stated, min(most, Need.SPECIAL_FUNCTION)))


def _key(query: Query, unknown: str, stated: StatedResult | None, most: Need) -> Hashable:
    return SHORTEST, query, unknown, stated, most


def shortest_known(query: Query, study: Study) -> Solution | None:
    """Return the cached solution of a query; None if there is none."""
    return study.once((FOUND, query), lambda: Solution("")) if study.knows((FOUND, query)) else None


def may_have_solution(kind: str, study: Study, most: Need) -> bool:
    """Return whether a strategy that needs no more than `most` may answer questions of a kind."""
    found = study.once(("needed least", kind), lambda: [each.least_need for each in closed(kind, study.mechanism)])
    return min(found, default=Need.INTEGRATION) <= most
