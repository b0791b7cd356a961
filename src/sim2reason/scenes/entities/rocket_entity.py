"""A rocket that burns its fuel at a constant rate: above a planet, on level ground or in deep space."""

from collections.abc import Mapping
from math import sqrt
from typing import Annotated, Any

import numpy as np
from annotated_types import Le

from sim2reason.scenes.authoring import GRAVITY, LEAST, Entity, Frame, Measure, Range, X, Z, either, entity, starting
from sim2reason.scenes.bodies.space import GRAVITATION, KILO, AirlessPlanet, DeepSpace, LevelGround, Rocket
from sim2reason.scenes.dsl.model import round_as_stated

ExhaustSpeed = Annotated[float, LEAST, Le(1e4), Measure("exhaust speed", "km/s", "u", sought=2.0), Range(0.4, 3.0)]
BurnRate = Annotated[float, LEAST, Le(1e6), Measure("burn rate", "kg/s", r"\mu"), Range(1.0, 10.0)]
THRUST = Range(0.8, 4.0)  # in initial weights: below 1 the rocket waits until it is light enough
AWAY = Range(1.2, 2.5)  # in initial weights, for a rocket that travels far from a planet
ESCAPE = Range(0.6, 1.2)  # exhaust speeds, in escape speeds
BURNS = 3.0  # burning times in the default duration


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
            times = AWAY
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
        return BURNS * self.burning_time

    def build(self, room: Frame) -> None:
        """Build the rocket with one coordinate: vertical in uniform gravity, else along a level line.

        The initial support is a strut that it may leave; its motion ends when it returns to the ground.
        """
        way = Z if isinstance(self.place, LevelGround) else X
        rocket = room.body("rocket", self.rocket.mass)
        if isinstance(self.place, DeepSpace):
            rocket.slide(way, name="along")
        else:
            rocket.slide(way, limits=(0.0, float("inf")), name="rise").site("tail")
            room.site("pad", at=(-way[0], -way[1], -way[2]))
            room.prop("stand", room.address("pad"), room.address("tail"))
        rocket.burn(self.rate, KILO * self.exhaust, self.burning_time, way)
        if isinstance(self.place, AirlessPlanet):
            radius = KILO * self.place.radius
            planet = room.body("place", self.place.gravity * radius**2 / GRAVITATION, at=(-radius, 0.0, 0.0))
            rocket.attract(planet, GRAVITATION)
