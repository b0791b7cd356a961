"""The methods by which entities build a mechanism: `Frame` is their interface, `Builder` collects the parts."""

from collections.abc import Iterable
from math import inf

from sim2reason.scenes.dsl.collector import WHEEL_RADIUS, Axes, Collector, Rim
from sim2reason.scenes.dsl.fields import Law
from sim2reason.scenes.dsl.mechanism import (
    NO_INERTIA,
    ZERO,
    Attraction,
    CollisionPair,
    ConstantTension,
    Coordinate,
    Elastic,
    Force,
    Inextensible,
    MassEjection,
    PlaneContact,
    Prop,
    Rigid,
    RigidBody,
    SurfaceContact,
    Y,
    Z,
)
from sim2reason.scenes.dsl.vectors import Region, Tensor, Vector, add, inner, outer, unit

__all__ = ["WHEEL_RADIUS", "Axes", "Builder", "Frame", "Rim"]


class Frame:
    """A body under construction, or the room, with the methods that build a mechanism.

    Everything that is made on a frame moves with it. Methods that add to the body return the frame, so that calls can
    be chained. Vectors are in the axes of the room at the start: x to the right, y away from the reader, z up; lengths
    are in m, masses in kg, angles in radians.

    Args:
        builder: Builder that collects the parts.
        prefix: Address that precedes all names made here.
        body: Address of the body; None for the room.
        at: Position of the frame in the room.
        origin: Position of the entity in the room; by default that of the frame.

    Attributes:
        prefix: Address that precedes all names made here.
        name: Address of the body; None for the room.
        at: Position of the frame in the room.
        origin: Position of the entity in the room.
        own_name: Address of the body; ValueError for the room.

    Examples:
        >>> from sim2reason.authoring import X, Z
        >>> from sim2reason.scenes.dsl.builder import Builder
        >>> builder = Builder()
        >>> builder.room("floor").body("block", 2.0).rest(X, Z, friction=0.2, speed=3.0)
        <Frame of 'floor.block' at (0.0, 0.0, 0.0)>
        >>> builder.finish()
        <Mechanism: 1 body, 1 coordinate, 1 face>
    """

    def __init__(
        self, builder: Collector, prefix: str, body: str | None, at: Vector, origin: Vector | None = None
    ) -> None:
        """Create a frame at `at` in the room, for the entity at `origin`; `prefix` precedes every name made here."""
        self._builder, self.prefix, self.name, self.at = builder, prefix, body, at
        self.origin = at if origin is None else origin

    def __repr__(self) -> str:
        """Return the name of the body, or that of the room, and the place in the room."""
        return f"<Frame of {'the room' if self.name is None else repr(self.name)} at {self.at}>"

    def address(self, name: str) -> str:
        """Return the full address of a name that is created here."""
        return f"{self.prefix}.{name}" if self.prefix else name

    def part(self, name: str, at: Vector = ZERO) -> "Frame":
        """Return a frame for a part of an entity: the same body, shifted by `at`, with `name` before all names."""
        return Frame(self._builder, self.address(name), self.name, add(self.at, at), self.origin)

    def body(
        self, name: str, mass: float = 0.0, *, at: Vector = ZERO, center: Vector = ZERO, inertia: Tensor = NO_INERTIA
    ) -> "Frame":
        """Add a body carried by this one, with its frame at `at`; it is fixed until a coordinate is added.

        The centre of mass, `center`, and the `inertia` about it are in the axes of the room at the start.
        """
        address, where = self.address(name), add(self.at, at)
        relative = self._builder.relative(self.name, where)
        self._builder.add_body(RigidBody(address, self.name, relative, mass, center, inertia))
        return Frame(self._builder, self.prefix, address, where, self.origin)

    def turned(self, axes: Axes) -> "Frame":
        """Set the initial directions of the axes of this body, for drawings only."""
        self._builder.turned[self._own()] = axes
        return self

    def slide(
        self,
        axis: Vector,
        speed: float = 0.0,
        limits: tuple[float, float] = (-inf, inf),
        name: str = "slide",
        stated: tuple[str, float] | None = None,
    ) -> "Frame":
        """Add a coordinate in m along `axis`, a vector of any length; the coordinate grows in its direction.

        `stated` is the label and initial value by which a text states a position.
        """
        own, direction = self._own(), unit(axis)
        self._builder.add_coordinate(Coordinate(f"{own}.{name}", own, name, "slide", direction, speed, *limits, stated))
        return self

    def hinge(
        self, axis: Vector, speed: float = 0.0, limits: tuple[float, float] = (-inf, inf), name: str = "hinge"
    ) -> "Frame":
        """Add a rotation about `axis` through the origin of the body's frame; limits in radians."""
        own = self._own()
        self._builder.add_coordinate(Coordinate(f"{own}.{name}", own, name, "hinge", unit(axis), speed, *limits))
        return self

    def rest(
        self,
        along: Vector,
        normal: Vector,
        friction: float = 0.0,
        speed: float = 0.0,
        limits: tuple[float, float] = (-inf, inf),
        name: str = "slide",
        static: float | None = None,
    ) -> "Frame":
        """Add a contact with a face of the parent on which the body can slide along `along`.

        Until the body slides, the face holds it by the coefficient `static`, by default equal to `friction`.
        """
        self.slide(along, speed, limits, name)
        slip = ((f"{self.name}.{name}", 1.0),)
        self._builder.add_face(
            SurfaceContact(self._own(), unit(normal), slip, friction, static_ratio=_ratio(static, friction))
        )
        return self

    def roll(
        self,
        along: Vector,
        normal: Vector,
        radius: float,
        friction: float = inf,
        speed: float = 0.0,
        spin: float | None = None,
        static: float | None = None,
    ) -> "Frame":
        """Add a contact of a round body with a face of its parent on which it can slide and roll.

        `spin`, rad/s, is positive in the sense of rolling along `along`; by default the body rolls at the start. With
        infinite `friction` it never slips; until it slips, the coefficient is `static`, by default that of `friction`.
        """
        own, direction, out = self._own(), unit(along), unit(normal)
        self.slide(direction, speed)
        self.hinge(outer(out, direction), speed / radius if spin is None else spin)
        slip = ((f"{own}.slide", 1.0), (f"{own}.hinge", -radius))
        self._builder.add_face(SurfaceContact(own, out, slip, friction, static_ratio=_ratio(static, friction)))
        return self

    def swing(
        self, axis: Vector, normal: Vector, radius: float, *, friction: float = 0.0, speed: float = 0.0, guided: bool
    ) -> "Frame":
        """Add a contact of a small body with a round face about the origin of its frame; `speed` in rad/s.

        Its centre of mass is at a distance `radius`, m, from there; `normal` points out of the face at the initial
        position. If `guided`, the body cannot leave the face, like a bead on a hoop.
        """
        own = self._own()
        self.hinge(axis, speed)
        slip = ((f"{own}.hinge", radius),)
        self._builder.add_face(SurfaceContact(own, unit(normal), slip, friction, turning=True, guided=guided))
        return self

    def site(self, name: str, at: Vector = ZERO, faces: Vector | None = None) -> "Frame":
        """Add a point of this body for strings, which leave it in the direction `faces`, or in any if that is None."""
        self._builder.add_site(self.address(name), self.name, add(self.at, at), faces)
        return self

    def hand(self, name: str, force: float) -> "Frame":
        """Add a point at which a hand pulls the string that ends there with a constant force, N."""
        self.site(name)
        self._builder.drawing[self.address(name)] = ConstantTension(force)
        return self

    def winch(self, name: str, speed: float) -> "Frame":
        """Add a point at which a winch pulls in the string that ends there at a constant speed, m/s, from t = 0 on."""
        self.site(name)
        self._builder.drawing[self.address(name)] = Inextensible(reel=speed)
        return self

    def pulley(
        self,
        name: str,
        at: Vector = ZERO,
        mass: float = 0.0,
        radius: float = WHEEL_RADIUS,
        faces: Vector | None = None,
    ) -> Rim:
        """Add a pulley with its axle fixed to this body; a mass makes it a uniform disc that the string rotates.

        Its two rim points are at `radius` to the left and right of the axle; strings leave them towards
        `faces`. A glued pulley is a smooth peg, over which strings slide; a fixed wheel also fixes its string.
        """
        address, left, right = self.address(name), self.address(f"{name}.left"), self.address(f"{name}.right")
        self._builder.add_site(left, self.name, add(self.at, at, (-radius, 0.0, 0.0)), faces)
        self._builder.add_site(right, self.name, add(self.at, at, (radius, 0.0, 0.0)), faces)
        if mass == 0.0:
            return self._builder.add_pulley(address, Rim(left, right, None, radius))
        self.body(name, mass, at=at, inertia=axial_inertia(0.5 * mass * radius**2)).hinge(Y)
        return self._builder.add_pulley(address, Rim(left, right, f"{address}.hinge", radius))

    def string(self, name: str, *through: str | Rim, slack: float = 0.0, reel: float = 0.0) -> None:
        """Add a string through sites by address, from end to end; a pulley stands for its rim, left to right.

        It has an initial `slack`, m, and is pulled in at `reel`, m/s.
        """
        self._builder.add_line(self.address(name), _flat(through), Inextensible(slack, reel))

    def pull(self, name: str, *through: str | Rim, force: float) -> None:
        """Add a string whose last stop is a hand that pulls it with a constant force, N."""
        self._builder.add_line(self.address(name), _flat(through), Inextensible(), last=ConstantTension(force))

    def rod(self, name: str, a: str, b: str) -> None:
        """Add a light rod that keeps the distance of two sites."""
        self._builder.add_line(self.address(name), (a, b), Rigid())

    def prop(self, name: str, a: str, b: str) -> None:
        """Add a strut that prevents two sites from coming nearer than at the start."""
        self._builder.add_line(self.address(name), (a, b), Prop())

    def spring(
        self, name: str, *through: str | Rim, stiffness: float, length: float | None = None, damping: float = 0.0
    ) -> None:
        """Add a light spring between sites; its natural length, m, is by default its initial length."""
        self._builder.add_spring(self.address(name), _flat(through), stiffness, length, damping)

    def wound(self, name: str, rim: str, end: str, across: float) -> None:
        """Add a string wound round the rim of this body down to the site `end`; the body rotates about y by its hinge.

        `rim` is a site of the room, `across`, m, to the right of the axle: a right-handed rotation takes in a string
        that hangs to the left. A glued body holds its string.
        """
        self._builder.add_wound(self.address(name), self._own(), (rim, end), -across)

    def wind(self, name: str, a: "Frame", b: "Frame", radius: float, arc: float, law: Elastic) -> None:
        """Add a light spring along the circle on which two bodies rotate, right-handed from `a` to `b`.

        Its initial length is the `arc` between them, m.
        """
        self._builder.add_arc(self.address(name), (a.own_name, b.own_name), radius, arc, law)

    def buffer(self, name: str, a: str, b: str, stiffness: float, length: float) -> None:
        """Add a light spring at site `a` that repels site `b` within its natural length, m."""
        self._builder.add_line(self.address(name), (a, b), Elastic(stiffness, length, acts="pushes"))

    def force(self, name: str, law: Law, region: Region | None = None) -> None:
        """Add a force on the centre of mass; the origin of its law and region is that of the entity."""
        here = None if region is None else region.moved(self.origin)
        self._builder.forces.append(Force(self.address(name), self._own(), law.moved(self.origin), here))

    def collide(self, a: "Frame", b: "Frame", distance: float, restitution: float, *, sticks: bool = False) -> None:
        """Let two bodies collide when the distance of their centres is `distance`, m."""
        self._builder.meetings.append(CollisionPair(a.own_name, b.own_name, distance, restitution, None, sticks))

    def bump(
        self, a: "Frame", b: "Frame", normal: Vector, distance: float, restitution: float, *, sticks: bool = False
    ) -> None:
        """Let two bodies collide when `b` is `distance`, m, ahead of `a` along `normal`; `a` may be the room."""
        away = a.name
        if away is None:
            distance += inner(normal, a.at)
        self._builder.meetings.append(CollisionPair(away, b.own_name, distance, restitution, unit(normal), sticks))

    def attract(self, other: "Frame", constant: float) -> None:
        """Let this body and another attract each other by Newton's law with a gravitational constant."""
        self._builder.attractions.append(Attraction(self._own(), other.own_name, constant))

    def burn(self, rate: float, exhaust: float, until: float, direction: Vector = Z) -> None:
        """Let this body eject mass at `rate`, kg/s, with exhaust speed `exhaust`, m/s, until a time, s."""
        self._builder.burns.append(MassEjection(self._own(), rate, exhaust, until, unit(direction)))

    def stand(self, name: str, at: Vector, along: Vector, normal: Vector, on: Vector | None = None) -> None:
        """Add a foot: a point of this body that may stand on a plane of the room.

        By default the plane goes through the initial foot; `on`, if given, is a point of it relative to the body's
        frame.
        """
        self.site(name, at)
        where = self._builder.position(self.address(name)) if on is None else add(self.at, on)
        self._builder.feet.append(
            PlaneContact(self.address(name), self.address(name), normal, along, inner(normal, where))
        )

    @property
    def own_name(self) -> str:
        """Return the address of this body; raise ValueError for the room."""
        return self._own()

    def _own(self) -> str:
        if self.name is None:
            raise ValueError("the room itself neither moves nor collides")
        return self.name


