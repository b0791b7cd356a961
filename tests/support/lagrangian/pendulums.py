"""Equations of motion of pendulums: on rods and strings, on carts and on each other, in a plane and in space.

Angles θ are counted from straight down towards +x; u = (sin θ, −cos θ) points outwards along a string.
"""

from collections.abc import Sequence
from math import cos, hypot, sin

import numpy as np

from lagrangian.follow import Array, Phase

G = 9.8


def double_compound(first: Sequence[float], second: Sequence[float]) -> Phase:
    """Return two rigid bodies in a row, each as (mass, inertia, distance of its centre of mass).

    The first has the length ℓ to the second hinge.
    L = ½(m₁a₁² + I₁ + m₂ℓ²)θ₁′² + ½(m₂a₂² + I₂)θ₂′² + m₂ℓa₂θ₁′θ₂′ cos(θ₁ − θ₂) + (m₁a₁ + m₂ℓ)g cos θ₁ + m₂a₂g cos θ₂;
    observed: both angles and their rates.
    """
    m1, i1, a1, long = first
    m2, i2, a2 = second

    def rate(_: float, y: Array) -> list[float]:
        t1, t2, w1, w2 = y
        c, s = m2 * long * a2 * cos(t1 - t2), m2 * long * a2 * sin(t1 - t2)
        p, q = m1 * a1 * a1 + i1 + m2 * long * long, m2 * a2 * a2 + i2
        r1 = -s * w2 * w2 - (m1 * a1 + m2 * long) * G * sin(t1)
        r2 = s * w1 * w1 - m2 * a2 * G * sin(t2)
        return [w1, w2, (q * r1 - c * r2) / (p * q - c * c), (p * r2 - c * r1) / (p * q - c * c)]

    return Phase(rate, lambda _, y: list(y))


def double_rods(m1: float, m2: float, l1: float, l2: float) -> Phase:
    """Return two bobs on light rods, with the Lagrangian of `double_compound` for aᵢ = ℓᵢ and Iᵢ = 0.

    Observed: x, z, their rates, of both bobs; then the tensions T₂ = −m₂(r₂″ − g)·u₂, T₁ = −m₁(r₁″ − g)·u₁ + T₂u₁·u₂.
    """
    phase = double_compound((m1, 0.0, l1, l1), (m2, 0.0, l2))

    def observe(t: float, y: Array) -> list[float]:
        t1, t2, w1, w2 = y
        b1, b2 = phase.rate(t, y)[2:]
        u1, u2 = np.array([sin(t1), -cos(t1)]), np.array([sin(t2), -cos(t2)])
        n1, n2 = np.array([cos(t1), sin(t1)]), np.array([cos(t2), sin(t2)])
        v1 = l1 * w1 * n1
        a1 = l1 * (b1 * n1 - w1 * w1 * u1)
        a2 = a1 + l2 * (b2 * n2 - w2 * w2 * u2)
        up = np.array([0.0, G])
        tension2 = -m2 * (a2 + up) @ u2
        tension1 = -m1 * (a1 + up) @ u1 + tension2 * (u1 @ u2)
        return [*(l1 * u1), *(l1 * u1 + l2 * u2), *v1, *(v1 + l2 * w2 * n2), tension1, tension2]

    return Phase(phase.rate, observe)


def on_string(mass: float, long: float) -> Phase:
    """Return a bob on a string that may go slack.

    θ″ = −g sin θ/ℓ while T = mg cos θ + mℓθ′² > 0; then a parabola until the string is taut again. The velocity along
    the string is lost then. Observed: x, z, their rates, T.
    """

    def flies(_: float, y: Array) -> list[float]:
        return [y[2], y[3], 0.0, -G]

    def pull(_: float, y: Array) -> float:
        return mass * (G * cos(y[0]) + long * y[1] ** 2)

    def swing(_: float, y: Array) -> list[float]:
        t, w = y
        return [long * sin(t), -long * cos(t), long * w * cos(t), long * w * sin(t), pull(_, y)]

    def slack(_: str, t: float, y: Array) -> tuple[Phase, list[float]]:
        return free, swing(t, y)[:4]

    def taut(_: str, __: float, y: Array) -> tuple[Phase, list[float]]:
        x, z, vx, vz = y
        return held, [float(np.arctan2(x, -z)), float((vx * -z + vz * x) / long**2)]

    held = Phase(lambda _, y: [y[1], -G / long * sin(y[0])], swing, {"slack": pull}, slack)
    free = Phase(flies, lambda _, y: [*y, 0.0], {"taut": lambda _, y: long - hypot(y[0], y[1])}, taut)
    return held


