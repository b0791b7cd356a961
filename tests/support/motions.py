"""Motions of every kind, each small enough to be solved on paper, with the words of a text about it."""

from collections.abc import Callable, Mapping
from functools import cache
from math import cos, inf, pi, radians, sin, sqrt

import numpy as np

from plain_scenes import ramp
from sim2reason.questions import SimulatedScene, Words
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.fields import Magnetic, Profile, Push
from sim2reason.scenes.dsl.mechanism import ZERO, Mechanism, X, Y, Z
from sim2reason.scenes.dsl.units import SI, UnitSystem
from sim2reason.scenes.dsl.vectors import HalfSpace
from sim2reason.simulation.engines.exact import simulate

G = 9.8
SAMPLES = 41


class Motion:
    """Mechanism with its names in the text and the duration of its motion."""

    def __init__(self, mechanism: Mechanism, mentions: Mapping[str, str], duration: float) -> None:
        """Take `mentions` as the bodies, springs and strings of the text by address."""
        self.mechanism, self.mentions, self.duration = mechanism, mentions, duration

    def told(self) -> tuple[SimulatedScene, Words]:
        """Return the motion by the exact engine, and the words of a text that states every number."""
        trace = simulate(self.mechanism, np.linspace(0.0, self.duration, SAMPLES))
        numbers = ("mass", "charge", "stiffness", "length")
        said = frozenset(f"{name}.{number}" for name in self.mentions for number in numbers)
        released = not any(c.speed for c in self.mechanism.coordinates)
        return SimulatedScene(ramp(), trace), Words(self.mechanism, self.mentions, released, said)


def string_pendulum(share: float = 3.5, length: float = 1.0) -> Motion:
    """Build a bob hanging on a string and struck with v₀² = share·gℓ; for 2 < share < 5 the string goes slack."""
    builder = Builder()
    room = builder.room("swing")
    room.site("point")
    bob = room.body("bob", 0.5, at=(0.0, 0.0, -length))
    bob.slide(X, sqrt(share * G * length), name="across").slide(Z, name="rise").site("hook")
    room.string("hanger", "swing.point", "swing.hook")
    return Motion(builder.finish(), {"swing.bob": "the bob", "swing.hanger": "the string"}, 2.5)


def rod_pendulum(angle: float = 60.0) -> Motion:
    """Build a uniform rod of 1.2 m and 2 kg, hinged at its end, released at `angle` degrees from the vertical."""
    builder = Builder()
    away = radians(angle)
    down = (sin(away), 0.0, -cos(away))
    along = np.eye(3) - np.outer(down, down)
    inertia = 2.0 * 1.2**2 / 12.0 * along
    builder.room("swing").body("rod", 2.0, center=tuple(0.6 * part for part in down), inertia=tensor(inertia)).hinge(Y)
    return Motion(builder.finish(), {"swing.rod": "the rod"}, 2.0)


def tensor(matrix: np.ndarray) -> tuple[float, ...]:
    """Return the six numbers of a symmetric matrix: xx, yy, zz, xy, xz, yz."""
    return tuple(float(matrix[i, j]) for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)))


def light_rod(angle: float = 60.0) -> Motion:
    """Build a bob on a light rod of 0.8 m, released from rest."""
    builder = Builder()
    away = radians(angle)
    rod = builder.room("swing").body("hanger").hinge(Y)
    rod.body("bob", 0.5, at=(0.8 * sin(away), 0.0, -0.8 * cos(away)))
    return Motion(builder.finish(), {"swing.bob": "the bob", "swing.hanger": "the rod"}, 2.0)


def rolling_ball(speed: float = 3.0, friction: float = 0.2) -> Motion:
    """Build a solid ball of 2 kg and 0.1 m that starts sliding on a level floor, without spin."""
    builder = Builder()
    inertia = 0.4 * 2.0 * 0.1**2
    ball = builder.room("lane").body("ball", 2.0, inertia=(inertia, inertia, inertia, 0.0, 0.0, 0.0))
    ball.roll(X, Z, 0.1, friction, speed=speed, spin=0.0)
    return Motion(builder.finish(), {"lane.ball": "the ball"}, 2.0)


