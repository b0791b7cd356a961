"""What all parts of a drawing to scale know: whose it is, the view, and where things stand and how they move."""

import math
from collections.abc import Iterator
from itertools import product

from sim2reason.base.lazy import cached_property
from sim2reason.figures.pieces import LIKE, DrawingPlan
from sim2reason.figures.scaled.view import APART, COILED, FROM_ABOVE, SPAN, View, fitting, sides
from sim2reason.figures.vectors import RIGHT
from sim2reason.scenes.dsl.body import Axial, Body, BodyLook, Capped, Rectangular, Silhouette, Small, Spherical
from sim2reason.scenes.dsl.collector import Axes
from sim2reason.scenes.dsl.frames import Frames, start
from sim2reason.scenes.dsl.mechanism import Elastic, Line, RigidBody, X, Y, Z
from sim2reason.scenes.dsl.vectors import BoxRegion, DiscRegion, HalfSpace, Region, Triple, Vector, add, inner, scale

UPRIGHT: Axes = (X, Y, Z)
RADII = {"ball": 0.24, "puck": 0.3, "star": 0.38, "planet": 0.2}  # units, of round things whose size does not matter
OBLONG = ("block", "slab", "cart")
BESIDE = (*OBLONG, "sphere")  # what stands on a track
SLAB, SLAB_LENGTH, SLAB_STEP = (
    0.62,
    1.5,
    0.9,
)  # units: the height of a slab, its length, and how much longer one below is
NARROW = 0.45  # units, the least width of a block
THIN_BULK = 0.27  # of the length of what is long and thin
STEEP = 0.1  # the cosine below which a body slides up and down rather than along


def vector(triple: Triple) -> Vector:
    """Three numbers as floats."""
    return (float(triple[0]), float(triple[1]), float(triple[2]))


