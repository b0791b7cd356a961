"""Search for the consistent contact mode of rows, faces and friction at an instant.

Modes are tried in the order of the number of changes from a guess. Forces and impulses are the same problem, for
accelerations and for velocities after an impact. Rows pull or push one way, faces press or separate, friction sticks
or is µN.
"""

from collections.abc import Iterator
from itertools import combinations, islice

from sim2reason.errors import SimulationError
from sim2reason.simulation.engines.mujoco.forces import (
    UNLIMITED_FRICTION,
    ContactMode,
    ForceProblem,
    ForceSolution,
    solve_mode,
)

ZERO_RTOL = 1e-9  # fraction of the largest load or acceleration: smaller values count as zero
MAX_MODES = 4000  # largest number of contact modes to try
MAX_CORRECTIONS = 30  # largest number of modes tried by correcting violated conditions

Change = tuple[str, int, int]
"""A change of a contact mode: ``rows``, ``faces`` or ``rubbing``, the index, and the new state."""


def search(instant: ForceProblem, guess: ContactMode) -> ForceSolution:
    """Return the solution of the consistent contact mode nearest to a guess; raise SimulationError if none exists."""
    start = _admissible(instant, guess)
    found = _repair(instant, start)
    if found is None:
        every = (_consistent(instant, mode) for mode in islice(_modes(instant, guess), MAX_MODES))
        found = next((each for each in every if each is not None), None)
    if found is None:
        raise SimulationError("MuJoCo: no forces are consistent with the strings and rough contacts")
    least = _least_changed(instant, start, found)
    if least == found.mode:
        instant.spend(least)
        return found
    return _consistent(instant, least) or found


def _consistent(instant: ForceProblem, mode: ContactMode) -> ForceSolution | None:
    """Return the solution of a contact mode if it is consistent, else None."""
    found = solve_mode(instant, mode)
    return None if found is None or _corrections(instant, found) else found


def _least_changed(instant: ForceProblem, start: ContactMode, found: ForceSolution) -> ContactMode:
    """Return the mode of a solution without changes from `start` that have no observable effect."""
    small, mode = _smallest_rate(instant, found), found.mode
    rates = [float(row.dot(found.x)) - target for row, target in zip(instant.rows, instant.targets, strict=True)]
    rows = [acts or (was and abs(rate) <= small) for acts, was, rate in zip(mode.rows, start.rows, rates, strict=True)]
    faces = [shut or abs(found.x[rise]) <= small for shut, rise in zip(mode.faces, instant.faces.rises, strict=True)]
    slips = [abs(float(slip.dot(found.x))) > small for slip in instant.faces.slips]
    rubbing = [
        was if not slid and not moves else side
        for was, side, slid, moves in zip(start.rubbing, mode.rubbing, instant.sliding, slips, strict=True)
    ]
    return _link_followers(instant, ContactMode(tuple(rows), tuple(faces), tuple(rubbing)))


def _smallest_rate(instant: ForceProblem, found: ForceSolution) -> float:
    """Return the acceleration, or velocity in an impact, below which values count as zero."""
    return ZERO_RTOL * max(1.0, *map(abs, found.x.tolist()), *map(abs, instant.targets))


def _repair(instant: ForceProblem, mode: ContactMode) -> ForceSolution | None:
    """Return a consistent solution found by correcting violated conditions repeatedly; None if this cycles."""
    tried: set[ContactMode] = set()
    while len(tried) < MAX_CORRECTIONS:
        found = solve_mode(instant, mode)
        wrong = _corrections(instant, found) if found is not None else ()
        if found is not None and not wrong:
            return found
        tried.add(mode)
        steps = (wrong, *((one,) for one in wrong))
        fresh = (_link_followers(instant, _changed(mode, step)) for step in steps if step)
        following = next((other for other in fresh if other not in tried), None)
        if following is None:
            return None
        mode = following
    return None


