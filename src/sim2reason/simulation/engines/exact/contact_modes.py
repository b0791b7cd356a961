"""Search for the contact mode (active constraints, sticking and sliding contacts) of forces or impulses.

Starting from a guess, the linear system of a mode is solved and violated conditions are flipped until none is
violated; if the iteration cycles, all modes are tried in order. See `problem` for the equations.
"""

from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import product
from math import prod

from sim2reason.errors import SimulationError
from sim2reason.simulation.engines.exact.linear import (
    ContactMode,
    Forces,
    LinearSolution,
    Problem,
    RoughContact,
    Row,
    Solution,
    dot,
    solve,
    total,
)
from sim2reason.simulation.engines.exact.native import core
from sim2reason.simulation.engines.exact.redundant_supports import admissible_forces

ZERO_RTOL = 1e-10  # fraction of the largest load or velocity: values below count as zero
FLIPS = 40  # iterations of the search before all modes are tried
MODES = 2000  # largest number of modes for an exhaustive search
EVALUATION, BEARING = 2_000, 50_000  # least operations of one mode and of a search for alternative forces
ARTIFICIAL_MASS_RATIO = (
    1e-6  # fraction of the largest mass: artificial mass of a massless unsupported body during the search
)


class NoForcesError(SimulationError):
    """An error if no contact mode is consistent; the caller adds the names of the rough contacts."""


@dataclass(slots=True)
class Flips:
    """The changes of a contact mode that correct the violations of a solution."""

    rows: list[int] = field(default_factory=list[int])
    rubbing: list[tuple[int, int]] = field(default_factory=list[tuple[int, int]])

    def count(self) -> int:
        """Return the number of changes of rows and contacts."""
        return len(self.rows) + len(self.rubbing)

    def apply(self, mode: ContactMode) -> ContactMode:
        """Return the contact mode with all changes applied."""
        acting, rubbing = list(mode.acting), list(mode.rubbing)
        for number in self.rows:
            acting[number] = not acting[number]
        for number, side in self.rubbing:
            rubbing[number] = side
        return ContactMode(tuple(acting), tuple(rubbing))

    def each(self) -> Iterator["Flips"]:
        """Yield, for each change, a `Flips` object with that change alone."""
        yield from (Flips([number], []) for number in self.rows)
        yield from (Flips([], [pair]) for pair in self.rubbing)


def search(problem: Problem, guess: ContactMode) -> Solution:
    """Return the first consistent solution, starting from a guess of the contact mode.

    Normal forces may come out negative: the caller then ends the motion. Friction has no law for them, so only
    if no mode is consistent is friction let off where the normal force is negative.

    Raises:
        NoForcesError: no mode is consistent, as can happen with strong friction.
    """
    solution = _searched(problem, guess, lenient=False) or _searched(problem, guess, lenient=True)
    if solution is None:
        raise NoForcesError("no forces are consistent with the strings and rough contacts")
    return solution


def _searched(problem: Problem, guess: ContactMode, *, lenient: bool) -> Solution | None:
    attempted: set[ContactMode] = set()
    mode = follow_leaders(problem, guess)
    for _ in range(FLIPS):
        solution = evaluate(problem, mode)
        if solution.consistent and solution.obeys and not lenient:
            return solution
        flips = _flips(problem, solution, lenient=lenient)
        if solution.consistent and not flips.count():
            return solution
        attempted.add(mode)
        candidates = (follow_leaders(problem, each.apply(mode)) for each in (flips, *flips.each()))
        fresh = next((candidate for candidate in candidates if candidate not in attempted), None)
        if fresh is None:
            break
        mode = fresh
    return _exhausted(problem, attempted, lenient=lenient)


def follow_leaders(problem: Problem, mode: ContactMode) -> ContactMode:
    """Return the mode with two-sided rows acting, and each row that follows another acting if the other does."""
    if not any(problem.held):
        return mode
    acting = list(mode.acting)
    for number, leader in enumerate(problem.follows):
        acting[number] = acting[leader] if leader >= 0 else acting[number] or problem.held[number]
    return ContactMode(tuple(acting), mode.rubbing)


