"""Tests of gravitation, electromagnetic fields, regions, drag and rockets against closed forms."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from math import atan, cos, pi, radians, sin, sqrt

import numpy as np
import pytest

from sim2reason.scenes.dsl.builder import Builder, Frame
from sim2reason.scenes.dsl.fields import Law, Magnetic, Profile, Push, Resistance
from sim2reason.scenes.dsl.mechanism import ZERO, Attraction, Mechanism, X, Y, Z
from sim2reason.scenes.dsl.state import Array
from sim2reason.scenes.dsl.vectors import BoxRegion, DiscRegion, HalfSpace, Region
from sim2reason.simulation.engines.exact import simulate
from sim2reason.simulation.trace import Event, Trace

GM = 4.0 * pi**2

Agree = Callable[..., None]


def times(duration: float, count: int = 201) -> Array:
    return np.linspace(0.0, duration, count)


def told(events: Sequence[Event]) -> list[tuple[str, float]]:
    """Return kind and time of all events without duplicates, except turning points."""
    return list(dict.fromkeys((event.kind, event.time) for event in events if event.kind != "turn"))


def kepler(e: float, duration: float, count: int, mass: float = 1.0) -> tuple[Array, Array, Array]:
    """Return times, positions and velocities of a planet with a = 1 that starts at its perihelion on the x axis.

    M = E − e sin E (Kepler), by Newton's method; x = cos E − e, y = √(1 − e²) sin E, with dE/dt = n/(1 − e cos E).
    """
    n = sqrt(GM * mass)
    t = times(duration * 2.0 * pi / n, count)
    mean, anomaly = n * t, n * t
    for _ in range(60):
        anomaly = anomaly - (anomaly - e * np.sin(anomaly) - mean) / (1.0 - e * np.cos(anomaly))
    flat, rate = sqrt(1.0 - e * e), n / (1.0 - e * np.cos(anomaly))
    place = np.stack([np.cos(anomaly) - e, flat * np.sin(anomaly)], axis=1)
    velocity = np.stack([-np.sin(anomaly) * rate, flat * np.cos(anomaly) * rate], axis=1)
    return t, place, velocity


def planet(e: float) -> Mechanism:
    """Build a planet that starts at its perihelion."""
    builder = Builder(gravity=ZERO)
    room = builder.room()
    star = room.body("star", 1.0)
    fast = sqrt(GM * (1.0 + e) / (1.0 - e))
    it = room.body("planet", 0.3, at=(1.0 - e, 0.0, 0.0)).slide(X, name="x").slide(Y, fast, name="y")
    it.attract(star, GM)
    return builder.finish()


@pytest.mark.parametrize(("e", "periods"), [(0.0, 10.0), (0.5, 1.0), (0.5, 10.0), (0.9, 1.0), (0.9, 3.0)])
def test_orbit(e: float, periods: float, agree: Agree) -> None:
    """Positions and velocities satisfy Kepler's equation (J. Kepler, Astronomia nova, 1609) over ten periods."""
    t, place, velocity = kepler(e, periods, 1001)
    state = simulate(planet(e), t).state
    agree(state.q + np.array([1.0 - e, 0.0]), place, close=1e-8)
    agree(state.v, velocity, close=1e-8)


@pytest.mark.parametrize("share", [0.2, 0.5])
def test_two_free_bodies_move_as_one(share: float, agree: Agree) -> None:
    """The separation of two free masses m₁ + m₂ = 1 obeys Kepler's equation for their sum."""
    e = 0.4
    t, place, _ = kepler(e, 2.0, 301)
    fast, far = sqrt(GM * (1.0 + e) / (1.0 - e)), 1.0 - e
    builder = Builder(gravity=ZERO)
    room = builder.room()
    one = room.body("one", share).slide(X, name="x").slide(Y, -(1.0 - share) * fast, name="y")
    other = room.body("other", 1.0 - share, at=(far, 0.0, 0.0)).slide(X, name="x").slide(Y, share * fast, name="y")
    one.attract(other, GM)
    q = simulate(builder.finish(), t).state.q
    agree(q[:, 2:] + np.array([far, 0.0]) - q[:, :2], place, close=1e-8)
    agree(share * q[:, :2] + (1.0 - share) * q[:, 2:], 0.0 * q[:, 2:], 1.0)


