"""Small oscillations about a stable equilibrium, and their check by the second engine."""

import math
from collections.abc import Collection
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from sim2reason.errors import SceneError, SimulationError, UnsupportedError
from sim2reason.scenes.dsl.fields import Push
from sim2reason.scenes.dsl.mechanism import Elastic, Mechanism
from sim2reason.scenes.dsl.state import State, displace
from sim2reason.simulation.certify import SMOOTH_RTOL, WITNESS
from sim2reason.simulation.engines.exact.assembly import Assembly
from sim2reason.simulation.engines.exact.system import System
from sim2reason.simulation.equilibrium import Equilibrium, equilibrium, neighbour
from sim2reason.simulation.loads import Vector
from sim2reason.simulation.trace import ENGINES

MASSLESS_RTOL = 1e-9  # fraction of the largest inertia: a smaller one counts as massless
ZERO_FREQUENCY_RTOL = 1e-6  # fraction of the largest ω²: a smaller one counts as zero


@dataclass(frozen=True)
class Oscillations:
    """The normal modes of small oscillations, lowest frequency first."""

    frequencies: Vector  # angular, rad/s, (k,); modes without restoring force are omitted
    shapes: Vector  # the displacement of the coordinates in each mode, m or rad, (n, k), of arbitrary size


def oscillations(rest: Equilibrium) -> Oscillations | None:
    """Return the normal modes about a stable equilibrium; None with damping, gyroscopic forces or zero stiffness."""
    mechanism = rest.mechanism
    if not _conserves(mechanism):
        return None
    mass = rest.allowed.T @ inertia(rest) @ rest.allowed
    sizes, axes = np.linalg.eigh(mass)
    heavy = sizes > MASSLESS_RTOL * float(sizes.max(initial=0.0))
    stiffness = axes.T @ rest.stiffness @ axes
    follow = _following(stiffness, heavy)
    if follow is None or not heavy.any():
        return None
    reduced = stiffness[np.ix_(heavy, heavy)] + stiffness[np.ix_(heavy, ~heavy)] @ follow
    roots = 1.0 / np.sqrt(sizes[heavy])
    squares, turned = np.linalg.eigh(roots[:, None] * reduced * roots)
    moving = squares > ZERO_FREQUENCY_RTOL * float(squares.max(initial=0.0))
    main = roots[:, None] * turned[:, moving]
    shapes = np.zeros((len(sizes), int(moving.sum())))
    shapes[heavy], shapes[~heavy] = main, follow @ main
    return Oscillations(np.sqrt(squares[moving]), rest.allowed @ axes @ shapes)


def inertia(rest: Equilibrium) -> Vector:
    """Return the mass matrix of all coordinates at an equilibrium, (n, n)."""
    mechanism, places = rest.mechanism, rest.coordinates.tolist()
    assembly = Assembly(mechanism, System(mechanism).phase, (places, [0.0] * len(places), 0.0), math)
    return np.array(assembly.full_mass(), dtype=np.float64)


def _following(stiffness: Vector, heavy: NDArray[np.bool_]) -> Vector | None:
    """Return the matrix by which massless coordinates follow the others; None if one is not held."""
    light = stiffness[np.ix_(~heavy, ~heavy)]
    if len(light) and float(np.linalg.eigvalsh(light).min()) <= ZERO_FREQUENCY_RTOL * float(np.abs(stiffness).max()):
        return None
    matrix: Vector = np.zeros((int((~heavy).sum()), int(heavy.sum())))
    return matrix - np.linalg.solve(light, stiffness[np.ix_(~heavy, heavy)])


def _conserves(mechanism: Mechanism) -> bool:
    """Return whether no force depends on velocities, as dashpots, drag and magnetic fields do."""
    dashpots = any(isinstance(line.law, Elastic) and line.law.damping for line in mechanism.lines)
    return not dashpots and all(isinstance(force.law, Push) or force.law.constant for force in mechanism.forces)


RELATIVE_DIFFERENCE_TOL = (
    1e-6  # relative: smaller differences count as equal; a stated number is shifted by a thousand times as much
)


def agree_at_rest(one: Mechanism, other: Mechanism, aspects: Collection[str]) -> bool:
    """Return whether two mechanisms differ in initial speeds alone, or agree at rest in the given aspects.

    Aspects are ``lengths`` of lines, ``forces``, ``inertia`` and ``stiffness``.
    """
    if len(one.coordinates) != len(other.coordinates):
        return False
    if _without_speeds(one) == _without_speeds(other):
        return True
    rest, again = equilibrium(one), equilibrium(other)
    if rest is None or again is None:
        return False
    mine, its = _facts(rest), _facts(again)
    return all(_same(mine[aspect], its[aspect]) for aspect in aspects)


