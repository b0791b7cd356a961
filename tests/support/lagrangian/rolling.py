"""Equations of motion of bodies that roll or slide on faces, in bowls, on domes, hoops and rods."""

from collections.abc import Sequence
from math import cos, sin

import numpy as np

from lagrangian.follow import Array, Margin, Phase

G = 9.8


class Roller:
    """Round body on a rough incline, its centre of mass off its axis, with or without a spring from its axis.

    s is the displacement of its axis up the incline, φ its rotation in that sense, ψ = ψ₀ + φ the angle of its centre
    of mass C from the normal. With d = |OC| and the weight (−g sin β, −g cos β):
    m(s″ + dφ″ cos ψ − dφ′² sin ψ) = −mg sin β + f − k(s − s₀), m(−dφ″ sin ψ − dφ′² cos ψ) = N − mg cos β,
    Iφ″ = dN sin ψ − (R + d cos ψ)f + k(s − s₀)d cos ψ, by torques about C. It rolls (s″ = Rφ″) while |f| ≤ µN, else
    f = −µN sign(s′ − Rφ′), until s′ = Rφ′. Observed: s, φ, their rates, N, f.
    """

    def __init__(
        self,
        body: tuple[float, float, float],
        offset: tuple[float, float],
        face: tuple[float, float],
        spring: tuple[float, float] = (0.0, 0.0),
    ) -> None:
        """Take `body` as (m, I, R), `offset` as (d, ψ₀), `face` as (β, µ) and `spring` as (k, s₀)."""
        self.m, self.i, self.r = body
        self.d, self.psi = offset
        self.slope, self.mu = face
        self.k, self.rest = spring

    def solved(self, y: Array, side: int) -> Array:
        """Return s″, φ″, N and f; `side` is 0 for rolling without slipping."""
        s, turned, _, w = y
        a = self.psi + turned
        c, z = self.d * cos(a), self.d * sin(a)
        pull = -self.k * (s - self.rest)
        # the spring pulls at the axis, which lies at (−z, −c) from C: its torque, in the sense of φ, is −c·pull
        rows = [
            [self.m, self.m * c, 0.0, -1.0],
            [0.0, -self.m * z, -1.0, 0.0],
            [0.0, self.i, -z, self.r + c],
            [1.0, -self.r, 0.0, 0.0] if side == 0 else [0.0, 0.0, self.mu * side, 1.0],
        ]
        right = [
            self.m * z * w * w - self.m * G * sin(self.slope) + pull,
            self.m * c * w * w - self.m * G * cos(self.slope),
            -c * pull,
            0.0,
        ]
        return np.linalg.solve(np.array(rows), np.array(right))

    def begin(self, v: float, w: float) -> Phase:
        """Return the phase from s = φ = 0 at given rates."""
        y = np.array([0.0, 0.0, v, w])
        slip = v - self.r * w
        return self.phase(int(np.sign(slip)) if slip else self.side(y))

    def side(self, y: Array) -> int:
        """Return 0 if friction suffices for rolling, else the sense in which the body begins to slip."""
        _, _, normal, friction = self.solved(y, 0)
        return 0 if abs(friction) <= self.mu * normal else -int(np.sign(friction))

    def phase(self, side: int) -> Phase:
        def margin(pick: int) -> Margin:
            return lambda _, y: float(self.solved(y, side)[pick])

        margins: dict[str, Margin] = {"lift": margin(2)}
        if side:
            margins["stick"] = lambda _, y: side * (y[2] - self.r * y[3])
        else:
            margins["slip"] = lambda _, y: float(self.mu * self.solved(y, 0)[2] - abs(self.solved(y, 0)[3]))

        def after(name: str, _: float, y: Array) -> tuple[Phase, Array] | None:
            if name == "lift":
                return None
            if name == "slip":
                return self.phase(-int(np.sign(self.solved(y, 0)[3]))), y
            y = np.array([y[0], y[1], self.r * y[3], y[3]])
            return self.phase(self.side(y)), y

        return Phase(
            lambda _, y: [y[2], y[3], *self.solved(y, side)[:2]],
            lambda _, y: [*y, *self.solved(y, side)[2:]],
            margins,
            after,
        )


def in_bowl(mass: float, radius: float, friction: float) -> Phase:
    """Return a small block in a rough round trough, θ from the lowest point, which slides until it rests or turns.

    N = m(g cos θ + Rθ′²), Rθ″ = −g sin θ − µN sign(θ′)/m; at rest it stays if |tan θ| ≤ µ. Observed: θ, θ′, N, f.
    """

    def push(y: Array) -> float:
        return mass * (G * cos(y[0]) + radius * y[1] ** 2)

    def phase(side: int) -> Phase:
        def rubbed(y: Array) -> float:
            return -friction * side * push(y) if side else mass * G * sin(y[0])

        def rate(_: float, y: Array) -> list[float]:
            return [y[1], (-G * sin(y[0]) + rubbed(y) / mass) / radius]

        def after(_: str, __: float, y: Array) -> tuple[Phase, list[float]]:
            stays = abs(sin(y[0])) <= friction * cos(y[0])
            return phase(0 if stays else -int(np.sign(y[0]))), [y[0], 0.0]

        margins: dict[str, Margin] = {"stop": lambda _, y: side * y[1]} if side else {}
        return Phase(rate, lambda _, y: [*y, push(y), rubbed(y)], margins, after)

    return phase(-1)


def on_dome(mass: float, radius: float) -> Phase:
    """Return a small block on a smooth dome, θ from the top.

    Rθ″ = g sin θ, N = m(g cos θ − Rθ′²) until that is zero.
    """

    def push(_: float, y: Array) -> float:
        return mass * (G * cos(y[0]) - radius * y[1] ** 2)

    return Phase(lambda _, y: [y[1], G / radius * sin(y[0])], lambda t, y: [*y, push(t, y)], {"lift": push})


