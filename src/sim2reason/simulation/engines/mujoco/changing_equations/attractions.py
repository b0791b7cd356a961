"""Attraction between bodies, computed for all pairs at once as loads on the joints."""

from typing import Any

import numpy as np

from sim2reason.errors import SimulationError
from sim2reason.scenes.dsl.mechanism import Attraction
from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.engines.mujoco.specification import mujoco

MIN_CLOSENESS = 1e-4  # smallest closeness; below, round-off dominates the step error


class Attractions:
    """All attracting pairs of bodies, as arrays."""

    def __init__(
        self,
        pairs: tuple[Attraction, ...],
        bodies: dict[str, int],
        model: Any,  # noqa: ANN401 - MuJoCo's
        *,
        straight: bool,
    ) -> None:
        """Index the pairs by `bodies` in the compiled `model`; `straight` means that no joint rotates."""
        self._pairs, self._model, self._straight = pairs, model, straight
        self._first = np.array([bodies[pair.a] for pair in pairs], dtype=np.intp)
        self._last = np.array([bodies[pair.b] for pair in pairs], dtype=np.intp)
        self._constants = np.array([pair.constant for pair in pairs])
        self._exponents = np.array([-0.5 * (pair.power + 1.0) for pair in pairs])
        self._bodies = sorted({*self._first.tolist(), *self._last.tolist()})
        self._jacobians = np.zeros((int(model.nbody), 3, int(model.nv)))
        self._apart: Array | None = None  # how the Jacobians of each pair differ, where nothing turns
        self._began = self._at_the_start() if pairs else np.zeros(0)

    def closeness(self, data: Any) -> float:  # noqa: ANN401 - MuJoCo's
        """Return the smallest ratio of a pair's present to initial distance, at most 1, to scale the step tolerance.

        When two bodies pass closely, a small error of their positions is a large part of their distance, which
        determines their deflection.
        """
        squares = self._squares(data)[1]
        return max(MIN_CLOSENESS, min(1.0, float(np.sqrt((squares / self._began).min()))))

    def _at_the_start(self) -> Array:
        """Return the squared distances of the pairs at the start, (pairs,), m²."""
        data = mujoco.MjData(self._model)
        mujoco.mj_fwdPosition(self._model, data)
        return self._squares(data)[1]

    def _squares(self, data: Any) -> tuple[Array, Array]:  # noqa: ANN401 - MuJoCo's
        """Return the separation of the centres of mass of each pair, (pairs, 3), m, and its square, (pairs,), m²."""
        places = data.xipos
        apart: Array = places.take(self._last, axis=0) - places.take(self._first, axis=0)
        return apart, np.vecdot(apart, apart)

    def load(self, data: Any) -> Array:  # noqa: ANN401 - MuJoCo's
        """Return the load on the joints, (joints,): constant·m·m′/rᵖ between centres of mass, for present masses."""
        apart, squares = self._squares(data)
        if not squares.all():
            pair = self._pairs[int(squares.argmin())]
            raise SimulationError(f"{pair.a} and {pair.b} are at one place")
        masses = self._model.body_mass
        pulls = self._constants * masses[self._first] * masses[self._last] * squares**self._exponents
        return (pulls[:, None] * apart).ravel() @ self._moved(data)

    def _moved(self, data: Any) -> Array:  # noqa: ANN401 - MuJoCo's
        """Return the Jacobian of the separation of each pair, (3·pairs, joints)."""
        if self._apart is not None:
            return self._apart
        for body in self._bodies:
            mujoco.mj_jacBodyCom(self._model, data, self._jacobians[body], None, body)
        moved = (self._jacobians[self._first] - self._jacobians[self._last]).reshape(-1, self._jacobians.shape[2])
        self._apart = moved if self._straight else None
        return moved
