"""Coordinates of bodies on the axes of the text, where the text states where a body starts; never drawn by recipes."""

from typing import ClassVar

import numpy as np

from sim2reason.dsl.mechanism import Coordinate, Mechanism, X, Y
from sim2reason.dsl.state import Array, State
from sim2reason.quantities import Quantity, quantity
from sim2reason.quantities.subjects import Sense
from sim2reason.quantities.subjects.bodies import Bodies


def stated_on(axis: str, mechanism: Mechanism, name: str) -> Coordinate | None:
    """Return the coordinate along which a body moves on an axis of the text; None if the text states no start there."""
    found = mechanism.body[name].coordinates if name in mechanism.body else ()
    return next((each for each in found if each.stated is not None and each.stated[0] == axis), None)


def _place(axis: str, state: State, name: str) -> Array:
    """Return a body's coordinate on an axis in m, (n,): the one at the start plus the displacement."""
    found = stated_on(axis, state.mechanism, name)
    assert found is not None
    assert found.stated is not None
    return np.asarray(found.stated[1] + state.q[:, state.mechanism.number[found.name]])


class AxisCoordinate(Quantity):
    """Base class of the coordinates of a body along one axis of the text.

    Class data:
        axis: the name of the axis.
    """

    axis: ClassVar[str]
    unit, of = "m", Bodies()
    drawn_by_recipes = False
    floor = 0.1

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the text states where on the axis the body starts."""
        return stated_on(self.axis, mechanism, name) is not None


@quantity
class XCoordinate(AxisCoordinate):
    """The x coordinate of a body whose x coordinate at the start the text states."""

    name, symbol = "x coordinate", "x"
    axis = "x"
    sense = Sense("along the x axis", X, "x", fixed=True)

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return x in m, (n,)."""
        return _place("x", state, subject)


@quantity
class YCoordinate(AxisCoordinate):
    """The y coordinate of a body whose y coordinate at the start the text states."""

    name, symbol = "y coordinate", "y"
    axis = "y"
    sense = Sense("along the y axis", Y, "y", fixed=True)

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return y in m, (n,)."""
        return _place("y", state, subject)


@quantity
class OriginDistance(Quantity):
    """The distance of a body from the origin of the axes on which the text states where the body starts."""

    name, unit, symbol = "distance from the origin", "m", "r"
    of = Bodies()
    drawn_by_recipes = False
    floor = 0.1

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the distance in m, (n,)."""
        axes = [each.stated[0] for each in state.mechanism.body[subject].coordinates if each.stated is not None]
        return np.linalg.norm([_place(axis, state, subject) for axis in axes], axis=0)

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the text states all coordinates at the start."""
        found = mechanism.body[name].coordinates
        return bool(found) and all(each.stated is not None for each in found)