def _exhausted(problem: Problem, attempted: set[ContactMode], *, lenient: bool) -> Solution | None:
    """Return the first consistent solution among all untried contact modes; None if none or if there are too many."""
    choices: list[tuple[int, ...]] = [(True,) if two_sided else (True, False) for two_sided in problem.held]
    choices += [
        (0,) if grip.never else (side,) if side else (0, 1, -1)
        for grip, side in zip(problem.grips, problem.sliding, strict=True)
    ]
    if prod(map(len, choices)) > MODES:
        return None
    for choice in product(*choices):
        acting, rubbing = choice[: len(problem.rows)], choice[len(problem.rows) :]
        mode = follow_leaders(problem, ContactMode(tuple(map(bool, acting)), tuple(rubbing)))
        if mode in attempted:
            continue
        solution = evaluate(problem, mode)
        if solution.consistent and not _flips(problem, solution, lenient=lenient).count():
            return solution
    return None


def evaluate(problem: Problem, mode: ContactMode) -> Solution:
    """Return the accelerations and forces of one contact mode, whether or not they obey its inequalities."""
    n = len(problem.force)
    active = [number for number, acts in enumerate(mode.acting) if acts]
    problem.budget.spend(EVALUATION + (n + len(active)) ** 3)
    linear_solution, forces, obeys = _solved(problem, mode, active, 0.0)
    nulls = linear_solution.nulls
    loose = bool(nulls) and any(any(abs(part) > ZERO_RTOL for part in null[:n]) for null in nulls)
    if loose:
        faint = ARTIFICIAL_MASS_RATIO * (
            max((row[number] for number, row in enumerate(problem.mass)), default=0.0) or 1.0
        )
        linear_solution, forces, obeys = _solved(problem, mode, active, faint)
    x = linear_solution.x[:n]
    spare = [
        _forces(problem, mode, [0.0] * n, _spread(null[n:], active, len(mode.acting)), 0.0)
        for null in linear_solution.nulls
    ]
    solution = Solution(mode, x, forces, spare, loose, linear_solution.consistent, obeys)
    if not spare or loose or not linear_solution.consistent or not _flips(problem, solution).count():
        return solution
    problem.budget.spend(BEARING)
    better = admissible_forces(problem, mode, x)
    if better is None:
        return solution
    rows, friction = better
    sticking_forces = [
        value for grip, side, value in zip(problem.grips, mode.rubbing, friction, strict=True) if _extra(grip, side)
    ]
    acting = _spread([*rows, *sticking_forces], active, len(mode.acting))
    return Solution(mode, x, _forces(problem, mode, x, acting, 1.0), spare, loose)


def _solved(
    problem: Problem, mode: ContactMode, active: list[int], faint: float
) -> tuple[LinearSolution, Forces, bool | None]:
    """Return the solution of a mode's equations, its forces, and whether these obey the mode; None if not checked."""
    if core is not None:
        x, nulls, consistent, forces, obeys = core.evaluate_mode(problem, mode.acting, mode.rubbing, faint)
        return LinearSolution(x, nulls, consistent), Forces(*forces), obeys
    found, n = solve(_system(problem, mode, active, faint)), len(problem.force)
    acting = _spread(found.x[n:], active, len(mode.acting))
    return found, _forces(problem, mode, found.x[:n], acting, 1.0), None


def _extra(grip: RoughContact, side: int) -> bool:
    """Return whether a contact's friction is an extra unknown: it sticks, and its slip has several coordinates."""
    return side == 0 and grip.coordinate < 0


def _system(problem: Problem, mode: ContactMode, active: list[int], faint: float) -> list[Row]:
    """Return the equations for accelerations x, multipliers λ of acting rows, and some friction; right side last.

    If the slip of a sticking contact depends on one coordinate only, the equation of motion of that coordinate gives
    its friction and is replaced by the condition of zero slip.
    """
    rows = problem.rows
    sticking_grips = [grip for grip, side in zip(problem.grips, mode.rubbing, strict=True) if _extra(grip, side)]
    columns = [rows[number].along for number in active] + [[-part for part in g.slip.along] for g in sticking_grips]
    system = [[*mass, *[column[k] for column in columns], problem.force[k]] for k, mass in enumerate(problem.mass)]
    if faint:
        for k, row in enumerate(system):
            row[k] += faint
    blank = [0.0] * (len(active) + len(sticking_grips))
    for grip, side in zip(problem.grips, mode.rubbing, strict=True):
        if side == 0:
            if grip.coordinate >= 0:
                system[grip.coordinate] = [*grip.slip.along, *blank, 0.0]
            continue
        # f = −µN, with N as its own row of the equations of motion gives it
        lift = [
            *problem.lifted[grip.contact],
            *(rows[i].lift[grip.contact] for i in active),
            *([0.0] * len(sticking_grips)),
        ]
        lift.append(problem.press[grip.contact])
        for k, part in grip.slip.terms:
            weight = grip.friction * side * part
            system[k] = [a + weight * b for a, b in zip(system[k], lift, strict=True)]
    system.extend([*rows[number].along, *blank, problem.targets[number]] for number in active)
    system.extend([*grip.slip.along, *blank, 0.0] for grip in sticking_grips)
    return system


