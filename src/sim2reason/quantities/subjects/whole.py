"""All that moves, taken together, as one subject."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.quantities.subjects import Sense, Subject, all_said
from sim2reason.quantities.subjects.bodies import Bodies

ALL = ""  # its only name


@dataclass(frozen=True)
class Whole(Subject):
    """Everything; a question about it names nothing."""

    name, slot = "whole", "all"

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """There is one."""
        del mechanism
        return (ALL,)

    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """It goes without saying."""
        del mechanism, mentions
        return {ALL: ""}

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """Whether the text says it of everything that has it."""
        del name
        return all_said(need, mechanism, said)

    def senses(self, mechanism: Mechanism, name: str) -> list[Sense]:
        """Return the directions of the text if they are the same for all bodies with a mass; else none."""
        del name
        each = [Bodies().senses(mechanism, body.name) for body in mechanism.bodies if body.mass > 0.0]
        return each[0] if each and all(senses == each[0] for senses in each) else []
