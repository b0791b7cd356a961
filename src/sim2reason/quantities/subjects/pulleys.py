"""Pulleys over which strings run."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.quantities.subjects import Subject, all_said

RIMS = ("left", "right"), ("in", "out")
"""The names of the two sites at the rim of a pulley."""


@dataclass(frozen=True)
class Pulleys(Subject):
    """Every pulley, by its address, whatever carries it."""

    name = slot = "pulley"

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Those over which a string runs, in the order of the strings."""
        owners = dict.fromkeys(site.rpartition(".")[0] for line in mechanism.lines for site in line.through)
        return tuple(
            owner for owner in owners if any(all(f"{owner}.{rim}" in mechanism.site for rim in rims) for rims in RIMS)
        )

    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """Those that the text mentions."""
        return {name: mentions[name] for name in self.names(mechanism) if name in mentions}

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """What a pulley bears comes from everything that is there."""
        del name
        return all_said(need, mechanism, said)
