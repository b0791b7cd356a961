"""Energies and powers, including the thrust of rocket engines and the fuel that they burn."""

import numpy as np

from sim2reason.scenes.dsl.mechanism import ZERO, Attraction, ConstantTension, MassEjection, Mechanism
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.scenes.dsl.vectors import dot, subtract_triples
from sim2reason.simulation.quantities import Quantity, quantity
from sim2reason.simulation.quantities.forces import StringLengthRate
from sim2reason.simulation.quantities.kinematics import AngularVelocity, Displacement, Velocity
from sim2reason.simulation.quantities.momentum import AngularMomentum, NetForce
from sim2reason.simulation.quantities.subjects.bodies import Bodies, center_path, is_welded_part
from sim2reason.simulation.quantities.subjects.interactions import Strings


class Energy(Quantity):
    """Base class of the energies of a body."""

    of = Bodies()
    unit = "J"
    needs = ("mass",)
    floor, heavy = 0.1, True


@quantity
class KineticEnergy(Energy):
    """The kinetic energy of a single body, including that of its rotation."""

    name, symbol = "kinetic energy", "K"
    magnitude = "the kinetic energy of {body}{ground}"
    how = "how much kinetic energy does {body} have{ground} {when}?"
    given = True
    weight = 0.15  # of one body it is seldom more than a function of its speed
    panel, pooled, order = "energy", True, 5

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return K = ½ m v² + ½ ω·Iω (König) in J, (n,), with the body's own inertia about its centre of mass."""
        moving = TranslationalEnergy.evaluate(state, subject)
        if state.frames[subject].spin is None:
            return moving
        return moving + RotationalEnergy.evaluate(state, subject)


