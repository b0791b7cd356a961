"""Entity of a sledge that a horse draws over level snow."""

from typing import Annotated

from sim2reason.authoring import (
    Block,
    End,
    Entity,
    Force,
    Frame,
    Friction,
    Profile,
    Push,
    Range,
    X,
    Z,
    either,
    entity,
    scale,
)


@entity
class HorseAndSledge(Entity):
    """A loaded sledge, a block, that a steady force draws over rough snow to the right."""

    load: Block
    draught: Annotated[Force, Range(10.0, 40.0)]
    friction: Annotated[Friction, Range(0.02, 0.08)]

    says = (
        either(
            "a horse draws {load} to the right over level snow with a horizontal force of {draught}.",
            "with a horizontal force of {draught} a horse draws {load} to the right over level snow.",
            "over level snow {load} is drawn to the right by a horse, with a horizontal force of {draught}.",
        ),
        either(
            "the coefficient of friction on snow, static and kinetic, is {friction}.",
            "on snow the coefficient of friction, static and kinetic, is {friction}.",
            "for {load} on snow the coefficient of friction, static and kinetic, is {friction}.",
        ),
    )
    tow = End(
        sites=("ring",),
        tied="the rear of {load}",
        leaves="runs level to the left",
        arrives="reaches the rear of {load} from the left, level",
    )

    def build(self, room: Frame) -> None:
        """Build a body on level ground and the horse's force."""
        load = room.body("load", self.load.mass).rest(X, Z, self.friction)
        load.force("draught", Push(X, Profile(self.draught)))
        load.site("ring", faces=scale(-1.0, X))
