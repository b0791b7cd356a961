"""Bodies in space: a rocket that burns its fuel at a constant rate, and a star with its planets."""

from collections.abc import Iterable, Mapping
from itertools import combinations
from math import cos, hypot, pi, sin, sqrt
from typing import Annotated, Any, ClassVar, Self

import numpy as np
from annotated_types import Le, Len
from pydantic import model_validator

from sim2reason.scenes.authoring import (
    GRAVITY,
    LEAST,
    Count,
    Entity,
    Frame,
    Measure,
    Range,
    X,
    Y,
    Z,
    assuming,
    each,
    either,
    entity,
    starting,
)
from sim2reason.scenes.bodies.space import (
    GRAVITATIONAL_CONSTANT,
    KILO,
    AirlessPlanet,
    DeepSpace,
    G,
    HeavyPlanet,
    LevelGround,
    Planet,
    Rocket,
    Star,
)
from sim2reason.scenes.dsl.model import replace_validated, round_as_stated
from sim2reason.scenes.dsl.units import ASTRONOMICAL, UnitSystem

ExhaustSpeed = Annotated[float, LEAST, Le(1e4), Measure("exhaust speed", "km/s", "u", sought=2.0), Range(0.4, 3.0)]
BurnRate = Annotated[float, LEAST, Le(1e6), Measure("burn rate", "kg/s", r"\mu"), Range(1.0, 10.0)]
THRUST = Range(0.8, 4.0)  # in initial weights: below 1 the rocket waits until it is light enough
ESCAPING_THRUST = Range(1.2, 2.5)  # in initial weights, for a rocket that travels far from a planet
ESCAPE = Range(0.6, 1.2)  # exhaust speeds, in escape speeds
HORIZON_BURNS = 3.0  # burning times in the default duration


@entity
class RocketEntity(Entity):
    """Thrust is the burn rate times the exhaust speed; without a planet or ground nothing else acts."""

    rocket: Rocket
    place: AirlessPlanet | LevelGround | DeepSpace
    exhaust: ExhaustSpeed
    rate: BurnRate

    says = (
        either(
            "{rocket} {place}.",
            "initially {rocket} {place}.",
            "at first {rocket} {place}.",
        ),
        starting(
            "at t = 0 the engine starts: it burns fuel at a rate of {rate} and ejects the gas backwards at speed {exhaust} relative to {rocket} until no fuel is left.",
            "from t = 0 on {rocket} burns fuel at a rate of {rate}, ejecting the gas backwards at speed {exhaust} relative to itself, until none is left.",
            "its engine, started at t = 0, ejects gas backwards at speed {exhaust} relative to {rocket} and burns fuel at a rate of {rate} until none is left.",
        ),
    )

    @classmethod
    def fitted(cls, drawn: Mapping[str, Any], rng: np.random.Generator) -> Mapping[str, object]:
        """Return an exhaust speed near the escape speed, and a thrust that can lift the rocket."""
        place, exhaust = drawn["place"], drawn["exhaust"]
        if isinstance(place, DeepSpace):
            return {}
        g, times = GRAVITY, THRUST
        if isinstance(place, AirlessPlanet):
            times = ESCAPING_THRUST
            g, escape = place.gravity, sqrt(2.0 * place.gravity * place.radius / KILO)
            exhaust = round_as_stated(RocketEntity, "exhaust", rng.uniform(ESCAPE.low, ESCAPE.high) * escape)
        thrust = rng.uniform(times.low, times.high) * drawn["rocket"].mass * g
        return {"exhaust": exhaust, "rate": round_as_stated(RocketEntity, "rate", thrust / (KILO * exhaust))}

    @property
    def clocked(self) -> bool:
        """Return True, since the engine starts at t = 0."""
        return True

    @property
    def thrust(self) -> float:
        """Return the thrust, N: burn rate times exhaust speed."""
        return self.rate * KILO * self.exhaust

    @property
    def burning_time(self) -> float:
        """Return the burning time of the fuel, s."""
        return (self.rocket.mass - self.rocket.dry) / self.rate

    def horizon(self, gravity: float) -> float:
        """Return three times the burning time, s."""
        del gravity
        return HORIZON_BURNS * self.burning_time

    def build(self, room: Frame) -> None:
        """Build the rocket with one coordinate: vertical in uniform gravity, else along a level line.

        The initial support is a strut that it may leave; its motion ends when it returns to the ground.
        """
        direction = Z if isinstance(self.place, LevelGround) else X
        rocket = room.body("rocket", self.rocket.mass)
        if isinstance(self.place, DeepSpace):
            rocket.slide(direction, name="along")
        else:
            rocket.slide(direction, limits=(0.0, float("inf")), name="rise").site("tail")
            room.site("pad", at=(-direction[0], -direction[1], -direction[2]))
            room.prop("stand", room.address("pad"), room.address("tail"))
        rocket.burn(self.rate, KILO * self.exhaust, self.burning_time, direction)
        if isinstance(self.place, AirlessPlanet):
            radius = KILO * self.place.radius
            planet = room.body("place", self.place.gravity * radius**2 / GRAVITATIONAL_CONSTANT, at=(-radius, 0.0, 0.0))
            rocket.attract(planet, GRAVITATIONAL_CONSTANT)


