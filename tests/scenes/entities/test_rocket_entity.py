"""Tests of rockets: Tsiolkovsky's equation, delayed lift-off, coasting above a planet, return."""

from math import log, sqrt

import numpy as np
import pytest
from pydantic import ValidationError

from lone_entities import alone, close, followed, happened
from sim2reason.scenes.bodies.space import AirlessPlanet, DeepSpace, LevelGround, Rocket
from sim2reason.scenes.dsl.mechanism import GRAVITY
from sim2reason.scenes.entities.space import RocketEntity

FULL, DRY = 900.0, 300.0


def launched(
    place: AirlessPlanet | LevelGround | DeepSpace, rate: float, exhaust: float, mass: float = FULL
) -> RocketEntity:
    """Build a rocket with an exhaust velocity in km/s."""
    return RocketEntity(rocket=Rocket(mass=mass, dry=DRY), place=place, exhaust=exhaust, rate=rate)


def test_in_deep_space() -> None:
    """The motion is v = u ln(m₀/m), s = ut − (um/µ) ln(m₀/m), then v = u ln(m₀/m₁) (K. Tsiolkovsky, 1903)."""
    entity = launched(DeepSpace(), 5.0, 2.0)
    assert entity.burning_time == 120.0
    assert alone(entity).horizon == 360.0
    trace = followed(entity, 240.0, 241)
    t = np.minimum(trace.state.times, 120.0)
    m = FULL - 5.0 * t
    v, s = 2000.0 * np.log(FULL / m), 2000.0 * t - 400.0 * m * np.log(FULL / m)
    close(trace.state.v[:, 0], v)
    close(trace.state.q[:, 0], s + v * (trace.state.times - t))
    [(kind, time)] = happened(trace)
    assert kind == "burn-out"
    close(time, 120.0)


def test_from_level_ground() -> None:
    """The motion is v = u ln(m₀/m) − gt, h = ut − (um/µ) ln(m₀/m) − gt²/2."""
    entity = launched(LevelGround(), 20.0, 0.8)
    trace = followed(entity, 30.0, 241)
    t = trace.state.times
    m = FULL - 20.0 * t
    close(trace.state.v[:, 0], 800.0 * np.log(FULL / m) - GRAVITY * t)
    close(trace.state.q[:, 0], 800.0 * t - 40.0 * m * np.log(FULL / m) - 0.5 * GRAVITY * t**2)


def test_it_waits_until_it_is_light_enough() -> None:
    """The thrust uµ lifts a mass of uµ/g, so the rocket is at rest until (m₀ − uµ/g)/µ."""
    rate, exhaust = 10.0, 0.7
    wait = (FULL - 1e3 * exhaust * rate / GRAVITY) / rate
    trace = followed(launched(LevelGround(), rate, exhaust), 60.0, 241)
    [(kind, time), *_] = happened(trace)
    assert kind == "leave"
    close(time, wait)
    t = trace.state.times
    since, left = np.maximum(t - wait, 0.0), FULL - rate * wait
    shed = np.log(left / (left - rate * since))
    close(trace.state.v[:, 0], 1e3 * exhaust * shed - GRAVITY * since)
    assert np.abs(trace.state.q[t < wait, 0]).max() < 1e-12  # m: rounding, while it stands


def test_it_waits_on_a_planet_for_its_surface_gravity() -> None:
    """The rocket lifts off when its thrust equals its weight with the planet's surface gravity."""
    trace = followed(launched(AirlessPlanet(radius=2400.0, gravity=3.0), 1.0, 2.5), 400.0)
    assert happened(trace)[0][0] == "leave"
    close(happened(trace)[0][1], FULL - 2500.0 / 3.0)


def test_it_never_lifts_off() -> None:
    """The thrust is less than the weight of the empty rocket."""
    trace = followed(launched(LevelGround(), 3.0, 0.9), 400.0)
    assert np.abs(trace.state.q).max() < 1e-12
    assert [kind for kind, _ in happened(trace)] == ["burn-out"]


@pytest.mark.parametrize("rate", [4.0, 12.0])
def test_above_a_planet(rate: float) -> None:
    """The thrust gives dv/dt = uµ/m − gR²/r²; after burn-out v²/2 − gR²/r is constant."""
    radius, g, exhaust = 1.5e6, 2.0, 2.1
    entity = launched(AirlessPlanet(radius=1e-3 * radius, gravity=g), rate, exhaust)
    trace = followed(entity, entity.horizon(9.8), 601)
    t, r, v = trace.state.times, radius + trace.state.q[:, 0], trace.state.v[:, 0]
    burning = t < entity.burning_time
    thrust = np.where(burning, 1e3 * exhaust * rate / (FULL - rate * np.where(burning, t, 0.0)), 0.0)
    close(trace.state.a[:, 0], thrust - g * radius**2 / r**2)
    energy = 0.5 * v**2 - g * radius**2 / r
    close(energy[~burning], energy[~burning][0], scale=g * radius)


def test_its_speed_at_burn_out_is_that_of_tsiolkovsky_less_what_gravity_took() -> None:
    """The speed is v = u ln(m₀/m₁) − ∫ gR²/r² dt, by Gaussian quadrature over the recorded motion."""
    radius, g, rate, exhaust = 9.0e5, 1.5, 6.0, 1.2
    entity = launched(AirlessPlanet(radius=1e-3 * radius, gravity=g), rate, exhaust)
    end = entity.burning_time
    nodes, weights = np.polynomial.legendre.leggauss(40)
    trace = followed(entity, end)
    r = radius + trace.sample(0.5 * end * (nodes + 1.0)).q[:, 0]
    taken = float(0.5 * end * (weights @ (g * radius**2 / r**2)))
    close(trace.state.v[-1, 0], 1e3 * exhaust * log(FULL / DRY) - taken)


def test_its_way_ends_where_it_returns_to_the_ground() -> None:
    """The rocket lands (v + √(v² + 2gh))/g after burn-out, like a ball thrown up with its speed there."""
    burning = RocketEntity(rocket=Rocket(mass=400.0, dry=DRY), place=LevelGround(), exhaust=0.5, rate=10.0)
    end = burning.burning_time
    m, u = 400.0 / DRY, 500.0
    v = u * log(m) - GRAVITY * end
    h = u * end - u * DRY / 10.0 * log(m) - 0.5 * GRAVITY * end**2
    trace = followed(burning, 60.0)
    assert trace.cut == "limit"
    close(trace.stable_until, end + (v + sqrt(v**2 + 2.0 * GRAVITY * h)) / GRAVITY)


def test_a_rocket_without_fuel_is_refused() -> None:
    with pytest.raises(ValidationError, match="not less than the mass with fuel"):
        Rocket(mass=300.0, dry=300.0)
