"""Which contacts come apart when faces would have to pull.

A solution of `modes` holds every contact closed. Where it needs a face to pull, the contact whose face pulls
most need not be the one that opens: a block that a wedge is jerked away under pulls at the wedge too, and so
makes the floor seem to pull the wedge, which in truth stays down. So the rises of the contacts that open become
unknowns like the coordinates, and what opens is found as what acts is: z ≥ 0, N ≥ 0, zN = 0. All contacts that
contradict that change sides, again and again; if that goes in circles, only the last of them does, which without
friction comes to an end: K. G. Murty, Note on a Bard-type scheme for solving the complementarity problem (1974).
"""

from sim2reason.dsl.kinematics import dot, kinematics
from sim2reason.simulation.engines.exact.contact_modes import Mode, NoForcesError, Problem, Solution, search
from sim2reason.simulation.engines.exact.equations import Equations, Gradient, Grip
from sim2reason.simulation.engines.exact.linear import Row

RISING = 1e-9  # of the largest velocity or acceleration: a contact that opens does so faster
PIVOTS = 64  # sets of contacts that are tried before the one that is pulled most is named


def lifted(system: Equations, problem: Problem, found: Solution, small: float) -> tuple[int, ...]:
    """The contacts that come apart, in order; none if no face pulls by more than `small`."""
    pulled = {number for number, force in enumerate(found.forces.normal) if force < -small}
    if not pulled:
        return ()
    heave = _heave(system)
    tried = set[frozenset[int]]()
    apart, wrong = frozenset[int](), frozenset(pulled)
    for _ in range(PIVOTS):
        flipped = apart ^ wrong
        apart = flipped if flipped not in tried else apart ^ {max(wrong)}
        tried.add(apart)
        try:
            rises, wrong = _rises(problem, heave, found.mode, tuple(sorted(apart)), small)
        except NoForcesError:  # what is left closed can't rub so
            break
        if not wrong:
            return rises
    return (min(pulled, key=found.forces.normal.__getitem__),)


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


def _rises(
    problem: Problem, heave: list[Row], mode: Mode, apart: tuple[int, ...], small: float
) -> tuple[tuple[int, ...], frozenset[int]]:
    """Those of `apart` that rise if these contacts and no others are open, and all that show that it is not so."""
    opened, kept = _opened(problem, heave, apart)
    rubbing = tuple(side for grip, side in zip(problem.grips, mode.rubbing, strict=True) if grip.contact not in apart)
    found = search(opened, Mode(mode.acting, rubbing))
    least = RISING * max(map(abs, found.x))
    rises = list(zip(apart, found.x[len(problem.force) :], strict=True))
    closing = [number for number, rise in rises if rise < -least]
    pulled = [number for number, force in zip(kept, found.forces.normal, strict=True) if force < -small]
    return tuple(number for number, rise in rises if rise > least), frozenset(closing + pulled)


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
