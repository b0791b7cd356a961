"""The verbs that entities speak; the one `Builder` turns them into a `Mechanism`."""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from math import inf

from sim2reason.dsl.mechanism import (
    GRAVITY,
    ZERO,
    Body,
    Collision,
    Contact,
    Coordinate,
    Mechanism,
    Pull,
    Site,
    String,
    Vector,
    Wheel,
    Y,
)
from sim2reason.dsl.vectors import add, scale, unit
from sim2reason.errors import SceneError

WHEEL_RADIUS = 0.05  # m; of a pulley that nobody gave one, so only for looks


@dataclass(frozen=True, slots=True)
class Pulley:
    """The points where a string meets a pulley's rim, as site names, and the wheel if it has mass.

    A string that passes over or under it goes through both, one after the other.
    """

    left: str
    right: str
    coordinate: str | None = None
    radius: float = WHEEL_RADIUS


class Frame:
    """A body under construction, or the room; what is made on it moves with it."""

    def __init__(self, builder: "Builder", prefix: str, body: str | None, at: Vector) -> None:
        """`prefix` goes before every name made here; `at` is where its origin stands in the room."""
        self._builder, self.prefix, self.name, self.at = builder, prefix, body, at

    def address(self, name: str) -> str:
        """The full address of a name that is made here."""
        return f"{self.prefix}.{name}" if self.prefix else name

    def part(self, name: str, at: Vector = ZERO) -> "Frame":
        """The same body, shifted by `at`, with `name` before all names: room for a part of an entity."""
        return Frame(self._builder, self.address(name), self.name, add(self.at, at))

    def body(self, name: str, mass: float = 0.0, *, at: Vector = ZERO, inertia: float = 0.0) -> "Frame":
        """A new body carried by this one, its centre of mass at `at`; welded until it is told to move."""
        address, where = self.address(name), add(self.at, at)
        self._builder.add_body(Body(address, self.name, self._builder.relative(self.name, where), mass, inertia))
        return Frame(self._builder, self.prefix, address, where)

    def slide(
        self, axis: Vector, speed: float = 0.0, limits: tuple[float, float] = (-inf, inf), name: str = "slide"
    ) -> "Frame":
        """Let it move along `axis`; call twice, with another name, for two directions."""
        self._builder.add_coordinate(
            self._own(), Coordinate(f"{self.name}.{name}", "slide", unit(axis), speed, *limits)
        )
        return self

    def hinge(self, axis: Vector, speed: float = 0.0) -> "Frame":
        """Let it turn about `axis` through its centre of mass."""
        self._builder.add_coordinate(self._own(), Coordinate(f"{self.name}.hinge", "hinge", unit(axis), speed))
        return self

    def rest(
        self,
        along: Vector,
        normal: Vector,
        friction: float = 0.0,
        speed: float = 0.0,
        limits: tuple[float, float] = (-inf, inf),
    ) -> "Frame":
        """Lay it on its parent's face: it slides along `along` and is pressed along `normal`."""
        self.slide(along, speed, limits)
        self._builder.add_contact(self._own(), Contact(f"{self.name}.slide", unit(normal), friction))
        return self

    def site(self, name: str, at: Vector = ZERO, faces: Vector | None = None) -> "Frame":
        """Mark a point of this body for strings; `faces` is the way in which one must leave, None for any way."""
        self._builder.add_site(self.address(name), self.name, add(self.at, at), faces)
        return self

    def hand(self, name: str, force: float) -> "Frame":
        """Mark a point at which a hand draws whatever string ends there with a constant force."""
        self.site(name)
        self._builder.hands[self.address(name)] = force
        return self

    def pulley(
        self,
        name: str,
        at: Vector = ZERO,
        mass: float = 0.0,
        radius: float = WHEEL_RADIUS,
        faces: Vector | None = None,
    ) -> Pulley:
        """Fix a pulley's axle to this body; a mass makes it a uniform disc that the string turns.

        Its two rim points lie `radius` to the left and right of the axle; strings leave them towards
        `faces`. Gluing it stops the wheel.
        """
        address, left, right = self.address(name), self.address(f"{name}.left"), self.address(f"{name}.right")
        self._builder.add_site(left, self.name, add(self.at, at, (-radius, 0.0, 0.0)), faces)
        self._builder.add_site(right, self.name, add(self.at, at, (radius, 0.0, 0.0)), faces)
        if mass == 0.0:
            return self._builder.add_pulley(address, Pulley(left, right, None, radius))
        self.body(name, mass, at=at, inertia=0.5 * mass * radius**2).hinge(Y)
        return self._builder.add_pulley(address, Pulley(left, right, f"{address}.hinge", radius))

    def string(self, name: str, *through: str | Pulley, slack: float = 0.0) -> None:
        """Stretch a string from end to end through sites, by address; a pulley stands for its rim, left to right."""
        self._builder.add_string(self.address(name), _flat(through), slack)

    def pull(self, name: str, *through: str | Pulley, force: float) -> None:
        """Like `string`, but its last stop is a hand that draws it in with a constant force."""
        self._builder.add_pull(self.address(name), _flat(through), force)

    def collide(self, a: "Frame", b: "Frame", distance: float, restitution: float) -> None:
        """Let two bodies bounce when their centres come within `distance`."""
        self._builder.add_collision(Collision(a.own_name, b.own_name, distance, restitution))

    @property
    def own_name(self) -> str:
        """The name of this body; ValueError for the room."""
        return self._own()

    def _own(self) -> str:
        if self.name is None:
            raise ValueError("the room itself neither moves nor collides")
        return self.name


