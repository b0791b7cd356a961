"""Scenes small enough to be solved on paper."""

from collections.abc import Sequence

from sim2reason.scenes.bodies.blocks import Block, Cart, Glider, Puck, Table
from sim2reason.scenes.bodies.oscillators import Ball, Coil, Cord
from sim2reason.scenes.bodies.round_bodies import Sphere, SphericalShell
from sim2reason.scenes.bodies.simple_machines import FixedPulley, Incline, MovablePulley, Plane, RoughTrack, Track
from sim2reason.scenes.connections.string import String
from sim2reason.scenes.dsl.connection import FREE_LENGTH, Link
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.pendulums import Pendulum, RotationEntity
from sim2reason.scenes.entities.pieces import RoundPiece
from sim2reason.scenes.entities.pulleys import MassWithFixedPulley, MassWithMovablePulley, MassWithReverseMovablePulley
from sim2reason.scenes.entities.rolling import NoSlipping, RollingEntity
from sim2reason.scenes.entities.slopes import TwoSideMassPlane
from sim2reason.scenes.entities.spring_chains import Blow, SpringMassChain, Strained
from sim2reason.scenes.entities.string_ends import FixedSupport, Hanging
from sim2reason.scenes.entities.track_collisions import ComplexCollisionPlane
from sim2reason.scenes.entities.two_d_collision_plane import TwoDCollisionPlane

G = 9.8


def ramp(mass: float = 2.0, angle: float = 30.0, friction: float = 0.0, speed: float | None = None) -> Scene:
    """Return a scene with a block on a plane."""
    plane = Plane(angle=angle, friction=friction)
    entity = TwoSideMassPlane(plane=plane, blocks=(Block(mass=mass),), speed=speed)
    return Scene(entities=(Named(name="ramp", entity=entity),))


def atwood(left: float = 3.0, right: float = 2.0) -> Scene:
    """Return a scene with two hanging blocks on a string over light fixed pulleys."""
    return _over_pulleys((left, right), (None, None))


def massive(mass: float) -> Scene:
    """Return a scene with blocks of 3 kg and 2 kg on a string over a uniform disc of some mass and a light pulley."""
    return _over_pulleys((3.0, 2.0), (mass, None))


def _over_pulleys(blocks: tuple[float, float], pulleys: tuple[float | None, float | None]) -> Scene:
    ends = tuple(_hanging(name, *sizes) for name, *sizes in zip(("one", "other"), blocks, pulleys, strict=True))
    return _joined(*ends)


def half_atwood() -> Scene:
    """Return a scene with a block of 2 kg on a smooth slope of 30°, and one of 3 kg hanging from a string to it."""
    entity = TwoSideMassPlane(plane=Plane(angle=30.0, friction=0.0), blocks=(Block(mass=2.0),))
    return _joined(Named(name="ramp", entity=entity), _hanging("other", 3.0, None))


def drawn_shell() -> Scene:
    """Return a scene with a rolling spherical shell drawn up a slope of 30° by a block, to a pulley 2.8 m away."""
    shell = SphericalShell(mass=1.1, radius=0.36)
    rolls = Named(name="roll", entity=RollingEntity(body=shell, plane=Incline(angle=30.0), grip=NoSlipping()))
    return _joined(rolls, _hanging("other", 0.95, None), free=2.8)


def bight(mass: float, load: float, disc: float | None = None) -> Scene:
    """Return a scene with a block on a string over a fixed pulley, under a movable one with a load, to a hook."""
    pulley = MovablePulley() if disc is None else MovablePulley(mass=disc)
    loaded = Named(name="loaded", entity=MassWithReverseMovablePulley(pulley=pulley, load=Block(mass=load)))
    hook = Named(name="hook", entity=FixedSupport())
    links = (("one", "tail"), ("loaded", "under"), ("hook", "end"))
    string = String(links=tuple(Link(entity=entity, port=port) for entity, port in links))
    return Scene(entities=(_hanging("one", mass, None), loaded, hook), connections=(string,))


def nested_atwood(mass: float, left: float, right: float) -> Scene:
    """Return a scene with a block on a string to the axle of a movable pulley, over which two more blocks hang."""
    ends = [Hanging(blocks=(Block(mass=held),)) for held in (left, right)]
    carried = MassWithMovablePulley(left=ends[0], right=ends[1], pulley=MovablePulley())
    string = String(links=(Link(entity="one", port="tail"), Link(entity="two", port="top")))
    return Scene(entities=(_hanging("one", mass, None), Named(name="two", entity=carried)), connections=(string,))


