"""Search for the consistent contact mode of rows, faces and friction at an instant.

Modes are tried in the order of the number of changes from a guess. Forces and impulses are the same problem, for
accelerations and for velocities after an impact. Rows pull or push one way, faces press or separate, friction sticks
or is µN.
"""

from collections.abc import Iterator
from itertools import combinations, islice

import numpy as np

from sim2reason.errors import SimulationError
from sim2reason.simulation.engines.mujoco.changing_equations.forces import (
    NEVER,
    ContactMode,
    ForceProblem,
    ForceSolution,
    solve_mode,
)

ZERO_RTOL = 1e-9  # fraction of the largest load or acceleration: smaller values count as zero
MAX_MODES = 4000  # largest number of contact modes to try
MENDS = 30  # largest number of modes tried by correcting violated conditions

Change = tuple[str, int, int]
"""A change of a contact mode: ``rows``, ``faces`` or ``rubbing``, the index, and the new state."""


def search(instant: ForceProblem, guess: ContactMode) -> ForceSolution:
    """Return the solution of the consistent contact mode nearest to a guess; raise SimulationError if none exists."""
    start = replace_rows(instant, guess)
    found = _mended(instant, start) or next(
        (each for way in islice(_ways(instant, guess), MAX_MODES) if (each := _held(instant, way)) is not None), None
    )
    if found is None:
        raise SimulationError("MuJoCo: no forces are consistent with the strings and rough contacts")
    return _held(instant, _unchanged(instant, start, found)) or found


def _held(instant: ForceProblem, way: ContactMode) -> ForceSolution | None:
    """Return the solution of a contact mode if it is consistent, else None."""
    found = solve_mode(instant, way)
    return None if found is None or _wrong(instant, found) else found


def _unchanged(instant: ForceProblem, start: ContactMode, found: ForceSolution) -> ContactMode:
    """Return the mode of a solution without changes from `start` that have no observable effect."""
    small, way = _little(instant, found), found.way
    rates = [float(row @ found.x) - target for row, target in zip(instant.rows, instant.targets, strict=True)]
    rows = [acts or (was and abs(rate) <= small) for acts, was, rate in zip(way.rows, start.rows, rates, strict=True)]
    faces = [shut or abs(found.x[rise]) <= small for shut, rise in zip(way.faces, instant.rises, strict=True)]
    slips = [abs(float(slip @ found.x)) > small for slip in instant.slips]
    rubbing = [
        was if not slid and not moves else side
        for was, side, slid, moves in zip(start.rubbing, way.rubbing, instant.sliding, slips, strict=True)
    ]
    return _linked(instant, ContactMode(tuple(rows), tuple(faces), tuple(rubbing)))


def _little(instant: ForceProblem, found: ForceSolution) -> float:
    """Return the acceleration, or velocity in an impact, below which values count as zero."""
    return ZERO_RTOL * max(
        float(np.abs(found.x).max(initial=0.0)), float(np.abs(instant.targets).max(initial=0.0)), 1.0
    )


def _mended(instant: ForceProblem, way: ContactMode) -> ForceSolution | None:
    """Return a consistent solution found by correcting violated conditions repeatedly; None if this cycles."""
    tried: set[ContactMode] = set()
    while len(tried) < MENDS:
        found = solve_mode(instant, way)
        wrong = _wrong(instant, found) if found is not None else ()
        if found is not None and not wrong:
            return found
        tried.add(way)
        steps = (wrong, *((one,) for one in wrong))
        fresh = (_linked(instant, _changed(way, step)) for step in steps if step)
        following = next((other for other in fresh if other not in tried), None)
        if following is None:
            return None
        way = following
    return None


