"""The exact engine's loop: forces, the next event, impacts, and again."""

from math import inf

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import Array
from sim2reason.errors import SimulationError
from sim2reason.simulation.engines.exact.balance import Balance, balance
from sim2reason.simulation.engines.exact.contact_modes import Mode, NoForcesError
from sim2reason.simulation.engines.exact.equations import TOUCHING, Equations, Pair, equations
from sim2reason.simulation.engines.exact.events import STILL, Approach, approach, crossing, stop
from sim2reason.simulation.engines.exact.impulses import strike
from sim2reason.simulation.engines.exact.linear import Row
from sim2reason.simulation.engines.exact.motion import Motion, Segment
from sim2reason.simulation.trace import ENGINES, Event, Trace

SEGMENTS = 500
CROWD = 5e-3  # s; a body that is hit again, or a string that jerks again, sooner has too much happen at once
TIE = 1e-11  # s; events that are no further apart are simultaneous
REST = 1e-11  # m/s or rad/s; what rounding leaves of a speed that is zero
ORDER = ("collision", "taut", "slack", "stick", "slip", "turn", "reach", "limit", "lift", "crowd", "indeterminate")


@ENGINES.register("exact")
def simulate(mechanism: Mechanism, times: Array) -> Trace:
    """The motion at `times` (m,), in seconds, increasing from 0.

    Raises:
        UnsupportedError: the mechanism has a part that this engine does not model.
        SimulationError: no consistent forces, or more than 500 events.
    """
    found = motion(mechanism, float(times[-1]))
    return Trace("exact", found.state(times), found.events, found.end, found.cut, found.state)


def motion(mechanism: Mechanism, duration: float) -> Motion:
    """The motion from 0 to `duration` seconds, or to the event that ends it; raises as `simulate` does."""
    run = _Run(equations(mechanism), duration)
    try:
        while run.step():
            if len(run.segments) > SEGMENTS:
                raise SimulationError(f"more than {SEGMENTS} events before {duration:g} s; simulate a shorter time")
    except NoForcesError as error:
        rough = ", ".join(name for name, contact in mechanism.contacts.items() if contact.friction > 0.0)
        remedy = f"; friction may be too strong on {rough}" if rough else ""
        raise SimulationError(f"{error} at {run.now:.6g} s{remedy}") from error
    return run.finish()


