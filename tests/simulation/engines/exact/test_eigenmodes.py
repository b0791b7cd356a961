"""Tests of linear motions that are solved by normal modes, against closed forms."""

from collections.abc import Callable
from math import cos, radians, sin, sqrt

import numpy as np
import pytest

from sim2reason.datasets.scene_questions import solve
from sim2reason.errors import SimulationError
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.state import Array
from sim2reason.scenes.files import loads
from sim2reason.simulation.engines.exact.eigenmodes import Modes, turning_times
from sim2reason.simulation.engines.exact.motion import Motion
from sim2reason.simulation.scenes import simulate, simulate_full_duration
from sim2reason.simulation.trace import Trace

STIFF, LIGHT = 1e6, 1e-3
RATE = sqrt(STIFF / LIGHT)


def scene(kind: str, parameters: str) -> Scene:
    """Return a scene with one entity."""
    return loads(f"scene: {{entities: [{{name: it, type: {kind}, parameters: {{{parameters}}}}}]}}")


HELD = scene("AnchoredSpring", "spring: {stiffness: 1.0e6, length: 0.5}, block: {mass: 0.001}, start: 0.6")
FREE = scene(
    "SpringMassChain",
    "track: {}, carts: [{mass: 0.001}, {mass: 0.002}], springs: [{stiffness: 1.0e6}], ends: free, "
    "blow: {cart: 0, toward: right, speed: 3.0}",
)
WEDGE = scene(
    "SpringOnWedge",
    "wedge: {mass: 1.0, angle: 30.0}, block: {mass: 1.0e-6}, spring: {stiffness: 1.0e6, length: 0.5}, start: 0.500001",
)
HUNG = scene(
    "AnchoredSpring",
    "support: ceiling, spring: {stiffness: 1.0e5, length: 0.5}, block: {mass: 0.001}, start: 0.5",
)
DAMPED = (
    "track: {{}}, carts: [{{mass: 0.001}}], springs: [{{stiffness: 1.0e6}}], ends: left, damping: {}, "
    "strain: {{spring: 0, way: stretched, by: 0.001}}"
)


def stretches(trace: Trace) -> int:
    """Count the linear stretches that the engine takes in closed form."""
    assert isinstance(trace.record, Motion)
    return sum(len(segment.flow.stretches) for segment in trace.record.segments if segment.flow)


def test_a_block_on_a_stiff_spring_oscillates_for_seconds() -> None:
    """The motion is x = ℓ₀ + A cos ω t over 5000 periods, and every turning point is an event."""
    trace = simulate(HELD, 1.0)
    times = trace.state.times
    assert stretches(trace) == 1
    assert abs(trace.state.q[:, 0]) == pytest.approx(0.1 * (1.0 - np.cos(RATE * times)), abs=1e-9)
    assert abs(trace.state.v[:, 0]) == pytest.approx(0.1 * RATE * abs(np.sin(RATE * times)), abs=1e-9 * RATE)
    turned = [event.time for event in trace.events if event.kind == "turn"]
    assert turned == pytest.approx([n * np.pi / RATE for n in range(1, len(turned) + 1)], rel=1e-9)
    assert len(turned) == int(RATE / np.pi)
    assert len(trace.knots()) > 8 * RATE / (2.0 * np.pi)


def test_a_crumb_on_a_sliding_wedge_oscillates_thousands_of_times() -> None:
    """The motion has ω² = k (M + m)/(m (M + m sin² θ)), and a mode of zero frequency for the total momentum."""
    big, small, slope = 1.0, 1e-6, radians(30.0)
    rate = sqrt(STIFF * (big + small) / (small * (big + small * sin(slope) ** 2)))
    trace = simulate(WEDGE, 0.1)
    assert stretches(trace) == 1
    middle = 0.5 - small * 9.8 * sin(slope) / STIFF
    along = (0.500001 - middle) * (np.cos(rate * trace.state.times) - 1.0)
    assert trace.state.q[:, 1] == pytest.approx(along, abs=1e-11)
    assert trace.state.q[:, 0] == pytest.approx(-small * cos(slope) / (big + small) * along, abs=1e-11 * small)


def test_two_carts_on_a_stiff_spring_drift_as_they_oscillate() -> None:
    """The centre of mass moves with m v/(m + M), and the carts about it by v M/((m + M) ω) sin ω t.

    ω² = k (m + M)/(m M).
    """
    rate, drift = sqrt(STIFF * 3e-3 / 2e-6), 1.0
    trace = simulate(FREE, 1.0)
    assert stretches(trace) == 1
    swing = np.sin(rate * trace.state.times) / rate
    assert trace.state.q[:, 0] == pytest.approx(drift * trace.state.times + 2.0 * swing, abs=1e-9)
    assert trace.state.q[:, 1] == pytest.approx(drift * trace.state.times - swing, abs=1e-9)


