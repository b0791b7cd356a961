"""Rigid connections of entities: pivots, welds and light rods."""

from typing import ClassVar

from sim2reason.scenes.connections.parts.straight import Straight
from sim2reason.scenes.connections.parts.two_ended import TwoEnded
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.connection import Joint, Look, connection
from sim2reason.scenes.dsl.mechanism import Rigid
from sim2reason.scenes.dsl.ports import Base, Mount, Port, SitePort
from sim2reason.scenes.dsl.template import Wordings, either


class Carried(TwoEnded):
    """Base class of connections that mount the base of one entity on a mount of another, its carrier."""

    joins: ClassVar[type[Port]] = SitePort
    look: ClassVar[Look] = "pivot"
    carries: ClassVar[bool] = True

    @classmethod
    def admits(cls, port: Port, index: int, last: int) -> bool:
        """Return whether a port fits: a mount at the carrier's end, a base at the other end."""
        return isinstance(port, Base if index == last else Mount)

    def build(self, joint: Joint, builder: Builder) -> None:
        """Build nothing, since the carried entity was built on its carrier."""
        del joint, builder


@connection
class Pivot(Carried):
    """A frictionless axle between a point of one entity and the base of another."""

    key: ClassVar[str] = "pivot"

    says: ClassVar[Wordings] = either(
        "{b} turns without friction about an axle on {a}.",
        "{b} is attached to {a} by a frictionless axle.",
        "a frictionless axle joins {b} to {a}.",
    )


@connection
class Weld(Carried):
    """A rigid joint between a point of one entity and the base of another."""

    key: ClassVar[str] = "weld"
    stiff: ClassVar[bool] = True
    look: ClassVar[Look] = "weld"

    says: ClassVar[Wordings] = either(
        "{b} is fixed rigidly to {a}.",
        "{b} is welded to {a}.",
        "a rigid joint holds {b} fast to {a}.",
    )


@connection
class Rod(Straight):
    """A light rigid rod, hinged at both ends, along the line of the two points that it joins."""

    key: ClassVar[str] = "rod"
    look: ClassVar[Look] = "rod"

    says: ClassVar[Wordings] = either(
        "a light rigid rod, hinged at both ends, joins {a} to {b}.",
        "{a} is joined to {b} by a light rigid rod that is hinged at both ends.",
        "between {a} and {b} runs a light rigid rod, hinged at both ends.",
    )
    leads: ClassVar[Wordings] = either(
        "from {a} a light rigid rod, hinged at both ends, {way} to {b}.",
        "a light rigid rod is hinged to {a} and {way} to {b}, to which it is hinged as well.",
        "a light rigid rod, hinged to {a}, {way} to {b} and is hinged there, too.",
    )

    def build(self, joint: Joint, builder: Builder) -> None:
        """Add a rigid line from site to site, which pulls or pushes."""
        builder.add_line(joint.name, self.ends(joint, builder), Rigid())
