"""Pulleys without mass: balances of forces give one tension by others, and strings around them change twice."""

from collections.abc import Collection, Sequence
from collections.abc import Set as AbstractSet

from sim2reason.solutions.algebra.elimination import Equation
from sim2reason.solutions.algebra.polynomials import Polynomial
from sim2reason.solutions.laws.dynamics import Dynamics
from sim2reason.solutions.laws.newton import Row
from sim2reason.solutions.writing.steps import UnsolvedError

TWICE = 2.0


def balanced_tensions(
    light: Sequence[Equation], known: Collection[str], unknown: AbstractSet[str], goals: Collection[str]
) -> tuple[dict[str, Polynomial], dict[str, frozenset[str]]]:
    """Return the tensions that balances at light pulleys give by others, and the labels of those balances.

    `goals` are found by others last. UnsolvedError where a balance has a ratio that changes.
    """
    found: dict[str, Polynomial] = {}
    labels: dict[str, frozenset[str]] = {}
    for equation in light:
        used = {name for name in equation.zero.names() if name in found}
        zero = equation.forces.put(found)
        names = [n for n in sorted(zero.names() & unknown) if n not in known]
        name = min(names, key=lambda n: (n in goals, abs(zero.coefficient(n).number or 0.0) != 1.0, n))
        before = zero.coefficient(name).number
        if not before:
            raise UnsolvedError("a light pulley balances at a ratio that changes")
        found[name] = zero.without((name,)).scaled(-1.0 / before)
        labels[name] = frozenset({equation.label}).union(*(labels[n] for n in used))
        labels |= {n: labels[n] | labels[name] for n, held in found.items() if name in held.names()}
        found = {n: p.put({name: found[name]}) for n, p in found.items()}
    return found, labels


def doubled(dynamics: Dynamics, row: Row) -> str:
    """Return why the acceleration of a pulley stands twice in a law of a string, as an addition to a sentence."""
    held = [int(name[1:]) for name in row.inertia.names() if name[1:].isdigit()]
    twice = [k for k in held if abs(row.inertia.coefficient(f"q{k}").number or 0.0) == TWICE]
    bodies = [dynamics.mechanism.coordinates[k].body for k in sorted(twice)]
    pulleys = [body for body in bodies if body in dynamics.setting.pulleys]
    if not pulleys:
        return ""
    return f", and moving {dynamics.setting.listed(pulleys)} changes the two parts beside it equally"