def spring_block(stretch: float = 0.2) -> Motion:
    """Build a block of 0.5 kg on a spring of 20 N/m and 0.6 m on a smooth floor, pulled out and released."""
    builder = Builder()
    room = builder.room("bench")
    room.site("wall", at=(-0.6 - stretch, 0.0, 0.0))
    room.body("block", 0.5).rest(X, Z).site("hook")
    room.spring("spring", "bench.wall", "bench.hook", stiffness=20.0, length=0.6)
    return Motion(builder.finish(), {"bench.block": "the block", "bench.spring": "the spring"}, 2.0)


def rubbed_spring(friction: float = 0.1) -> Motion:
    """Build `spring_block` pulled out by 0.2 m on a rough floor: the amplitude drops by 2µmg/k per half period."""
    builder = Builder()
    room = builder.room("bench")
    room.site("wall", at=(-0.8, 0.0, 0.0))
    room.body("block", 0.5).rest(X, Z, friction).site("hook")
    room.spring("spring", "bench.wall", "bench.hook", stiffness=20.0, length=0.6)
    return Motion(builder.finish(), {"bench.block": "the block", "bench.spring": "the spring"}, 3.0)


def orbit(eccentricity: float = 0.5, constant: float = 4.0 * pi**2, units: UnitSystem = SI) -> Motion:
    """Build a planet in its perihelion about a fixed star of mass 1, semi-major axis 1; for e < 0 in its aphelion."""
    builder = Builder(gravity=ZERO, units=units)
    room = builder.room("sky")
    star = room.body("star", 1.0)
    near = 1.0 - eccentricity
    fast = sqrt(constant * (1.0 + eccentricity) / near)
    planet = room.body("planet", 1e-3, at=(near, 0.0, 0.0)).slide(X, name="x").slide(Z, fast, name="y")
    planet.attract(star, constant)
    return Motion(builder.finish(), {"sky.star": "the star", "sky.planet": "the planet"}, 1.2)


def rocket() -> Motion:
    """Build a rocket of 10 kg that burns 0.5 kg/s with an exhaust speed of 400 m/s for 6 s, straight up."""
    builder = Builder()
    body = builder.room("pad").body("rocket", 10.0).slide(Z, name="rise")
    body.burn(0.5, 400.0, 6.0)
    return Motion(builder.finish(), {"pad.rocket": "the rocket"}, 8.0)


def heavy_rocket() -> Motion:
    """Build a rocket of 10 kg on a prop that burns 0.5 kg/s at 160 m/s and doesn't lift off for 3.7 s."""
    builder = Builder()
    room = builder.room("pad")
    room.site("ground", at=(0.0, 0.0, -1.0))
    body = room.body("rocket", 10.0).slide(Z, name="rise")
    body.site("tail", at=(0.0, 0.0, -0.5))
    body.burn(0.5, 160.0, 12.0)
    room.prop("stand", "pad.ground", "pad.tail")
    return Motion(builder.finish(), {"pad.rocket": "the rocket"}, 10.0)


def thrown_ball(restitution: float | None = 0.8) -> Motion:
    """Build a ball of 0.2 kg thrown at 5 m/s and 40° from a height of 1 m, which bounces or ends on the ground."""
    builder = Builder()
    room = builder.room("field")
    rise = 5.0 * sin(radians(40.0))
    ball = room.body("ball", 0.2, at=(0.0, 0.0, 1.0)).slide(X, 5.0 * cos(radians(40.0)), name="x")
    ball.slide(Z, rise, limits=(-inf if restitution is not None else -1.0, inf), name="y")
    if restitution is not None:
        room.bump(room, ball, Z, 0.0, restitution)
    return Motion(builder.finish(), {"field.ball": "the ball"}, 2.5)


def charge(field: float = 3.0) -> Motion:
    """Build a particle of 0.1 kg that flies into a half-space with a magnetic field, on half a circle."""
    builder = Builder(gravity=ZERO)
    room = builder.room("lab")
    particle = room.body("charge", 0.1).slide(X, 2.0, name="x").slide(Z, name="y")
    particle.force("field", Magnetic(Y, Profile(field * 0.1)), HalfSpace(X, 1.0))
    return Motion(builder.finish(), {"lab.charge": "the particle"}, 2.5)


