"""Sentences about a momentum that is conserved: along a level track all of it, else its horizontal component."""

from dataclasses import dataclass
from typing import Self

from sim2reason.bodies.planes import Track
from sim2reason.solutions.setting import LEVEL, Setting


@dataclass(frozen=True, slots=True)
class MomentumWords:
    """Sentences about the conservation of momentum, each without its full stop."""

    conserved: str
    zero: str
    rests: str  # what follows from that for the centre of mass, as do the next two sentences
    drifts: str
    unaccelerated: str
    frame: str  # in which the momentum is zero

    @property
    def still(self) -> str:
        """Return that the momentum is zero, with what follows."""
        return f"{self.zero}{self.rests}"

    @classmethod
    def of(cls, setting: Setting) -> Self:
        """Return those for a scene."""
        coordinates = setting.mechanism.coordinates
        if all(coordinate.kind == "hinge" for coordinate in coordinates):  # beads on a level ring
            return cls._angular()
        level = all(abs(c.axis[2]) < LEVEL for c in coordinates if c.kind == "slide")
        if level and any(isinstance(body, Track) for body in setting.scene.bodies.values()):
            return cls._along_a_track()
        return cls(
            "The total horizontal momentum is conserved",
            "The total horizontal momentum is zero",
            ", so the common centre of mass does not move horizontally",
            "The horizontal velocity of the centre of mass is constant",
            "The centre of mass has no horizontal acceleration",
            "In the frame of reference in which the horizontal momentum is zero,",
        )

    @classmethod
    def _along_a_track(cls) -> Self:
        return cls(
            "The total momentum along the track is conserved",
            "The total momentum along the track is zero",
            ", so the common centre of mass stays at rest",
            "The centre of mass moves with constant velocity",
            "The centre of mass is not accelerated",
            "In the frame of reference in which the momentum is zero,",
        )

    @classmethod
    def _angular(cls) -> Self:
        return cls(
            "The angular momentum about the centre of the circle is conserved",
            "The angular momentum about the centre of the circle is zero",
            "",
            "The angular momentum about the centre of the circle is constant",
            "The angular momentum about the centre of the circle does not change",
            "In the frame of reference in which the angular momentum is zero,",
        )
