"""What a motion looks like to whoever reads it: arrays over time, the same from every engine."""

from collections.abc import Callable, Mapping
from dataclasses import field
from itertools import pairwise
from typing import NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from sim2reason.dsl.frames import Frames, start
from sim2reason.dsl.mechanism import ConstantTension, Elastic, Line, Mechanism
from sim2reason.dsl.triples import Triple, minus, product
from sim2reason.lazy import cached_property
from sim2reason.record import counted, record

Array = NDArray[np.float64]


class Dynamics(NamedTuple):
    """What forces do at n instants."""

    a: Array
    constraint_tension: Mapping[str, Array]
    normal: Mapping[str, Array]
    friction: Mapping[str, Array]


@record()
class State:
    """The motion of a mechanism at n instants.

    `q`, `v`, `a` have the shape (n, number of coordinates), in the order of `mechanism.coordinates`.
    At an instant of an event the values are those just after it. A force that the mechanism does not
    determine (three supports, two unknown frictions) is NaN; everything else is finite.

    All is read off a motion when it is asked for: many look at places alone, at whose instants forces cost the most.
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
        """What is known already."""
        return cls(mechanism, times, lambda: kinematics, lambda _, __: dynamics)

    @cached_property
    def _kinematics(self) -> tuple[Array, Array]:
        return self.kinematics()

    @cached_property
    def _dynamics(self) -> Dynamics:
        return self.dynamics(*self._kinematics)

    @property
    def q(self) -> Array:
        """Coordinates, m or rad."""
        return self._kinematics[0]

    @property
    def v(self) -> Array:
        """Their rates."""
        return self._kinematics[1]

    @property
    def a(self) -> Array:
        """The rates of these."""
        return self._dynamics.a

    @property
    def constraint_tension(self) -> Mapping[str, Array]:
        """By line that gives an equation, N; of a rod negative where it pushes."""
        return self._dynamics.constraint_tension

    @property
    def normal(self) -> Mapping[str, Array]:
        """By the body that rests, N, ≥ 0 unless its face holds both ways."""
        return self._dynamics.normal

    @property
    def friction(self) -> Mapping[str, Array]:
        """By the body that rests, N, on that body, positive along its slip."""
        return self._dynamics.friction

    @cached_property
    def frames(self) -> Frames:
        """Where the parts are at all instants: components are arrays (n,), or floats where they never change."""
        return Frames(self.mechanism, list(self.q.T), list(self.v.T), np)

    @cached_property
    def began(self) -> Frames:
        """Where the parts were at the start."""
        return start(self.mechanism)

    @cached_property
    def known(self) -> "dict[tuple[str, str], Array]":
        """What quantities have been read off it, by quantity and subject, for those that build on them."""
        return {}

    @cached_property
    def tension(self) -> Mapping[str, Array]:
        """By line, N; of a rod or a spring negative where it pushes. Springs and hands give theirs by their own law."""
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
        """The mass of a body: of one that burns, what is left at each instant, (n,)."""
        found: Array | float = self.mechanism.body[body].mass
        for burn in self.mechanism.burns:
            if burn.body == body:
                found = found - burn.rate * np.minimum(self.times, burn.until)
        return found

    def vector(self, components: Triple) -> Array:
        """Three components as one array, (n, 3)."""
        found = np.empty((len(self.times), 3))
        for number, part in enumerate(components):
            found[:, number] = part
        return found

    def length(self, line: Line) -> tuple[Array, Array]:
        """The sum of the distances between the sites of a line, m, and its rate, m/s; both (n,).

        Where two sites coincide their distance has no rate, and 0 stands for it.
        """
        length, rate = np.zeros(len(self.times)), np.zeros(len(self.times))
        for first, last in pairwise(line.through):
            one, other = self.frames.site(first), self.frames.site(last)
            apart = minus(other.place, one.place)
            parting = minus(other.velocity, one.velocity)
            distance = np.sqrt(product(apart, apart)) + length * 0.0
            length = length + distance
            rate = rate + product(apart, parting) / np.where(distance > 0.0, distance, 1.0)
        return length, rate

    def free_length(self, line: Line) -> tuple[Array, Array]:
        """The length of a line with what its wheels give out, m, and its rate, m/s; both (n,)."""
        length, rate = self.length(line)
        for wheel in line.wheels:
            number = self.mechanism.number[wheel.coordinate]
            length, rate = length + wheel.radius * self.q[:, number], rate + wheel.radius * self.v[:, number]
        return length, rate
