"""The MuJoCo engine: an independent simulation of the same mechanism, used to check the exact engine.

`specification` describes the mechanism for MjSpec; `model` compiles it and returns MuJoCo's mass matrix, bias and
Jacobians at any state, with `distances` for lines and attraction. `forces` solves the linear system of one contact
mode, and `contact_modes` finds the consistent mode. `instant` applies both to impacts and forces at one instant;
`engine` advances from event to event with the steps of `integration`, whose events `margins` and `event_search` find;
`record` stores the steps. `own_units` first converts very light mechanisms to other units. MuJoCo is imported when the
first mechanism is simulated.

Where the equations of motion are constant by the mechanism's structure, one step reaches the next event: its
accelerations are those at its start, and its event functions are polynomials of time.
"""

from importlib import import_module

from sim2reason.errors import SimulationError
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.state import Array, check_initial_speeds
from sim2reason.simulation.engines.mujoco.own_units import is_tiny, run_in_own_units
from sim2reason.simulation.trace import DEFAULT_STEP_RTOL, ENGINES, Trace

__all__ = ["simulate"]


@ENGINES.register("mujoco")
def simulate(mechanism: Mechanism, times: Array, tolerance: float = DEFAULT_STEP_RTOL) -> Trace:
    """Simulate a mechanism with MuJoCo's model, as an independent check: the motion at `times` (m,).

    Times are in seconds, increasing from 0; its tolerance is its own.

    Raises:
        SceneError: two sites of a string coincide, two bodies overlap, or a rod's ends begin to part, at the start.
        SimulationError: no consistent forces, more than 500 events, more operations than its
            budget has, or any warning of the library.
    """
    del tolerance
    check_initial_speeds(mechanism)
    with import_module(f"{__name__}.specification").collect_warnings() as messages:
        run = import_module(f"{__name__}.engine").run
        trace: Trace = run_in_own_units(run, mechanism, times) if is_tiny(mechanism) else run(mechanism, times)
    if messages:
        raise SimulationError(f"MuJoCo warns: {messages[0]}")
    return trace
