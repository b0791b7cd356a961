"""What impacts bring about: velocities jump at them, places do not."""

from collections.abc import Callable, Iterable, Sequence

import numpy as np

from sim2reason.dsl.mechanism import Inextensible, Mechanism, Prop, Rigid
from sim2reason.dsl.state import Array, State
from sim2reason.quantities.energy import KineticEnergy
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.trace import Event, Trace

IMPACTS = frozenset({"collision", "taut", "land"})
BALANCE = 1e-6  # of an impulse: by how much two may differ that are one


def jumps(trace: Trace, of: Callable[[State], Array], times: Iterable[float]) -> list[Array]:
    """By how much a function of the state differs just after each of some instants, s, from just before."""
    return [
        np.asarray(of(trace.at(time))[0] - of(trace.at(float(np.nextafter(time, 0.0))))[0])
        for time in dict.fromkeys(times)  # several events may share an instant
    ]


def hits(trace: Trace, end: float, chosen: Callable[[Event], bool] = lambda _: True) -> list[float]:
    """The times, s, of collisions of a kind up to an instant, in order, each event for itself."""
    return [event.time for event in trace.events if event.kind == "collision" and event.time <= end and chosen(event)]


def is_smooth(trace: Trace, end: float) -> bool:
    """Whether no impact happens up to an instant, so that no force is greater than any."""
    return not any(event.kind in IMPACTS and event.time <= end for event in trace.events)


def energy_lost(trace: Trace, times: Iterable[float]) -> float:
    """The kinetic energy, J, that all bodies lose together at some instants."""

    def kinetic(state: State) -> Array:
        return np.sum([KineticEnergy.evaluate(state, body) for body in massive(state.mechanism)], axis=0)

    return -float(np.sum(jumps(trace, kinetic, times)))


def massive(mechanism: Mechanism) -> Sequence[str]:
    """The names of all bodies with a mass."""
    return [body.name for body in mechanism.bodies if body.mass > 0.0]


def energies(mechanism: Mechanism) -> tuple[Channel, ...]:
    """What a loss of kinetic energy hangs on."""
    return tuple(Channel(name, KineticEnergy.name) for name in massive(mechanism))


def is_loose(mechanism: Mechanism, name: str) -> bool:
    """Whether nothing but faces holds a body at an impact: no line, no hinge, no rider."""
    tied = {mechanism.site[s].body for line in mechanism.lines if _holds(line.law) for s in line.through}
    body = mechanism.body[name]
    ridden = any(other.parent == name for other in mechanism.bodies)
    slides = all(c.kind == "slide" for c in body.coordinates) and body.parent is None
    return slides and not ridden and name not in tied


def _holds(law: object) -> bool:
    return isinstance(law, Inextensible | Rigid | Prop)
