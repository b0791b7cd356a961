"""Parts of strings, by their ends."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass

from sim2reason.dsl.mechanism import ConstantTension, Inextensible, Mechanism
from sim2reason.quantities.subjects import Subject, all_said
from sim2reason.quantities.subjects.lines import ends_label, line_phrases


@dataclass(frozen=True)
class Strings(Subject):
    """Every string part, pulls among them."""

    name = slot = "string"

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """All parts, those among them that a constant force draws in."""
        return tuple(line.name for line in mechanism.lines if isinstance(line.law, Inextensible | ConstantTension))

    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """Those that can be told by their ends."""
        return strings(mechanism, mentions)

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """What a string carries comes from everything that is there."""
        del name
        return all_said(need, mechanism, said)

    def label(self, phrase: str) -> str:
        """Its ends: *block A – pulley P*."""
        return ends_label(phrase)


def strings(mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
    """A phrase for every string part that may go slack and can be told from the others, by name."""
    return line_phrases(mechanism, mentions, mechanism.strings, "string", alone=not mechanism.pulls)
