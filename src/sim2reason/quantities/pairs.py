"""How two bodies stand and move relative to each other."""

from itertools import permutations

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.dsl.triples import minus, product
from sim2reason.quantities import Quantity, quantity
from sim2reason.quantities.kinematics import Velocity
from sim2reason.quantities.subjects.bodies import moves, moves_in_plane
from sim2reason.quantities.subjects.pairs import AND, Pairs, members
from sim2reason.quantities.subjects.relative import RelativeBodies


@quantity
class DistanceBetween(Quantity):
    """The distance of two centres of mass."""

    name, unit, symbol = "distance", "m", "d"
    of = Pairs()
    magnitude = "the distance between {pair}"
    how = "how far apart are {pair} {when}?"
    indirect = "how far apart {pair} are"
    given = center = True
    floor = 0.1
    panel, order = "distance", 0

    def subjects(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the names of the pairs, and of any other two bodies that move freely in a plane, in either order."""
        free = [body.name for body in mechanism.bodies if moves_in_plane(mechanism, body.name)]
        return tuple(dict.fromkeys((*self.of.names(mechanism), *(AND.join(two) for two in permutations(free, 2)))))

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """|r − r′|, (n,)."""
        a, b = members(subject)
        apart = minus(state.frames.center(a).place, state.frames.center(b).place)
        return np.sqrt(product(apart, apart)) + 0.0 * state.times


@quantity
class RelativeSpeed(Quantity):
    """The speed of two bodies relative to each other."""

    name, unit, symbol = "relative speed", "m/s", "w"
    of = Pairs()
    magnitude = "the relative speed of {pair}"
    given = True
    weight = 0.6
    floor, least = 0.1, 1e-2
    order = 1

    def present(self, mechanism: Mechanism, name: str) -> bool:
        """Whether both move: else it is the speed of the one that does."""
        return all(moves(mechanism, body) for body in members(name))

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """|v − v′|, (n,)."""
        a, b = members(subject)
        return np.linalg.norm(Velocity.evaluate(state, a) - Velocity.evaluate(state, b), axis=1)


@quantity
class RelativeVelocity(Quantity):
    """The velocity of the centre of mass of one body relative to that of another; never drawn."""

    name, unit, symbol = "relative velocity", "m/s", "u"
    of, vector = RelativeBodies(), True
    given = True
    drawn_by_recipes = False
    floor, least = 0.1, 1e-2
    order = 2

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return v − v′ in m/s, (n, 3)."""
        a, b = members(subject)
        return Velocity.evaluate(state, a) - Velocity.evaluate(state, b)
