"""Fields that act on a charged bead in the x-y plane: uniform and linear fields, and drag."""

from collections.abc import Mapping
from math import sqrt
from typing import Annotated, Literal, Self, TypeVar

import numpy as np
from annotated_types import Ge, Le
from pydantic import model_validator

from sim2reason.base.registry import Registry
from sim2reason.scenes.authoring import (
    LEAST,
    Law,
    Magnetic,
    Measure,
    Part,
    Profile,
    Push,
    Range,
    Resistance,
    Vector,
    Word,
    X,
    Y,
    Z,
    either,
    scale,
)
from sim2reason.scenes.dsl.model import Model

ElectricStrength = Annotated[
    float, LEAST, Le(1e9), Measure("electric field", "N/C", "E", called="strength"), Range(0.4, 2.0)
]
MagneticStrength = Annotated[
    float, Ge(1e-12), Le(1e6), Measure("magnetic field", "T", "B", called="strength"), Range(0.4, 1.2)
]
Direction = Literal["positive x", "negative x", "positive y", "negative y"]
Trend = Literal["increases", "decreases"]
AXES: Mapping[str, Vector] = {"x": X, "y": Y, "z": Z}
ElectricAtFirst = Annotated[
    float, LEAST, Le(1e9), Measure("field strength", "N/C", "E", called="magnitude"), Range(0.4, 2.0)
]
MagneticAtFirst = Annotated[
    float, Ge(1e-12), Le(1e6), Measure("field strength", "T", "B", called="magnitude"), Range(0.4, 1.2)
]
"""Ranges for fields that have this strength only at one time or position."""


class ForceField(Part):
    """Base class of fields. A kind outside the classes below may have a base of its own, with a field of an entity."""

    @classmethod
    def variants(cls) -> tuple[type[Model], ...]:
        """Return the fields that are registered under this base."""
        return tuple(kind for kind in FIELDS.values() if issubclass(kind, cls))

    def law(self, charge: float) -> Law:
        """Return the force law for a charge, uC; forces in uN, positions in m and times in s."""
        raise NotImplementedError

    def rate(self, charge: float, mass: float) -> float:
        """Return the rate of rotation, oscillation, decay or acceleration of a bead, 1/s; 0 without a time scale."""
        del charge, mass
        return 0.0


F = TypeVar("F", bound=ForceField)
FIELDS: Registry[type[ForceField]] = Registry("entities.parts.fields", package="sim2reason.scenes.entities")


def force_field(cls: type[F]) -> type[F]:
    """Register a field under the name of its class."""
    return FIELDS.add(cls.__name__, cls)


class ElectricField(ForceField):
    """An electric field in the plane of the motion."""

    called = "the electric field"


class MagneticField(ForceField):
    """A magnetic field square to the plane of the motion."""

    called = "the magnetic field"


class Medium(ForceField):
    """Base class of media that resist the motion."""

    called = "the medium"


_WAYS = [f"{side} {axis}" for axis in AXES for side in ("positive", "negative")]
_TURNED: Mapping[str, str] = {"increases": "decreases", "decreases": "increases"}


def _trend_word(trend: str) -> Word:
    """Return the word for the trend of a field's component along an axis, given the trend along the field."""
    return Word("way", {way: trend if way.startswith("positive") else _TURNED[trend] for way in _WAYS})


CHANGING: dict[str, Word] = {
    "direction": Word("way", {way: f"the {way} direction" for way in _WAYS}),
    "line": Word("way", {way: f"the {way[-1]} axis" for way in _WAYS}),
    "component": Word("way", {way: f"{way[-1]} component" for way in _WAYS}),
    "growing": _trend_word("increases"),
    "fading": _trend_word("decreases"),
    "changes": Word("trend", {"increases": "{growing}", "decreases": "{fading}"}),
}
"""The words for the axis and the trend of a field's component, so that texts avoid components along negative axes.
component, and what that does, so that no text speaks of a component in a negative direction."""


def direction_vector(way: str) -> Vector:
    """Return the unit vector of a direction given in words."""
    side, axis = way.split()
    return scale(1.0 if side == "positive" else -1.0, AXES[axis])


@force_field
class UniformElectric(ElectricField):
    """The same strength and direction everywhere."""

    strength: ElectricStrength
    way: Direction

    says = (
        either(
            "a uniform electric field of strength {strength} points in the {way} direction.",
            "a uniform electric field, whose strength is {strength}, is directed along the {way} direction.",
            "there is a uniform electric field of strength {strength} in the {way} direction.",
        ),
    )

    def law(self, charge: float) -> Law:
        """Return the force law F = qE."""
        return Push(direction_vector(self.way), Profile(charge * self.strength))


@force_field
class UniformMagnetic(MagneticField):
    """Square to the plane of the motion."""

    strength: MagneticStrength
    way: Literal["positive z", "negative z"]

    says = (
        either(
            "a uniform magnetic field of strength {strength} points in the {way} direction.",
            "a uniform magnetic field, whose strength is {strength}, is directed along the {way} direction.",
            "there is a uniform magnetic field of strength {strength} in the {way} direction.",
        ),
    )

    def law(self, charge: float) -> Law:
        """Return the force law F = q v × B."""
        return Magnetic(direction_vector(self.way), Profile(charge * self.strength))

    def rate(self, charge: float, mass: float) -> float:
        """Return the cyclotron frequency |q|B/m."""
        return abs(charge) * self.strength / mass


ElectricGradient = Annotated[float, LEAST, Le(1e6), Measure("gradient", "N/(C m)", "k"), Range(0.2, 1.2)]


