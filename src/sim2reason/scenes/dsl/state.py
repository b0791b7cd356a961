"""The motion of a mechanism as arrays over time, common to all engines."""

from collections.abc import Callable, Mapping
from dataclasses import field
from itertools import pairwise
from typing import NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from sim2reason.base.lazy import cached_property
from sim2reason.base.record import counted, record
from sim2reason.scenes.dsl.frames import Frames, initial_frames
from sim2reason.scenes.dsl.mechanism import ConstantTension, Elastic, Line, Mechanism
from sim2reason.scenes.dsl.vectors import Triple, dot, minus

Array = NDArray[np.float64]


class Dynamics(NamedTuple):
    """Accelerations and constraint forces at n instants."""

    a: Array
    constraint_tension: Mapping[str, Array]
    normal: Mapping[str, Array]
    friction: Mapping[str, Array]


@record()
class State:
    """The motion of a mechanism at n instants.

    Positions and forces are evaluated when they are first read. At the time of an event the values are those just after
    it. A force that the mechanism does not determine, as with three supports or two unknown frictions, is NaN; all
    other values are finite.

    Attributes:
        mechanism: The mechanism.
        times: The instants (n,), s.
        kinematics: Function that returns q and v.
        dynamics: Function of q and v that returns accelerations and forces.
        q: Coordinates (n, number of coordinates), m or rad, in the order of `mechanism.coordinates`.
        v: Rates of the coordinates, m/s or rad/s.
        a: Accelerations, m/s² or rad/s².
        constraint_tension: Tensions (n,) of lines that give equations, N, by line.
        normal: Normal forces (n,), N, by the body that rests.
        friction: Forces of friction (n,), N, by the body that rests.
        tension: Tensions (n,) of all lines, N, by line.
        frames: Positions and velocities of all parts.
        began: Positions of all parts at the start.
        known: Quantities evaluated so far, by quantity and subject.
    """

    mechanism: Mechanism
    times: Array  # s, (n,)
    kinematics: Callable[[], tuple[Array, Array]] = field(repr=False)  # gives q and v
    dynamics: Callable[[Array, Array], Dynamics] = field(repr=False)  # of q and v

    def __repr__(self) -> str:
        """Return the number of coordinates and of instants, and the first and the last instant."""
        count, unit = counted(len(self.mechanism.coordinates), "coordinate"), self.mechanism.units.time
        span = f", {self.times[0]:g} to {self.times[-1]:g} {unit}" if len(self.times) else ""
        return f"<State: {count} at {counted(len(self.times), 'instant')}{span}>"

    @classmethod
    def of(cls, mechanism: Mechanism, times: Array, kinematics: tuple[Array, Array], dynamics: Dynamics) -> Self:
        """Return a state whose coordinates, accelerations and forces are known already."""
        return cls(mechanism, times, lambda: kinematics, lambda _, __: dynamics)

    @cached_property
    def _kinematics(self) -> tuple[Array, Array]:
        return self.kinematics()

    @cached_property
    def _dynamics(self) -> Dynamics:
        return self.dynamics(*self._kinematics)

    @property
    def q(self) -> Array:
        """Return the coordinates, m or rad, (n, number of coordinates)."""
        return self._kinematics[0]

    @property
    def v(self) -> Array:
        """Return the rates of the coordinates, m/s or rad/s, (n, number of coordinates)."""
        return self._kinematics[1]

    @property
    def a(self) -> Array:
        """Return the accelerations, m/s² or rad/s², (n, number of coordinates)."""
        return self._dynamics.a

    @property
    def constraint_tension(self) -> Mapping[str, Array]:
        """Return the tension, N, of each line that gives a constraint equation; negative for a rod that pushes."""
        return self._dynamics.constraint_tension

    @property
    def normal(self) -> Mapping[str, Array]:
        """Return the normal force, N, on each body on a face; negative only on faces that hold in both directions."""
        return self._dynamics.normal

    @property
    def friction(self) -> Mapping[str, Array]:
        """Return the friction force, N, on each body on a face, positive along its slip."""
        return self._dynamics.friction

    @cached_property
    def frames(self) -> Frames:
        """Return the positions of all parts: components are arrays (n,), or floats if they never change."""
        return Frames(self.mechanism, list(self.q.T), list(self.v.T), np)

    @cached_property
    def began(self) -> Frames:
        """Return the positions of all parts at the start."""
        return initial_frames(self.mechanism)

    @cached_property
    def known(self) -> "dict[tuple[str, str], Array]":
        """Return the cached values of quantities, by quantity and subject, from which other quantities are computed."""
        return {}

    @cached_property
    def tension(self) -> Mapping[str, Array]:
        """Return the tension, N, of each line, (n,); negative for a rod or a spring that pushes."""
        given = [line for line in self.mechanism.lines if not line.law.row]
        return {**self.constraint_tension, **{line.name: self._given(line) for line in given}}

    def _given(self, line: Line) -> Array:
        law = line.law
        if isinstance(law, ConstantTension):
            return np.full(len(self.times), law.force)
        assert isinstance(law, Elastic)
        length, rate = self.free_length(line)
        tension = law.stiffness * (length - law.length) + law.damping * rate
        return np.where(law.side * tension >= 0.0, tension, 0.0)

    def mass(self, body: str) -> Array | float:
        """Return the mass of a body; for a body that burns, the remaining mass at each instant, (n,)."""
        found: Array | float = self.mechanism.body[body].mass
        for burn in self.mechanism.burns:
            if burn.body == body:
                found = found - burn.rate * np.minimum(self.times, burn.until)
        return found

    def vector(self, components: Triple) -> Array:
        """Return three components as one array, (n, 3)."""
        found = np.empty((len(self.times), 3))
        for number, part in enumerate(components):
            found[:, number] = part
        return found

    def length(self, line: Line) -> tuple[Array, Array]:
        """Return the total distance between the sites of a line, m, and its rate, m/s; both (n,).

        Where two sites coincide, the rate of their distance is undefined and 0 is used.
        """
        length, rate = np.zeros(len(self.times)), np.zeros(len(self.times))
        for first, last in pairwise(line.through):
            one, other = self.frames.site(first), self.frames.site(last)
            apart = minus(other.place, one.place)
            parting = minus(other.velocity, one.velocity)
            distance = np.sqrt(dot(apart, apart)) + length * 0.0
            length = length + distance
            rate = rate + dot(apart, parting) / np.where(distance > 0.0, distance, 1.0)
        return length, rate

    def free_length(self, line: Line) -> tuple[Array, Array]:
        """Return the length of a line including the length unwound from its wheels, m, and its rate, m/s; both (n,)."""
        length, rate = self.length(line)
        for wheel in line.wheels:
            number = self.mechanism.number[wheel.coordinate]
            length, rate = length + wheel.radius * self.q[:, number], rate + wheel.radius * self.v[:, number]
        return length, rate
