"""What quantities are of: each kind of subject says which there are, and how a text speaks of them."""

from abc import ABC, abstractmethod
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from typing import ClassVar

from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.vectors import Vector

LETTERS = 2  # characters of what is a letter, not a noun


@dataclass(frozen=True, slots=True)
class Sense:
    """A direction in the words of the text, and in room coordinates.

    `positive` is what counts as positive, as in *taking … as positive*. `axis` names a component (``x``, ``vertical``);
    empty where the subject moves along one line anyway. `fixed` is a sense that the text or the noun phrase fixes, so
    that no question need say what is positive. `share` says how often it is asked of, compared with others.
    """

    positive: str
    vector: Vector
    axis: str = ""
    fixed: bool = False
    share: float = 1.0


@dataclass(frozen=True)
class Subject(ABC):
    """A kind of subject, such as bodies or strings, to which quantities apply; a quantity names its own by `of`.

    Class data:
        name: what one of them is called, ``body``.
        slot: the placeholder that stands for it in a quantity's phrases.
        extras: further placeholders that a phrase may use, which `fills` fills.
    """

    name: ClassVar[str]
    slot: ClassVar[str]
    extras: ClassVar[frozenset[str]] = frozenset()

    @abstractmethod
    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return all of this kind, in the order of the mechanism."""

    @abstractmethod
    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """By name, those that a text can speak of, each as it does; `mentions` are its bodies by address."""

    @abstractmethod
    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """Return whether one has what a quantity needs of it (such as its ``mass``) and the text says it.

        `said` holds the paths of all numbers that the text says.
        """

    def fills(self, mechanism: Mechanism, name: str, mentions: Mapping[str, str]) -> dict[str, str]:
        """Return what stands for each of the `extras`; by default there are none."""
        del mechanism, name, mentions
        return {}

    def point(self, mechanism: Mechanism, name: str, phrase: str) -> str:
        """Return how the text speaks of the point of it that has a place and a velocity; by default as of itself."""
        del mechanism, name
        return phrase

    def senses(self, mechanism: Mechanism, name: str) -> list[Sense]:
        """Return the directions of one for which the text has words; none by default."""
        del mechanism, name
        return []

    def directions(self, mechanism: Mechanism, name: str) -> list[Vector]:
        """Return the directions in which one can move in the room, if they do not change; none by default."""
        del mechanism, name
        return []

    def label(self, phrase: str) -> str:
        """Return a phrase for the legend of a plot; of *block A* the letter."""
        words = phrase.removeprefix("the ").split()
        return words[1] if len(words) == 2 and len(words[1]) <= LETTERS else " ".join(words)


def all_said(need: str, mechanism: Mechanism, said: Collection[str]) -> bool:
    """Return whether the text says a number (such as ``mass``) of every body that has it."""
    return all(is_said(need, body.name, said) for body in mechanism.bodies if getattr(body, need, 0.0) != 0.0)


def is_said(need: str, name: str, said: Collection[str]) -> bool:
    """Return whether the text says a number of what is called `name`; a ``dry_mass`` says the mass as well."""
    if f"{name}.{need}" in said:
        return True
    return any(path.startswith(f"{name}.") and path.endswith(f"_{need}") for path in said)