def _spread(values: Row, active: list[int], size: int) -> Row:
    """Expand Lagrange multipliers of the active constraints to all `size` constraints, zero for inactive ones.

    Values beyond those of active constraints, such as static friction, follow unchanged.
    """
    spread = [0.0] * size
    for number, value in zip(active, values, strict=False):
        spread[number] = value
    return [*spread, *values[len(active) :]]


def _forces(problem: Problem, mode: ContactMode, x: Row, multipliers: Row, load: float) -> Forces:
    """Return constraint, friction and normal forces from accelerations and multipliers; `load` 0 omits the loads."""
    count = len(problem.rows)
    acting, sticking_forces = multipliers[:count], iter(multipliers[count:])
    pulls = [(value, row) for value, row in zip(acting, problem.rows, strict=True) if value != 0.0]
    normal = [
        dot(mass, x) - load * press + total(value * row.lift[i] for value, row in pulls)
        for i, (mass, press) in enumerate(zip(problem.lifted, problem.press, strict=True))
    ]
    friction: Row = []
    for grip, side in zip(problem.grips, mode.rubbing, strict=True):
        k = grip.coordinate
        if side:
            friction.append(-grip.friction * side * normal[grip.contact])
        elif k < 0:
            friction.append(next(sticking_forces))
        else:
            needed = dot(problem.mass[k], x) - load * problem.force[k]
            friction.append(needed + total(value * row.along[k] for value, row in pulls))
    return Forces(acting, friction, normal)


def scales(problem: Problem, x: Row) -> tuple[float, float]:
    """Return the thresholds below which a force, and an acceleration or velocity (an entry of x), count as zero."""
    size = max(max(map(abs, x), default=0.0), max(map(abs, problem.targets), default=0.0), 1.0)
    return ZERO_RTOL * max(problem.load, 1e-3), ZERO_RTOL * size


def _flips(problem: Problem, solution: Solution, *, lenient: bool = False) -> Flips:
    flips = Flips()
    mode, x = solution.mode, solution.x
    small_force, small_x = scales(problem, x)
    for number, (acts, row) in enumerate(zip(mode.acting, problem.rows, strict=True)):
        if problem.held[number]:
            continue
        if acts:
            violated = solution.forces.rows[number] < -small_force
        else:
            violated = row.rate(x) - problem.targets[number] > small_x
        if violated:
            flips.rows.append(number)
    for number, (grip, side) in enumerate(zip(problem.grips, mode.rubbing, strict=True)):
        friction, normal = solution.forces.friction[number], solution.forces.normal[grip.contact]
        if grip.never or problem.sliding[number] or (lenient and normal < -small_force):
            continue
        if grip.both:
            normal = abs(normal)
        if side == 0 and abs(friction) > grip.holds * normal + small_force:
            flips.rubbing.append((number, -1 if friction > 0.0 else 1))
        elif side and side * grip.slip.rate(x) < -small_x:
            flips.rubbing.append((number, 0))
    return flips


def count_resting_as_acting(problem: Problem, solution: Solution, small_x: float) -> Solution:
    """Return the solution with every constraint at rest counted as acting and every contact at rest as sticking.

    Accelerations up to `small_x` count as zero. Its `spare` then lists the force patterns that the motion does not
    determine.
    """
    if all(solution.mode.acting) and not any(solution.mode.rubbing):
        return solution
    acting = tuple(
        acts or abs(row.rate(solution.x) - target) <= small_x
        for acts, row, target in zip(solution.mode.acting, problem.rows, problem.targets, strict=True)
    )
    rubbing = tuple(
        side if problem.sliding[number] or abs(grip.slip.rate(solution.x)) > small_x else 0
        for number, (grip, side) in enumerate(zip(problem.grips, solution.mode.rubbing, strict=True))
    )
    mode = follow_leaders(problem, ContactMode(acting, rubbing))
    return solution if mode == solution.mode else evaluate(problem, mode)
