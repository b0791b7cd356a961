"""What the second engine sees of an equilibrium: whether all stays at rest there, and how it swings about it."""

import numpy as np

from sim2reason.dsl.displaced import displaced
from sim2reason.dsl.state import State
from sim2reason.errors import SceneError, SimulationError, UnsupportedError
from sim2reason.simulation.certify import SMOOTH, WITNESS
from sim2reason.simulation.engines.exact.system import System
from sim2reason.simulation.rest.equilibrium import Rest, neighbour
from sim2reason.simulation.rest.oscillation import Oscillations, inertia
from sim2reason.simulation.trace import ENGINES

SMALL = 1e-3  # amplitude: rad, or that share of the shortest straight piece of a line
SAMPLES = 5  # in half a period
SHAPE = 1e-2  # of the amplitude: small oscillations are sines up to their size
PHASE = 1e-3  # of a period
INSTANT = 1e-3  # s: long enough for a state at rest


def unrest(rest: Rest) -> str:
    """Why the witness does not see everything at rest in an equilibrium, with the same forces; empty if it does."""
    mechanism, still = rest.mechanism, [0.0] * len(rest.mechanism.coordinates)
    try:
        there = displaced(mechanism, rest.coordinates.tolist(), still)
        seen = ENGINES[WITNESS](there, np.array([0.0, INSTANT])).state
    except (SceneError, SimulationError, UnsupportedError) as error:
        return f"no witness: {error}"
    if float(np.abs(inertia(rest) @ seen.a[0]).max(initial=0.0)) > SMOOTH * _load(rest.state):
        return "in the other engine the equilibrium is none"
    for name in ("tension", "normal", "friction"):
        ours, theirs = getattr(rest.state, name), getattr(seen, name)
        if any(abs(float(theirs[key][0] - value[0])) > SMOOTH * _load(rest.state) for key, value in ours.items()):
            return f"the engines disagree on a {name} at rest"
    return ""


def _load(state: State) -> float:
    """The largest force at rest, N, or the largest weight."""
    mechanism = state.mechanism
    weight = max(body.mass for body in mechanism.bodies) * float(np.linalg.norm(mechanism.gravity))
    forces = [*state.tension.values(), *state.normal.values()]
    return max([weight, *(abs(float(force[0])) for force in forces if np.isfinite(force[0]))]) or 1.0


def disagreement(rest: Rest, modes: Oscillations, number: int) -> str:
    """Why the witness does not swing in a mode as it is told, from a small displacement; empty if it does."""
    mechanism, frequency, shape = rest.mechanism, float(modes.frequencies[number]), modes.shapes[:, number]
    system = System(mechanism)
    shortest = min([run.value for run in system.runs.values()], default=1.0)
    hinges = np.array([coordinate.kind == "hinge" for coordinate in mechanism.coordinates])
    shift = SMALL * shape / float((np.abs(shape) / np.where(hinges, 1.0, shortest)).max())
    begun = neighbour(rest, shift)
    times = np.linspace(0.0, np.pi / frequency, SAMPLES)
    try:
        trace = ENGINES[WITNESS](displaced(mechanism, begun.tolist(), [0.0] * len(begun)), times)
    except (SceneError, SimulationError, UnsupportedError) as error:
        return f"no witness: {error}"
    if trace.stable_until < times[-1]:
        return "in the other engine the oscillation ends"
    places = trace.state.q + (begun - rest.coordinates)
    mass = inertia(rest)
    size = float(shift @ mass @ shift)
    apart = np.abs(places @ mass @ shift / size - np.cos(frequency * times)).max()
    late = float(np.abs(trace.state.v[-1] @ mass @ shift)) / (size * frequency) / (2.0 * np.pi)
    return "" if apart <= SHAPE and late <= PHASE else "in the other engine it oscillates otherwise"
