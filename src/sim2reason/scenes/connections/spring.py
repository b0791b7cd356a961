"""A light spring between two points."""

from math import dist
from typing import Annotated, ClassVar, Literal, Self

from annotated_types import Ge, Le
from pydantic import model_validator

from sim2reason.scenes.connections.parts.straight import Straight
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.connection import Joint, Look, connection
from sim2reason.scenes.dsl.measures import Chance, Measure, Range, Stiffness, Strain
from sim2reason.scenes.dsl.template import Word, Wordings, either

Dashpot = Annotated[float, Ge(0), Le(1e6), Measure("damping constant", "N*s/m", "b"), Range(0.2, 3.0), Chance(0.25)]


@connection
class SpringConnection(Straight):
    """A light spring along the line of the two points that it joins, strained at the start or not, damped or not."""

    key: ClassVar[str] = "spring"
    look: ClassVar[Look] = "spring"
    stiffness: Stiffness
    strained: Annotated[Literal["stretched", "compressed"], Chance(1.0)] = "stretched"
    by: Annotated[Strain, Chance(0.5)] = 0.0
    damping: Dashpot = 0.0

    words: ClassVar[dict[str, Word]] = {
        "strain": Word("by", {0.0: "relaxed"}, "{strained} by {by}"),
        "dashpot": Word("damping", {0.0: ""}, " with a light dashpot of damping constant {damping} beside it"),
        "damped": Word("damping", {0.0: ""}, ", and beside it acts a light dashpot of damping constant {damping}"),
    }
    says: ClassVar[Wordings] = either(
        "a light spring of stiffness {stiffness}{dashpot}, initially {strain}, joins {a} to {b}.",
        "{a} is joined to {b} by a light spring of stiffness {stiffness}, initially {strain}{damped}.",
        "between {a} and {b} runs a light spring of stiffness {stiffness}{dashpot}; at the start the spring is {strain}.",
    )
    leads: ClassVar[Wordings] = either(
        "from {a} a light spring of stiffness {stiffness}{dashpot}, initially {strain}, {way} to {b}.",
        "a light spring of stiffness {stiffness} is fastened to {a}; initially {strain}, it {way} to {b}{damped}.",
        "a light spring of stiffness {stiffness}{dashpot}, fastened to {a}, {way} to {b} and is {strain} at the start.",
    )

    @model_validator(mode="after")
    def _strained_or_not(self) -> Self:
        if self.by == 0.0 and self.strained != "stretched":
            raise ValueError("strained: a spring strained by 0 is relaxed; leave it out, or say by how much")
        return self

    @property
    def spacing(self) -> float:
        """Return the free length at the start, m: the smaller of initial and natural length, both being positive."""
        return self.free + (self.by if self.strained == "stretched" else 0.0)

    def build(self, joint: Joint, builder: Builder) -> None:
        """Add a spring from site to site; its natural length follows from their distance and the strain."""
        ends = self.ends(joint, builder)
        strain = self.by if self.strained == "stretched" else -self.by
        length = dist(*map(builder.position, ends)) - strain
        builder.add_spring(joint.name, ends, self.stiffness, length, self.damping)
