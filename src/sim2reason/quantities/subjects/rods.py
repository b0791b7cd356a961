"""Light rods, which pull or push."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass

from sim2reason.dsl.mechanism import ZERO, Mechanism, Rigid, RigidBody
from sim2reason.dsl.vectors import Vector, add
from sim2reason.quantities.subjects import Sense, Subject, all_said
from sim2reason.quantities.subjects.lines import ends_label, line_phrases
from sim2reason.quantities.subjects.paths import carried_by
from sim2reason.quantities.subjects.swinging_lines import body_pointer, is_light_rod


@dataclass(frozen=True)
class Rods(Subject):
    """Every light rod: between two sites, or on a hinge with all that it holds at its other end."""

    name = slot = "rod"

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Lines that are rods, then bodies that are."""
        lines = (line.name for line in mechanism.lines if isinstance(line.law, Rigid))
        return (*lines, *(body.name for body in mechanism.bodies if _pulls_alone(mechanism, body)))

    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """Those with a name of their own, or that can be told by their ends."""
        rigid = [line for line in mechanism.lines if isinstance(line.law, Rigid)]
        bodies = {name: mentions[name] for name in self.names(mechanism) if name in mentions}
        return line_phrases(mechanism, mentions, rigid, "rod", alone=not bodies) | bodies

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """What a rod carries comes from everything that is there."""
        del name
        return all_said(need, mechanism, said)

    def senses(self, mechanism: Mechanism, name: str) -> list[Sense]:
        """A pull."""
        del mechanism, name
        return [Sense("tension", (0.0, 0.0, 0.0))]

    def label(self, phrase: str) -> str:
        """Its name, or its ends."""
        return ends_label(phrase)


def _pulls_alone(mechanism: Mechanism, body: RigidBody) -> bool:
    """Whether a body is a light rod on a hinge, and nothing else than it and weight acts on what it holds."""
    if not is_light_rod(body) or body_pointer(mechanism, body) is None:
        return False
    held = {each.name for each in carried_by(mechanism, body.name)}
    pulled = {mechanism.site[site].body for line in mechanism.lines for site in line.through}
    acted = {force.body for force in mechanism.forces} | {burn.body for burn in mechanism.burns}
    drawn = {name for pull in mechanism.attractions for name in (pull.a, pull.b)}
    stands = {mechanism.site[foot.site].body for foot in mechanism.feet}
    return not held & (pulled | acted | drawn | stands | mechanism.contacts.keys()) and _at_its_end(mechanism, body)


def _at_its_end(mechanism: Mechanism, rod: RigidBody) -> bool:
    """Whether all that a light rod holds is joined to it at one point: small bodies, and hinges of what hangs there."""
    fixed: dict[str | None, Vector] = {
        rod.name: ZERO
    }  # where the frames of what can't move on the rod stand in its own
    places: set[tuple[float, ...]] = set()
    for body in mechanism.bodies:
        if body.parent not in fixed:
            continue
        at = add(fixed[body.parent], body.at)
        if not body.coordinates:
            fixed[body.name] = at
            at = add(at, body.center)
        if any(c.kind == "slide" for c in body.coordinates) or (not body.coordinates and any(body.inertia)):
            return False
        places.add(tuple(round(part, 9) for part in at))
    return len(places) == 1
