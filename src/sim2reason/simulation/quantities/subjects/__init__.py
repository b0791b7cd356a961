"""Kinds of subjects of quantities: their members in a mechanism and their phrases in a text."""

from abc import ABC, abstractmethod
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from typing import ClassVar

from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.vectors import Vector

MAX_LETTER_LENGTH = 2  # largest number of characters of a label letter, as opposed to a noun


@dataclass(frozen=True, slots=True)
class Sense:
    """A direction, as a phrase of the text and as a vector in the world frame.

    `positive` is the phrase of the positive direction, as in *taking … as positive*. `axis` names a component (``x``,
    ``vertical``); empty if the subject moves along one line anyway. `fixed` marks a sense that the text or the noun
    phrase fixes, so that questions need not state it. `share` is the relative frequency of questions about it.
    """

    positive: str
    vector: Vector
    axis: str = ""
    fixed: bool = False
    share: float = 1.0


@dataclass(frozen=True)
class Subject(ABC):
    """A kind of subject, such as bodies or strings, to which quantities apply; a quantity names its kind by `of`.

    Class data:
        name: the name of one subject, such as ``body``.
        slot: the placeholder of the subject in a quantity's phrases.
        extras: further placeholders that a phrase may use, which `fills` fills.
    """

    name: ClassVar[str]
    slot: ClassVar[str]
    extras: ClassVar[frozenset[str]] = frozenset()

    @abstractmethod
    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the names of all subjects of this kind, in the order of the mechanism."""

    @abstractmethod
    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """Return the phrases, by subject, with which a text can refer; `mentions`: phrases of bodies by address."""

    @abstractmethod
    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """Return whether a subject has the property `need` (such as ``mass``) and the text states it.

        `said` holds the paths of all numbers that the text states.
        """

    def fills(self, mechanism: Mechanism, name: str, mentions: Mapping[str, str]) -> dict[str, str]:
        """Return the texts for the further placeholders (`extras`) in a quantity's phrases; by default none."""
        del mechanism, name, mentions
        return {}

    def point(self, mechanism: Mechanism, name: str, phrase: str) -> str:
        """Return the phrase for the point of a subject whose position and velocity are meant; by default its own."""
        del mechanism, name
        return phrase

    def senses(self, mechanism: Mechanism, name: str) -> list[Sense]:
        """Return the directions of a subject that the text can name; by default none."""
        del mechanism, name
        return []

    def directions(self, mechanism: Mechanism, name: str) -> list[Vector]:
        """Return the fixed directions in which a subject can move in the world frame; by default none."""
        del mechanism, name
        return []

    def label(self, phrase: str) -> str:
        """Return a short label for the legend of a plot, such as the letter of *block A*."""
        words = phrase.removeprefix("the ").split()
        return words[1] if len(words) == 2 and len(words[1]) <= MAX_LETTER_LENGTH else " ".join(words)


def is_stated_for_all(need: str, mechanism: Mechanism, stated_paths: Collection[str]) -> bool:
    """Return whether the text states a property (such as ``mass``) for every body that has it."""
    return all(is_stated(need, body.name, stated_paths) for body in mechanism.bodies if getattr(body, need, 0.0) != 0.0)


def is_stated(need: str, name: str, stated_paths: Collection[str]) -> bool:
    """Return whether the text states a property of the subject `name`; a ``dry_mass`` also counts as the mass."""
    if f"{name}.{need}" in stated_paths:
        return True
    return any(path.startswith(f"{name}.") and path.endswith(f"_{need}") for path in stated_paths)