def test_it_is_asked_about_after_a_second() -> None:
    """The speed is |v| = A ω |sin ω t|."""
    answer = solve(HELD, find="speed", of="it.block", when="1 s").answer
    assert answer == pytest.approx(0.1 * RATE * abs(sin(RATE)), rel=1e-8)


@pytest.mark.parametrize("duration", [0.002, 1.0, 60.0])
def test_a_small_mass_on_a_stiff_spring_is_followed_to_the_last_digits(duration: float) -> None:
    """The motion is x = A (1 − cos ω t), A = m g/k = 98 nm, too small for an integrator's steps."""
    trace = simulate(HUNG, duration)
    times, size, rate = trace.state.times, LIGHT * 9.8 / 1e5, sqrt(1e5 / LIGHT)
    assert abs(trace.state.q[:, 0]) == pytest.approx(size * (1.0 - np.cos(rate * times)), abs=1e-9 * size)
    assert abs(trace.state.v[:, 0]) == pytest.approx(size * rate * abs(np.sin(rate * times)), abs=1e-9 * size * rate)
    assert len(trace.state.times) == 101
    assert sum(event.kind == "turn" for event in trace.events) == int(duration * rate / np.pi)


def chain(soft: float, by: float) -> tuple[Scene, Callable[[Array], Array]]:
    """Return 1 g on 10⁵ N/m with 1 kg on a soft spring, and the displacements as a function of times.

    Squares λ of the rates of its normal modes have the sum (k₁ + k₂)/m + k₂/M and the product k₁ k₂/(m M). Of each mode
    x₂/x₁ = ((k₁ + k₂) − m λ)/k₂ = k₂/(k₂ − M λ), in the form that does not cancel.
    """
    k1, m, big = 1e5, 1e-3, 1.0
    total = (k1 + soft) / m + soft / big
    fast = 0.5 * (total + sqrt(total**2 - 4.0 * k1 * soft / (m * big)))
    slow = k1 * soft / (m * big) / fast
    ratios = np.array([soft / (soft - big * fast), (k1 + soft - m * slow) / soft])
    size = by / (ratios[1] - ratios[0]) * np.array([-1.0, 1.0])
    springs = f"[{{stiffness: 1.0e5}}, {{stiffness: {soft}}}]"
    carts = f"track: {{}}, carts: [{{mass: 0.001}}, {{mass: 1.0}}], springs: {springs}, ends: left"
    made = scene("SpringMassChain", f"{carts}, strain: {{spring: 1, way: stretched, by: {by}}}")

    def displaced(times: Array) -> Array:
        swing = size * np.cos(np.sqrt([fast, slow]) * times[:, None])
        return np.stack([swing.sum(axis=1), swing @ ratios - by], axis=1)

    return made, displaced


def test_a_chain_of_a_small_and_a_large_mass_has_its_normal_modes_for_half_a_minute() -> None:
    """The squares of the chain's frequencies differ by a factor of 10⁷."""
    made, displaced = chain(10.0, 0.1)
    trace = simulate(made, 30.0)
    assert stretches(trace) == 1
    off = abs(trace.state.q - displaced(trace.state.times)).max(axis=0)
    assert off[0] < 1e-9 * 2e-5
    assert off[1] < 1e-9 * 0.1


def test_an_event_after_thousands_of_periods_is_found() -> None:
    """A collision after 20,000 periods of the small mass is found at its time."""
    made, displaced = chain(0.01, 2.9)
    trace = simulate_full_duration(made, 20.0)
    assert stretches(trace) > 1
    assert trace.cut == "reach"
    end = trace.stable_until

    def gap(times: Array) -> Array:
        return 3.0 + displaced(times) @ np.array([-1.0, 1.0])

    assert gap(np.array([end])) == pytest.approx([1e-9], abs=1e-10)  # at which they count as met
    assert (gap(np.linspace(0.0, end - 1e-9, 1_000_000)) > 1e-9).all()


@pytest.mark.parametrize("damping", [1e-4, 0.5, 20.0])
def test_a_damped_stiff_motion_is_followed_to_nine_digits(damping: float) -> None:
    """The motion is x = A e^(−γ t) (cos ν t + γ/ν sin ν t) with ν² = k/m − γ² and γ = b/2m."""
    trace = simulate(scene("SpringMassChain", DAMPED.format(damping)), 10.0)
    decay = damping / (2.0 * LIGHT)
    rate, times = sqrt(STIFF / LIGHT - decay**2), trace.state.times
    left = np.exp(-decay * times) * (np.cos(rate * times) + decay / rate * np.sin(rate * times))
    assert abs(trace.state.q[:, 0]) == pytest.approx(0.001 * (1.0 - left), abs=1e-9 * 0.001)


