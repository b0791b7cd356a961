"""The MuJoCo engine: an independent simulation of the same mechanism, used to check the exact engine.

`specification` describes the mechanism for MjSpec and `compiled_model` compiles it: both call MuJoCo.
`balance` uses its solver to find forces and impulses without the softness of its constraints; `forces` derives from
them the taut strings and the sticking or sliding contacts; `event_detection` predicts events; `engine` advances from
event to event in steps of RK4; `record` stores the steps. `changing_equations` does the same for mechanisms that
MuJoCo's own constraints cannot represent. `own_units` first converts very light mechanisms to other units. MuJoCo is
imported when the first mechanism is simulated.
"""

from importlib import import_module
from math import inf

from sim2reason.errors import SimulationError
from sim2reason.scenes.dsl.mechanism import ConstantTension, Inextensible, Line, Mechanism
from sim2reason.scenes.dsl.state import Array, check_speeds
from sim2reason.scenes.dsl.structure import changing
from sim2reason.simulation.engines.mujoco.own_units import in_own_units, is_tiny
from sim2reason.simulation.trace import ENGINES, FINEST, Trace

__all__ = ["simulate"]


@ENGINES.register("mujoco")
def simulate(mechanism: Mechanism, times: Array, tolerance: float = FINEST) -> Trace:
    """Simulate a mechanism with MuJoCo's model and solver, as an independent check: the motion at `times` (m,).

    Times are in seconds, increasing from 0; its tolerance is its own.

    Raises:
        UnsupportedError: a string bends as it moves.
        SceneError: two sites of a string coincide, two bodies overlap, or a rod's ends begin to part, at the start.
        SimulationError: no consistent forces, more than 500 events, more operations than its
            budget has, or any warning of the library.
    """
    del tolerance
    check_speeds(mechanism)
    soft = is_simple(mechanism) and not changing(mechanism)
    with import_module(f"{__name__}.specification").collect_warnings() as said:
        loop = "engine" if soft else "changing_equations.engine"
        run = import_module(f"{__name__}.{loop}").run
        trace: Trace = in_own_units(run, mechanism, times) if is_tiny(mechanism) else run(mechanism, times)
    if said:
        raise SimulationError(f"MuJoCo warns: {said[0]}")
    return trace


def is_simple(mechanism: Mechanism) -> bool:
    """Return whether MuJoCo's own constraints can represent all constraints of a mechanism."""
    plain = all(
        isinstance(line.law, ConstantTension) or line.law == Inextensible(_slack(line)) for line in mechanism.lines
    )
    slides = all(len(face.slip) == 1 and face.friction < inf and not face.guided for face in mechanism.faces)
    bounces = all(meeting.normal is None and not meeting.sticks for meeting in mechanism.meetings)
    return plain and slides and bounces and not mechanism.forces


def _slack(line: Line) -> float:
    return line.law.slack if isinstance(line.law, Inextensible) else 0.0
