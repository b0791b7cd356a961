"""The worked solution that shows what a question needs, found before the question is written or its answer solved for.

Nothing is integrated numerically on the way: where only that would lead to the answer, the solution has none.
"""

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.questions import Query, StatedResult, Study, Words
from sim2reason.questions.need import Need
from sim2reason.solutions.setting import Setting
from sim2reason.solutions.solution import Solution
from sim2reason.solutions.solve import solve
from sim2reason.solutions.strategies import STRATEGIES

FOUND = "shortest solution"


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
    found = study.once(("shortest", query, unknown, stated, most), lambda: solve(setting))
    if found.answer is not None and not unknown and stated is None:
        study.once((FOUND, query), lambda: found)
    return found


def shortest_known(query: Query, study: Study) -> Solution | None:
    """Return the solution of a query if one was found before."""
    return study.once((FOUND, query), lambda: Solution("")) if study.knows((FOUND, query)) else None


def may_be_solved(mechanism: Mechanism) -> bool:
    """Return whether any strategy that does not integrate may apply to a mechanism, judged before it is simulated."""
    return any(not strategy.integrates and not strategy.unfit(mechanism) for strategy in STRATEGIES.values())