def test_another_power_of_attraction(agree: Agree) -> None:
    """A pull of constant size, F = kmM (power 0), towards a fixed point keeps ½v² + kMr and xv_y − yv_x."""
    builder = Builder(gravity=ZERO)
    room = builder.room()
    room.body("sun", 2.0)
    room.body("ball", 0.7, at=(1.5, 0.0, 0.0)).slide(X, name="x").slide(Y, 0.9, name="y")
    mechanism = replace(builder.finish(), attractions=(Attraction("sun", "ball", 3.0, 0.0),))
    state = simulate(mechanism, times(2.0)).state
    (x, y), (u, v) = (state.q + np.array([1.5, 0.0])).T, state.v.T
    agree(0.5 * (u**2 + v**2) + 6.0 * np.hypot(x, y), 0.5 * 0.81 + 9.0)
    agree(x * v - y * u, 1.35)


# ---- a charge


def charge(
    law: Law, velocity: tuple[float, float] = (0.0, 0.0), region: Region | None = None, mass: float = 1.0
) -> tuple[Builder, Frame]:
    """Return a builder of a body in a horizontal plane under one force, and the body."""
    builder = Builder()
    ball = builder.room().body("ball", mass).slide(X, velocity[0], name="x").slide(Y, velocity[1], name="y")
    ball.force("field", law, region)
    return builder, ball


def followed(builder: Builder, t: Array) -> Trace:
    return simulate(builder.finish(), t)


def magnetic(strength: float) -> Magnetic:
    return Magnetic(Z, Profile(strength))


@pytest.mark.parametrize("turns", [1.0, 10.0, 100.0])
def test_charge_in_a_magnetic_field(turns: float, agree: Agree) -> None:
    """A positive charge circles clockwise about +z with ω = qB/m at constant speed."""
    omega = 1.7
    t = times(turns * 2.0 * pi / omega, 801)
    state = followed(charge(magnetic(omega), (2.0, 0.0))[0], t).state
    agree(state.q, np.stack([2.0 / omega * np.sin(omega * t), 2.0 / omega * (np.cos(omega * t) - 1.0)], axis=1))
    agree(np.hypot(*state.v.T), 2.0)


@pytest.mark.parametrize("launch", [(0.0, 0.0), (1.0, 0.0), (0.4, -0.8)])
def test_crossed_fields(launch: tuple[float, float], agree: Agree) -> None:
    """With E along y and B along z, the charge circles about a drift v = E/B along x; from rest, a cycloid.

    With w = v_x + i v_y, dw/dt = −iω w + ia, so w = a/ω + (w₀ − a/ω) e^{−iωt}.
    """
    omega, a, mass = 2.5, 1.5, 0.4
    builder, ball = charge(magnetic(omega * mass), launch, mass=mass)
    ball.force("electric", Push(Y, Profile(a * mass)))
    t = times(20.0)
    state = followed(builder, t).state
    drift, start = a / omega, complex(*launch)
    w = drift + (start - drift) * np.exp(-1j * omega * t)
    s = drift * t + (start - drift) * (1.0 - np.exp(-1j * omega * t)) / (1j * omega)
    agree(state.v, np.stack([w.real, w.imag], axis=1))
    agree(state.q, np.stack([s.real, s.imag], axis=1))


def test_drag_in_a_magnetic_field(agree: Agree) -> None:
    """With dw/dt = −(γ + iω) w, w = w₀ e^{−(γ+iω)t}, a spiral that ends at w₀/(γ + iω)."""
    gamma, omega = 0.3, 2.0
    builder, ball = charge(magnetic(omega), (1.0, 0.5))
    ball.force("drag", Resistance(linear=gamma))
    t, start, rate = times(12.0), complex(1.0, 0.5), complex(gamma, omega)
    state = followed(builder, t).state
    s = start * (1.0 - np.exp(-rate * t)) / rate
    agree(state.q, np.stack([s.real, s.imag], axis=1))


