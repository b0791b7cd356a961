"""The sign of a quantity of which a question states only the magnitude: why the opposite sign is excluded."""

from collections.abc import Sequence

from sim2reason.solutions.algebra.evaluated import Chain
from sim2reason.solutions.algebra.expressions import Expression
from sim2reason.solutions.algebra.reached import is_explicit, range_text, values_with
from sim2reason.solutions.opposite_sign import ONLY, exclude_opposite_sign
from sim2reason.solutions.other_roots import OtherRoots
from sim2reason.solutions.writing.steps import StepBuilder

OPPOSITE = f"{ONLY} with the opposite sign, for which {{}} would be {{}}"
"""Beginning of the sentence that excludes a value of the unknown with which the goal has the opposite sign."""


def write_sign_reason(
    roots: OtherRoots, step: StepBuilder, chain: Chain | None, found: Sequence[tuple[str, Expression]]
) -> None:
    """Write why the opposite sign of the goal is excluded: the unknown would have no value or an impossible value.

    The `chain` leads from the unknown to the goal, and is None where the sign is known. If one of its formulas is a
    root that was found numerically, no other values are searched for.
    """
    if chain is None:
        return
    goal, _ = chain.formulas[-1]
    if exclude_opposite_sign(roots.book, step, goal, found) or not is_explicit(chain):
        return
    others = values_with(chain, -float(chain.value(roots.book.values).real), roots.unknown, roots.book)
    if not others:
        what = range_text(roots.unknown, roots.book)
        step.add_text(f"{ONLY} no {what} gives $-{goal}$ in place of ${goal}$.")
    roots.schedule_exclusion(others, OPPOSITE)
