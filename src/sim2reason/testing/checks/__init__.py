"""The checks of the conformance kit."""

from abc import ABC, abstractmethod
from collections.abc import Iterator
from typing import ClassVar, TypeVar

from sim2reason.base.registry import Registry
from sim2reason.testing.report import Finding
from sim2reason.testing.specimens import Specimens


class Check(ABC):
    """A property that every entity must have, stated in the first line of the check's docstring."""

    name: ClassVar[str]

    @abstractmethod
    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Yield the violations of the check in these scenes, a few of each kind."""


C = TypeVar("C", bound=Check)
CHECKS: Registry[Check] = Registry("testing.checks")


def check(cls: type[C]) -> type[C]:
    """Register a check class under its name."""
    CHECKS.add(cls.name, cls())
    return cls
