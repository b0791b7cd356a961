"""Equations of motion of bodies on springs: in chains with friction, at angles, damped, struck, on wedges."""

from collections.abc import Sequence
from itertools import pairwise
from math import cos, sin

import numpy as np

from lagrangian.follow import Array, Margin, Phase

G = 9.8


class RoughChain:
    """Blocks in a row on a rough floor, each joined to the next by a spring, the first to a wall.

    mᵢxᵢ″ = Fᵢ − µᵢmᵢg sign(xᵢ′), Fᵢ = −kᵢeᵢ + kᵢ₊₁eᵢ₊₁; the extension of spring i is eᵢ = xᵢ − xᵢ₋₁ plus that at
    the start; a block at rest stays while |Fᵢ| ≤ µᵢmᵢg. Observed: all x, all x′, all friction.
    """

    def __init__(
        self, masses: Sequence[float], friction: Sequence[float], stiffness: Sequence[float], stretched: Sequence[float]
    ) -> None:
        self.m, self.k, self.e = np.array(masses), np.array(stiffness), np.array(stretched)
        self.bound = G * np.array(friction) * self.m
        self.n = len(masses)

    def loads(self, x: Array) -> Array:
        pull = self.k * (np.diff(x, prepend=0.0) + self.e)
        return -pull + np.append(pull[1:], 0.0)

    def begin(self, v: Sequence[float]) -> Phase:
        """Return the phase from natural lengths at given speeds."""
        return self.phase(self.sides(np.zeros(self.n), np.array(v), set(range(self.n))))

    def sides(self, x: Array, v: Array, free: set[int]) -> tuple[int, ...]:
        """Return the sense in which each block slides, 0 for static friction.

        A block in `free` with zero speed moves in the direction of its load if that exceeds the friction.
        """
        found = [int(np.sign(speed)) for speed in v]
        for i, load in enumerate(self.loads(x)):
            if i in free and v[i] == 0.0 and abs(load) > self.bound[i]:
                found[i] = int(np.sign(load))
        return tuple(found)

    def phase(self, sides: tuple[int, ...]) -> Phase:
        n, way = self.n, np.array(sides)

        def rubbed(y: Array) -> Array:
            return np.where(way == 0, -self.loads(y[:n]), -self.bound * way)

        def rate(_: float, y: Array) -> Array:
            return np.concatenate([y[n:], (self.loads(y[:n]) + rubbed(y)) / self.m])

        margins: dict[str, Margin] = {}
        for i, side in enumerate(sides):
            if side:
                margins[f"stop {i}"] = lambda _, y, i=i, s=side: s * y[n + i]
            else:
                margins[f"slip {i}"] = lambda _, y, i=i: self.bound[i] - abs(self.loads(y[:n])[i])
        return Phase(rate, lambda _, y: [*y, *rubbed(y)], margins, lambda name, _, y: self.after(sides, name, y))

    def after(self, sides: tuple[int, ...], name: str, y: Array) -> tuple[Phase, Array]:
        kind, number = name.split()
        i, new, y = int(number), list(sides), y.copy()
        load = self.loads(y[: self.n])[i]
        if kind == "slip":
            new[i] = int(np.sign(load))
        else:
            y[self.n + i] = 0.0
            new[i] = int(np.sign(load)) if abs(load) > self.bound[i] else 0
        return self.phase(tuple(new)), y


