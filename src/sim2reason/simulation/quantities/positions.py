"""Heights, coordinates and inclinations."""

from math import degrees, inf
from typing import ClassVar

import numpy as np

from sim2reason.scenes.dsl.frames import Frames, initial_frames
from sim2reason.scenes.dsl.mechanism import ZERO, Coordinate, Inextensible, Mechanism, X, Y
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.scenes.dsl.vectors import cross, dot, subtract_triples, unit
from sim2reason.simulation.quantities import Quantity, quantity
from sim2reason.simulation.quantities.kinematics import Displacement
from sim2reason.simulation.quantities.subjects import Sense
from sim2reason.simulation.quantities.subjects.bodies import Bodies, center_path
from sim2reason.simulation.quantities.subjects.rotating_parts import SwingingLines, pointer


def stated_coordinate(axis: str, mechanism: Mechanism, name: str) -> Coordinate | None:
    """Return the coordinate of a body along an axis of the text; None if the text states no initial value."""
    coordinates = mechanism.body[name].coordinates if name in mechanism.body else ()
    return next((each for each in coordinates if each.stated is not None and each.stated[0] == axis), None)


def _axis_position(axis: str, state: State, name: str) -> Array:
    """Return the position of a body on an axis in m, (n,): initial value plus displacement."""
    coordinate = stated_coordinate(axis, state.mechanism, name)
    assert coordinate is not None
    assert coordinate.stated is not None
    return np.asarray(coordinate.stated[1] + state.q[:, state.mechanism.number[coordinate.name]])


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
        return stated_coordinate(self.axis, mechanism, name) is not None


@quantity
class XCoordinate(AxisCoordinate):
    """The x coordinate of a body, if the text states its initial x coordinate."""

    name, symbol = "x coordinate", "x"
    axis = "x"
    sense = Sense("along the x axis", X, "x", fixed=True)

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return x in m, (n,)."""
        return _axis_position("x", state, subject)


@quantity
class YCoordinate(AxisCoordinate):
    """The y coordinate of a body, if the text states its initial y coordinate."""

    name, symbol = "y coordinate", "y"
    axis = "y"
    sense = Sense("along the y axis", Y, "y", fixed=True)

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return y in m, (n,)."""
        return _axis_position("y", state, subject)


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
        return np.linalg.norm([_axis_position(axis, state, subject) for axis in axes], axis=0)

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the text states all coordinates at the start."""
        coordinates = mechanism.body[name].coordinates
        return bool(coordinates) and all(each.stated is not None for each in coordinates)


VERTICAL_COSINE = 1.0 - 1e-9  # vertical component of a direction that counts as vertical


@quantity
class Height(Quantity):
    """The height of a flying body above the ground; for structured questions only, not drawn by recipes."""

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


def height_at_start(mechanism: Mechanism, name: str) -> float:
    """Return the height above the ground, in m, at which a body that falls to the ground or bounces off it starts."""
    number = _falling(mechanism, name)
    if number is not None:
        return -mechanism.coordinates[number].lower
    gap = next(met for met in mechanism.meetings if met.a is None and met.names == (name,))
    assert gap.normal is not None
    return float(dot(initial_frames(mechanism).center(name).place, gap.normal)) - gap.distance


def _falling(mechanism: Mechanism, name: str) -> int | None:
    """Return the index of the vertical coordinate along which a body falls to the ground; None if there is none."""
    for coordinate in mechanism.body[name].coordinates:
        if coordinate.kind == "slide" and coordinate.axis[2] > VERTICAL_COSINE and coordinate.lower > -inf:
            return mechanism.number[coordinate.name]
    return None


def _bounces(mechanism: Mechanism, name: str) -> bool:
    met = (gap for gap in mechanism.meetings if gap.a is None and gap.names == (name,))
    return any(gap.normal is not None and gap.normal[2] > VERTICAL_COSINE for gap in met)


SLACK_RTOL = 1e-6  # fraction of its length: a string that is shorter by more is slack


@quantity
class Deflection(Quantity):
    """The angle of a string or rod, or of the line from an axle to a centre of mass, with the downward vertical."""

    name, unit, symbol = "deflection", "deg", "θ"
    of = SwingingLines()
    magnitude = "the angle that {line} makes with the downward vertical"
    how = "what angle does {line} make with the downward vertical {when}?"
    given = True
    weight = 3.0
    floor, least = 1.0, 0.1
    panel, order = "angle with the vertical", 0

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the angle in degrees, 0 to 180, (n,); NaN while a string is slack."""
        return np.where(_slack(state, subject), np.nan, _angle(state.frames, state.mechanism, subject))


def deflection_at_start(state: State, subject: str) -> float:
    """Return the angle at the start of the motion, in degrees."""
    return float(_angle(state.began, state.mechanism, subject))


def _angle(frames: Frames, mechanism: Mechanism, subject: str) -> Array:
    """Return the angle in degrees from sine and cosine, so that small angles keep their accuracy."""
    (top, start), (bottom, end) = pointer(mechanism, subject)
    arm = subtract_triples(frames[bottom].point(end).place, frames[top].point(start).place)
    down = unit(mechanism.gravity)
    across = cross(down, arm)
    return degrees(1.0) * np.arctan2(np.sqrt(dot(across, across)), dot(down, arm))


def _slack(state: State, subject: str) -> Array:
    """Return whether a string is slack, (n,): shorter than its limit."""
    line = state.mechanism.line.get(subject)
    if line is None or not isinstance(line.law, Inextensible):
        return np.zeros(len(state.times), dtype=bool)
    full_length = state.began.length(line) + line.law.slack - line.law.reel * state.times
    return state.length(line)[0] < full_length * (1.0 - SLACK_RTOL)