@force_field
class LinearElectric(ElectricField):
    """One direction, and a strength that is a linear function of the coordinate along it, as charges can cause it.

    The `trend` is that of its component in the direction that it has at the origin.
    """

    strength: ElectricAtFirst
    way: Direction
    trend: Trend
    axis: Literal["x", "y"]
    slope: ElectricGradient

    words = CHANGING
    says = (
        either(
            "an electric field is everywhere parallel to {line}; at {axis} = 0 it has magnitude {strength} and points in {direction}, and its {component} {changes} with {axis} at a rate of {slope}.",
            "there is an electric field parallel to {line}, whose {component} {changes} with {axis} at a rate of {slope}; at {axis} = 0 the field has magnitude {strength} and points in {direction}.",
            "the lines of an electric field are parallel to {line}; at {axis} = 0 the field points in {direction} and has magnitude {strength}, and its {component} {changes} with {axis} at a rate of {slope}.",
        ),
    )

    @model_validator(mode="after")
    def _has_no_curl(self) -> Self:
        if not self.way.endswith(self.axis):
            raise ValueError("axis: a field at rest does not change across its direction; give the axis of way")
        return self

    @classmethod
    def fitted(cls, drawn: Mapping[str, object], rng: np.random.Generator) -> Mapping[str, object]:
        """Return the axis along which the strength changes, made parallel to the drawn direction of the field."""
        del rng
        return {"axis": str(drawn["way"])[-1]}

    @property
    def signed(self) -> float:
        """Return the signed gradient of the field along the axis, N/(C m)."""
        return self.slope if self.trend == "increases" else -self.slope

    def law(self, charge: float) -> Law:
        """Return the force law F = q (E₀ + k s) along one direction."""
        return Push(direction_vector(self.way), Profile(charge * self.strength, charge * self.signed, AXES[self.axis]))

    def rate(self, charge: float, mass: float) -> float:
        """Return √(qk/m), 1/s, for an oscillation, or twice that for an exponentially growing motion."""
        return (1.0 if self.drives_back(charge) else 2.0) * sqrt(abs(charge) * self.slope / mass)

    def drives_back(self, charge: float) -> bool:
        """Return whether the force drives a charge, uC, towards the zero of the field."""
        return charge * self.signed * direction_vector(self.way)["xy".index(self.axis)] < 0.0


MagneticGradient = Annotated[float, LEAST, Le(1e6), Measure("gradient", "T/m", r"\beta"), Range(0.05, 0.5)]


@force_field
class LinearMagnetic(MagneticField):
    """Square to the plane, and as strong as a linear function of x or of y says.

    The `trend` is that of its component in the direction that it has at the origin.
    """

    strength: MagneticAtFirst
    way: Literal["positive z", "negative z"]
    trend: Trend
    axis: Literal["x", "y"]
    slope: MagneticGradient

    words = CHANGING
    says = (
        either(
            "a magnetic field is everywhere parallel to {line}; at {axis} = 0 it has magnitude {strength} and points in {direction}, and its {component} {changes} with {axis} at a rate of {slope}.",
            "there is a magnetic field parallel to {line}, whose {component} {changes} with {axis} at a rate of {slope}; at {axis} = 0 the field has magnitude {strength} and points in {direction}.",
            "the lines of a magnetic field are parallel to {line}; at {axis} = 0 the field points in {direction} and has magnitude {strength}, and its {component} {changes} with {axis} at a rate of {slope}.",
        ),
    )

    def law(self, charge: float) -> Law:
        """Return the force law F = q v × B, with B = B₀ + βs."""
        slope = self.slope if self.trend == "increases" else -self.slope
        return Magnetic(direction_vector(self.way), Profile(charge * self.strength, charge * slope, AXES[self.axis]))

    def rate(self, charge: float, mass: float) -> float:
        """Return the cyclotron frequency at the origin, rad/s."""
        return abs(charge) * self.strength / mass


Drag = Annotated[float, LEAST, Le(1e6), Measure("drag", "uN s/m", "b", called="constant"), Range(0.1, 1.0)]


@force_field
class LinearDrag(Medium):
    """A force −bv."""

    coefficient: Drag

    says = (
        either(
            "a medium resists the motion with a force proportional to the speed, with the constant of proportionality {coefficient}.",
            "a medium exerts a drag force proportional to the speed; the constant of proportionality is {coefficient}.",
            "the drag force of a medium is proportional to the speed, the constant of proportionality being {coefficient}.",
        ),
    )

    def law(self, charge: float) -> Law:
        """Return the force law F = −bv."""
        del charge
        return Resistance(linear=self.coefficient)

    def rate(self, charge: float, mass: float) -> float:
        """Return the decay rate of the speed, 1/s."""
        del charge
        return self.coefficient / mass


SquareDrag = Annotated[float, LEAST, Le(1e6), Measure("drag", "uN s^2/m^2", "c", called="constant"), Range(0.1, 0.5)]


@force_field
class QuadraticDrag(Medium):
    """A force −c|v|v."""

    coefficient: SquareDrag

    says = (
        either(
            "a medium resists the motion with a force proportional to the square of the speed, with the constant of proportionality {coefficient}.",
            "a medium exerts a drag force proportional to the square of the speed; the constant of proportionality is {coefficient}.",
            "the drag force of a medium is proportional to the square of the speed, the constant of proportionality being {coefficient}.",
        ),
    )

    def law(self, charge: float) -> Law:
        """Return the force law F = −c|v|v."""
        del charge
        return Resistance(quadratic=self.coefficient)
