"""Trials of an outcome: whether it comes about with another value of one number of the scene."""

from collections.abc import Iterable
from itertools import islice, pairwise

import numpy as np

from sim2reason.dsl.scene import Scene
from sim2reason.errors import SceneError, SimulationError, UnsupportedError
from sim2reason.questions.outcomes import PossibleOutcome
from sim2reason.questions.study import Study
from sim2reason.questions.unknown import range_of, usual_range
from sim2reason.simulation.certify import RECORDED
from sim2reason.simulation.trace import ENGINES

SAMPLES = 65
SPARSE = 16  # a first scan takes every sixteenth point: without a change there, none is looked for
LONGER = 7  # times that a motion is followed twice as long
EXACT, ROUGH = 1e-9, 1e-5  # relative: of closing in; where it only matters by how much it differs
CLOSE, WIDER, WIDEST = 0.02, 3.0, 5  # relative: how near a known change another one is looked for first; times; turns


class Trial:
    """Whether an outcome comes about, as a function of the number at an address of the scene."""

    def __init__(self, study: Study, outcome: PossibleOutcome, path: str, engine: str = RECORDED) -> None:
        """`study` is that of a scene in which that number has any value."""
        self._scene, self._outcome, self._path, self._engine = study.scene, outcome, path, engine
        self._known: dict[float, bool | None] = {}

    def __call__(self, value: float) -> bool | None:
        """Whether it does; None if there is no such motion."""
        if value not in self._known:
            try:
                self._known[value] = self._followed(self._scene.having(self._path, value))
            except (SceneError, SimulationError, UnsupportedError, ValueError):
                self._known[value] = None
        return self._known[value]

    def _followed(self, scene: Scene) -> bool | None:
        """Whether it does in one scene, which is followed for ever longer until that is clear."""
        duration = self._outcome.duration(scene)
        for _ in range(LONGER):
            times = np.linspace(0.0, duration, SAMPLES)
            found = self._outcome.happens(ENGINES[self._engine](scene.mechanism, times))
            if found is not None:
                return found
            duration *= 2.0
        return None

    def change(self, *, usual: bool = False) -> float | None:
        """Where the outcome changes, if it does so just once in the number's range; `usual`: near what is drawn."""
        values = range_of(self._scene, self._path)
        sparse = self._turns((*values[::SPARSE], values[-1]))
        if len(sparse) != 1 or (usual and not self._is_usual(*sparse[0])):
            return None
        turns = self._turns(values)
        if len(turns) != 1 or (usual and not self._is_usual(*turns[0])):
            return None
        return self.between(*turns[0])

    def _turns(self, values: Iterable[float]) -> list[tuple[float, float]]:
        """Between which neighbours among some values it changes; no more than two such pairs."""
        told = ((value, found) for value in values if (found := self(value)) is not None)
        return list(islice(((low, high) for (low, one), (high, other) in pairwise(told) if one != other), 2))

    def _is_usual(self, low: float, high: float) -> bool:
        """Whether any number between two is not far from those that are drawn."""
        least, most = usual_range(self._scene, self._path)
        return low <= most and high >= least

    def near(self, about: float) -> float | None:
        """Where it changes, looked for ever farther from a number: just there, if that is where it does."""
        for width in (EXACT, *(CLOSE * WIDER**turn for turn in range(WIDEST))):
            low, high = about / (1.0 + width), about * (1.0 + width)
            if {self(low), self(high)} == {True, False}:
                return about if width == EXACT else self.between(low, high, ROUGH)
        return None

    def between(self, low: float, high: float, exact: float = EXACT) -> float | None:
        """Where it changes between two numbers that differ in it, by halving; None if a motion is missing there."""
        below = self(low)
        while high - low > exact * abs(high):
            middle = 0.5 * (low + high)
            found = self(middle)
            if found is None:
                return None
            low, high = (middle, high) if found == below else (low, middle)
        return 0.5 * (low + high)
