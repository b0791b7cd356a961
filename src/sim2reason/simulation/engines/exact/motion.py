"""A motion as the exact engine finds it: pieces of constant acceleration between events."""

from dataclasses import dataclass

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.simulation.engines.exact.contact_modes import Mode
from sim2reason.simulation.engines.exact.linear import Row
from sim2reason.simulation.trace import Event


@dataclass(frozen=True, slots=True)
class Segment:
    """From `start` on: q + vτ + aτ²/2, with constant multipliers (NaN where they are not determined)."""

    start: float  # s
    q: Row  # (n,), at the start of the segment
    v: Row
    a: Row
    tension: Row  # by string, N
    normal: Row  # by contact, N
    friction: Row  # by contact, N
    mode: Mode  # of all strings and all rough contacts


@dataclass(frozen=True)
class Motion:
    """Segments in order of time, the events between them, and where and why it ends."""

    mechanism: Mechanism
    segments: tuple[Segment, ...]
    events: tuple[Event, ...]
    end: float  # s
    cut: str = ""  # the kind of the event that ended it early

    def state(self, times: Array) -> State:
        """The motion at any times ≥ 0, s, shape (m,); after the end the last segment just goes on."""
        segments = self.segments
        starts = np.array([segment.start for segment in segments])
        at = np.maximum(np.searchsorted(starts, times, side="right") - 1, 0)
        n = len(self.mechanism.coordinates)
        table = np.array([(*s.q, *s.v, *s.a, *s.tension, *s.normal, *s.friction) for s in segments])[at]
        q0, v0, a = table[:, :n], table[:, n : 2 * n], table[:, 2 * n : 3 * n]
        since = (times - starts[at])[:, None]
        forces = table[:, 3 * n :].T
        contacts = list(self.mechanism.contacts)
        k, c = len(self.mechanism.strings), len(contacts)
        tension = {string.name: forces[i] for i, string in enumerate(self.mechanism.strings)}
        tension |= {pull.name: np.full(len(times), pull.force) for pull in self.mechanism.pulls}
        return State(
            mechanism=self.mechanism,
            times=times,
            q=q0 + since * (v0 + 0.5 * since * a),
            v=v0 + since * a,
            a=a,
            tension=tension,
            normal=dict(zip(contacts, forces[k : k + c], strict=True)),
            friction=dict(zip(contacts, forces[k + c :], strict=True)),
        )
