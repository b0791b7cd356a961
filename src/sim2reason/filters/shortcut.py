"""Drops a question on which too much of the scene has no bearing."""

from collections.abc import Iterator

from sim2reason.filters import FILTERS, Candidate, Filter
from sim2reason.filters.parts.effects import Effect, effects

ALLOWED = {"easy": 0, "medium": 0, "hard": 1}


class Shortcut(Filter):
    """A part of the scene can be held or left out, and the answer stays within the tolerance, or nearly.

    A hard problem in numbers may have one such part, which is recorded as a distraction; other problems have none. What
    changes the answer a little, but might be forgotten, would be paid for.
    """

    order = 6

    def reason(self, candidate: Candidate) -> str:
        """Hold and leave out what can be, part by part."""
        idle = dict[str, Effect]()
        allowed = ALLOWED[candidate.difficulty] if candidate.question.formula is None else 0
        for effect in effects(candidate, part=True):
            if not effect.close:
                continue
            idle.setdefault(effect.subject, effect)
            forgiven = effect.simplification.misleads and not effect.same
            if forgiven or len(idle) > allowed:
                return f"{effect.simplification.name}: {effect.subject} changes the answer by {effect.change:.2g}"
        return ""

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """What each does to the answer."""
        return (effect.told for effect in effects(candidate, part=True))


FILTERS.add("shortcut", Shortcut())
