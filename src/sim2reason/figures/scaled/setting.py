"""Context of a drawing to scale: its owners, view, and the positions and velocities of bodies on the page."""

import math
from collections.abc import Iterator
from itertools import product

from sim2reason.base.records import cached_property
from sim2reason.figures.pieces import VALUE_TOLERANCE, DrawingPlan
from sim2reason.figures.plane import COILED, FROM_ABOVE, NEIGHBOUR_GAP, RIGHT, SPAN, View, fitting, sides
from sim2reason.scenes.dsl.body import Axial, Body, BodyLook, Capped, Rectangular, Silhouette, Small, Spherical
from sim2reason.scenes.dsl.collector import Axes
from sim2reason.scenes.dsl.frames import Frames, initial_frames
from sim2reason.scenes.dsl.mechanism import Elastic, Line, RigidBody, X, Y, Z
from sim2reason.scenes.dsl.vectors import BoxRegion, DiscRegion, HalfSpace, Region, Triple, Vector, add, inner, scale

UPRIGHT: Axes = (X, Y, Z)
RADII = {"ball": 0.24, "puck": 0.3, "star": 0.38, "planet": 0.2}  # units, of round bodies whose size does not matter
OBLONG = ("block", "slab", "cart")
BESIDE = (*OBLONG, "sphere")  # bodies that stand on a track
SLAB, SLAB_LENGTH, SLAB_STEP = (
    0.62,
    1.5,
    0.9,
)  # units: the height of a slab, its length, and how much longer one below is
MIN_BLOCK_WIDTH = 0.45  # units, the least width of a block
THIN_BULK = 0.27  # times the length of a thin body
MAX_VERTICAL_COSINE = 0.1  # cosine to the horizontal below which a body slides vertically


def vector(triple: Triple) -> Vector:
    """Return three numbers as floats."""
    return (float(triple[0]), float(triple[1]), float(triple[2]))


