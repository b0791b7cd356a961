"""A rocket, and where it may start: on an airless planet, on level ground, in deep space."""

from collections.abc import Mapping
from math import pi
from typing import Annotated, Any, Self

import numpy as np
from annotated_types import Gt, Le
from pydantic import model_validator

from sim2reason.dsl.body import Body, body
from sim2reason.dsl.looks import BodyLook, Globe, Small, Unseen
from sim2reason.dsl.measures import LEAST, Mass, Measure, Range
from sim2reason.dsl.model import as_said

PlanetRadius = Annotated[float, LEAST, Le(1e6), Measure("radius", "km", "R"), Range(800.0, 2800.0)]
SurfaceGravity = Annotated[
    float, Gt(0), Le(1e3), Measure("gravity", "m/s^2", "g", called="acceleration of free fall"), Range(0.4, 4.0)
]

GRAVITATION = 6.674e-11  # N m²/kg²
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
        """A rocket."""
        return Small("rocket")


class StartingPlace(Body):
    """Where a rocket is before its engine starts; told as what the rocket does there."""

    letters = ""

    @property
    def look(self) -> BodyLook:
        """What the rocket stands on is drawn below it, if it does."""
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
        return self.gravity / (4.0 / 3.0 * pi * GRAVITATION * KILO * self.radius)

    @classmethod
    def fitted(cls, drawn: Mapping[str, Any], rng: np.random.Generator) -> Mapping[str, object]:
        """Give it the gravity of a ball of rock, or of ice and rock."""
        density = rng.uniform(ROCK.low, ROCK.high)
        gravity = density * 4.0 / 3.0 * pi * GRAVITATION * KILO * drawn["radius"]
        return {"gravity": as_said(cls, "gravity", gravity)}

    @property
    def look(self) -> Globe:
        """A wide curve."""
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
