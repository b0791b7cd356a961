"""One instant of a motion: impacts, then the acting forces, recorded as events."""

from dataclasses import replace

import numpy as np

from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.engines.mujoco.contact_modes import all_acting, search
from sim2reason.simulation.engines.mujoco.event_search import SIMULTANEITY_RTOL
from sim2reason.simulation.engines.mujoco.forces import (
    UNLIMITED_FRICTION,
    ContactMode,
    ForceProblem,
    ForceSolution,
    Row,
    SwitchState,
)
from sim2reason.simulation.engines.mujoco.integration import Knot
from sim2reason.simulation.engines.mujoco.margins import EventFunction
from sim2reason.simulation.engines.mujoco.model import CompiledModel
from sim2reason.simulation.engines.mujoco.record import MotionRecord, present_problem
from sim2reason.simulation.trace import Event

CONTACT_DISTANCE = 1e-7  # m; smaller distances count as contact
REST_SPEED = 1e-6  # m/s or m/s²; slower motion counts as rest
FAINT, MIN_LOAD = 1e-7, 1e-3  # fraction of the largest load, at least this, N: smaller tensions hold nothing
FREE_MOTION_TOL = 1e-6  # smaller components of a motion of massless parts are round-off
LIFT_SPEED_RTOL = 1e-6  # fraction of the largest speed: a smaller speed of separation after an impact is round-off
DUPLICATE_WINDOW = 8  # latest events that are compared to avoid duplicates
REPEATED_IMPACT_TIME = 5e-3  # s; repeated impacts of one body, or jerks of one string, within this time end the motion
BEGINS = {"string": "taut", "prop": "land", "foot": "land"}  # kind of the event at which a constraint begins to act
STOPS = {"string": "slack", "prop": "leave", "foot": "leave"}  # kind of the event at which a constraint ceases to act


