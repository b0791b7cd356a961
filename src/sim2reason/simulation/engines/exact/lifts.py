"""Which contacts come apart when faces would have to pull.

A solution of `modes` holds every contact closed. Where it needs a face to pull, the contact whose face pulls
most need not be the one that opens: a block that a wedge is jerked away under pulls at the wedge too, and so
makes the floor seem to pull the wedge, which in truth stays down. So the rises of the contacts that open become
unknowns like the coordinates, and what opens is found as what acts is: z ≥ 0, N ≥ 0, zN = 0.
"""

from collections.abc import Iterator
from itertools import combinations

from sim2reason.dsl.kinematics import dot, kinematics
from sim2reason.errors import SimulationError
from sim2reason.simulation.engines.exact.equations import Equations, Gradient, Grip
from sim2reason.simulation.engines.exact.linear import Row
from sim2reason.simulation.engines.exact.modes import Mode, Problem, Solution, search

RISING = 1e-9  # of the largest velocity or acceleration: a contact that opens does so faster
SETS = 512  # of contacts that are tried before the one that is pulled most is named


def lifted(system: Equations, problem: Problem, found: Solution, small: float) -> tuple[int, ...]:
    """The contacts that come apart, in order; none if no face pulls by more than `small`."""
    pulled = {number for number, force in enumerate(found.forces.normal) if force < -small}
    if not pulled:
        return ()
    heave = _heave(system)
    for number, apart in enumerate(_candidates(len(problem.press))):
        if number > SETS:
            break
        rises = _rises(problem, heave, found.mode, apart, small)
        if rises:
            return rises
    return (min(pulled, key=found.forces.normal.__getitem__),)


def _candidates(count: int) -> Iterator[tuple[int, ...]]:
    """Sets of contacts, the small ones first: bodies seldom leave their faces together."""
    for size in range(1, count + 1):
        yield from combinations(range(count), size)


def _heave(system: Equations) -> list[Row]:
    """The mass matrix of the rises alone, (c, c): Σ m n·n′ over the bodies that both carry."""
    count = len(system.press)
    heave = [[0.0] * count for _ in range(count)]
    points = kinematics(system.mechanism)
    for body in system.mechanism.bodies:
        normals = points.bodies[body.name].normals
        for i, axis in normals:
            for j, other in normals:
                heave[i][j] += float(body.mass) * dot(axis, other)
    return heave


def _rises(problem: Problem, heave: list[Row], mode: Mode, apart: tuple[int, ...], small: float) -> tuple[int, ...]:
    """Those of `apart` that rise, if these contacts and no others can be the ones that open; else none."""
    opened, kept = _opened(problem, heave, apart)
    rubbing = tuple(side for grip, side in zip(problem.grips, mode.rubbing, strict=True) if grip.contact not in apart)
    try:
        found = search(opened, Mode(mode.acting, rubbing))
    except SimulationError:
        return ()
    rises = found.x[len(problem.force) :]
    least = RISING * max(map(abs, found.x))
    if min(rises) < -least or min((found.forces.normal[i] for i in range(len(kept))), default=0.0) < -small:
        return ()
    return tuple(number for number, rise in zip(apart, rises, strict=True) if rise > least)


def _opened(problem: Problem, heave: list[Row], apart: tuple[int, ...]) -> tuple[Problem, list[int]]:
    """The same problem with the rises of `apart` among the coordinates; and the contacts that are left."""
    kept = [number for number in range(len(problem.press)) if number not in apart]
    place = {number: new for new, number in enumerate(kept)}

    def wide(numbers: list[int] | tuple[int, ...]) -> list[Row]:
        return [[*problem.lifted[i], *(heave[i][j] for j in apart)] for i in numbers]

    mass = [[*row, *(problem.lifted[j][k] for j in apart)] for k, row in enumerate(problem.mass)]
    rows = tuple(_raised(row, apart, kept) for row in problem.rows)
    held = [(grip, side) for grip, side in zip(problem.grips, problem.sliding, strict=True) if grip.contact in place]
    opened = Problem(
        mass=mass + wide(apart),
        lifted=wide(kept),
        force=[*problem.force, *(problem.press[j] for j in apart)],
        press=[problem.press[i] for i in kept],
        rows=rows,
        targets=problem.targets,
        grips=tuple(Grip(place[grip.contact], grip.coordinate, grip.friction) for grip, _ in held),
        sliding=tuple(side for _, side in held),
    )
    return opened, kept


def _raised(row: Gradient, apart: tuple[int, ...], kept: list[int]) -> Gradient:
    along = [*row.along, *(row.lift[j] for j in apart)]
    terms = tuple((number, part) for number, part in enumerate(along) if part != 0.0)
    return Gradient(along, [row.lift[i] for i in kept], terms)
