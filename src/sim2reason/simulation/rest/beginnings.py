"""Whether two mechanisms are one that begins otherwise: at another place, or with other speeds."""

from dataclasses import replace

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.simulation.rest.equilibrium import Rest, equilibrium
from sim2reason.simulation.rest.loads import Vector
from sim2reason.simulation.rest.oscillation import inertia

SAME = 1e-6  # relative: what differs by less is the same; a stated number is shifted by a thousand times as much


def begins_otherwise(one: Mechanism, other: Mechanism) -> bool:
    """Whether they differ in speeds alone, or come to rest alike, with the same forces, lengths, inertia, stiffness."""
    if len(one.coordinates) != len(other.coordinates):
        return False
    if _still(one) == _still(other):
        return True
    rest, again = equilibrium(one), equilibrium(other)
    if rest is None or again is None:
        return False
    return all(_alike(mine, its) for mine, its in zip(_facts(rest), _facts(again), strict=True))


def _still(mechanism: Mechanism) -> Mechanism:
    bodies = (
        replace(body, coordinates=tuple(replace(coordinate, speed=0.0) for coordinate in body.coordinates))
        for body in mechanism.bodies
    )
    return replace(mechanism, bodies=tuple(bodies))


def _facts(rest: Rest) -> tuple[Vector, ...]:
    """What tells of an equilibrium how the mechanism stands there, and how it would move."""
    state, lines = rest.state, rest.mechanism.lines
    lengths = [float(state.length(line)[0][0]) for line in lines]
    forces = [float(force[0]) for found in (state.tension, state.normal) for force in found.values()]
    stiffness = rest.allowed @ rest.stiffness @ rest.allowed.T
    weights = [body.mass for body in rest.mechanism.bodies]
    return np.array(lengths), np.array(forces), np.array(weights), inertia(rest), stiffness


def _alike(mine: Vector, its: Vector) -> bool:
    if mine.shape != its.shape:
        return False
    return bool(np.allclose(mine, its, rtol=0.0, atol=SAME * float(np.abs(mine).max(initial=0.0)), equal_nan=True))
