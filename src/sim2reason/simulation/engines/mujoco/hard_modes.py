"""What acts at an instant, found by trying: of all ways in which rows, faces and friction can act, the one that holds.

Ways are tried in the order of how much they change. Forces and impulses are the same problem, for accelerations and
for velocities after an impact. Rows pull or push one way, faces press or come apart, friction holds or is µN.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations
from typing import NamedTuple

import numpy as np

from sim2reason.dsl.state import Array
from sim2reason.errors import SimulationError

SMALL = 1e-9  # of the largest load or acceleration: what still counts as zero
SINGULAR = 1e-10  # of the largest singular value
MOST = 4000  # ways that are tried


class Way(NamedTuple):
    """Which rows act, which faces are closed, how each rough face rubs: 0 sticks, ±1 slips to that side."""

    rows: tuple[bool, ...]
    faces: tuple[bool, ...]
    rubbing: tuple[int, ...]


@dataclass(frozen=True)
class Instant:
    """All that the forces of one instant depend on, in arrays over joints."""

    inertia: Array
    loads: Array
    rows: Array  # (rows, joints)
    targets: Array
    both: tuple[bool, ...]
    follows: tuple[int, ...]
    rises: list[int]  # joints
    slips: Array  # (faces, joints)
    friction: Array  # (faces,)
    sliding: tuple[int, ...]  # the side to which a face slips already; else 0
    guided: tuple[bool, ...]
    allowed: tuple[bool, ...]  # the rows that may act


class Faces(NamedTuple):
    """The joints along which bodies rise from their faces, how these slip (faces, joints), and their friction."""

    rises: list[int]
    slips: Array
    friction: Array


@dataclass(frozen=True)
class Found:
    """Accelerations and all forces of one way; `open_rows` and the like say which of them are not determined."""

    way: Way
    x: Array
    rows: Array
    normal: Array
    friction: Array
    unknown: Array  # (rows + faces + faces,), 1 where a force is not determined


def search(instant: Instant, guess: Way) -> Found:
    """The way that holds, nearest to a guess; SimulationError if none does."""
    for number, way in enumerate(_ways(instant, guess)):
        if number == MOST:
            break
        found = solved(instant, way)
        if found is not None and _holds(instant, found):
            return found
    raise SimulationError("MuJoCo: no forces are consistent with the strings and rough contacts")


def _ways(instant: Instant, guess: Way) -> Iterator[Way]:
    """All ways, those that change least first."""
    free = [
        number
        for number, ok in enumerate(instant.allowed)
        if ok and not instant.both[number] and instant.follows[number] < 0
    ]
    rough = [i for i, mu in enumerate(instant.friction) if mu > 0.0 and not instant.sliding[i]]
    faces = [i for i, held in enumerate(instant.guided) if not held]
    start = replace_rows(instant, guess)
    changes: list[tuple[str, int, object]] = [("rows", i, not start.rows[i]) for i in free]
    changes += [("rubbing", i, side) for i in rough for side in (0, 1, -1) if side != start.rubbing[i]]
    changes += [("faces", i, not start.faces[i]) for i in faces]
    for count in range(len(changes) + 1):
        for chosen in combinations(changes, count):
            places = [(kind, i) for kind, i, _ in chosen]
            if len(set(places)) == len(places):
                yield _linked(instant, _changed(start, chosen))


def replace_rows(instant: Instant, guess: Way) -> Way:
    """A guess with what may not act left out, what is held acting, and faces that slip already slipping."""
    rows = tuple(
        (acts or both) and ok for acts, both, ok in zip(guess.rows, instant.both, instant.allowed, strict=True)
    )
    rubbing = tuple(side or was for side, was in zip(instant.sliding, guess.rubbing, strict=True))
    return _linked(instant, Way(rows, guess.faces, rubbing))


def _changed(way: Way, changes: tuple[tuple[str, int, object], ...]) -> Way:
    parts: dict[str, list[object]] = {"rows": list(way.rows), "faces": list(way.faces), "rubbing": list(way.rubbing)}
    for kind, number, value in changes:
        parts[kind][number] = value
    rows, faces = tuple(bool(x) for x in parts["rows"]), tuple(bool(x) for x in parts["faces"])
    return Way(rows, faces, tuple(int(str(x)) for x in parts["rubbing"]))


def _linked(instant: Instant, way: Way) -> Way:
    rows = tuple(
        way.rows[leader] if leader >= 0 else acts for acts, leader in zip(way.rows, instant.follows, strict=True)
    )
    return replace_tuple(way, rows)


def replace_tuple(way: Way, rows: tuple[bool, ...]) -> Way:
    """A way with other rows."""
    return way._replace(rows=rows)


class Acting(NamedTuple):
    """What acts in one way, by number: rows, closed faces, and those of them that stick."""

    rows: list[int]
    closed: list[int]
    sticking: list[int]


def acting(way: Way, friction: Array) -> Acting:
    """What acts in one way."""
    closed = [i for i, shut in enumerate(way.faces) if shut]
    sticking = [i for i in closed if friction[i] > 0.0 and way.rubbing[i] == 0]
    return Acting([i for i, acts in enumerate(way.rows) if acts], closed, sticking)


def system(
    inertia: Array, loads: Array, held: list[Array], targets: list[float], faces: "Faces", way: Way, acts: Acting
) -> tuple[Array, Array]:
    """The equations of one way: for accelerations, the forces of rows `held` at `targets`, of faces, and friction."""
    n, first, second = len(loads), len(held), len(held) + len(acts.closed)
    size = n + second + len(acts.sticking)
    matrix, wanted = np.zeros((size, size)), np.zeros(size)
    matrix[:n, :n], wanted[:n] = inertia, loads
    if held:
        matrix[:n, n : n + first], matrix[n : n + first, :n] = np.array(held).T, np.array(held)
        wanted[n : n + first] = targets
    for place, i in enumerate(acts.closed, start=n + first):
        joint = faces.rises[i]
        matrix[joint, place], matrix[place, joint] = -1.0, 1.0
        if way.rubbing[i]:
            matrix[:n, place] += faces.friction[i] * way.rubbing[i] * faces.slips[i]
    for place, i in enumerate(acts.sticking, start=n + second):
        matrix[:n, place], matrix[place, :n] = -faces.slips[i], faces.slips[i]
    return matrix, wanted


def solved(instant: Instant, way: Way) -> Found | None:
    """The linear system of one way, solved; None if it has no solution."""
    n, faces = len(instant.loads), Faces(instant.rises, instant.slips, instant.friction)
    acts = acting(way, instant.friction)
    held, targets = [instant.rows[i] for i in acts.rows], [float(instant.targets[i]) for i in acts.rows]
    matrix, wanted = system(instant.inertia, instant.loads, held, targets, faces, way, acts)
    solution, null = quick(matrix, wanted) or _least(matrix, wanted)
    if solution is None or null[:n].any():
        return None
    rows, normal, friction = np.zeros(len(way.rows)), np.zeros(len(way.faces)), np.zeros(len(way.faces))
    second = n + len(held) + len(acts.closed)
    rows[acts.rows], normal[acts.closed] = solution[n : n + len(held)], solution[n + len(held) : second]
    friction[acts.sticking] = solution[second:]
    for i in acts.closed:
        if way.rubbing[i]:
            friction[i] = -instant.friction[i] * way.rubbing[i] * normal[i]
    unknown = np.zeros(len(rows) + 2 * len(normal))
    places = [*acts.rows, *(len(rows) + i for i in acts.closed), *(len(rows) + len(normal) + i for i in acts.sticking)]
    unknown[places] = null[n:]
    return Found(way, solution[:n], rows, normal, friction, unknown)


def quick(matrix: Array, wanted: Array) -> tuple[Array, Array] | None:
    """The solution of a system that plainly has one."""
    try:
        found: Array = np.asarray(np.linalg.solve(matrix, wanted), dtype=np.float64)
    except np.linalg.LinAlgError:
        return None
    scale = np.abs(matrix).max(axis=1, initial=1e-300)
    large = float(np.abs(found).max(initial=0.0))
    sound = np.isfinite(large) and np.abs((matrix @ found - wanted) / scale).max(initial=0.0) <= 1e-9 * (1.0 + large)
    return (found, np.zeros(len(wanted))) if sound and large <= 1e9 else None


def _least(matrix: Array, wanted: Array) -> tuple[Array | None, Array]:
    """A solution, and which unknowns are not determined; None if there is none. Rows are scaled to size one."""
    if not len(wanted):
        return wanted, wanted
    scale = np.maximum(np.abs(matrix).max(axis=1), 1e-300)
    a, b = matrix / scale[:, None], wanted / scale
    left, sizes, right = np.linalg.svd(a)
    rank = int((sizes > SINGULAR * sizes[0]).sum())
    found = np.asarray(right[:rank].T @ ((left[:, :rank].T @ b) / sizes[:rank]), dtype=np.float64)
    if rank < len(wanted) and np.abs(a @ found - b).max() > 1e-7 * (1.0 + np.abs(b).max()):
        return None, found
    null = np.zeros(len(wanted))
    null[(np.abs(right[rank:]) > 1e-8).any(axis=0)] = 1.0
    return found, null


def _holds(instant: Instant, found: Found) -> bool:
    """Whether nothing pulls that can only push, and nothing gives way that would hold."""
    way = found.way
    force = SMALL * max(float(np.abs(instant.loads).max(initial=0.0)), 1e-3)
    small = SMALL * max(float(np.abs(found.x).max(initial=0.0)), float(np.abs(instant.targets).max(initial=0.0)), 1.0)
    for i, acts in enumerate(way.rows):
        if instant.both[i] or not instant.allowed[i]:
            continue
        if acts and found.rows[i] < -force:
            return False
        if not acts and instant.rows[i] @ found.x - instant.targets[i] > small:
            return False
    for i, shut in enumerate(way.faces):
        if shut and not instant.guided[i] and found.normal[i] < -force:
            return False
        if not shut and found.x[instant.rises[i]] < -small:
            return False
        if instant.friction[i] > 0.0 and shut and not _rubs(instant, found, i, force, small):
            return False
    return True


def _rubs(instant: Instant, found: Found, i: int, force: float, small: float) -> bool:
    side = found.way.rubbing[i]
    if side == 0:
        return abs(found.friction[i]) <= instant.friction[i] * abs(found.normal[i]) + force
    return bool(instant.sliding[i]) or side * float(instant.slips[i] @ found.x) >= -small


def everything(rows: int, faces: int) -> Way:
    """The way in which all acts and sticks."""
    return Way((True,) * rows, (True,) * faces, (0,) * faces)
