"""What happens at an impact: velocities jump, positions do not.

All impacts of one instant are one problem: pairs that touch (Newton's law along the line of centres, u⁺ = −e u⁻), rows
that are used up (inelastic, they only pull or push), contacts (the face does not give way, and rubs by Coulomb's law
with impulses in place of forces).
"""

from dataclasses import dataclass

from sim2reason.simulation.engines.exact.contact_modes import search
from sim2reason.simulation.engines.exact.linear import Row, dot
from sim2reason.simulation.engines.exact.problem import Mode, Problem
from sim2reason.simulation.engines.exact.separations import lifted
from sim2reason.simulation.engines.exact.system import Instant, System

ROUNDING = 1e-9  # of the largest impulse or momentum: a face that pulls by less does not pull


@dataclass(slots=True)
class Struck:
    """What an impact leaves."""

    v: Row  # the velocities just after
    acting: tuple[bool, ...]  # of the rows that took part
    rubbing: tuple[int, ...]  # of each rough contact: 0 if it sticks
    lifted: tuple[int, ...]  # the contacts that come apart; v then means nothing


@dataclass(slots=True)
class Impact:
    """What takes part: the numbers of rows, those that act at first, the numbers of pairs; and what rows are."""

    rows: list[int]
    acting: list[bool]
    pairs: list[int]
    held: tuple[bool, ...]
    follows: tuple[int, ...]


def strike(system: System, instant: Instant, impact: Impact, still: float) -> Struck:
    """The velocities just after, and what comes apart; slower than `still`, m/s, nothing closes."""
    rows = [instant.rows[number] for number in impact.rows]
    targets = [instant.rows[number].rate(instant.v) - instant.rates[number] for number in impact.rows]
    acting = list(impact.acting)
    for number in impact.pairs:
        near = instant.pairs[number]
        rows.append(near.closing(system.size, system.count))
        acting.append(near.rate < -still)
        targets.append(min(0.0, near.meeting.restitution * near.rate))
    loads = instant.loads
    momenta = [dot(row, instant.v) for row in loads.mass]
    problem = Problem(
        loads.mass,
        loads.lifted,
        momenta,
        [dot(row, instant.v) for row in loads.lifted],
        tuple(rows),
        targets,
        system.grips,
        (0,) * len(system.grips),
        (*impact.held, *(False for _ in impact.pairs)),
        (*impact.follows, *(-1 for _ in impact.pairs)),
        system.guided,
        system.budget,
    )
    sides = tuple(grip.side(slip) for grip, slip in zip(system.grips, instant.slips, strict=True))
    found = search(problem, Mode(tuple(acting), sides))
    small = ROUNDING * max(map(abs, (*found.forces.normal, *momenta)), default=0.0)
    apart = lifted(problem, loads.heave, found, small)
    return Struck(found.x, found.mode.acting[: len(impact.rows)], found.mode.rubbing, apart)
