"""The equations of a mechanism that change as it moves, as straight-line code: one piece for each mode.

They are recorded once on a tape; those of a mode are solved on it with pivots chosen where the mode begins. The code
runs with floats for the integrator, with arrays for all samples at once.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from itertools import chain
from math import inf
from typing import Any

from sim2reason.dsl.triples import Number
from sim2reason.simulation.engines.exact.assembly import Assembly
from sim2reason.simulation.engines.exact.dop853 import Rate
from sim2reason.simulation.engines.exact.lengths import Phase, RowTerms
from sim2reason.simulation.engines.exact.linear import Row
from sim2reason.simulation.engines.exact.margins import Margin
from sim2reason.simulation.engines.exact.problem import Mode
from sim2reason.simulation.engines.exact.symbolic import Unknowns, eliminated
from sim2reason.simulation.engines.exact.system import Instant, System
from sim2reason.simulation.engines.exact.tape import Symbol, Tape

PIVOT = 1e-6  # of its size at the beginning: a pivot that shrinks below that is lost


@dataclass(frozen=True)
class Formulas:
    """The code of one mode: rates for the integrator, all forces for samples, margins."""

    rate: Rate
    forces: Callable[[Any], Callable[..., tuple[Any, ...]]]  # of `math` or `numpy`: a, rows, normal, friction
    margins: Callable[..., tuple[float, ...]]
    watched: tuple[Margin, ...]


class CurvedEquations:
    """Equations on a tape, for each phase, and their code, for each mode."""

    def __init__(self, system: System) -> None:
        """Nothing is recorded before it is needed."""
        self.system = system
        self._recorded: dict[Phase, _Recorded] = {}

    def instant(self, time: float, q: Row, v: Row, phase: Phase) -> Instant:
        """The numbers of one instant."""
        return self.system.instant(time, q, v, phase)

    def formulas(self, instant: Instant, phase: Phase, mode: Mode) -> Formulas:
        """The code of a mode, made where it begins."""
        recorded = self._recorded.get(phase)
        if recorded is None:
            recorded = self._recorded[phase] = _Recorded(self.system, phase)
        return recorded.formulas(instant, mode)

    def forget(self, phase: Phase, mode: Mode) -> None:
        """Choose the pivots of a mode anew the next time."""
        self._recorded[phase].made.pop(mode, None)


class _Recorded:
    """The equations of one phase on a tape."""

    def __init__(self, system: System, phase: Phase) -> None:
        n = system.size
        self.system, self.phase = system, phase
        self.tape = Tape(["t", *(f"q{i}" for i in range(n)), *(f"v{i}" for i in range(n))])
        symbols = list(self.tape.inputs.values())
        self.time, self.q, self.v = symbols[0], symbols[1 : n + 1], symbols[n + 1 :]
        self.assembly = Assembly(system.mechanism, phase, (self.q, self.v, self.time), self.tape)
        self.mass = self.assembly.full_mass()
        self.rows = self.assembly.rows(system.starts)
        self.made: dict[Mode, Formulas] = {}

    def formulas(self, instant: Instant, mode: Mode) -> Formulas:
        """The code of a mode, made at an instant if it is new."""
        if mode not in self.made:
            self.tape.stand([instant.time, *instant.q, *instant.v])
            self.made[mode] = self._formulas(mode)
        return self.made[mode]

    def _formulas(self, mode: Mode) -> Formulas:
        tape = self.tape
        found = self._solved(mode)
        normal = self._normals(found)
        friction = self._friction(mode, found, normal)
        rows = [found.rows.get(number, 0.0) for number in range(len(self.rows))]
        guards = [(pivot, PIVOT * abs(pivot.value)) for pivot in found.pivots if isinstance(pivot, Symbol)]
        rate = tape.code([*self.v, *found.x], guards)(math)
        forces = tape.code([*found.x, *rows, *normal, *friction])
        watched = self._watched(mode, rows, normal, friction)
        margins = tape.code([number for _, number in watched])(math)
        return Formulas(rate, forces, margins, tuple(margin for margin, _ in watched))

    # ---- one mode, solved

    def _solved(self, mode: Mode) -> Unknowns:
        """Accelerations, multipliers of acting rows, and friction of contacts that stick."""
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
        return eliminated(equations, n, active, sticking)

    def _rub(
        self,
        equations: list[list[Number]],
        weight: float,
        contact: int,
        slip: tuple[tuple[int, float], ...],
        active: list[int],
    ) -> None:
        """Friction −µN along a slip, with N as its own row of the equations gives it."""
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

    def _friction(self, mode: Mode, found: Unknowns, normal: list[Number]) -> list[Number]:
        friction: list[Number] = [0.0] * self.system.count
        for number, (grip, side) in enumerate(zip(self.system.grips, mode.rubbing, strict=True)):
            along = found.friction[number] if side == 0 else -grip.friction * side * normal[grip.contact]
            friction[grip.contact] = along
        return friction

    # ---- margins

    def _watched(
        self, mode: Mode, rows: list[Number], normal: list[Number], friction: list[Number]
    ) -> list[tuple[Margin, Number]]:
        system = self.system
        found = list(chain(self._row_margins(mode, rows), self._contact_margins(mode, normal, friction)))
        for number, (meeting, stuck) in enumerate(zip(system.mechanism.meetings, self.phase.stuck, strict=True)):
            if not stuck:
                found.append((Margin("gap", number), self.assembly.separation(meeting).gap))
        for number, (first, last) in enumerate(system.runs):
            if not self._keeps(mode, first, last):
                found.append((Margin("reach", number), self._distance(first, last)))
        for number, limit in enumerate(system.limits):
            found.append((Margin("limit", number), limit.room + limit.sign * self.q[limit.coordinate]))
        for number, burning in enumerate(self.phase.burning):
            if burning:
                found.append((Margin("burn", number), system.mechanism.burns[number].until - self.time))
        return [*found, *self._borders()]

    def _row_margins(self, mode: Mode, rows: list[Number]) -> list[tuple[Margin, Number]]:
        found: list[tuple[Margin, Number]] = []
        for number, kind in enumerate(self.system.kinds(self.phase)):
            if kind.both:
                continue
            if mode.acting[number]:
                found.append((Margin("force", number), rows[number]))
            else:
                found.append((Margin("spare", number), self.rows[number].value))
        return found

    def _contact_margins(self, mode: Mode, normal: list[Number], friction: list[Number]) -> list[tuple[Margin, Number]]:
        system = self.system
        found = [(Margin("normal", i), force) for i, force in enumerate(normal) if i not in system.guided]
        for number, (grip, side) in enumerate(zip(system.grips, mode.rubbing, strict=True)):
            if side:
                slip: Number = 0.0
                for k, part in grip.slip.terms:
                    slip = slip + side * part * self.v[k]
                found.append((Margin("slip", number, side), slip))
            elif grip.friction < inf:
                bound = grip.friction * normal[grip.contact]
                if grip.both:
                    bound = grip.friction * self.tape.sqrt(normal[grip.contact] * normal[grip.contact])
                found.append((Margin("grip", number, 1), bound + friction[grip.contact]))
                found.append((Margin("grip", number, -1), bound - friction[grip.contact]))
        return found

    def _keeps(self, mode: Mode, first: str, last: str) -> bool:
        """Whether a run keeps its length, since a row that acts consists of it alone."""
        known = self.system.mechanism.line
        acting = [kind.name for kind, acts in zip(self.system.kinds(self.phase), mode.acting, strict=True) if acts]
        lines = [known[name] for name in acting if name in known]
        return any(line.through == (first, last) and not line.wheels for line in lines)

    def _distance(self, first: str, last: str) -> Number:
        one, other = self.assembly.frames.site(first).place, self.assembly.frames.site(last).place
        total: Number = 0.0
        for a, b in zip(one, other, strict=True):
            apart = b - a
            total = total + apart * apart
        return self.tape.sqrt(total)

    def _borders(self) -> list[tuple[Margin, Number]]:
        found: list[tuple[Margin, Number]] = []
        for number, force in enumerate(self.system.mechanism.forces):
            if force.region is not None:
                place = self.assembly.frames.center(force.body).place
                for side, margin in enumerate(force.region.margins(place, self.tape)):
                    inside = self.phase.inside[number][side]
                    found.append((Margin("border", number, side), margin if inside else -margin))
        return found


def _equation(row: RowTerms, n: int, width: int) -> list[Number]:
    return [*(row.along.get(k, 0.0) for k in range(n)), *([0.0] * (width - n)), row.target]
