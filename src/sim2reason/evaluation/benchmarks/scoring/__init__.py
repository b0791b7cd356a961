"""Rules by which benchmarks score responses. One file each, as published; none of them is the reward."""

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
    """What a rule gives for a response: from 0 to 1 point, whether there was an answer to read, and why."""

    points: float
    readable: bool = True
    parsed: str = ""
    why: str = ""

    @classmethod
    def unreadable(cls, why: str) -> "Award":
        """Nothing, since no answer could be read."""
        return cls(0.0, readable=False, why=why)

    @classmethod
    def all_or_nothing(cls, right: bool, parsed: str, why: str = "") -> "Award":  # noqa: FBT001 - the verdict itself
        """Return one point for a right answer, none for a wrong one."""
        return cls(float(right), parsed=parsed, why=why)


class Scoring(ABC):
    """A published rule. `award` is a pure function of the response and the reference."""

    needs: ClassVar[tuple[str, ...]] = ()
    """Modules that the extra [eval] brings."""

    def check(self) -> None:
        """Look for what it needs, before anyone is asked; MissingExtraError if it is not there."""
        for name in self.needs:
            if find_spec(name) is None:
                raise MissingExtraError(name.replace("_", "-"), "eval")

    @abstractmethod
    def award(self, response: str, reference: Reference) -> Award:
        """Return the award for a response, with its thinking; it never raises for anything that a response says."""

    def question(self, response: str, reference: Reference, prompt: str) -> str | None:
        """Return what to ask a judge about a response that `award` did not pay; None where the rule alone decides."""
        del response, reference, prompt
        return None

    def ruling(self, said: str) -> Award:
        """Return the award by what a judge said; only for rules that ask one."""
        raise NotImplementedError(said)


SCORINGS: Registry[Scoring] = Registry("benchmarks.scoring", package="sim2reason.evaluation.benchmarks.scoring")
