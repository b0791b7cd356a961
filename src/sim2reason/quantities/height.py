"""The height of a body above the ground, in scenes with a ground, and above its starting point."""

from math import inf

import numpy as np

from sim2reason.dsl.mechanism import ZERO, Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.quantities import Quantity, quantity
from sim2reason.quantities.kinematics import Displacement
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.quantities.subjects.paths import center_path

UPRIGHT = 1.0 - 1e-9


@quantity
class Height(Quantity):
    """The height of a flying body above the ground; used only in structured questions, and never drawn."""

    name, unit, symbol = "height above the ground", "m", "h"
    of = Bodies()
    floor = 0.1

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the height of a body above the ground in m, (n,)."""
        mechanism = state.mechanism
        number = _falling(mechanism, subject)
        if number is not None:
            return state.q[:, number] - mechanism.coordinates[number].lower
        gap = next(met for met in mechanism.meetings if met.a is None and met.names == (subject,))
        return state.vector(state.frames.center(subject).place) @ np.array(gap.normal) - gap.distance

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body falls to the ground or bounces off the ground."""
        return _falling(mechanism, name) is not None or _bounces(mechanism, name)


@quantity
class HeightAboveStart(Quantity):
    """The height of a body above its starting point; used in structured questions only, never drawn by recipes."""

    name, unit, symbol = "height above the start", "m", "h"
    of = Bodies()
    drawn_by_recipes = False
    floor = 0.1

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the vertical displacement of the centre of mass in m, (n,)."""
        return Displacement.evaluate(state, subject)[:, 2]

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether there is gravity and the body can move up or down."""
        return mechanism.gravity != ZERO and center_path(mechanism, name).rises


def _falling(mechanism: Mechanism, name: str) -> int | None:
    """Return the number of the vertical coordinate along which a body falls to the ground; None if there is none."""
    for coordinate in mechanism.body[name].coordinates:
        if coordinate.kind == "slide" and coordinate.axis[2] > UPRIGHT and coordinate.lower > -inf:
            return mechanism.number[coordinate.name]
    return None


def _bounces(mechanism: Mechanism, name: str) -> bool:
    met = (gap for gap in mechanism.meetings if gap.a is None and gap.names == (name,))
    return any(gap.normal is not None and gap.normal[2] > UPRIGHT for gap in met)
