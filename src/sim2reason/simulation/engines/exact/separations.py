"""Which contacts come apart when faces would have to pull.

A solution of `contact_modes` holds every contact closed. Where it needs a face to pull, the contact whose face pulls
most need not be the one that opens: a block that a wedge is jerked away under pulls at the wedge too, and so
makes the floor seem to pull the wedge, which in truth stays down. So the rises of the contacts that open become
unknowns like the coordinates, and what opens is found as what acts is: z ≥ 0, N ≥ 0, zN = 0. All contacts that
contradict that change sides, again and again; if that goes in circles, only the last of them does, which without
friction comes to an end: K. G. Murty, Note on a Bard-type scheme for solving the complementarity problem (1974).
"""

from dataclasses import replace

from sim2reason.simulation.engines.exact.contact_modes import NoForcesError, search
from sim2reason.simulation.engines.exact.linear import Row
from sim2reason.simulation.engines.exact.problem import Gradient, Mode, Problem, Solution, gradient

RISING = 1e-9  # of the largest velocity or acceleration: a contact that opens does so faster
PIVOTS = 64  # sets of contacts that are tried before the one that is pulled most is named


def lifted(problem: Problem, heave: list[Row], found: Solution, small: float) -> tuple[int, ...]:
    """The contacts that come apart, in order; none if no face pulls by more than `small`.

    `heave` is the mass matrix of the rises alone, (c, c): Σ m n·n′ over the bodies that both carry.
    """
    guided = {grip.contact for grip in problem.grips if grip.both} | set(problem.guided)
    pulled = {number for number, force in enumerate(found.forces.normal) if force < -small and number not in guided}
    if not pulled:
        return ()
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
        wrong -= guided
        if not wrong:
            return rises
    return (min(pulled, key=found.forces.normal.__getitem__),)


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
    stay = [number for number, grip in enumerate(problem.grips) if grip.contact in place]
    opened = replace(
        problem,
        mass=mass + wide(apart),
        lifted=wide(kept),
        force=[*problem.force, *(problem.press[j] for j in apart)],
        press=[problem.press[i] for i in kept],
        rows=tuple(_raised(row, apart, kept) for row in problem.rows),
        grips=tuple(
            replace(
                problem.grips[i],
                contact=place[problem.grips[i].contact],
                slip=_raised(problem.grips[i].slip, apart, kept),
            )
            for i in stay
        ),
        sliding=tuple(problem.sliding[i] for i in stay),
    )
    return opened, kept


def _raised(row: Gradient, apart: tuple[int, ...], kept: list[int]) -> Gradient:
    return gradient([*row.along, *(row.lift[j] for j in apart)], [row.lift[i] for i in kept])
