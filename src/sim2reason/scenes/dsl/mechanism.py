"""The engine-independent model of a scene: bodies, lines, faces, forces and collision pairs.

At the start of the motion the axes of every body's frame are those of the room: x to the right, y away from the
reader, z up. All numbers are in one coherent system of units, SI unless `units` says otherwise, angles in radians.
"""

from math import inf
from typing import ClassVar, Literal

from sim2reason.base.records import Memo, cached_property, format_count, record
from sim2reason.scenes.dsl.fields import Law
from sim2reason.scenes.dsl.units import SI, UnitSystem
from sim2reason.scenes.dsl.vectors import Region, Tensor, Vector

X: Vector = (1.0, 0.0, 0.0)
Y: Vector = (0.0, 1.0, 0.0)
Z: Vector = (0.0, 0.0, 1.0)
ZERO: Vector = (0.0, 0.0, 0.0)
NO_INERTIA: Tensor = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
GRAVITY = 9.8


@record(slots=True)
class Coordinate:
    """A generalized coordinate of a body relative to its parent, zero at the start of the motion."""

    name: str
    body: str
    label: str  # distinguishes the coordinates of a body: slide, hinge, x
    kind: Literal["slide", "hinge"]
    axis: Vector  # unit vector in the parent's frame; a hinge rotates right-handed about it
    speed: float = 0.0  # at the start: m/s, or rad/s for a hinge
    lower: float = -inf  # travel limits; reaching one ends the motion
    upper: float = inf
    stated: tuple[str, float] | None = None  # the axis of the text along this coordinate, and the initial value


@record(slots=True)
class RigidBody:
    """A rigid body in the frame of its parent. Mass 0 means massless.

    Its coordinates act one after the other: slides move the frame's origin, hinges turn about axes through it.
    """

    name: str
    parent: str | None  # None: the room
    at: Vector  # origin of its frame in the parent's frame at the start
    mass: float = 0.0
    center: Vector = ZERO  # centre of mass, in its own frame
    inertia: Tensor = NO_INERTIA  # about its centre of mass, in its own frame, kg m²
    coordinates: tuple[Coordinate, ...] = ()  # none: welded to the parent


@record(slots=True)
class SurfaceContact:
    """A contact of a body with a face of its parent, along which it may slide or roll.

    The velocity with which the two surfaces slip is Σ factor · rate over `slip`; friction acts against it.
    """

    subject: str  # the body that lies on its parent
    normal: Vector  # unit vector, out of the face; in the parent's frame, or in the body's own if it is `turning`
    slip: tuple[tuple[str, float], ...]  # (coordinate, factor)
    friction: float = 0.0  # coefficient of kinetic friction; infinite: it never slips
    turning: bool = False  # the face is curved: its normal turns with the body
    guided: bool = False  # the face holds the body in both directions, so that the normal force may have either sign
    static_ratio: float = 1.0  # ratio of the coefficients of static and kinetic friction, at least 1

    @property
    def static_friction(self) -> float:
        """Return the coefficient of static friction, which bounds the friction while a body does not slip."""
        return self.friction * self.static_ratio


@record(slots=True)
class Site:
    """A point fixed on a body, or in the room."""

    name: str
    body: str | None
    at: Vector  # in the body's frame


@record(slots=True)
class WheelCoupling:
    """The rotation of a massive pulley by a line, whose free length changes by `radius` times the angle."""

    coordinate: str
    radius: float  # signed, in metres


@record(slots=True)
class Inextensible:
    """The law of a string: its length is at most the initial one + `slack` − `reel`·t; it pulls or is slack."""

    row: ClassVar[str] = "string"  # kind of the constraint row; empty for a law that gives a force

    slack: float = 0.0  # m, initial slack
    reel: float = 0.0  # m/s at which it is pulled in


@record(slots=True)
class Rigid:
    """The law of a light rod: its length never changes; it pulls or pushes."""

    row: ClassVar[str] = "rod"


@record(slots=True)
class Prop:
    """The law of a light strut: its length is at least the initial one; it pushes or is idle."""

    row: ClassVar[str] = "prop"


