"""The exact engine with its native core and without, and SciPy's integrator at equal error, side by side.

    python benchmarks/native.py [simulations] [--rounds N] [--scipy]

Five systems: a pendulum, an elliptic orbit, a double pendulum, a scene of pulleys and a chain of carts that is struck.
Each simulation is of another mechanism of the same shape and lasts from a mechanism to its states at 101 instants,
with accelerations and events. CPU time of processes turn about; of each system the best of all rounds.

SciPy's DOP853 integrates the same accelerations, as straight-line Python, with the reversals of coordinates as events,
at the largest of its relative tolerances by which its error at the 101 instants is not above the engine's (or 1e-12).

What is not native, by shares of the CPU time of items (of every recipe and difficulty, by cProfile, in Python alone;
numeric, reverse, symbolic):

- Eigenmodes of long linear motions: 0.06, 0.04 and 0.07 %; NumPy's LAPACK does the work.
- Admissible forces of redundant supports: 0.4, 0.02 and 0.01 %; the same.
- Braced event functions (Fourier–Motzkin): none was evaluated in 178 items. Such modes are integrated in Python.
- Setting up (`System`, `ConstantEquations`, equations of one instant): 4.8, 3.6 and 9.4 %, spread over some sixty small
  functions, most of them of frames and vectors in `scenes.dsl`, which other packages use with arrays and symbols, too.
  One mechanism for each shape, its numbers as inputs, takes away most of it in Python. A closed-form motion, as that of
  pulleys, is nearly all setting up: therefore it gains least.
- Impacts and the choice of what may act, around the forces of a mode: 1.5 to 3 % after the port; flat, too.
- The table of a closed-form motion's accelerations and forces: 1.1, 0.7 and 0.8 %.
- Code of each shape compiled by a C compiler: 20 ms for the least function, as much as sixty motions.
"""

import argparse
import json
import os
import subprocess
import sys
from collections.abc import Callable
from math import cos, pi, radians, sin, sqrt
from time import process_time

import numpy as np
from against import PHASE, ROOT, fixed_loop

from sim2reason.datasets.worker import tune_garbage_collection
from sim2reason.generation.item_search import sample
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.mechanism import ZERO, Mechanism, X, Y, Z
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.simulation.engines.exact import simulate
from sim2reason.simulation.engines.exact.motion import Motion
from sim2reason.simulation.trace import Trace

SAMPLES = 101
TOLERANCES = [10.0**-power for power in range(4, 14)]
LEAST_ERROR = 1e-12
REPEATS = 20  # of SciPy
Rate = Callable[[float, np.ndarray], tuple[float, ...]]


def pendulum(number: int) -> Mechanism:
    builder, angle = Builder(), radians(60.0 + 0.01 * number)
    rod = builder.room("swing").body("hanger").hinge(Y)
    rod.body("bob", 0.5, at=(0.8 * sin(angle), 0.0, -0.8 * cos(angle)))
    return builder.finish()


def orbit(number: int) -> Mechanism:
    builder, eccentricity, constant = Builder(gravity=ZERO), 0.5 + 1e-4 * number, 4.0 * pi**2
    room = builder.room("sky")
    star, near = room.body("star", 1.0), 1.0 - eccentricity
    planet = room.body("planet", 1e-3, at=(near, 0.0, 0.0)).slide(X, name="x")
    planet.slide(Z, sqrt(constant * (1.0 + eccentricity) / near), name="y").attract(star, constant)
    return builder.finish()


def double_pendulum(number: int) -> Mechanism:
    builder, angle = Builder(), radians(100.0 + 0.01 * number)
    at = (0.7 * sin(angle), 0.0, -0.7 * cos(angle))
    upper = builder.room().body("upper").hinge(Y)
    upper.body("first", 1.0, at=at)
    upper.body("lower", at=at).hinge(Y).body("second", 0.5, at=(0.5, 0.0, 0.0))
    return builder.finish()


def drawn(recipe: str, number: int) -> Mechanism:
    """A scene built anew, since scenes keep their mechanism."""
    found = sample(recipe, "hard", seed=5, index=number)
    return Scene(entities=found.entities, connections=found.connections, world=found.world).mechanism


SYSTEMS: dict[str, tuple[Callable[[int], Mechanism], float]] = {
    "pendulum": (pendulum, 5.0),
    "orbit": (orbit, 1.2),
    "double pendulum": (double_pendulum, 3.0),
    "hard pulleys": (lambda number: drawn("pulley", number), 2.0),
    "struck chain": (lambda number: drawn("chain", number), 4.0),
}


def followed(mechanism: Mechanism, duration: float) -> Trace:
    trace = simulate(mechanism, np.linspace(0.0, duration, SAMPLES))
    _ = trace.state.q, trace.state.a
    return trace