def _ways(instant: ForceProblem, guess: ContactMode) -> Iterator[ContactMode]:
    """Yield all contact modes, those with the fewest changes first."""
    free = [
        number
        for number, ok in enumerate(instant.allowed)
        if ok and not instant.both[number] and instant.follows[number] < 0
    ]
    rough = [i for i, mu in enumerate(instant.friction) if 0.0 < mu < NEVER and not instant.sliding[i]]
    faces = [i for i, held in enumerate(instant.guided) if not held]
    start = replace_rows(instant, guess)
    changes: list[Change] = [("rows", i, not start.rows[i]) for i in free]
    changes += [("rubbing", i, side) for i in rough for side in (0, 1, -1) if side != start.rubbing[i]]
    changes += [("faces", i, not start.faces[i]) for i in faces]
    for count in range(len(changes) + 1):
        for chosen in combinations(changes, count):
            places = [(kind, i) for kind, i, _ in chosen]
            if len(set(places)) == len(places):
                yield _linked(instant, _changed(start, chosen))


def replace_rows(instant: ForceProblem, guess: ContactMode) -> ContactMode:
    """Return the contact mode `guess` with disallowed rows idle, two-sided rows acting, and sliding faces slipping."""
    rows = tuple(
        (acts or both) and ok for acts, both, ok in zip(guess.rows, instant.both, instant.allowed, strict=True)
    )
    rubbing = tuple(side or was for side, was in zip(instant.sliding, guess.rubbing, strict=True))
    return _linked(instant, ContactMode(rows, guess.faces, rubbing))


def _changed(way: ContactMode, changes: tuple[Change, ...]) -> ContactMode:
    parts: dict[str, list[int]] = {"rows": [*way.rows], "faces": [*way.faces], "rubbing": [*way.rubbing]}
    for kind, number, value in changes:
        parts[kind][number] = value
    return ContactMode(tuple(map(bool, parts["rows"])), tuple(map(bool, parts["faces"])), tuple(parts["rubbing"]))


def _linked(instant: ForceProblem, way: ContactMode) -> ContactMode:
    rows = tuple(
        way.rows[leader] if leader >= 0 else acts for acts, leader in zip(way.rows, instant.follows, strict=True)
    )
    return replace_tuple(way, rows)


def replace_tuple(way: ContactMode, rows: tuple[bool, ...]) -> ContactMode:
    """Return the contact mode with another choice of the constraint rows that act."""
    return way._replace(rows=rows)


def _wrong(instant: ForceProblem, found: ForceSolution) -> tuple[Change, ...]:
    """Return the changes that correct the violated conditions of a solution; empty if it is consistent."""
    way = found.way
    force = ZERO_RTOL * max(float(np.abs(instant.loads).max(initial=0.0)), 1e-3)
    small = _little(instant, found)
    wrong: list[Change] = []
    for i, acts in enumerate(way.rows):
        if instant.both[i] or not instant.allowed[i]:
            continue
        over = float(instant.rows[i] @ found.x) - instant.targets[i]
        if found.rows[i] < -force if acts else over > small:
            wrong.append(("rows", i, not acts))
    for i, shut in enumerate(way.faces):
        if (shut and not instant.guided[i] and found.normal[i] < -force) or (
            not shut and found.x[instant.rises[i]] < -small
        ):
            wrong.append(("faces", i, not shut))
        elif instant.friction[i] > 0.0 and shut:
            wrong += _rubs_wrong(instant, found, i, force, small)
    return tuple(wrong)


def _rubs_wrong(instant: ForceProblem, found: ForceSolution, i: int, force: float, small: float) -> list[Change]:
    """Return the changes of the friction of a rough face that correct its violated condition."""
    if instant.friction[i] >= NEVER:
        return []
    side, held = found.way.rubbing[i], float(found.friction[i])
    if side == 0:
        too_much = abs(held) > instant.holds[i] * abs(found.normal[i]) + force
        return [("rubbing", i, -1 if held > 0.0 else 1)] if too_much else []
    back = not instant.sliding[i] and side * float(instant.slips[i] @ found.x) < -small
    return [("rubbing", i, 0)] if back else []


def everything(rows: int, faces: int) -> ContactMode:
    """Return the contact mode in which all constraints act and all contacts stick."""
    return ContactMode((True,) * rows, (True,) * faces, (0,) * faces)
