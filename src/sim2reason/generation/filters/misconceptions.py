"""Effects of misconceptions on an answer, and filters for questions that they leave right."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

from sim2reason.generation.filters import FILTERS, Candidate, Filter
from sim2reason.questions import SimulatedScene
from sim2reason.questions.accuracy import CLEAR_ERROR_FACTOR
from sim2reason.questions.simplifications import (
    MISCONCEPTIONS,
    Misconception,
    MisinterpretedMotion,
    ordered_misconceptions,
)
from sim2reason.questions.simplifications.forces import GravityLeftOut
from sim2reason.questions.simplifications.inertia import rotatable_bodies
from sim2reason.scenes.dsl.mechanism import Mechanism, RigidBody
from sim2reason.scenes.dsl.structure import replace_bodies

UNCHANGED_FRACTION = 0.02  # of the tolerance; smaller changes of an answer count as none
EXTENSION_FACTOR = 3.0  # factor by which the simulated time is extended if the answer does not occur in time


@dataclass(frozen=True, slots=True)
class Effect:
    """The change of the answer if one misconception is applied to one part of the scene."""

    simplification: Misconception
    subject: str
    answer: float | None  # None if there is none any more
    change: float  # relative; infinite if there is no answer
    tolerance: float
    study: SimulatedScene | None  # the scene as it has it; None if there is no motion then

    @property
    def is_unchanged(self) -> bool:
        """Return whether the changed answer equals the correct one, within a small fraction of the tolerance."""
        return self.change < UNCHANGED_FRACTION * self.tolerance

    @property
    def is_accepted(self) -> bool:
        """Return whether the changed answer would be accepted as correct, or nearly."""
        return self.change < CLEAR_ERROR_FACTOR * self.tolerance

    @property
    def is_error(self) -> bool:
        """Return whether the misconception is an error, not a sound approximation that leaves the answer unchanged."""
        return not (self.is_unchanged and self.simplification.sound_if_same)

    @property
    def text(self) -> str:
        """Return in one line which misconception was applied, and how the answer changes."""
        about = f" ({self.subject})" if self.subject else ""
        if self.answer is None:
            return f"{self.simplification.name}{about}: there is no answer any more"
        return f"{self.simplification.name}{about}: {self.answer:.4g}, {self.change:.2g} of the answer away"


def effects(candidate: Candidate, *, part: bool) -> Iterator[Effect]:
    """Yield the changes of the answer by all misconceptions that omit a part of the scene (`part`), or by all others.

    Objects named in the question are never removed or held. Omissions on which answers of this kind never depend, such
    as the initial state for a period of small oscillations, are not errors.
    """
    for simplification in ordered_misconceptions():
        if simplification.part == part:
            yield from find_effects(simplification, candidate)


def find_effects(simplification: Misconception, candidate: Candidate) -> Iterator[Effect]:
    """Yield the changes of the answer by one misconception, for each part of the scene to which it applies."""
    query, study = candidate.question.query, candidate.study
    subjects = [*simplification.subjects(query, study)]
    if not subjects or _is_beside(simplification, candidate):
        return
    spared, until = _protected_subjects(simplification, candidate), _simulated_time(candidate)
    for subject in subjects:
        if subject in spared:
            continue
        other = simplification.simplified(study, subject, until)
        effect = _effect(simplification, subject, candidate, other, candidate.response(other))
        indifferent = other is not None and effect.is_unchanged and candidate.kind.indifferent(query, study, other)
        if simplification.part or not indifferent:
            yield effect


def find_far_effects(candidate: Candidate) -> Iterator[Effect]:
    """Yield the changes of the answer by misconceptions that change the mechanism, with longer simulated motions.

    These are the most expensive effects; their answers are usually far from the correct one.
    """
    query, study = candidate.question.query, candidate.study
    until = EXTENSION_FACTOR * _simulated_time(candidate)
    for simplification in MISCONCEPTIONS.values():
        if isinstance(simplification, MisinterpretedMotion):
            continue
        spared = _protected_subjects(simplification, candidate)
        for subject in simplification.subjects(query, study):
            if subject not in spared:
                other = simplification.simplified(study, subject, until)
                yield _effect(simplification, subject, candidate, other, candidate.far_response(other))


def _effect(
    simplification: Misconception,
    subject: str,
    candidate: Candidate,
    other: SimulatedScene | None,
    answer: float | None,
) -> Effect:
    return Effect(simplification, subject, answer, candidate.change_to(answer), candidate.tolerance, other)


def _protected_subjects(simplification: Misconception, candidate: Candidate) -> set[str]:
    """Return the addresses to which a misconception is not applied: the unknown, and the subjects of the question.

    The empty name stands for the whole scene and is excluded.
    """
    spared = {candidate.question.unknown}
    if simplification.part or simplification.holds:
        query = candidate.question.query
        spared |= {*query.subjects, *(query.moment.subjects if query.moment is not None else ())}
    return spared - {""}


def _simulated_time(candidate: Candidate) -> float:
    return candidate.until if candidate.until is not None else float(candidate.study.trace.state.times[-1])


def _is_beside(simplification: Misconception, candidate: Candidate) -> bool:
    """Return whether a misconception concerns the simulated motion, while the answer does not depend on it."""
    return isinstance(simplification, MisinterpretedMotion) and _is_of_no_motion(candidate)


def _is_of_no_motion(candidate: Candidate) -> bool:
    """Return whether the answer depends only on the scene, as a threshold does, not on the simulated motion."""
    return candidate.question.query.moment is None and candidate.time == 0.0


TURNS = "weight drives it, and bodies that turn resist it by their moments of inertia"
INERTIA_FACTOR = 1.1  # factor on the inertia
MIN_INERTIA_EFFECT = 5e-3  # relative change of the answer from which it depends on the inertia


def turns_by_weight(candidate: Candidate) -> bool:
    """Return whether the answer depends on weight and on the inertia of rotation about a body's own centre.

    Without weight, as in L = m v R of a rolling hoop, the answer may contain the inertia by definition. The test
    increases the inertia slightly, because without any inertia sliding bodies would roll.
    """
    if not rotatable_bodies(candidate.study.mechanism):
        return False
    other = candidate.study.changed("more inertia", _harder_to_turn, candidate.until)
    if candidate.change(other) <= MIN_INERTIA_EFFECT:
        return False
    without = find_effects(MISCONCEPTIONS[GravityLeftOut.name], candidate)
    return any(not effect.is_accepted for effect in without)


def _harder_to_turn(mechanism: Mechanism) -> Mechanism:
    return replace_bodies(mechanism, rotatable_bodies(mechanism), _with_more)


def _with_more(body: RigidBody) -> RigidBody:
    xx, yy, zz, xy, xz, yz = (INERTIA_FACTOR * part for part in body.inertia)
    return replace(body, inertia=(xx, yy, zz, xy, xz, yz))


MAX_DISTRACTIONS = {"easy": 0, "medium": 0, "hard": 1}


class Shortcut(Filter):
    """Filter for questions whose answer stays (nearly) within the tolerance if a part is held fixed or omitted.

    A hard numeric problem may have one such part, which is recorded as a distraction; other problems have none. A part
    with a small effect would allow a solver who forgets it to be graded as correct.
    """

    order = 6

    def reason(self, candidate: Candidate) -> str:
        """Return a reason if too many parts of the scene hardly change the answer when held fixed or omitted."""
        idle = dict[str, Effect]()
        allowed = MAX_DISTRACTIONS[candidate.difficulty] if candidate.question.formula is None else 0
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
    without = (part.study for part in effects(candidate, part=True) if part.is_accepted)
    query, slip = candidate.question.query, effect.simplification
    return any(effect.subject not in slip.subjects(query, study) for study in filter(None, without))


FILTERS.add("simplification", Simplified())
