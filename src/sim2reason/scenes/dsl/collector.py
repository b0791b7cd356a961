"""The collection of the parts of a mechanism, with checks and names."""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from itertools import pairwise
from math import dist

from sim2reason.base.records import cached_property
from sim2reason.errors import SceneError
from sim2reason.scenes.dsl.mechanism import (
    GRAVITY,
    ZERO,
    Attraction,
    CollisionPair,
    ConstantTension,
    Coordinate,
    Elastic,
    Force,
    Inextensible,
    Line,
    LineLaw,
    MassEjection,
    Mechanism,
    PlaneContact,
    RigidBody,
    Site,
    SurfaceContact,
    WheelCoupling,
)
from sim2reason.scenes.dsl.units import SI, UnitSystem
from sim2reason.scenes.dsl.vectors import Vector, add

Axes = tuple[Vector, Vector, Vector]
"""The directions of the x, y and z axes of a body in the world frame: orthogonal unit vectors."""
WHEEL_RADIUS = 0.05  # m; default radius of a pulley, for drawings only


@dataclass(frozen=True, slots=True)
class Rim:
    """The two points where a string meets a pulley's rim, as site names, and the wheel if it has mass.

    A string that passes over or under it goes through both, one after the other.
    """

    left: str
    right: str
    coordinate: str | None = None
    radius: float = WHEEL_RADIUS


