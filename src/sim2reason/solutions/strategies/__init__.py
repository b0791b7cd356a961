"""Strategies, one a file: which problems each can solve, at what cost, and how it writes the solution."""

from abc import ABC, abstractmethod
from typing import ClassVar

from sim2reason.base.registry import Registry
from sim2reason.questions import Moment
from sim2reason.questions.need import Need
from sim2reason.scenes.dsl.constancy import changing
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.solutions.goals import GOALS
from sim2reason.solutions.setting import Setting
from sim2reason.solutions.writing.steps import Book


class Strategy(ABC):
    """A way to solve problems of one family.

    Class data:
        name: under which it is registered.
        cost: how long its solutions are compared with others'; the cheapest that applies is written.
        kinds: of questions that it can answer.
        least_need: the mathematics that each of its solutions takes at least.
        integrates: whether it derives nothing, and the answer is what a numerical integration gives.
        nested: whether it leaves to other strategies what its question is about, as a comparison does.
        finished: whether its steps are ordered and merged already as a text shows them.
    """

    name: ClassVar[str]
    cost: ClassVar[float]
    kinds: ClassVar[frozenset[str]] = frozenset({"start", "state", "event", "time_to_event"})
    integrates: ClassVar[bool] = False
    least_need: ClassVar[Need] = Need.ARITHMETIC
    nested: ClassVar[bool] = False
    finished: ClassVar[bool] = False

    def unfit(self, mechanism: Mechanism) -> str:
        """Why it applies to nothing that could be asked about a mechanism, in a few words; by default it may apply."""
        del mechanism
        return ""

    def formulas(self, mechanism: Mechanism) -> frozenset[str]:
        """The kinds of question about a mechanism that it answers by formulas which may fit into a box; by default all.

        Elsewhere it finds numbers on the way, or what it writes only grows.
        """
        del mechanism
        return frozenset[str]() if self.integrates else self.kinds

    @abstractmethod
    def refusal(self, setting: Setting) -> str:
        """Return why it does not apply to a question about a mechanism for which it is not unfit; empty if it does."""

    @abstractmethod
    def write(self, setting: Setting, book: Book) -> str:
        """Write all steps, and say which symbol is the answer, in SI units; UnsolvedError where it finds no way."""


STRATEGIES: Registry[Strategy] = Registry("solutions.strategies")


def strategy(cls: type[Strategy]) -> type[Strategy]:
    """Enter a strategy under its name."""
    STRATEGIES.add(cls.name, cls())
    return cls


def fitting(mechanism: Mechanism) -> list[Strategy]:
    """Return the strategies that are fit for a mechanism, the cheapest first."""
    fit = (held for held in STRATEGIES.values() if not held.unfit(mechanism))
    return mechanism.once("fitting strategies", lambda: sorted(fit, key=lambda held: held.cost))


def offered(kind: str, mechanism: Mechanism, *, derived: bool = False) -> list[Strategy]:
    """Return the strategies that may answer a kind of question about a mechanism, the cheapest first.

    With `derived`, only those that lead to formulas.
    """
    own = [held for held in fitting(mechanism) if kind in held.kinds]
    return [held for held in own if not derived or kind in held.formulas(mechanism)]


def deriving(kind: str, mechanism: Mechanism) -> list[Strategy]:
    """Return the strategies that may lead to a formula for a kind of question which is about no other question."""
    return mechanism.once(
        ("deriving strategies", kind),
        lambda: [held for held in offered(kind, mechanism, derived=True) if not held.nested],
    )


def closed(kind: str, mechanism: Mechanism) -> list[Strategy]:
    """Return the strategies that may answer a kind of question without any numerical integration."""
    return [held for held in offered(kind, mechanism) if not held.integrates]


def varying_acceleration(mechanism: Mechanism) -> str:
    """Return that accelerations change as it moves; empty where they only change at events."""
    return "accelerations change as it moves" if changing(mechanism) else ""


def no_goal(setting: Setting, moments: tuple[type[Moment], ...]) -> str:
    """Return what of a query no way leads to: its moment, if it is none of `moments`, or its quantity; else empty."""
    if not isinstance(setting.query.moment, moments):
        return f"no way to the moment {type(setting.query.moment).__name__}"
    target = setting.target
    if target is None or target.quantity in GOALS:
        return ""
    return f"no way to the quantity {target.quantity}"
