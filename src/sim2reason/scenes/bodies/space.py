"""Rockets, stars and planets."""

from collections.abc import Mapping
from math import hypot, pi
from typing import Annotated, Any, Self

import numpy as np
from annotated_types import Ge, Gt, Le
from pydantic import model_validator

from sim2reason.scenes.dsl.body import Body, BodyLook, Globe, Small, Unseen, body
from sim2reason.scenes.dsl.measures import LEAST, Mass, Measure, Range
from sim2reason.scenes.dsl.model import round_as_stated
from sim2reason.scenes.dsl.template import Word

PlanetRadius = Annotated[float, LEAST, Le(1e6), Measure("radius", "km", "R"), Range(800.0, 2800.0)]
SurfaceGravity = Annotated[
    float, Gt(0), Le(1e3), Measure("gravity", "m/s^2", "g", called="acceleration of free fall"), Range(0.4, 4.0)
]

GRAVITATIONAL_CONSTANT = 6.674e-11  # N m²/kg²
KILO = 1e3
ROCK = Range(1800.0, 5200.0)  # kg/m³


@body
class Rocket(Body):
    """A rocket with its fuel, and its mass when that is spent."""

    mass: Annotated[Mass, Range(500.0, 1500.0)]
    dry: Annotated[Mass, Range(120.0, 300.0)]

    nouns = ("rocket", "probe")
    lone = (
        "a {noun} of mass {mass} ({dry} without its fuel)",
        "a {noun}, whose mass is {mass} with its fuel and {dry} without,",
    )
    named = (
        "{noun} {letter} of mass {mass} ({dry} without its fuel)",
        "{noun} {letter}, whose mass is {mass} with its fuel and {dry} without,",
    )
    symbols = {"mass": "m_0", "dry": "m_1"}

    @model_validator(mode="after")
    def _has_fuel(self) -> Self:
        if self.dry >= self.mass:
            raise ValueError("dry: it is not less than the mass with fuel; make it less")
        return self

    @property
    def look(self) -> Small:
        """Return the drawn shape: a rocket."""
        return Small("rocket")


class StartingPlace(Body):
    """Base class of the places of a rocket before launch, described by what the rocket does there."""

    letters = ""

    @property
    def look(self) -> BodyLook:
        """Return the empty drawn shape, since the figure draws the ground below the rocket."""
        return Unseen()


@body
class AirlessPlanet(StartingPlace):
    """The surface of a planet without air whose attraction falls off as 1/r²."""

    radius: PlanetRadius
    gravity: SurfaceGravity

    matter = "planet"
    nouns = ("planet",)
    lone = (
        "stands upright on the surface of an airless {noun} of radius {radius}, where g is {gravity}",
        "stands upright on an airless {noun} of radius {radius} with g = {gravity} at its surface",
    )
    symbols = {"gravity": "g_0"}

    @property
    def density(self) -> float:
        """Return the mean density of the planet, kg/m³, from its surface gravity: g = 4πGρR/3."""
        return self.gravity / (4.0 / 3.0 * pi * GRAVITATIONAL_CONSTANT * KILO * self.radius)

    @classmethod
    def fitted(cls, drawn: Mapping[str, Any], rng: np.random.Generator) -> Mapping[str, object]:
        """Return a surface gravity that matches the mean density of rock, or of ice and rock."""
        density = rng.uniform(ROCK.low, ROCK.high)
        gravity = density * 4.0 / 3.0 * pi * GRAVITATIONAL_CONSTANT * KILO * drawn["radius"]
        return {"gravity": round_as_stated(cls, "gravity", gravity)}

    @property
    def look(self) -> Globe:
        """Return the drawn shape: a wide curve."""
        return Globe()


@body
class LevelGround(StartingPlace):
    """Ground above which the field of gravity is the same everywhere."""

    nouns = ("ground",)
    lone = (
        "stands upright on level {noun}, where there is no air and g is the same at all heights",
        "stands upright on level {noun} in a uniform gravitational field, without air",
    )


@body
class DeepSpace(StartingPlace):
    """Far from everything."""

    nouns = ("space",)
    lone = (
        "is at rest in deep {noun}, far from all other bodies",
        "is at rest in empty {noun}, where nothing attracts it",
    )


G = 4.0 * pi**2  # au³/(Msun yr²): what is 1 au from 1 solar mass takes 1 year for a circle
MIN_COMET_ECCENTRICITY = 0.6  # the least eccentricity of the orbit of a comet

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
        """Return the drawn shape: a bright disc."""
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
        """Return whether the orbit is eccentric enough for the noun *comet*; True for other nouns."""
        star = next((held for held in bodies.values() if isinstance(held, Star)), None)
        if noun != "comet" or star is None:
            return True
        pull, speed, radial = G * star.mass, hypot(self.vx, self.vy), self.x * self.vx + self.y * self.vy
        along = speed**2 - pull / hypot(self.x, self.y)
        return (
            hypot(along * self.x - radial * self.vx, along * self.y - radial * self.vy) >= MIN_COMET_ECCENTRICITY * pull
        )

    @property
    def look(self) -> Small:
        """Return the drawn shape: a small filled circle."""
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
        """Return the drawn shape: a small filled circle."""
        return Small("planet")
