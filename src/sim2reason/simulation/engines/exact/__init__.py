"""The exact engine: from event to event by closed forms where nothing bends, and by integration where something does.

`assembly` writes the equations of motion once, for numbers and for symbols; `dsl.constancy` says whether they ever
change. At each event `settling` lets what collides bounce (`impulses`) and finds what acts (`balance`, by the search
in `contact_modes`). On to the next event then goes `glide`, in closed form, or `flow`, which integrates (`dop853`) the
code that `formulas` writes on a `tape`, and locates events on its steps (`margins`, `crossings`). `engine` is the loop.
"""

from sim2reason.simulation.engines.exact.engine import motion, simulate
from sim2reason.simulation.engines.exact.motion import Motion, Segment

__all__ = ["Motion", "Segment", "motion", "simulate"]
