"""Equilibria of a mechanism by Newton's method on the exact formulas, with zero velocities and accelerations.

With the coordinates q and the force λ of each active row, an equilibrium solves F(q) − Jᵀ(q) λ = 0 and
spare(q) = 0. It is stable if the stiffness −∂(F − Jᵀλ)/∂q is positive along all motions that the rows allow.
"""

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from itertools import product
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sim2reason.errors import SimulationError, UnsupportedError
from sim2reason.scenes.dsl.mechanism import Inextensible, Mechanism
from sim2reason.simulation.engines.exact.assembly import Assembly
from sim2reason.simulation.engines.exact.system import System
from sim2reason.simulation.engines.exact.tape import Tape

Vector = NDArray[np.float64]

ATTEMPTS = 24  # starting points of Newton's method, for each set of taut strings
STEPS = 60
PATIENCE = 6  # steps in which what is wrong must halve
MOST_STRINGS = 6  # every set of taut strings is tried
EXACT = 1e-10  # of the largest force, or m
SAME = 1e-6  # m or rad: two equilibria closer than that are one
DIFFERENCE = 6e-6  # of the size of a coordinate, for central differences


@dataclass(frozen=True)
class Equilibrium:
    """Equilibrium position of a mechanism."""

    coordinates: Mapping[str, float]
    """Of each coordinate, counted from where the mechanism starts, m or rad."""
    tensions: Mapping[str, float]
    """Of each line, N; negative where a rod or a spring is compressed, 0 where a string hangs slack."""
    normal: tuple[float, ...]
    """Of each face, N."""
    stable: bool
    """Whether any small displacement is driven back."""


def equilibria(mechanism: Mechanism) -> tuple[Equilibrium, ...]:
    """Return all equilibria that Newton's method finds from points all over the reach, the stable ones first.

    An UnsupportedError is raised if friction holds over a range of positions, if a body burns, is reeled in or
    stands on feet, if there are too many strings, or if no equilibrium is isolated. A SimulationError is raised if
    there is none.
    """
    _check(mechanism)
    system = System(mechanism)
    formulas = _formulas(system)
    found: list[Equilibrium] = []
    for taut in _taut(system):
        statics = _Statics(system, formulas, taut)
        for start in _starts(system):
            rest = statics.rest(start)
            if rest is not None and not any(_same(mechanism, rest, other) for other in found):
                found.append(rest)
    if not found:
        raise SimulationError("no equilibrium was found: nothing keeps the mechanism at rest anywhere near")
    return tuple(sorted(found, key=lambda rest: (not rest.stable, *rest.coordinates.values())))


def _check(mechanism: Mechanism) -> None:
    strings = [line.law for line in mechanism.lines if isinstance(line.law, Inextensible)]
    problems = {
        "friction holds a body over a range of places": any(face.friction > 0.0 for face in mechanism.faces),
        "a body burns its fuel": bool(mechanism.burns),
        "a body stands on its feet": bool(mechanism.feet),
        "a string is reeled in": any(law.reel for law in strings),
        f"there are more than {MOST_STRINGS} strings": len(strings) > MOST_STRINGS,
    }
    for problem, is_there in problems.items():
        if is_there:
            raise UnsupportedError(f"no equilibrium to name: {problem}")


def _taut(system: System) -> Iterator[tuple[bool, ...]]:
    """Yield every set of rows that may act, beginning with all of them."""
    kinds = system.kinds(system.phase)
    yield from product(*((True,) if kind.both else (True, False) for kind in kinds))


def _starts(system: System) -> Iterator[Vector]:
    """Yield the initial points: the mechanism's own start, then fixed points spread over its reach."""
    mechanism = system.mechanism
    reach = max([1.0, *(system.starts[line.name] for line in mechanism.lines)])
    low = [max(c.lower, -math.pi if c.kind == "hinge" else -reach) for c in mechanism.coordinates]
    high = [min(c.upper, math.pi if c.kind == "hinge" else reach) for c in mechanism.coordinates]
    yield np.zeros(system.size)
    rng = np.random.default_rng(0)
    for _ in range(ATTEMPTS):
        yield rng.uniform(low, high)


def _same(mechanism: Mechanism, one: Equilibrium, other: Equilibrium) -> bool:
    for coordinate in mechanism.coordinates:
        apart = one.coordinates[coordinate.name] - other.coordinates[coordinate.name]
        if coordinate.kind == "hinge":
            apart = math.remainder(apart, 2.0 * math.pi)
        if abs(apart) > SAME:
            return False
    return True


class _Rest(NamedTuple):
    """Load on each coordinate at rest, and the remainder of each row with its gradient."""

    force: Vector  # (n,)
    spare: Vector  # (rows,)
    along: Vector  # (rows, n)


def _formulas(system: System) -> Callable[[Vector], _Rest]:
    """Return code that computes loads and remainders for any coordinates."""
    n = system.size
    tape = Tape(["t", *(f"q{number}" for number in range(n))])
    _, *q = tape.inputs.values()
    assembly = Assembly(system.mechanism, system.phase, (q, [0.0] * n, 0.0), tape)
    rows = assembly.rows(system.starts)
    entries = [row.along.get(k, 0.0) for row in rows for k in range(n)]
    code = tape.code([*assembly.force, *(row.value for row in rows), *entries])(math)

    def rest(places: Vector) -> _Rest:
        found = np.array(code(0.0, [*map(float, places)]), dtype=np.float64)
        last = n + len(rows)
        return _Rest(found[:n], found[n:last], found[last:].reshape(len(rows), n))

    return rest


