"""The main loop of the MuJoCo engine: impacts, forces, and steps to the next event."""

from math import inf

import numpy as np

from sim2reason.errors import SimulationError, UnsupportedError
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.engines.mujoco.compiled_model import STEP, CompiledModel, Flags, Integers
from sim2reason.simulation.engines.mujoco.event_detection import REST_RATE, TOUCHING, EventDetector
from sim2reason.simulation.engines.mujoco.forces import (
    ContactMode,
    SettledForces,
    solve_forces,
    solve_impact,
    weightless,
)
from sim2reason.simulation.engines.mujoco.record import Recorder
from sim2reason.simulation.trace import EVENT_KINDS, Event, Trace

SEGMENTS = 500  # largest number of motion segments
STEPS = 100_000  # largest number of steps
CLOSER = 20  # times that a step is shortened to end at a contact
CROWD = 5e-3  # s; repeated impacts of one body, or jerks of one string, within this time end the motion
TIE = 1e-9  # s; events closer than this are simultaneous
END_SIMULTANEITY_TOL = 1e-7  # s; ends of the motion this close are simultaneous, as lengths have errors of 1e-8 m
REST_SPEED = 1e-8  # m/s or rad/s; residual round-off of a speed that is zero
SHORT = 1e-7  # s; the last step ends this long before two sites coincide, as a string has no direction there
STEADY = 1e-4  # fraction of the largest load; forces are constant between events
ORDER = {kind: place for place, kind in enumerate(EVENT_KINDS)}  # rank of simultaneous events


def run(mechanism: Mechanism, times: Array) -> Trace:
    """Return the motion at `times` (m,), in seconds, increasing from 0; raises as `simulate` of the package does."""
    motion = ConstantLoop(mechanism, float(times[-1]))
    while motion.advance():
        if motion.segments > SEGMENTS:
            raise SimulationError(f"more than {SEGMENTS} events before {times[-1]:g} s; simulate a shorter time")
    record = motion.record
    events = sorted(motion.events, key=lambda event: (event.time, ORDER[event.kind]))
    return Trace("mujoco", record.state(times), tuple(events), motion.now, motion.cut, record.state)