def _hanging(name: str, mass: float, pulley: float | None) -> Named:
    disc = FixedPulley() if pulley is None else FixedPulley(mass=pulley)
    return Named(name=name, entity=MassWithFixedPulley(system=Hanging(blocks=(Block(mass=mass),)), pulley=disc))


def _joined(one: Named, other: Named, free: float = FREE_LENGTH) -> Scene:
    links = (
        Link(entity=one.name, port={"ramp": "right", "roll": "axle"}.get(one.name, "tail")),
        Link(entity=other.name, port="tail"),
    )
    return Scene(entities=(one, other), connections=(String(links=links, free=free),))


def table(restitution: float = 0.5, speed: float = 2.0, tilt: float = 0.0) -> Scene:
    """Return a scene with a puck that collides head on with one twice as heavy, after (1 − 0.2) m."""
    pucks = (Puck(mass=1.0, x=0.0, y=0.0, vx=speed, vy=0.0), Puck(mass=2.0, x=1.0, y=0.0, vx=0.0, vy=0.0))
    entity = TwoDCollisionPlane(table=Table(angle=tilt), radius=0.1, pucks=pucks, restitution=restitution)
    return Scene(entities=(Named(name="table", entity=entity),))


def three() -> Scene:
    """Return a scene with a puck that hits another off centre, which then hits a third."""
    places = ((1.0, 0.0, 0.0, 2.0), (2.0, 1.0, 0.05, 0.0), (1.5, 1.8, 0.3, -0.2))
    pucks = tuple(Puck(mass=m, x=x, y=y, vx=vx, vy=0.0) for m, x, y, vx in places)
    entity = TwoDCollisionPlane(table=Table(), radius=0.1, pucks=pucks, restitution=0.6)
    return Scene(entities=(Named(name="table", entity=entity),))


def squeezed(heavy: float = 4.0, restitution: float = 1.0) -> Scene:
    """Return a scene with a cart of 1 kg at rest between a heavy one, arriving from the left at 1 m/s, and a wall."""
    carts = (Glider(mass=heavy, x=0.0, v=1.0), Glider(mass=1.0, x=1.0, v=0.0))
    entity = ComplexCollisionPlane(track=Track(), gliders=carts, right=2.0, restitution=restitution)
    return Scene(entities=(Named(name="track", entity=entity),))


def swing(angle: float = 60.0) -> Scene:
    """Return a scene with a ball of 0.5 kg on a string of 0.8 m, released from rest."""
    entity = Pendulum(bob=Ball(mass=0.5), hanger=Cord(length=0.8), angle=angle)
    return Scene(entities=(Named(name="swing", entity=entity),))


def arm(angle: float = 60.0, rate: float | None = None) -> Scene:
    """Return a scene with a sphere of 2 kg and 0.2 m on a light arm, its centre 0.9 m from the axle."""
    piece = RoundPiece(body=Sphere(mass=2.0, radius=0.2), distance=0.9)
    return Scene(entities=(Named(name="arm", entity=RotationEntity(pieces=(piece,), angle=angle, rate=rate)),))


def row(
    masses: Sequence[float],
    stiffnesses: Sequence[float],
    ends: str,
    *,
    strain: float = 0.0,
    at: int = 0,
    speed: float = 0.0,
    tilt: float = 0.0,
    friction: float = 0.0,
) -> Scene:
    """Return a row of carts; spring `at` is stretched by `strain`, and the last cart moves to the right."""
    by_how_much = Strained(spring=at, by=strain) if strain else Strained()
    blow = Blow(cart=len(masses) - 1, toward="right", speed=speed) if speed else None
    chain = SpringMassChain(
        track=RoughTrack(angle=tilt, friction=friction),
        carts=tuple(Cart(mass=mass) for mass in masses),
        ends=ends,  # type: ignore[arg-type]
        springs=tuple(Coil(stiffness=stiffness) for stiffness in stiffnesses),
        strain=by_how_much,
        blow=blow,
    )
    return Scene(entities=(Named(name="row", entity=chain),))
