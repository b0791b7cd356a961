"""Single bodies, and the whole system."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass

from sim2reason.scenes.dsl.constancy import turns_one_way
from sim2reason.scenes.dsl.mechanism import Mechanism, RigidBody
from sim2reason.scenes.dsl.vectors import Vector, scale
from sim2reason.simulation.quantities.subjects import Sense, Subject, all_said, is_said
from sim2reason.simulation.quantities.subjects.paths import (
    EVEN,
    CenterPath,
    carried_by,
    center_path,
    is_pulley_wheel,
    rides,
    turning_axes,
)

UP, RIGHT = "up", "right"
OPPOSITE = {UP: "down", RIGHT: "left"}
HORIZONTAL, VERTICAL = "horizontal", "vertical"
SELDOM = 0.3  # of a component along no axis of the text, or along one of two
AXES = ("x", "y", "z")  # labels of coordinates along axes that the text defines


@dataclass(frozen=True)
class Bodies(Subject):
    """Bodies as subjects; texts ask about those whose centre of mass can move."""

    name = slot = "body"
    extras = frozenset({"ground"})

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return all bodies, massless ones and wheels among them."""
        return tuple(mechanism.body)

    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """Return those that can move, but for the wheels of pulleys: a pulley is no disc that the text follows."""
        return {name: mentions[name] for name in mechanism.body if name in mentions and moves(mechanism, name)}

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """Return whether the body has it and the text says it at the body's address."""
        return getattr(mechanism.body[name], need, 1.0) != 0.0 and is_said(need, name, said)

    def fills(self, mechanism: Mechanism, name: str, mentions: Mapping[str, str]) -> dict[str, str]:
        """Return *relative to the ground* for a body that is carried by another one."""
        del mentions
        return {"ground": " relative to the ground" if rides(mechanism, name) else ""}

    def point(self, mechanism: Mechanism, name: str, phrase: str) -> str:
        """Return the centre of mass of what has a size and swings; what turns about its centre moves as that does."""
        swings = any(mechanism.body[name].inertia) and center_path(mechanism, name).swings
        return f"the centre of mass of {phrase}" if swings else phrase

    def senses(self, mechanism: Mechanism, name: str) -> list[Sense]:
        """Up, up the slope, the axes that the text defines."""
        own = [c for c in mechanism.body[name].coordinates if c.label in AXES and c.kind == "slide"]
        path = center_path(mechanism, name)
        if own and len(own) == len(path.ways):
            share = SELDOM if len(own) > 1 else 1.0  # of a plane motion rather how fast, how far and which way
            return [Sense(f"along the {c.label} axis", c.axis, c.label, share=share, fixed=True) for c in own]
        right = [Sense(RIGHT, c.axis) for c in mechanism.body[name].coordinates if c.label == RIGHT]
        return _of_path(path) or (right if path.straight else [])

    def directions(self, mechanism: Mechanism, name: str) -> list[Vector]:
        """Return those of its own and of what carries it; none of a path that bends."""
        path = center_path(mechanism, name)
        return [] if path.bends else list(path.ways)

    def label(self, phrase: str) -> str:
        """Return its letter, or its noun."""
        return phrase.removeprefix("the ") if phrase.startswith("the ") else phrase.rpartition(" ")[2]


def moves(mechanism: Mechanism, name: str) -> bool:
    """Return whether the centre of mass of a body can move, and it is not the wheel of a pulley.

    What has no mass and turns, as a light arm on a carriage does, has no centre of mass, and no point is meant.
    """
    body = mechanism.body[name]
    pointless = not body.mass and any(coordinate.kind == "hinge" for coordinate in body.coordinates)
    return bool(center_path(mechanism, name).ways) and not pointless and not is_pulley_wheel(mechanism, name)


def moves_in_plane(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body moves freely along two axes of the text, as projectiles, pucks and planets do."""
    return sum(coordinate.label in AXES for coordinate in mechanism.body[name].coordinates) > 1


def _of_path(path: CenterPath) -> list[Sense]:
    """Return the directions for which English has words; right is only one where the text fixes it, as a label says."""
    if not path.rises:
        return []
    if not path.straight:
        return [Sense(UP, (0.0, 0.0, 1.0), VERTICAL, share=SELDOM)]
    way = path.ways[0] if path.ways[0][2] > 0.0 else scale(-1.0, path.ways[0])
    return [Sense(UP if way[2] > 1.0 - EVEN else "up the slope", way)]


ROD = "rod"  # the last part of its address


@dataclass(frozen=True)
class HungBodies(Subject):
    """Small bodies at the end of a light rod on a hinge, on which only the rod and gravity act, as subjects."""

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


@dataclass(frozen=True)
class TurningBodies(Subject):
    """Bodies that turn about a hinge, their own or that of a body that carries them, as subjects."""

    name, slot = "turning body", "body"
    extras = frozenset({"net"})

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return all that turn, wheels of pulleys among them."""
        return tuple(name for name in mechanism.body if turning_axes(mechanism, name))

    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """Return those whose turning can be seen: not pulleys, nor bodies so small that they have no size."""
        seen = [name for name in self.names(mechanism) if name in mentions and not is_pulley_wheel(mechanism, name)]
        return {name: mentions[name] for name in seen if _has_size(mechanism, name)}

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """Return whether the body has it and the text says it at the body's address."""
        return Bodies().gives(need, mechanism, name, said)

    def fills(self, mechanism: Mechanism, name: str, mentions: Mapping[str, str]) -> dict[str, str]:
        """Return *net* for the angle of a body that may reverse its rotation."""
        del mentions
        return {"net": "" if turns_one_way(mechanism, name) else "net "}


def _has_size(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body is no point: it has a moment of inertia, or it is light and its own hinge turns it."""
    body = mechanism.body[name]
    return any(body.inertia) or (body.mass == 0.0 and any(c.kind == "hinge" for c in body.coordinates))


ALL = ""  # its only name


@dataclass(frozen=True)
class Whole(Subject):
    """The whole scene as a subject, which questions do not name."""

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
        """Return whether the text says it of everything that has it."""
        del name
        return all_said(need, mechanism, said)

    def senses(self, mechanism: Mechanism, name: str) -> list[Sense]:
        """Return the directions of the text if they are the same for all bodies with a mass; else none."""
        del name
        each = [Bodies().senses(mechanism, body.name) for body in mechanism.bodies if body.mass > 0.0]
        return each[0] if each and all(senses == each[0] for senses in each) else []