LATE = [(HUNG, "it.block", "60 s"), (chain(10.0, 0.1)[0], "it.carts.1", "30 s")]


@pytest.mark.parametrize(("asked", "body", "after"), LATE)
def test_questions_about_late_instants_have_worked_solutions(asked: Scene, body: str, after: str) -> None:
    """The solution's formulas give the simulated answer."""
    solved = solve(asked, find="speed", of=body, when=after)
    assert solved.answer is not None
    assert solved.solution.text


def test_what_would_take_too_many_pieces_is_refused_at_once() -> None:
    """The refusal precedes any long computation."""
    with pytest.raises(SimulationError, match="million operations"):
        simulate(HELD, 1e6)


def test_what_bends_is_not_taken_for_linear() -> None:
    """The spring of a block launched sideways rotates, and the usual limit on steps applies."""
    spring = "springs: [{stiffness: 1.0e6, length: 0.5, x: 1.0, y: 0.0}]"
    bent = scene("SpringBlock", f"block: {{mass: 0.001}}, {spring}, x: 0.4, y: 0.0, launch: {{x: 0.0, y: 1.0}}")
    with pytest.raises(SimulationError, match="million operations"):
        simulate(bent, 5.0)


def test_ordinary_motions_are_integrated_as_before() -> None:
    """Closed forms replace integration only if that would take too many steps."""
    soft = scene("AnchoredSpring", "spring: {stiffness: 100.0, length: 0.5}, block: {mass: 0.1}, start: 0.6")
    assert stretches(simulate(soft, 100.0)) == 0


@pytest.mark.parametrize("damping", [1e-4, 0.5, 20.0, 200.0])
def test_a_stiff_spring_with_a_dashpot_is_followed_for_seconds(damping: float) -> None:
    """The solution of m ẍ = −k x − b ẋ with x = A at rest holds for real and complex λ.

    x = A (λ₂ e^(λ₁ t) − λ₁ e^(λ₂ t))/(λ₂ − λ₁).
    """
    trace = simulate(scene("SpringMassChain", DAMPED.format(damping)), 1.0)
    assert stretches(trace) >= 1
    half = damping / (2.0 * LIGHT)
    root = np.sqrt(complex(half**2 - RATE**2))
    one, other = -half + root, -half - root
    times = np.concatenate([np.linspace(0.0, 1.0, 41), np.geomspace(1e-5, 1.0, 200)])
    left = np.real((other * np.exp(one * times) - one * np.exp(other * times)) / (other - one))
    assert abs(trace.sample(times).q[:, 0]) == pytest.approx(0.001 * (1.0 - left), abs=1e-9)
    turned = [event.time for event in trace.events if event.kind == "turn"]
    assert turned[:100] == pytest.approx([n * np.pi / abs(root) for n in range(1, len(turned[:100]) + 1)], rel=1e-6)
    assert (len(turned) > 5) == (half < RATE)


def test_at_critical_damping_a_stiff_motion_is_refused_in_words() -> None:
    """There are too few eigenvectors; the error message suggests a shorter time."""
    critical = 2.0 * sqrt(STIFF * LIGHT)
    with pytest.raises(SimulationError, match="simulate a shorter time"):
        simulate(scene("SpringMassChain", DAMPED.format(repr(critical))), 100.0)


def test_modes_that_begin_later_are_the_same_motion_later() -> None:
    """x = 0.2 m + 0.3 m sin(ω t) and y = 0.1 m + 0.5 m/s t − 1 m/s² t² from an instant on, with ω = 7/s."""
    begin, rate = 2.5, 7.0
    modes = Modes(
        begin,
        np.array([0.2, 0.1]),
        np.eye(2),
        np.array([rate**2, 0.0]),
        np.array([0.0, -2.0]),
        np.array([0.3 * rate, 0.5]),
    )
    since = np.linspace(0.0, 3.0, 31)
    swing, none = np.array([0.3 * np.sin(rate * since), 0.3 * rate * np.cos(rate * since)]), np.zeros_like(since)
    wanted = [0.2 + swing[0], 0.1 + 0.5 * since - since**2, swing[1], 0.5 - 2.0 * since]
    assert modes.at(begin + since) == pytest.approx(np.transpose(wanted), abs=1e-12)
    accelerations = np.transpose([-(rate**2) * swing[0], none - 2.0])
    assert modes.accelerations(begin + since) == pytest.approx(accelerations, abs=1e-11)
    turns = turning_times(modes, 1.0)
    assert [number for _, number in turns] == [0, 1, 0]
    assert [time - begin for time, _ in turns] == pytest.approx([0.5 * np.pi / rate, 0.25, 1.5 * np.pi / rate])