class InstantSolver:
    """A motion under construction: the present state, the recorded segments and the present contact mode."""

    def __init__(self, mechanism: Mechanism, times: Array) -> None:
        """Compile the mechanism and set its initial state; the last of `times` is the end, s."""
        self.mechanism, self.duration = mechanism, float(times[-1])
        self.model = CompiledModel(mechanism)
        self.now = 0.0
        self.q, self.v = np.zeros(self.model.size), np.zeros(self.model.size)
        self.v[self.model.coordinates] = [coordinate.speed for coordinate in mechanism.coordinates]
        self.switches = SwitchState(
            [],
            [burn.until > 0.0 for burn in mechanism.burns],
            [False] * len(mechanism.meetings),
            [False] * len(mechanism.half_springs),
        )
        self.switches.inside = [[True]] * len(mechanism.forces)
        self.model.set_state(0.0, self.q, self.v, self.switches)
        self.switches.inside = [[m > 0.0 for m in self.model.borders(i)] for i in range(len(mechanism.forces))]
        pulls = self.model.pulls
        strains = zip(pulls.deformations(self.q), pulls.deformation_rates(self.q, self.v), strict=True)
        self.switches.strained = [
            s > CONTACT_DISTANCE or (abs(s) <= CONTACT_DISTANCE and rate > 0.0) for s, rate in strains
        ]
        self.mode: ContactMode | None = None
        self.due: list[EventFunction] = []
        self.record = MotionRecord(self.model)
        self.events: list[Event] = []
        self.hits: dict[str, tuple[float, tuple[str, ...]]] = {}
        self.jerks: dict[str, tuple[float, tuple[str, ...]]] = {}
        self.steps = 0
        self.cut = ""

    def settle(self) -> ForceSolution:
        """Compute the acting forces; record the changes and any event that ends the motion."""
        rows = self.model.rows()
        solution = self._search(rows)
        unheld = self._unsupported(rows, solution)
        if self.mode is not None and self.record.intervals:  # how it begins, be it with a jerk, is no change
            # which strings are slack about a part that nothing holds is as undetermined as its motion
            after = solution.mode._replace(rows=self.mode.rows[: len(rows)]) if unheld else solution.mode
            self._note_changes(after._replace(rubbing=self._rubbing(solution)), rows)
        self._lift(solution, REST_SPEED)
        if unheld and not self.cut:
            self.end("indeterminate", *unheld)
        self._tear(rows, solution.x)
        self._pressed(solution.x)
        if self.cut and not self.record.intervals:  # it ended as it began
            self._record_only(solution)
        return solution

    def _search(self, rows: list[Row]) -> ForceSolution:
        sliding = self._sliding()
        allowed = tuple(self._may_act(i, row) for i, row in enumerate(rows))
        return search(present_problem(self.model, rows, sliding, allowed), self._guess(rows, sliding))

    def _record_only(self, found: ForceSolution) -> None:
        """Record the present state as the entire motion."""
        self.record.start(found.mode, found, self.switches)
        self.record.add(Knot(self.now, np.concatenate([self.q, self.v]), np.concatenate([self.v, found.x])))

    def _unsupported(self, rows: list[Row], found: ForceSolution) -> list[str]:
        """Return the coordinates of massless parts that no row, face or friction holds; none if all are held."""
        free = self.model.weightless()
        if not free.shape[1]:
            return []
        faint = FAINT * max(float(np.abs(self.model.loads()).max(initial=0.0)), MIN_LOAD)
        pulls = (found.rows > faint) | (found.unknown[: len(rows)] > 0.0)
        holding = [row.gradient for row, pulled in zip(rows, pulls, strict=True) if row.both or pulled]
        shut = [i for i, face in enumerate(found.mode.faces) if face]
        holding += [np.eye(self.model.size)[self.model.faces.rises[i]] for i in shut]
        holding += [
            self.model.faces.slips[i] for i in shut if self.model.faces.friction[i] > 0.0 and not found.mode.rubbing[i]
        ]
        held = np.array(holding).reshape(len(holding), self.model.size) @ free
        if np.linalg.matrix_rank(held, tol=FREE_MOTION_TOL) == free.shape[1]:
            return []
        moving = np.abs(free).max(axis=1)[self.model.coordinates] > FREE_MOTION_TOL
        return [c.name for c, moves in zip(self.mechanism.coordinates, moving.tolist(), strict=True) if moves]

    def _guess(self, rows: list[Row], sliding: tuple[int, ...]) -> ContactMode:
        """Return a first guess of the contact mode: rows keep acting, and contacts that do not slip stick."""
        faces = len(self.mechanism.faces)
        if self.mode is None:
            return all_acting(len(rows), faces)
        acting = [*self.mode.rows, *([True] * (len(rows) - len(self.mode.rows)))]
        for due in self.due:
            if due.kind == "force":
                acting[due.number] = False
        return ContactMode(tuple(acting), self.mode.faces, sliding)

    def _sliding(self) -> tuple[int, ...]:
        """Return the direction of slip of each face; a face at the friction limit begins to slip."""
        speeds = (self.model.faces.slips @ self.v).tolist()
        sides = [int(np.sign(speed)) if abs(speed) > REST_SPEED else 0 for speed in speeds]
        for due in self.due:
            if due.kind == "grip":
                sides[due.number] = due.side
            elif due.kind == "slip":
                sides[due.number] = 0
        return tuple(
            side if 0.0 < mu < UNLIMITED_FRICTION else 0
            for side, mu in zip(sides, self.model.faces.friction, strict=True)
        )

    def _may_act(self, number: int, row: Row) -> bool:
        if row.both and row.follows < 0:
            return True
        if any(due.kind == "force" and due.number in (number, row.follows) for due in self.due):
            return False
        if row.follows >= 0:
            return row.spare <= CONTACT_DISTANCE
        if self.mode is not None and number < len(self.mode.rows) and self.mode.rows[number]:
            return row.rate > -1e3 * REST_SPEED
        return row.spare <= CONTACT_DISTANCE and abs(row.rate) <= 1e2 * REST_SPEED

    def _rubbing(self, found: ForceSolution) -> tuple[int, ...]:
        """Return the direction of slip of each face; a face at rest that is not accelerated sticks.

        Of undetermined forces some let it slide at no speed.
        """
        sliding, started = self._sliding(), self.model.faces.slips @ found.x
        sides = zip(found.mode.rubbing, sliding, started, strict=True)
        return tuple(side if slides or abs(begins) > REST_SPEED else 0 for side, slides, begins in sides)

    def _lift(self, found: ForceSolution, least: float) -> None:
        """Record the end of the motion at open faces; under constant forces only if these open faster than `least`."""
        for number, (shut, rise) in enumerate(zip(found.mode.faces, self.model.faces.rises, strict=True)):
            if not shut and not (self.model.constant and found.x[rise] <= least):
                self.end("lift", self.mechanism.faces[number].subject)

    def _tear(self, rows: list[Row], a: Array) -> None:
        """Record the end of the motion if a foot that loses contact would return at once without first slipping."""
        for due in self.due:
            if due.kind == "force" and rows[due.number].kind == "foot":
                row = rows[due.number]
                if row.gradient @ a - row.target > REST_SPEED:
                    self.end("lift", row.name)

    def _pressed(self, a: Array) -> None:
        """Record the end of the motion if two resting bodies are pressed together, which causes endless hits."""
        for number, meeting in enumerate(self.mechanism.meetings):
            if not self.switches.stuck[number]:
                gap, rate, gradient, bias = self.model.separation(meeting)
                if (
                    gap <= CONTACT_DISTANCE
                    and abs(rate) <= REST_SPEED
                    and gradient @ a + bias < -REST_SPEED
                    and not self.cut
                ):
                    self.end("crowd", *meeting.names)

    def _note_changes(self, after: ContactMode, rows: list[Row]) -> None:
        assert self.mode is not None
        for number, row in enumerate(rows):
            was = self.mode.rows[number] if number < len(self.mode.rows) else True
            if row.both or was == after.rows[number]:
                continue
            if was and self.jerks.get(row.name, (-1.0,))[0] == self.now:  # it is slack again at once
                continue
            self.note((BEGINS if after.rows[number] else STOPS)[row.kind], row.name)
        for number, face in enumerate(self.mechanism.faces):
            if self.record.intervals and self.mode.rubbing[number] != after.rubbing[number]:
                self.note("slip" if after.rubbing[number] else "stick", face.subject)

    # ---- impacts

    def impact(self) -> bool:
        """Compute all impacts and jerks at an instant; return False at the end of the motion."""
        rows = self.model.rows()
        acts = [self.mode is not None and i < len(self.mode.rows) and self.mode.rows[i] for i in range(len(rows))]
        snapped = [
            i
            for i, row in enumerate(rows)
            if not row.both and row.spare <= CONTACT_DISTANCE and row.rate > (1.0 if acts[i] else 10.0 * REST_SPEED)
        ]
        near = [self.model.separation(meeting) for meeting in self.mechanism.meetings]
        bounces = [meeting.restitution > 0.0 for meeting in self.mechanism.meetings]
        touching = [  # a pair that rests against each other is struck next
            i
            for i, (gap, rate, *_) in enumerate(near)
            if gap <= CONTACT_DISTANCE and not self.switches.stuck[i] and (rate < -REST_SPEED or not bounces[i])
        ]
        hits = [i for i in touching if near[i][1] < -REST_SPEED]
        if not snapped and not hits:
            return True
        if self._ends_crowded(hits, [rows[i].name for i in snapped]):
            return False
        self._strike(rows, acts, touching)
        for i in hits:
            names = self.mechanism.meetings[i].names
            self.note("collision", *names)
            movable = [name for name in names if self.model.center(name).jacobian.any()]
            self.hits |= dict.fromkeys(movable, (self.now, names))
            if self.mechanism.meetings[i].sticks:
                self.switches.stuck[i] = True
        for i in snapped:
            self.jerks[rows[i].name] = (self.now, (rows[i].name,))
        return not self.cut

    def meets(self) -> bool:
        """Return whether any touching bodies that do not stick together approach each other."""
        near = (self.model.separation(meeting) for meeting in self.mechanism.meetings)
        pairs = zip(near, self.switches.stuck, strict=True)
        return any(gap <= CONTACT_DISTANCE and rate < -REST_SPEED and not stuck for (gap, rate, *_), stuck in pairs)

    def _strike(self, rows: list[Row], acts: list[bool], touching: list[int]) -> None:
        """Compute the velocities just after an impact, as in the problem of forces but with momenta as loads."""
        instant, every = self._impact_problem(rows, acts, touching)
        speeds = self.model.faces.slips @ self.v
        sides = tuple(
            int(np.sign(s)) if abs(s) > REST_SPEED and mu < UNLIMITED_FRICTION else 0
            for s, mu in zip(speeds, self.model.faces.friction, strict=True)
        )
        began = tuple(row.rate > REST_SPEED or (i < len(rows) and acts[i]) for i, row in enumerate(every))
        solution = search(instant, ContactMode(began, (True,) * len(self.mechanism.faces), sides))
        self.v = np.where(np.abs(solution.x) < REST_SPEED * 1e-3, 0.0, solution.x)
        self._lift(solution, LIFT_SPEED_RTOL * float(np.abs(self.v).max(initial=0.0)))
        for number, (row, acts_now) in enumerate(zip(rows, solution.mode.rows, strict=False)):
            if acts_now and not row.both and row.rate > 10.0 * REST_SPEED:
                self.note(BEGINS[row.kind], row.name)
            elif acts[number] and not acts_now and not row.both:
                self.note(STOPS[row.kind], row.name)
        before = self.mode or all_acting(len(rows), len(self.mechanism.faces))
        self.mode = before._replace(rows=tuple(solution.mode.rows[: len(rows)]))
        self.due = []
        if self.cut and not self.record.intervals:
            self.model.set_state(self.now, self.q, self.v, self.switches)
            self._record_only(self._search(self.model.rows()))

    def _impact_problem(self, rows: list[Row], acts: list[bool], touching: list[int]) -> tuple[ForceProblem, list[Row]]:
        """Return the force problem that represents an impact, and the problem's rows, those of touching pairs last."""
        hits: list[Row] = []
        for number in touching:
            meeting = self.mechanism.meetings[number]
            _, rate, gradient, _ = self.model.separation(meeting)
            hits.append(Row("hit", "", -gradient, 0.0, -rate, min(0.0, meeting.restitution * rate)))
        full = [row.spare <= CONTACT_DISTANCE or acts[i] or row.both for i, row in enumerate(rows)]
        every, faces = [*rows, *hits], len(self.mechanism.faces)
        instant = present_problem(self.model, every, (0,) * faces, (*full, *(True for _ in hits)))
        targets = [float(row.gradient @ self.v) - row.rate for row in rows] + [row.target for row in hits]
        return replace(instant, loads=instant.inertia @ self.v, targets=targets), every

    def _ends_crowded(self, hits: list[int], snapped: list[str]) -> bool:
        """End the motion if a body is hit, or a string jerks, again too soon."""
        names = [name for i in hits for name in self.mechanism.meetings[i].names]
        recent = [self.hits[name] for name in names if name in self.hits]
        recent += [self.jerks[name] for name in snapped if name in self.jerks]
        early = min(
            (hit for hit in recent if SIMULTANEITY_RTOL < self.now - hit[0] < REPEATED_IMPACT_TIME), default=None
        )
        if early is None:
            return False
        self.now = early[0]
        self.events = [event for event in self.events if event.time <= self.now]
        self.end("crowd", *early[1])
        return True

    def note(self, kind: str, *subjects: str) -> None:
        """Record an event at the present time unless already recorded; only collisions may be recorded repeatedly."""
        event = Event(self.now, kind, subjects)
        if kind == "collision" or event not in self.events[-DUPLICATE_WINDOW:]:
            self.events.append(event)

    def end(self, kind: str, *subjects: str) -> None:
        """Record an event that ends the motion now."""
        self.note(kind, *subjects)
        self.cut = self.cut or kind