class Setting:
    """The part of a scene that is drawn to scale in one piece."""

    def __init__(self, plan: DrawingPlan, owners: frozenset[str]) -> None:
        """`owners` are the entities and connections that are drawn."""
        self.plan, self.owners = plan, owners
        self.mechanism = plan.paths.mechanism
        rest, speeds = zip(*((0.0, c.speed) for c in self.mechanism.coordinates), strict=True)
        self.frames, self.moving = start(self.mechanism), Frames(self.mechanism, rest, speeds, math)
        self.members = [body for body in self.mechanism.bodies if self.owns(body.name)]
        self.lines: list[Line] = [line for line in self.mechanism.lines if self.owns(line.whole)]
        right, up = sides(self.mechanism, self.members)
        plain = View(right, up, 1.0)
        small = [plain.at(self.place(a)) for a in self.bodies if isinstance(self.look(a), Small) and self.stands(a)]
        small += [plain.at(place) for place in self._turns()]
        largest = max((2.0 * self._bulk(a) for a in self.bodies), default=0.0)
        seen = [plain.at(place) for place in self._places()]
        wanted = FROM_ABOVE if plain.level else SPAN
        coils = any(isinstance(line.law, Elastic) for line in self.lines)
        size = fitting(seen or [0j], small, largest, wanted, apart=COILED if coils else APART)
        thick = [
            math.dist(vector(self.frames[a].origin), vector(self.frames[b].origin)) for a, b in self.stacked.items()
        ]
        self.view = View(right, up, SLAB / min(thick) if thick and min(thick) > LIKE else size)
        self.drawn: set[str] = set()  # addresses, as the parts of the drawing come
        self._shown: set[tuple[str, str]] = set()
        self.legend: tuple[float, str] | None = None  # how long an arrow is, and for which speed

    def owns(self, address: str) -> bool:
        """Return whether something with this address belongs to the drawing."""
        return address.split(".", maxsplit=1)[0] in self.owners

    @cached_property
    def bodies(self) -> dict[str, Body]:
        """The bodies of the text that are to be drawn."""
        return {address: body for address, body in self.plan.scene.bodies.items() if self.owns(address)}

    def look(self, address: str) -> BodyLook | None:
        """Return how a body looks; None for what is no body of the text, or has no look."""
        body = self.bodies.get(address)
        return None if body is None else body.look

    def stands(self, address: str) -> bool:
        """Return whether the mechanism has a body at an address."""
        return address in self.mechanism.body

    def place(self, address: str) -> Vector:
        """Where a body stands: a small one at its centre of mass, one with extent at the origin of its own axes."""
        if isinstance(self.look(address), Spherical | Axial | Capped | Rectangular | Silhouette):
            return vector(self.frames[address].origin)
        return vector(self.frames.center(address).place)

    def at(self, address: str) -> complex:
        """Return the same on the page."""
        return self.view.at(self.place(address))

    def site(self, name: str) -> complex:
        """Return a site on the page."""
        return self.view.at(vector(self.frames.site(name).place))

    def velocity(self, address: str) -> complex:
        """Return how fast a body moves at the start, in the units of the text."""
        return self.view.way(vector(self.moving.center(address).velocity))

    def axes(self, address: str) -> Axes:
        """Return where the own axes of a body point."""
        return self.plan.scene.builder.turned.get(address, UPRIGHT)

    def origin(self, owner: str) -> Vector:
        """Return where an entity stands."""
        return self.plan.scene.builder.origins.get(owner, (0.0, 0.0, 0.0))

    def extent(self, address: str) -> float:
        """Return the radius of a body that the text or its collisions give; 0 where it does not matter."""
        match self.look(address):
            case Spherical(radius):
                return radius
            case Axial(radius, height):
                return max(radius, 0.5 * height)
            case Capped(radius):
                return radius
            case Rectangular(x, y, z):
                return 0.5 * max(x, y, z)
            case Silhouette(points):
                return max(math.hypot(*point) for point in points)
            case _:
                meetings = (m for m in self.mechanism.meetings if address in m.names and m.normal is None)
                return 0.5 * min((m.distance for m in meetings), default=0.0)

    def _bulk(self, address: str) -> float:
        """Half the size of a body that is not to fill the page: less than half its length if it is thin."""
        match self.look(address):
            case Axial(radius, height):
                return max(radius, THIN_BULK * height)
            case Rectangular(x, y, z):
                least, middle, most = sorted((x, y, z))
                del least
                return max(0.5 * middle, THIN_BULK * most)
            case _:
                return self.extent(address)

    @cached_property
    def stacked(self) -> dict[str, str]:
        """By small body that lies on another small one the name of that."""
        held = {f.subject: self.mechanism.body[f.subject].parent for f in self.mechanism.faces if self.owns(f.subject)}
        return {a: b for a, b in held.items() if b is not None and isinstance(self.look(b), Small)}

    def sizes(self, address: str) -> tuple[float, float]:
        """Return the width and height of a block, in units; of slabs the lower one is the longer one."""
        look, usual = self.look(address), self.plan.sizes
        if not isinstance(look, Small) or look.kind != "slab":
            return min(usual.width, self._near(address)), usual.height
        above, top = 0, address
        while (found := next((a for a, b in self.stacked.items() if b == top), None)) is not None:
            above, top = above + 1, found
        return SLAB_LENGTH + SLAB_STEP * above, SLAB

    def _near(self, address: str) -> float:
        """Return a little less than the distance to the nearest block beside this one, in units; but not too little."""
        look = self.look(address)
        oblong = [a for a in self.bodies if isinstance(other := self.look(a), Small) and other.kind in BESIDE]
        if not isinstance(look, Small):
            return math.inf
        ways = (self.at(a) - self.at(address) for a in oblong if a != address and self.stands(a))
        return max(NARROW, 0.9 * min((abs(way) for way in ways if abs(way.imag) < abs(way.real)), default=math.inf))

    def radius(self, address: str) -> float:
        """Return the radius with which a body is drawn, in units: of a block, half its height."""
        look, real = self.look(address), self.extent(address)
        if isinstance(look, Small):
            return max(RADII.get(look.kind, 0.5 * self.sizes(address)[1]), self.view.scale * real)
        return self.view.scale * real

    def along(self, address: str) -> complex:
        """Return the way in which a block lies: along its face or its rail, else level."""
        face = self.mechanism.contacts.get(address)
        slides = [c for c in self.mechanism.body[address].coordinates if c.kind == "slide"]
        if (face is None or face.turning) and len(slides) != 1:
            return RIGHT
        way = self.view.way(slides[0].axis) if slides else RIGHT
        if face is None and abs(way.real) < STEEP:
            return RIGHT
        return (way if way.real >= 0.0 else -way) / (abs(way) or 1.0)

    def edge(self, site: str, way: complex) -> complex:
        """Return where a line that leaves a site along a unit vector comes out of the body, if that is a small one."""
        return self.rim(self.mechanism.site[site].body, self.site(site), way)

    def rim(self, body: str | None, at: complex, way: complex) -> complex:
        """Return the same for a place on a body."""
        look = None if body is None else self.look(body)
        if body is None or not isinstance(look, Small) or abs(at - self.at(body)) > LIKE:
            return at
        if look.kind not in OBLONG:
            return at + self.radius(body) * way
        turned, (wide, tall) = way / self.along(body), self.sizes(body)
        steep = abs(turned.imag) * wide >= abs(turned.real) * tall
        far = 0.5 * (tall / abs(turned.imag) if steep else wide / abs(turned.real))
        return at + far * way

    def regions(self) -> Iterator[tuple[Region, str]]:
        """Yield the regions outside which forces cease, each once, with a body on which they act."""
        found: list[Region] = []
        for force in self.mechanism.forces:
            if force.region is not None and self.owns(force.body) and force.region not in found:
                found.append(force.region)
                yield force.region, force.body

    def stated(self, owner: str, unit: str, value: float) -> str:
        """Return a number of an entity as the text has it, if one of that size and unit is stated; else nothing."""
        return self.plan.stated(owner, unit, value)

    def once(self, owner: str, unit: str, value: float) -> str:
        """Return the same, but nothing if the drawing has shown this number before."""
        text = self.stated(owner, unit, value)
        new = (owner, text) not in self._shown
        self._shown.add((owner, text))
        return text if new else ""

    def _places(self) -> Iterator[Vector]:
        """Yield what must be in sight."""
        for body in self.members:
            yield self.place(body.name)
            if any(c.kind == "hinge" for c in body.coordinates):
                yield vector(self.frames[body.name].origin)
            yield from (self._below(body) or ())
        for line in self.lines:
            bent = line.circle is not None
            yield from () if bent else (vector(self.frames.site(site).place) for site in line.through)
        yield from self._turns()
        for meeting in self.mechanism.meetings:
            if meeting.a is None and meeting.normal is not None and self.owns(meeting.b):
                place = self.place(meeting.b)
                yield add(place, scale(meeting.distance - inner(meeting.normal, place), meeting.normal))  # of a wall
        for region, _ in self.regions():
            yield from corners(region)
        for face in self.mechanism.faces:
            if face.turning and self.owns(face.subject):
                yield from self.track(face.subject)
        if any(c.label == "x" for body in self.members for c in body.coordinates):
            yield from (self.origin(owner) for owner in self.owners if owner in self.plan.scene.builder.origins)

    def _turns(self) -> Iterator[Vector]:
        """Points of the room that strings pass, wherever their ends are."""
        for line in self.mechanism.lines:
            for site in line.through[1:-1]:
                if self.owns(site) and self.mechanism.site[site].body is None:
                    yield vector(self.frames.site(site).place)

    def track(self, address: str) -> list[Vector]:
        """Return the ends of the level and the upright diameter of a round track on which a body lies."""
        middle = vector(self.frames[address].origin)
        radius = math.dist(middle, vector(self.frames.center(address).place))
        return [add(middle, scale(side * radius, way)) for way in (X, Z) for side in (-1.0, 1.0)]

    def _below(self, body: RigidBody) -> list[Vector]:
        """Return the point of the ground below a body that can fall to it."""
        floor = self.floor(body)
        if floor is None:
            return []
        x, y, _ = self.place(body.name)
        return [(x, y, floor)]

    def floor(self, body: RigidBody) -> float | None:
        """Return the height of level ground under a body, where it can meet it; None without any."""
        for coordinate in body.coordinates:
            upright = coordinate.kind == "slide" and coordinate.axis[2] > 1.0 - LIKE
            if upright and math.isfinite(coordinate.lower) and body.parent is None:
                return self.place(body.name)[2] + coordinate.lower
        for meeting in self.mechanism.meetings:
            if meeting.b == body.name and meeting.a is None and meeting.normal == Z:
                return meeting.distance
        return None


def corners(region: Region) -> Iterator[Vector]:
    """Points at the borders of a region, as far as it has any."""
    if isinstance(region, DiscRegion):
        r, (x, y, z) = region.radius, region.center
        yield from ((x + r, y, z), (x - r, y, z), (x, y + r, z), (x, y - r, z), (x, y, z + r), (x, y, z - r))
    elif isinstance(region, BoxRegion):
        for places in product(*([scale(low, axis), scale(high, axis)] for axis, low, high in region.sides)):
            yield add(*places)
    elif isinstance(region, HalfSpace):
        yield scale(region.offset, region.normal)
