"""One name for each quantity in the solutions of several parts, and none for two."""

from collections.abc import Collection, Iterator, Sequence
from itertools import chain

from sim2reason.grading.tokens import canonical
from sim2reason.solutions.multipart.quantities import NamedQuantity, names_of, quantities
from sim2reason.solutions.multipart.recall import kept_steps
from sim2reason.solutions.multipart.renaming import renamed, spoken
from sim2reason.solutions.solution import Solution
from sim2reason.solutions.writing.subscripts import numbered


def consistent(solutions: Sequence[Solution], fixed: Collection[str] = ()) -> list[Solution]:
    """Return the solutions renamed so that a name means the same in all; names in `fixed`, of the text, are kept.

    Numbers that the question states keep their names. A quantity that several parts find has the first of its names
    that is free, and that no other quantity has in as many parts; where none is, it has a fresh one.
    """
    solved = [solution for solution in solutions if solution.answer is not None]
    fixed = {*fixed, *(name for solution in solved for name in solution.constants)}
    found = quantities(solved, fixed)
    naming = _Naming(solved, found, fixed)
    names: list[dict[str, str]] = [{} for _ in solved]
    for quantity in naming.ordered():
        name = naming.named(quantity)
        for part, old in quantity.members.items():
            names[part][old] = name
    told = iter([renamed(solution, given) for solution, given in zip(solved, names, strict=True)])
    return [solution if solution.answer is None else next(told) for solution in solutions]


class _Naming:
    """The assignment of names to quantities."""

    def __init__(self, solutions: Sequence[Solution], found: Sequence[NamedQuantity], fixed: Collection[str]) -> None:
        self._found = found
        self._taken = {canonical(name) for name in fixed}
        self._used: list[frozenset[str]] = []
        self._spoken: list[frozenset[str]] = []
        goals = [solution.goal for solution in solutions]
        for part, solution in enumerate(solutions):
            earlier = [q for q in found if any(q.members.get(n) == goals[n] for n in range(part))]
            steps = kept_steps(solution, {q.members[part] for q in earlier if part in q.members})
            self._used.append(frozenset([*names_of(steps), solution.goal, *solution.stated]))
            self._spoken.append(spoken(" ".join(step.text for step in steps)))

    def ordered(self) -> Iterator[NamedQuantity]:
        """Yield quantities in the order of choice: stated in the question, used in the texts, the others."""
        texts = [q for q in self._found if any(name in self._used[part] for part, name in q.members.items())]
        groups = [q for q in texts if q.stated], [q for q in texts if not q.stated]
        yield from chain(*groups)
        yield from (q for q in self._found if q not in texts)

    def named(self, quantity: NamedQuantity) -> str:
        """Choose a name, which is taken from then on."""
        own = [*dict.fromkeys(quantity.members.values())]
        free = [name for name in own if self._is_free(name, quantity)]
        best = [name for name in free if len(own) == 1 or not self._is_needed(name, quantity)]
        name = next(chain(best, free, (n for n in numbered(own[0]) if self._is_free(n, quantity))))
        self._taken.add(canonical(name))
        return name

    def _is_free(self, name: str, quantity: NamedQuantity) -> bool:
        """Return whether a name is not taken and no part uses it for something else."""
        clash = any(
            name != old and name in self._spoken[part] and not self._is_own(part, name)
            for part, old in quantity.members.items()
        )
        return canonical(name) not in self._taken and not clash

    def _is_own(self, part: int, name: str) -> bool:
        return any(q.members.get(part) == name for q in self._found)

    def _is_needed(self, name: str, quantity: NamedQuantity) -> bool:
        """Return whether another quantity has a name in all its parts, at least as many as this one."""
        least = [*quantity.members.values()].count(name)
        others = (q for q in self._found if q is not quantity and {*q.members.values()} == {name})
        return any(len(q.members) >= least for q in others)
