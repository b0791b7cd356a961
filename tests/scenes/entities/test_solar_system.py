"""Tests of planets about a fixed star: ellipses, mutual attraction, collisions, refusals."""

import time
from math import pi, sqrt
from resource import RUSAGE_SELF, getrusage

import numpy as np
import pytest
from pydantic import ValidationError

from lone_entities import alone, close, followed, planar
from sim2reason.errors import SimulationError
from sim2reason.scenes.bodies.space import HeavyPlanet, Planet, Star
from sim2reason.scenes.entities.space import DURATION_PERIODS, G, SolarSystem
from sim2reason.simulation.scenes import certify
from sim2reason.text.prose import describe


def elliptic(e: float, axis: float = 1.0, mass: float = 1.0) -> SolarSystem:
    """Build a planet at its perihelion, on the x axis."""
    speed = sqrt(G * mass / axis * (1.0 + e) / (1.0 - e))
    return SolarSystem(star=Star(mass=mass), planets=(Planet(x=axis * (1.0 - e), y=0.0, vx=0.0, vy=speed),))


def test_the_earth_takes_a_year() -> None:
    """A circle of 1 au about one solar mass has the speed 2π au/yr, by the definition of G = 4π²."""
    system = elliptic(0.0)
    assert alone(system).horizon == pytest.approx(DURATION_PERIODS)
    t = np.linspace(0.0, 1.0, 201)
    x, y, _, _ = planar(followed(system, 1.0))
    close(x + 1.0, np.cos(2.0 * pi * t))
    close(y, np.sin(2.0 * pi * t))


@pytest.mark.parametrize(("e", "axis", "mass"), [(0.3, 0.8, 1.4), (0.5, 1.7, 0.6)])
def test_ten_periods_by_keplers_equation(e: float, axis: float, mass: float) -> None:
    """The motion is x = a (cos E − e), y = a √(1 − e²) sin E with M = E − e sin E.

    J. Kepler, Astronomia nova, 1609.
    """
    system = elliptic(e, axis, mass)
    period = 2.0 * pi * sqrt(axis**3 / (G * mass))
    assert alone(system).horizon == pytest.approx(DURATION_PERIODS * period)
    t = np.linspace(0.0, 10.0 * period, 401)
    anomaly = mean = 2.0 * pi * t / period
    for _ in range(60):
        anomaly = anomaly - (anomaly - e * np.sin(anomaly) - mean) / (1.0 - e * np.cos(anomaly))
    x, y, _, _ = planar(followed(system, 10.0 * period, 401))
    close(x + axis * (1.0 - e), axis * (np.cos(anomaly) - e))
    close(y, axis * sqrt(1.0 - e * e) * np.sin(anomaly))


def test_two_heavy_planets_opposite_each_other() -> None:
    """At ±r on one circle, the other planet adds Gm/4r² to the star's GM/r² (L. Euler, 1767)."""
    r, m, mass = 0.9, 0.04, 1.1
    omega = sqrt(G * (mass + 0.25 * m) / r**3)
    planets = (
        HeavyPlanet(mass=m, x=r, y=0.0, vx=0.0, vy=omega * r),
        HeavyPlanet(mass=m, x=-r, y=0.0, vx=0.0, vy=-omega * r),
    )
    system = SolarSystem(star=Star(mass=mass), planets=planets)
    t = np.linspace(0.0, 2.0, 201)
    q = followed(system, 2.0).state.q
    close(q[:, 0] + r, r * np.cos(omega * t))
    close(q[:, 3], -r * np.sin(omega * t))