class _Statics:
    """Equilibrium equations for one set of taut strings."""

    def __init__(self, system: System, formulas: Callable[[Vector], _Rest], taut: tuple[bool, ...]) -> None:
        self.system, self.formulas, self.taut, self.n = system, formulas, taut, system.size
        self.active = [number for number, acts in enumerate(taut) if acts]
        self.scale = float(np.abs(formulas(np.zeros(self.n)).force).max(initial=0.0)) or 1.0

    def rest(self, start: Vector) -> Equilibrium | None:
        """Return the valid equilibrium that Newton's method reaches from a point, or None."""
        try:
            found = self._newton(np.concatenate([start, np.zeros(len(self.active))]))
            return None if found is None else self._equilibrium(found)
        except ZeroDivisionError:  # two sites met on the way
            return None

    def _newton(self, x: Vector) -> Vector | None:
        residual = self._residual(x)
        before = math.inf
        for number in range(STEPS):
            size = float(np.linalg.norm(residual))
            if size <= EXACT:
                return x
            if number % PATIENCE == 0:
                if size > 0.5 * before:
                    return None
                before = size
            step = np.linalg.lstsq(self._jacobian(x), -residual, rcond=1e-12)[0]
            length = float(np.abs(step[: self.n]).max(initial=0.0))
            share = min(1.0, 1.0 / length) if length > 0.0 else 1.0
            for _ in range(20):
                trial = self._residual(x + share * step)
                if float(np.linalg.norm(trial)) < (1.0 - 0.1 * share) * size:
                    break
                share *= 0.5
            else:
                return None
            x, residual = x + share * step, trial
        return None

    def _assembly(self, q: Vector) -> Assembly:
        still = [0.0] * self.n
        return Assembly(self.system.mechanism, self.system.phase, ([*map(float, q)], still, 0.0), math)

    def _residual(self, x: Vector) -> Vector:
        """Return forces as fractions of the largest at the start, then the remainder of each taut row in m."""
        rest = self.formulas(x[: self.n])
        pulled = x[self.n :] @ rest.along[self.active]
        return np.concatenate([rest.force / self.scale - pulled, rest.spare[self.active]])

    def _jacobian(self, x: Vector) -> Vector:
        columns: list[Vector] = []
        for k in range(len(x)):
            step = np.zeros(len(x))
            step[k] = DIFFERENCE * max(1.0, abs(float(x[k])))
            columns.append((self._residual(x + step) - self._residual(x - step)) / (2.0 * step[k]))
        return np.array(columns).T

    def _equilibrium(self, x: Vector) -> Equilibrium | None:
        mechanism, q = self.system.mechanism, x[: self.n]
        assembly = self._assembly(q)
        rows = assembly.rows(self.system.starts)
        acting = {number: self.scale * float(part) for number, part in zip(self.active, x[self.n :], strict=True)}
        normal = [-float(press) for press in assembly.press]
        for number, force in acting.items():
            for contact, part in rows[number].lift.items():
                normal[contact] += force * float(part)
        if not (self._holds(assembly, acting, normal) and self._is_within(q)):
            return None
        tensions = {
            kind.name: acting.get(number, 0.0) for number, kind in enumerate(self.system.kinds(self.system.phase))
        }
        for line in mechanism.lines:
            if not line.law.row:
                tensions[line.name] = float(assembly.tension(line, assembly.length(line)))
        names = [coordinate.name for coordinate in mechanism.coordinates]
        places = dict(zip(names, map(float, q), strict=True))
        return Equilibrium(places, tensions, tuple(normal), self._is_stable(x))

    def _holds(self, assembly: Assembly, acting: Mapping[int, float], normal: list[float]) -> bool:
        """Return whether strings pull, faces push, slack strings are long enough, and nothing overlaps."""
        little = SAME * self.scale
        kinds = self.system.kinds(self.system.phase)
        rows = assembly.rows(self.system.starts)
        pulls = all(kinds[number].both or force >= -little for number, force in acting.items())
        slack = all(float(row.value) >= -SAME for number, row in enumerate(rows) if number not in acting)
        pushed = all(force >= -little for i, force in enumerate(normal) if i not in self.system.guided)
        apart = all(float(assembly.separation(pair).gap) >= -SAME for pair in self.system.mechanism.meetings)
        return pulls and slack and pushed and apart

    def _is_within(self, q: Vector) -> bool:
        return all(
            limit.initial_travel + limit.sign * float(q[limit.coordinate]) >= -SAME for limit in self.system.limits
        )

    def _is_stable(self, x: Vector) -> bool:
        """Return whether the stiffness is positive along the allowed motions; raise if a motion needs no force."""
        jacobian = self._jacobian(x)
        stiffness, rows = -jacobian[: self.n, : self.n], jacobian[self.n :, : self.n]
        allowed = _null_space(rows)
        if not allowed.shape[1]:
            return True
        values = np.linalg.eigvalsh(allowed.T @ (0.5 * (stiffness + stiffness.T)) @ allowed)
        if float(np.abs(values).min()) < SAME * max(1.0, float(np.abs(values).max())):
            raise UnsupportedError("no equilibrium to name: it can be moved without any force")
        return bool(values.min() > 0.0)


def _null_space(rows: Vector) -> Vector:
    """Return orthonormal columns that all rows map to zero."""
    _, sizes, ways = (
        np.linalg.svd(rows, full_matrices=True) if rows.size else (None, np.zeros(0), np.eye(rows.shape[1]))
    )
    rank = int((sizes > SAME).sum())
    return ways[rank:].T
