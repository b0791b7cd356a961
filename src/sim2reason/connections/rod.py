"""A light rigid rod between two points."""

from typing import ClassVar

from sim2reason.connections.parts.two_ended import TwoEnded
from sim2reason.dsl.builder import Builder
from sim2reason.dsl.connection import FREE, Joint, Look, connection
from sim2reason.dsl.measures import FreeLength
from sim2reason.dsl.mechanism import Rigid
from sim2reason.dsl.ports import Attachment, Port
from sim2reason.dsl.template import Wordings, either


@connection
class Rod(TwoEnded):
    """A light rigid rod, hinged at both ends, along the line of the two points that it joins."""

    key: ClassVar[str] = "rod"
    joins: ClassVar[type[Port]] = Attachment
    look: ClassVar[Look] = "rod"
    free: FreeLength = FREE

    says: ClassVar[Wordings] = either(
        "a light rigid rod, hinged at both ends, joins {a} to {b}.",
        "{a} is joined to {b} by a light rigid rod that is hinged at both ends.",
        "between {a} and {b} runs a light rigid rod, hinged at both ends.",
    )

    @property
    def spacing(self) -> float:
        """Its length."""
        return self.free

    def build(self, joint: Joint, builder: Builder) -> None:
        """From site to site; it pulls or pushes."""
        builder.add_line(joint.name, [stop.sites[0] for stop in joint.stops], Rigid())
