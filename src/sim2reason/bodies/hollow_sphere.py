"""Hollow spheres: with a wall of any thickness, or with one too thin to matter."""

from collections.abc import Mapping
from typing import Self

from pydantic import model_validator

from sim2reason.dsl.body import body
from sim2reason.dsl.looks import THIN, Spherical
from sim2reason.dsl.shape import Overlooked, Radius, Shape, Thickness
from sim2reason.dsl.solids import Solid, ball, sphere_surface


@body
class SphericalShell(Shape):
    """A thin spherical shell."""

    radius: Radius

    nouns = ("shell",)
    lone = (
        "a thin spherical {noun} of radius {radius} and mass {mass}",
        "a uniform thin spherical {noun} of mass {mass} and radius {radius}",
    )
    named = (
        "a thin spherical {noun} {letter} of radius {radius} and mass {mass}",
        "a thin spherical {noun} {letter} (radius {radius}, mass {mass})",
    )

    @property
    def solid(self) -> Solid:
        """About its centre."""
        return sphere_surface(self.radius)

    @property
    def look(self) -> Spherical:
        """A ring, as if cut open."""
        return Spherical(self.radius, wall=THIN * self.radius)


@body
class HollowSphere(Shape):
    """A sphere with a concentric cavity."""

    radius: Radius
    thickness: Thickness

    bulky = True
    nouns = ("sphere",)
    lone = (
        "a hollow {noun} of outer radius {radius}, wall thickness {thickness} and mass {mass}",
        "a hollow {noun} of mass {mass} with an outer radius of {radius} and a wall thickness of {thickness}",
    )
    named = (
        "a hollow {noun} {letter} of outer radius {radius}, wall thickness {thickness} and mass {mass}",
        "a hollow {noun} {letter} (outer radius {radius}, wall thickness {thickness}, mass {mass})",
    )

    @model_validator(mode="after")
    def _has_a_cavity(self) -> Self:
        if self.thickness >= self.radius:
            raise ValueError("thickness: the wall is thicker than the sphere; give less than its radius")
        return self

    @property
    def solid(self) -> Solid:
        """One ball less another."""
        return ball(self.radius) - ball(self.radius - self.thickness)

    @property
    def plainer(self) -> Mapping[Overlooked, Solid]:
        """Return the same sphere with a thin wall: the moment of inertia is 2mR²/3."""
        return {"wall": sphere_surface(self.radius)}

    @property
    def look(self) -> Spherical:
        """A broad ring, as if cut open."""
        return Spherical(self.radius, wall=self.thickness)