def on_turning_hoop(inertia: float, mass: float, radius: float) -> Phase:
    """Return a bead on a smooth hoop that turns freely about its vertical diameter at a rate Ω.

    θ is counted from the lowest point.
    L = ½JΩ² + ½mR²(θ′² + Ω² sin²θ) + mgR cos θ; (J + mR² sin²θ)Ω is constant. In the plane of the hoop the force on
    the bead is N = m(g cos θ + Rθ′² + RΩ² sin²θ), inwards. Observed: the hoop's angle, θ, Ω, θ′, N.
    """

    def rate(_: float, y: Array) -> list[float]:
        _f, t, turn, w = y
        whole = inertia + mass * radius**2 * sin(t) ** 2
        return [
            turn,
            w,
            -2.0 * mass * radius**2 * sin(t) * cos(t) * w * turn / whole,
            turn * turn * sin(t) * cos(t) - G / radius * sin(t),
        ]

    def observe(_: float, y: Array) -> list[float]:
        push = mass * (G * cos(y[1]) + radius * y[3] ** 2 + radius * (y[2] * sin(y[1])) ** 2)
        return [*y, push]

    return Phase(rate, observe)


def on_turning_rod(inertia: float, mass: float, spring: tuple[float, float]) -> Phase:
    """Return a bead on a smooth rod that turns freely about an upright axis, held by a spring (k, r₀) there.

    L = ½(J + mr²)φ′² + ½mr′² − ½k(r − r₀)². Observed: φ, r, their rates.
    """
    k, rest = spring

    def rate(_: float, y: Array) -> list[float]:
        _f, r, w, v = y
        return [w, v, -2.0 * mass * r * v * w / (inertia + mass * r * r), r * w * w - k / mass * (r - rest)]

    return Phase(rate, lambda _, y: list(y))


class Ladder:
    """Light rod between a block on a rough floor and one on a rough upright wall, φ its angle to the floor.

    The floor's block at x = ℓ cos φ, the wall's at z = ℓ sin φ; C the rod's push along its line:
    m x″ = C cos φ − µ₁N₁ sign(x′), N₁ = mg + C sin φ; M z″ = C sin φ − Mg − µ₂N₂ sign(z′), N₂ = C cos φ,
    with x″ = −ℓ(φ″ sin φ + φ′² cos φ), z″ = ℓ(φ″ cos φ − φ′² sin φ). It ends when the wall's block leaves.
    Observed: x, z, their rates, N₁, N₂, C.
    """

    def __init__(self, masses: tuple[float, float], friction: tuple[float, float], long: float) -> None:
        self.m, self.mu, self.long = masses, friction, long

    def solved(self, y: Array) -> Array:
        """Return φ″ and C for the rod sliding down and away from the wall."""
        (foot, top), (mu1, mu2), (a, w) = self.m, self.mu, y
        c, s, long = cos(a), sin(a), self.long
        # x′ > 0: friction on the floor's block −µ₁N₁; z′ < 0: on the wall's +µ₂N₂
        rows = [[-foot * long * s, -(c - mu1 * s)], [top * long * c, -(s + mu2 * c)]]
        right = [foot * long * w * w * c - mu1 * foot * G, top * long * w * w * s - top * G]
        return np.linalg.solve(np.array(rows), np.array(right))

    def observe(self, _: float, y: Array) -> Sequence[float]:
        (a, w), push = y, float(self.solved(y)[1])
        place = [self.long * cos(a), self.long * sin(a)]
        speed = [-self.long * sin(a) * w, self.long * cos(a) * w]
        return [*place, *speed, self.m[0] * G + push * sin(a), push * cos(a), push]

    @property
    def phase(self) -> Phase:
        """Return the phase that lasts until the wall's block leaves the wall."""
        return Phase(
            lambda _, y: [y[1], self.solved(y)[0]], self.observe, {"lift": lambda _, y: float(self.solved(y)[1])}
        )


def hexagonal_prism(side: float, slope: float, inertia_factor: float, mass: float) -> Phase:
    """Return a hexagonal prism that tips over its edges down a rough incline, without slipping or bouncing.

    About the edge it stands on, α from the upright of the edge to the centre: (I + ma²)α″ = mga sin α, a the side and
    I = κma². When the next edge lands, α = β + 30°, the angular momentum about it is conserved:
    (I + ma²)ω⁺ = (I + ma² cos 60°)ω⁻. Observed: the centre's position (right, up), the angle turned, and their rates.
    """
    kappa = inertia_factor
    ratio = (kappa + 0.5) / (kappa + 1.0)
    down = np.array([cos(slope), -sin(slope)])
    del mass

    def phase(number: int) -> Phase:
        edge = (number + 0.5) * side * down  # from the foot of the centre's first perpendicular

        def observe(_: float, y: Array) -> list[float]:
            a, w = y
            place = edge + side * np.array([sin(a), cos(a)])
            turned = a - (slope - np.pi / 6.0) + number * np.pi / 3.0
            return [*place, turned, side * w * cos(a), -side * w * sin(a), w]

        def after(_: str, __: float, y: Array) -> tuple[Phase, list[float]]:
            return phase(number + 1), [y[0] - np.pi / 3.0, ratio * y[1]]

        margins: dict[str, Margin] = {"land": lambda _, y: slope + np.pi / 6.0 - y[0]}
        return Phase(lambda _, y: [y[1], G * sin(y[0]) / (side * (kappa + 1.0))], observe, margins, after)

    return phase(0)
