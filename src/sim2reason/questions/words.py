"""What a question needs to know of the text before it."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Self

from sim2reason.base.lazy import cached_property
from sim2reason.questions.named_numbers import named_numbers
from sim2reason.questions.spoken import OwnSymbol, said, say
from sim2reason.questions.unknown import Unknown, unknowns
from sim2reason.scenes.dsl.constancy import may_turn_back
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.units import UnitSystem
from sim2reason.simulation.quantities.subjects import Subject


@dataclass(frozen=True, eq=False)
class Words:
    """How bodies are called, how the motion begins, and which numbers are given."""

    mechanism: Mechanism
    mentions: Mapping[str, str]  # by address
    released: bool  # from rest; else the text counts time from t = 0
    said: frozenset[str] = frozenset()  # the paths of all numbers that the text says, or speaks of as unknown
    unknowns: Sequence[Unknown] = ()  # the numbers that it leaves unknown, or could
    symbols: Mapping[str, str] = field(default_factory=dict[str, str])  # by address, those of all numbers, if known
    symbolic: bool = False  # whether it has those in place of numbers
    own: Mapping[str, OwnSymbol] = field(default_factory=dict[str, OwnSymbol])  # of a question's numbers, by SI unit
    named: Mapping[str, str] = field(default_factory=dict[str, str])  # phrases for numbers of the scene, by address
    _called: dict[str, Mapping[str, str]] = field(default_factory=dict[str, Mapping[str, str]], repr=False)

    @classmethod
    def of(
        cls,
        scene: Scene,
        mentions: Mapping[str, str],
        unknown: Mapping[str, str] | None = None,
        symbols: Mapping[str, str] | None = None,
    ) -> Self:
        """Return those of a text about a scene that calls its bodies by `mentions`.

        `unknown` has the symbol of each number that it leaves unknown, or could; `symbols` those that all would have.
        """
        said = frozenset(p.path for p in scene.parameters if p.value is not None and not p.hidden)
        offered = unknowns(scene, mentions, unknown or {})
        named = named_numbers(scene, mentions)
        return cls(scene.mechanism, mentions, scene.starts_from_rest, said, offered, symbols or {}, named=named)

    def in_symbols(self, own: Mapping[str, OwnSymbol]) -> Self:
        """Return those of the text that has symbols in place of numbers, and some for the question's own."""
        unknowns = [found.called(self.symbols[found.path]) for found in self.unknowns if found.path in self.symbols]
        return replace(self, symbolic=True, own=own, unknowns=unknowns)

    @cached_property
    def turns_back(self) -> bool:
        """Return whether something may turn back: what is sent off, collides, or is driven by a force that changes."""
        return may_turn_back(self.mechanism)

    @property
    def since(self) -> str:
        """From when on the text counts time."""
        return "release" if self.released else "t = 0"

    def say(self, value: float, unit: str) -> str:
        """Return a number of the question's own: 0.80 s, or its symbol."""
        own = self.own.get(unit)
        return own.shown if own is not None else say(value, self.units.spell(unit))

    def amount(self, value: float, unit: str) -> str:
        """Return the same where a noun must go before a symbol: 0.80 s, or *a time $t$*."""
        own = self.own.get(unit)
        return f"{own.noun} {own.shown}" if own is not None else self.say(value, unit)

    def heard(self, text: str, unit: str) -> list[float]:
        """Return the numbers of a question's own that stand in it."""
        own = self.own.get(unit)
        if own is None:
            return said(text, self.units.spell(unit))
        return [own.value] if own.shown in text else []

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
        """Return what further placeholders stand for in phrases about one subject."""
        return of.fills(self.mechanism, name, self.mentions)
