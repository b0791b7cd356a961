"""What springs and drawn strings pull with, all at once: the load that they put on the joints."""

from itertools import pairwise
from typing import Any

import numpy as np

from sim2reason.dsl.mechanism import Line
from sim2reason.dsl.state import Array
from sim2reason.errors import SimulationError
from sim2reason.simulation.engines.mujoco.specification import mujoco


class Pulls:
    """The lines whose tension follows from their length and its rate, as arrays over their straight pieces."""

    def __init__(
        self,
        lines: tuple[Line, ...],
        sites: dict[str, int],
        index: dict[str, int],
        model: Any,  # noqa: ANN401 - MuJoCo's
        *,
        straight: bool,
    ) -> None:
        """`sites` and `index` number the sites and joints of the compiled `model`; `straight`: nothing turns."""
        self.lines = [line for line in lines if not line.law.row]
        names = sorted({name for line in self.lines for name in line.through})
        place = {name: number for number, name in enumerate(names)}
        pieces = [(owner, piece) for owner, line in enumerate(self.lines) for piece in pairwise(line.through)]
        self._model = model
        self._sites = [sites[name] for name in names]
        self._carriers = [int(model.site_bodyid[site]) for site in self._sites]
        self._first = np.array([place[first] for _, (first, _) in pieces], dtype=np.intp)
        self._last = np.array([place[last] for _, (_, last) in pieces], dtype=np.intp)
        self._owned, self._wound = np.zeros((len(self.lines), len(pieces))), np.zeros((len(self.lines), int(model.nv)))
        for number, (owner, _) in enumerate(pieces):
            self._owned[owner, number] = 1.0
        for owner, line in enumerate(self.lines):
            for wheel in line.wheels:
                self._wound[owner, index[wheel.coordinate]] += wheel.radius
        laws = [line.law for line in self.lines]
        self._given, self._stiffness, self._natural, self._damping = (
            np.array([getattr(law, name, 0.0) for law in laws]) for name in ("force", "stiffness", "length", "damping")
        )
        self._straight = straight
        self._apart: Array | None = None  # how the Jacobians of the ends of each piece differ
        self._jacobians = np.zeros((len(names), 3, int(model.nv)))

    def load(self, data: Any, q: Array, v: Array, idle: list[Line]) -> Array:  # noqa: ANN401 - MuJoCo's
        """The load on the joints, (joints,), of all lines but those that are `idle`."""
        places = data.site_xpos[self._sites]
        apart = places[self._last] - places[self._first]
        lengths = np.sqrt(np.einsum("ij,ij->i", apart, apart))
        if not lengths.all():
            raise SimulationError("two points of a line have come together")
        runs = np.einsum("ij,ijk->ik", apart / lengths[:, None], self._moved(data, places))
        gradients = self._owned @ runs + self._wound
        stretch = self._owned @ lengths + self._wound @ q - self._natural
        tension = self._given + self._stiffness * stretch + self._damping * (gradients @ v)
        if idle:
            tension = tension * np.array([line not in idle for line in self.lines])
        return np.asarray(-tension @ gradients, dtype=np.float64)

    def _moved(self, data: Any, places: Array) -> Array:  # noqa: ANN401 - MuJoCo's
        """How the ends of each piece move apart, (pieces, 3, joints); always the same where nothing turns."""
        if self._apart is not None:
            return self._apart
        for number, carrier in enumerate(self._carriers):
            if carrier:
                mujoco.mj_jac(self._model, data, self._jacobians[number], None, places[number], carrier)
        moved = self._jacobians[self._last] - self._jacobians[self._first]
        self._apart = moved if self._straight else None
        return moved