def test_planets_that_attract_each_other_keep_energy_and_angular_momentum() -> None:
    """The sums Σ½mv² − ΣGMm/r − Gmm'/d and Σm(xv_y − yv_x) are constant; one planet's alone are not."""
    star, planets = 1.0, ((0.05, 0.8, 0.1, -0.6, 7.0), (0.03, -1.3, 0.4, -1.2, -5.2))
    system = SolarSystem(
        star=Star(mass=star),
        planets=tuple(HeavyPlanet(mass=m, x=x, y=y, vx=vx, vy=vy) for m, x, y, vx, vy in planets),
    )
    trace = followed(system, 1.5)
    places = [trace.state.q[:, 2 * i : 2 * i + 2] + np.array(planets[i][1:3]) for i in (0, 1)]
    rates = [trace.state.v[:, 2 * i : 2 * i + 2] for i in (0, 1)]
    masses = [planet[0] for planet in planets]
    apart = np.hypot(*(places[0] - places[1]).T)
    own = [
        m * (0.5 * (v**2).sum(axis=1) - G * star / np.hypot(*r.T))
        for m, r, v in zip(masses, places, rates, strict=True)
    ]
    energy = own[0] + own[1] - G * masses[0] * masses[1] / apart
    spin = sum(m * (r[:, 0] * v[:, 1] - r[:, 1] * v[:, 0]) for m, r, v in zip(masses, places, rates, strict=True))
    close(energy, energy[0])
    close(spin, spin[0])
    assert np.ptp(own[0]) > 1e-3 * abs(own[0][0])


@pytest.mark.parametrize("aside", [0.0, 1e-9])
def test_a_planet_that_falls_into_its_star_is_refused_at_once(aside: float) -> None:
    """A planet released at r reaches the star after (π/2) √(r³/2GM), 0.18 yr from 1 au; so does a near miss."""
    system = SolarSystem(star=Star(mass=1.0), planets=(Planet(x=1.0, y=0.0, vx=0.0, vy=aside),))
    began, held = time.process_time(), getrusage(RUSAGE_SELF).ru_maxrss
    with pytest.raises(SimulationError, match=r"singular at 0\.17"):
        certify(alone(system))
    assert time.process_time() - began < 5.0
    assert getrusage(RUSAGE_SELF).ru_maxrss - held < 2**16  # kB, 64 MB


def test_heavy_planets_that_meet_are_refused_at_once() -> None:
    """The planets start towards each other, far from their star."""
    planets = (
        HeavyPlanet(mass=0.05, x=5.0, y=0.0, vx=1.0, vy=0.0),
        HeavyPlanet(mass=0.05, x=5.5, y=0.0, vx=-1.0, vy=0.0),
    )
    began = time.process_time()
    with pytest.raises(SimulationError, match="singular"):
        followed(SolarSystem(star=Star(mass=0.5), planets=planets), 5.0)
    assert time.process_time() - began < 5.0


def test_a_planet_that_escapes_is_followed_for_the_time_of_a_circle() -> None:
    """The horizon is a little more than 2π √(r³/GM)."""
    system = SolarSystem(star=Star(mass=1.0), planets=(Planet(x=1.0, y=0.0, vx=3.0, vy=12.0),))
    assert alone(system).horizon == pytest.approx(DURATION_PERIODS)
    assert followed(system, 1.0).cut == ""


@pytest.mark.parametrize(
    ("planets", "says"),
    [
        ((Planet(x=0.0, y=0.0, vx=1.0, vy=0.0),), "where the star is"),
        ((HeavyPlanet(mass=0.02, x=1.0, y=0.0, vx=0.0, vy=6.0),), "matters only to other planets"),
        (
            (
                HeavyPlanet(mass=0.02, x=1.0, y=0.0, vx=0.0, vy=6.0),
                HeavyPlanet(mass=0.02, x=1.0, y=0.0, vx=0.0, vy=-6.0),
            ),
            "it is where planets.0 is",
        ),
        (
            (HeavyPlanet(mass=0.02, x=1.0, y=0.0, vx=0.0, vy=6.0), Planet(x=2.0, y=0.0, vx=0.0, vy=4.0)),
            "give one to all",
        ),
    ],
)
def test_what_is_no_solar_system_is_refused(planets: tuple[Planet | HeavyPlanet, ...], says: str) -> None:
    with pytest.raises(ValidationError, match=says):
        SolarSystem(star=Star(mass=1.0), planets=planets)


def test_masses_of_planets_are_said_only_where_they_matter() -> None:
    """The text states masses of planets only if they attract each other."""
    assert describe(alone(elliptic(0.2))).text.count("Msun") == 3  # of the unit, of G, of the star
    heavy = tuple(HeavyPlanet(mass=0.02, x=x, y=0.0, vx=0.0, vy=6.0) for x in (1.0, -1.0))
    text = describe(alone(SolarSystem(star=Star(mass=1.0), planets=heavy))).text
    assert text.count("0.020 Msun") == 2
    assert "attract" in text