class KineticEnergyPart(Energy):
    """Base class of the translational and rotational parts of the kinetic energy of a rotating body."""

    weight = 0.1
    given = True

    def present(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body rotates and has a moment of inertia, so that the parts differ from the total.

        It is False for a body welded to others.
        """
        turns = any(mechanism.body[name].inertia) and bool(center_path(mechanism, name).turns)
        return turns and not is_welded_part(mechanism, name)


@quantity
class TranslationalEnergy(KineticEnergyPart):
    """The kinetic energy of the motion of the centre of mass."""

    name, symbol = "translational kinetic energy", "K"
    magnitude = "the translational kinetic energy of {body}{ground}"
    order = 6

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return ½ m v² in J, (n,)."""
        speed = Velocity.evaluate(state, subject)
        return 0.5 * state.mass(subject) * np.einsum("ij,ij->i", speed, speed)


@quantity
class RotationalEnergy(KineticEnergyPart):
    """The kinetic energy of rotation about the centre of mass."""

    name, symbol = "rotational kinetic energy", "K"
    magnitude = "the rotational kinetic energy of {body} about its centre of mass"
    order = 7

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body rotates and has a moment of inertia."""
        return self.present(mechanism, name)

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return ½ ω·Iω in J, (n,)."""
        omega, momentum = AngularVelocity.evaluate(state, subject), AngularMomentum.evaluate(state, subject)
        return 0.5 * np.einsum("ij,ij->i", omega, momentum)


@quantity
class PotentialEnergy(Energy):
    """The gravitational potential energy of a body minus its initial value, in a uniform field or near fixed bodies."""

    name, symbol = "potential energy", "U"
    over = "the magnitude of the change in {body}'s gravitational potential energy"
    how = "by how much does the gravitational potential energy of {body} change {when}?"
    magnitude = f"{over} since the start"
    weight = 0.02  # of one body it is seldom useful by itself
    from_start = True
    panel, pooled, order = "energy", True, 8

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return −m g·s, and −G m M/r for each attracting body at rest, minus their initial values, in J, (n,)."""
        rise = -(Displacement.evaluate(state, subject) @ np.array(state.mechanism.gravity))
        total = state.mass(subject) * rise
        for pull, other in _pulls(state.mechanism, subject):
            total = total + _attracted(state, pull, subject, other)
        return total

    def present(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body rises or falls, or is attracted only by bodies at rest."""
        if any(burn.body == name for burn in mechanism.burns):
            return False
        pulls = _pulls(mechanism, name)
        alone = all(not center_path(mechanism, other).ways for _, other in pulls)
        rises = mechanism.gravity != ZERO and center_path(mechanism, name).rises
        return alone and (rises or bool(pulls))


def _pulls(mechanism: Mechanism, name: str) -> list[tuple[Attraction, str]]:
    """Return the attractions of a body, each with the name of the other body."""
    return [(p, p.b if p.a == name else p.a) for p in mechanism.attractions if name in (p.a, p.b)]


def _attracted(state: State, pull: Attraction, name: str, other: str) -> Array:
    """Return −G m M/((p − 1) rᵖ⁻¹) minus its initial value in J, (n,); for p = 1 the logarithm."""
    separation = subtract_triples(state.frames.center(name).place, state.frames.center(other).place)
    began = subtract_triples(state.began.center(name).place, state.began.center(other).place)
    far, near = np.sqrt(dot(separation, separation)), float(np.sqrt(dot(began, began)))
    strength = pull.constant * state.mass(name) * state.mass(other)
    if pull.power == 1.0:
        return strength * np.log(far / near)
    power = pull.power - 1.0
    return strength / power * (near**-power - far**-power)


class PowerOfForce(Quantity):
    """Base class of quantities that are the power of a force on a body, in W."""

    unit, symbol = "W", "P"
    of = Bodies()
    drawn_by_recipes = False
    floor, heavy = 0.1, True


@quantity
class NetPower(PowerOfForce):
    """The power of the net force on a body."""

    name = "power of the net force"
    magnitude = "the magnitude of the power of the net force on {body}"
    needs = ("mass",)
    order = 20

    def present(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body is not welded to others."""
        return not is_welded_part(mechanism, name)

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return F·v in W, (n,), with the velocity of the centre of mass."""
        return np.einsum("ij,ij->i", NetForce.evaluate(state, subject), Velocity.evaluate(state, subject))


@quantity
class GravityPower(PowerOfForce):
    """The power of the weight of a body in a uniform field."""

    name = "power of gravity"
    magnitude = "the magnitude of the power of gravity on {body}"
    needs = ("mass",)
    order = 21

    def present(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether there is a uniform field and the body rises or falls."""
        return mechanism.gravity != ZERO and center_path(mechanism, name).rises

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return m g·v in W, (n,)."""
        return state.mass(subject) * (Velocity.evaluate(state, subject) @ np.array(state.mechanism.gravity))


@quantity
class HandPower(PowerOfForce):
    """The power of a hand that pulls a string with a constant force."""

    name = "power of a hand"
    of = Strings()
    order = 23

    def subjects(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the names of the strings that a hand pulls."""
        return tuple(line.name for line in mechanism.pulls)

    def present(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether a hand pulls the string."""
        return name in self.subjects(mechanism)

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the force times the rate at which the string is pulled in, in W, (n,)."""
        law = state.mechanism.line[subject].law
        assert isinstance(law, ConstantTension)
        return -law.force * StringLengthRate.evaluate(state, subject)


class EngineQuantity(Quantity):
    """Base class of quantities of a body that burns fuel."""

    of = Bodies()
    drawn_by_recipes = False
    floor = 0.1

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body has a single engine."""
        return [burn.body for burn in mechanism.burns].count(name) == 1


@quantity
class Thrust(EngineQuantity):
    """The thrust of the engine while it burns."""

    name, unit, symbol = "thrust", "N", "F"

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the burn rate times the exhaust speed in N, (n,); zero after burnout."""
        burn = _burn(state.mechanism, subject)
        return np.where(state.times < burn.until, burn.rate * burn.exhaust, 0.0)


@quantity
class ThrustPower(EngineQuantity):
    """The power of the thrust: the thrust times the component of the velocity along it."""

    name, unit, symbol = "power of the thrust", "W", "P"
    magnitude = "the magnitude of the power of the thrust on {body}"
    heavy, order = True, 22

    def present(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body has a single engine."""
        return self.fits(mechanism, name)

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the power in W, (n,); zero after burnout."""
        along = Velocity.evaluate(state, subject) @ np.array(_burn(state.mechanism, subject).direction)
        return Thrust.evaluate(state, subject) * along


@quantity
class FuelBurnt(EngineQuantity):
    """The mass of the fuel that has been burnt."""

    name, unit, symbol = "fuel burnt", "kg", "m"

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the burn rate times the elapsed burn time in kg, (n,)."""
        burn = _burn(state.mechanism, subject)
        return burn.rate * np.minimum(state.times, burn.until)


@quantity
class FuelLeft(EngineQuantity):
    """The mass of the fuel that is left."""

    name, unit, symbol = "fuel left", "kg", "m"

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the initial fuel minus the fuel burnt since then, in kg, (n,)."""
        burn = _burn(state.mechanism, subject)
        return burn.rate * burn.until - FuelBurnt.evaluate(state, subject)


def _burn(mechanism: Mechanism, name: str) -> MassEjection:
    return next(burn for burn in mechanism.burns if burn.body == name)
