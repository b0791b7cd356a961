"""Lengths of all lines of a mechanism as arrays, with their rates and the forces of springs."""

from collections.abc import Mapping
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from sim2reason.errors import SimulationError
from sim2reason.scenes.dsl.mechanism import ZERO, Line
from sim2reason.scenes.dsl.state import Array
from sim2reason.scenes.dsl.vectors import Triple
from sim2reason.simulation.engines.mujoco.specification import mujoco


class Pieces(NamedTuple):
    """The straight segments of lines: ends, lengths, directions, and Jacobians of separation (pieces, 3, joints)."""

    places: Array  # positions of all sites
    runs: Array
    ways: Array
    moved: Array


class Lengths(NamedTuple):
    """The lengths of lines, m, with gradients (lines, joints) and straight segments."""

    values: Array
    gradients: Array
    pieces: Pieces


class Lines:
    """A set of lines, as arrays over their straight segments."""

    def __init__(
        self,
        lines: tuple[Line, ...],
        sites: dict[str, int],
        index: dict[str, int],
        model: Any,  # noqa: ANN401 - MuJoCo's
        *,
        straight: bool,
        ways: Mapping[tuple[str, str], Triple],
    ) -> None:
        """Index the sites and joints of the compiled `model`; `straight` means that no joint rotates.

        `ways` are the unit vectors of segments of constant direction. If the ends of such a segment nearly coincide, a
        direction computed from their positions would be round-off and would cause a jerk of the force.
        """
        self.lines = lines
        names = sorted({name for line in lines for name in line.through})
        place = {name: number for number, name in enumerate(names)}
        pieces = [(owner, ends) for owner, line in enumerate(lines) for ends in pairwise(line.through)]
        self._model, self._straight = model, straight
        self._sites = np.array([sites[name] for name in names], dtype=np.intp)
        self._carriers = [int(model.site_bodyid[site]) for site in self._sites]
        self._first = np.array([place[first] for _, (first, _) in pieces], dtype=np.intp)
        self._last = np.array([place[last] for _, (_, last) in pieces], dtype=np.intp)
        self._kept = np.array([ways.get(ends, ZERO) for _, ends in pieces]).reshape(len(pieces), 3)
        self._keeps = np.array([ends in ways for _, ends in pieces], dtype=bool)
        self._is_kept = bool(self._keeps.any())
        self._owned, self._wound = np.zeros((len(lines), len(pieces))), np.zeros((len(lines), int(model.nv)))
        for number, (owner, _) in enumerate(pieces):
            self._owned[owner, number] = 1.0
        for owner, line in enumerate(lines):
            for wheel in line.wheels:
                self._wound[owner, index[wheel.coordinate]] += wheel.radius
        self._wheels, self._single = bool(self._wound.any()), len(pieces) == len(lines)
        self._apart: Array | None = None  # how the Jacobians of the ends of each piece differ, where nothing turns
        self._jacobians = np.zeros((len(names), 3, int(model.nv)))
        self._dots = np.zeros_like(self._jacobians)

    def lengths(self, data: Any, q: Array) -> Lengths:  # noqa: ANN401 - MuJoCo's
        """Return the lengths of the lines, with gradients and segments."""
        places = data.site_xpos.take(self._sites, axis=0)
        apart = places.take(self._last, axis=0) - places.take(self._first, axis=0)
        runs, ways = self._directed(apart)
        moved = self._moved(data, places)
        values, gradients = self._summed(runs), self._summed(np.vecmat(ways, moved))
        if self._wheels:
            values, gradients = values + self._wound @ q, gradients + self._wound
        return Lengths(values, gradients, Pieces(places, runs, ways, moved))

    def _directed(self, apart: Array) -> tuple[Array, Array]:
        """Return the lengths (pieces,) and directions of segments, given the separations of their ends, (pieces, 3)."""
        keeps = self._keeps
        runs: Array = np.sqrt(np.vecdot(apart, apart))
        if not (runs.all() or (runs.astype(bool) | keeps).all()):
            raise SimulationError("two points of a line have come together")
        if not self._is_kept:
            return runs, apart / runs[:, None]
        turning = apart / np.where(keeps, 1.0, runs)[:, None]
        return np.where(keeps, np.vecdot(apart, self._kept), runs), np.where(keeps[:, None], self._kept, turning)

    def bends(self, data: Any, v: Array, pieces: Pieces) -> Array:  # noqa: ANN401 - MuJoCo's
        """Return the second derivatives of the lengths at q̈ = 0, m/s²."""
        places, runs, ways, moved = pieces
        parting = moved @ v
        along = np.vecdot(ways, parting)
        turning = (np.vecdot(parting, parting) - along * along) / np.where(self._keeps, 1.0, runs)
        found = np.where(self._keeps, 0.0, turning)
        if not self._straight:
            for number, carrier in enumerate(self._carriers):
                if carrier:
                    mujoco.mj_jacDot(self._model, data, self._dots[number], None, places[number], carrier)
            biases = self._dots @ v
            found += np.vecdot(ways, biases.take(self._last, axis=0) - biases.take(self._first, axis=0))
        return self._summed(found)

    def _summed(self, parts: Array) -> Array:
        """Return, for each line, the sum of the values of its segments."""
        return parts if self._single else self._owned @ parts

    def _moved(self, data: Any, places: Array) -> Array:  # noqa: ANN401 - MuJoCo's
        """Return the Jacobian of the separation of each segment's ends, (pieces, 3, joints)."""
        if self._apart is not None:
            return self._apart
        for number, carrier in enumerate(self._carriers):
            if carrier:
                mujoco.mj_jac(self._model, data, self._jacobians[number], None, places[number], carrier)
        moved = self._jacobians.take(self._last, axis=0) - self._jacobians.take(self._first, axis=0)
        self._apart = moved if self._straight else None
        return moved


class Pulls:
    """The lines whose tension is a function of length and rate: springs and prescribed pulls."""

    def __init__(self, lines: Lines) -> None:
        """Store the force laws as arrays."""
        self._lines = lines
        laws = [line.law for line in lines.lines]
        self._given, self._stiffness, self._natural, self._damping = (
            np.array([getattr(law, name, 0.0) for law in laws]) for name in ("force", "stiffness", "length", "damping")
        )
        self._damps = bool(self._damping.any())

    def load(self, data: Any, q: Array, v: Array, idle: list[Line]) -> Array:  # noqa: ANN401 - MuJoCo's
        """Return the load on the joints, (joints,), of all lines except `idle` ones."""
        values, gradients, _ = self._lines.lengths(data, q)
        tension = self._given + self._stiffness * (values - self._natural)
        if self._damps:
            tension += self._damping * (gradients @ v)
        if idle:
            tension *= [line not in idle for line in self._lines.lines]
        return np.asarray(-tension @ gradients, dtype=np.float64)
