"""Paths in the plane of the axes that a text defines."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from sim2reason.scenes.dsl.measures import show_unit
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.scenes.dsl.vectors import Vector
from sim2reason.simulation.quantities.subjects.bodies import Bodies


@dataclass(frozen=True)
class Trajectory:
    """Where the centre of mass of a body goes: coordinates along two axes, from the origin of its entity."""

    body: str
    name: str
    x: Array
    y: Array


@dataclass(frozen=True)
class Trajectories:
    """Those of one entity, in one plane."""

    across: str
    up: str
    members: tuple[Trajectory, ...]


def trajectories(state: State, mentions: Mapping[str, str], origins: Mapping[str, Vector]) -> tuple[Trajectories, ...]:
    """By entity the paths of all bodies for whose two directions the text has axes."""
    of, found = Bodies(), dict[tuple[str, str, str], list[Trajectory]]()
    unit = show_unit(state.mechanism.units.length)
    for name, phrase in of.phrases(state.mechanism, mentions).items():
        axes = [sense for sense in of.senses(state.mechanism, name) if sense.axis]
        if len(axes) == 2:
            owner = name.split(".", maxsplit=1)[0]
            place = state.vector(state.frames.center(name).place) - np.array(origins.get(owner, (0.0, 0.0, 0.0)))
            x, y = (place @ np.array(axis.vector) for axis in axes)
            one, other = (f"{axis.axis} ({unit})" for axis in axes)
            found.setdefault((owner, one, other), []).append(Trajectory(name, of.label(phrase), x, y))
    return tuple(Trajectories(one, other, tuple(members)) for (_, one, other), members in found.items())
