"""A pivot: one entity hangs from a point of another and can turn there."""

from typing import ClassVar

from sim2reason.scenes.connections.parts.two_ended import TwoEnded
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.connection import Joint, Look, connection
from sim2reason.scenes.dsl.ports import Base, Mount, Port, SitePort
from sim2reason.scenes.dsl.template import Wordings, either


class Carried(TwoEnded):
    """What joins the base of one entity to a mount of another, which carries it from then on."""

    joins: ClassVar[type[Port]] = SitePort
    look: ClassVar[Look] = "pivot"
    carries: ClassVar[bool] = True

    @classmethod
    def admits(cls, port: Port, index: int, last: int) -> bool:
        """First what carries, then what is carried."""
        return isinstance(port, Base if index == last else Mount)

    def build(self, joint: Joint, builder: Builder) -> None:
        """Nothing: what is carried was built on what carries it."""
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