def measured(count: int) -> dict[str, float]:
    """Milliseconds of each system, in this process."""
    tune_garbage_collection()
    found = dict[str, float]()
    for name, (make, duration) in SYSTEMS.items():
        mechanisms = [make(number) for number in range(count + 1)]
        followed(mechanisms.pop(), duration)
        start = process_time()
        for mechanism in mechanisms:
            followed(mechanism, duration)
        found[name] = 1e3 * (process_time() - start) / count
    return found | {PHASE: fixed_loop()}


def in_a_process(switch: str, count: int) -> dict[str, float]:
    environment = os.environ | {"SIM2REASON_NATIVE": switch, "PYTHONPATH": path()}
    command = [sys.executable, __file__, str(count), "--figures"]
    return json.loads(subprocess.run(command, env=environment, check=True, capture_output=True).stdout)


def path() -> str:
    return os.pathsep.join([str(ROOT / "src"), *filter(None, [os.environ.get("PYTHONPATH")])])


# ---- SciPy


def rate_of(trace: Trace) -> Rate:
    """The derivatives of all coordinates and rates, as plain Python; run where the core is not in use."""
    assert isinstance(trace.record, Motion)
    segment = trace.record.segments[0]
    if segment.flow is not None:
        code = segment.flow.formulas.rate
        return lambda time, y: code(time, y.tolist())
    n, a = len(segment.q), tuple(segment.a)
    return lambda _, y: (*y[n:].tolist(), *a)


def integrated(rate: Rate, start: np.ndarray, times: np.ndarray, tolerance: float) -> np.ndarray:
    """Coordinates (m, n) by SciPy, which looks for reversals, too."""
    from scipy.integrate import solve_ivp  # noqa: PLC0415 - it is no requirement of ours

    n = len(start) // 2
    turns = [lambda _, y, k=k: y[k] for k in range(n, 2 * n)]
    span = (0.0, float(times[-1]))
    found = solve_ivp(
        rate, span, start, "DOP853", times, events=turns, rtol=max(tolerance, 3e-14), atol=1e-2 * tolerance
    )
    return found.y[:n].T


def compared(name: str) -> tuple[float, float, float]:
    """The engine's error, and the tolerance and milliseconds of SciPy for the same."""
    make, duration = SYSTEMS[name]
    trace = followed(make(0), duration)
    rate, until = rate_of(trace), min(duration, trace.stable_until)
    times = np.linspace(0.0, until, SAMPLES)
    start, ours = np.concatenate([trace.at(0.0).q[0], trace.at(0.0).v[0]]), trace.sample(times).q
    exact = integrated(rate, start, times, 3e-14)
    error = max(float(np.abs(ours - exact).max()), LEAST_ERROR)
    for tolerance in TOLERANCES:
        if float(np.abs(integrated(rate, start, times, tolerance) - exact).max()) <= error:
            break
    spent: list[float] = []
    for _ in range(REPEATS):
        begun = process_time()
        integrated(rate, start, times, tolerance)
        spent.append(process_time() - begun)
    return error, tolerance, 1e3 * min(spent)


def main() -> None:
    options = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    options.add_argument("count", type=int, nargs="?", default=100, help="simulations of each system (default: 100)")
    options.add_argument("--rounds", type=int, default=3, help="how often; the best counts (default: 3)")
    options.add_argument("--scipy", action="store_true", help="compare with SciPy, which must be installed")
    options.add_argument("--figures", action="store_true", help=argparse.SUPPRESS)  # one round as JSON
    options.add_argument("--compared", action="store_true", help=argparse.SUPPRESS)  # SciPy as JSON
    given = options.parse_args()
    if given.figures or given.compared:
        print(json.dumps(measured(given.count) if given.figures else {name: compared(name) for name in SYSTEMS}))
        return
    rounds = [(in_a_process("1", given.count), in_a_process("0", given.count)) for _ in range(given.rounds)]
    scipy = dict[str, tuple[float, float, float]]()
    if given.scipy:
        environment = os.environ | {"SIM2REASON_NATIVE": "0", "PYTHONPATH": path()}
        command = [sys.executable, __file__, "--compared"]
        scipy = json.loads(subprocess.run(command, env=environment, check=True, capture_output=True).stdout)
    for name in [*SYSTEMS, PHASE]:
        native, plain = (min(found[side][name] for found in rounds) for side in (0, 1))
        line = f"{name:16} native {native:7.3f} ms, Python {plain:7.3f} ms, {plain / native:5.2f} times as fast"
        if name in scipy:
            error, tolerance, spent = scipy[name]
            line += (
                f"; SciPy {spent:7.3f} ms at {tolerance:.0e} for an error of {error:.0e}, {spent / native:5.1f} times"
            )
        print(line)


if __name__ == "__main__":
    main()