def driven_charge() -> Motion:
    """Build a particle of 0.1 kg and 1 C in the field E = (1 + 2x) along x, in N/C."""
    builder = Builder(gravity=ZERO)
    particle = builder.room("lab").body("charge", 0.1).slide(X, 0.5, name="x").slide(Z, 0.5, name="y")
    particle.force("push", Push(X, Profile(1.0, slope=2.0)))
    return Motion(builder.finish(), {"lab.charge": "the particle"}, 0.5)


def dome() -> Motion:
    """Build a small block that slides off a smooth dome of 1 m, from 10° beside its top."""
    builder = Builder()
    away = radians(10.0)
    top = (sin(away), 0.0, cos(away))
    room = builder.room("hill")
    room.body("block", 0.3, center=top).swing(Y, top, 1.0, guided=False)
    return Motion(builder.finish(), {"hill.block": "the block", "hill.surface": "the dome"}, 2.0)


def pushed_block(growth: float = 3.0, friction: float = 0.4) -> Motion:
    """Build a block of 1 kg at rest on a rough floor, and a horizontal force that grows by `growth` N/s."""
    builder = Builder()
    block = builder.room("bench").body("block", 1.0).rest(X, Z, friction)
    block.force("push", Push(X, Profile(0.0, rate=growth)))
    return Motion(builder.finish(), {"bench.block": "the block"}, 2.0)


def slab() -> Motion:
    """Build a block of 1 kg thrown at 2 m/s on a rough slab of 3 kg on a smooth floor, until both move as one."""
    builder = Builder()
    slab = builder.room("bench").body("slab", 3.0).rest(X, Z)
    slab.body("block", 1.0).rest(X, Z, 0.3, speed=2.0)
    return Motion(builder.finish(), {"bench.slab": "the slab", "bench.block": "the block"}, 1.5)


def pucks() -> Motion:
    """Build two pucks of 1 kg and 2 kg that collide obliquely at 2 m/s, restitution 0.5, and a wall for one."""
    builder = Builder(gravity=ZERO)
    room = builder.room("table")
    a = room.body("a", 1.0).slide(X, 2.0, name="x").slide(Z, name="y")
    b = room.body("b", 2.0, at=(1.0, 0.0, 0.12)).slide(X, name="x").slide(Z, name="y")
    room.collide(a, b, 0.2, 0.5)
    return Motion(builder.finish(), {"table.a": "puck A", "table.b": "puck B"}, 2.0)


def two_strings() -> Motion:
    """Build block A of 1 kg, which a hand pulls up with 30 N, and block B of 2 kg on a string below it."""
    builder = Builder()
    room = builder.room("crane")
    a = room.body("a", 1.0).slide(Z).site("a.eye").site("a.hook")
    room.body("b", 2.0, at=(0.0, 0.0, -1.0)).slide(Z).site("b.hook")
    assert a.name
    room.site("hand", at=(0.0, 0.0, 5.0))
    room.pull("pull", "crane.a.eye", "crane.hand", force=30.0)
    room.string("string", "crane.a.hook", "crane.b.hook")
    return Motion(builder.finish(), {"crane.a": "block A", "crane.b": "block B"}, 1.0)


def strut() -> Motion:
    """Build a block of 1 kg in a vertical guide and one of 2 kg on a smooth floor, joined by a light rod at 45°."""
    builder = Builder()
    room = builder.room("ladder")
    room.body("a", 1.0, at=(0.0, 0.0, 1.0)).slide(Z).site("upper")
    room.body("b", 2.0, at=(1.0, 0.0, 0.0)).rest(X, Z).site("lower")
    room.rod("rod", "ladder.upper", "ladder.lower")
    return Motion(builder.finish(), {"ladder.a": "block A", "ladder.b": "block B"}, 0.4)


MOTIONS: Mapping[str, Callable[[], Motion]] = {
    made.__name__: made
    for made in (
        string_pendulum,
        rod_pendulum,
        light_rod,
        rolling_ball,
        spring_block,
        orbit,
        rocket,
        thrown_ball,
        charge,
        driven_charge,
        dome,
        pushed_block,
        slab,
        pucks,
        strut,
    )
}


@cache
def told_motions() -> tuple[tuple[SimulatedScene, Words], ...]:
    """Return all motions and some variants of them with another start or end, each simulated once."""
    others = (thrown_ball(None), orbit(-0.5), spring_block(-0.2), rubbed_spring())
    return (*(made().told() for made in MOTIONS.values()), *(motion.told() for motion in others))
