"""Paths of strings through a drawing, and springs as zigzags."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import pairwise

from sim2reason.base.records import cached_property
from sim2reason.figures.plane import Polygon, unit_vector
from sim2reason.scenes.dsl.body import Body, FixedPlane, MovingSlope, PulleyWheel
from sim2reason.scenes.dsl.mechanism import Elastic, Line, Mechanism
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.vectors import Vector

COIL, LOOPS, LEAD = 0.17, 0.26, 0.25  # units: half the width, length of a loop, length of the straight part at each end
PARALLEL_OFFSET = 0.22  # units from the centre line to a spring and to its dashpot
CUP, PISTON, DEEP = 0.11, 0.08, 0.25  # half the widths of a dashpot's two parts, and half its length at most


def spring(a: complex, b: complex, line: Line | None) -> Iterator[Polygon]:
    """Yield the strokes of a spring from `a` to `b`, with a dashpot if the line has damping."""
    if not (line is not None and isinstance(line.law, Elastic) and line.law.damping):
        yield _zigzag(a, b)
        return
    direction = unit_vector(b - a)
    out, lead = PARALLEL_OFFSET * direction * 1j, min(0.5 * LEAD, 0.08 * abs(b - a)) * direction
    yield (a, a + lead)
    yield (b - lead, b)
    for end in (a + lead, b - lead):
        yield (end + out, end - out)
    yield _zigzag(a + lead + out, b - lead + out)
    yield from _dashpot(a + lead - out, b - lead - out)


def _dashpot(a: complex, b: complex) -> Iterator[Polygon]:
    """Yield the outline of a cup that opens towards `b`, and of a piston in it."""
    direction, long = unit_vector(b - a), abs(b - a)
    across, middle, deep = direction * 1j, 0.5 * (a + b), min(0.12 * long, DEEP) * direction
    bottom, top, piston = middle - deep, middle + deep, middle + 0.2 * deep
    yield (a, bottom)
    yield tuple(at + side * CUP * across for at, side in ((top, 1.0), (bottom, 1.0), (bottom, -1.0), (top, -1.0)))
    yield (piston + PISTON * across, piston - PISTON * across)
    yield (piston, b)


def _zigzag(a: complex, b: complex) -> Polygon:
    direction, long = unit_vector(b - a), abs(b - a)
    lead = min(LEAD, 0.15 * long)
    count = max(4, min(14, round((long - 2.0 * lead) / LOOPS)))
    step = (long - 2.0 * lead) / count
    across = COIL * direction * 1j
    zigzag = (a + direction * (lead + (n + 0.5) * step) + across * (1.0 if n % 2 else -1.0) for n in range(count))
    return (a, a + lead * direction, *zigzag, b - lead * direction, b)


def has_faces(body: Body | None) -> bool:
    """Return whether a body has faces on which blocks lie."""
    return body is not None and isinstance(body.look, FixedPlane | MovingSlope)


def is_plane(body: Body | None) -> bool:
    """Return whether a body is a fixed plane."""
    return body is not None and isinstance(body.look, FixedPlane)


def is_pulley(body: Body | None, *, fixed: bool = False) -> bool:
    """Return whether a body is a pulley; with `fixed`, one whose axle cannot move."""
    return body is not None and isinstance(body.look, PulleyWheel) and (body.look.fixed or not fixed)


def flat(vector: Vector) -> complex:
    """Return the projection of a vector to the plane of the drawing, seen from the front."""
    return complex(vector[0], vector[2])


@dataclass(frozen=True, slots=True)
class PathKnot:
    """A point where a string is tied, or a pulley that it goes round."""

    piece: str  # the address of what it lies on: a body, or a site of the room
    item: str  # the body, or else the site, that it is tied to or goes round
    arrives: str  # the site that the string reaches first
    leaves: str  # and the one from which it goes on; the same, but for pulleys
    rim: bool = False

    @property
    def side(self) -> float:
        """Return −1 if the string first touches the pulley on its left side, 1 on its right side."""
        return 1.0 if self.arrives.endswith(".right") else -1.0


@dataclass(frozen=True, slots=True)
class Strand:
    """A straight segment of a string between two points or pulleys, with its direction; None if not fixed."""

    string: str
    number: int  # of the strand in its string
    a: PathKnot
    b: PathKnot
    direction: complex | None

    @property
    def inner(self) -> bool:
        """Return whether both ends lie on the same piece."""
        return self.a.piece == self.b.piece


def owner_name(address: str) -> str:
    """Return the entity or connection that an address belongs to."""
    return address.split(".", maxsplit=1)[0]


def without_welds(scene: Scene) -> Scene:
    """Return the scene without welds, which change the motion but not the drawing."""
    return scene.model_copy(update={"glued": ()}) if scene.glued else scene


def longest_common_prefix(address: str, others: list[str]) -> str:
    """Return the address that shares the longest prefix with `address`."""

    def common(other: str) -> int:
        steps = zip(address.split("."), other.split("."), strict=False)
        return next((n for n, (a, b) in enumerate(steps) if a != b), 99)

    return max(others, key=common)


def carriers(scene: Scene) -> dict[str, str]:
    """Return the addresses of the bodies with faces, by the address of each block that rests on them."""
    mechanism = scene.mechanism
    planes = [address for address, body in scene.bodies.items() if is_plane(body)]
    carrier_by_block: dict[str, str] = {}
    for body in mechanism.bodies:
        if body.name not in mechanism.contacts or has_faces(scene.bodies.get(body.name)):
            continue
        if body.parent is not None and has_faces(scene.bodies.get(body.parent)):
            carrier_by_block[body.name] = body.parent
        elif planes:
            carrier_by_block[body.name] = longest_common_prefix(body.name, planes)
    return carrier_by_block


class Paths:
    """The strings of a scene: the points and pulleys along each, and the straight segments between them."""

    def __init__(self, scene: Scene, owners: frozenset[str], home: Mapping[str, str]) -> None:
        """Read the strings of the given entities and connections from the mechanism.

        `home` maps each entity that is drawn to scale to its piece.
        """
        self.home = home
        self.scene, self.mechanism = scene, scene.mechanism
        self.carriers = {a: b for a, b in carriers(scene).items() if owner_name(a) in owners}
        self.knots = {name: list(self._knots(sites)) for name, sites in _sites(self.mechanism, owners).items()}

    @cached_property
    def strands(self) -> list[Strand]:
        """Return the straight segments of all strings, string by string."""
        return [
            Strand(name, number, a, b, self._way(a, b))
            for name, knots in self.knots.items()
            for number, (a, b) in enumerate(pairwise(knots))
        ]

    def _knots(self, sites: list[str]) -> Iterator[PathKnot]:
        number = 0
        while number < len(sites):
            site, last = sites[number], number in (0, len(sites) - 1)
            owner = site.rpartition(".")[0]
            if is_pulley(self.scene.bodies.get(owner)):
                number += 1
                yield PathKnot(self.piece(site), owner, site, sites[number], rim=True)
            else:
                knot = PathKnot(self.piece(site), self._item(site), site, site)
                yield knot if last else replace(knot, item=site, rim=True)
            number += 1

    def _item(self, site: str) -> str:
        body = self.mechanism.site[site].body
        return body if body is not None and body in self.scene.bodies else site

    def piece(self, site: str) -> str:
        """Return the name of the drawn piece to which an attachment point belongs."""
        owner = site.rpartition(".")[0]
        if owner_name(site) in self.home:
            return self.home[owner_name(site)]
        if is_pulley(self.scene.bodies.get(owner), fixed=True):
            return owner
        body = self.mechanism.site[site].body
        return site if body is None else self.carriers.get(body, body)

    def _way(self, a: PathKnot, b: PathKnot) -> complex | None:
        """Return the direction of the string between two points or pulleys; None if the scene leaves it open."""
        builder = self.scene.builder
        near_by = a.leaves.split(".")[0] == b.arrives.split(".")[0]
        if not near_by and builder.faces[a.leaves] is None and builder.faces[b.arrives] is None:
            return None
        separation = flat(builder.position(b.arrives)) - flat(builder.position(a.leaves))
        return unit_vector(separation) if abs(separation) > 1e-9 else None


def _sites(mechanism: Mechanism, owners: frozenset[str]) -> dict[str, list[str]]:
    """Return the sites of each string from end to end; segments on both sides of massive pulleys are joined."""
    sites_by_string: dict[str, list[str]] = {}
    for line in mechanism.lines:
        if owner_name(line.whole) in owners:
            sites_by_string.setdefault(line.whole, []).extend(line.through)
    return sites_by_string
