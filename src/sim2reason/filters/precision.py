"""Drops a question whose answer hangs on digits that the text does not give."""

from collections.abc import Iterator
from math import sqrt

from sim2reason.filters import FILTERS, Candidate, Filter
from sim2reason.filters.parts.numbers import elasticities, givens

WORST = 20.0  # the condition number, the root of the sum of the squares of all elasticities


class Precision(Filter):
    """A small shift of a stated number moves the answer too far, or changes the order of events: chaos.

    What is counted must not change by half a unit in the last place of any number.
    """

    order = 8

    def reason(self, candidate: Candidate) -> str:
        """Shift the stated numbers, one by one, by one part in a thousand and solve again."""
        squares = 0.0
        for found in elasticities(candidate):
            if found.reordered:
                return f"a small shift of {', '.join(found.given.paths)} changes the order of events"
            squares += found.size**2
            if squares > WORST**2:
                return f"the condition number is at least {sqrt(squares):.1f}"
        changed = next(_miscounted(candidate), "") if candidate.kind.measured(candidate.question.query).whole else ""
        return f"half a unit in the last place of {changed} changes the count" if changed else ""

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """The condition number."""
        total = sqrt(sum(found.size**2 for found in elasticities(candidate)))
        yield f"the condition number is {total:.2f}; up to {WORST:g} is allowed"


def _miscounted(candidate: Candidate) -> Iterator[str]:
    """The addresses of numbers that change what is counted as soon as they are rounded."""
    study, question = candidate.study, candidate.question
    for parameter in (parameter for given in givens(study.scene, question.left_open) for parameter in given.parameters):
        value = float(study.scene.value(parameter.path))
        half = 0.5 * 10.0 ** -parameter.measure.places(value)
        others = (study.with_values({parameter.path: value + shift}, candidate.until) for shift in (half, -half))
        if any(other is not None and candidate.response(other) != question.answer for other in others):
            yield parameter.path


FILTERS.add("precision", Precision())
