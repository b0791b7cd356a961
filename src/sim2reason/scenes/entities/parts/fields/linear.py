"""Fields that are linear functions of a coordinate."""

from collections.abc import Mapping
from math import sqrt
from typing import Annotated, Literal, Self

import numpy as np
from annotated_types import Le
from pydantic import model_validator

from sim2reason.scenes.authoring import LEAST, Law, Magnetic, Measure, Profile, Push, Range, either
from sim2reason.scenes.entities.parts.fields import (
    AXES,
    CHANGING,
    Direction,
    ElectricAtFirst,
    ElectricField,
    MagneticAtFirst,
    MagneticField,
    Trend,
    along,
    force_field,
)

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
        return Push(along(self.way), Profile(charge * self.strength, charge * self.signed, AXES[self.axis]))

    def rate(self, charge: float, mass: float) -> float:
        """Return √(qk/m), 1/s, for an oscillation, or twice that for an exponentially growing motion."""
        return (1.0 if self.drives_back(charge) else 2.0) * sqrt(abs(charge) * self.slope / mass)

    def drives_back(self, charge: float) -> bool:
        """Return whether the force drives a charge, uC, towards the zero of the field."""
        return charge * self.signed * along(self.way)["xy".index(self.axis)] < 0.0


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
        return Magnetic(along(self.way), Profile(charge * self.strength, charge * slope, AXES[self.axis]))

    def rate(self, charge: float, mass: float) -> float:
        """Return the cyclotron frequency at the origin, rad/s."""
        return abs(charge) * self.strength / mass
