"""Equations of motion of attracting bodies, rockets, balls in air, and charges in fields."""

from collections.abc import Sequence
from math import cos, hypot, pi, sin, sqrt

import numpy as np

from lagrangian.follow import Array, Phase


def attracting(masses: Sequence[float], constant: float, fixed: int | None = None) -> Phase:
    """Return particles in a plane under Newton's law rᵢ″ = Σ Gmⱼ(rⱼ − rᵢ)/|rⱼ − rᵢ|³; one may be fixed.

    Observed: all positions, all velocities.
    """
    m, n = np.array(masses), len(masses)

    def rate(_: float, y: Array) -> Array:
        r = y[: 2 * n].reshape(n, 2)
        apart = r[None, :, :] - r[:, None, :]
        cubes = (apart**2).sum(axis=2) ** 1.5 + np.eye(n)
        a = constant * (m[None, :, None] * apart / cubes[:, :, None]).sum(axis=1)
        if fixed is not None:
            a[fixed] = 0.0
        return np.concatenate([y[2 * n :], a.ravel()])

    return Phase(rate, lambda _, y: list(y))


def kepler(major: float, eccentricity: float, strength: float, times: Array) -> Array:
    """Return position and velocity on an ellipse from its nearest point, by Kepler's equation M = E − e sin E.

    x = a(cos E − e), y = a√(1 − e²) sin E, E′ = n/(1 − e cos E), n² = GM/a³.
    """
    n, e = sqrt(strength / major**3), eccentricity
    rows: list[list[float]] = []
    for mean in n * times:
        anomaly = mean + e * sin(mean)
        for _ in range(50):
            anomaly -= (anomaly - e * sin(anomaly) - mean) / (1.0 - e * cos(anomaly))
        turn, flat = n / (1.0 - e * cos(anomaly)), sqrt(1.0 - e * e)
        place = [major * (cos(anomaly) - e), major * flat * sin(anomaly)]
        rows.append([*place, -major * sin(anomaly) * turn, major * flat * cos(anomaly) * turn])
    return np.array(rows)


def rocket(full: float, burn: tuple[float, float, float], pull: float) -> Phase:
    """Return a rocket near a planet at the origin, with `burn` as (ṁ, u, time).

    r″ = −GM r/r³ + (0, uṁ/(m₀ − ṁt)) until burn-out. Observed: position, velocity.
    """
    flow, exhaust, until = burn

    def falls(y: Array) -> Array:
        return -pull * y[:2] / hypot(y[0], y[1]) ** 3

    def burns(t: float, y: Array) -> Array:
        return np.concatenate([y[2:], falls(y) + np.array([0.0, exhaust * flow / (full - flow * t)])])

    coast = Phase(lambda _, y: np.concatenate([y[2:], falls(y)]), lambda _, y: list(y))
    return Phase(burns, lambda _, y: list(y), {"burn-out": lambda t, _: until - t}, lambda _, __, y: (coast, y))


def bouncing(mass: float, drag: tuple[float, float], restitution: float) -> Phase:
    """Return a ball in air over level ground that rebounds with e times its vertical speed.

    mr″ = −mg − (c₁ + c₂|v|)v. Observed: position, velocity.
    """
    one, two = drag

    def rate(_: float, y: Array) -> list[float]:
        factor = (one + two * hypot(y[2], y[3])) / mass
        return [y[2], y[3], -factor * y[2], -9.8 - factor * y[3]]

    def after(_: str, __: float, y: Array) -> tuple[Phase, list[float]]:
        return phase, [y[0], 0.0, y[2], -restitution * y[3]]

    phase = Phase(rate, lambda _, y: list(y), {"land": lambda _, y: y[1]}, after)
    return phase


def charge_in_disc(
    per_mass: tuple[float, float], electric: tuple[float, float], disc: tuple[Sequence[float], float]
) -> Phase:
    """Return a charge in a plane, with uniform B across it and E = (E₀ + E′x, 0) inside a disc only.

    `per_mass` is (q/m, B), B along −y of (x, y, z) so that the plane (x, z) is right-handed:
    x″ = (q/m)(E₀ + E′x + Bz′), z″ = −(q/m)Bx′. Observed: position, velocity.
    """
    ratio, b = per_mass
    center, radius = disc

    def inside(_: float, y: Array) -> float:
        return radius - hypot(y[0] - center[0], y[1] - center[1])

    def turns(_: float, y: Array) -> list[float]:
        field = electric[0] + electric[1] * y[0]
        return [y[2], y[3], ratio * (field + b * y[3]), -ratio * b * y[2]]

    outer = Phase(
        lambda _, y: [y[2], y[3], 0.0, 0.0],
        lambda _, y: list(y),
        {"enter": lambda t, y: -inside(t, y)},
        lambda _, __, y: (inner, y),
    )
    inner = Phase(turns, lambda _, y: list(y), {"exit": inside}, lambda _, __, y: (outer, y))
    return outer


def charge_in_space(ratio: float, magnetic: tuple[float, float], electric: tuple[float, float]) -> Phase:
    """Return a charge in space with B = (0, 0, B₀ + B′t) and E = (E₀ cos ωt, 0, 0).

    x″ = (q/m)(E₀ cos ωt + By′), y″ = −(q/m)Bx′, z″ = 0. Observed: position, velocity.
    """
    strength, growth = magnetic
    size, frequency = electric

    def rate(t: float, y: Array) -> list[float]:
        b = strength + growth * t
        return [*y[3:], ratio * (size * cos(frequency * t) + b * y[4]), -ratio * b * y[3], 0.0]

    return Phase(rate, lambda _, y: list(y))


FULL_TURN = 2.0 * pi
