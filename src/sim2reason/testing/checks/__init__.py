"""The checks of the kit, one file each: what must hold of every entity."""

from abc import ABC, abstractmethod
from collections.abc import Iterator
from typing import ClassVar, TypeVar

from sim2reason.base.registry import Registry
from sim2reason.testing.report import Finding
from sim2reason.testing.specimens import Specimens


class Check(ABC):
    """Something that must hold of every entity. The first line of a check's docstring says what."""

    name: ClassVar[str]

    @abstractmethod
    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Return what does not hold in these scenes, at most a few of each kind."""


C = TypeVar("C", bound=Check)
CHECKS: Registry[Check] = Registry("testing.checks")


def check(cls: type[C]) -> type[C]:
    """Enter a check under its name."""
    CHECKS.add(cls.name, cls())
    return cls
