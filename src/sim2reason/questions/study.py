"""The recorded motion of a scene and its variants, and directions of motion."""

from collections.abc import Callable, Hashable, Mapping
from typing import Protocol, Self

import numpy as np

from sim2reason.base.records import Memo
from sim2reason.errors import SceneError, SimulationError, UnsupportedError
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.certify import RECORDED
from sim2reason.simulation.trace import DEFAULT_STEP_RTOL, ENGINES, Trace

MIN_VARIANT_FRACTION = 1e-2  # of a motion: least duration of its variants
EXACT_STEP_ERROR = 1e-8  # relative: error of integration steps if answers are compared for equality
COARSE_STEP_ERROR = 1e-6  # relative: error of integration steps if only clear differences of answers matter
TIME_MARGIN = 1.1  # factor on the time of the moment: duration of variants and of the second engine's motion


Change = Callable[[Mechanism], Mechanism]
"""Of a mechanism, for any scene of the kind."""
VariantParts = tuple[Scene, Mechanism, Change | None]
"""A scene, what moves in it, and how that was changed, if it was."""


class Timed(Hashable, Protocol):
    """The protocol of moments: hashable objects with a time in a motion."""

    def time(self, trace: Trace) -> float | None:
        """Return the time, s; None if the moment does not occur."""
        ...


class SimulatedScene(Memo):
    """A scene with its motion, shared by all questions and filters, with cached derived results."""

    def __init__(self, scene: Scene, trace: Trace, change: Change | None = None) -> None:
        """Wrap a scene and its recorded motion: that of its mechanism, as altered by `change` if one is given."""
        self.scene, self.trace, self.change = scene, trace, change
        self._times: dict[Timed, float | None] = {}
        self._variants: dict[object, tuple[SimulatedScene | None, float]] = {}  # and until when they are known
        self._shorter: dict[
            tuple[object, float], SimulatedScene
        ] = {}  # variants that are known for longer than is asked
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
        """Return the mechanism of the motion."""
        return self.trace.mechanism

    def time(self, moment: Timed) -> float | None:
        """Return the time of a moment, s; None if it does not occur in the simulated motion."""
        try:
            return self._times[moment]
        except KeyError:
            found = self._times[moment] = moment.time(self.trace)
            return found

    def release(self) -> None:
        """Discard all cached results, of variants too, which refer back to the scene and so keep it in memory.

        Otherwise the garbage collector must find them, which takes 4 % of the time of an item.
        """
        variants = [variant for variant, _ in self._variants.values()]
        self._variants.clear()
        variants += self._shorter.values()
        self._shorter.clear()
        self.forget()
        for variant in variants:
            if variant is not None:
                variant.release()

    def variant(
        self, scene: Scene, until: float | None = None, error: float = COARSE_STEP_ERROR
    ) -> "SimulatedScene | None":
        """Return a changed scene with its motion until a time, s, by default as long as this; None if simulation fails.

        `error` is the relative error allowed in an integration step.
        """
        return self._simulate_variant((scene, error), lambda: (scene, scene.mechanism, None), until, error)

    def with_values(self, values: Mapping[str, float], until: float | None = None) -> "SimulatedScene | None":
        """Return the scene with other values at addresses, and its motion until a time, s; None if either fails."""
        key = tuple(values.items())
        scene = self._having(key)
        if scene is None:
            return None
        return self._simulate_variant(("values", key), lambda: (scene, scene.mechanism, None), until)

    def with_same_change(self, values: Mapping[str, float]) -> "SimulatedScene | None":
        """Return the motion with other values, with the same change of the mechanism, duration and accuracy.

        None if there is no such motion.
        """
        key = tuple(values.items())
        scene = self._having(key)
        if scene is None:
            return None
        change, error = self.change, self.trace.tolerance or DEFAULT_STEP_RTOL

        def make() -> VariantParts:
            return scene, scene.mechanism if change is None else change(scene.mechanism), change

        return self._simulate_variant(("likewise", key), make, None, error)

    def _having(self, values: tuple[tuple[str, float], ...]) -> Scene | None:
        """Return the scene with other values at some addresses, cached; None if the values are invalid."""
        if values not in self._scenes:
            try:
                self._scenes[values] = self.scene.having_all(dict(values))
            except (SceneError, ValueError):
                self._scenes[values] = None
        return self._scenes[values]

    def changed(self, name: Hashable, change: Change, until: float | None = None) -> "SimulatedScene | None":
        """Return the motion of the changed mechanism, cached under the change's `name`; None if simulation fails."""
        combined_change = change if self.change is None else _one_after(self.change, change)
        return self._simulate_variant(name, lambda: (self.scene, change(self.mechanism), combined_change), until)

    def _simulate_variant(
        self,
        key: object,
        make: Callable[[], VariantParts],
        until: float | None,
        error: float = COARSE_STEP_ERROR,
    ) -> "SimulatedScene | None":
        end = float(self.trace.state.times[-1])
        until = end if until is None else min(max(until, MIN_VARIANT_FRACTION * end), end)
        known, reaches = self._variants.get(key, (None, -1.0))
        if reaches < until or (known is None and reaches > until):
            reaches = until if reaches < 0.0 or reaches > until else end  # who asks again will ask once more
            try:
                known = _made(make(), reaches, error)
            except (SceneError, SimulationError, UnsupportedError):
                known = None
            self._variants[key] = known, reaches
        return known if known is None or reaches == until else self._truncate(key, known, until)

    def _truncate(self, key: object, known: "SimulatedScene", until: float) -> "SimulatedScene":
        """Return a variant truncated to a time, s, so that results do not depend on the order of queries."""
        if (key, until) not in self._shorter:
            self._shorter[key, until] = SimulatedScene(known.scene, known.trace.until(until), known.change)
        return self._shorter[key, until]


def _one_after(first: Change, then: Change) -> Change:
    return lambda mechanism: then(first(mechanism))


def _made(made: VariantParts, until: float, error: float) -> SimulatedScene | None:
    scene, mechanism, change = made
    if not mechanism.coordinates:
        return None
    return SimulatedScene(scene, ENGINES[RECORDED](mechanism, np.array([0.0, until]), error), change)


REVERSAL_SPEED_RTOL = 1e-6  # of the mean speed: a slower coordinate is reversing
CHANGE_RTOL = 1e-9  # of the largest change: smaller changes are zero


def change_directions(study: SimulatedScene, time: float) -> tuple[float, ...]:
    """Return the signs of all coordinates' changes by a time, s (of trends at 0), then whether each reverses then.

    Between motions with different results a magnitude passes through zero, or a swing becomes a full turn.
    """
    start, end = study.trace.at(0.0), study.trace.at(time)
    changes = end.q[0] - start.q[0] if time else start.a[0]
    largest = np.abs(changes).max()
    turns = np.abs(end.v[0]) * time <= REVERSAL_SPEED_RTOL * largest if time else np.zeros(len(changes), dtype=bool)
    return (*np.sign(np.where(np.abs(changes) > CHANGE_RTOL * largest, changes, 0.0)).tolist(), *turns.tolist())
