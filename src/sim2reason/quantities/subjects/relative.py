"""One body as another one sees it."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from itertools import permutations

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.quantities.subjects import Sense, Subject
from sim2reason.quantities.subjects.bodies import Bodies, moves
from sim2reason.quantities.subjects.pairs import AND, members


@dataclass(frozen=True)
class RelativeBodies(Subject):
    """Every two bodies that move, in either order, as ``a & b``: the first one relative to the second one."""

    name, slot = "body relative to another", "relative"

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return all ordered pairs of bodies whose centres of mass move."""
        moving = [name for name in mechanism.body if moves(mechanism, name)]
        return tuple(AND.join(pair) for pair in permutations(moving, 2))

    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """Return no phrases: only structured questions are about pairs; a sentence with two bodies is about each."""
        del mechanism, mentions
        return {}

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """Return whether the text gives the number `need`, such as the mass, of both bodies."""
        return all(Bodies().gives(need, mechanism, body, said) for body in members(name))

    def senses(self, mechanism: Mechanism, name: str) -> list[Sense]:
        """Return the directions that both bodies have."""
        one, other = (Bodies().senses(mechanism, body) for body in members(name))
        return [sense for sense in one if sense in other]
