"""Equations of motion of rigid bodies that rotate in space."""

from math import cos, sin

import numpy as np

from lagrangian.follow import Array, Phase


def heavy_top(across: float, along: float, weight: float) -> Phase:
    """Return Lagrange's top on a fixed point.

    A, A and C are the moments of inertia about the point, and `weight` is mg times the distance to the centre of mass.
    With θ from the upright, φ the precession, ψ the spin: (Aφ′ sin²θ + Cn cos θ)′ = 0, n = ψ′ + φ′ cos θ is constant,
    Aθ″ = Aφ′² sin θ cos θ − Cnφ′ sin θ + mgℓ sin θ (Goldstein, Classical Mechanics, 5.7).

    Observed: φ, θ, ψ, their rates.
    """

    def rates(y: Array) -> tuple[float, float]:
        _f, t, _s, _w, p, n = y
        turn = (p - along * n * cos(t)) / (across * sin(t) ** 2)
        return turn, n - turn * cos(t)

    def rate(_: float, y: Array) -> list[float]:
        t, w, n = y[1], y[3], y[5]
        turn, spin = rates(y)
        bend = turn * turn * sin(t) * cos(t) - along * n / across * turn * sin(t) + weight / across * sin(t)
        return [turn, w, spin, bend, 0.0, 0.0]

    def observe(_: float, y: Array) -> list[float]:
        turn, spin = rates(y)
        return [y[0], y[1], y[2], turn, y[3], spin]

    return Phase(rate, observe)


def top_start(across: float, along: float, tilt: float, precession: float, spin: float) -> list[float]:
    """Return the initial values of `heavy_top` for rates φ′ and ψ′, with θ′ = 0."""
    n = spin + precession * cos(tilt)
    return [0.0, tilt, 0.0, 0.0, across * precession * sin(tilt) ** 2 + along * n * cos(tilt), n]


def free_body(moments: tuple[float, float, float]) -> Phase:
    """Return a body without torque by Euler's equations in body axes, Iω′ = Iω × ω, with its rotation matrix R.

    R′ = R[ω]×. Observed: the directions of its three axes, nine components, row by row of R, and ω in the room.
    """
    inertia = np.array(moments)

    def rate(_: float, y: Array) -> Array:
        w, turn = y[:3], y[3:].reshape(3, 3)
        cross = np.array([[0.0, -w[2], w[1]], [w[2], 0.0, -w[0]], [-w[1], w[0], 0.0]])
        return np.concatenate([np.cross(inertia * w, w) / inertia, (turn @ cross).ravel()])

    return Phase(rate, lambda _, y: [*y[3:], *(y[3:].reshape(3, 3) @ y[:3])])
