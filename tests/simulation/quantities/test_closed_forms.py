"""Tests of all quantities of bodies that swing, roll, orbit and burn, against textbook formulas, to 1e-8."""

from collections.abc import Callable, Mapping
from math import cos, pi, radians, sqrt

import numpy as np
import pytest

import motions
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.mechanism import X, Y, Z
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.simulation.engines.exact import simulate
from sim2reason.simulation.quantities import QUANTITIES

G = 9.8
CLOSE = 1e-8
BALL, BLOCK, ROD, BOB = "lane.ball", "bench.block", "swing.rod", "swing.bob"
PLANET, CHARGE, HANGER = "sky.planet", "lab.charge", "swing.hanger"
Check = Callable[[State], tuple[Array, Array | float]]


def value(state: State, quantity: str, subject: str) -> Array:
    return QUANTITIES[quantity].evaluate(state, subject)


def size(state: State, quantity: str, subject: str) -> Array:
    """Return the magnitude of a vector."""
    return np.linalg.norm(value(state, quantity, subject), axis=1)


def theta(state: State, subject: str) -> Array:
    """Return the signed angle between a swinging body and the downward vertical in rad."""
    found = np.radians(value(state, "deflection", subject))
    turned = value(state, "angle turned", subject)
    return np.where(np.abs(radians(60.0) - np.radians(np.abs(turned)) - found) < 1e-6, found, -found)


# ---- a uniform rod of 1.2 m and 2 kg on a hinge at its end, let go at 60°: ω² = (3g/L)(cos θ − cos θ₀)
# (energy, with I = mL²/3), α = (3g/2L) sin θ

L, M, START = 1.2, 2.0, radians(60.0)


def rod_spin(state: State) -> Array:
    return np.sqrt(np.maximum(3.0 * G / L * (np.cos(theta(state, ROD)) - cos(START)), 0.0))


def rod_alpha(state: State) -> Array:
    return 1.5 * G / L * np.sin(np.abs(theta(state, ROD)))


ROD_CHECKS: Mapping[str, Check] = {
    "angular velocity": lambda s: (size(s, "angular velocity", ROD), rod_spin(s)),
    "angular acceleration": lambda s: (size(s, "angular acceleration", ROD), rod_alpha(s)),
    "velocity of the centre": lambda s: (size(s, "velocity", ROD), rod_spin(s) * L / 2.0),
    "acceleration, ω × v included": lambda s: (
        size(s, "acceleration", ROD),
        L / 2.0 * np.hypot(rod_alpha(s), rod_spin(s) ** 2),
    ),
    "displacement of the centre, a chord": lambda s: (
        size(s, "displacement", ROD),
        L * np.sin(0.5 * np.abs(theta(s, ROD) - START)),
    ),
    "momentum": lambda s: (size(s, "momentum", ROD), M * rod_spin(s) * L / 2.0),
    "angular momentum about its centre": lambda s: (
        size(s, "angular momentum", ROD),
        M * L**2 / 12.0 * rod_spin(s),
    ),
    "torque about its centre": lambda s: (size(s, "torque", ROD), M * L**2 / 12.0 * rod_alpha(s)),
    "kinetic energy, mL²ω²/6": lambda s: (value(s, "kinetic energy", ROD), M * L**2 / 6.0 * rod_spin(s) ** 2),
    "translational kinetic energy": lambda s: (
        value(s, "translational kinetic energy", ROD),
        M * L**2 / 8.0 * rod_spin(s) ** 2,
    ),
    "rotational kinetic energy": lambda s: (
        value(s, "rotational kinetic energy", ROD),
        M * L**2 / 24.0 * rod_spin(s) ** 2,
    ),
    "potential energy": lambda s: (
        value(s, "potential energy", ROD),
        -M * G * L / 2.0 * (np.cos(theta(s, ROD)) - cos(START)),
    ),
    "angle turned": lambda s: (np.radians(np.abs(value(s, "angle turned", ROD))), np.abs(theta(s, ROD) - START)),
    "moment of inertia, mL²/12": lambda s: (value(s, "moment of inertia", ROD), M * L**2 / 12.0),
    "centre of mass offset": lambda s: (size(s, "centre of mass offset", ROD), L / 2.0),
    "inertia tensor, its trace": lambda s: (
        value(s, "inertia tensor, diagonal", ROD).sum(axis=1),
        2.0 * M * L**2 / 12.0,
    ),
    "inertia tensor, I_xz = −(mL²/12) n_x n_z": lambda s: (
        np.abs(value(s, "inertia tensor, off the diagonal", ROD)[:, 1]),
        M * L**2 / 24.0 * np.abs(np.sin(2.0 * theta(s, ROD))),
    ),
}

