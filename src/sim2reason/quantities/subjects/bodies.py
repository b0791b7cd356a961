"""Bodies, by where they can move."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.vectors import Vector
from sim2reason.quantities.subjects import Sense, Subject

EVEN = 1e-9  # the vertical part of a direction that is level
UP = "up"


@dataclass(frozen=True)
class Bodies(Subject):
    """Every body."""

    name = slot = "body"

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """All bodies, massless ones and wheels among them."""
        return tuple(mechanism.body)

    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """Those that move without turning."""
        return {name: mentions[name] for name in mechanism.body if name in mentions and moves(mechanism, name)}

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """Whether the body has it and the text says it at the body's address."""
        return getattr(mechanism.body[name], need) != 0.0 and f"{name}.{need}" in said

    def senses(self, mechanism: Mechanism, name: str) -> list[Sense]:
        """Up, up the slope, the axes of a table."""
        return senses(mechanism, name)

    def directions(self, mechanism: Mechanism, name: str) -> list[Vector]:
        """Those of its own and of what carries it."""
        return axes(mechanism, name)

    def ground(self, mechanism: Mechanism, name: str) -> str:
        """What rides on a body that moves another way moves in two ways."""
        return " relative to the ground" if len(axes(mechanism, name)) > 1 and rides(mechanism, name) else ""

    def label(self, phrase: str) -> str:
        """Its letter, or its noun."""
        return phrase.removeprefix("the ") if phrase.startswith("the ") else phrase.rpartition(" ")[2]


def axes(mechanism: Mechanism, name: str) -> list[Vector]:
    """The directions in which a body can move in the room, its own first."""
    found: list[Vector] = []
    step: str | None = name
    while step is not None:
        body = mechanism.body[step]
        found.extend(c.axis for c in body.coordinates if c.kind == "slide")
        step = body.parent
    return found


def moves(mechanism: Mechanism, name: str) -> bool:
    """Whether a body can move, and does not turn."""
    return bool(axes(mechanism, name)) and not any(mechanism.body[name].inertia)


def rides(mechanism: Mechanism, name: str) -> bool:
    """Whether a body rides on another one that moves."""
    parent = mechanism.body[name].parent
    return parent is not None and moves(mechanism, parent)


def senses(mechanism: Mechanism, name: str) -> list[Sense]:
    """The directions that the text gives words for: up, up the slope, the axes of a table.

    Left and right are only used where the text fixes them, which a prism with two faces does.
    """
    found, body = axes(mechanism, name), mechanism.body[name]
    if len(body.coordinates) == 2 and name not in mechanism.contacts:
        return [Sense(f"the {c.label} axis", c.axis, c.label, fixed=True) for c in body.coordinates]
    if len(found) == 1:
        return [] if abs(found[0][2]) < EVEN else [Sense(_uphill(found[0]), found[0])]
    return [Sense(UP, (0.0, 0.0, 1.0), "vertical")] if any(abs(axis[2]) > EVEN for axis in found) else []


def _uphill(axis: Vector) -> str:
    return UP if abs(axis[2]) > 1.0 - EVEN else "up the slope"
