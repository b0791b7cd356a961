"""Filters for questions that a misconception answers correctly."""

from collections.abc import Iterator

from sim2reason.generation.filters import FILTERS, Candidate, Filter
from sim2reason.generation.filters.parts.effects import Effect, effects

ALLOWED = {"easy": 0, "medium": 0, "hard": 1}


class Shortcut(Filter):
    """Filter for questions whose answer stays (nearly) within the tolerance if a part is held fixed or omitted.

    A hard numeric problem may have one such part, which is recorded as a distraction; other problems have none. A part
    with a small effect would allow a solver who forgets it to be graded as correct.
    """

    order = 6

    def reason(self, candidate: Candidate) -> str:
        """Return a reason if too many parts of the scene hardly change the answer when held fixed or omitted."""
        idle = dict[str, Effect]()
        allowed = ALLOWED[candidate.difficulty] if candidate.question.formula is None else 0
        for effect in effects(candidate, part=True):
            if not effect.is_accepted:
                continue
            idle.setdefault(effect.subject, effect)
            forgiven = effect.simplification.misleads and not effect.is_unchanged
            if forgiven or len(idle) > allowed:
                return f"{effect.simplification.name}: {effect.subject} changes the answer by {effect.change:.2g}"
        return ""

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield report lines: the effect on the answer of each part's omission or fixing."""
        return (effect.text for effect in effects(candidate, part=True))


FILTERS.add("shortcut", Shortcut())


class Simplified(Filter):
    """Filter for questions that a misconception answers (nearly) correctly.

    A misconception without effect is allowed if it concerns only a part that the item marks as a distraction.
    """

    order = 4

    def reason(self, candidate: Candidate) -> str:
        """Return a reason if a misconception leads (nearly) to the correct answer."""
        for effect in effects(candidate, part=False):
            if (
                effect.is_accepted
                and effect.is_error
                and not (effect.is_unchanged and _is_about_a_marked_part(effect, candidate))
            ):
                return f"{effect.simplification.name}: the answer changes by {effect.change:.2g}"
        return ""

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield report lines: the effect of each misconception on the answer."""
        return (effect.text for effect in effects(candidate, part=False))


def _is_about_a_marked_part(effect: Effect, candidate: Candidate) -> bool:
    """Return whether a misconception concerns only parts that the item will mark as distractions."""
    without = (part.study for part in effects(candidate, part=True) if part.is_accepted and part.study is not None)
    query, slip = candidate.question.query, effect.simplification
    return any(effect.subject not in slip.subjects(query, study) for study in without)


FILTERS.add("simplification", Simplified())
