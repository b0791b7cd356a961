"""Shapes of prompts: orders of scene, question, assumptions and numbers.

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
    """A possible meaning of a prompt: the text of a scene, a question, and given numbers by symbol."""

    story: str
    question: str
    given: Mapping[str, str] = field(default_factory=dict[str, str])


class PromptShape(ABC):
    """The base class of prompt shapes.

    Class data:
        name: the registered name.
        share: relative frequency among the shapes that suit a text; positive.
        marked: whether the shape has characteristic words; the parser tries unmarked shapes last.
    """

    name: ClassVar[str]
    share: ClassVar[float] = 1.0
    marked: ClassVar[bool] = True

    @abstractmethod
    def compose(self, description: Description, question: str, rng: np.random.Generator) -> str | None:
        """Return the prompt without its last line; None if this shape does not suit the text or question."""

    @abstractmethod
    def drafts(self, text: str) -> Iterator[Draft]:
        """Yield all possible meanings of a prompt without its last line; none if it has another shape."""


def check_share(name: str, member: object) -> None:
    """Raise ValueError if a shape has no positive share, so that it would never be drawn."""
    share = getattr(member, "share", 0.0)
    if not (share > 0.0 and isfinite(share)):
        raise ValueError(f"questions.shapes: {name!r} has the share {share}, so it would never be drawn; declare one")


S = TypeVar("S", bound=PromptShape)
SHAPES: Registry[PromptShape] = Registry("questions.shapes", check_share)


def shape(cls: type[S]) -> type[S]:
    """Register a shape of prompts under its name."""
    SHAPES.add(cls.name, cls())
    return cls


def shapes_to_try() -> list[PromptShape]:
    """Return all shapes in the order in which the parser tries them: first those with characteristic words."""
    return sorted(SHAPES.values(), key=lambda member: not member.marked)