NEGLIGIBLE_MASS = 1e-6  # solar masses, of a planet whose mass is not stated and has no effect
INNERMOST = Range(0.3, 0.7)  # au, first perihelion
ORBIT_SPACING, FAR_APART = Range(1.2, 1.6), Range(1.6, 2.2)  # perihelion over the previous aphelion; for heavy ones
RATIO = Range(2e-4, 1e-3)  # mass of a heavy planet over that of its star
ROUND = Range(0.0, 0.3)  # eccentricities
APSIS_PROBABILITY = (
    0.4  # probability that the first planet starts at an apsis, with a velocity perpendicular to the radius
)
DURATION_PERIODS = 1.2  # periods in the default duration: more than one, even if a number is changed slightly
MAX_DURATION = 50.0  # yr

AnyPlanet = Planet | HeavyPlanet
Planets = Annotated[tuple[AnyPlanet, ...], Len(1, 6), Count(1, 4, alike=True)]


@entity
class SolarSystem(Entity):
    """Planets that a fixed star attracts; those that have a mass attract one another, too."""

    star: Star
    planets: Planets

    units: ClassVar[UnitSystem] = ASTRONOMICAL
    says = (
        either(
            "{star} is fixed at the origin of the x-y plane; the units are the astronomical unit (au), the year (yr) and the solar mass (Msun), in which G = 4π² au³/(Msun yr²).",
            "{star} is fixed at the origin of the x-y plane; with lengths in au, times in years (yr) and masses in solar masses (Msun), G = 4π² au³/(Msun yr²).",
            "lengths are in au, times in years (yr) and masses in solar masses (Msun), so that G = 4π² au³/(Msun yr²); {star} is fixed at the origin of the x-y plane.",
        ),
        each(
            "planets",
            "{planets.*} is at ({planets.*.x}, {planets.*.y}) at t = 0, moving with the velocity ({planets.*.vx}, {planets.*.vy}).",
            "at t = 0 {planets.*} is at the point ({planets.*.x}, {planets.*.y}) and has the velocity ({planets.*.vx}, {planets.*.vy}).",
            "the position of {planets.*} at t = 0 is ({planets.*.x}, {planets.*.y}), and its velocity is ({planets.*.vx}, {planets.*.vy}).",
            table=(
                "the table gives each {noun}'s {columns} at t = 0.",
                "the table shows the {columns} of each {noun} at t = 0.",
                "at t = 0 each {noun} has the {columns} that the table gives.",
                "for t = 0 the table lists the {columns} of each {noun}.",
            ),
        ),
        assuming(
            "{planets:{planets.first} is attracted by the star alone/the {planets:s} are attracted by the star and {planets.first.among} one another}.",
            "{planets:the only force on {planets.first} is the attraction of the star/the star attracts the {planets:s}, which {planets.first.among} one another}.",
            "{planets:no force but the attraction of the star acts on {planets.first}/the star attracts each of the {planets:s}, and they {planets.first.among} one another}.",
        ),
    )

    @model_validator(mode="after")
    def _moves(self) -> Self:
        heavy = [isinstance(planet, HeavyPlanet) for planet in self.planets]
        if any(heavy) and not (all(heavy) and len(heavy) > 1):
            raise ValueError("planets: a mass matters only to other planets; give one to all of several, or to none")
        for index, planet in enumerate(self.planets):
            if hypot(planet.x, planet.y) == 0.0:
                raise ValueError(f"planets.{index}: it is where the star is; give it another place")
        for (i, a), (j, b) in combinations(enumerate(self.planets), 2):
            if all(heavy) and (a.x, a.y) == (b.x, b.y):
                raise ValueError(f"planets.{j}: it is where planets.{i} is; give it another place")
        return self

    @classmethod
    def fitted(cls, drawn: Mapping[str, Any], rng: np.random.Generator) -> Mapping[str, object]:
        """Return planets on nested ellipses about the drawn star, all much lighter than the star."""
        mass: float = drawn["star"].mass
        planets = orbiting(drawn["planets"], mass, ROUND, rng)
        return {"planets": tuple(_lighter(planet, mass, rng) for planet in planets)}

    def horizon(self, gravity: float) -> float:
        """Return slightly more than the shortest period of a bound planet, or that of a circular orbit, yr."""
        del gravity
        return min([MAX_DURATION, *(DURATION_PERIODS * self._period(planet) for planet in self.planets)])

    def _period(self, planet: AnyPlanet) -> float:
        distance, attraction = hypot(planet.x, planet.y), G * self.star.mass
        over = 2.0 / distance - (planet.vx**2 + planet.vy**2) / attraction  # 1/a, by the vis-viva equation
        axis = 1.0 / over if over * distance > 0.1 else distance
        return 2.0 * pi * sqrt(axis**3 / attraction)

    def build(self, room: Frame) -> None:
        """Build planets with two sliding coordinates each in the level plane, and the fixed star."""
        star = room.body("star", self.star.mass)
        frames: list[Frame] = []
        for index, planet in enumerate(self.planets):
            mass = planet.mass if isinstance(planet, HeavyPlanet) else NEGLIGIBLE_MASS
            frame = room.body(f"planets.{index}", mass, at=(planet.x, planet.y, 0.0))
            frame.slide(X, planet.vx, name="x", stated=("x", planet.x))
            frame.slide(Y, planet.vy, name="y", stated=("y", planet.y)).attract(star, G)
            frames.append(frame)
        if isinstance(self.planets[0], HeavyPlanet):
            for one, other in combinations(frames, 2):
                one.attract(other, G)


