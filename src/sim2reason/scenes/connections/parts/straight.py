"""Straight connections between two points that pass no pulley, so that their ends face each other."""

from typing import ClassVar

from sim2reason.errors import SceneError
from sim2reason.scenes.connections.parts.two_ended import TwoEnded
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.connection import FREE_LENGTH, Joint
from sim2reason.scenes.dsl.layout import opposite
from sim2reason.scenes.dsl.measures import FreeLength
from sim2reason.scenes.dsl.ports import Attachment, Port


class Straight(TwoEnded):
    """Base class of light straight lines between two attachments, which the line can leave in opposite directions."""

    joins: ClassVar[type[Port]] = Attachment
    free: FreeLength = FREE_LENGTH

    @property
    def spacing(self) -> float:
        """Return the initial length, m."""
        return self.free

    def ends(self, joint: Joint, builder: Builder) -> list[str]:
        """Return the two joined sites; raise SceneError if the line between them would have to bend."""
        sites = [stop.sites[0] for stop in joint.stops]
        if not opposite(*(builder.faces[site] for site in sites)):
            problem = f"{' and '.join(map(str, self.links))} do not face each other, and a {self.key} runs straight"
            raise SceneError(
                joint.name, problem, "join ends that it can leave in opposite directions, or lead a string"
            )
        return sites
