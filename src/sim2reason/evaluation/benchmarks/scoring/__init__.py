"""Scoring rules of benchmarks, one module each, as published; they are independent of the reward."""

from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass
from importlib.util import find_spec
from typing import ClassVar

from pydantic import JsonValue

from sim2reason.base.registry import Registry
from sim2reason.errors import MissingExtraError

__all__ = ["SCORINGS", "Award", "Reference", "Scoring"]

Reference = Mapping[str, JsonValue]
"""What a benchmark's item says of its answer."""


@dataclass(frozen=True, slots=True)
class Award:
    """The result of a rule: points from 0 to 1, whether an answer could be parsed, and the reason."""

    points: float
    readable: bool = True
    parsed: str = ""
    why: str = ""

    @classmethod
    def unreadable(cls, why: str) -> "Award":
        """Return an award of zero points for a response without a readable answer."""
        return cls(0.0, readable=False, why=why)

    @classmethod
    def all_or_nothing(cls, right: bool, parsed: str, why: str = "") -> "Award":  # noqa: FBT001 - the verdict itself
        """Return an award of one point for a correct answer and zero for any other."""
        return cls(float(right), parsed=parsed, why=why)


class Scoring(ABC):
    """A published scoring rule; `award` is a pure function of the response and the reference."""

    needs: ClassVar[tuple[str, ...]] = ()
    """Modules that the extra [eval] brings."""

    def check(self) -> None:
        """Check for required packages before a run; MissingExtraError if one is missing."""
        for name in self.needs:
            if find_spec(name) is None:
                raise MissingExtraError(name.replace("_", "-"), "eval")

    @abstractmethod
    def award(self, response: str, reference: Reference) -> Award:
        """Return the award for a response including its thinking; no response text raises an error."""

    def question(self, response: str, reference: Reference, prompt: str) -> str | None:
        """Return the prompt by which a judge is asked about a response; None if the rule alone decides."""
        del response, reference, prompt
        return None

    def ruling(self, said: str) -> Award:
        """Return the award that a judge's text expresses; only for rules with a judge."""
        raise NotImplementedError(said)


SCORINGS: Registry[Scoring] = Registry("benchmarks.scoring", package="sim2reason.evaluation.benchmarks.scoring")