class ConstantLoop:
    """A motion under construction: the present state and the steps so far, extended from event to event."""

    def __init__(self, mechanism: Mechanism, duration: float) -> None:
        """Compile the mechanism and set its initial state."""
        self.mechanism, self.duration = mechanism, duration
        self.model = CompiledModel(mechanism)
        self.detector = EventDetector(self.model)
        self.now = 0.0
        self.q = np.zeros(self.model.size)
        self.v = np.zeros(self.model.size)
        self.v[self.model.coordinates] = [coordinate.speed for coordinate in mechanism.coordinates]
        self.mode: ContactMode | None = None
        self.record = Recorder(mechanism)
        self.events: list[Event] = []
        self.hits: dict[str, tuple[float, tuple[str, ...]]] = {}
        self.jerks: dict[int, tuple[float, tuple[str, ...]]] = {}
        self.segments, self.steps, self.cut = 0, 0, ""

    def advance(self) -> bool:
        """Advance to just before the next event; return False at the end."""
        self.v[np.abs(self.v) < REST_SPEED] = 0.0
        snapped = self._impact()
        if self.cut:
            return False
        self.segments += 1
        taut = snapped | (np.ones_like(snapped) if self.mode is None else self.mode.taut)
        settled = solve_forces(self.model, self.detector, self.q, self.v, taut)
        self.model.check()
        self._note_changes(settled, snapped)
        if self._ended(settled):
            return False
        self.mode = settled.mode
        return self._travel(settled)

    # ---- impacts

    def _impact(self) -> Flags:
        """Compute all impacts and jerks at an instant; return which strings became taut with a jerk."""
        zero = np.zeros(self.model.size)
        strings = self.detector.strings(self.q, self.v, zero)
        snapped = (strings.value <= TOUCHING) & (strings.rate < -REST_RATE)
        gaps = self.detector.approach(self.q, self.v, zero).gaps
        hits = np.flatnonzero((gaps.value <= TOUCHING) & (gaps.rate < -REST_RATE))
        if not (snapped.any() or len(hits)) or self._crowded(hits, np.flatnonzero(snapped)):
            return snapped
        self.v, lifted = solve_impact(self.model, self.detector, self.q, self.v)
        self.v[np.abs(self.v) < REST_SPEED] = 0.0
        for number in hits:
            pair = self.mechanism.meetings[number]
            self._note("collision", *pair.names)
            self.hits |= dict.fromkeys(self._movable(int(number)), (self.now, pair.names))
        for number in np.flatnonzero(snapped):
            self.jerks[int(number)] = (self.now, (self.mechanism.strings[number].name,))
        self._lift(lifted)
        if self.cut:
            self._note_snapped(snapped)
        if self.cut and not self.record.times:
            self._note_forces(solve_forces(self.model, self.detector, self.q, self.v, snapped))
        return snapped

    def _note_snapped(self, snapped: Flags) -> None:
        for number in np.flatnonzero(snapped):
            self._note("taut", self.mechanism.strings[number].name)

    def _movable(self, number: int) -> list[str]:
        pair = self.mechanism.meetings[number]
        return [name for name in pair.names if self.model.center(name)[1].any()]

    def _crowded(self, hits: Integers, snapped: Integers) -> bool:
        """End the motion at the earlier hit if a body is hit again too soon, or at the earlier jerk of a string."""
        recent = [self.hits[name] for number in hits for name in self._movable(int(number)) if name in self.hits]
        recent += [self.jerks[int(number)] for number in snapped if int(number) in self.jerks]
        early = min((hit for hit in recent if TIE < self.now - hit[0] < CROWD), default=None)
        if early is None:
            return False
        self.now = early[0]
        self.events = [event for event in self.events if event.time <= self.now]
        self._end("crowd", *early[1])
        return True

    # ---- forces

    def _note_changes(self, settled: SettledForces, snapped: Flags) -> None:
        mode, before = settled.mode, self.mode
        if (
            settled.loose and before is not None
        ):  # strings about a part that nothing holds are slack or not as one likes
            mode = mode._replace(taut=before.taut)
        for number, string in enumerate(self.mechanism.strings):
            if snapped[number] or (before is not None and mode.taut[number] and not before.taut[number]):
                self._note("taut", string.name)
            elif before is not None and before.taut[number] and not mode.taut[number]:
                self._note("slack", string.name)
        for number, name in enumerate(self.mechanism.contacts):
            if before is not None and before.rubbing[number] != mode.rubbing[number]:
                self._note("slip" if mode.rubbing[number] else "stick", name)

    def _ended(self, settled: SettledForces) -> bool:
        if not self.record.times:
            self._note_forces(settled)
        self._lift(settled.lifted)
        gaps = self.detector.approach(self.q, self.v, settled.balance.a).gaps
        pressed = (gaps.value <= TOUCHING) & (np.abs(gaps.rate) <= REST_RATE) & (gaps.second < -REST_RATE)
        if not self.cut and settled.loose:
            self._end("indeterminate", *self._unheld())
        elif not self.cut and pressed.any():
            pair = self.mechanism.meetings[int(np.flatnonzero(pressed)[0])]
            self._end("crowd", *pair.names)
        return bool(self.cut)

    def _unheld(self) -> list[str]:
        free = np.abs(weightless(self.model)).max(axis=1)[self.model.coordinates] > 1e-6
        return [c.name for c, moves in zip(self.mechanism.coordinates, free, strict=True) if moves]

    # ---- motion

    def _travel(self, settled: SettledForces) -> bool:
        """Step to the next event; return False at the end."""
        self._note_forces(settled)
        a = settled.balance.a
        while True:
            loose = ~settled.mode.taut
            change = self.detector.next_change(self.q, self.v, a, loose, settled.mode.rubbing)
            ends = self.detector.finish(self.q, self.v, a).used_up()
            finish, left = float(ends.min(initial=inf)), self.duration - self.now
            ending = finish <= left + END_SIMULTANEITY_TOL
            if min(finish, left) <= change + TIE and ending and finish <= SHORT:
                return self._finish(ends)
            if left <= TIE:
                self.now = self.duration
                return False
            if change <= TIE:
                return True
            room = finish - 0.5 * SHORT if ending else inf  # what ends well after the duration needs no care
            self._step(min(change, room, left, STEP))
            a = self.model.a
            self._note_step(settled, a)

    def _step(self, duration: float) -> None:
        """Advance by one step, shortened to the contact of bodies if a curved approach was predicted inexactly."""
        q, v, now = self.model.q, self.model.v, self.now
        for _ in range(CLOSER):
            self.model.step(duration)
            self.now = now + duration
            self.q, self.v = self.model.q, self.model.v
            back = self.detector.too_far(self.q, self.v, duration)
            if back == 0.0:
                break
            duration -= back
            self.model.load(q, v)
        self.steps += 1
        if self.steps > STEPS:
            raise SimulationError("MuJoCo: the budget of steps is used up")
        self.model.check()
        if self.detector.bent():
            raise UnsupportedError("a string bends as it moves")

    def _finish(self, ends: Array) -> bool:
        soonest = float(ends.min())
        self.now += soonest
        for number in np.flatnonzero(ends <= soonest + END_SIMULTANEITY_TOL):
            kind, subjects = self.detector.ends[int(number)]
            self._end(kind, *subjects)
        return False

    # ---- notes

    def _note_forces(self, settled: SettledForces) -> None:
        self._keep(settled, self.q, self.v, settled.balance.a, settled.balance.forces)

    def _note_step(self, settled: SettledForces, a: Array) -> None:
        forces = self.model.forces(self.model.rows())
        if np.abs(forces - settled.balance.forces).max(initial=0.0) > STEADY * self.model.load_scale:
            raise SimulationError("MuJoCo: a force changes between two events")
        before, time = self.record.motion[-1], self.record.times[-1]
        self._keep(settled, self.q, self.v, a, forces)
        self._note_turns(before, time)

    def _keep(self, settled: SettledForces, q: Array, v: Array, a: Array, forces: Array) -> None:
        model, n = self.model, self.model.coordinates
        normal = forces[model.presses]
        friction = forces[model.grips] - settled.mode.rubbing * model.friction * normal
        known = np.where(settled.undetermined, np.nan, forces)
        friction = np.where(settled.undetermined[model.grips], np.nan, friction)
        shown = np.concatenate([known[model.strings], known[model.presses], friction])
        self.record.add(self.now, np.concatenate([q[n], v[n], a[n]]), shown)

    def _note_turns(self, before: Array, time: float) -> None:
        """Record the instants within a step at which speeds of frictionless joints pass through zero."""
        n = len(self.mechanism.coordinates)
        old, new = before[n : 2 * n], self.record.motion[-1][n : 2 * n]
        rough = set(self.model.rubs[self.model.friction > 0.0])
        for number in np.flatnonzero((old * new < 0.0) & (np.abs(old) > REST_SPEED) & (np.abs(new) > REST_SPEED)):
            if self.model.coordinates[number] not in rough:
                part = old[number] / (old[number] - new[number])
                when = time + float(part) * (self.now - time)
                self.events.append(Event(when, "turn", (self.mechanism.coordinates[number].name,)))

    def _lift(self, contacts: tuple[int, ...]) -> None:
        names = list(self.mechanism.contacts)
        for number in contacts:
            self._end("lift", names[number])

    def _note(self, kind: str, *subjects: str) -> None:
        self.events.append(Event(self.now, kind, subjects))

    def _end(self, kind: str, *subjects: str) -> None:
        self._note(kind, *subjects)
        self.cut = self.cut or kind
