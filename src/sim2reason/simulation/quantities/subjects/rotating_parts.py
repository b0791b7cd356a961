"""Subjects of quantities that rotate about a point: rods, swinging lines, axles and pulleys."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from math import hypot
from typing import NamedTuple

from sim2reason.scenes.dsl.frames import initial_frames
from sim2reason.scenes.dsl.mechanism import ZERO, Line, Mechanism, Rigid, RigidBody
from sim2reason.scenes.dsl.vectors import Vector, add, apply_tensor, inner, outer, scale, subtract_triples
from sim2reason.simulation.quantities.subjects import Sense, Subject, is_stated_for_all
from sim2reason.simulation.quantities.subjects.bodies import (
    DIRECTION_TOL,
    HORIZONTAL,
    OFF_AXIS_SHARE,
    RIGHT,
    UP,
    VERTICAL,
    ancestor_chain,
    carried_bodies,
    initial_position,
    point_directions,
    rim_sites,
)
from sim2reason.simulation.quantities.subjects.interactions import ends_label, line_phrases, springs, strings, surface


class Pointer(NamedTuple):
    """Two points joined by a line, the upper one first, each as a body (None: the world) and a point in its frame."""

    top: tuple[str | None, Vector]
    bottom: tuple[str | None, Vector]


@dataclass(frozen=True)
class SwingingLines(Subject):
    """Lines and bodies whose angle with the vertical changes, as subjects."""

    name, slot = "swinging line", "line"

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the names of lines with two ends that swing, then of bodies that hang from their own hinges."""
        if mechanism.gravity == ZERO:
            return ()
        lines = [line.name for line in mechanism.lines if line_pointer(mechanism, line) is not None]
        return (*lines, *(b.name for b in mechanism.bodies if body_pointer(mechanism, b) is not None))

    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """Return the phrases *the string*, *the rod*, *the line from the axle to the centre of mass of the disc*."""
        known = {**springs(mechanism, mentions), **strings(mechanism, mentions), **mentions}
        phrase_by_name: dict[str, str] = {}
        for name in self.names(mechanism):
            body = mechanism.body.get(name)
            if body is not None and is_light_rod(body) and has_bodies_on_both_sides(mechanism, name):
                phrase_by_name[name] = "the line from the axle to the centre of mass of the bodies on the arm"
            elif name in known and (body is None or is_light_rod(body) or _is_thin(mechanism, body)):
                phrase_by_name[name] = known[name]
            elif body is not None and name in mentions:
                point = "the centre of mass of " if any(body.inertia) else ""
                phrase_by_name[name] = f"the line from {_pivot(mechanism, name, mentions)} to {point}{mentions[name]}"
        return phrase_by_name

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """Return True, since an angle requires no number of the text."""
        del need, mechanism, name, said
        return True


def pointer(mechanism: Mechanism, name: str) -> Pointer:
    """Return the end points of a swinging line or body; raise ValueError for any other name."""
    line, body = mechanism.line.get(name), mechanism.body.get(name)
    endpoints = line_pointer(mechanism, line) if line is not None else body and body_pointer(mechanism, body)
    if not endpoints:
        raise ValueError(f"{name!r} does not swing")
    return endpoints


def line_pointer(mechanism: Mechanism, line: Line) -> Pointer | None:
    """Return the end points of a straight line that can swing, from its less mobile end; None for any other line."""
    if len(line.through) != 2 or line.wheels:
        return None
    ends = [mechanism.site[name] for name in line.through]
    places = [add(initial_position(mechanism, end.body), end.at) for end in ends]
    ways = [point_directions(mechanism, end.body, end.at) for end in ends]
    separation = add(places[1], scale(-1.0, places[0]))
    length = hypot(*separation)
    if length <= DIRECTION_TOL or not any(
        _turns(ways, name, scale(1.0 / length, separation)) for name in {*ways[0], *ways[1]}
    ):
        return None
    upper = min((0, 1), key=lambda i: (len(ways[i]), -places[i][2], i))
    top, bottom = ends[upper], ends[1 - upper]
    return Pointer((top.body, top.at), (bottom.body, bottom.at))


def _turns(ways: list[dict[str, Vector]], name: str, direction: Vector) -> bool:
    """Return whether a coordinate moves one end of a line relative to the other, perpendicular to the line."""
    relative_motion = add(ways[1].get(name, ZERO), scale(-1.0, ways[0].get(name, ZERO)))
    return hypot(*outer(direction, relative_motion)) > DIRECTION_TOL


def is_light_rod(body: RigidBody) -> bool:
    """Return whether a body is a light rod: massless, with a hinge as its only coordinate."""
    return body.mass == 0.0 and len(body.coordinates) == 1 and body.coordinates[0].kind == "hinge"


def body_pointer(mechanism: Mechanism, body: RigidBody) -> Pointer | None:
    """Return the points from a body's hinge to its centre of mass, or to that of a light rod's load; else None."""
    if len(body.coordinates) != 1 or body.coordinates[0].kind != "hinge":
        return None
    axis = body.coordinates[0].axis
    center = body.center if body.mass > 0.0 else load_center(mechanism, body)
    arm = add(center, scale(-inner(center, axis), axis))  # square to the axle
    tilts = hypot(axis[0], axis[1]) > DIRECTION_TOL
    return Pointer((body.name, ZERO), (body.name, arm)) if tilts and hypot(*arm) > DIRECTION_TOL else None


def _is_thin(mechanism: Mechanism, body: RigidBody) -> bool:
    """Return whether the mass of a body lies on the line from its hinge to its centre of mass."""
    endpoints, inertia = body_pointer(mechanism, body), max(map(abs, body.inertia))
    if endpoints is None or inertia == 0.0:
        return False
    arm = endpoints.bottom[1]
    return all(abs(part) <= DIRECTION_TOL * inertia * hypot(*arm) for part in apply_tensor(body.inertia, arm))


