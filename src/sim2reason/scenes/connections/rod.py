"""A light rigid rod between two points."""

from typing import ClassVar

from sim2reason.scenes.connections.parts.straight import Straight
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.connection import Joint, Look, connection
from sim2reason.scenes.dsl.mechanism import Rigid
from sim2reason.scenes.dsl.template import Wordings, either


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
        """From site to site; it pulls or pushes."""
        builder.add_line(joint.name, self.ends(joint, builder), Rigid())
