"""What a question needs to know of the text before it."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Self

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.scene import Scene
from sim2reason.dsl.units import UnitSystem
from sim2reason.quantities.subjects import Subject
from sim2reason.questions.unknown import Unknown, unknowns


@dataclass(frozen=True, eq=False)
class Words:
    """How bodies are called, how the motion begins, and which numbers are given."""

    mechanism: Mechanism
    mentions: Mapping[str, str]  # by address
    released: bool  # from rest; else the text counts time from t = 0
    said: frozenset[str] = frozenset()  # the paths of all numbers that the text says, or speaks of as unknown
    unknowns: Sequence[Unknown] = ()  # the numbers that it leaves unknown, or could
    _called: dict[str, Mapping[str, str]] = field(default_factory=dict[str, Mapping[str, str]], repr=False)

    @classmethod
    def of(cls, scene: Scene, mentions: Mapping[str, str], symbols: Mapping[str, str] | None = None) -> Self:
        """Those of a text about a scene that calls its bodies by `mentions` and its unknown, if any, by `symbols`."""
        said = frozenset(p.path for p in scene.parameters if p.value is not None and not p.hidden)
        return cls(scene.mechanism, mentions, scene.starts_from_rest, said, unknowns(scene, mentions, symbols or {}))

    @property
    def since(self) -> str:
        """From when on the text counts time."""
        return "release" if self.released else "t = 0"

    @property
    def units(self) -> UnitSystem:
        """The units in which the text speaks."""
        return self.mechanism.units

    def called(self, of: Subject) -> Mapping[str, str]:
        """By name, what the text calls each of one kind of subject."""
        found = self._called.get(of.name)
        if found is None:
            found = self._called[of.name] = of.phrases(self.mechanism, self.mentions)
        return found

    def fills(self, of: Subject, name: str) -> dict[str, str]:
        """What further placeholders stand for in phrases about one subject."""
        return of.fills(self.mechanism, name, self.mentions)
