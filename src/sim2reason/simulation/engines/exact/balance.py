"""The forces of one instant: which strings pull, which contacts hold, and what the mechanism leaves open."""

from dataclasses import dataclass
from math import nan

from sim2reason.simulation.engines.exact.contact_modes import Forces, Mode, Problem, Solution, scales, search, stiffest
from sim2reason.simulation.engines.exact.equations import Equations
from sim2reason.simulation.engines.exact.linear import Row, solve
from sim2reason.simulation.engines.exact.separations import lifted

FAINT = 1e-9  # an entry of a force pattern that is not there


@dataclass(frozen=True, slots=True)
class Balance:
    """Acceleration, multipliers and mode; of all strings and all contacts."""

    a: Row
    tension: Row
    normal: Row
    friction: Row
    mode: Mode
    lifted: tuple[int, ...]  # the contacts that come apart
    loose: bool  # a massless part that no force holds


def balance(system: Equations, v: Row, tight: list[int], guess: Mode) -> Balance:
    """Find the forces at given velocities.

    Args:
        system: the mechanism.
        v: the velocities.
        tight: the strings at full length that do not shorten: only they may pull.
        guess: the mode just before, of all strings and all rough contacts.
    """
    sliding = tuple((v[grip.coordinate] > 0.0) - (v[grip.coordinate] < 0.0) for grip in system.grips)
    problem = Problem(
        system.mass,
        system.lifted,
        system.force,
        system.press,
        tuple(system.strings[number] for number in tight),
        [0.0] * len(tight),
        system.grips,
        sliding,
    )
    start = Mode(
        tuple(guess.acting[number] for number in tight),
        tuple(now or before for now, before in zip(sliding, guess.rubbing, strict=True)),
    )
    found = search(problem, start)
    open_ended = _open(stiffest(problem, found).spare, found.forces)
    small, small_x = scales(problem, found.x)
    loose = found.loose or _unheld(system, problem, found, open_ended, small)
    away = lifted(system, problem, found, small)
    return _spread(system, tight, found, _kept(problem, found, start, small_x), open_ended, away, loose=loose)


def _kept(problem: Problem, found: Solution, before: Mode, small: float) -> Mode:
    """The mode found, less the changes that nothing shows.

    A string that was taut stays so under no tension while its ends do not come together, and a contact at rest
    that is not accelerated sticks, though of forces that are not determined some let it slide at no speed.
    """
    acting, rubbing = found.mode
    for number, acts in enumerate(acting):
        if before.acting[number] and not acts and abs(problem.rows[number].rate(found.x)) <= small:
            acting = (*acting[:number], True, *acting[number + 1 :])
    for number, side in enumerate(rubbing):
        if side and not problem.sliding[number] and abs(found.x[problem.grips[number].coordinate]) <= small:
            rubbing = (*rubbing[:number], 0, *rubbing[number + 1 :])
    return Mode(acting, rubbing)


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


def _unheld(system: Equations, problem: Problem, found: Solution, forces: Forces, small: float) -> bool:
    """Whether some massless part is held by nothing, or only by strings that do not pull."""
    if not system.weightless:
        return False
    holding = [
        [row.rate(motion) for motion in system.weightless]
        for row, force in zip(problem.rows, forces.rows, strict=True)
        if not force <= small  # also NaN
    ]
    holding += [
        [motion[grip.coordinate] for motion in system.weightless]
        for grip, side in zip(problem.grips, found.mode.rubbing, strict=True)
        if side == 0
    ]
    return not holding or bool(solve([[*row, 0.0] for row in holding]).nulls)


def _spread(
    system: Equations,
    tight: list[int],
    found: Solution,
    kept: Mode,
    forces: Forces,
    away: tuple[int, ...],
    *,
    loose: bool,
) -> Balance:
    """From the strings and contacts that took part to all of them."""
    tension, acting = [0.0] * len(system.strings), [False] * len(system.strings)
    for number, force, acts in zip(tight, forces.rows, kept.acting, strict=True):
        tension[number], acting[number] = _clipped(force), acts
    friction = [0.0] * len(system.press)
    for grip, force in zip(system.grips, forces.friction, strict=True):
        friction[grip.contact] = 0.0 if found.forces.normal[grip.contact] < 0.0 else force
    mode = Mode(tuple(acting), kept.rubbing)
    return Balance(found.x, tension, [_clipped(force) for force in forces.normal], friction, mode, away, loose)


def _clipped(force: float) -> float:
    """Rounding may leave a force that can't push a hair below zero."""
    return max(force, 0.0)
