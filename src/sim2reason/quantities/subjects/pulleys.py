"""Pulleys over which strings run."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.quantities.subjects import Subject, all_said
from sim2reason.quantities.subjects.paths import rim_of


@dataclass(frozen=True)
class Pulleys(Subject):
    """Every pulley over which a string runs, by its address; a fixed pulley as well as one on a body."""

    name = slot = "pulley"

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the addresses of the pulleys over which a string runs, in the order of the strings."""
        owners = dict.fromkeys(site.rpartition(".")[0] for line in mechanism.lines for site in line.through)
        return tuple(owner for owner in owners if rim_of(mechanism, owner) is not None)

    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """Return the phrases of the pulleys that the text mentions."""
        return {name: mentions[name] for name in self.names(mechanism) if name in mentions}

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """Return whether the text gives it for every body that has it, since each may load the pulley."""
        del name
        return all_said(need, mechanism, said)
