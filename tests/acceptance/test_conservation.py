"""Tests of the conservation of energy and momentum in scenes without friction, hands or inelastic impacts."""

from collections.abc import Iterator
from itertools import count

import numpy as np
import pytest

from cells import drawn
from sim2reason.questions.difficulty import DIFFICULTIES, Difficulty
from sim2reason.scenes.dsl.mechanism import Elastic, Mechanism, X, Y
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.scenes.dsl.vectors import Vector
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.simulation.scenes import simulate
from sim2reason.simulation.trace import Trace

SCENES = [3, pytest.param(17, marks=pytest.mark.slow)]  # of each cell: 357 in all
CONSERVING = ("box", "collision", "hybrid", "incline", "pendulum", "pulley", "rotation")
"""Recipes whose energy is that of motion and weight alone; test_balances and the kit account for the work of others."""
LIMIT = 1600  # draws; scenes without friction or hands are rare among hard ones
CLOSE = 1e-8


def conserves(mechanism: Mechanism) -> bool:
    return not (
        mechanism.pulls
        or mechanism.forces
        or any(isinstance(line.law, Elastic) or getattr(line.law, "reel", 0.0) for line in mechanism.lines)
        or any(contact.friction > 0.0 for contact in mechanism.contacts.values())
        or any(pair.restitution < 1.0 for pair in mechanism.meetings)
    )


def motions(recipe: str, difficulty: Difficulty, seed: int) -> Iterator[Trace]:
    """Yield motions that conserve energy for a while; a string that snaps taut is an inelastic impact."""
    for scene in drawn(recipe, difficulty, LIMIT, seed):
        if conserves(scene.mechanism):
            trace = simulate(scene)
            if trace.stable_until > 0.0 and not any(event.kind == "taut" for event in trace.events):
                yield trace


def sampled(trace: Trace) -> State:
    return trace.sample(np.linspace(0.0, trace.stable_until, 60))


def total(state: State, quantity: str) -> Array:
    """Return the sum over all bodies of a scalar (n,) or vector (n, 3)."""
    return np.sum([QUANTITIES[quantity].evaluate(state, name) for name in state.mechanism.body], axis=0)


def energy_drift(state: State) -> float:
    """Return the largest change of the total energy relative to the largest energy of any body."""
    parts = ("kinetic energy", "potential energy")
    scale = max(np.abs(QUANTITIES[part].evaluate(state, name)).max() for part in parts for name in state.mechanism.body)
    energy = total(state, parts[0]) + total(state, parts[1])
    return float(np.abs(energy - energy[0]).max() / max(scale, 1e-3))


def free_directions(mechanism: Mechanism) -> list[Vector]:
    """Return the horizontal axes along which all root bodies can move and no external force acts."""
    roots = [body for body in mechanism.bodies if body.parent is None]
    if any(mechanism.site[site].body is None for line in mechanism.lines for site in line.through):
        return []
    if any(meeting.a is None for meeting in mechanism.meetings):
        return []
    return [axis for axis in (X, Y) if all(any(c.axis == axis for c in body.coordinates) for body in roots)]


def momentum_drift(state: State, direction: Vector) -> float:
    found = total(state, "momentum") @ np.array(direction)
    scale = max(
        np.linalg.norm(QUANTITIES["momentum"].evaluate(state, name), axis=1).max() for name in state.mechanism.body
    )
    return float(np.abs(found - found[0]).max() / max(scale, 1e-3))


@pytest.mark.parametrize("scenes", SCENES)
@pytest.mark.parametrize("recipe", CONSERVING)
def test_energy_stays_what_it_was(recipe: str, scenes: int) -> None:
    seen = 0
    for difficulty in DIFFICULTIES:
        found = motions(recipe, difficulty, 21)
        for number, trace in zip(range(scenes), found, strict=False):
            assert energy_drift(sampled(trace)) <= CLOSE, (recipe, difficulty, number)
            seen += 1
    assert seen == 3 * scenes


@pytest.mark.parametrize("recipe", ["collision", "box"])
def test_momentum_stays_where_nothing_outside_pushes(recipe: str) -> None:
    seen = moved = 0
    for seed in count(31):
        for difficulty in DIFFICULTIES:
            for number, trace in zip(range(17), motions(recipe, difficulty, seed), strict=False):
                for direction in free_directions(trace.mechanism):
                    state = sampled(trace)
                    assert momentum_drift(state, direction) <= CLOSE, (recipe, difficulty, number)
                    seen += 1
                    moved += bool(np.abs(state.v).max() > 1e-6)
        if seen >= 30:
            break
    assert moved >= 0.9 * seen