# ---- others


def bounded(state: State, before: float) -> np.ndarray:
    return state.times < before


def sliding(state: State) -> np.ndarray:
    """Return expected values for a sphere of 2 kg set sliding at 3 m/s, µ = 0.2, which rolls from 2v₀/(7µg) on."""
    return bounded(state, 2.0 * 3.0 / (7.0 * 0.2 * G))


def radius(state: State) -> Array:
    """Return the distance between star and planet; a = 1, e = 1/2, GM = 4π², starting at perihelion."""
    return value(state, "distance", "sky.planet & sky.star")


STRUCK = 3.5 * G  # v₀² of the bob on a string of 1 m
OMEGA = sqrt(20.0 / 0.5)  # of the block on its spring, pulled out by 0.2 m
ROLLED = 2.0 * 3.0 / (7.0 * 0.2 * G)

CHECKS: list[tuple[str, Callable[[], motions.Motion], Check]] = [
    *((f"a rod on a hinge: {name}", motions.rod_pendulum, check) for name, check in ROD_CHECKS.items()),
    (
        "a ball that slips, then rolls at 5v₀/7: speed",
        motions.rolling_ball,
        lambda s: (size(s, "velocity", BALL), np.where(sliding(s), 3.0 - 0.2 * G * s.times, 15.0 / 7.0)),
    ),
    (
        "…: its spin 5µgt/(2R), then v/R",
        motions.rolling_ball,
        lambda s: (size(s, "angular velocity", BALL), np.where(sliding(s), 2.5 * 0.2 * G * s.times / 0.1, 150.0 / 7.0)),
    ),
    (
        "…: angle rolled",
        motions.rolling_ball,
        lambda s: (
            np.abs(value(s, "angle rolled", BALL)),
            np.where(sliding(s), 24.5 * s.times**2, 24.5 * ROLLED**2 + 150.0 / 7.0 * (s.times - ROLLED)),
        ),
    ),
    (
        "…: kinetic energy, ½mv² + ½(2/5)mR²ω²",
        motions.rolling_ball,
        lambda s: (
            value(s, "kinetic energy", BALL),
            size(s, "velocity", BALL) ** 2 + 0.5 * 0.4 * 2.0 * 0.01 * size(s, "angular velocity", BALL) ** 2,
        ),
    ),
    (
        "…: friction µmg, then none",
        motions.rolling_ball,
        lambda s: (np.abs(value(s, "friction force", BALL)), np.where(sliding(s), 0.2 * 2.0 * G, 0.0)),
    ),
    (
        "…: torque of friction about its centre µmgR",
        motions.rolling_ball,
        lambda s: (size(s, "torque", BALL), np.where(sliding(s), 0.2 * 2.0 * G * 0.1, 0.0)),
    ),
    (
        "a bob on a string: tension m(v²/ℓ + g cos θ), none while it is slack",
        motions.string_pendulum,
        lambda s: (
            value(s, "tension", HANGER)[bounded(s, 1.2)],
            np.nan_to_num(
                0.5 * (STRUCK - 2.0 * G + 3.0 * G * np.cos(np.radians(value(s, "deflection", HANGER))))[bounded(s, 1.2)]
            ),
        ),
    ),
    (
        "a bob on a light rod: force mg(3 cos θ − 2 cos θ₀)",
        motions.light_rod,
        lambda s: (
            value(s, "rod force", HANGER),
            0.5 * G * (3.0 * np.cos(np.radians(value(s, "deflection", HANGER))) - 2.0 * cos(START)),
        ),
    ),
    (
        "a spring block: extension A cos ωt",
        motions.spring_block,
        lambda s: (value(s, "extension", "bench.spring"), 0.2 * np.cos(OMEGA * s.times)),
    ),
    (
        "…: length",
        motions.spring_block,
        lambda s: (value(s, "spring length", "bench.spring"), 0.6 + 0.2 * np.cos(OMEGA * s.times)),
    ),
    (
        "…: rate",
        motions.spring_block,
        lambda s: (value(s, "extension rate", "bench.spring"), -0.2 * OMEGA * np.sin(OMEGA * s.times)),
    ),
    (
        "…: force kx",
        motions.spring_block,
        lambda s: (value(s, "spring force", "bench.spring"), 4.0 * np.cos(OMEGA * s.times)),
    ),
    (
        "…: energy ½kA² cos² ωt",
        motions.spring_block,
        lambda s: (value(s, "spring energy", "bench.spring"), 0.4 * np.cos(OMEGA * s.times) ** 2),
    ),
    (
        "a planet: change in potential energy −GMm(1/r − 1/r₀)",
        motions.orbit,
        lambda s: (value(s, "potential energy", PLANET), -4e-3 * pi**2 * (1.0 / radius(s) - 2.0)),
    ),
    (
        "…: speed by the vis-viva equation v² = GM(2/r − 1/a)",
        motions.orbit,
        lambda s: (size(s, "velocity", PLANET), 2.0 * pi * np.sqrt(2.0 / radius(s) - 1.0)),
    ),
    (
        "…: net force GMm/r²",
        motions.orbit,
        lambda s: (size(s, "net force", PLANET), 4e-3 * pi**2 / radius(s) ** 2),
    ),
    (
        "a rocket: mass",
        motions.rocket,
        lambda s: (value(s, "mass", "pad.rocket"), 10.0 - 0.5 * np.minimum(s.times, 6.0)),
    ),
    (
        "…: u ln(m₀/m) − gt (Tsiolkovsky)",
        motions.rocket,
        lambda s: (
            value(s, "velocity", "pad.rocket")[:, 2],
            400.0 * np.log(10.0 / value(s, "mass", "pad.rocket")) - G * s.times,
        ),
    ),
    (
        "…: net force, thrust less weight",
        motions.rocket,
        lambda s: (
            value(s, "net force", "pad.rocket")[:, 2],
            200.0 * (s.times < 6.0) - G * value(s, "mass", "pad.rocket"),
        ),
    ),
    ("a charge in B keeps its speed", motions.charge, lambda s: (size(s, "velocity", CHARGE), 2.0)),
    (
        "…: its acceleration is vω inside",
        motions.charge,
        lambda s: (
            size(s, "acceleration", CHARGE),
            np.where((s.times >= 0.5) & (s.times < 0.5 + pi / 3.0), 6.0, 0.0),
        ),
    ),
    (
        "a charge in E = 1 + 2x: x = (λv₀ sinh λt + 10 (cosh λt − 1)) / λ², λ² = 20",
        motions.driven_charge,
        lambda s: (
            value(s, "displacement", CHARGE)[:, 0],
            0.5 * np.sinh(sqrt(20.0) * s.times) / sqrt(20.0) + 0.5 * (np.cosh(sqrt(20.0) * s.times) - 1.0),
        ),
    ),
    (
        "…: electric potential energy −(x + x²)",
        motions.driven_charge,
        lambda s: (
            value(s, "electric potential energy", CHARGE),
            -(value(s, "displacement", CHARGE)[:, 0] + value(s, "displacement", CHARGE)[:, 0] ** 2),
        ),
    ),
    (
        "a block on a dome: normal force mg(3 cos θ − 2 cos θ₀)",
        motions.dome,
        lambda s: (
            value(s, "normal force", "hill.block")[bounded(s, 0.73)],
            (0.3 * G * (-3.0 * np.cos(np.radians(value(s, "deflection", "hill.block"))) - 2.0 * cos(radians(10.0))))[
                bounded(s, 0.73)
            ],
        ),
    ),
    (
        "static friction holds: it is the push, 3t, until that is µmg",
        motions.pushed_block,
        lambda s: (
            np.abs(value(s, "friction force", BLOCK)),
            np.where(s.times < 0.4 * G / 3.0, 3.0 * s.times, 0.4 * G),
        ),
    ),
    (
        "a slab and its block: the block slides at µg less, until both have p/(m + M)",
        motions.slab,
        lambda s: (
            size(s, "velocity", BLOCK),
            np.where(s.times < 2.0 / (0.4 * G), 2.0 - 0.3 * G * s.times, 0.5),
        ),
    ),
    (
        "pucks: relative speed after an oblique impact, its normal part times e",
        motions.pucks,
        lambda s: (
            value(s, "relative speed", "table.a & table.b"),
            np.where(s.times < 0.42, 2.0, 2.0 * sqrt(0.6**2 + (0.5 * 0.8) ** 2)),
        ),
    ),
    (
        "…: momentum of the struck one, (1 + e) v_n/(1/m₁ + 1/m₂) along the line of centres",
        motions.pucks,
        lambda s: (
            value(s, "momentum", "table.b"),
            np.where(s.times < 0.42, 0.0, 1.5 * 1.6 / 1.5)[:, None] * np.array([0.8, 0.0, 0.6]),
        ),
    ),
    (
        "a strut that lets go of a wall at 45°: it pushes with √2·m₁m₂g/(m₁ + m₂) at first",
        motions.strut,
        lambda s: (value(s, "rod force", "ladder.rod")[:1], -sqrt(2.0) * 2.0 / 3.0 * G),
    ),
]


