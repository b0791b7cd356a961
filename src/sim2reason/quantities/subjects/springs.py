"""Springs."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass

from sim2reason.dsl.mechanism import ZERO, Elastic, Mechanism
from sim2reason.quantities.subjects import Sense, Subject, is_said
from sim2reason.quantities.subjects.lines import ends_label, line_phrases

STRETCHED = "stretched"


@dataclass(frozen=True)
class Springs(Subject):
    """Every spring."""

    name = slot = "spring"

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """All of them."""
        return tuple(line.name for line in mechanism.lines if isinstance(line.law, Elastic))

    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """Those with a name of their own, or that can be told by their ends."""
        return springs(mechanism, mentions)

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """Whether the text says a number of the spring, its ``stiffness`` or its natural ``length``."""
        return is_said(need, mechanism.line[name].whole, said)

    def senses(self, mechanism: Mechanism, name: str) -> list[Sense]:
        """Return *stretched*, the direction in which extensions, their rates and forces count as positive."""
        del mechanism, name
        return [Sense(STRETCHED, ZERO)]

    def label(self, phrase: str) -> str:
        """Its name, or its ends."""
        return ends_label(phrase)


def springs(mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
    """A phrase for every spring that can be told from the others, by name."""
    elastic = [line for line in mechanism.lines if isinstance(line.law, Elastic)]
    return line_phrases(mechanism, mentions, elastic, "spring", alone=True)