def _pivot(mechanism: Mechanism, name: str, mentions: Mapping[str, str]) -> str:
    """Return the phrase of the pivot of a body: its axle, or the centre of the round face on which it moves."""
    face = mechanism.contacts.get(name)
    if face is not None and face.turning:
        return f"the centre of {surface(mechanism, name, mentions)}"
    return "the axle"


def has_bodies_on_both_sides(mechanism: Mechanism, rod: str) -> bool:
    """Return whether bodies are welded to a light rod on both sides of its axle."""
    places = [body.at for body in welded_bodies(mechanism, rod)]
    return any(inner(places[0], position) < 0.0 for position in places[1:])


def welded_bodies(mechanism: Mechanism, rod: str) -> list[RigidBody]:
    """Return the bodies with mass that are welded to a rod."""
    carried = carried_bodies(mechanism, rod)
    return [body for body in carried if body.parent == rod and body.mass > 0.0 and not body.coordinates]


def load_center(mechanism: Mechanism, rod: RigidBody) -> Vector:
    """Return the centre of mass of the load of a light rod, or of the hinges on it, in the rod's frame, m."""
    heavy = [(b.mass, add(b.at, b.center)) for b in welded_bodies(mechanism, rod.name)]
    loads = heavy or [(1.0, b.at) for b in carried_bodies(mechanism, rod.name) if b.parent == rod.name]
    total = sum(mass for mass, _ in loads)
    return scale(1.0 / total, add(*(scale(mass, position) for mass, position in loads))) if loads else ZERO


@dataclass(frozen=True)
class Rods(Subject):
    """Light rods as subjects: between two sites, or on a hinge with the bodies at the other end."""

    name = slot = "rod"

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the names of rigid lines, then of bodies that are light rods."""
        lines = (line.name for line in mechanism.lines if isinstance(line.law, Rigid))
        return (*lines, *(body.name for body in mechanism.bodies if _pulls_alone(mechanism, body)))

    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """Return the phrases of rods with names of their own or with distinguishable ends."""
        rigid = [line for line in mechanism.lines if isinstance(line.law, Rigid)]
        bodies = {name: mentions[name] for name in self.names(mechanism) if name in mentions}
        return line_phrases(mechanism, mentions, rigid, "rod", alone=not bodies) | bodies

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """Return whether the text states `need` for every body: the force in a rod depends on all of them."""
        del name
        return is_stated_for_all(need, mechanism, said)

    def senses(self, mechanism: Mechanism, name: str) -> list[Sense]:
        """Return the direction in which the force of a rod counts as positive, tension."""
        del mechanism, name
        return [Sense("tension", (0.0, 0.0, 0.0))]

    def label(self, phrase: str) -> str:
        """Return the name of the rod, or its ends."""
        return ends_label(phrase)


def _pulls_alone(mechanism: Mechanism, body: RigidBody) -> bool:
    """Return whether a body is a light rod on a hinge, with only the rod and gravity acting on its load."""
    if not is_light_rod(body) or body_pointer(mechanism, body) is None:
        return False
    carried = {each.name for each in carried_bodies(mechanism, body.name)}
    pulled = {mechanism.site[site].body for line in mechanism.lines for site in line.through}
    acted = {force.body for force in mechanism.forces} | {burn.body for burn in mechanism.burns}
    drawn = {name for pull in mechanism.attractions for name in (pull.a, pull.b)}
    stands = {mechanism.site[foot.site].body for foot in mechanism.feet}
    return not carried & (pulled | acted | drawn | stands | mechanism.contacts.keys()) and _at_its_end(mechanism, body)


def _at_its_end(mechanism: Mechanism, rod: RigidBody) -> bool:
    """Return whether everything on a light rod is joined to it at one point."""
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
        return tuple(name for name in hinged if is_held_by_axle_alone(mechanism, name))

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


def is_held_by_axle_alone(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body, with all bodies joined to it, rotates about one fixed axle without other contacts."""
    if [c.kind for body in ancestor_chain(mechanism, name) for c in body.coordinates] != ["hinge"]:
        return False
    together = carried_bodies(mechanism, ancestor_chain(mechanism, name)[-1].name)
    carried = {body.name for body in together}
    pulled = {mechanism.site[site].body for line in mechanism.lines for site in line.through}
    acted = {force.body for force in mechanism.forces} | {burn.body for burn in mechanism.burns}
    drawn = {each for pull in mechanism.attractions for each in (pull.a, pull.b)}
    stands = {mechanism.site[foot.site].body for foot in mechanism.feet}
    hinges = [c.name for body in together for c in body.coordinates]
    wound = any(wheel.coordinate in hinges for line in mechanism.lines for wheel in line.wheels)
    return (
        len(hinges) == 1 and not wound and not carried & (pulled | acted | drawn | stands | mechanism.contacts.keys())
    )


DIRECTIONS = "directions of the string's parts"
"""The need of a quantity of a pulley that the text fixes the angle between its string parts."""


@dataclass(frozen=True)
class Pulleys(Subject):
    """Pulleys as subjects, named by their addresses: fixed ones and those on bodies."""

    name = slot = "pulley"

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the addresses of the pulleys over which a string runs, in the order of the strings."""
        owners = dict.fromkeys(site.rpartition(".")[0] for line in mechanism.lines for site in line.through)
        return tuple(owner for owner in owners if rim_sites(mechanism, owner) is not None)

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
                part = subtract_triples(frames.site(end).place, frames.site(rim).place)
                if hypot(float(part[0]), float(part[1])) > DIRECTION_TOL:
                    ends.add(end.partition(".")[0])
    return len(ends) <= 1
