"""The forces of one instant: which rows act, which contacts hold, and what the mechanism leaves open."""

from dataclasses import dataclass
from math import nan

from sim2reason.simulation.engines.exact.contact_modes import linked, scales, search, stiffest
from sim2reason.simulation.engines.exact.lengths import RowKind
from sim2reason.simulation.engines.exact.linear import Row, solve
from sim2reason.simulation.engines.exact.problem import Forces, Mode, Problem, Solution
from sim2reason.simulation.engines.exact.separations import lifted
from sim2reason.simulation.engines.exact.system import Instant, System

FAINT = 1e-9  # an entry of a force pattern that is not there


@dataclass(slots=True)
class Balance:
    """Acceleration, multipliers and mode; of all rows and all contacts."""

    a: Row
    rows: Row
    normal: Row
    friction: Row
    mode: Mode
    lifted: tuple[int, ...]  # the contacts that come apart
    loose: bool  # a massless part that no force holds


@dataclass(slots=True)
class Demand:
    """What may act: `tight` rows, `sliding` sides that no search may change, and the mode just before."""

    tight: list[int]
    sliding: tuple[int, ...]
    guess: Mode
    kinds: list[RowKind]


def balance(system: System, instant: Instant, demand: Demand) -> Balance:
    """Find the forces; raises NoForcesError if there are none that are consistent."""
    tight, kinds = demand.tight, demand.kinds
    place = {number: new for new, number in enumerate(tight)}
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
        tuple([place.get(kinds[number].follows, -1) for number in tight]),
        system.guided,
        system.budget,
    )
    guess = demand.guess
    start = Mode(
        tuple(guess.acting[number] for number in tight),
        tuple(now or before for now, before in zip(demand.sliding, guess.rubbing, strict=True)),
    )
    found = search(problem, start)
    open_ended = _open(stiffest(problem, found).spare, found.forces)
    small, small_x = scales(problem, found.x)
    loose = found.loose or _unheld(instant, problem, found, open_ended, small)
    away = lifted(problem, loads.heave, found, small)
    kept = _kept(problem, found, start, small_x)
    return _spread(system, demand, found, kept, open_ended, away, loose=loose)


def _kept(problem: Problem, found: Solution, before: Mode, small: float) -> Mode:
    """The mode found, less the changes that nothing shows.

    A string that was taut stays so under no tension while its ends do not come together, and a contact at rest that is
    not accelerated sticks, though of forces that are not determined some let it slide at no speed.
    """
    acting, rubbing = list(found.mode.acting), list(found.mode.rubbing)
    for number, acts in enumerate(found.mode.acting):
        if before.acting[number] and not acts:
            acting[number] = abs(problem.rows[number].rate(found.x) - problem.targets[number]) <= small
    for number, side in enumerate(found.mode.rubbing):
        if side and not problem.sliding[number] and abs(problem.grips[number].slip.rate(found.x)) <= small:
            rubbing[number] = 0
    return linked(problem, Mode(tuple(acting), tuple(rubbing)))


def _open(spare: list[Forces], forces: Forces) -> Forces:
    """The multipliers, NaN where a force pattern without effect could be added."""
    if not spare:
        return forces
    return Forces(*(_masked(values, [pattern[kind] for pattern in spare]) for kind, values in enumerate(forces)))


def _masked(values: Row, patterns: list[Row]) -> Row:
    return [
        nan if any(abs(pattern[number]) > FAINT for pattern in patterns) else value
        for number, value in enumerate(values)
    ]


def _unheld(instant: Instant, problem: Problem, found: Solution, forces: Forces, small: float) -> bool:
    """Whether some massless part is held by nothing, or only by strings that do not pull."""
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
        for grip, side in zip(problem.grips, found.mode.rubbing, strict=True)
        if side == 0
    ]
    return not holding or bool(solve([[*row, 0.0] for row in holding]).nulls)


def _spread(
    system: System,
    demand: Demand,
    found: Solution,
    kept: Mode,
    forces: Forces,
    away: tuple[int, ...],
    *,
    loose: bool,
) -> Balance:
    """From the rows and contacts that took part to all of them."""
    count = len(demand.kinds)
    rows, acting = [0.0] * count, [False] * count
    for number, force, acts in zip(demand.tight, forces.rows, kept.acting, strict=True):
        rows[number], acting[number] = force if demand.kinds[number].both else _clipped(force), acts
    friction = [0.0] * system.count
    for grip, force in zip(system.grips, forces.friction, strict=True):
        friction[grip.contact] = 0.0 if found.forces.normal[grip.contact] < 0.0 and not grip.both else force
    normal = [force if number in system.guided else _clipped(force) for number, force in enumerate(forces.normal)]
    return Balance(found.x, rows, normal, friction, Mode(tuple(acting), kept.rubbing), away, loose)


def _clipped(force: float) -> float:
    """Rounding may leave a force that can't push a hair below zero."""
    return max(force, 0.0)
