"""The forces and accelerations at one instant, and the contacts that separate there."""

from dataclasses import dataclass, replace
from math import nan

from sim2reason.simulation.engines.exact.contact_modes import (
    NoForcesError,
    count_resting_as_acting,
    follow_leaders,
    scales,
    search,
)
from sim2reason.simulation.engines.exact.lengths import RowKind
from sim2reason.simulation.engines.exact.linear import (
    ContactMode,
    Forces,
    Gradient,
    Problem,
    Row,
    Solution,
    gradient,
    solve,
)
from sim2reason.simulation.engines.exact.system import Instant, System

SEPARATION_RTOL = 1e-9  # fraction of the largest velocity or acceleration: a separating contact opens faster than this
MAX_PIVOTS = 64  # sets of separating contacts tried before the contact with the most negative normal force is returned


def separating_contacts(problem: Problem, heave: list[Row], solution: Solution, small: float) -> tuple[int, ...]:
    """Return the indices of the contacts that separate, in order; empty if no normal force is below -`small`.

    `heave` is the mass matrix of the rises alone, (c, c): Σ m n·n′ over the bodies that both carry.
    """
    if not any(force < -small for force in solution.forces.normal):
        return ()
    guided = {grip.contact for grip in problem.grips if grip.both} | set(problem.guided)
    pulled = {number for number, force in enumerate(solution.forces.normal) if force < -small and number not in guided}
    if not pulled:
        return ()
    attempted = set[frozenset[int]]()
    separating, wrong = frozenset[int](), frozenset(pulled)
    for _ in range(MAX_PIVOTS):
        flipped = separating ^ wrong
        separating = flipped if flipped not in attempted else separating ^ {max(wrong)}
        attempted.add(separating)
        try:
            rises, wrong = _rises(problem, heave, solution.mode, tuple(sorted(separating)), small)
        except NoForcesError:  # what is left closed can't rub so
            break
        wrong -= guided
        if not wrong:
            return rises
    return (min(pulled, key=solution.forces.normal.__getitem__),)


def _rises(
    problem: Problem, heave: list[Row], mode: ContactMode, separating: tuple[int, ...], small: float
) -> tuple[tuple[int, ...], frozenset[int]]:
    """Return the contacts that open if those in `separating` are free to, and the contacts that contradict this."""
    opened, kept = _opened(problem, heave, separating)
    rubbing = tuple(
        side for grip, side in zip(problem.grips, mode.rubbing, strict=True) if grip.contact not in separating
    )
    solution = search(opened, ContactMode(mode.acting, rubbing))
    threshold = SEPARATION_RTOL * max(map(abs, solution.x))
    rises = list(zip(separating, solution.x[len(problem.force) :], strict=True))
    closing = [number for number, rise in rises if rise < -threshold]
    pulled = [number for number, force in zip(kept, solution.forces.normal, strict=True) if force < -small]
    return tuple(number for number, rise in rises if rise > threshold), frozenset(closing + pulled)


def _opened(problem: Problem, heave: list[Row], separating: tuple[int, ...]) -> tuple[Problem, list[int]]:
    """Return the problem with gaps of contacts in `separating` as coordinates, and the indices of other contacts."""
    kept = [number for number in range(len(problem.press)) if number not in separating]
    new_index = {number: new for new, number in enumerate(kept)}

    def wide(numbers: list[int] | tuple[int, ...]) -> list[Row]:
        return [[*problem.lifted[i], *(heave[i][j] for j in separating)] for i in numbers]

    mass = [[*row, *(problem.lifted[j][k] for j in separating)] for k, row in enumerate(problem.mass)]
    stay = [number for number, grip in enumerate(problem.grips) if grip.contact in new_index]
    opened = replace(
        problem,
        mass=mass + wide(separating),
        lifted=wide(kept),
        force=[*problem.force, *(problem.press[j] for j in separating)],
        press=[problem.press[i] for i in kept],
        rows=tuple(_raised(row, separating, kept) for row in problem.rows),
        grips=tuple(
            replace(
                problem.grips[i],
                contact=new_index[problem.grips[i].contact],
                slip=_raised(problem.grips[i].slip, separating, kept),
            )
            for i in stay
        ),
        sliding=tuple(problem.sliding[i] for i in stay),
    )
    return opened, kept


def _raised(row: Gradient, separating: tuple[int, ...], kept: list[int]) -> Gradient:
    return gradient([*row.along, *(row.lift[j] for j in separating)], [row.lift[i] for i in kept])


ZERO_PATTERN_TOL = 1e-9  # threshold below which an entry of a force pattern counts as zero


@dataclass(slots=True)
class Balance:
    """Accelerations, constraint forces and contact mode at one instant, for all rows and contacts."""

    a: Row
    rows: Row
    normal: Row
    friction: Row
    mode: ContactMode
    lifted: tuple[int, ...]  # the contacts that separate
    loose: bool  # whether a massless part is held by no force