def on_cart(cart: float, bob: float, long: float) -> Phase:
    """Return a bob on a light rod that hangs from a cart on a level, smooth rail.

    L = ½(M + m)x′² + mℓx′θ′ cos θ + ½mℓ²θ′² + mgℓ cos θ. The rod's pull is T = m(g cos θ + ℓθ′² − x″ sin θ), the
    rail's push N = Mg + T cos θ. Observed: x, bob's position relative to the cart, all velocities, T, N.
    """

    def rate(_: float, y: Array) -> list[float]:
        _x, t, v, w = y
        c, s = cos(t), sin(t)
        a = bob * s * (long * w * w + G * c) / (cart + bob * s * s)
        return [v, w, a, -(a * c + G * s) / long]

    def observe(t: float, y: Array) -> list[float]:
        x, o, v, w = y
        pull = bob * (G * cos(o) + long * w * w - rate(t, y)[2] * sin(o))
        place, speed = [long * sin(o), -long * cos(o)], [v, v + long * w * cos(o), long * w * sin(o)]
        return [x, *place, *speed, pull, cart * G + pull * cos(o)]

    return Phase(rate, observe)


def on_spring_cart(masses: Sequence[float], long: float, spring: Sequence[float], slope: float) -> Phase:
    """Return a compound pendulum on a cart on an incline, held by a damped spring (k, c, x₀).

    The cart's mass is M, the pendulum's m, I about its centre, ℓ from the hinge; the cart is at x along the incline,
    e = (cos β, sin β), the pendulum at θ from the vertical, n = (cos θ, sin θ):
    L = ½Mx′² + ½m|x′e + ℓθ′n|² + ½Iθ′² − (M + m)gx sin β + mgℓ cos θ − ½k(x − x₀)², and −cx′ acts on x.
    Observed: x, θ, their rates.
    """
    cart, bob, inertia = masses
    k, damping, rest = spring

    def rate(_: float, y: Array) -> list[float]:
        x, t, v, w = y
        c, s = bob * long * cos(t - slope), bob * long * sin(t - slope)
        p, q = cart + bob, bob * long * long + inertia
        r1 = s * w * w - (cart + bob) * G * sin(slope) - k * (x - rest) - damping * v
        r2 = -bob * G * long * sin(t)
        return [v, w, (q * r1 - c * r2) / (p * q - c * c), (p * r2 - c * r1) / (p * q - c * c)]

    return Phase(rate, lambda _, y: list(y))


def swinging_atwood(heavy: float, bob: float) -> Phase:
    """Return a bob that swings on a string whose other end holds a weight; r is the length on the bob's side.

    L = ½(M + m)r′² + ½mr²θ′² + mgr cos θ − Mgr; T = M(g + r″). Observed: r, bob's position, r′, its velocity, T.
    """

    def rate(_: float, y: Array) -> list[float]:
        r, t, v, w = y
        a = (bob * r * w * w + bob * G * cos(t) - heavy * G) / (heavy + bob)
        return [v, w, a, -(2.0 * v * w + G * sin(t)) / r]

    def observe(t: float, y: Array) -> list[float]:
        r, o, v, w = y
        speed = [v * sin(o) + r * w * cos(o), -v * cos(o) + r * w * sin(o)]
        return [r, r * sin(o), -r * cos(o), v, *speed, heavy * (G + rate(t, y)[2])]

    return Phase(rate, observe)


def winched(mass: float, long: float, reel: float) -> Phase:
    """Return a pendulum whose string is wound in at constant speed: (ℓ²θ′)′ = −gℓ sin θ with ℓ = ℓ₀ − ut.

    T = mg cos θ + mℓθ′². Observed: x, z, their rates, T.
    """

    def rate(t: float, y: Array) -> list[float]:
        r = long - reel * t
        return [y[1], (2.0 * reel * y[1] - G * sin(y[0])) / r]

    def observe(t: float, y: Array) -> list[float]:
        (o, w), r = y, long - reel * t
        speed = [-reel * sin(o) + r * w * cos(o), reel * cos(o) + r * w * sin(o)]
        return [r * sin(o), -r * cos(o), *speed, mass * (G * cos(o) + r * w * w)]

    return Phase(rate, observe)