@record(slots=True)
class Elastic:
    """The law of a light spring: its tension is stiffness·(length − natural length) + damping·rate.

    One that only pushes is a buffer, which bodies may leave; one that only pulls is an elastic cord, which may go
    slack.
    """

    row: ClassVar[str] = ""

    stiffness: float  # N/m
    length: float  # natural, m
    damping: float = 0.0  # N s/m
    acts: Literal["both", "pushes", "pulls"] = "both"

    @property
    def side(self) -> float:
        """Return the sign of the extension at which the spring acts; 0 for both."""
        return {"both": 0.0, "pushes": -1.0, "pulls": 1.0}[self.acts]


@record(slots=True)
class ConstantTension:
    """The law of a string pulled with a constant force, its tension."""

    row: ClassVar[str] = ""

    force: float  # N, at least 0


LineLaw = Inextensible | Rigid | Prop | Elastic | ConstantTension


@record(slots=True)
class Line:
    """A light line of one tension, straight between its sites.

    Its length is the sum of the distances between consecutive sites + Σ radius·angle over its wheels. A line that
    passes a massive pulley is several of these, one for each part, all with the same `whole`. One along a circle joins
    two bodies that turn about its centre: they are its wheels, and its fixed sites have its initial length as distance.
    """

    name: str
    whole: str
    through: tuple[str, ...]  # site names, from end to end
    wheels: tuple[WheelCoupling, ...] = ()
    law: LineLaw = Inextensible()
    circle: tuple[str, str] | None = None  # the bodies joined by a line along a circle, counter-clockwise


@record(slots=True)
class Force:
    """A force on a body at its centre of mass by a law, in a region or everywhere."""

    name: str
    body: str
    law: Law
    region: Region | None = None


@record(slots=True)
class Attraction:
    """A pair of bodies that attract each other with `constant`·m·m′/rᵖ between their centres of mass."""

    a: str
    b: str
    constant: float  # gravitational constant
    power: float = 2.0


@record(slots=True)
class MassEjection:
    """The ejection of mass by a body: thrust rate·exhaust along `direction` until a time."""

    body: str
    rate: float  # kg/s
    exhaust: float  # m/s, relative to the body
    until: float  # s
    direction: Vector = Z


@record(slots=True)
class PlaneContact:
    """A point of a body that may stand on a plane of the room, without penetration or slip."""

    name: str
    site: str
    normal: Vector
    along: Vector
    height: float  # of the plane: n·r of its points


@record(slots=True)
class CollisionPair:
    """A pair of bodies that collide: at centre distance `distance`, along `normal` if it is given."""

    a: str | None  # None: the room, at its origin
    b: str
    distance: float  # m
    restitution: float  # ratio of normal relative speeds, 0 to 1
    normal: Vector | None = None  # of flat faces: the gap is n·(b − a) − distance
    sticks: bool = False  # whether they stay together after the collision

    @property
    def names(self) -> tuple[str, ...]:
        """Return the names of the two bodies, without the room."""
        return (self.b,) if self.a is None else (self.a, self.b)