def test_quadratic_drag(agree: Agree) -> None:
    """With m dv/dt = −cv², v = v₀/(1 + cv₀t/m), x = (m/c) ln(1 + cv₀t/m) in a constant direction."""
    mass, c, speed = 0.5, 0.8, 3.0
    t = times(5.0)
    state = followed(charge(Resistance(quadratic=c), (0.6 * speed, 0.8 * speed), mass=mass)[0], t).state
    grown = 1.0 + c * speed * t / mass
    agree(state.v, np.outer(speed / grown, [0.6, 0.8]))
    agree(state.q, np.outer(mass / c * np.log(grown), [0.6, 0.8]))


@pytest.mark.parametrize("slope", [2.0, -2.0])
def test_field_that_grows_with_the_way(slope: float, agree: Agree) -> None:
    """Solutions of ẍ = kx about x = −E₀/k are cosh and sinh for k > 0, cos and sin for k < 0."""
    start, push = 0.7, 0.5
    t, root = times(3.0), sqrt(abs(slope))
    state = followed(charge(Push(X, Profile(push, slope, X)), (start, 0.0))[0], t).state
    even, odd = (np.cosh, np.sinh) if slope > 0.0 else (np.cos, np.sin)
    agree(state.q[:, 0], push / slope * (even(root * t) - 1.0) + start / root * odd(root * t))


def test_field_across_the_way(agree: Agree) -> None:
    """In a field E_y = E₀ + kx, which has a curl, x = ut gives y = E₀t²/2 + kut³/6."""
    t = times(4.0)
    state = followed(charge(Push(Y, Profile(0.5, -0.8, X)), (1.2, 0.0))[0], t).state
    agree(state.q, np.stack([1.2 * t, 0.25 * t**2 - 0.8 * 1.2 * t**3 / 6.0], axis=1))


def test_fields_that_change_with_time(agree: Agree) -> None:
    """With ẍ = a + rt, x = at²/2 + rt³/6; with ẍ = a cos ωt, x = a(1 − cos ωt)/ω²."""
    t = times(6.0)
    state = followed(charge(Push(X, Profile(0.5, rate=-0.4)), (1.0, 0.0))[0], t).state
    agree(state.q[:, 0], t + 0.25 * t**2 - 0.4 * t**3 / 6.0)
    state = followed(charge(Push(X, Profile(0.5, frequency=3.0)))[0], t).state
    agree(state.q[:, 0], 0.5 * (1.0 - np.cos(3.0 * t)) / 9.0)


# ---- regions


@pytest.mark.parametrize("off", [0.3, 1.0, 2.5])
def test_disc_aimed_at_its_centre(off: float, agree: Agree) -> None:
    """A charge that enters a disc of field radially leaves it radially, turned by φ with tan(φ/2) = R/r_L.

    The path inside is an arc of the angle φ about a point r_L away.
    """
    radius, speed, omega = 0.5, 2.0, 3.0
    larmor = speed / omega
    angle = 2.0 * atan(radius / larmor)
    builder, _ = charge(magnetic(omega), (speed, 0.0), DiscRegion((off + radius, 0.0, 0.0), radius))
    enter, leave = off / speed, off / speed + angle / omega
    trace = followed(builder, times(leave + 1.0))
    assert [kind for kind, _ in told(trace.events)] == ["enter", "exit"]
    agree([time for _, time in told(trace.events)], [enter, leave])
    state = trace.sample(np.array([leave, leave + 1.0]))
    way = np.array([cos(angle), -sin(angle)])
    agree(state.v, [speed * way, speed * way])
    agree(state.q[0], np.array([off + radius, 0.0]) + radius * way)