def _without_speeds(mechanism: Mechanism) -> Mechanism:
    bodies = (
        replace(body, coordinates=tuple(replace(coordinate, speed=0.0) for coordinate in body.coordinates))
        for body in mechanism.bodies
    )
    return replace(mechanism, bodies=tuple(bodies))


def _facts(rest: Equilibrium) -> dict[str, Vector]:
    state = rest.state
    forces = [float(force[0]) for forces_by_name in (state.tension, state.normal) for force in forces_by_name.values()]
    return {
        "lengths": np.array([float(state.length(line)[0][0]) for line in rest.mechanism.lines]),
        "forces": np.array(forces),
        "inertia": inertia(rest),
        "stiffness": rest.allowed @ rest.stiffness @ rest.allowed.T,
    }


def _same(mine: Vector, its: Vector) -> bool:
    if mine.shape != its.shape:
        return False
    return bool(
        np.allclose(
            mine, its, rtol=0.0, atol=RELATIVE_DIFFERENCE_TOL * float(np.abs(mine).max(initial=0.0)), equal_nan=True
        )
    )


AMPLITUDE = 1e-3  # amplitude: rad, or fraction of the shortest straight line segment
SAMPLES_PER_HALF_PERIOD = 5  # in half a period
MAX_SHAPE_DEVIATION = 1e-2  # fraction of the amplitude: largest deviation of a small oscillation from a sine
MAX_PHASE_ERROR = 1e-3  # fraction of a period: largest phase error
REST_DURATION = 1e-3  # s: duration of the simulation of a state at rest


def equilibrium_disagreement(rest: Equilibrium) -> str:
    """Return why the second engine disagrees about an equilibrium or its forces; empty if it agrees."""
    mechanism, still = rest.mechanism, [0.0] * len(rest.mechanism.coordinates)
    try:
        there = displace(mechanism, rest.coordinates.tolist(), still)
        seen = ENGINES[WITNESS](there, np.array([0.0, REST_DURATION])).state
    except (SceneError, SimulationError, UnsupportedError) as error:
        return f"no witness: {error}"
    if float(np.abs(inertia(rest) @ seen.a[0]).max(initial=0.0)) > SMOOTH_RTOL * _load(rest.state):
        return "in the other engine the equilibrium is none"
    for name in ("tension", "normal", "friction"):
        ours, theirs = getattr(rest.state, name), getattr(seen, name)
        if any(abs(float(theirs[key][0] - value[0])) > SMOOTH_RTOL * _load(rest.state) for key, value in ours.items()):
            return f"the engines disagree on a {name} at rest"
    return ""


def _load(state: State) -> float:
    """Return the largest force at rest, or the largest weight, N."""
    mechanism = state.mechanism
    weight = max(body.mass for body in mechanism.bodies) * float(np.linalg.norm(mechanism.gravity))
    forces = [*state.tension.values(), *state.normal.values()]
    return max([weight, *(abs(float(force[0])) for force in forces if np.isfinite(force[0]))]) or 1.0


def mode_disagreement(rest: Equilibrium, modes: Oscillations, number: int) -> str:
    """Return why the second engine disagrees about a normal mode of small amplitude; empty if it agrees."""
    mechanism, frequency, shape = rest.mechanism, float(modes.frequencies[number]), modes.shapes[:, number]
    system = System(mechanism)
    shortest = min([run.value for run in system.runs.values()], default=1.0)
    hinges = np.array([coordinate.kind == "hinge" for coordinate in mechanism.coordinates])
    shift = AMPLITUDE * shape / float((np.abs(shape) / np.where(hinges, 1.0, shortest)).max())
    begun = neighbour(rest, shift)
    times = np.linspace(0.0, np.pi / frequency, SAMPLES_PER_HALF_PERIOD)
    try:
        trace = ENGINES[WITNESS](displace(mechanism, begun.tolist(), [0.0] * len(begun)), times)
    except (SceneError, SimulationError, UnsupportedError) as error:
        return f"no witness: {error}"
    if trace.stable_until < times[-1]:
        return "in the other engine the oscillation ends"
    places = trace.state.q + (begun - rest.coordinates)
    mass = inertia(rest)
    size = float(shift @ mass @ shift)
    deviation = np.abs(places @ mass @ shift / size - np.cos(frequency * times)).max()
    late = float(np.abs(trace.state.v[-1] @ mass @ shift)) / (size * frequency) / (2.0 * np.pi)
    return (
        ""
        if deviation <= MAX_SHAPE_DEVIATION and late <= MAX_PHASE_ERROR
        else "in the other engine it oscillates otherwise"
    )
