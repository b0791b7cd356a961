"""Generated straight-line code for the changing equations of a mechanism, one function per contact mode.

The equations are recorded once on a tape; those of a mode are solved on it with pivots chosen at the start of the mode.
The code runs with floats for the integrator and with arrays for all samples at once.
"""

import math
from functools import partial
from itertools import chain
from math import inf

from sim2reason.scenes.dsl.frames import Frames
from sim2reason.scenes.dsl.structure import constant_direction
from sim2reason.scenes.dsl.vectors import Number, dot, subtract_triples
from sim2reason.simulation.engines.exact.affine import linear_equations
from sim2reason.simulation.engines.exact.assembly import Assembly
from sim2reason.simulation.engines.exact.lengths import RowTerms, SwitchState
from sim2reason.simulation.engines.exact.linear import ContactMode, FreeForces, Row, Unknowns, solve_symbolic
from sim2reason.simulation.engines.exact.margins import Formulas, Margin
from sim2reason.simulation.engines.exact.system import Instant, System
from sim2reason.simulation.engines.exact.tape import Symbol, Tape, float_value

ZERO_MARGIN_CHANGE = 1e-9  # a smaller change of an event function counts as zero
COINCIDENCE_DISTANCE = 1e-9  # m; the ends of a straight line segment that are closer coincide
MIN_PIVOT_RATIO = 1e-6  # fraction of its initial size: a pivot that shrinks below this is unusable
PASSING_DISTANCE = (
    1e-7  # m; at smaller distances a line has no direction, and a step could skip the coincidence of its points
)
STAGES, MARGINS = 13, 3  # evaluations of rates and of margins per step
UNKNOWN, FIXED = 400, 500  # operations of a step for each coordinate, and in total at least
OPERATIONS_PER_LINE = 100  # operations to generate the code that executes one operation


class VariableEquations:
    """Equations of motion recorded as symbols for each on/off state, with generated code for each contact mode."""

    def __init__(self, system: System) -> None:
        """Start without equations; they are recorded on first use."""
        self.system = system
        self._recorded: dict[SwitchState, _Recorded] = {}

    def restarted(self) -> "VariableEquations":
        """Return the equations for the same motion from its start; the code of its first contact mode is kept.

        Code of later modes is discarded, because its pivots depend on the instant at which a mode begins.
        """
        costs = [cost for recorded in self._recorded.values() for cost in recorded.costs]
        if len(costs) != 1 or not any(recorded.made for recorded in self._recorded.values()):
            return VariableEquations(self.system)
        self.system.budget.spend(costs[0])
        return self

    def instant(self, time: float, q: Row, v: Row, phase: SwitchState) -> Instant:
        """Return the numerical equations at one instant."""
        return self.system.instant(time, q, v, phase)

    def formulas(self, instant: Instant, phase: SwitchState, mode: ContactMode) -> Formulas:
        """Return the code of a contact mode, generated on first use."""
        recorded = self._recorded.get(phase)
        if recorded is None:
            recorded = self._recorded[phase] = _Recorded(self.system, phase)
        return recorded.formulas(instant, mode)

    def forget(self, phase: SwitchState, mode: ContactMode) -> None:
        """Discard the code of a contact mode, so that the pivots of its linear equations are chosen anew."""
        self._recorded[phase].made.pop(mode, None)


