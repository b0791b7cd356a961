"""Filter for questions with too few relevant or too many irrelevant numbers."""

from collections.abc import Iterator

from sim2reason.generation.filters import FILTERS, Candidate, Filter
from sim2reason.generation.filters.parts.effects import effects
from sim2reason.generation.filters.parts.numbers import (
    EVER,
    Given,
    elasticities,
    givens,
    matters,
    question_number_count,
    shifted,
    shortfall,
)
from sim2reason.scenes.dsl.mechanism import Mechanism

COUNTED = 2  # numbers that must be able to change a count
MAX_IDLE_FRACTION = {"easy": 0.0, "medium": 0.1, "hard": 0.1}  # fraction of irrelevant numbers allowed without a mark


class Sensitivity(Filter):
    """Filter for questions with too few numbers that change the answer, or too many that do not.

    Not counted as irrelevant: numbers of parts that the item marks as distractions, the mass and charge of the subject
    and the radius of a rolling body, which may cancel, and numbers to which the question kind is indifferent.
    """

    order = 7

    def reason(self, candidate: Candidate) -> str:
        """Return a reason if too few numbers change the answer beyond the tolerance when halved or doubled."""
        scene, query = candidate.study.scene, candidate.question.query
        given = [given for given in givens(scene, candidate.question.left_open) if given.owner != "world"]
        aside = [effect.subject for effect in effects(candidate, part=True) if effect.is_accepted]
        own = {path for name in query.subjects for path in _cancelling(candidate.study.mechanism, name)}
        excused = [g for g in given if own & {*g.paths} or any(_belongs(g, name) for name in aside)]
        counted = candidate.kind.measured(query).whole  # which changes with some of the numbers only
        told = len(given) + question_number_count(candidate)
        moving, idle = list[Given](), list[Given]()
        for found in elasticities(candidate):
            if found.given in given:
                (moving if matters(candidate, found) else idle).append(found.given)
            if len(idle) > EVER * told:
                return f"idle numbers: {_paths(idle)}"
            unmarked = [g for g in idle if g not in excused and not _is_indifferent(candidate, g)]
            if not counted and len(unmarked) > MAX_IDLE_FRACTION[candidate.difficulty] * len(given):
                return f"idle numbers: {_paths(unmarked)}"
        if counted:
            return "" if len(moving) >= COUNTED else f"reach: the count changes with {len(moving)} numbers"
        short = shortfall(candidate, moving)
        return f"reach: {short}" if short else ""

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield report lines: the sensitivity of the answer to each stated number."""
        for found in elasticities(candidate):
            moved = "matters" if matters(candidate, found) else "does not matter"
            yield f"{', '.join(found.given.paths)}: |d ln answer / d ln number| = {found.size:.3g}; it {moved}"


def _paths(found: list[Given]) -> str:
    return ", ".join(path for given in found for path in given.paths)


def _is_indifferent(candidate: Candidate, given: Given) -> bool:
    """Return whether a change of a number cannot change answers of this kind, such as of the amplitude for a period."""
    other = shifted(candidate.study, given, candidate.until)
    return other is not None and candidate.kind.indifferent(candidate.question.query, candidate.study, other)


def _cancelling(mechanism: Mechanism, subject: str) -> set[str]:
    """Return the addresses of numbers that may cancel: the subject's mass and charge, and its radius if it rolls."""
    body = _lone(mechanism, subject)
    rolls = body in mechanism.contacts and len(mechanism.contacts[body].slip) > 1
    return {f"{body}.mass", f"{body}.charge", *([f"{body}.radius"] if rolls else [])}


def _lone(mechanism: Mechanism, subject: str) -> str:
    """Return the only body with mass that moves rigidly with the subject, such as a pendulum bob; else the subject."""
    frame = _carrier(mechanism, subject)
    found = [body.name for body in mechanism.bodies if body.mass and _carrier(mechanism, body.name) == frame]
    return found[0] if frame and len(found) == 1 else subject


def _carrier(mechanism: Mechanism, name: str | None) -> str:
    """Return the moving body that a body is, or is fixed to; empty if it is not a body or does not move."""
    body = mechanism.body.get(name or "")
    if body is None:
        return ""
    return body.name if body.coordinates else _carrier(mechanism, body.parent)


def _belongs(given: Given, name: str) -> bool:
    """Return whether a number belongs to the part of that name."""
    return any(path.startswith(f"{name}.") for path in given.paths)


FILTERS.add("sensitivity", Sensitivity())