@pytest.mark.parametrize(("motion", "check"), [each[1:] for each in CHECKS], ids=[each[0] for each in CHECKS])
def test_closed_form(motion: Callable[[], motions.Motion], check: Check) -> None:
    """The error is relative to the largest value."""
    study, _ = motion().told()
    found, expected = check(study.trace.state)
    scale = float(np.abs(np.broadcast_to(expected, found.shape)).max())
    assert np.abs(found - expected).max() <= CLOSE * scale


def test_the_potential_energy_of_a_planet_is_not_the_force_times_the_way() -> None:
    state = motions.orbit().told()[0].trace.state
    work = -np.einsum("ij,ij->i", value(state, "net force", PLANET), value(state, "displacement", PLANET))
    assert np.abs(work - value(state, "potential energy", PLANET)).max() > 0.5 * np.abs(work).max()


# ---- a body of an articulated system, by point masses


@pytest.fixture(scope="module")
def crane() -> State:
    """Return states of a cart with a uniform rod of 1 m, 0.6 kg hinged to it, and one of 0.8 m, 0.9 kg to that."""
    builder = Builder()
    cart = builder.room().body("cart", 2.0).slide(X, 0.7)
    upper = cart.body("upper", 0.6, center=(0.0, 0.0, -0.5), inertia=_thin(0.6, 1.0)).hinge(Y, 2.0)
    upper.body("lower", 0.9, at=(0.0, 0.0, -1.0), center=(0.0, 0.0, -0.4), inertia=_thin(0.9, 0.8)).hinge(Y, -3.0)
    assert Z
    return simulate(builder.finish(), np.linspace(0.0, 1.5, 31)).state