def _flat(through: Iterable[str | Pulley]) -> list[str]:
    return [site for stop in through for site in ((stop,) if isinstance(stop, str) else (stop.left, stop.right))]


class Builder:
    """Collects what frames say; gluing, naming and the splitting of strings are settled here once."""

    def __init__(self, gravity: Vector = (0.0, 0.0, -GRAVITY), glued: Iterable[str] = ()) -> None:
        """`glued` names bodies that are welded to their parents whatever an entity says of them."""
        self._gravity = gravity
        self._glued = frozenset(glued)
        self._bodies: dict[str, Body] = {}
        self._origin: dict[str | None, Vector] = {None: ZERO}
        self._sites: dict[str, Site] = {}
        self.faces: dict[str, Vector | None] = {}  # by site, the way in which a string must leave it
        self.hands: dict[str, float] = {}  # by site, the force with which a string is drawn in there
        self._rims: dict[tuple[str, str], Pulley] = {}
        self._strings: dict[str, String] = {}
        self._pulls: dict[str, Pull] = {}
        self._collisions: list[Collision] = []

    def room(self, name: str = "", at: Vector = ZERO) -> Frame:
        """The room, for one entity: `name` goes before all its names, `at` is where it stands."""
        return Frame(self, name, None, at)

    @property
    def bodies(self) -> tuple[str, ...]:
        """The names of all bodies that were made."""
        return tuple(self._bodies)

    def position(self, site: str) -> Vector:
        """Where a site stands in the room at the start."""
        found = self._sites[site]
        return add(self._origin[found.body], found.at)

    def carrier(self, site: str) -> str | None:
        """The body that a site is on; None for the room."""
        return self._sites[site].body

    def extent(self) -> tuple[float, float]:
        """The least and greatest x of all sites and bodies."""
        across = [self.position(site)[0] for site in self._sites] + [at[0] for name, at in self._origin.items() if name]
        return (min(across), max(across)) if across else (0.0, 0.0)

    def relative(self, body: str | None, where: Vector) -> Vector:
        """A point of the room as seen from a body's centre of mass at the start."""
        return add(where, scale(-1.0, self._origin[body]))

    def add_body(self, body: Body) -> None:
        """Enter a body; its name must be new."""
        self._new(body.name, self._bodies)
        self._bodies[body.name] = body
        self._origin[body.name] = add(self._origin[body.parent], body.at)

    def add_coordinate(self, body: str, coordinate: Coordinate) -> None:
        """Give a body one more way to move, unless it is glued."""
        if body not in self._glued:
            found = self._bodies[body]
            self._bodies[body] = replace(found, coordinates=(*found.coordinates, coordinate))

    def add_contact(self, body: str, contact: Contact) -> None:
        """Say that a body lies on its parent, unless it is glued to it."""
        if body not in self._glued:
            self._bodies[body] = replace(self._bodies[body], contact=contact)

    def add_site(self, name: str, body: str | None, where: Vector, faces: Vector | None = None) -> None:
        """Mark a point of a body, given where it stands in the room at the start."""
        self._new(name, self._sites)
        self.faces[name] = faces
        self._sites[name] = Site(name, body, self.relative(body, where))

    def add_pulley(self, name: str, pulley: Pulley) -> Pulley:
        """Enter a pulley, so that strings that pass its rim points turn it, unless it is glued."""
        kept = replace(pulley, coordinate=None) if name in self._glued else pulley
        self._rims[pulley.left, pulley.right] = kept
        return kept

    def add_string(self, name: str, through: Iterable[str], slack: float) -> None:
        """Enter a string, in as many parts as massive pulleys cut it into."""
        parts = self._split(through)
        for number, (sites, wheels) in enumerate(parts, start=1):
            part = name if len(parts) == 1 else f"{name}/{number}"
            self._new(part, self._strings)
            self._strings[part] = String(part, name, sites, wheels, slack)

    def add_pull(self, name: str, through: Iterable[str], force: float) -> None:
        """Enter a pulled string: the part at the hand is a `Pull`, those behind massive pulleys are strings."""
        parts = self._split(through)
        for number, (sites, wheels) in enumerate(parts, start=1):
            part = name if len(parts) == 1 else f"{name}/{number}"
            self._new(part, (*self._strings, *self._pulls))
            if number < len(parts):
                self._strings[part] = String(part, name, sites, wheels)
            else:
                self._pulls[part] = Pull(part, sites, force, wheels)

    def _split(self, through: Iterable[str]) -> list[tuple[tuple[str, ...], tuple[Wheel, ...]]]:
        """Cut a path wherever it goes from one rim point of a massive pulley to the other."""
        parts: list[tuple[list[str], list[Wheel]]] = [([], [])]
        for site in through:
            if site not in self._sites:
                raise ValueError(f"no site is called {site!r}")
            sites, wheels = parts[-1]
            grip = self._grip(sites[-1], site) if sites else None
            if grip is None:
                sites.append(site)
            else:
                wheels.append(grip)
                parts.append(([site], [Wheel(grip.coordinate, -grip.radius)]))
        if any(len(sites) < 2 for sites, _ in parts):
            raise ValueError("a string needs two ends, and something between any two massive pulleys")
        return [(tuple(sites), tuple(wheels)) for sites, wheels in parts]

    def _grip(self, first: str, last: str) -> Wheel | None:
        """How a string that comes in at `first` and leaves at `last` turns a massive pulley, if it is one's rim."""
        pulley = self._rims.get((first, last)) or self._rims.get((last, first))
        if pulley is None or pulley.coordinate is None:
            return None
        # The wheel turns right-handed about y: its left rim rises and takes in string that hangs from it, but
        # gives out string that holds it from above.
        upwards = self.faces[first]
        under = upwards is not None and upwards[2] > 0.0
        return Wheel(pulley.coordinate, pulley.radius if (first == pulley.left) != under else -pulley.radius)

    def add_collision(self, collision: Collision) -> None:
        """Enter a pair that may bounce."""
        self._collisions.append(collision)

    def _new(self, name: str, known: Iterable[str]) -> None:
        if name in known:
            raise SceneError(name, "two things have this name", "give each body and string its own")

    def finish(self) -> Mechanism:
        """The mechanism of everything that was said."""
        return Mechanism(
            tuple(self._bodies.values()),
            tuple(self._sites.values()),
            tuple(self._strings.values()),
            tuple(self._pulls.values()),
            tuple(self._collisions),
            self._gravity,
        )