@record()
class Mechanism(Memo):
    """The engine-independent model of a scene: bodies, lines, contacts and forces with all numbers.

    All numbers are in the coherent units `units`, the SI by default; angles are in radians. At the start the axes of
    all frames are those of the room: x to the right, y away from the reader, z up.

    Attributes:
        bodies: Rigid bodies; a parent comes before its children.
        sites: Points fixed on bodies or in the room.
        lines: Parts of strings, rods and springs.
        faces: Faces on which bodies slide or roll.
        feet: Points that may stand on a plane of the room.
        forces: Forces on bodies by a law of place, velocity and time.
        attractions: Pairs of bodies that attract each other.
        burns: Bodies that eject mass.
        meetings: Pairs of bodies that may collide.
        gravity: Acceleration due to gravity, a vector.
        units: System of units.
        coordinates: All coordinates, body by body: the order of q, v and a in every engine and trace.
        number: Index of each coordinate, by name.
        body: Bodies by name.
        site: Sites by name.
        line: Lines by name.
        routes: Names of the sites through which each line runs.
        constraints: Lines that give equations rather than forces.
        strings: Lines that are inextensible and may go slack.
        pulls: Lines that are drawn in with a constant tension.
        half_springs: Springs that only push or only pull, each with its law.
        face_number: Index of each face, by the name of the body on it.
        contacts: Faces by the name of the body on them.

    Examples:
        >>> import sim2reason
        >>> scene = sim2reason.parse_scene("A 2 kg block is released from rest on a frictionless 30-degree incline.")
        >>> mechanism = scene.scene.mechanism
        >>> mechanism
        <Mechanism: 1 body, 1 coordinate, 1 face>
        >>> [coordinate.name for coordinate in mechanism.coordinates]
        ['e1.blocks.0.slide']
    """

    bodies: tuple[RigidBody, ...]
    sites: tuple[Site, ...] = ()
    lines: tuple[Line, ...] = ()
    faces: tuple[SurfaceContact, ...] = ()
    feet: tuple[PlaneContact, ...] = ()
    forces: tuple[Force, ...] = ()
    attractions: tuple[Attraction, ...] = ()
    burns: tuple[MassEjection, ...] = ()
    meetings: tuple[CollisionPair, ...] = ()
    gravity: Vector = (0.0, 0.0, -GRAVITY)
    units: UnitSystem = SI

    def __repr__(self) -> str:
        """Return the numbers of bodies, coordinates, lines and so on; kinds without members are left out."""
        numbers = [format_count(len(self.bodies), "body", "bodies"), format_count(len(self.coordinates), "coordinate")]
        for noun in ("line", "face", "force", "attraction", "burn", "meeting"):
            number = len(getattr(self, f"{noun}s"))
            numbers.extend([format_count(number, noun)] if number else [])
        return f"<Mechanism: {', '.join(numbers)}>"

    def __str__(self) -> str:
        """Return the line of `repr` and a line for each body: its mass, its parent and its coordinates."""
        lines = [repr(self)[1:-1]]
        for body in self.bodies:
            parent = body.parent or "the room"
            moves = ", ".join(coordinate.label for coordinate in body.coordinates) or "fixed"
            lines.append(f"  {body.name}: {body.mass:g} {self.units.mass}, carried by {parent}, {moves}")
        return "\n".join(lines)

    @cached_property
    def coordinates(self) -> tuple[Coordinate, ...]:
        """Return all coordinates, body by body: the order of q, v and a in every engine and trace."""
        return tuple(c for body in self.bodies for c in body.coordinates)

    @cached_property
    def number(self) -> dict[str, int]:
        """Return the index of each coordinate, by name."""
        return {coordinate.name: number for number, coordinate in enumerate(self.coordinates)}

    @cached_property
    def body(self) -> dict[str, RigidBody]:
        """Return the bodies by name."""
        return {body.name: body for body in self.bodies}

    @cached_property
    def site(self) -> dict[str, Site]:
        """Return the sites by name."""
        return {site.name: site for site in self.sites}

    @cached_property
    def line(self) -> dict[str, Line]:
        """Return the lines by name."""
        return {line.name: line for line in self.lines}

    @cached_property
    def routes(self) -> tuple[tuple[str, ...], ...]:
        """Return the names of the sites through which each line runs."""
        return tuple(line.through for line in self.lines)

    @cached_property
    def constraints(self) -> tuple[Line, ...]:
        """Return the lines that give constraint equations rather than forces."""
        return tuple(line for line in self.lines if line.law.row)

    @cached_property
    def strings(self) -> tuple[Line, ...]:
        """Return the lines that are inextensible and may go slack."""
        return tuple(line for line in self.lines if isinstance(line.law, Inextensible))

    @cached_property
    def pulls(self) -> tuple[Line, ...]:
        """Return the lines that are pulled with a constant tension."""
        return tuple(line for line in self.lines if isinstance(line.law, ConstantTension))

    @cached_property
    def half_springs(self) -> tuple[tuple[Line, Elastic], ...]:
        """Return the springs that only push or only pull, each with its law."""
        return tuple((line, line.law) for line in self.lines if isinstance(line.law, Elastic) and line.law.side)

    @cached_property
    def face_number(self) -> dict[str, int]:
        """Return the index of each face, by the name of the body on it."""
        return {face.subject: number for number, face in enumerate(self.faces)}

    @cached_property
    def contacts(self) -> dict[str, SurfaceContact]:
        """Return the faces by the name of the body on them."""
        return {face.subject: face for face in self.faces}
