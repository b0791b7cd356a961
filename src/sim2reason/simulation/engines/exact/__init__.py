"""The exact engine: closed-form motion between events if the equations are constant, else numerical integration.

`assembly` builds the equations of motion for numbers and for symbols; `dsl.constancy` decides whether they are
constant. At each event `settling` computes impacts (`impulses`) and the acting forces (`balance`, by the search in
`contact_modes`). The motion to the next event is computed by `glide` in closed form, or by `flow`, which integrates
(`dop853`) the code that `formulas` generates on a `tape` and locates events within steps (`margins`, `crossings`).
`engine` is the main loop. Where a C compiler was found at installation, the `native` core does the work of `tape`,
`dop853`, `flow`, `crossings` and part of `contact_modes`, with the same results; `uses_native_core` returns whether.
"""

from sim2reason.simulation.engines.exact.engine import motion, simulate
from sim2reason.simulation.engines.exact.motion import Motion, Segment
from sim2reason.simulation.engines.exact.native import uses_native_core

__all__ = ["Motion", "Segment", "motion", "simulate", "uses_native_core"]
