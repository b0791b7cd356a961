"""Entities for tests of drawings: a carriage with ports of all kinds, and a pendulum that it can carry."""

from math import cos, radians, sin

from sim2reason.scenes.bodies.blocks import Block
from sim2reason.scenes.bodies.oscillators import Ball, LightRod
from sim2reason.scenes.dsl.builder import Frame
from sim2reason.scenes.dsl.connection import Connection
from sim2reason.scenes.dsl.entity import Entity, Named
from sim2reason.scenes.dsl.mechanism import X, Y
from sim2reason.scenes.dsl.ports import Base, End, Mount
from sim2reason.scenes.dsl.scene import Scene

LEANING = radians(30.0)


class Slider(Entity):
    """A carriage on a rail."""

    carriage: Block

    says = ("{carriage} slides on a smooth horizontal rail.",)
    left = End(sites=("left",), tied="{carriage}", leaves="runs to the left", arrives="reaches {carriage} on the left")
    right = End(sites=("right",), tied="{carriage}", leaves="runs to the right", arrives="reaches {carriage}")
    pivot = Mount(sites=("pin",), place="{carriage}")

    def build(self, room: Frame) -> None:
        """Build one slide."""
        carriage = room.body("carriage", self.carriage.mass).slide(X)
        carriage.site("left", faces=(-1.0, 0.0, 0.0)).site("right", faces=X).site("pin")


class RodPendulum(Entity):
    """A bob on a rod that something carries."""

    bob: Ball
    rod: LightRod

    says = ("{bob} is at the end of {rod}.",)
    top = Base(held="{bob}")

    def build(self, room: Frame) -> None:
        """Build one hinge about y."""
        length = self.rod.length
        room.body("bob", self.bob.mass, center=(length * sin(LEANING), 0.0, -length * cos(LEANING))).hinge(Y)


def scene_of(*connections: Connection, **entities: Entity) -> Scene:
    """Return a scene of entities by name."""
    named = tuple(Named(name=name, entity=entity) for name, entity in entities.items())
    return Scene(entities=named, connections=connections)
