"""One instant of a motion: impacts, then the forces and the contact mode that follow."""

from collections.abc import Sequence
from dataclasses import dataclass

from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.simulation.engines.exact.balance import Balance, ContactDemand, balance, separating_contacts
from sim2reason.simulation.engines.exact.contact_modes import search
from sim2reason.simulation.engines.exact.flow import Flow
from sim2reason.simulation.engines.exact.formulas import VariableEquations
from sim2reason.simulation.engines.exact.glide import REST_RATE, ConstantEquations
from sim2reason.simulation.engines.exact.linear import ContactMode, Problem, RoughContact, Row, dot
from sim2reason.simulation.engines.exact.margins import Margin
from sim2reason.simulation.engines.exact.motion import EventLog, Segment
from sim2reason.simulation.engines.exact.system import CONTACT_DISTANCE, Instant, PairState, System

IMPULSE_RTOL = 1e-9  # fraction of the largest impulse or momentum: a smaller negative impulse is round-off


@dataclass(slots=True)
class ImpactResult:
    """The state just after an impact."""

    v: Row  # the velocities just after
    acting: tuple[bool, ...]  # for each row in the impact
    rubbing: tuple[int, ...]  # for each rough contact: 0 if it sticks
    lifted: tuple[int, ...]  # the contacts that separate; v is then meaningless


@dataclass(slots=True)
class Impact:
    """The constraints in an impact: indices of rows, the initially acting ones, indices of pairs, kinds of rows."""

    rows: list[int]
    acting: list[bool]
    pairs: list[int]
    held: tuple[bool, ...]
    follows: tuple[int, ...]


def solve_impact(system: System, instant: Instant, impact: Impact, still: float) -> ImpactResult:
    """Compute the state just after an impact; closing speeds below `still`, m/s, count as zero."""
    rows = [instant.rows[number] for number in impact.rows]
    targets = [instant.rows[number].rate(instant.v) - instant.rates[number] for number in impact.rows]
    acting = list(impact.acting)
    for number in impact.pairs:
        near = instant.pairs[number]
        rows.append(near.closing(system.size, system.count))
        acting.append(near.rate < -still)
        targets.append(min(0.0, near.meeting.restitution * near.rate))
    loads = instant.loads
    momenta = [dot(row, instant.v) for row in loads.mass]
    problem = Problem(
        loads.mass,
        loads.lifted,
        momenta,
        [dot(row, instant.v) for row in loads.lifted],
        tuple(rows),
        targets,
        system.grips,
        (0,) * len(system.grips),
        (*impact.held, *(False for _ in impact.pairs)),
        (*impact.follows, *(-1 for _ in impact.pairs)),
        system.guided,
        system.budget,
    )
    sides = tuple(grip.side(slip) for grip, slip in zip(system.grips, instant.slips, strict=True))
    force_balance = search(problem, ContactMode(tuple(acting), sides))
    small = IMPULSE_RTOL * max(map(abs, (*force_balance.forces.normal, *momenta)), default=0.0)
    apart = separating_contacts(problem, loads.heave, force_balance, small)
    return ImpactResult(
        force_balance.x, force_balance.mode.acting[: len(impact.rows)], force_balance.mode.rubbing, apart
    )


REST_SPEED = 1e-11  # m/s or rad/s; residual round-off of a speed that is zero
CONSTRAINT_DRIFT = 1e-7  # m or m/s; admissible drift of a constraint


