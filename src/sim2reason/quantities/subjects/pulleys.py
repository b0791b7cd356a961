"""Pulleys over which strings run."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from math import hypot

from sim2reason.dsl.frames import start
from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.triples import minus
from sim2reason.quantities.subjects import Subject, all_said
from sim2reason.quantities.subjects.paths import EVEN, rim_of

DIRECTIONS = "directions of the string's parts"
"""Name of a fact about a pulley: the text fixes the angle between the parts of a string that leave the pulley."""


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
        return directions_told(mechanism, name) if need == DIRECTIONS else all_said(need, mechanism, said)


def directions_told(mechanism: Mechanism, name: str) -> bool:
    """Return whether all slanting or level parts of strings that leave a pulley run to one and the same thing.

    Nothing is said of the sides on which two separate planes lie, so the angle between parts along them is unknown.
    """
    frames, ends = start(mechanism), set[str]()
    for line in mechanism.lines:
        for one, other in zip(line.through, line.through[1:], strict=False):
            for rim, end in ((one, other), (other, one)):
                if rim.rpartition(".")[0] != name or end.rpartition(".")[0] == name:
                    continue
                part = minus(frames.site(end).place, frames.site(rim).place)
                if hypot(float(part[0]), float(part[1])) > EVEN:
                    ends.add(end.partition(".")[0])
    return len(ends) <= 1
