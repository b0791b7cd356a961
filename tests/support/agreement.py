"""Comparison of the exact engine with independently computed motions."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
import pytest

from lagrangian.follow import Array, Phase, Record, follow
from sim2reason.scenes.dsl.builder import Frame
from sim2reason.scenes.dsl.mechanism import Mechanism, X, Z
from sim2reason.scenes.dsl.state import State
from sim2reason.scenes.dsl.vectors import Tensor, Vector
from sim2reason.simulation.certify import certify
from sim2reason.simulation.trace import Event

CLOSE = 1e-7  # what the engine may differ by, of a column's largest value; events, of the duration
SELF = 1e-9  # what the reference may differ by when its steps are halved
SLIGHT = 1e-3  # a column that never exceeds this is compared as it is
Columns = Callable[[State], Sequence[Array]]


@dataclass(frozen=True)
class Measured:
    """Greatest differences found by one test."""

    name: str
    columns: float
    events: float
    happened: int
    own: float  # of the reference from itself


MEASURED = pytest.StashKey[list[Measured]]()


def relative(found: Array, wanted: Array) -> float:
    """Return the greatest difference, relative to the greatest value of each column."""
    return float((np.abs(found - wanted).max(axis=0) / np.maximum(np.abs(wanted).max(axis=0), SLIGHT)).max())


class Agreement:
    """Callable that compares an exact motion with a reference."""

    def __init__(self, request: pytest.FixtureRequest) -> None:
        self._request = request

    def __call__(
        self,
        mechanism: Mechanism,
        reference: tuple[Phase, Sequence[float]],
        times: Array,
        columns: Columns,
        events: dict[str, str] | None = None,
        substeps: int = 2,
    ) -> Record:
        """Assert that the motions agree, and return the record of the reference.

        `events` maps the engine's kinds of event to the reference's names for them, separated by bars.
        """
        phase, start = reference
        record, finer = (follow(phase, start, times, n) for n in (substeps, 2 * substeps))
        own = relative(record.array, finer.array)
        assert own <= SELF, f"the reference is off by {own:.1e} itself"
        trace, certificate = certify(mechanism, times)
        assert certificate.reason == trace.cut, certificate.reason
        found = np.stack(columns(trace.sample(np.array(record.times))), axis=1)
        worst = relative(found, record.array)
        apart = self._events(trace.events, record.events, events or {}) / float(times[-1])
        note = Measured(self._request.node.nodeid.rpartition("::")[2], worst, apart, len(record.events), own)
        self._request.config.stash.setdefault(MEASURED, []).append(note)
        assert worst <= CLOSE, np.abs(found - record.array).max(axis=0)
        assert apart <= CLOSE
        return record

    def _events(self, found: Sequence[Event], wanted: Sequence[tuple[float, str]], names: dict[str, str]) -> float:
        """Return the greatest difference in s between the times of corresponding events."""
        told = [event for event in found if event.kind in names]
        assert len(told) == len(wanted), (told, wanted)
        for event, (_, name) in zip(told, wanted, strict=True):
            assert name.split()[0] in names[event.kind].split("|"), (told, wanted)
        return max((abs(event.time - time) for event, (time, _) in zip(told, wanted, strict=True)), default=0.0)


def about_y(moment: float) -> Tensor:
    """Return the inertia tensor of a body for which only the moment about y matters."""
    return (moment, moment, moment, 0.0, 0.0, 0.0)


def axis(state: State, name: str, start: float = 0.0, sign: float = 1.0) -> Array:
    return start + sign * state.q[:, state.mechanism.number[name]]


def rate(state: State, name: str, sign: float = 1.0) -> Array:
    return sign * state.v[:, state.mechanism.number[name]]


def plane_body(frame: Frame, name: str, mass: float, at: Vector, speed: tuple[float, float] = (0.0, 0.0)) -> Frame:
    """Build a particle that moves freely in the plane, with a hook."""
    made = frame.body(name, mass, at=at).slide(X, speed[0], name="x").slide(Z, speed[1], name="z")
    return made.site(f"{name}.hook")


def in_plane(state: State, name: str, at: Vector) -> list[Array]:
    return [axis(state, f"{name}.x", at[0]), axis(state, f"{name}.z", at[2])]


def speeds(state: State, name: str) -> list[Array]:
    return [rate(state, f"{name}.x"), rate(state, f"{name}.z")]
