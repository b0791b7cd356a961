"""Scenes small enough to be solved on paper."""

from sim2reason.bodies.block import Block
from sim2reason.bodies.plane import Plane
from sim2reason.bodies.puck import Puck, Table
from sim2reason.bodies.pulley import FixedPulley
from sim2reason.dsl.connection import CONNECTIONS, Link
from sim2reason.dsl.entity import Named
from sim2reason.dsl.scene import Scene
from sim2reason.entities.mass_with_fixed_pulley import MassWithFixedPulley
from sim2reason.entities.parts.mass_systems import Hanging
from sim2reason.entities.two_d_collision_plane import TwoDCollisionPlane
from sim2reason.entities.two_side_mass_plane import TwoSideMassPlane

G = 9.8


def ramp(mass: float = 2.0, angle: float = 30.0, friction: float = 0.0, speed: float | None = None) -> Scene:
    """A block on a plane."""
    plane = Plane(angle=angle, friction=friction)
    entity = TwoSideMassPlane(plane=plane, blocks=(Block(mass=mass),), speed=speed)
    return Scene(entities=(Named(name="ramp", entity=entity),))


def atwood(left: float = 3.0, right: float = 2.0) -> Scene:
    """Two hanging blocks on a string over light fixed pulleys."""
    ends = tuple(
        Named(name=name, entity=MassWithFixedPulley(system=Hanging(blocks=(Block(mass=mass),)), pulley=FixedPulley()))
        for name, mass in (("one", left), ("other", right))
    )
    links = tuple(Link(entity=end.name, port="tail") for end in ends)
    return Scene(entities=ends, connections=(CONNECTIONS["tendon"](links=links),))


def table(restitution: float = 0.5, speed: float = 2.0, tilt: float = 0.0) -> Scene:
    """A puck that meets one twice as heavy, head on, after (1 − 0.2) m."""
    pucks = (Puck(mass=1.0, x=0.0, y=0.0, vx=speed, vy=0.0), Puck(mass=2.0, x=1.0, y=0.0, vx=0.0, vy=0.0))
    entity = TwoDCollisionPlane(table=Table(tilt=tilt), radius=0.1, pucks=pucks, restitution=restitution)
    return Scene(entities=(Named(name="table", entity=entity),))
