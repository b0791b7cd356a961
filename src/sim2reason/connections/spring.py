"""A light spring between two points."""

from typing import ClassVar

from sim2reason.connections.parts.two_ended import TwoEnded
from sim2reason.dsl.builder import Builder
from sim2reason.dsl.connection import FREE, Joint, Look, connection
from sim2reason.dsl.measures import FreeLength, Stiffness
from sim2reason.dsl.ports import Attachment, Port
from sim2reason.dsl.template import Wordings, either


@connection
class Spring(TwoEnded):
    """A light spring, relaxed at the start, along the line of the two points that it joins."""

    key: ClassVar[str] = "spring"
    joins: ClassVar[type[Port]] = Attachment
    look: ClassVar[Look] = "spring"
    stiffness: Stiffness
    free: FreeLength = FREE

    says: ClassVar[Wordings] = either(
        "a light spring of stiffness {stiffness}, at first relaxed, joins {a} to {b}.",
        "{a} is joined to {b} by a light spring of stiffness {stiffness}, which is relaxed at first.",
        "between {a} and {b} runs a light spring of stiffness {stiffness}, relaxed at the start.",
    )

    @property
    def spacing(self) -> float:
        """Its natural length."""
        return self.free

    def build(self, joint: Joint, builder: Builder) -> None:
        """From site to site, as long as they are apart."""
        sites = [stop.sites[0] for stop in joint.stops]
        builder.add_spring(joint.name, sites, self.stiffness, None, 0.0)