def _thin(mass: float, length: float) -> tuple[float, ...]:
    along = mass * length**2 / 12.0
    return (along, along, 0.0, 0.0, 0.0, 0.0)


class Points:
    """Lower rod as three points, m/6 at its ends and 2m/3 in the middle (Simpson), from coordinates alone."""

    def __init__(self, state: State) -> None:
        x, one, two = state.q.T
        xv, one_v, two_v = state.v.T
        xa, one_a, two_a = state.a.T
        angle, rate, change = -(one + two), -(one_v + two_v), -(one_a + two_a)  # about −y: x = s sin, z = −s cos
        first, first_v, first_a = -one, -one_v, -one_a
        self.masses = np.array([0.15, 0.6, 0.15])
        self.places, self.rates, self.changes = [], [], []
        for s in (0.0, 0.4, 0.8):
            place, speed, gain = [x, 0.0 * x], [xv, 0.0 * x], [xa, 0.0 * x]
            for length, q, v, a in ((1.0, first, first_v, first_a), (s, angle, rate, change)):
                place = [place[0] + length * np.sin(q), place[1] - length * np.cos(q)]
                speed = [speed[0] + length * v * np.cos(q), speed[1] + length * v * np.sin(q)]
                gain = [
                    gain[0] + length * (a * np.cos(q) - v**2 * np.sin(q)),
                    gain[1] + length * (a * np.sin(q) + v**2 * np.cos(q)),
                ]
            for kept, new in ((self.places, place), (self.rates, speed), (self.changes, gain)):
                kept.append(np.stack(new, axis=1))

    def total(self, of: list[Array]) -> Array:
        """Return Σ m·of, with x and z in columns."""
        return np.einsum("k,kni->ni", self.masses, np.array(of))

    def moment(self, of: list[Array]) -> Array:
        """Return Σ m (r − r_c) × of about y."""
        arms = np.array(self.places) - self.total(self.places) / 0.9
        turned = arms[:, :, 1] * np.array(of)[:, :, 0] - arms[:, :, 0] * np.array(of)[:, :, 1]
        return self.masses @ turned