def conical(mass: float, long: float) -> Phase:
    """Return a bob on a light rod in space.

    θ″ = φ′² sin θ cos θ − g sin θ/ℓ, (φ′ sin²θ)′ = 0, by Euler and Lagrange.
    T = m(g cos θ + ℓθ′² + ℓφ′² sin²θ). Observed: x, y, z, their rates, T.
    """

    def rate(_: float, y: Array) -> list[float]:
        t, _f, w, h = y  # h = φ′ sin²θ
        return [w, h / sin(t) ** 2, h * h * cos(t) / sin(t) ** 3 - G * sin(t) / long, 0.0]

    def observe(_: float, y: Array) -> list[float]:
        t, f, w, h = y
        turn = h / sin(t) ** 2
        place = [sin(t) * cos(f), sin(t) * sin(f), -cos(t)]
        across = [w * cos(t) * cos(f) - turn * place[1], w * cos(t) * sin(f) + turn * place[0], w * sin(t)]
        pull = mass * (G * cos(t) + long * (w * w + turn * h))
        return [*(long * part for part in (*place, *across)), pull]

    return Phase(rate, observe)


def bob_on_string_on_body(body: Sequence[float], bob: float, long: float) -> Phase:
    """Return a rigid body (M, I, a) on a hinge, and a bob on a string from its point at distance b.

    Taut: `double_compound` with the bob as the second body, T = −m(r″ − g)·u₂. Slack: the body is a pendulum, the bob
    falls. Taut again: an impulse J along the string after which its ends have equal velocities along it:
    J(1/m + (b n₁·u)²/(I + Ma²)) = speed of parting. Observed: θ₁, bob's position, θ₁′, its velocity, T.
    """
    mass, inertia, a, b = body
    whole = inertia + mass * a * a
    both = double_compound((mass, inertia, a, b), (bob, 0.0, long))

    def ends(t1: float, w1: float) -> tuple[Array, Array]:
        return b * np.array([sin(t1), -cos(t1)]), b * w1 * np.array([cos(t1), sin(t1)])

    def pull(t: float, y: Array) -> float:
        t1, t2, w1, w2 = y
        b1, b2 = both.rate(t, y)[2:]
        u = np.array([sin(t2), -cos(t2)])
        point = b * (b1 * np.array([cos(t1), sin(t1)]) - w1 * w1 * np.array([sin(t1), -cos(t1)]))
        a2 = point + long * (b2 * np.array([cos(t2), sin(t2)]) - w2 * w2 * u)
        return float(-bob * (a2 + np.array([0.0, G])) @ u)

    def swing(t: float, y: Array) -> list[float]:
        t1, t2, w1, w2 = y
        point, speed = ends(t1, w1)
        place = point + long * np.array([sin(t2), -cos(t2)])
        return [t1, *place, w1, *(speed + long * w2 * np.array([cos(t2), sin(t2)])), pull(t, y)]

    def slack(_: str, t: float, y: Array) -> tuple[Phase, list[float]]:
        return free, swing(t, y)[:6]

    def flies(_: float, y: Array) -> list[float]:
        return [y[3], y[4], y[5], -mass * a * G * sin(y[0]) / whole, 0.0, -G]

    def spare(_: float, y: Array) -> float:
        point, _speed = ends(y[0], y[3])
        return long - float(np.hypot(*(y[1:3] - point)))

    def taut(_: str, __: float, y: Array) -> tuple[Phase, list[float]]:
        point, speed = ends(y[0], y[3])
        apart, parting = y[1:3] - point, y[4:6] - speed
        u = apart / np.hypot(*apart)
        lever = b * float(np.array([cos(y[0]), sin(y[0])]) @ u)
        impulse = float(u @ parting) / (1.0 / bob + lever**2 / whole)
        w1 = y[3] + impulse * lever / whole
        across = y[4:6] - impulse / bob * u - ends(y[0], w1)[1]
        n = np.array([-u[1], u[0]])
        return held, [y[0], float(np.arctan2(u[0], -u[1])), w1, float(across @ n) / long]

    held = Phase(both.rate, swing, {"slack": pull}, slack)
    free = Phase(flies, lambda _, y: [*y, 0.0], {"taut": spare}, taut)
    return held
