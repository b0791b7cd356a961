"""The hands of a text that draw strings in."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.quantities.subjects import Subject


@dataclass(frozen=True)
class Hands(Subject):
    """The one hand of a text, by the string part that it draws in."""

    name, slot = "hand", "hand"

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the names of all string parts that a hand draws in."""
        return tuple(line.name for line in mechanism.pulls)

    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """Return the phrase *the hand* by the name of its string; no phrase if several hands pull."""
        del mentions
        names = self.names(mechanism)
        return {names[0]: "the hand"} if len(names) == 1 else {}

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """Return True, since a question about a hand needs no number of the text."""
        del need, mechanism, name, said
        return True
