"""Drops a question that one line answers."""

from collections.abc import Iterator

from sim2reason.filters import FILTERS, Candidate, Filter
from sim2reason.filters.parts.effects import effects
from sim2reason.filters.parts.products import product_of
from sim2reason.filters.parts.sums import sum_of
from sim2reason.questions.simplifications.gravity_left_out import GravityLeftOut
from sim2reason.questions.simplifications.point_mass import PointMass


class OneLine(Filter):
    """The answer is no more than a product of a few stated numbers, or a sum of two, as F/(m + M) or √(v² + 2 g h).

    So is whatever is read off a formula that everybody knows: a period, a free fall, a weight on a slope. What follows
    from a law of motion and a law of turning together is more, whatever it simplifies to: the friction ½ m g sin θ on
    a pipe that rolls down.
    """

    order = 8

    def reason(self, candidate: Candidate) -> str:
        """See how the answer goes with each number, and whether that is all there is to it."""
        if candidate.kind.measured(candidate.question.query).whole:
            return ""
        line = product_of(candidate) or sum_of(candidate)
        return "" if line and _needs_a_second_law(candidate) else line

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """The product or sum, if it is one."""
        yield (
            product_of(candidate) or sum_of(candidate) or "the answer is no product of stated numbers, nor a sum of two"
        )
        if _needs_a_second_law(candidate):
            yield "weight drives it, and bodies that turn resist it by their moments of inertia"


def _needs_a_second_law(candidate: Candidate) -> bool:
    """Whether weight bears on the answer, and so does the inertia with which something turns about its own centre.

    Without weight, as in L = m v R of a hoop that rolls, it may be by definition that inertia bears.
    """
    changed = {effect.simplification.name for effect in effects(candidate, part=False) if not effect.close}
    return {PointMass.name, GravityLeftOut.name} <= changed


FILTERS.add("one line", OneLine())