def test_a_body_of_an_articulated_system_by_its_points(crane: State) -> None:
    """Sums over the points give P = Σ m v, F = Σ m a, L = Σ m (r − r_c) × v and the like.

    τ = Σ m (r − r_c) × a, K = Σ ½ m v²; neither König's theorem nor an inertia tensor is used.
    """
    points = Points(crane)
    flat = (0, 2)
    for found, expected in (
        (value(crane, "momentum", "lower")[:, flat], points.total(points.rates)),
        (value(crane, "net force", "lower")[:, flat], points.total(points.changes)),
        (value(crane, "angular momentum", "lower")[:, 1], points.moment(points.rates)),
        (value(crane, "torque", "lower")[:, 1], points.moment(points.changes)),
        (
            value(crane, "kinetic energy", "lower"),
            0.5 * points.masses @ np.array([(rate**2).sum(axis=1) for rate in points.rates]),
        ),
        (
            value(crane, "displacement", "lower")[:, flat],
            (points.total(points.places) - points.total(points.places)[0]) / 0.9,
        ),
    ):
        assert np.abs(found - expected).max() <= 1e-12 * np.abs(expected).max()


def test_energy_of_an_articulated_system_is_kept(crane: State) -> None:
    bodies = ("cart", "upper", "lower")
    energy = sum(value(crane, "kinetic energy", body) + value(crane, "potential energy", body) for body in bodies)
    assert np.abs(energy - energy[0]).max() <= 1e-9 * energy[0]
    parts = value(crane, "translational kinetic energy", "lower") + value(crane, "rotational kinetic energy", "lower")
    assert value(crane, "kinetic energy", "lower") == pytest.approx(parts, rel=1e-12)


def test_a_sum_over_the_whole_equals_what_acts_on_it_from_without(crane: State) -> None:
    """Without horizontal forces, total momentum along x is constant and the net forces along x cancel."""
    bodies = ("cart", "upper", "lower")
    along = sum(value(crane, "momentum", body)[:, 0] for body in bodies)
    assert np.abs(along - along[0]).max() <= 1e-9 * abs(along[0])
    assert np.abs(sum(value(crane, "net force", body)[:, 0] for body in bodies)).max() <= 1e-11
