"""Strategies for worked solutions: each states which problems it can solve at which cost, and writes the solution."""

from abc import ABC, abstractmethod
from typing import ClassVar

from sim2reason.base.registry import Registry
from sim2reason.questions import Moment
from sim2reason.questions.difficulty import Need
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.structure import changing
from sim2reason.solutions.goals import GOALS
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.writing.steps import SolutionBuilder


class Strategy(ABC):
    """A method for deriving worked solutions of one family of problems.

    Class data:
        name: the name under which it is registered.
        cost: typical length of its solutions; applicable strategies are tried in the order of cost.
        kinds: the kinds of questions that it can answer.
        least_need: the mathematics that each of its solutions needs at least.
        integrates: whether the answer comes from numerical integration instead of a derivation.
        nested: whether it delegates an inner question to other strategies, as a comparison does.
        finished: whether its steps are ordered and merged for the text already.
        drawn: whether it may answer generated questions, and not only those that users ask.
    """

    name: ClassVar[str]
    cost: ClassVar[float]
    kinds: ClassVar[frozenset[str]] = frozenset({"start", "state", "event", "time_to_event"})
    integrates: ClassVar[bool] = False
    least_need: ClassVar[Need] = Need.ARITHMETIC
    nested: ClassVar[bool] = False
    finished: ClassVar[bool] = False
    drawn: ClassVar[bool] = True

    def why_unsuitable(self, mechanism: Mechanism) -> str:
        """Return the reason, in words, that the strategy cannot apply to a mechanism; by default empty: it may."""
        del mechanism
        return ""

    def formulas(self, mechanism: Mechanism) -> frozenset[str]:
        """Return the question kinds that have a compact formula for a mechanism; by default all kinds of the strategy.

        For other kinds it needs intermediate numbers, or its formulas become too long.
        """
        del mechanism
        return frozenset[str]() if self.integrates else self.kinds

    @abstractmethod
    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""

    @abstractmethod
    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write all steps and return the symbol of the answer; raise UnsolvedError if the derivation fails."""


STRATEGIES: Registry[Strategy] = Registry("solutions.strategies")


def strategy(cls: type[Strategy]) -> type[Strategy]:
    """Register a strategy under its name; a class decorator."""
    STRATEGIES.add(cls.name, cls())
    return cls


def applicable_strategies(mechanism: Mechanism) -> list[Strategy]:
    """Return the strategies that may apply to a mechanism, those of lowest cost first."""
    fit = (candidate for candidate in STRATEGIES.values() if not candidate.why_unsuitable(mechanism))
    return mechanism.memoize("fitting strategies", lambda: sorted(fit, key=lambda candidate: candidate.cost))


def strategies_for_kind(kind: str, mechanism: Mechanism, *, derived: bool = False) -> list[Strategy]:
    """Return the strategies that may answer a kind of question about a mechanism, those of lowest cost first.

    With `derived`, only those that lead to formulas.
    """
    own = [candidate for candidate in applicable_strategies(mechanism) if kind in candidate.kinds]
    return [candidate for candidate in own if not derived or kind in candidate.formulas(mechanism)]


def deriving_strategies(kind: str, mechanism: Mechanism) -> list[Strategy]:
    """Return the strategies that may derive a formula for a kind of question without calling other strategies."""
    return mechanism.memoize(
        ("deriving strategies", kind),
        lambda: [candidate for candidate in strategies_for_kind(kind, mechanism, derived=True) if not candidate.nested],
    )


def closed_form_strategies(kind: str, mechanism: Mechanism) -> list[Strategy]:
    """Return the strategies that may answer a kind of question without numerical integration."""
    return [candidate for candidate in strategies_for_kind(kind, mechanism) if not candidate.integrates]


def varying_acceleration(mechanism: Mechanism) -> str:
    """Return the reason, in words, that accelerations vary between events; empty if accelerations are constant."""
    return "accelerations change as it moves" if changing(mechanism) else ""


def missing_goal(setting: ProblemContext, moments: tuple[type[Moment], ...]) -> str:
    """Return the reason that the moment (not one of `moments`) or quantity of a question is unsupported; or empty."""
    if not isinstance(setting.query.moment, moments):
        return f"no way to the moment {type(setting.query.moment).__name__}"
    target = setting.target
    if target is None or target.quantity in GOALS:
        return ""
    return f"no way to the quantity {target.quantity}"
