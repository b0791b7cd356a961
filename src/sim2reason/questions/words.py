"""What a question needs to know of the text before it."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Self

from sim2reason.dsl.scene import Scene
from sim2reason.dsl.units import SI, UnitSystem


@dataclass(frozen=True, slots=True)
class Words:
    """How bodies are called, how the motion begins, and which numbers are given."""

    mentions: Mapping[str, str]  # by address
    released: bool  # from rest; else the text counts time from t = 0
    said: frozenset[str] = frozenset()  # the paths of all numbers that the text says
    units: UnitSystem = SI  # in which it speaks

    @classmethod
    def of(cls, scene: Scene, mentions: Mapping[str, str]) -> Self:
        """Those of a text about a scene that calls its bodies by `mentions`."""
        said = frozenset(p.path for p in scene.parameters if p.value is not None and not p.hidden)
        return cls(mentions, scene.starts_from_rest, said, scene.units)
