"""Round bodies that are homogeneous: discs, hoops, cylinders, pipes and spheres."""

from collections.abc import Mapping
from typing import Annotated, Self

from pydantic import model_validator

from sim2reason.scenes.dsl.body import THIN_WALL_RATIO, Axial, Spherical, body
from sim2reason.scenes.dsl.measures import LEAST, Measure, Range
from sim2reason.scenes.dsl.solids import (
    MAX_SIZE,
    Extent,
    Overlooked,
    Radius,
    Shape,
    Solid,
    Thickness,
    ball,
    cylinder,
    disc,
    ring,
    rod,
    sphere_surface,
)


def _introductions(first: str, second: str, lettered: str = "") -> tuple[tuple[str, str], tuple[str, str]]:
    """Return the templates that introduce a body by its radius and mass, without and with a letter.

    `first` and `second` are the adjectives of two wordings; the second wording with a letter has `lettered` if given.
    """
    size = "of radius {radius} and mass {mass}"
    lone = f"a {first} {{noun}} {size}", f"a {second} {{noun}} of mass {{mass}} and radius {{radius}}"
    named = (
        f"a {first} {{noun}} {{letter}} {size}",
        f"a {lettered or second} {{noun}} {{letter}} (radius {{radius}}, mass {{mass}})",
    )
    return lone, named


@body
class Cylinder(Shape):
    """A uniform solid cylinder about z."""

    radius: Radius
    height: Extent

    bulky = True
    nouns = ("cylinder",)
    lone = (
        "a uniform solid {noun} of radius {radius}, height {height} and mass {mass}",
        "a solid uniform {noun} of mass {mass} with a radius of {radius} and a height of {height}",
    )
    named = (
        "a uniform solid {noun} {letter} of radius {radius}, height {height} and mass {mass}",
        "a solid uniform {noun} {letter} (radius {radius}, height {height}, mass {mass})",
    )

    @property
    def solid(self) -> Solid:
        """Return the uniform mass distribution of the body, with the centre as origin."""
        return cylinder(self.radius, self.height)

    @property
    def plainer(self) -> Mapping[Overlooked, Solid]:
        """Return the simplified mass distributions, by overlooked detail: a thin rod, and a thin disc."""
        return {"section": rod(self.height), "height": disc(self.radius)}

    @property
    def look(self) -> Axial:
        """Return the drawn shape: a rectangle from the side, a disc from its end."""
        return Axial(self.radius, self.height)


@body
class Roller(Shape):
    """A uniform solid cylinder that only ever turns about its own axis, z."""

    radius: Radius

    nouns = ("cylinder", "roller")
    lone, named = _introductions("uniform solid", "solid uniform")

    @property
    def solid(self) -> Solid:
        """Return a disc, since the length has no effect on rotation about the axis."""
        return disc(self.radius)

    @property
    def look(self) -> Axial:
        """Return the drawn shape: a disc, seen from its end."""
        return Axial(self.radius)


@body
class Disc(Shape):
    """A uniform thin disc about z."""

    radius: Radius

    nouns = ("disc",)
    lone, named = _introductions("uniform thin", "thin uniform")

    @property
    def solid(self) -> Solid:
        """Return the uniform mass distribution of the body, with the centre as origin."""
        return disc(self.radius)

    @property
    def look(self) -> Axial:
        """Return the drawn shape: a disc, or a thick line from the side."""
        return Axial(self.radius)


@body
class SphericalShell(Shape):
    """A thin spherical shell."""

    radius: Radius

    nouns = ("shell",)
    lone, named = _introductions("thin spherical", "uniform thin spherical", "thin spherical")

    @property
    def solid(self) -> Solid:
        """Return the uniform mass distribution of the body, with the centre as origin."""
        return sphere_surface(self.radius)

    @property
    def look(self) -> Spherical:
        """Return the drawn shape: a ring, as if cut open."""
        return Spherical(self.radius, wall=THIN_WALL_RATIO * self.radius)


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
        """Return the difference of two balls."""
        return ball(self.radius) - ball(self.radius - self.thickness)

    @property
    def plainer(self) -> Mapping[Overlooked, Solid]:
        """Return the simplified mass distributions, by overlooked detail: a thin shell, with inertia 2mR²/3."""
        return {"wall": sphere_surface(self.radius)}

    @property
    def look(self) -> Spherical:
        """Return the drawn shape: a broad ring, as if cut open."""
        return Spherical(self.radius, wall=self.thickness)


@body
class Hoop(Shape):
    """A thin circular hoop about z."""

    radius: Radius

    nouns = ("hoop", "ring")
    lone, named = _introductions("thin", "thin uniform")

    @property
    def solid(self) -> Solid:
        """Return the uniform mass distribution of the body, with the centre as origin."""
        return ring(self.radius)

    @property
    def look(self) -> Axial:
        """Return the drawn shape: a ring."""
        return Axial(self.radius, wall=THIN_WALL_RATIO * self.radius)


Bore = Annotated[float, LEAST, MAX_SIZE, Measure("inner radius", "m", "r"), Range(0.02, 0.12)]


@body
class Pipe(Shape):
    """A pipe with a thin wall, about z; its length never matters."""

    radius: Radius

    nouns = ("pipe", "tube")
    lone, named = _introductions("thin-walled", "thin-walled")

    @property
    def solid(self) -> Solid:
        """Return a ring, since the length has no effect on rotation about the axis."""
        return ring(self.radius)

    @property
    def look(self) -> Axial:
        """Return the drawn shape: a ring, seen from its end."""
        return Axial(self.radius, wall=THIN_WALL_RATIO * self.radius)


@body
class ThickPipe(Shape):
    """A pipe with a thick wall, about z; its length never matters."""

    radius: Annotated[Radius, Range(0.08, 0.2)]
    bore: Bore

    nouns = ("pipe", "tube")
    lone = (
        "a thick-walled {noun} of outer radius {radius}, inner radius {bore} and mass {mass}",
        "a {noun} of mass {mass} with an outer radius of {radius} and an inner radius of {bore}",
    )
    named = (
        "a thick-walled {noun} {letter} of outer radius {radius}, inner radius {bore} and mass {mass}",
        "a thick-walled {noun} {letter} (outer radius {radius}, inner radius {bore}, mass {mass})",
    )

    @model_validator(mode="after")
    def _has_a_wall(self) -> Self:
        if self.bore >= self.radius:
            raise ValueError("bore: the inner radius is not less than the outer one; make it smaller")
        return self

    @property
    def solid(self) -> Solid:
        """Return the difference of two discs, since the length has no effect on rotation about the axis."""
        return disc(self.radius) - disc(self.bore)

    @property
    def plainer(self) -> Mapping[Overlooked, Solid]:
        """Return the simplified mass distributions, by overlooked detail: a thin pipe."""
        return {"wall": ring(self.radius)}

    @property
    def look(self) -> Axial:
        """Return the drawn shape: a broad ring, seen from its end."""
        return Axial(self.radius, wall=self.radius - self.bore)


@body
class Sphere(Shape):
    """A uniform solid sphere."""

    radius: Radius

    bulky = True
    nouns = ("sphere",)
    lone, named = _introductions("uniform solid", "solid uniform")

    @property
    def solid(self) -> Solid:
        """Return the uniform mass distribution of the body, with the centre as origin."""
        return ball(self.radius)

    @property
    def look(self) -> Spherical:
        """Return the drawn shape: a disc."""
        return Spherical(self.radius)