@pytest.mark.parametrize("degrees", [0.0, 30.0, -50.0])
def test_half_plane(degrees: float, agree: Agree) -> None:
    """The charge leaves the half-plane shifted along the border by 2mv cos α/(qB).

    α is the angle to the normal of the border; the arc has the angle π − 2α for a path that bends to negative y.
    """
    alpha, speed, omega, edge = radians(degrees), 2.0, 4.0, 0.6
    velocity = (speed * cos(alpha), speed * sin(alpha))
    builder, _ = charge(magnetic(omega), velocity, HalfSpace(X, edge))
    enter = edge / velocity[0]
    leave = enter + (pi + 2.0 * alpha) / omega
    trace = followed(builder, times(leave + 0.5))
    agree([time for _, time in told(trace.events)], [enter, leave])
    assert [kind for kind, _ in told(trace.events)] == ["enter", "exit"]
    shift = trace.sample(np.array([leave])).q[0] - trace.sample(np.array([enter])).q[0]
    agree(shift, [0.0, -2.0 * speed * cos(alpha) / omega])


def test_capacitor(agree: Agree) -> None:
    """The deflection between the plates is y = aL²/2u², and the slope of the path after them aL/u²."""
    speed, a, low, high = 3.0, 2.0, 0.5, 1.7
    builder, _ = charge(Push(Y, Profile(a)), (speed, 0.0), BoxRegion(((X, low, high),)))
    trace = followed(builder, times(2.0))
    agree([time for _, time in told(trace.events)], [low / speed, high / speed])
    inside = (high - low) / speed
    state = trace.sample(np.array([high / speed, 2.0]))
    agree(state.q[:, 1], [0.5 * a * inside**2, 0.5 * a * inside**2 + a * inside * (2.0 - high / speed)])


def test_two_fields_in_one_region_are_entered_once(agree: Agree) -> None:
    """With E perpendicular to B and E = vB, the bead passes straight through both."""
    speed, omega, region = 2.0, 3.0, DiscRegion((1.0, 0.0, 0.0), 0.4)
    builder, ball = charge(magnetic(omega), (speed, 0.0), region)
    ball.force("electric", Push(Y, Profile(speed * omega)), region)
    trace = followed(builder, times(1.5))
    assert [kind for kind, _ in told(trace.events)] == ["enter", "exit"]
    agree([time for _, time in told(trace.events)], [0.3, 0.7])
    agree(trace.state.q[:, 1], 0.0, 1.0)


# ---- rockets


def rocket(gravity: tuple[float, float, float] = ZERO, *, pad: bool = False) -> Builder:
    """Build a rocket of 500 kg with 400 kg of fuel, burned in 80 s at 5 kg/s with an exhaust of 2 km/s."""
    builder = Builder(gravity=gravity)
    room = builder.room()
    it = room.body("rocket", 500.0).slide(Z, limits=(0.0, float("inf")))
    it.burn(5.0, 2000.0, 80.0)
    if pad:
        it.site("tail")
        room.site("pad", at=(0.0, 0.0, -1.0))
        room.prop("stand", "pad", "tail")
    return builder


@pytest.mark.parametrize("g", [0.0, 9.8, 15.0])
def test_rocket_in_a_uniform_field(g: float, agree: Agree) -> None:
    """The motion is v = u ln(m₀/m) − gt, h = ut − (um/µ) ln(m₀/m) − gt²/2, then free flight.

    K. Tsiolkovsky, 1903.
    """
    t = times(120.0, 241)
    trace = followed(rocket((0.0, 0.0, -g)), t)
    agree([time for kind, time in told(trace.events) if kind == "burn-out"], [80.0])
    burning = np.minimum(t, 80.0)
    mass = 500.0 - 5.0 * burning
    shed = np.log(500.0 / mass)
    coast = t - burning
    v = 2000.0 * shed - g * burning
    h = 2000.0 * burning - 400.0 * mass * shed - 0.5 * g * burning**2
    agree(trace.state.v[:, 0], v - g * coast)
    agree(trace.state.q[:, 0], h + v * coast - 0.5 * g * coast**2)


@pytest.mark.parametrize("g", [22.0, 40.0])
def test_rocket_that_waits_on_its_pad(g: float, agree: Agree) -> None:
    """The thrust uµ is less than the weight until m = uµ/g, after (m₀ − uµ/g)/µ."""
    wait = (500.0 - 2000.0 * 5.0 / g) / 5.0
    t = times(80.0, 161)
    trace = followed(rocket((0.0, 0.0, -g), pad=True), t)
    kind, time = told(trace.events)[0]
    assert kind == "leave"
    agree(time, wait)
    since = np.maximum(t - wait, 0.0)
    left = 2000.0 * 5.0 / g
    shed = np.log(left / (left - 5.0 * since))
    agree(trace.state.q[:, 0], 2000.0 * since - 400.0 * (left - 5.0 * since) * shed - 0.5 * g * since**2)