class _Recorded:
    """The symbolic equations of motion for one on/off state of forces, engines and springs."""

    def __init__(self, system: System, phase: SwitchState) -> None:
        n = system.size
        self.system, self.phase = system, phase
        self.tape = Tape(["t", *(f"q{i}" for i in range(n)), *(f"v{i}" for i in range(n))])
        symbols = list(self.tape.inputs.values())
        self.time, self.q, self.v = symbols[0], symbols[1 : n + 1], symbols[n + 1 :]
        frames = Frames(system.mechanism, self.q, self.v, self.tape, steady=system.steady)
        self.assembly = Assembly(system.mechanism, phase, (self.q, self.v, self.time), self.tape, frames)
        self.mass = self.assembly.full_mass()
        self.rows = self.assembly.rows(system.starts)
        self.made: dict[ContactMode, Formulas] = {}
        self.costs: list[int] = []  # operations to generate the code of each mode

    def formulas(self, instant: Instant, mode: ContactMode) -> Formulas:
        """Return the code of a contact mode, generated at the given instant if it is new."""
        if mode not in self.made:
            self.tape.stand([instant.time, *instant.q, *instant.v])
            self.made[mode] = self._formulas(mode)
        return self.made[mode]

    def _formulas(self, mode: ContactMode) -> Formulas:
        tape = self.tape
        unknowns = self._solved(mode)
        normal = self._normals(unknowns)
        friction = self._friction(mode, unknowns, normal)
        rows = [unknowns.rows.get(number, 0.0) for number in range(len(self.rows))]
        guards = [(pivot, MIN_PIVOT_RATIO * abs(pivot.value)) for pivot in unknowns.pivots if isinstance(pivot, Symbol)]
        rate = tape.code([*self.v, *unknowns.x], guards)(math)
        cost = STAGES * tape.written
        forces = [*unknowns.x, *rows, *normal, *friction]
        watched = self._watched(mode, rows, normal, friction)
        patterns = [self._patterns(mode, spare) for spare in unknowns.free]
        parts = {margin: [pattern.get(margin, 0.0) for pattern in patterns] for margin, _ in watched}
        open_ended = {
            m for m, changes in parts.items() if any(abs(float_value(part)) > ZERO_MARGIN_CHANGE for part in changes)
        }
        braced = [(margin, number) for margin, number in watched if margin in open_ended]
        watched = [(margin, number) for margin, number in watched if margin not in open_ended]
        outputs = [number for _, number in (*watched, *braced)] + [
            part for margin, _ in braced for part in parts[margin]
        ]
        margins = tape.code(outputs)(math)
        cost += MARGINS * tape.written + UNKNOWN * len(self.v) + FIXED
        acting = [row.value for row, acts in zip(self.rows, mode.acting, strict=True) if acts]
        constraint_values = tape.code(acting)(math) if unknowns.free and acting else None
        passing = self._passing(watched)
        closing = tape.code([*passing.values(), *(watched[index][1] for index in passing)])(math)
        self.costs.append(OPERATIONS_PER_LINE * len(tape.nodes))
        self.system.budget.spend(self.costs[-1])
        names = [*(margin for margin, _ in watched), *([Margin("brace", 0)] if braced else [])]
        due = tuple(margin for margin, _ in braced)
        write = partial(tape.code, forces)
        linear = partial(linear_equations, tape, unknowns.x, [number for _, number in watched])
        return Formulas(
            rate, write, margins, tuple(names), constraint_values, tuple(passing), closing, cost, linear, due
        )

    def _patterns(self, mode: ContactMode, free: FreeForces) -> dict[Margin, Number]:
        """Return the change of each event function of rows and contacts due to one pattern of undetermined forces."""
        lift: list[Number] = [0.0] * self.system.count
        for number, force in free.rows.items():
            for contact, part in self.rows[number].lift.items():
                lift[contact] = lift[contact] + part * force
        changes: dict[Margin, Number] = {Margin("force", number): force for number, force in free.rows.items()}
        changes |= {Margin("normal", contact): part for contact, part in enumerate(lift)}
        for number, (grip, side) in enumerate(zip(self.system.grips, mode.rubbing, strict=True)):
            if side == 0 and grip.friction < inf:
                along, bound = free.friction.get(number, 0.0), grip.holds * lift[grip.contact]
                changes[Margin("grip", number, 1)] = bound + along
                changes[Margin("grip", number, -1)] = bound - along
        return changes

    # ---- one mode, solved

    def _solved(self, mode: ContactMode) -> Unknowns:
        """Return accelerations, multipliers of acting rows, and friction of sticking contacts."""
        system, n = self.system, self.system.size
        active = [number for number, acts in enumerate(mode.acting) if acts]
        sticking = [number for number, side in enumerate(mode.rubbing) if side == 0]
        grips, terms = system.grips, self.rows
        equations: list[list[Number]] = []
        for k in range(n):
            row = [*self.mass[k], *(terms[i].along.get(k, 0.0) for i in active)]
            row += [*(-grips[g].slip.along[k] for g in sticking), self.assembly.force[k]]
            equations.append(row)
        width = n + len(active) + len(sticking)
        for grip, side in zip(grips, mode.rubbing, strict=True):
            if side:
                self._rub(equations, grip.friction * side, grip.contact, grip.slip.terms, active)
        equations += [_equation(terms[i], n, width) for i in active]
        equations += [[*grips[g].slip.along, *([0.0] * (width - n)), 0.0] for g in sticking]
        return solve_symbolic(equations, n, active, sticking)

    def _rub(
        self,
        equations: list[list[Number]],
        weight: float,
        contact: int,
        slip: tuple[tuple[int, float], ...],
        active: list[int],
    ) -> None:
        """Add the kinetic friction −µN of a contact, with N from its own equation, to the equations of motion."""
        lift = [*self.assembly.lifted[contact], *(self.rows[i].lift.get(contact, 0.0) for i in active)]
        for k, part in slip:
            factor = weight * part
            row = equations[k]
            for column, entry in enumerate(lift):
                row[column] = row[column] + factor * entry
            row[-1] = row[-1] + factor * self.assembly.press[contact]

    def _normals(self, found: Unknowns) -> list[Number]:
        assembly = self.assembly
        normal: list[Number] = []
        for contact in range(self.system.count):
            total: Number = -1.0 * assembly.press[contact]
            for entry, x in zip(assembly.lifted[contact], found.x, strict=True):
                total = total + entry * x
            for number, force in found.rows.items():
                total = total + self.rows[number].lift.get(contact, 0.0) * force
            normal.append(total)
        return normal

    def _friction(self, mode: ContactMode, found: Unknowns, normal: list[Number]) -> list[Number]:
        friction: list[Number] = [0.0] * self.system.count
        for number, (grip, side) in enumerate(zip(self.system.grips, mode.rubbing, strict=True)):
            along = found.friction[number] if side == 0 else -grip.friction * side * normal[grip.contact]
            friction[grip.contact] = along
        return friction

    # ---- margins

    def _watched(
        self, mode: ContactMode, rows: list[Number], normal: list[Number], friction: list[Number]
    ) -> list[tuple[Margin, Number]]:
        system = self.system
        margins = list(chain(self._row_margins(mode, rows), self._contact_margins(mode, normal, friction)))
        for number, (meeting, stuck) in enumerate(zip(system.mechanism.meetings, self.phase.stuck, strict=True)):
            if not stuck:
                margins.append((Margin("gap", number), self.assembly.separation(meeting).gap))
        kept = self._kept_segments(mode)
        for number, (first, last) in enumerate(system.runs):
            if (first, last) not in kept:
                margins.append((Margin("reach", number), self._distance(first, last)))
        for number, limit in enumerate(system.limits):
            margins.append((Margin("limit", number), limit.initial_travel + limit.sign * self.q[limit.coordinate]))
        for number, burning in enumerate(self.phase.burning):
            if burning:
                margins.append((Margin("burn", number), system.mechanism.burns[number].until - self.time))
        return [*margins, *self._strains(), *self._borders()]

    def _strains(self) -> list[tuple[Margin, Number]]:
        """Return the deformations of one-sided springs beyond the point at which they begin or cease to act, m."""
        margins: list[tuple[Margin, Number]] = []
        halves = zip(self.system.mechanism.half_springs, self.phase.strained, strict=True)
        for number, ((line, law), strained) in enumerate(halves):
            side = law.side if strained else -law.side
            margins.append((Margin("strain", number), side * (self.assembly.length(line).value - law.length)))
        return margins

    def _row_margins(self, mode: ContactMode, rows: list[Number]) -> list[tuple[Margin, Number]]:
        margins: list[tuple[Margin, Number]] = []
        for number, kind in enumerate(self.system.kinds(self.phase)):
            if kind.both:
                continue
            if mode.acting[number]:
                margins.append((Margin("force", number), rows[number]))
            else:
                margins.append((Margin("spare", number), self.rows[number].value))
        return margins

    def _contact_margins(
        self, mode: ContactMode, normal: list[Number], friction: list[Number]
    ) -> list[tuple[Margin, Number]]:
        system = self.system
        margins = [(Margin("normal", i), force) for i, force in enumerate(normal) if i not in system.guided]
        for number, (grip, side) in enumerate(zip(system.grips, mode.rubbing, strict=True)):
            if side:
                slip: Number = 0.0
                for k, part in grip.slip.terms:
                    slip = slip + side * part * self.v[k]
                margins.append((Margin("slip", number, side), slip))
            elif grip.friction < inf:
                bound = grip.holds * normal[grip.contact]
                if grip.both:
                    bound = grip.holds * self.tape.sqrt(normal[grip.contact] * normal[grip.contact])
                margins.append((Margin("grip", number, 1), bound + friction[grip.contact]))
                margins.append((Margin("grip", number, -1), bound - friction[grip.contact]))
        return margins

    def _kept_segments(self, mode: ContactMode) -> set[tuple[str, ...]]:
        """Return the ends of the segments that are whole acting constraints and so have a constant length."""
        known = self.system.mechanism.line
        acting = [kind.name for kind, acts in zip(self.system.kinds(self.phase), mode.acting, strict=True) if acts]
        lines = [known[name] for name in acting if name in known]
        return {line.through for line in lines if not line.wheels}

    def _passing(self, watched: list[tuple[Margin, Number]]) -> dict[int, Number]:
        """Return Δr·Δv of each pair of line ends that may pass each other; it is zero at their nearest approach."""
        runs, frames = list(self.system.runs), self.assembly.frames
        passing: dict[int, Number] = {}
        for index, (margin, _) in enumerate(watched):
            if (
                margin.kind == "reach"
                and constant_direction(self.system.mechanism, self.system.frames, *runs[margin.number]) is None
            ):
                one, other = (frames.site(name) for name in runs[margin.number])
                passing[index] = dot(
                    subtract_triples(other.place, one.place), subtract_triples(other.velocity, one.velocity)
                )
        return passing

    def _distance(self, first: str, last: str) -> Number:
        """Return the distance of two sites, m; negative after they have passed through each other on a line."""
        one, other = self.assembly.frames.site(first).place, self.assembly.frames.site(last).place
        direction = constant_direction(self.system.mechanism, self.system.frames, first, last)
        total: Number = 0.0
        for number, (a, b) in enumerate(zip(one, other, strict=True)):
            difference = b - a
            total = total + (difference * difference if direction is None else difference * direction[number])
        return self.tape.sqrt(total) - PASSING_DISTANCE if direction is None else total - COINCIDENCE_DISTANCE

    def _borders(self) -> list[tuple[Margin, Number]]:
        margins: list[tuple[Margin, Number]] = []
        for number, force in enumerate(self.system.mechanism.forces):
            if force.region is not None:
                position = self.assembly.frames.center(force.body).place
                for side, margin in enumerate(force.region.margins(position, self.tape)):
                    inside = self.phase.inside[number][side]
                    margins.append((Margin("border", number, side), margin if inside else -margin))
        return margins


def _equation(row: RowTerms, n: int, width: int) -> list[Number]:
    return [*(row.along.get(k, 0.0) for k in range(n)), *([0.0] * (width - n)), row.target]