def _lighter(planet: AnyPlanet, mass: float, rng: np.random.Generator) -> AnyPlanet:
    """Return a heavy planet with a small part of the mass of its star."""
    if isinstance(planet, Planet):
        return planet
    return replace_validated(planet, mass=float(f"{rng.uniform(RATIO.low, RATIO.high) * mass:.1e}"))


def orbiting(
    planets: Iterable[AnyPlanet],
    mass: float,
    eccentricities: Range,
    rng: np.random.Generator,
) -> tuple[AnyPlanet, ...]:
    """Return planets on ellipses about a star of a given mass, each orbit outside the previous one.

    The first planet starts on the x axis, so that its distance from the star is evident; the others anywhere.
    With p = a(1 − e²), at the angle ν from the perihelion, r = p/(1 + e cos ν), and the velocity is √(GM/p) times
    (−sin ν, e + cos ν) in axes of which the first points to the perihelion.
    """
    placed: list[AnyPlanet] = []
    nearest = rng.uniform(INNERMOST.low, INNERMOST.high)
    for planet in planets:
        e, turn, angle = rng.uniform((eccentricities.low, 0.0, 0.0), (eccentricities.high, 2.0 * pi, 2.0 * pi))
        if not placed:
            angle = pi * float(rng.integers(2)) if rng.random() < APSIS_PROBABILITY else angle
            turn = -angle
        p = nearest * (1.0 + e)
        r, speed = p / (1.0 + e * cos(angle)), sqrt(G * mass / p)
        x, y = r * cos(angle + turn), r * sin(angle + turn)
        along, across = -speed * sin(angle), speed * (e + cos(angle))
        vx, vy = along * cos(turn) - across * sin(turn), along * sin(turn) + across * cos(turn)
        orbit = {
            name: round_as_stated(type(planet), name, part)
            for name, part in (("x", x), ("y", y), ("vx", vx), ("vy", vy))
        }
        spacing = FAR_APART if isinstance(planet, HeavyPlanet) else ORBIT_SPACING
        nearest *= (1.0 + e) / (1.0 - e) * rng.uniform(spacing.low, spacing.high)
        placed.append(replace_validated(planet, **orbit))
    return tuple(placed)