class DrawingContext:
    """The geometry of entities drawn to scale: the view, and bodies, points and velocities on the page."""

    def __init__(self, plan: DrawingPlan, owners: frozenset[str]) -> None:
        """Choose the direction of view and the scale for the given entities and connections."""
        self.plan, self.owners = plan, owners
        self.mechanism = plan.paths.mechanism
        rest, speeds = zip(*((0.0, c.speed) for c in self.mechanism.coordinates), strict=True)
        self.frames, self.moving = initial_frames(self.mechanism), Frames(self.mechanism, rest, speeds, math)
        self.members = [body for body in self.mechanism.bodies if self.owns(body.name)]
        self.lines: list[Line] = [line for line in self.mechanism.lines if self.owns(line.whole)]
        right, up = sides(self.mechanism, self.members)
        plain = View(right, up, 1.0)
        small = [plain.at(self.place(a)) for a in self.bodies if isinstance(self.look(a), Small) and self.stands(a)]
        small += [plain.at(position) for position in self._turns()]
        largest = max((2.0 * self._bulk(a) for a in self.bodies), default=0.0)
        seen = [plain.at(position) for position in self._included_positions()]
        wanted = FROM_ABOVE if plain.level else SPAN
        coils = any(isinstance(line.law, Elastic) for line in self.lines)
        size = fitting(seen or [0j], small, largest, wanted, apart=COILED if coils else NEIGHBOUR_GAP)
        thick = [
            math.dist(vector(self.frames[a].origin), vector(self.frames[b].origin)) for a, b in self.stacked.items()
        ]
        self.view = View(right, up, SLAB / min(thick) if thick and min(thick) > VALUE_TOLERANCE else size)
        self.drawn: set[str] = set()  # addresses, as the parts of the drawing come
        self._shown: set[tuple[str, str]] = set()
        self.legend: tuple[float, str] | None = None  # how long an arrow is, and for which speed

    def owns(self, address: str) -> bool:
        """Return whether the object at an address belongs to this drawing."""
        return address.split(".", maxsplit=1)[0] in self.owners

    @cached_property
    def bodies(self) -> dict[str, Body]:
        """Return the bodies of the text in this drawing, by address."""
        return {address: body for address, body in self.plan.scene.bodies.items() if self.owns(address)}

    def look(self, address: str) -> BodyLook | None:
        """Return the look of a body; None if the address is no body of the text, or its class has no look."""
        body = self.bodies.get(address)
        return None if body is None else body.look

    def stands(self, address: str) -> bool:
        """Return whether the mechanism has a rigid body at an address."""
        return address in self.mechanism.body

    def place(self, address: str) -> Vector:
        """Return the position of a body: its centre of mass, or the origin of an extended body's axes."""
        if isinstance(self.look(address), Spherical | Axial | Capped | Rectangular | Silhouette):
            return vector(self.frames[address].origin)
        return vector(self.frames.center(address).place)

    def at(self, address: str) -> complex:
        """Return the position of a body on the page."""
        return self.view.at(self.place(address))

    def site(self, name: str) -> complex:
        """Return the position on the page of an attachment point (site) of a body or of the ground."""
        return self.view.at(vector(self.frames.site(name).place))

    def velocity(self, address: str) -> complex:
        """Return the initial velocity of a body on the page, in units of the text."""
        return self.view.project_direction(vector(self.moving.center(address).velocity))

    def axes(self, address: str) -> Axes:
        """Return the directions of a body's own axes in the world frame."""
        return self.plan.scene.builder.turned.get(address, UPRIGHT)

    def origin(self, owner: str) -> Vector:
        """Return the position of an entity's origin in the world frame."""
        return self.plan.scene.builder.origins.get(owner, (0.0, 0.0, 0.0))

    def extent(self, address: str) -> float:
        """Return the radius of a body from the text or its collisions; 0 where it does not matter."""
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
        """Return half the size of a body, by which the scale of the drawing is chosen; less for thin bodies."""
        match self.look(address):
            case Axial(radius, height):
                return max(radius, THIN_BULK * height)
            case Rectangular(x, y, z):
                smallest, middle, most = sorted((x, y, z))
                del smallest
                return max(0.5 * middle, THIN_BULK * most)
            case _:
                return self.extent(address)

    @cached_property
    def stacked(self) -> dict[str, str]:
        """Return, for each body that lies on another small body, the address of the lower one."""
        parents = {
            f.subject: self.mechanism.body[f.subject].parent for f in self.mechanism.faces if self.owns(f.subject)
        }
        return {a: b for a, b in parents.items() if b is not None and isinstance(self.look(b), Small)}

    def sizes(self, address: str) -> tuple[float, float]:
        """Return the width and height of a block, in units; of stacked slabs the lower one is longer."""
        look, usual = self.look(address), self.plan.sizes
        if not isinstance(look, Small) or look.kind != "slab":
            return min(usual.width, self._max_block_width(address)), usual.height
        above, top = 0, address
        while (upper := next((a for a, b in self.stacked.items() if b == top), None)) is not None:
            above, top = above + 1, upper
        return SLAB_LENGTH + SLAB_STEP * above, SLAB

    def _max_block_width(self, address: str) -> float:
        """Return the largest width of a block that keeps it clear of its neighbours, in units, with a minimum."""
        look = self.look(address)
        oblong = [a for a in self.bodies if isinstance(other := self.look(a), Small) and other.kind in BESIDE]
        if not isinstance(look, Small):
            return math.inf
        ways = (self.at(a) - self.at(address) for a in oblong if a != address and self.stands(a))
        return max(
            MIN_BLOCK_WIDTH,
            0.9 * min((abs(offset) for offset in ways if abs(offset.imag) < abs(offset.real)), default=math.inf),
        )

    def radius(self, address: str) -> float:
        """Return the drawn radius of a body, in units; of a block, half its height."""
        look, real = self.look(address), self.extent(address)
        if isinstance(look, Small):
            return max(RADII.get(look.kind, 0.5 * self.sizes(address)[1]), self.view.scale * real)
        return self.view.scale * real

    def along(self, address: str) -> complex:
        """Return the direction of a block's long side: along its face or rail, else horizontal."""
        face = self.mechanism.contacts.get(address)
        slides = [c for c in self.mechanism.body[address].coordinates if c.kind == "slide"]
        if (face is None or face.turning) and len(slides) != 1:
            return RIGHT
        direction = self.view.project_direction(slides[0].axis) if slides else RIGHT
        if face is None and abs(direction.real) < MAX_VERTICAL_COSINE:
            return RIGHT
        return (direction if direction.real >= 0.0 else -direction) / (abs(direction) or 1.0)

    def edge(self, site: str, way: complex) -> complex:
        """Return the point where a line from a site along a unit vector leaves the drawn body."""
        return self.rim(self.mechanism.site[site].body, self.site(site), way)

    def rim(self, body: str | None, at: complex, way: complex) -> complex:
        """Return the point where a line from a position on a body along a unit vector leaves the drawn body."""
        look = None if body is None else self.look(body)
        if body is None or not isinstance(look, Small) or abs(at - self.at(body)) > VALUE_TOLERANCE:
            return at
        if look.kind not in OBLONG:
            return at + self.radius(body) * way
        turned, (wide, tall) = way / self.along(body), self.sizes(body)
        steep = abs(turned.imag) * wide >= abs(turned.real) * tall
        far = 0.5 * (tall / abs(turned.imag) if steep else wide / abs(turned.real))
        return at + far * way

    def regions(self) -> Iterator[tuple[Region, str]]:
        """Yield the regions of space to which forces are limited, each once, with a body on which the force acts."""
        seen: list[Region] = []
        for force in self.mechanism.forces:
            if force.region is not None and self.owns(force.body) and force.region not in seen:
                seen.append(force.region)
                yield force.region, force.body

    def stated(self, owner: str, unit: str, value: float) -> str:
        """Return the text of an entity's number with this unit and value; empty if the text states no such number."""
        return self.plan.stated(owner, unit, value)

    def state_once(self, owner: str, unit: str, value: float) -> str:
        """Return a stated number as text the first time; empty afterwards, because the drawing already shows it."""
        text = self.stated(owner, unit, value)
        new = (owner, text) not in self._shown
        self._shown.add((owner, text))
        return text if new else ""

    def _included_positions(self) -> Iterator[Vector]:
        """Yield the positions that the drawing must include."""
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
                position = self.place(meeting.b)
                yield add(
                    position, scale(meeting.distance - inner(meeting.normal, position), meeting.normal)
                )  # of a wall
        for region, _ in self.regions():
            yield from corners(region)
        for face in self.mechanism.faces:
            if face.turning and self.owns(face.subject):
                yield from self.track(face.subject)
        if any(c.label == "x" for body in self.members for c in body.coordinates):
            yield from (self.origin(owner) for owner in self.owners if owner in self.plan.scene.builder.origins)

    def _turns(self) -> Iterator[Vector]:
        """Yield the fixed points at which strings bend, even if the ends of the strings are outside this drawing."""
        for line in self.mechanism.lines:
            for site in line.through[1:-1]:
                if self.owns(site) and self.mechanism.site[site].body is None:
                    yield vector(self.frames.site(site).place)

    def track(self, address: str) -> list[Vector]:
        """Return the ends of the horizontal and vertical diameters of the circular track under a body."""
        middle = vector(self.frames[address].origin)
        radius = math.dist(middle, vector(self.frames.center(address).place))
        return [add(middle, scale(side * radius, axis)) for axis in (X, Z) for side in (-1.0, 1.0)]

    def _below(self, body: RigidBody) -> list[Vector]:
        """Return the point of the ground below a body that can fall to it, as a list."""
        floor = self.floor(body)
        if floor is None:
            return []
        x, y, _ = self.place(body.name)
        return [(x, y, floor)]

    def floor(self, body: RigidBody) -> float | None:
        """Return the height of the horizontal ground under a body that can hit it; None without one."""
        for coordinate in body.coordinates:
            upright = coordinate.kind == "slide" and coordinate.axis[2] > 1.0 - VALUE_TOLERANCE
            if upright and math.isfinite(coordinate.lower) and body.parent is None:
                return self.place(body.name)[2] + coordinate.lower
        for meeting in self.mechanism.meetings:
            if meeting.b == body.name and meeting.a is None and meeting.normal == Z:
                return meeting.distance
        return None


def corners(region: Region) -> Iterator[Vector]:
    """Yield the points on the borders of a region, if it is bounded."""
    if isinstance(region, DiscRegion):
        r, (x, y, z) = region.radius, region.center
        yield from ((x + r, y, z), (x - r, y, z), (x, y + r, z), (x, y - r, z), (x, y, z + r), (x, y, z - r))
    elif isinstance(region, BoxRegion):
        for places in product(*([scale(low, axis), scale(high, axis)] for axis, low, high in region.sides)):
            yield add(*places)
    elif isinstance(region, HalfSpace):
        yield scale(region.offset, region.normal)
