"""Axles and pulleys."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from math import hypot

from sim2reason.scenes.dsl.frames import initial_frames
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.vectors import Vector, minus
from sim2reason.simulation.quantities.subjects import Sense, Subject, is_stated_for_all
from sim2reason.simulation.quantities.subjects.bodies import HORIZONTAL, OFF_AXIS_SHARE, RIGHT, UP, VERTICAL
from sim2reason.simulation.quantities.subjects.paths import DIRECTION_TOL, carried_by, chain, rim_of
from sim2reason.simulation.quantities.subjects.rods import Rods

ACROSS: Vector = (1.0, 0.0, 0.0)
UPWARD: Vector = (0.0, 0.0, 1.0)


@dataclass(frozen=True)
class Axles(Subject):
    """Bodies that rotate about a fixed axle and are held by that axle alone, as subjects.

    A light rod with its load at one point is excluded: the force in the rod is that on the axle.
    """

    name, slot = "axle", "body"

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the names of the hinged bodies that carry all bodies rotating with them."""
        rods = Rods().names(mechanism)
        hinged = [body.name for body in mechanism.bodies if body.coordinates and body.name not in rods]
        return tuple(name for name in hinged if held_by_axle_alone(mechanism, name))

    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """Return the phrases of the bodies that the text mentions."""
        return {name: mentions[name] for name in self.names(mechanism) if name in mentions}

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """Return whether the text states the number `need` for every body that has it, since each may load the axle."""
        del name
        return is_stated_for_all(need, mechanism, said)

    def senses(self, mechanism: Mechanism, name: str) -> list[Sense]:
        """Return the direction up, and right if the axle is horizontal and points away from the reader."""
        up = Sense(UP, UPWARD, VERTICAL, fixed=True, share=OFF_AXIS_SHARE)
        right = Sense(RIGHT, ACROSS, HORIZONTAL, fixed=True, share=OFF_AXIS_SHARE)
        return [up, right] if abs(mechanism.body[name].coordinates[0].axis[1]) > 1.0 - DIRECTION_TOL else [up]


def held_by_axle_alone(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body, with all bodies joined to it, rotates about one fixed axle without other contacts."""
    if [c.kind for body in chain(mechanism, name) for c in body.coordinates] != ["hinge"]:
        return False
    together = carried_by(mechanism, chain(mechanism, name)[-1].name)
    held = {body.name for body in together}
    pulled = {mechanism.site[site].body for line in mechanism.lines for site in line.through}
    acted = {force.body for force in mechanism.forces} | {burn.body for burn in mechanism.burns}
    drawn = {each for pull in mechanism.attractions for each in (pull.a, pull.b)}
    stands = {mechanism.site[foot.site].body for foot in mechanism.feet}
    hinges = [c.name for body in together for c in body.coordinates]
    wound = any(wheel.coordinate in hinges for line in mechanism.lines for wheel in line.wheels)
    return len(hinges) == 1 and not wound and not held & (pulled | acted | drawn | stands | mechanism.contacts.keys())


DIRECTIONS = "directions of the string's parts"
"""The need of a quantity of a pulley that the text fixes the angle between its string parts."""


@dataclass(frozen=True)
class Pulleys(Subject):
    """Pulleys as subjects, named by their addresses: fixed ones and those on bodies."""

    name = slot = "pulley"

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the addresses of the pulleys over which a string runs, in the order of the strings."""
        owners = dict.fromkeys(site.rpartition(".")[0] for line in mechanism.lines for site in line.through)
        return tuple(owner for owner in owners if rim_of(mechanism, owner) is not None)

    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """Return the phrases of the pulleys that the text mentions."""
        return {name: mentions[name] for name in self.names(mechanism) if name in mentions}

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """Return whether the text states the number `need` for every body, since each may load the pulley."""
        return (
            are_directions_stated(mechanism, name) if need == DIRECTIONS else is_stated_for_all(need, mechanism, said)
        )


def are_directions_stated(mechanism: Mechanism, name: str) -> bool:
    """Return whether all slanted or horizontal string parts that leave a pulley run to the same body.

    The text does not state the sides of two separate planes, so the angle between parts along them is unknown.
    """
    frames, ends = initial_frames(mechanism), set[str]()
    for line in mechanism.lines:
        for one, other in zip(line.through, line.through[1:], strict=False):
            for rim, end in ((one, other), (other, one)):
                if rim.rpartition(".")[0] != name or end.rpartition(".")[0] == name:
                    continue
                part = minus(frames.site(end).place, frames.site(rim).place)
                if hypot(float(part[0]), float(part[1])) > DIRECTION_TOL:
                    ends.add(end.partition(".")[0])
    return len(ends) <= 1
