"""A fixed star, and what moves about it; in astronomical units, years and solar masses."""

from collections.abc import Mapping
from math import hypot, pi
from typing import Annotated

from annotated_types import Ge, Le

from sim2reason.dsl.body import Body, body
from sim2reason.dsl.looks import Small
from sim2reason.dsl.measures import Measure, Range
from sim2reason.dsl.template import Word

G = 4.0 * pi**2  # au³/(Msun yr²): what is 1 au from 1 solar mass takes 1 year for a circle
COMET = 0.6  # the least eccentricity of the orbit of a comet

StarMass = Annotated[float, Ge(1e-18), Le(1e6), Measure("mass", "Msun", "M"), Range(0.5, 2.0)]
PlanetMass = Annotated[float, Ge(1e-18), Le(1e6), Measure("mass", "Msun", "m"), Range(1e-5, 5e-4)]
PlaceX = Annotated[float, Ge(-1e3), Le(1e3), Measure("position", "au", "x", decimals=2), Range(-3.0, 3.0)]
PlaceY = Annotated[float, Ge(-1e3), Le(1e3), Measure("position", "au", "y", decimals=2), Range(-3.0, 3.0)]
OrbitalVelocity = Annotated[float, Ge(-1e3), Le(1e3), Measure("velocity", "au/yr", "v", decimals=2), Range(-8.0, 8.0)]


@body
class Star(Body):
    """A star that stays where it is."""

    mass: StarMass

    nouns = ("star",)
    letters = ""
    lone = ("a {noun} of mass {mass}", "a {noun} ({mass})")

    @property
    def look(self) -> Small:
        """A bright disc."""
        return Small("star")


@body
class Planet(Body):
    """Something so light that it attracts nothing, with its place and velocity at the start."""

    x: PlaceX
    y: PlaceY
    vx: OrbitalVelocity
    vy: OrbitalVelocity

    nouns = ("planet", "comet")
    lone = ("a {noun}", "a {noun} of negligible mass")
    named = ("{noun} {letter}", "{noun} {letter}, of negligible mass,")
    listed = "{letter}"
    words = {"among": Word("x", {}, "do not attract")}
    symbols = {"vx": "v_x", "vy": "v_y"}

    def suits(self, noun: str, bodies: Mapping[str, Body]) -> bool:
        """Return whether its orbit about the star is as long as that of a comet, if it is to be called so."""
        star = next((held for held in bodies.values() if isinstance(held, Star)), None)
        if noun != "comet" or star is None:
            return True
        pull, speed, radial = G * star.mass, hypot(self.vx, self.vy), self.x * self.vx + self.y * self.vy
        along = speed**2 - pull / hypot(self.x, self.y)
        return hypot(along * self.x - radial * self.vx, along * self.y - radial * self.vy) >= COMET * pull

    @property
    def look(self) -> Small:
        """A small filled circle."""
        return Small("planet")


@body
class HeavyPlanet(Body):
    """A planet whose mass matters to others, with its place and velocity at the start."""

    mass: PlanetMass
    x: PlaceX
    y: PlaceY
    vx: OrbitalVelocity
    vy: OrbitalVelocity

    nouns = ("planet",)
    lone = ("a {noun} of mass {mass}", "a {noun} ({mass})")
    named = ("{noun} {letter} of mass {mass}", "{noun} {letter} ({mass})")
    listed = "{letter} ({mass})"
    words = {"among": Word("mass", {}, "also attract")}
    symbols = {"vx": "v_x", "vy": "v_y"}

    @property
    def look(self) -> Small:
        """A small filled circle."""
        return Small("planet")
