"""In what two mechanisms are alike at rest: how they stand there, what acts, what moves, and what drives it back."""

from collections.abc import Collection
from dataclasses import replace

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.simulation.rest.equilibrium import Rest, equilibrium
from sim2reason.simulation.rest.loads import Vector
from sim2reason.simulation.rest.oscillation import inertia

SAME = 1e-6  # relative: what differs by less is the same; a stated number is shifted by a thousand times as much


def alike_at_rest(one: Mechanism, other: Mechanism, aspects: Collection[str]) -> bool:
    """Whether they differ in the speeds at the start alone, or agree at rest in some aspects, whatever came before.

    Aspects are ``lengths`` of lines, ``forces``, ``inertia`` and ``stiffness``.
    """
    if len(one.coordinates) != len(other.coordinates):
        return False
    if _still(one) == _still(other):
        return True
    rest, again = equilibrium(one), equilibrium(other)
    if rest is None or again is None:
        return False
    mine, its = _facts(rest), _facts(again)
    return all(_same(mine[aspect], its[aspect]) for aspect in aspects)


def _still(mechanism: Mechanism) -> Mechanism:
    bodies = (
        replace(body, coordinates=tuple(replace(coordinate, speed=0.0) for coordinate in body.coordinates))
        for body in mechanism.bodies
    )
    return replace(mechanism, bodies=tuple(bodies))


def _facts(rest: Rest) -> dict[str, Vector]:
    state = rest.state
    forces = [float(force[0]) for found in (state.tension, state.normal) for force in found.values()]
    return {
        "lengths": np.array([float(state.length(line)[0][0]) for line in rest.mechanism.lines]),
        "forces": np.array(forces),
        "inertia": inertia(rest),
        "stiffness": rest.allowed @ rest.stiffness @ rest.allowed.T,
    }


def _same(mine: Vector, its: Vector) -> bool:
    if mine.shape != its.shape:
        return False
    return bool(np.allclose(mine, its, rtol=0.0, atol=SAME * float(np.abs(mine).max(initial=0.0)), equal_nan=True))