@dataclass(slots=True)
class ContactDemand:
    """The constraints that may act: indices of tight rows, given directions of slip, and the preceding contact mode."""

    tight: list[int]
    sliding: tuple[int, ...]
    guess: ContactMode
    kinds: list[RowKind]


def balance(system: System, instant: Instant, demand: ContactDemand) -> Balance:
    """Compute the forces and accelerations of an instant; raise NoForcesError if no consistent forces exist."""
    tight, kinds = demand.tight, demand.kinds
    new_index = {number: new for new, number in enumerate(tight)}
    loads = instant.loads
    problem = Problem(
        loads.mass,
        loads.lifted,
        loads.force,
        loads.press,
        tuple([instant.rows[number] for number in tight]),
        [instant.targets[number] for number in tight],
        system.grips,
        demand.sliding,
        tuple([kinds[number].both for number in tight]),
        tuple([new_index.get(kinds[number].follows, -1) for number in tight]),
        system.guided,
        system.budget,
    )
    guess = demand.guess
    start = ContactMode(
        tuple(guess.acting[number] for number in tight),
        tuple(now or before for now, before in zip(demand.sliding, guess.rubbing, strict=True)),
    )
    solution = search(problem, start)
    small, small_x = scales(problem, solution.x)
    open_ended = _open(count_resting_as_acting(problem, solution, small_x).spare, solution.forces)
    loose = solution.loose or _unheld(instant, problem, solution, open_ended, small)
    away = separating_contacts(problem, loads.heave, solution, small)
    kept = _kept(problem, solution, start, small_x)
    return _spread(system, demand, solution, kept, open_ended, away, loose=loose)


def _kept(problem: Problem, solution: Solution, before: ContactMode, small: float) -> ContactMode:
    """Return a solution's contact mode, but as in `before` where the difference has no observable effect.

    A string that was taut stays so under no tension while its ends do not come together, and a contact at rest that is
    not accelerated sticks, though of forces that are not determined some let it slide at no speed.
    """
    if solution.mode.acting == before.acting and not any(solution.mode.rubbing):
        return solution.mode
    acting, rubbing = list(solution.mode.acting), list(solution.mode.rubbing)
    for number, acts in enumerate(solution.mode.acting):
        if before.acting[number] and not acts:
            acting[number] = abs(problem.rows[number].rate(solution.x) - problem.targets[number]) <= small
    for number, side in enumerate(solution.mode.rubbing):
        if side and not problem.sliding[number] and abs(problem.grips[number].slip.rate(solution.x)) <= small:
            rubbing[number] = 0
    return follow_leaders(problem, ContactMode(tuple(acting), tuple(rubbing)))


def _open(spare: list[Forces], forces: Forces) -> Forces:
    """Return the constraint forces, with NaN for those that the motion does not determine."""
    if not spare:
        return forces
    return Forces(*(_masked(values, [pattern[kind] for pattern in spare]) for kind, values in enumerate(forces)))


def _masked(values: Row, patterns: list[Row]) -> Row:
    return [
        nan if any(abs(pattern[number]) > ZERO_PATTERN_TOL for pattern in patterns) else value
        for number, value in enumerate(values)
    ]


def _unheld(instant: Instant, problem: Problem, solution: Solution, forces: Forces, small: float) -> bool:
    """Return whether some massless part is held by nothing, or only by strings without tension."""
    weightless = instant.loads.weightless
    if not weightless:
        return False
    holding = [
        [row.rate(motion) for motion in weightless]
        for number, (row, force) in enumerate(zip(problem.rows, forces.rows, strict=True))
        if problem.held[number] or not force <= small  # also NaN
    ]
    holding += [
        [grip.slip.rate(motion) for motion in weightless]
        for grip, side in zip(problem.grips, solution.mode.rubbing, strict=True)
        if side == 0
    ]
    return not holding or bool(solve([[*row, 0.0] for row in holding]).nulls)


def _spread(
    system: System,
    demand: ContactDemand,
    solution: Solution,
    kept: ContactMode,
    forces: Forces,
    away: tuple[int, ...],
    *,
    loose: bool,
) -> Balance:
    """Return the solution for the active rows and contacts, extended to all rows and contacts."""
    count = len(demand.kinds)
    rows, acting = [0.0] * count, [False] * count
    for number, force, acts in zip(demand.tight, forces.rows, kept.acting, strict=True):
        rows[number], acting[number] = force if demand.kinds[number].both else _clipped(force), acts
    friction = [0.0] * system.count
    for grip, force in zip(system.grips, forces.friction, strict=True):
        friction[grip.contact] = 0.0 if solution.forces.normal[grip.contact] < 0.0 and not grip.both else force
    normal = [force if number in system.guided else _clipped(force) for number, force in enumerate(forces.normal)]
    return Balance(solution.x, rows, normal, friction, ContactMode(tuple(acting), kept.rubbing), away, loose)


def _clipped(force: float) -> float:
    """Return the force, with small negative values from round-off replaced by zero."""
    return max(force, 0.0)
