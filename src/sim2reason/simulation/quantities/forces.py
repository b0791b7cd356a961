"""Forces of contacts, strings, rods and supports."""

from collections.abc import Collection

import numpy as np

from sim2reason.scenes.dsl.mechanism import ZERO, Mechanism
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.scenes.dsl.vectors import dot, subtract_triples
from sim2reason.simulation.quantities import Quantity, quantity
from sim2reason.simulation.quantities.kinematics import Acceleration
from sim2reason.simulation.quantities.momentum import NetForce
from sim2reason.simulation.quantities.subjects import Sense, is_stated_for_all
from sim2reason.simulation.quantities.subjects.bodies import (
    DIRECTION_TOL,
    VERTICAL,
    Bodies,
    SuspendedBodies,
    TurningBodies,
    ancestor_chain,
    carried_bodies,
    is_vertical,
)
from sim2reason.simulation.quantities.subjects.interactions import Contacts, Strings
from sim2reason.simulation.quantities.subjects.rotating_parts import (
    DIRECTIONS,
    Axles,
    Pulleys,
    Rods,
    is_held_by_axle_alone,
    pointer,
)


class SupportForce(Quantity):
    """Base class of forces between a support, such as an axle, and the supported body."""

    unit, symbol = "N", "F"
    vector = True
    drawn_by_recipes = False
    needs = ("mass",)
    floor, heavy = 0.1, True


@quantity
class PulleyForce(SupportForce):
    """The resultant force of the strings on a pulley; for a massless pulley its axle bears this force."""

    name = "force on a pulley"
    of = Pulleys()
    needs = ("mass", DIRECTIONS)

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return Σ T over the string parts that leave the rim, in N, (n, 3)."""
        total = np.zeros((len(state.times), 3))
        for line in state.mechanism.lines:
            for one, other in zip(line.through, line.through[1:], strict=False):
                for rim, end in ((one, other), (other, one)):
                    if rim.rpartition(".")[0] == subject and end.rpartition(".")[0] != subject:
                        part = subtract_triples(state.frames.site(end).place, state.frames.site(rim).place)
                        length = np.broadcast_to(np.sqrt(dot(part, part)), state.times.shape)
                        length = np.where(length > 0.0, length, np.nan)  # what has no length has no direction
                        total = total + (state.tension[line.name] / length)[:, None] * state.vector(part)
        return total


class AxleLoads(TurningBodies):
    """The kind of subject for the force on an axle: every body on a hinge, with all bodies that rotate with it."""

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """Return whether the text states the number `need` for every body that has it, since each may load the axle."""
        del name
        return is_stated_for_all(need, mechanism, said)


@quantity
class ForceOnAxle(SupportForce):
    """The force that a body on a fixed axle exerts on the axle, if only the axle and gravity act on the body."""

    name = "force on the axle"
    of = AxleLoads()

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body, alone or in a rigid body, rotates about a fixed axle without other contacts."""
        return is_held_by_axle_alone(mechanism, name)

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return Σ m (g − a) over all bodies that rotate together, in N, (n, 3)."""
        total = np.zeros((len(state.times), 3))
        for body in carried_bodies(state.mechanism, ancestor_chain(state.mechanism, subject)[-1].name):
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
        """Return the horizontal part of m a in N, (n, 3); the other forces, tension and gravity, are vertical."""
        return NetForce.evaluate(state, subject) * np.array((1.0, 1.0, 0.0))


def _guided(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body slides vertically along a horizontally sliding body without lying on it."""
    body = mechanism.body[name]
    carrier = mechanism.body[body.parent] if body.parent is not None else None
    if carrier is None or name in mechanism.contacts:
        return False
    own, carrier_coordinates = body.coordinates, carrier.coordinates
    slides = [c.kind for c in own] == ["slide"] and [c.kind for c in carrier_coordinates] == ["slide"]
    return slides and is_vertical(own[0].axis) and abs(carrier_coordinates[0].axis[2]) <= DIRECTION_TOL


FORCE = "force that the axle exerts on {body}"


@quantity
class AxleForce(Quantity):
    """The force that a fixed axle exerts on the body that rotates about it."""

    name, unit, symbol = "axle force", "N", "F"
    of, vector = Axles(), True
    magnitude = f"the magnitude of the {FORCE}"
    signed = f"the {{component}}{FORCE}"
    how = "how large a force does the axle exert on {body} {when}?"
    needs = ("mass",)
    immediate = True
    weight = 3.0
    floor, heavy = 0.1, True

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return Σ m (a − g) over all bodies that rotate together, in N, (n, 3)."""
        return -ForceOnAxle.evaluate(state, subject)

    def signed_along(self, sense: Sense, mechanism: Mechanism, name: str) -> str:
        """Return *the upward component* or *the rightward component*, so that the phrase fixes the sign."""
        del mechanism, name
        direction = "upward" if sense.axis == VERTICAL else "rightward"
        return f"the {direction} component of the {FORCE}"


@quantity
class NormalForce(Quantity):
    """The normal force on a body that lies on a face."""

    name, unit, symbol = "normal force", "N", "N"
    of = Contacts()
    magnitude = "the magnitude of the normal force exerted on {body} by {surface}"
    needs = ("mass",)
    immediate = True
    floor, heavy = 0.1, True
    panel, order = "normal force", 0

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the normal force in N, (n,); negative only on faces that hold in both directions."""
        return state.normal[subject]


