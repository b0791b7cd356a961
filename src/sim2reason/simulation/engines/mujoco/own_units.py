"""Simulation of very light mechanisms in units of mass and time in which their numbers are near 1.

MuJoCo would treat such masses as zero. Lengths keep their unit, so that the geometry is unchanged.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

from sim2reason.scenes.dsl.fields import Law
from sim2reason.scenes.dsl.mechanism import (
    Attraction,
    ConstantTension,
    Coordinate,
    Elastic,
    Inextensible,
    LineLaw,
    MassEjection,
    Mechanism,
    RigidBody,
)
from sim2reason.scenes.dsl.state import Array, Dynamics, State
from sim2reason.scenes.dsl.vectors import Maths, Number, Triple, Vector, scale_triple
from sim2reason.simulation.trace import Event, Trace

MIN_MASS = 1e-15  # kg or kg m²: MuJoCo treats a smaller mass or inertia as zero


def is_tiny(mechanism: Mechanism) -> bool:
    """Return whether a moving body is so light that MuJoCo would treat it as massless."""
    return any(0.0 < body.mass < MIN_MASS for body in mechanism.bodies)


@dataclass(frozen=True, slots=True)
class OwnUnits:
    """The units of mass and time of a simulation, as multiples of the original units of the mechanism."""

    mass: float
    time: float

    @classmethod
    def for_motion(cls, mechanism: Mechanism, duration: float) -> "OwnUnits":
        """Return the units suited to a motion: the mass of the heaviest body, and the duration."""
        return cls(max(body.mass for body in mechanism.bodies), duration)

    @property
    def force(self) -> float:
        """Return the unit of force that follows from these units if lengths keep their unit."""
        return self.mass / self.time**2

    # ---- there

    def convert_mechanism(self, mechanism: Mechanism) -> Mechanism:
        """Return a mechanism with its numbers converted to these units."""
        x, y, z = mechanism.gravity
        square = self.time**2
        return replace(
            mechanism,
            bodies=tuple(map(self._body, mechanism.bodies)),
            lines=tuple(replace(line, law=self._line_law(line.law)) for line in mechanism.lines),
            forces=tuple(replace(force, law=LawInUnits(force.law, self)) for force in mechanism.forces),
            attractions=tuple(map(self._attraction, mechanism.attractions)),
            burns=tuple(map(self._burn, mechanism.burns)),
            gravity=(x * square, y * square, z * square),
        )

    def _body(self, body: RigidBody) -> RigidBody:
        a, b, c, d, e, f = (part / self.mass for part in body.inertia)
        coordinates = tuple(map(self._coordinate, body.coordinates))
        return replace(body, mass=body.mass / self.mass, inertia=(a, b, c, d, e, f), coordinates=coordinates)

    def _coordinate(self, coordinate: Coordinate) -> Coordinate:
        return replace(coordinate, speed=coordinate.speed * self.time)

    def _line_law(self, law: LineLaw) -> LineLaw:
        match law:
            case Inextensible():
                return replace(law, reel=law.reel * self.time)
            case Elastic():
                damping = law.damping / (self.force * self.time)
                return replace(law, stiffness=law.stiffness / self.force, damping=damping)
            case ConstantTension():
                return replace(law, force=law.force / self.force)
            case _:
                return law

    def _attraction(self, pair: Attraction) -> Attraction:
        return replace(pair, constant=pair.constant * self.mass**2 / self.force)

    def _burn(self, burn: MassEjection) -> MassEjection:
        rate, exhaust = burn.rate * self.time / self.mass, burn.exhaust * self.time
        return replace(burn, rate=rate, exhaust=exhaust, until=burn.until / self.time)

    # ---- and back

    def convert_trace(self, trace: Trace, mechanism: Mechanism) -> Trace:
        """Return a motion of the converted mechanism, converted back to the units of the original `mechanism`."""

        def sample(at: Array) -> State:
            return self._state(trace.sample(at / self.time), mechanism, at)

        events = tuple(Event(event.time * self.time, event.kind, event.subjects) for event in trace.events)
        state = self._state(trace.state, mechanism, trace.state.times * self.time)
        return Trace(trace.engine, state, events, trace.stable_until * self.time, trace.cut, sample)

    def _state(self, state: State, mechanism: Mechanism, at: Array) -> State:
        def forces(by_name: Mapping[str, Array]) -> dict[str, Array]:
            return {name: values * self.force for name, values in by_name.items()}

        constraint_forces = (forces(state.constraint_tension), forces(state.normal), forces(state.friction))
        return State.of(
            mechanism, at, (state.q, state.v / self.time), Dynamics(state.a / self.time**2, *constraint_forces)
        )


@dataclass(frozen=True, slots=True)
class LawInUnits:
    """A force law, converted to other units of mass and time."""

    law: Law
    units: OwnUnits

    def force(self, place: Triple, velocity: Triple, time: Number, maths: Maths) -> Triple:
        """Return the force in the converted units."""
        units = self.units
        law_force = self.law.force(place, scale_triple(1.0 / units.time, velocity), time * units.time, maths)
        return scale_triple(1.0 / units.force, law_force)

    def potential(self, place: Triple, maths: Maths) -> Number | None:
        """Return the potential energy in the converted units; None if the law has none."""
        energy = self.law.potential(place, maths)
        return None if energy is None else energy * (1.0 / self.units.force)

    @property
    def constant(self) -> bool:
        """Return whether the force is constant."""
        return self.law.constant

    def moved(self, by: Vector) -> "LawInUnits":
        """Return this law with its origin translated."""
        return replace(self, law=self.law.moved(by))


def run_in_own_units(run: Callable[[Mechanism, Array], Trace], mechanism: Mechanism, at: Array) -> Trace:
    """Return the motion of a mechanism at times (m,), simulated by `run` in units suited to the mechanism."""
    units = OwnUnits.for_motion(mechanism, float(at[-1]))
    return units.convert_trace(run(units.convert_mechanism(mechanism), at / units.time), mechanism)
