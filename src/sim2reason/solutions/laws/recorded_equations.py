"""Equations of motion as the exact engine records them on a tape, and the phase in which they hold."""

import math
from dataclasses import replace

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import State
from sim2reason.dsl.vectors import Vector
from sim2reason.simulation.engines.exact.assembly import Assembly
from sim2reason.simulation.engines.exact.lengths import Phase
from sim2reason.simulation.engines.exact.tape import Tape

ROUNDING = 1e-12  # m: a coordinate of a body that is smaller is zero


def _exact(mechanism: Mechanism) -> Mechanism:
    """Return the mechanism with coordinates that are rounding errors set to zero, so that twins have one form."""

    def rounded(vector: Vector) -> Vector:
        x, y, z = (0.0 if abs(part) < ROUNDING else part for part in vector)
        return x, y, z

    bodies = tuple(
        replace(
            body,
            at=rounded(body.at),
            center=rounded(body.center),
            coordinates=tuple(replace(c, axis=rounded(c.axis)) for c in body.coordinates),
        )
        for body in mechanism.bodies
    )
    return replace(mechanism, bodies=bodies, sites=tuple(replace(s, at=rounded(s.at)) for s in mechanism.sites))


def assembled(mechanism: Mechanism, phase: Phase) -> tuple[Assembly, Tape]:
    """Record the equations of a mechanism in a phase; the inputs are the time, the coordinates and their rates."""
    mechanism = _exact(mechanism)
    size = len(mechanism.coordinates)
    tape = Tape(["t", *(f"q{k}" for k in range(size)), *(f"v{k}" for k in range(size))])
    symbols = list(tape.inputs.values())
    return Assembly(mechanism, phase, (symbols[1 : size + 1], symbols[size + 1 :], symbols[0]), tape), tape


def phase_at(state: State) -> Phase:
    """Return which fields, engines and one-sided springs act at an instant; nothing sticks."""
    m, time = state.mechanism, float(state.times[0])
    inside: list[tuple[bool, ...]] = []
    for force in m.forces:
        place = state.vector(state.frames.center(force.body).place)[0]
        margins = force.region.margins((place[0], place[1], place[2]), math) if force.region is not None else ()
        inside.append((all(float(margin) >= 0.0 for margin in margins),))  # type: ignore[arg-type]
    lengths = {line.name: float(state.free_length(line)[0][0]) for line, _ in m.half_springs}
    return Phase(
        inside=tuple(inside),
        burning=tuple(time < burn.until for burn in m.burns),
        stuck=(False,) * len(m.meetings),
        strained=tuple(law.side * (lengths[line.name] - law.length) >= 0.0 for line, law in m.half_springs),
    )