def _ratio(static: float | None, friction: float) -> float:
    """Return the ratio of static to kinetic friction; 1 if `static` is None or `friction` is 0 or infinite."""
    return 1.0 if static is None or not 0.0 < friction < inf else static / friction


def _flat(through: Iterable[str | Rim]) -> list[str]:
    return [site for stop in through for site in ((stop,) if isinstance(stop, str) else (stop.left, stop.right))]


def axial_inertia(inertia: float) -> Tensor:
    """Return the inertia tensor of a flat disc in the xz plane, whose axis is y.

    Args:
        inertia: Moment of inertia about the axis, kg m².

    Returns:
        The components xx, yy, zz, xy, xz and yz, kg m²; about a diameter it is half of `inertia`.

    Examples:
        >>> from sim2reason.authoring import axial_inertia
        >>> axial_inertia(0.4)
        (0.2, 0.4, 0.2, 0.0, 0.0, 0.0)
    """
    return (0.5 * inertia, inertia, 0.5 * inertia, 0.0, 0.0, 0.0)


class Builder(Collector):
    """A mechanism under construction."""

    def room(self, name: str = "", at: Vector = ZERO) -> Frame:
        """Return the frame of the room for one entity, with its names preceded by `name` and its origin at `at`."""
        self.origins[name] = at
        return Frame(self, name, None, at)

    def mount(self, name: str, site: str, *, stiff: bool) -> Frame:
        """Return the frame of the body that carries a site, for an entity mounted there; `stiff` if it is welded."""
        carrier, where = self.carrier(site), self.position(site)
        self.origins[name] = where
        if stiff:
            self.welded[name] = carrier
        return Frame(self, name, carrier, where)