def _modes(instant: ForceProblem, guess: ContactMode) -> Iterator[ContactMode]:
    """Yield all contact modes, those with the fewest changes first."""
    free = [
        number
        for number, ok in enumerate(instant.allowed)
        if ok and not instant.both[number] and instant.follows[number] < 0
    ]
    rough = [
        i for i, mu in enumerate(instant.faces.friction) if 0.0 < mu < UNLIMITED_FRICTION and not instant.sliding[i]
    ]
    faces = [i for i, held in enumerate(instant.faces.guided) if not held]
    start = _admissible(instant, guess)
    changes: list[Change] = [("rows", i, not start.rows[i]) for i in free]
    changes += [("rubbing", i, side) for i in rough for side in (0, 1, -1) if side != start.rubbing[i]]
    changes += [("faces", i, not start.faces[i]) for i in faces]
    for count in range(len(changes) + 1):
        for chosen in combinations(changes, count):
            places = [(kind, i) for kind, i, _ in chosen]
            if len(set(places)) == len(places):
                yield _link_followers(instant, _changed(start, chosen))


def _admissible(instant: ForceProblem, guess: ContactMode) -> ContactMode:
    """Return the contact mode `guess` with disallowed rows idle, two-sided rows acting, and sliding faces slipping."""
    rows = tuple(
        (acts or both) and ok for acts, both, ok in zip(guess.rows, instant.both, instant.allowed, strict=True)
    )
    rubbing = tuple(side or was for side, was in zip(instant.sliding, guess.rubbing, strict=True))
    return _link_followers(instant, ContactMode(rows, guess.faces, rubbing))


def _changed(mode: ContactMode, changes: tuple[Change, ...]) -> ContactMode:
    parts: dict[str, list[int]] = {"rows": [*mode.rows], "faces": [*mode.faces], "rubbing": [*mode.rubbing]}
    for kind, number, value in changes:
        parts[kind][number] = value
    return ContactMode(tuple(map(bool, parts["rows"])), tuple(map(bool, parts["faces"])), tuple(parts["rubbing"]))


def _link_followers(instant: ForceProblem, mode: ContactMode) -> ContactMode:
    rows = tuple(
        mode.rows[leader] if leader >= 0 else acts for acts, leader in zip(mode.rows, instant.follows, strict=True)
    )
    return mode._replace(rows=rows)


def _corrections(instant: ForceProblem, found: ForceSolution) -> tuple[Change, ...]:
    """Return the changes that correct the violated conditions of a solution; empty if it is consistent."""
    mode = found.mode
    force = ZERO_RTOL * max(1e-3, *map(abs, instant.loads.tolist()))
    small = _smallest_rate(instant, found)
    wrong: list[Change] = []
    for i, acts in enumerate(mode.rows):
        if instant.both[i] or not instant.allowed[i]:
            continue
        over = float(instant.rows[i].dot(found.x)) - instant.targets[i]
        if found.rows[i] < -force if acts else over > small:
            wrong.append(("rows", i, not acts))
    for i, shut in enumerate(mode.faces):
        if (shut and not instant.faces.guided[i] and found.normal[i] < -force) or (
            not shut and found.x[instant.faces.rises[i]] < -small
        ):
            wrong.append(("faces", i, not shut))
        elif instant.faces.friction[i] > 0.0 and shut:
            wrong += _friction_corrections(instant, found, i, force, small)
    return tuple(wrong)


def _friction_corrections(
    instant: ForceProblem, found: ForceSolution, i: int, force: float, small: float
) -> list[Change]:
    """Return the changes of the friction of a rough face that correct its violated condition."""
    if instant.faces.friction[i] >= UNLIMITED_FRICTION:
        return []
    side, held = found.mode.rubbing[i], float(found.friction[i])
    if side == 0:
        too_much = abs(held) > instant.faces.holds[i] * abs(found.normal[i]) + force
        return [("rubbing", i, -1 if held > 0.0 else 1)] if too_much else []
    back = not instant.sliding[i] and side * float(instant.faces.slips[i].dot(found.x)) < -small
    return [("rubbing", i, 0)] if back else []


def all_acting(rows: int, faces: int) -> ContactMode:
    """Return the contact mode in which all constraints act and all contacts stick."""
    return ContactMode((True,) * rows, (True,) * faces, (0,) * faces)