@quantity
class FrictionForce(Quantity):
    """The friction force on a body that lies on a face, signed along its direction of slip."""

    name, unit, symbol = "friction force", "N", "f"
    of = Contacts()
    magnitude = "the magnitude of the friction force exerted on {body} by {surface}"
    needs = ("mass",)
    immediate = True
    weight = 8.0  # on a rough face it should be asked about as often as a velocity
    floor, heavy = 0.1, True
    order = 1

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the static or kinetic friction force in N, (n,)."""
        return state.friction[subject]

    def present(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the face is rough."""
        return mechanism.contacts[name].friction > 0.0


@quantity
class FrictionNeeded(Quantity):
    """The smallest coefficient of static friction that prevents slipping: friction force divided by normal force.

    It is used in structured questions only, and never drawn by recipes.
    """

    name, unit, symbol = "coefficient of friction needed", "", "μ"
    of = Contacts()
    drawn_by_recipes = False
    floor = 0.1

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the face is rough."""
        return mechanism.contacts[name].friction > 0.0

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return |f| / |N|, (n,); zero without friction, infinite if friction acts without a normal force."""
        pressed = np.abs(state.normal[subject])
        ratio = np.divide(
            np.abs(state.friction[subject]), pressed, out=np.full(pressed.shape, np.inf), where=pressed > 0
        )
        return np.where(state.friction[subject] == 0.0, 0.0, ratio)


@quantity
class RodForce(Quantity):
    """The force in a light rod, positive in tension."""

    name, unit, symbol = "rod force", "N", "T"
    of = Rods()
    magnitude = "the magnitude of the force in {rod}"
    needs = ("mass",)
    immediate = True
    weight = 2.0
    floor, heavy = 0.1, True
    panel, order = "tension", 0

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the constraint force in N, (n,); for a rod on a hinge, Σ m (g − a) of its load along the rod."""
        if subject in state.mechanism.line:
            return state.tension[subject]
        (top, start), (bottom, end) = pointer(state.mechanism, subject)
        arm = subtract_triples(state.frames[bottom].point(end).place, state.frames[top].point(start).place)
        length = np.sqrt(dot(arm, arm))
        along = state.vector(arm) / np.broadcast_to(length, state.times.shape)[:, None]
        total = np.zeros((len(state.times), 3))
        for body in carried_bodies(state.mechanism, subject):
            if body.mass:
                total = total + body.mass * (
                    np.array(state.mechanism.gravity) - Acceleration.evaluate(state, body.name)
                )
        return np.einsum("ij,ij->i", total, along)


@quantity
class RodPull(Quantity):
    """The force in a light rod that holds a small body on a moving axle; for structured questions, not for recipes."""

    name, unit, symbol = "rod pull", "N", "T"
    of = SuspendedBodies()
    drawn_by_recipes = False
    needs = ("mass",)
    floor, heavy = 0.1, True

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return m (g − a) along the rod in N, (n,): positive if the rod pulls."""
        arm = subtract_triples(state.frames.center(subject).place, state.frames[subject].point(ZERO).place)
        along = state.vector(arm) / np.broadcast_to(np.sqrt(dot(arm, arm)), state.times.shape)[:, None]
        force = np.array(state.mechanism.gravity) - Acceleration.evaluate(state, subject)
        return state.mechanism.body[subject].mass * np.einsum("ij,ij->i", force, along)


@quantity
class StringLength(Quantity):
    """The change since the start of the free length of a string, site to site.

    A massive pulley that winds the string on or off changes it. A slack string counts as the shortest line.
    """

    name, unit, symbol = "length", "m", "l"
    of = Strings()
    floor = 0.1

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the change Δl of the length since the start in m, (n,)."""
        line = state.mechanism.line[subject]
        return state.length(line)[0] - state.began.length(line)


@quantity
class StringLengthRate(Quantity):
    """The rate of change of the free length of a string."""

    name, unit, symbol = "rate of change of length", "m/s", "u"
    of = Strings()
    floor, least = 0.1, 1e-2

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return dl/dt in m/s, (n,)."""
        return state.length(state.mechanism.line[subject])[1]


@quantity
class Tension(Quantity):
    """The tension of a string: 0 if it is slack, NaN if the mechanism does not determine it."""

    name, unit, symbol = "tension", "N", "T"
    of = Strings()
    magnitude = "the tension in {string}"
    needs = ("mass",)
    immediate = True
    weight = 3.0
    floor, heavy = 0.1, True
    panel, order = "tension", 0

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the tension T ≥ 0 in N, (n,)."""
        return state.tension[subject]
