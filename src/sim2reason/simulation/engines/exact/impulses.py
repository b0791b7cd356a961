"""What happens at an impact: velocities jump, positions do not.

All impacts of one instant are one problem: pairs that touch (Newton's law along the line of centres,
u⁺ = −e u⁻), strings at full length (inelastic, they only pull), contacts (the face does not give way, and
rubs by Coulomb's law with impulses in place of forces).
"""

from typing import NamedTuple

from sim2reason.simulation.engines.exact.contact_modes import Mode, Problem, search
from sim2reason.simulation.engines.exact.equations import Equations, Gradient, Pair
from sim2reason.simulation.engines.exact.events import STILL, Approach
from sim2reason.simulation.engines.exact.linear import Row, dot
from sim2reason.simulation.engines.exact.separations import lifted

ROUNDING = 1e-9  # of the largest impulse or momentum: a face that pulls by less does not pull


class Struck(NamedTuple):
    """What an impact leaves."""

    v: Row  # the velocities just after
    rubbing: tuple[int, ...]  # of each rough contact: 0 if it sticks
    lifted: tuple[int, ...]  # the contacts that come apart; v then means nothing


def closing(pair: Pair, approach: Approach, size: tuple[int, int]) -> Gradient:
    """The gradient of minus the gap: a positive multiplier pushes the two apart, as a string's pulls together."""
    along, lift = [0.0] * size[0], [0.0] * size[1]
    r = sum(part * part for part in approach.apart) ** 0.5
    for steps, gradient in ((pair.slides, along), (pair.normals, lift)):
        for number, axis in steps:
            gradient[number] -= sum(p * w for p, w in zip(approach.apart, axis, strict=True)) / r
    return Gradient(along, lift, tuple((number, part) for number, part in enumerate(along) if part != 0.0))


def strike(
    system: Equations,
    v: Row,
    strings: list[int],
    pairs: list[tuple[Pair, Approach]],
    taut: list[bool],
) -> Struck:
    """The velocities just after, and what comes apart.

    Args:
        system: the mechanism.
        v: velocities just before.
        strings: the strings at full length.
        pairs: the pairs that touch.
        taut: which of all strings were taut before.
    """
    size = (len(v), len(system.press))
    rows = [system.strings[number] for number in strings]
    acting = [taut[number] or row.rate(v) > STILL for number, row in zip(strings, rows, strict=True)]
    targets = [0.0] * len(rows)
    for pair, approach in pairs:
        rows.append(closing(pair, approach, size))
        acting.append(approach.rate < -STILL)
        targets.append(min(0.0, pair.restitution * approach.rate))
    momenta = [dot(row, v) for row in system.mass]
    problem = Problem(
        system.mass,
        system.lifted,
        momenta,
        [dot(row, v) for row in system.lifted],
        tuple(rows),
        targets,
        system.grips,
        (0,) * len(system.grips),
    )
    sides = tuple((v[grip.coordinate] > 0.0) - (v[grip.coordinate] < 0.0) for grip in system.grips)
    found = search(problem, Mode(tuple(acting), sides))
    small = ROUNDING * max(map(abs, (*found.forces.normal, *momenta)), default=0.0)
    return Struck(found.x, found.mode.rubbing, lifted(system, problem, found, small))
