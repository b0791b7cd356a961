"""A light spring between two points."""

from typing import ClassVar

from sim2reason.connections.parts.straight import Straight
from sim2reason.dsl.builder import Builder
from sim2reason.dsl.connection import Joint, Look, connection
from sim2reason.dsl.measures import Stiffness
from sim2reason.dsl.template import Wordings, either


@connection
class SpringConnection(Straight):
    """A light spring, relaxed at the start, along the line of the two points that it joins."""

    key: ClassVar[str] = "spring"
    look: ClassVar[Look] = "spring"
    stiffness: Stiffness

    says: ClassVar[Wordings] = either(
        "a light spring of stiffness {stiffness}, at first relaxed, joins {a} to {b}.",
        "{a} is joined to {b} by a light spring of stiffness {stiffness}, which is relaxed at first.",
        "between {a} and {b} runs a light spring of stiffness {stiffness}, relaxed at the start.",
    )
    leads: ClassVar[Wordings] = either(
        "from {a} a light spring of stiffness {stiffness}, at first relaxed, {way} to {b}.",
        "a light spring of stiffness {stiffness} is fastened to {a}; relaxed at first, it {way} to {b}.",
        "to {a} is fastened a light spring of stiffness {stiffness}, which {way} to {b} and is relaxed at the start.",
    )

    def build(self, joint: Joint, builder: Builder) -> None:
        """From site to site, as long as they are apart."""
        builder.add_spring(joint.name, self.ends(joint, builder), self.stiffness, None, 0.0)
