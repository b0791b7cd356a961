"""Bodies, by where they can move."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.vectors import Vector, scale
from sim2reason.quantities.subjects import Sense, Subject, is_said
from sim2reason.quantities.subjects.paths import EVEN, CenterPath, center_path, is_pulley_wheel, rides

UP, RIGHT = "up", "right"
OPPOSITE = {UP: "down", RIGHT: "left"}
HORIZONTAL, VERTICAL = "horizontal", "vertical"
SELDOM = 0.3  # of a component along no axis of the text, or along one of two
AXES = ("x", "y", "z")  # labels of coordinates along axes that the text defines


@dataclass(frozen=True)
class Bodies(Subject):
    """Every body; those whose centre of mass can move are spoken of."""

    name = slot = "body"
    extras = frozenset({"ground"})

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """All bodies, massless ones and wheels among them."""
        return tuple(mechanism.body)

    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """Those that can move, but for the wheels of pulleys: a pulley is no disc that the text follows."""
        return {name: mentions[name] for name in mechanism.body if name in mentions and moves(mechanism, name)}

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """Whether the body has it and the text says it at the body's address."""
        return getattr(mechanism.body[name], need, 1.0) != 0.0 and is_said(need, name, said)

    def fills(self, mechanism: Mechanism, name: str, mentions: Mapping[str, str]) -> dict[str, str]:
        """Return *relative to the ground* for a body that is carried by another one."""
        del mentions
        return {"ground": " relative to the ground" if rides(mechanism, name) else ""}

    def point(self, mechanism: Mechanism, name: str, phrase: str) -> str:
        """The centre of mass of what has a size and swings; what turns about its centre moves as that does."""
        swings = any(mechanism.body[name].inertia) and center_path(mechanism, name).swings
        return f"the centre of mass of {phrase}" if swings else phrase

    def senses(self, mechanism: Mechanism, name: str) -> list[Sense]:
        """Up, up the slope, the axes that the text defines."""
        own = [c for c in mechanism.body[name].coordinates if c.label in AXES and c.kind == "slide"]
        path = center_path(mechanism, name)
        if own and len(own) == len(path.ways):
            share = SELDOM if len(own) > 1 else 1.0  # of a plane motion rather how fast, how far and which way
            return [Sense(f"along the {c.label} axis", c.axis, c.label, share=share, fixed=True) for c in own]
        right = [Sense(RIGHT, c.axis) for c in mechanism.body[name].coordinates if c.label == RIGHT]
        return _of_path(path) or (right if path.straight else [])

    def directions(self, mechanism: Mechanism, name: str) -> list[Vector]:
        """Those of its own and of what carries it; none of a path that bends."""
        path = center_path(mechanism, name)
        return [] if path.bends else list(path.ways)

    def label(self, phrase: str) -> str:
        """Its letter, or its noun."""
        return phrase.removeprefix("the ") if phrase.startswith("the ") else phrase.rpartition(" ")[2]


def moves(mechanism: Mechanism, name: str) -> bool:
    """Whether the centre of mass of a body can move, and it is not the wheel of a pulley.

    What has no mass and turns, as a light arm on a carriage does, has no centre of mass, and no point is meant.
    """
    body = mechanism.body[name]
    pointless = not body.mass and any(coordinate.kind == "hinge" for coordinate in body.coordinates)
    return bool(center_path(mechanism, name).ways) and not pointless and not is_pulley_wheel(mechanism, name)


def moves_in_plane(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body moves freely along two axes of the text, as projectiles, pucks and planets do."""
    return sum(coordinate.label in AXES for coordinate in mechanism.body[name].coordinates) > 1


def _of_path(path: CenterPath) -> list[Sense]:
    """The directions for which English has words; right is only one where the text fixes it, as a label says."""
    if not path.rises:
        return []
    if not path.straight:
        return [Sense(UP, (0.0, 0.0, 1.0), VERTICAL, share=SELDOM)]
    way = path.ways[0] if path.ways[0][2] > 0.0 else scale(-1.0, path.ways[0])
    return [Sense(UP if way[2] > 1.0 - EVEN else "up the slope", way)]
