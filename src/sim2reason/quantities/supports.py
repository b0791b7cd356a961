"""What supports bear: the force of strings on a pulley, and that of what turns on its axle. Recipes ask for neither."""

from collections.abc import Collection

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.dsl.triples import minus, product
from sim2reason.quantities import Quantity, quantity
from sim2reason.quantities.kinematics import Acceleration
from sim2reason.quantities.momentum import NetForce
from sim2reason.quantities.subjects import all_said
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.quantities.subjects.paths import EVEN, carried_by, chain, upright
from sim2reason.quantities.subjects.pulleys import Pulleys
from sim2reason.quantities.subjects.turners import TurningBodies


@quantity
class PulleyForce(Quantity):
    """The resultant force of the strings that run over a pulley on it, which of a light one its axle bears."""

    name, unit, symbol = "force on a pulley", "N", "F"
    of, vector = Pulleys(), True
    drawn_by_recipes = False
    needs = ("mass",)
    floor, heavy = 0.1, True

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Σ T along each part of a string that leaves the rim, (n, 3)."""
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
    """What turns about an axle, of all of which the text gives what a quantity needs."""

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """What an axle bears comes from everything that is there."""
        del name
        return all_said(need, mechanism, said)


@quantity
class AxleForce(Quantity):
    """The force of what turns about a fixed axle on that axle, if nothing else than axle and weight acts on it."""

    name, unit, symbol = "force on the axle", "N", "F"
    of, vector = AxleLoads(), True
    drawn_by_recipes = False
    needs = ("mass",)
    floor, heavy = 0.1, True

    def subjects(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the names of what turns about a fixed axle, each part of it included."""
        return tuple(name for name in mechanism.body if _held_by_axle_alone(mechanism, name))

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Σ m (g − a) of all that turns together, (n, 3)."""
        total = np.zeros((len(state.times), 3))
        for body in carried_by(state.mechanism, chain(state.mechanism, subject)[-1].name):
            if body.mass:
                total = total + body.mass * (
                    np.array(state.mechanism.gravity) - Acceleration.evaluate(state, body.name)
                )
        return total


def _held_by_axle_alone(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body, with all that is joined to it, turns about one fixed axle, and nothing else holds it."""
    if [c.kind for body in chain(mechanism, name) for c in body.coordinates] != ["hinge"]:
        return False
    together = carried_by(mechanism, chain(mechanism, name)[-1].name)
    held = {body.name for body in together}
    pulled = {mechanism.site[site].body for line in mechanism.lines for site in line.through}
    acted = {force.body for force in mechanism.forces} | {burn.body for burn in mechanism.burns}
    stands = {mechanism.site[foot.site].body for foot in mechanism.feet}
    hinges = [c.name for body in together for c in body.coordinates]
    wound = any(wheel.coordinate in hinges for line in mechanism.lines for wheel in line.wheels)
    return len(hinges) == 1 and not wound and not held & (pulled | acted | stands | mechanism.contacts.keys())


@quantity
class GuideForce(Quantity):
    """The horizontal force, in N, that a smooth vertical guide on an accelerating box exerts on the body in it."""

    name, unit, symbol = "force of the guide", "N", "N"
    of, vector = Bodies(), True
    drawn_by_recipes = False
    needs = ("mass",)
    floor, heavy = 0.1, True

    def subjects(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the names of the bodies in guides on bodies that slide on a level floor."""
        return tuple(body.name for body in mechanism.bodies if _guided(mechanism, body.name))

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """The level part of m a, as a string beside the guide pulls straight up, (n, 3)."""
        return NetForce.evaluate(state, subject) * np.array((1.0, 1.0, 0.0))


def _guided(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body slides up and down on a body that slides on the level, and lies on no face of it."""
    body = mechanism.body[name]
    carrier = mechanism.body[body.parent] if body.parent is not None else None
    if carrier is None or name in mechanism.contacts:
        return False
    own, held = body.coordinates, carrier.coordinates
    slides = [c.kind for c in own] == ["slide"] and [c.kind for c in held] == ["slide"]
    return slides and upright(own[0].axis) and abs(held[0].axis[2]) <= EVEN
