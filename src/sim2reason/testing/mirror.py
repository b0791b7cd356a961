"""The mirror image of a mechanism: left and right exchanged, x → −x."""

from dataclasses import dataclass, replace

from sim2reason.scenes.dsl.fields import Law
from sim2reason.scenes.dsl.mechanism import Coordinate, Mechanism, RigidBody
from sim2reason.scenes.dsl.vectors import Maths, Number, Region, Triple, Vector


def polar(vector: Triple) -> Triple:
    """Return the image of a place, a velocity, a force or a direction."""
    return (-vector[0], vector[1], vector[2])


def axial(vector: Vector) -> Vector:
    """Return the image of an axis of turning: in a mirror, what is right-handed about it turns left-handed."""
    return (vector[0], -vector[1], -vector[2])


@dataclass(frozen=True, slots=True)
class MirroredLaw:
    """The image of a law of force, whatever it is: the law is asked on the other side of the mirror."""

    law: Law

    def force(self, place: Triple, velocity: Triple, time: Number, maths: Maths) -> Triple:
        """Return the image of the force at the image of the place."""
        return polar(self.law.force(polar(place), polar(velocity), time, maths))

    def potential(self, place: Triple, maths: Maths) -> Number | None:
        """Return the potential at the image of the place."""
        return self.law.potential(polar(place), maths)

    @property
    def constant(self) -> bool:
        """As the law."""
        return self.law.constant

    def moved(self, by: Vector) -> "MirroredLaw":
        """About another origin."""
        return MirroredLaw(self.law.moved(polar(by)))


@dataclass(frozen=True, slots=True)
class MirroredRegion:
    """The image of a region."""

    region: Region

    def margins(self, place: Triple, maths: Maths) -> tuple[Number, ...]:
        """Return those of the image of the place."""
        return self.region.margins(polar(place), maths)

    def moved(self, by: Vector) -> "MirroredRegion":
        """Elsewhere."""
        return MirroredRegion(self.region.moved(polar(by)))


def mirrored(mechanism: Mechanism) -> Mechanism:
    """Return the mirror image: each of its coordinates goes as that of the mechanism does."""
    return replace(
        mechanism,
        bodies=tuple(map(_body, mechanism.bodies)),
        sites=tuple(replace(site, at=polar(site.at)) for site in mechanism.sites),
        faces=tuple(replace(face, normal=polar(face.normal)) for face in mechanism.faces),
        feet=tuple(replace(foot, normal=polar(foot.normal), along=polar(foot.along)) for foot in mechanism.feet),
        forces=tuple(
            replace(
                force,
                law=MirroredLaw(force.law),
                region=None if force.region is None else MirroredRegion(force.region),
            )
            for force in mechanism.forces
        ),
        burns=tuple(replace(burn, direction=polar(burn.direction)) for burn in mechanism.burns),
        meetings=tuple(
            replace(hit, normal=None if hit.normal is None else polar(hit.normal)) for hit in mechanism.meetings
        ),
        gravity=polar(mechanism.gravity),
    )


def _body(body: RigidBody) -> RigidBody:
    xx, yy, zz, xy, xz, yz = body.inertia
    return replace(
        body,
        at=polar(body.at),
        center=polar(body.center),
        inertia=(xx, yy, zz, -xy, -xz, yz),
        coordinates=tuple(map(_coordinate, body.coordinates)),
    )


def _coordinate(coordinate: Coordinate) -> Coordinate:
    axis = polar(coordinate.axis) if coordinate.kind == "slide" else axial(coordinate.axis)
    return replace(coordinate, axis=axis)
