"""Connections that run straight from a point to another: they pass no pulley, so their ends face each other."""

from typing import ClassVar

from sim2reason.errors import SceneError
from sim2reason.scenes.connections.parts.two_ended import TwoEnded
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.connection import FREE, Joint
from sim2reason.scenes.dsl.layout import opposite
from sim2reason.scenes.dsl.measures import FreeLength
from sim2reason.scenes.dsl.ports import Attachment, Port


class Straight(TwoEnded):
    """A light line between two attachments, along the directions in which they can be left."""

    joins: ClassVar[type[Port]] = Attachment
    free: FreeLength = FREE

    @property
    def spacing(self) -> float:
        """Return how long it is at the start, m."""
        return self.free

    def ends(self, joint: Joint, builder: Builder) -> list[str]:
        """Return the two sites that it joins; SceneError if it would have to turn on its way from one to the other."""
        sites = [stop.sites[0] for stop in joint.stops]
        if not opposite(*(builder.faces[site] for site in sites)):
            problem = f"{' and '.join(map(str, self.links))} do not face each other, and a {self.key} runs straight"
            raise SceneError(
                joint.name, problem, "join ends that it can leave in opposite directions, or lead a string"
            )
        return sites