def net(
    masses: Sequence[float], springs: Sequence[tuple[int, int | Array, float, float, float]], gravity: float
) -> Phase:
    """Return particles in a vertical plane, joined by damped springs to each other and to nails.

    A spring is (particle, particle or position of a nail, k, natural length, c); it pulls with k(ℓ − ℓ₀) + cℓ′ along
    its line. Observed: all positions, all velocities, then all tensions.
    """
    m, n = np.array(masses), len(masses)

    def pulls(y: Array) -> tuple[Array, list[float]]:
        places, speeds = y[: 2 * n].reshape(n, 2), y[2 * n :].reshape(n, 2)
        force, tensions = np.zeros((n, 2)), list[float]()
        for one, other, k, rest, damping in springs:
            if isinstance(other, int):
                apart, parting = places[other] - places[one], speeds[other] - speeds[one]
            else:
                apart, parting = other - places[one], -speeds[one]
            long = float(np.hypot(*apart))
            way = apart / long
            tension = k * (long - rest) + damping * float(way @ parting)
            force[one] += tension * way
            if isinstance(other, int):
                force[other] -= tension * way
            tensions.append(tension)
        return force, tensions

    def rate(_: float, y: Array) -> Array:
        a = pulls(y)[0] / m[:, None] - np.array([0.0, gravity])
        return np.concatenate([y[2 * n :], a.ravel()])

    return Phase(rate, lambda _, y: [*y, *pulls(y)[1]])


def elastic_pendulum(mass: float, k: float, rest: float) -> Phase:
    """Return a bob on a spring in polar coordinates: r″ = rθ′² + g cos θ − k(r − ℓ₀)/m, (r²θ′)′ = −gr sin θ.

    Observed: x, z, their rates, the tension.
    """

    def rate(_: float, y: Array) -> list[float]:
        r, t, v, w = y
        return [v, w, r * w * w + G * cos(t) - k / mass * (r - rest), -(2.0 * v * w + G * sin(t)) / r]

    def observe(_: float, y: Array) -> list[float]:
        r, t, v, w = y
        speed = [v * sin(t) + r * w * cos(t), -v * cos(t) + r * w * sin(t)]
        return [r * sin(t), -r * cos(t), *speed, k * (r - rest)]

    return Phase(rate, observe)


def on_wedge(wedge: float, block: float, angle: float, spring: tuple[float, float]) -> Phase:
    """Return a block on a smooth wedge on a smooth floor, tied to the wedge's top by a spring (k, e₀).

    s is the displacement of the block up the face, e₀ the extension of the spring at s = 0:
    L = ½(M + m)X′² + mX′s′ cos α + ½ms′² − mgs sin α − ½k(e₀ − s)². The face pushes with N = m(g cos α − X″ sin α), the
    floor with Mg + N cos α + k(e₀ − s) sin α. Observed: X, s, their rates, both pushes, the tension.
    """
    k, stretched = spring
    c, s = cos(angle), sin(angle)

    def rate(_: float, y: Array) -> list[float]:
        along = k * (stretched - y[1]) - block * G * s
        a = -along * c / (wedge + block - block * c * c)
        return [y[2], y[3], a, along / block - a * c]

    def observe(t: float, y: Array) -> list[float]:
        normal, pull = block * (G * c - rate(t, y)[2] * s), k * (stretched - y[1])
        return [*y, wedge * G + normal * c + pull * s, normal, pull]

    return Phase(rate, observe)


def struck(ball: float, block: float, k: float, distance: float, restitution: float) -> Phase:
    """Return a ball that runs into a block on a spring on a smooth floor, once or repeatedly.

    Between collisions the block oscillates with ω² = k/m; each collision: J = (1 + e)µ·(speed of approach),
    µ = mM/(m + M). Observed: both displacements x and y of ball and block, both rates; `distance` is that between them
    at the start.
    """
    reduced = ball * block / (ball + block)

    def rate(_: float, y: Array) -> list[float]:
        return [y[2], y[3], 0.0, -k / block * y[1]]

    def after(_: str, __: float, y: Array) -> tuple[Phase, list[float]]:
        impulse = (1.0 + restitution) * reduced * (y[2] - y[3])
        return phase, [y[0], y[1], y[2] - impulse / ball, y[3] + impulse / block]

    phase = Phase(rate, lambda _, y: list(y), {"hit": lambda _, y: distance + y[1] - y[0]}, after)
    return phase


def ring(links: Sequence[int]) -> list[tuple[int, int]]:
    """Return the pairs of neighbours in a closed ring."""
    return list(pairwise([*links, links[0]]))