def test_rocket_that_leaves_a_planet_keeps_its_energy_after_burn_out(agree: Agree) -> None:
    """After burn-out v²/2 − GM/r is constant; before it d²r/dt² = uµ/m − GM/r².

    The latter is checked by its integral, the work.
    """
    radius, g = 6.0e5, 3.0
    builder = Builder(gravity=ZERO)
    room = builder.room()
    core = room.body("planet", 1.0e20, at=(-radius, 0.0, 0.0))
    it = room.body("rocket", 900.0).slide(X)
    it.burn(3.0, 2000.0, 200.0, X)
    it.attract(core, g * radius**2 / 1.0e20)
    trace = followed(builder, times(1000.0, 501))
    out = told(trace.events)[0]
    assert out[0] == "burn-out"
    agree(out[1], 200.0)
    state, after = trace.state, trace.state.times >= 200.0
    energy = 0.5 * state.v[:, 0] ** 2 - g * radius**2 / (radius + state.q[:, 0])
    agree(energy[after], energy[after][0])
    mass = 900.0 - 3.0 * np.minimum(state.times, 200.0)
    thrust = np.where(after, 0.0, 6000.0 / mass)
    agree(state.a[:, 0], thrust - g * radius**2 / (radius + state.q[:, 0]) ** 2)


def test_coast_to_a_height(agree: Agree) -> None:
    """From r₀ with v₀ straight up under GM = 1, the highest point has 1/r = 1/r₀ − v₀²/2.

    With r = r_max cos²θ, t = √(r_max³/2) (θ₀ + sin θ₀ cos θ₀) from r₀ = r_max cos²θ₀ to the top.
    """
    start, speed = 1.0, 1.1
    top = 1.0 / (1.0 / start - 0.5 * speed**2)
    builder = Builder(gravity=ZERO)
    room = builder.room()
    core = room.body("core", 1.0)
    room.body("stone", 1.0, at=(start, 0.0, 0.0)).slide(X, speed, name="rise").attract(core, 1.0)
    trace = followed(builder, times(5.0))
    turn = next(event.time for event in trace.events if event.kind == "turn")
    theta = atan(sqrt(top / start - 1.0))
    agree(turn, sqrt(top**3 / 2.0) * (theta + sin(theta) * cos(theta)))
    agree(trace.sample(np.array([turn])).q[0, 0], top - start)


# ---- bounces


@pytest.mark.parametrize("e", [0.5, 0.7, 0.9])
def test_bounces_of_a_ball(e: float, agree: Agree) -> None:
    """The k-th bounce is at t₁ + (2v₁/g) e (1 − e^{k−1})/(1 − e), and all are before t₁ + 2ev₁/(g(1 − e))."""
    g, height = 9.8, 3.0
    builder = Builder()
    room = builder.room()
    ball = room.body("ball", 0.2, at=(0.0, 0.0, height)).slide(X, 1.5, name="x").slide(Z, name="y")
    room.bump(room, ball, Z, 0.0, e)
    first, speed = sqrt(2.0 * height / g), sqrt(2.0 * g * height)
    last = first + 2.0 * e * speed / (g * (1.0 - e))
    trace = followed(builder, times(last + 1.0))
    hits = [event.time for event in trace.events if event.kind == "collision"]
    k = np.arange(1, len(hits) + 1)
    agree(hits, first + 2.0 * speed / g * e * (1.0 - e ** (k - 1)) / (1.0 - e))
    assert trace.cut == "crowd"
    gap = 2.0 * speed / g * e ** len(hits)  # the flight that would follow is too short to tell its ends apart
    assert gap < 5e-3 <= gap / e**2
    assert trace.stable_until == hits[-1] < last