class _Run:
    """A motion in the making: the present state and what is behind it."""

    def __init__(self, system: Equations, duration: float) -> None:
        self.system, self.duration = system, duration
        self.now = 0.0
        self.q: Row = [0.0] * len(system.force)
        self.v: Row = [float(coordinate.speed) for coordinate in system.mechanism.coordinates]
        self.mode = Mode((True,) * len(system.strings), (0,) * len(system.grips))
        self.segments: list[Segment] = []
        self.events: list[Event] = []
        self.hits: dict[str, tuple[float, tuple[str, ...]]] = {}  # the last hit of each body
        self.jerks: dict[int, tuple[float, tuple[str, ...]]] = {}  # the last jerk of each string
        self.cut = ""

    def finish(self) -> Motion:
        """What was found."""
        if not self.segments:  # an impact at the start ended it
            self._append(balance(self.system, self.v, [], Mode((), self.mode.rubbing)))
        events = sorted(self.events, key=lambda event: (event.time, ORDER.index(event.kind)))
        return Motion(self.system.mechanism, tuple(self.segments), tuple(events), self.now, self.cut)

    def step(self) -> bool:
        """Settle the present instant and go on to the next event; False when there is nothing more to do."""
        self.v = [0.0 if abs(speed) < REST else speed for speed in self.v]
        snapped = self._impact()
        if snapped is None:
            return False
        found = self._settle(snapped)
        if found is None:
            return False
        return self._advance(found)

    # -- impacts ---------------------------------------------------------------------------------

    def _impact(self) -> set[int] | None:
        """Let what collides bounce and what snaps taut jerk; the strings that snapped, or None at the end."""
        full = [number for number in range(len(self.system.strings)) if self._spare(number) <= TOUCHING]
        snapped = {number for number in full if self.system.strings[number].rate(self.v) > STILL}
        touching = [(pair, near) for pair, near in self._approaches() if near.touching]
        hits = [pair for pair, near in touching if near.rate < -STILL]
        if not snapped and not hits:
            return snapped
        if self._crowded(hits, snapped):
            return None
        found = strike(self.system, self.v, full, touching, list(self.mode.acting))
        self.v = [0.0 if abs(speed) < REST else speed for speed in found.v]
        self._rest(found.rubbing)
        for pair in hits:
            self._record("collision", *pair.names)
            self.hits |= dict.fromkeys(pair.movable, (self.now, pair.names))
        for number in snapped:
            self.jerks[number] = (self.now, (self.system.mechanism.strings[number].name,))
        if found.lifted:
            for number in sorted(snapped):
                self._record("taut", self.system.mechanism.strings[number].name)
            self._lift(found.lifted)
            return None
        return snapped

    def _rest(self, rubbing: tuple[int, ...]) -> None:
        for grip, side in zip(self.system.grips, rubbing, strict=True):
            if side == 0:
                self.v[grip.coordinate] = 0.0

    def _crowded(self, hits: list[Pair], snapped: set[int]) -> bool:
        """End at the earlier hit if a body is hit again too soon, or a string jerks again: two can do so by turns."""
        recent = [self.hits[name] for pair in hits for name in pair.movable if name in self.hits]
        recent += [self.jerks[number] for number in snapped if number in self.jerks]
        early = min((hit for hit in recent if TIE < self.now - hit[0] < CROWD), default=None)
        if early is None:
            return False
        self.now = early[0]
        self.events = [event for event in self.events if event.time <= self.now]
        self.segments = [segment for segment in self.segments if segment.start <= self.now]
        self._end("crowd", *early[1])
        return True

    # -- forces ----------------------------------------------------------------------------------

    def _settle(self, snapped: set[int]) -> Balance | None:
        """Find the forces and note what changed; None at the end."""
        system, before = self.system, self.mode
        tight = [
            number
            for number, string in enumerate(system.strings)
            if self._spare(number) <= TOUCHING and abs(string.rate(self.v)) <= STILL
        ]
        acting = tuple(acts or number in snapped for number, acts in enumerate(before.acting))
        still = tuple(0 if self._stopped(number) else side for number, side in enumerate(before.rubbing))
        found = balance(system, self.v, tight, Mode(acting, still))
        pressing = next((pair for pair, near in self._approaches(found.a) if self._pressed(near)), None)
        ended = bool(found.lifted) or found.loose or pressing is not None
        if self.segments or snapped:
            # which strings are slack about a part that nothing holds is as open as how it moves
            self._note_changes(
                before, found.mode._replace(acting=before.acting) if found.loose else found.mode, snapped
            )
        if not ended or not self.segments:
            self._append(found)
        self.mode = found.mode
        if not ended:
            return found
        if found.lifted:
            self._lift(found.lifted)
        elif found.loose:
            self._end("indeterminate", *self._unheld())
        elif pressing is not None:
            self._end("crowd", *pressing.names)
        return None

    def _stopped(self, number: int) -> bool:
        """Whether a contact that was sliding has just come to rest: it then tries to stick."""
        grip = self.system.grips[number]
        return bool(self.segments) and self.v[grip.coordinate] == 0.0

    @staticmethod
    def _pressed(near: Approach) -> bool:
        """Whether two bodies that rest against each other are pressed together: hits without number."""
        return near.touching and abs(near.rate) <= STILL and near.second < -STILL

    def _append(self, found: Balance) -> None:
        segment = Segment(self.now, self.q, self.v, found.a, found.tension, found.normal, found.friction, found.mode)
        self.segments.append(segment)

    def _note_changes(self, before: Mode, after: Mode, snapped: set[int]) -> None:
        mechanism, first = self.system.mechanism, not self.segments
        for number, string in enumerate(mechanism.strings):
            if number in snapped or (after.acting[number] and not before.acting[number]):
                self._record("taut", string.name)
            elif before.acting[number] and not after.acting[number] and not first:
                self._record("slack", string.name)
        names = list(mechanism.contacts)
        for grip, was, now in zip(self.system.grips, before.rubbing, after.rubbing, strict=True):
            if was != now and not first:
                self._record("slip" if now else "stick", names[grip.contact])

    # -- the next event --------------------------------------------------------------------------

    def _advance(self, found: Balance) -> bool:
        """Go to the next event; False at the end."""
        change, (finish, last) = self._change(found), self._finish(found.a)
        left = self.duration - self.now
        span = min(change, finish, left)
        self._note_turns(found, span)
        self.q = [q + span * (v + 0.5 * span * a) for q, v, a in zip(self.q, self.v, found.a, strict=True)]
        self.v = [v + span * a for v, a in zip(self.v, found.a, strict=True)]
        if finish <= min(change + TIE, left):
            self.now += finish
            for kind, subjects in last:
                self._end(kind, *subjects)
            return False
        if change >= left:
            self.now = self.duration
            return False
        self.now += span
        for number, grip in enumerate(self.system.grips):
            if found.mode.rubbing[number] and abs(self.v[grip.coordinate]) < STILL:
                self.v[grip.coordinate] = 0.0
        return True

    def _change(self, found: Balance) -> float:
        """The time until the mode changes: a hit, a string at full length, a contact that stops sliding."""
        soonest = inf
        for number, string in enumerate(self.system.strings):
            if not found.mode.acting[number]:
                spare, rate = self._spare(number), -string.rate(self.v)
                if spare > TOUCHING or abs(rate) > STILL:
                    soonest = min(soonest, crossing(spare, rate, -string.rate(found.a)))
        for grip in self.system.grips:
            soonest = min(soonest, stop(self.v[grip.coordinate], found.a[grip.coordinate]))
        for _, near in self._approaches(found.a):
            soonest = min(soonest, near.hit())
        return soonest

    def _finish(self, a: Row) -> tuple[float, list[tuple[str, tuple[str, ...]]]]:
        """The time until the description ends, and the events that end it."""
        found: list[tuple[float, str, tuple[str, ...]]] = []
        for run in self.system.runs:
            gradient = run.gradient
            time = crossing(run.length + gradient.rate(self.q), gradient.rate(self.v), gradient.rate(a))
            found.append((time, "reach", run.sites))
        for limit in self.system.limits:
            k, sign = limit.coordinate, limit.sign
            time = crossing(limit.room + sign * self.q[k], sign * self.v[k], sign * a[k])
            found.append((time, "limit", (limit.name,)))
        soonest = min((time for time, _, _ in found), default=inf)
        return soonest, [(kind, subjects) for time, kind, subjects in found if time <= soonest + TIE]

    def _note_turns(self, found: Balance, span: float) -> None:
        """Speeds that pass through zero before the next event; of a rough contact that is a change of mode."""
        rough = {grip.coordinate for grip in self.system.grips}
        for number, coordinate in enumerate(self.system.mechanism.coordinates):
            time = stop(self.v[number], found.a[number])
            if number not in rough and TIE < time < span - TIE:
                self.events.append(Event(self.now + time, "turn", (coordinate.name,)))

    # -- small things ----------------------------------------------------------------------------

    def _spare(self, number: int) -> float:
        """How much a string may still lengthen, m."""
        return self.system.slack[number] - self.system.strings[number].rate(self.q)

    def _approaches(self, a: Row | None = None) -> list[tuple[Pair, Approach]]:
        a = a or [0.0] * len(self.q)
        return [(pair, approach(pair, self.q, self.v, a)) for pair in self.system.pairs]

    def _unheld(self) -> tuple[str, ...]:
        """The massless bodies that may be the ones which nothing holds."""
        moving = {number for motion in self.system.weightless for number, part in enumerate(motion) if part}
        names = [c.name for number, c in enumerate(self.system.mechanism.coordinates) if number in moving]
        return tuple(names)

    def _lift(self, contacts: tuple[int, ...]) -> None:
        names = list(self.system.mechanism.contacts)
        for number in contacts:
            self._end("lift", names[number])

    def _record(self, kind: str, *subjects: str) -> None:
        self.events.append(Event(self.now, kind, subjects))

    def _end(self, kind: str, *subjects: str) -> None:
        self._record(kind, *subjects)
        self.cut = self.cut or kind
