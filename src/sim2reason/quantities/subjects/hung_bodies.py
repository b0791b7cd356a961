"""Small bodies on light rods whose axle moves."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass

from sim2reason.dsl.mechanism import Mechanism, RigidBody
from sim2reason.quantities.subjects import Subject, all_said
from sim2reason.quantities.subjects.paths import carried_by

ROD = "rod"  # the last part of its address


@dataclass(frozen=True)
class HungBodies(Subject):
    """Every small body at the end of a light rod on a hinge, on which nothing but the rod and weight acts."""

    name, slot = "hung body", "rod"

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the names of the bodies."""
        return tuple(body.name for body in mechanism.bodies if _hangs(mechanism, body))

    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """Return what the text calls the rod of each body."""
        rods = {name: f"{name.rpartition('.')[0]}.{ROD}" for name in self.names(mechanism)}
        return {name: mentions[rod] for name, rod in rods.items() if rod in mentions}

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """Return whether the text gives everything, on all of which the force in a rod depends."""
        del name
        return all_said(need, mechanism, said)


def _hangs(mechanism: Mechanism, body: RigidBody) -> bool:
    hinged = [coordinate.kind for coordinate in body.coordinates] == ["hinge"] and body.parent is not None
    small = body.mass > 0.0 and not any(body.inertia) and len(list(carried_by(mechanism, body.name))) == 1
    pulled = {mechanism.site[site].body for line in mechanism.lines for site in line.through}
    acted = {force.body for force in mechanism.forces} | {burn.body for burn in mechanism.burns}
    drawn = {name for pull in mechanism.attractions for name in (pull.a, pull.b)}
    return hinged and small and body.name not in pulled | acted | drawn | mechanism.contacts.keys()