class Collector:
    """A collector of the parts of a mechanism, which also welds glued bodies and splits lines."""

    def __init__(
        self, gravity: Vector = (0.0, 0.0, -GRAVITY), glued: Iterable[str] = (), units: UnitSystem = SI
    ) -> None:
        """Start without parts; bodies in `glued` are welded to their parents regardless of the entities."""
        self._gravity, self._units = gravity, units
        self._glued = frozenset(glued)
        self._bodies: dict[str, RigidBody] = {}
        self._origin: dict[str | None, Vector] = {None: ZERO}
        self._sites: dict[str, Site] = {}
        self.faces: dict[str, Vector | None] = {}  # by site, the way in which a string must leave it
        self.drawing: dict[str, ConstantTension | Inextensible] = {}  # by site, the law of a string drawn in there
        self.origins: dict[str, Vector] = {}  # by entity, where it stands in the room; only for looks
        self.turned: dict[str, Axes] = {}  # by body, where its own axes point at the start; only for looks
        self.wound: set[str] = set()  # the strings that leave the rim of what they are wound round; only for looks
        self._rims: dict[tuple[str, str], Rim] = {}
        self.welded: dict[str, str | None] = {}  # entities that can't move on what carries them, and that
        self._lines: dict[str, Line] = {}
        self._faces: dict[str, SurfaceContact] = {}
        self.feet: list[PlaneContact] = []
        self.forces: list[Force] = []
        self.attractions: list[Attraction] = []
        self.burns: list[MassEjection] = []
        self.meetings: list[CollisionPair] = []

    @property
    def bodies(self) -> tuple[str, ...]:
        """Return the names of all bodies."""
        return tuple(self._bodies)

    def position(self, site: str) -> Vector:
        """Return the initial position of a site in the world frame, m."""
        entry = self._sites[site]
        return add(self._origin[entry.body], entry.at)

    def carrier(self, site: str) -> str | None:
        """Return the body of a site; None for the room."""
        return self._sites[site].body

    @cached_property
    def extent(self) -> tuple[float, float]:
        """Return the least and greatest x of all sites and bodies, m."""
        across = [self.position(site)[0] for site in self._sites] + [at[0] for name, at in self._origin.items() if name]
        return (min(across), max(across)) if across else (0.0, 0.0)

    def relative(self, body: str | None, where: Vector) -> Vector:
        """Return a point of the world frame relative to the frame of a body at the start, m."""
        origin = self._origin[body]
        return (where[0] - origin[0], where[1] - origin[1], where[2] - origin[2])

    def add_body(self, body: RigidBody) -> None:
        """Add a body; raise SceneError if its name is already in use."""
        self._new(body.name, self._bodies)
        self._bodies[body.name] = body
        self._origin[body.name] = add(self._origin[body.parent], body.at)

    def add_coordinate(self, coordinate: Coordinate) -> None:
        """Add a coordinate unless its body is glued or welded; SceneError for a welded body with an initial speed."""
        body = self._bodies[coordinate.body]
        welded = self._is_welded(body)
        if welded and coordinate.speed != 0.0:
            raise SceneError(coordinate.body, "it is welded and can not move at the start", "leave out how it starts")
        if coordinate.body not in self._glued and not welded:
            ways = (*body.coordinates, coordinate)
            self._bodies[coordinate.body] = RigidBody(
                body.name, body.parent, body.at, body.mass, body.center, body.inertia, ways
            )

    def _is_welded(self, body: RigidBody) -> bool:
        if not self.welded:
            return False
        owner = body.name.split(".", maxsplit=1)[0]
        return owner in self.welded and body.parent == self.welded[owner]

    def add_face(self, face: SurfaceContact) -> None:
        """Add a contact of a body with its parent unless the body is glued to it."""
        if face.subject not in self._glued and not self._is_welded(self._bodies[face.subject]):
            self._faces[face.subject] = face

    def add_site(self, name: str, body: str | None, where: Vector, faces: Vector | None = None) -> None:
        """Add a point of a body, given its initial position in the world frame."""
        self._new(name, self._sites)
        self.faces[name] = faces
        self._sites[name] = Site(name, body, self.relative(body, where))

    def add_pulley(self, name: str, pulley: Rim) -> Rim:
        """Add a pulley, which strings rotate; if it is glued, strings slide over it."""
        kept = replace(pulley, coordinate=None) if name in self._glued else pulley
        self._rims[pulley.left, pulley.right] = kept
        return kept

    def add_line(self, name: str, through: Iterable[str], law: LineLaw, last: LineLaw | None = None) -> None:
        """Add a line, split at the massive pulleys that it passes; `last` is the force law of its last part."""
        parts = self._split(through)
        for number, (sites, wheels) in enumerate(parts, start=1):
            part = name if len(parts) == 1 else f"{name}/{number}"
            self._new(part, self._lines)
            own = last if last is not None and number == len(parts) else law
            self._lines[part] = Line(part, name, sites, wheels, own)

    def add_spring(
        self, name: str, through: Iterable[str], stiffness: float, length: float | None, damping: float
    ) -> None:
        """Add a spring; without a natural length it is initially relaxed."""
        sites = tuple(through)
        if length is None:
            places = [self.position(site) for site in sites]
            length = sum(dist(one, other) for one, other in pairwise(places))
        self.add_line(name, sites, Elastic(stiffness, length, damping))

    def add_arc(self, name: str, bodies: tuple[str, str], radius: float, arc: float, law: LineLaw) -> None:
        """Add a line along the circle on which two bodies rotate; a glued body holds its end."""
        ends = (f"{name}.from", f"{name}.to")
        for end, at in zip(ends, (ZERO, (arc, 0.0, 0.0)), strict=True):
            self.add_site(end, None, at)
        hinges = [self._bodies[body].coordinates for body in bodies]
        sides = zip(hinges, (-radius, radius), strict=True)
        wheels = tuple(WheelCoupling(hinge.name, side) for own, side in sides for hinge in own)
        self._new(name, self._lines)
        self._lines[name] = Line(name, name, ends, wheels, law, bodies)

    def add_wound(self, name: str, body: str, ends: tuple[str, str], radius: float) -> None:
        """Add a string wound round a rotating body; its free length shrinks by `radius` times the angle."""
        self._new(name, self._lines)
        self.wound.add(name)
        wheels = tuple(WheelCoupling(hinge.name, radius) for hinge in self._bodies[body].coordinates)
        self._lines[name] = Line(name, name, ends, wheels, Inextensible())

    def _split(self, through: Iterable[str]) -> list[tuple[tuple[str, ...], tuple[WheelCoupling, ...]]]:
        """Return the parts of a path, split where it passes the rim of a massive pulley."""
        parts: list[tuple[list[str], list[WheelCoupling]]] = [([], [])]
        for site in through:
            if site not in self._sites:
                raise ValueError(f"no site is called {site!r}")
            sites, wheels = parts[-1]
            grip = self._grip(sites[-1], site) if sites else None
            if grip is None:
                sites.append(site)
            else:
                wheels.append(grip)
                parts.append(([site], [WheelCoupling(grip.coordinate, -grip.radius)]))
        if any(len(sites) < 2 for sites, _ in parts):
            raise ValueError("a string needs two ends, and something between any two massive pulleys")
        return [(tuple(sites), tuple(wheels)) for sites, wheels in parts]

    def _grip(self, first: str, last: str) -> WheelCoupling | None:
        """Return the wheel of a massive pulley with rim points `first` and `last`, signed by direction; else None."""
        pulley = self._rims.get((first, last)) or self._rims.get((last, first))
        if pulley is None or pulley.coordinate is None:
            return None
        # The wheel turns right-handed about y: its left rim rises and takes in string that hangs from it, but
        # gives out string that holds it from above.
        upwards = self.faces[first]
        under = upwards is not None and upwards[2] > 0.0
        return WheelCoupling(pulley.coordinate, pulley.radius if (first == pulley.left) != under else -pulley.radius)

    def _new(self, name: str, known: Iterable[str]) -> None:
        if name in known:
            raise SceneError(name, "two things have this name", "give each body and string its own")

    def finish(self) -> Mechanism:
        """Return the mechanism of all collected parts."""
        return Mechanism(
            tuple(self._bodies.values()),
            tuple(self._sites.values()),
            tuple(self._lines.values()),
            tuple(self._faces[body] for body in self._bodies if body in self._faces),
            tuple(self.feet),
            tuple(self.forces),
            tuple(self.attractions),
            tuple(self.burns),
            tuple(self.meetings),
            self._gravity,
            self._units,
        )
