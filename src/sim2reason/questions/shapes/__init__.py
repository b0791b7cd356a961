"""The shapes of prompts: in which order scene, question, assumptions and numbers stand.

Each shape can be undone: its `drafts` put a prompt back into the usual order, from which it is read.
"""

from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from math import isfinite
from typing import ClassVar, TypeVar

import numpy as np

from sim2reason.base.registry import Registry
from sim2reason.text.prose.description import Description


@dataclass(frozen=True)
class Draft:
    """What a prompt may say: the text of a scene and a question, with the numbers that it gives by their symbols."""

    story: str
    question: str
    given: Mapping[str, str] = field(default_factory=dict[str, str])


class PromptShape(ABC):
    """One shape of prompts. All that the library knows of it stands on its class.

    Class data:
        name: under which it is registered.
        share: how often it is drawn, compared with the other shapes that a text can have; positive.
        marked: whether words of its own tell it; what is not marked is tried last when a prompt is read.
    """

    name: ClassVar[str]
    share: ClassVar[float] = 1.0
    marked: ClassVar[bool] = True

    @abstractmethod
    def compose(self, description: Description, question: str, rng: np.random.Generator) -> str | None:
        """The prompt without its last line, or None for a text or a question to which this shape can't be given."""

    @abstractmethod
    def drafts(self, text: str) -> Iterator[Draft]:
        """Return all that a prompt of this shape, without its last line, may say; none for a prompt of another one."""


def check_share(name: str, member: object) -> None:
    """Refuse what would never be drawn, with ValueError."""
    share = getattr(member, "share", 0.0)
    if not (share > 0.0 and isfinite(share)):
        raise ValueError(f"questions.shapes: {name!r} has the share {share}, so it would never be drawn; declare one")


S = TypeVar("S", bound=PromptShape)
SHAPES: Registry[PromptShape] = Registry("questions.shapes", check_share)


def shape(cls: type[S]) -> type[S]:
    """Enter a shape of prompts under its name."""
    SHAPES.add(cls.name, cls())
    return cls


def shapes_to_try() -> list[PromptShape]:
    """Return all shapes in the order in which a prompt is read: first those that words of their own tell."""
    return sorted(SHAPES.values(), key=lambda member: not member.marked)
