"""Positions of the arguments about the order of collisions among the other steps."""

from collections.abc import Mapping, Sequence
from collections.abc import Set as AbstractSet

from sim2reason.solutions.collisions.order import ORDER
from sim2reason.solutions.solution import Step

LAST = "so there is no further collision"  # ends the argument about the last flights, before the end time
SOLVE_KIND = "solve for the unknown"  # kind of the steps that solve for the unknown

OUTCOME = frozenset({"after", "solve"})  # kinds of the steps that give velocities just after a collision


def in_order(steps: Sequence[Step], earliest: Mapping[int, int], late: AbstractSet[str]) -> list[Step]:
    """Move each argument about the order of collisions behind the steps with its numbers and the first collision time.

    `earliest` has, for each argument, the index of the step from which on that collision is sought. An argument with
    names that are known only at the end, `late`, stays in its position; its conclusion is assumed before the unknown is
    solved for.
    """
    found = [step for step in steps if step.kind != ORDER or not late.isdisjoint(step.symbols())]
    for step in steps:
        if step in found:
            continue
        used = {name for r in step.relations if r.role == "verified" for name in r.right.symbols()}
        after = [n for n, held in enumerate(found) if used & {*held.gives}]
        begins = earliest[step.id]
        times = (n for n, held in enumerate(found) if held.kind == "impact time" and held.id >= begins)
        first = next(times, next((n - 1 for n, held in enumerate(found) if held.id >= begins), len(found) - 1))
        place = max([first, *after]) + 1
        while place < len(found) and found[place].kind in OUTCOME:
            place += 1
        found.insert(place, step)
    return _with_supposition(found)


def _with_supposition(steps: Sequence[Step]) -> list[Step]:
    """Insert a sentence before the unknown is solved for, with the assumptions verified only later."""
    solved = next((n for n, step in enumerate(steps) if step.kind == SOLVE_KIND), len(steps))
    late = next((step for step in steps[solved:] if step.kind == ORDER and LAST in step.text), None)
    if late is None:
        return [*steps]
    until = late.text.rpartition(LAST)[2]
    text = f"This supposes that there is no further collision{until.removesuffix('.')}, which is verified below."
    said = Step(max(step.id for step in steps) + 1, "supposition", text, (), (), ())
    return [*steps[:solved], said, *steps[solved:]]
