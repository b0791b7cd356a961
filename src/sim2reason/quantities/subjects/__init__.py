"""What quantities are of: each kind of subject says which there are, and how a text speaks of them."""

from abc import ABC, abstractmethod
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from typing import ClassVar

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.vectors import Vector


@dataclass(frozen=True, slots=True)
class Sense:
    """A direction in the words of the text, and in room coordinates.

    `axis` names a component (``x``, ``horizontal``); empty where the subject moves along one line anyway.
    `fixed` is a sense that the text or the noun phrase fixes, so that no question need say what is positive.
    """

    positive: str
    vector: Vector
    axis: str = ""
    fixed: bool = False


@dataclass(frozen=True)
class Subject(ABC):
    """One kind of subject; a quantity names its own by `of`. Each has a file of its own.

    Class data:
        name: what one of them is called, ``body``.
        slot: the placeholder that stands for it in a quantity's phrases.
    """

    name: ClassVar[str]
    slot: ClassVar[str]

    @abstractmethod
    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """All of this kind, in the order of the mechanism."""

    @abstractmethod
    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """By name, those that a text can speak of, each as it does; `mentions` are its bodies by address."""

    @abstractmethod
    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """Whether one has what a quantity needs of it (such as its ``mass``) and the text says it.

        `said` holds the paths of all numbers that the text says.
        """

    def senses(self, mechanism: Mechanism, name: str) -> list[Sense]:
        """The directions of one for which the text has words; none by default."""
        del mechanism, name
        return []

    def directions(self, mechanism: Mechanism, name: str) -> list[Vector]:
        """The directions in which one can move in the room; none by default."""
        del mechanism, name
        return []

    def ground(self, mechanism: Mechanism, name: str) -> str:
        """What must be added where its motion could be taken as relative to what carries it."""
        del mechanism, name
        return ""

    def label(self, phrase: str) -> str:
        """A phrase for the legend of a plot."""
        return phrase.removeprefix("the ")


def all_said(need: str, mechanism: Mechanism, said: Collection[str]) -> bool:
    """Whether the text says a number (such as ``mass``) of every body that has it."""
    return all(f"{body.name}.{need}" in said for body in mechanism.bodies if getattr(body, need) != 0.0)
