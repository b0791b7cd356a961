"""Forces between supports and what they hold; used in structured questions only, never drawn by recipes."""

from collections.abc import Collection

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.dsl.triples import minus, product
from sim2reason.quantities import Quantity, quantity
from sim2reason.quantities.kinematics import Acceleration
from sim2reason.quantities.momentum import NetForce
from sim2reason.quantities.subjects import all_said
from sim2reason.quantities.subjects.axles import held_by_axle_alone
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.quantities.subjects.paths import EVEN, carried_by, chain, upright
from sim2reason.quantities.subjects.pulleys import DIRECTIONS, Pulleys
from sim2reason.quantities.subjects.turners import TurningBodies


class SupportForce(Quantity):
    """Base class of forces between a support, such as an axle, and what it holds."""

    unit, symbol = "N", "F"
    vector = True
    drawn_by_recipes = False
    needs = ("mass",)
    floor, heavy = 0.1, True


@quantity
class PulleyForce(SupportForce):
    """The resultant force on a pulley of the strings that run over it; the axle of a massless pulley bears it."""

    name = "force on a pulley"
    of = Pulleys()
    needs = ("mass", DIRECTIONS)

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return Σ T along each part of a string that leaves the rim, in N, (n, 3)."""
        total = np.zeros((len(state.times), 3))
        for line in state.mechanism.lines:
            for one, other in zip(line.through, line.through[1:], strict=False):
                for rim, end in ((one, other), (other, one)):
                    if rim.rpartition(".")[0] == subject and end.rpartition(".")[0] != subject:
                        part = minus(state.frames.site(end).place, state.frames.site(rim).place)
                        length = np.broadcast_to(np.sqrt(product(part, part)), state.times.shape)
                        length = np.where(length > 0.0, length, np.nan)  # what has no length has no direction
                        total = total + (state.tension[line.name] / length)[:, None] * state.vector(part)
        return total


class AxleLoads(TurningBodies):
    """Every body that a hinge turns, for the force on its axle, to which all that turns about the axle adds."""

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """Return whether the text gives it for every body that has it, since each may load the axle."""
        del name
        return all_said(need, mechanism, said)


@quantity
class ForceOnAxle(SupportForce):
    """The force that a body on a fixed axle exerts on the axle, where only the axle and gravity act on the body."""

    name = "force on the axle"
    of = AxleLoads()

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body is, or is part of, what turns about a fixed axle and is held by the axle alone."""
        return held_by_axle_alone(mechanism, name)

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return Σ m (g − a) of all bodies that turn together, in N, (n, 3)."""
        total = np.zeros((len(state.times), 3))
        for body in carried_by(state.mechanism, chain(state.mechanism, subject)[-1].name):
            if body.mass:
                total = total + body.mass * (
                    np.array(state.mechanism.gravity) - Acceleration.evaluate(state, body.name)
                )
        return total


@quantity
class GuideForce(SupportForce):
    """The horizontal force, in N, that a smooth vertical guide on an accelerating box exerts on the body in it."""

    name, symbol = "force of the guide", "N"
    of = Bodies()

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body slides in a vertical guide that is mounted on a body on a level floor."""
        return _guided(mechanism, name)

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the horizontal part of m a in N, (n, 3); the other forces, a string's and gravity, are vertical."""
        return NetForce.evaluate(state, subject) * np.array((1.0, 1.0, 0.0))


def _guided(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body slides vertically along another one that slides horizontally, without lying on it."""
    body = mechanism.body[name]
    carrier = mechanism.body[body.parent] if body.parent is not None else None
    if carrier is None or name in mechanism.contacts:
        return False
    own, held = body.coordinates, carrier.coordinates
    slides = [c.kind for c in own] == ["slide"] and [c.kind for c in held] == ["slide"]
    return slides and upright(own[0].axis) and abs(held[0].axis[2]) <= EVEN
