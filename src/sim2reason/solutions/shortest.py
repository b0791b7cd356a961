"""The worked solution that shows what a question needs, found before the question is written or its answer solved for.

Nothing is integrated numerically on the way: where only that would lead to the answer, the solution has none.
"""

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.questions import Query, Question, StatedResult, Study, Words
from sim2reason.solutions.derivation import derivation
from sim2reason.solutions.setting import Setting
from sim2reason.solutions.solution import Solution
from sim2reason.solutions.solve import solve
from sim2reason.solutions.strategies import STRATEGIES


def shortest(
    query: Query, study: Study, words: Words, unknown: str = "", stated: StatedResult | None = None
) -> Solution:
    """Return the solution of a query, or of the question for the `unknown` that has the `stated` result.

    It is worked out once for a study. `unknown` is the address of a number of the scene.
    """
    setting = Setting(study.scene, words, words.symbols, study, query, unknown, stated)
    return study.once(("shortest", query, unknown, stated), lambda: solve(setting, integrate=False))


def shortest_of(question: Question, study: Study, words: Words) -> Solution:
    """Return the solution of a question about its own motion; of one in symbols, the derivation of its formula."""
    if question.formula is not None:
        return derivation(question.query, study, words)
    return shortest(question.query, study, words, question.unknown, question.given)


def may_be_solved(mechanism: Mechanism) -> bool:
    """Return whether any strategy that does not integrate may apply to a mechanism, judged before it is simulated."""
    return any(not strategy.integrates and not strategy.unfit(mechanism) for strategy in STRATEGIES.values())