class Settling:
    """A motion under construction: the present state, the recorded segments and the present contact mode."""

    def __init__(self, mechanism: Mechanism, duration: float, tolerance: float) -> None:
        """Validate the mechanism, raising as `System` does, and set the state at the start of the motion."""
        self.tolerance = tolerance
        self.system = System(mechanism)
        self.steady = None if self.system.changing else ConstantEquations(self.system)
        self.curved = VariableEquations(self.system) if self.steady is None else None
        self.still = REST_RATE if self.curved is None else CONSTRAINT_DRIFT
        self.mechanism, self.duration = mechanism, duration
        self.now = 0.0
        self.q: Row = [0.0] * self.system.size
        self.v: Row = [float(coordinate.speed) for coordinate in mechanism.coordinates]
        self.phase = self.system.phase
        self.kinds = self.system.kinds(self.phase)
        self.mode = ContactMode((True,) * len(self.kinds), (0,) * len(self.system.grips))
        self.due: tuple[Margin, ...] = ()
        self.segments: list[Segment] = []
        self.event_log = EventLog(mechanism)

    def instant(self) -> Instant:
        """Return the equations at the present state."""
        equations = self.steady or self.curved
        assert equations is not None
        return equations.instant(self.now, self.q, self.v, self.phase)

    # -- impacts ---------------------------------------------------------------------------------

    def impact(self, instant: Instant) -> set[int] | None:
        """Compute all impacts at an instant; return the constraints that tighten with a jerk, None if motion ends."""
        full = [
            i
            for i, spare in enumerate(instant.spare)
            if spare <= CONTACT_DISTANCE or self.kinds[i].both or self._acts(i)
        ]
        full = [i for i in full if not self._is_due("force", i)]
        full = [i for i in full if self.kinds[i].follows < 0 or self.kinds[i].follows in full]
        snapped = {i for i in full if instant.rates[i] > self.still and not self.kinds[i].both}
        if self.curved is not None and self.segments:
            snapped = {i for i in snapped if not self.mode.acting[i] or instant.rates[i] > 1.0}
        touching = [i for i, near in enumerate(instant.pairs) if self._takes_part(i, near)]
        hits = [i for i in touching if instant.pairs[i].rate < -REST_RATE]
        if not snapped and not hits:
            return snapped
        if self._crowded(hits, snapped):
            return None
        self._strike(instant, full, touching, snapped)
        return None if self.event_log.cut else snapped

    def _takes_part(self, number: int, near: PairState) -> bool:
        """Return whether a pair takes part in an impact: touching, not stuck, not at rest if the bodies can bounce."""
        resting = near.meeting.restitution > 0.0 and near.rate >= -REST_RATE
        return near.touching and not resting and not self.phase.stuck[number]

    def _strike(self, instant: Instant, full: list[int], touching: list[int], snapped: set[int]) -> None:
        new_index = {number: new for new, number in enumerate(full)}
        impact = Impact(
            full,
            [self.kinds[i].both or self._acts(i) or instant.rates[i] > self.still for i in full],
            touching,
            tuple(self.kinds[i].both for i in full),
            tuple(new_index.get(self.kinds[i].follows, -1) for i in full),
        )
        impact_result = solve_impact(self.system, instant, impact, REST_RATE)
        hits = [i for i in touching if instant.pairs[i].rate < -REST_RATE]
        self.v = [0.0 if abs(speed) < REST_SPEED else speed for speed in impact_result.v]
        self._rest(impact_result.rubbing)
        for number in hits:
            names = self.mechanism.meetings[number].names
            self.event_log.record(self.now, "collision", *names)
            self.event_log.record_impact(self.now, self.system.movable[number], names)
            if self.mechanism.meetings[number].sticks:
                self._stick(number)
        for number in snapped:
            self.event_log.record_impact(self.now, [f"row {self.kinds[number].name}"], (self.kinds[number].name,))
        if impact_result.lifted:
            self.event_log.record_jerks(self.now, self.kinds, snapped)
            self.event_log.lift(self.now, impact_result.lifted)

    def _rest(self, rubbing: tuple[int, ...]) -> None:
        """Set the slip of each contact that sticks after an impact to exactly zero if it depends on one coordinate."""
        for grip, side in zip(self.system.grips, rubbing, strict=True):
            if side == 0 and grip.coordinate >= 0:
                self.v[grip.coordinate] = 0.0

    def _stick(self, number: int) -> None:
        """Keep a pair of bodies together from now on by an additional constraint row."""
        stuck = tuple(was or i == number for i, was in enumerate(self.phase.stuck))
        self.phase = self.phase._replace(stuck=stuck)
        kinds = self.system.kinds(self.phase)
        first = sum(kind.kind != "stuck" for kind in kinds)
        self.mode = ContactMode((*self.mode.acting[:first], *(True for _ in kinds[first:])), self.mode.rubbing)
        self.kinds = kinds

    def _crowded(self, hits: list[int], snapped: set[int]) -> bool:
        """End the motion if a body is hit or a string jerks again too soon, as such impacts may repeat endlessly."""
        names = [name for i in hits for name in self.system.movable[i]]
        early = self.event_log.previous_impact_time(
            self.now, [*names, *(f"row {self.kinds[number].name}" for number in snapped)]
        )
        if early is None:
            return False
        self.now = early
        self.segments = [segment for segment in self.segments if segment.start <= self.now]
        return True

    # -- forces ----------------------------------------------------------------------------------

    def settle(self, instant: Instant, snapped: set[int], rates: Sequence[float]) -> Balance | None:
        """Return the forces and record changes of contact; None at the end. `rates`: of row lengths before impacts."""
        before = self.mode
        force_balance = self.balance(instant, snapped, rates)
        touching = (i for i, near in enumerate(instant.pairs) if near.touching)
        pressing = next((i for i in touching if self._pressed(instant, i, force_balance.a)), None)
        torn = [margin.number for margin in self.due if self._is_torn(instant, margin, force_balance.a)]
        ended = bool(force_balance.lifted) or force_balance.loose or pressing is not None or bool(torn)
        if self.segments or snapped:
            # which strings are slack about a part that nothing holds is as open as how it moves
            after = force_balance.mode._replace(acting=before.acting) if force_balance.loose else force_balance.mode
            self.event_log.changed(self.now, self.kinds, (before, after), snapped, first=not self.segments)
            if self.segments:
                self.event_log.record_friction_changes(self.now, self.system.grips, (before, after))
        if ended and not self.segments:
            self.append(force_balance, None)
        self.mode = force_balance.mode
        if not ended:
            return force_balance
        if force_balance.lifted:
            self.event_log.lift(self.now, force_balance.lifted)
        elif force_balance.loose:
            self.event_log.end(self.now, "indeterminate", *self._unheld(instant))
        elif pressing is not None:
            self.event_log.end(self.now, "crowd", *self.mechanism.meetings[pressing].names)
        for number in torn:
            self.event_log.end(self.now, "lift", self.kinds[number].name)
        return None

    def balance(self, instant: Instant, snapped: set[int], rates: Sequence[float] | None) -> Balance:
        """Compute the forces, with rows and contacts whose event has just occurred in the state after that event.

        `rates` are those of rows before any impact; None if no row is tight.
        """
        rows = range(len(self.kinds) if rates is not None else 0)
        tight = [i for i in rows if self.kinds[i].both or self._is_tight(instant, i, rates or ())]
        tight = [i for i in tight if self.kinds[i].follows < 0 or self.kinds[i].follows in tight]
        sliding = [
            grip.side(slip, self._least(grip)) for grip, slip in zip(self.system.grips, instant.slips, strict=True)
        ]
        for number in range(len(sliding)):
            if self._is_due("slip", number):
                sliding[number] = 0
        guess = [0 if self.segments and not side else was for side, was in zip(sliding, self.mode.rubbing, strict=True)]
        for margin in self.due:
            if margin.kind == "grip":
                sliding[margin.number] = guess[margin.number] = margin.side
        acting = tuple(acts or number in snapped for number, acts in enumerate(self.mode.acting))
        return balance(
            self.system, instant, ContactDemand(tight, tuple(sliding), ContactMode(acting, tuple(guess)), self.kinds)
        )

    def _least(self, grip: RoughContact) -> float:
        """Return the largest slip speed that counts as zero: 0 for a slip that is one coordinate's rate, else more."""
        return 0.0 if self.curved is None and grip.coordinate >= 0 else REST_RATE

    def _is_tight(self, instant: Instant, number: int, rates: Sequence[float]) -> bool:
        """Return whether a constraint may act: its length has reached the bound and does not recede.

        An acting row continues to act despite integration drift, unless an impact makes it recede.
        """
        if self._is_due("force", number):
            return False
        if self.curved is not None and self._acts(number):
            drifted = rates[number] if number < len(rates) else 0.0  # a pair that now sticks has one row more
            return instant.rates[number] > min(drifted, 0.0) - CONSTRAINT_DRIFT
        return instant.spare[number] <= CONTACT_DISTANCE and abs(instant.rates[number]) <= self.still

    def _acts(self, number: int) -> bool:
        """Return whether a constraint acted in the preceding segment, so that integration drift is possible."""
        return bool(self.segments) and self.mode.acting[number]

    def _is_due(self, kind: str, number: int) -> bool:
        return bool(self.due) and any(margin.kind == kind and margin.number == number for margin in self.due)

    def _pressed(self, instant: Instant, number: int, a: Row) -> bool:
        """Return whether two bodies in resting contact are pressed together, which would cause infinitely many hits."""
        near = instant.pairs[number]
        if self.phase.stuck[number] or abs(near.rate) > REST_RATE:
            return False
        return near.second(a) < -REST_RATE

    def _is_torn(self, instant: Instant, due: Margin, a: Row) -> bool:
        """Return whether a foot that loses contact would return at once because nothing holds it along its plane.

        It would have to slip first, which no coefficient of friction determines.
        """
        if due.kind != "force" or self.kinds[due.number].kind != "foot":
            return False
        return instant.rows[due.number].rate(a) - instant.targets[due.number] > REST_RATE

    def append(self, found: Balance, flow: Flow | None) -> None:
        """Record the segment that starts at the present state."""
        self.segments.append(Segment(self.now, self.q, self.v, found, tuple(self.kinds), flow))

    # -- small things ----------------------------------------------------------------------------

    def _unheld(self, instant: Instant) -> tuple[str, ...]:
        """Return the names of the coordinates whose massless bodies may be unsupported."""
        moving = {number for motion in instant.loads.weightless for number, part in enumerate(motion) if part}
        names = [c.name for number, c in enumerate(self.mechanism.coordinates) if number in moving]
        return tuple(names)
