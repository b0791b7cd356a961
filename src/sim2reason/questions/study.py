"""Recorded motion of a scene and of scenes like it, and the directions of motion."""

from collections.abc import Callable, Hashable, Mapping
from typing import Protocol, Self

import numpy as np

from sim2reason.base.lazy import Memo
from sim2reason.errors import SceneError, SimulationError, UnsupportedError
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.certify import RECORDED
from sim2reason.simulation.trace import ENGINES, FINEST, Trace

SHORTEST = 1e-2  # of a motion: no variant of it is followed for less
ENOUGH = 1e-8  # relative: what a step may err by in a motion whose answers are equal to this one's, or are not
COARSE = 1e-6  # relative: or in one that matters only by how much its answers differ, or where they clearly do
BEYOND = 1.1  # times the moment that is asked about, to which variants and the witness follow a motion


Change = Callable[[Mechanism], Mechanism]
"""Of a mechanism, for any scene of the kind."""
Made = tuple[Scene, Mechanism, Change | None]
"""A scene, what moves in it, and how that was changed, if it was."""


class Timed(Hashable, Protocol):
    """What comes at some time of a motion."""

    def time(self, trace: Trace) -> float | None:
        """Return when it comes, s; None if it does not."""
        ...


class Study(Memo):
    """A scene with its motion, which all questions and filters about it share; nothing is worked out twice."""

    def __init__(self, scene: Scene, trace: Trace, change: Change | None = None) -> None:
        """`trace` is the motion of `scene`, as the recorded engine has it, or of its mechanism after a `change`."""
        self.scene, self.trace, self.change = scene, trace, change
        self._times: dict[Timed, float | None] = {}
        self._variants: dict[object, tuple[Study | None, float]] = {}  # and until when they are known
        self._shorter: dict[tuple[object, float], Study] = {}  # variants that are known for longer than is asked
        self._scenes: dict[tuple[tuple[str, float], ...], Scene | None] = {}

    @classmethod
    def of(cls, scene: Scene, times: Array) -> Self:
        """Return a scene and its motion, recorded at `times` (n,), s.

        Raises:
            SceneError, UnsupportedError, SimulationError: the scene can not be built, modelled or solved.
        """
        return cls(scene, ENGINES[RECORDED](scene.mechanism, times))

    @property
    def mechanism(self) -> Mechanism:
        """Return what moves."""
        return self.trace.mechanism

    def time(self, moment: Timed) -> float | None:
        """Return when a moment comes, s; None if it does not come while the motion is described."""
        try:
            return self._times[moment]
        except KeyError:
            found = self._times[moment] = moment.time(self.trace)
            return found

    def variant(self, scene: Scene, until: float | None = None, error: float = COARSE) -> "Study | None":
        """A changed scene with its motion until a time, s, by default as long as this one's; None if there is none.

        `error` is what a step may err by, relative.
        """
        return self._followed((scene, error), lambda: (scene, scene.mechanism, None), until, error)

    def with_values(self, values: Mapping[str, float], until: float | None = None) -> "Study | None":
        """The motion with other values at some addresses of the scene, until a time, s; None if there is none."""
        scene = self._having(values)
        return None if scene is None else self.variant(scene, until)

    def likewise(self, values: Mapping[str, float]) -> "Study | None":
        """Return the motion with other values, changed as this one is and followed as far, to the same accuracy.

        None if there is none.
        """
        scene = self._having(values)
        if scene is None:
            return None
        change, error = self.change, self.trace.tolerance or FINEST

        def make() -> Made:
            return scene, scene.mechanism if change is None else change(scene.mechanism), change

        return self._followed(("likewise", tuple(values.items())), make, None, error)

    def _having(self, values: Mapping[str, float]) -> Scene | None:
        """Return the scene with other values, or None if there is none; several filters ask for the same ones."""
        key = tuple(values.items())
        if key not in self._scenes:
            try:
                self._scenes[key] = self.scene.having_all(values)
            except (SceneError, ValueError):
                self._scenes[key] = None
        return self._scenes[key]

    def changed(self, name: Hashable, change: Change, until: float | None = None) -> "Study | None":
        """The scene with its mechanism changed, and the motion of that; `name` is that of the change among all."""
        whole = change if self.change is None else _one_after(self.change, change)
        return self._followed(name, lambda: (self.scene, change(self.mechanism), whole), until)

    def _followed(
        self,
        key: object,
        make: Callable[[], Made],
        until: float | None,
        error: float = COARSE,
    ) -> "Study | None":
        end = float(self.trace.state.times[-1])
        until = end if until is None else min(max(until, SHORTEST * end), end)
        known, reaches = self._variants.get(key, (None, -1.0))
        if reaches < until or (known is None and reaches > until):
            reaches = until if reaches < 0.0 or reaches > until else end  # who asks again will ask once more
            try:
                known = _made(make(), reaches, error)
            except (SceneError, SimulationError, UnsupportedError):
                known = None
            self._variants[key] = known, reaches
        return known if known is None or reaches == until else self._cut(key, known, until)

    def _cut(self, key: object, known: "Study", until: float) -> "Study":
        """A variant as if nobody had asked to follow it any longer: what one question finds hangs on no other."""
        if (key, until) not in self._shorter:
            self._shorter[key, until] = Study(known.scene, known.trace.until(until), known.change)
        return self._shorter[key, until]


def _one_after(first: Change, then: Change) -> Change:
    return lambda mechanism: then(first(mechanism))


def _made(made: Made, until: float, error: float) -> Study | None:
    scene, mechanism, change = made
    if not mechanism.coordinates:
        return None
    return Study(scene, ENGINES[RECORDED](mechanism, np.array([0.0, until]), error), change)


TURNING = 1e-6  # of the mean speed: what is slower turns
STILL = 1e-9  # of the largest: a coordinate that has changed by less, or begins to, has not


def ways(study: Study, time: float) -> tuple[float, ...]:
    """Return which way each coordinate has changed by a time, or begins to, and whether it turns then.

    In between, a magnitude passes through zero, or a pendulum that turns becomes one that goes over the top, and
    between them takes for ever.
    """
    start, end = study.trace.at(0.0), study.trace.at(time)
    changes = end.q[0] - start.q[0] if time else start.a[0]
    largest = np.abs(changes).max()
    turns = np.abs(end.v[0]) * time <= TURNING * largest if time else np.zeros(len(changes), dtype=bool)
    return (*np.sign(np.where(np.abs(changes) > STILL * largest, changes, 0.0)).tolist(), *turns.tolist())
