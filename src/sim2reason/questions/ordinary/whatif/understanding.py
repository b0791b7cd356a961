"""Understanding of questions about a changed scene, such as *how fast would A be if B were twice as heavy*."""

import re
from collections.abc import Mapping
from dataclasses import replace
from math import isclose

from sim2reason.errors import SceneError, SimulationError, TextError, UnsupportedError
from sim2reason.questions.following import FollowedMotion, SimulatedAnswer, simulate_scene
from sim2reason.questions.ordinary.hearing import TokenizedSentence
from sim2reason.questions.ordinary.moment_phrases import addresses
from sim2reason.questions.ordinary.reading import Reader, UnderstoodQuestion
from sim2reason.questions.ordinary.whatif.numbers import NamedNumber, paths_of
from sim2reason.questions.ordinary.whatif.supposed_rows import FIXED, MORE, NONE, SAME, SWAPPED, TIMES
from sim2reason.questions.ordinary.whatif.suppositions import ChangedQuestion, Supposition, changed_questions
from sim2reason.questions.posing import RATIO
from sim2reason.questions.posing import VALUE as ITSELF
from sim2reason.questions.structured import parse_amount
from sim2reason.questions.unknown import find_limits, number_at
from sim2reason.questions.variation import SceneChange, units_of, words_in
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.simulation.quantities.kinematics import Velocity
from sim2reason.simulation.quantities.subjects.bodies import Bodies, TurningBodies

MIN_NONZERO_VALUE = 1e-9  # the least value of a number that must not be zero, in place of zero
ANSWER_RTOL = 1e-6  # relative: answers that differ by less are equal


def understand_changed_scene(
    sentence: TokenizedSentence, motion: FollowedMotion, words: Words, reader: Reader
) -> UnderstoodQuestion | None:
    """Return the meaning of a sentence as a question about a changed scene; None if it is no such question."""
    for changed_question in changed_questions(sentence.text, sentence):
        varied = _variation(changed_question, motion, words)
        if varied is None:
            continue
        meaning = _answered(changed_question, varied, sentence, motion, words, reader)
        if meaning is not None:
            return meaning
    return None


def _answered(
    changed_question: ChangedQuestion,
    varied: SceneChange,
    sentence: TokenizedSentence,
    motion: FollowedMotion,
    words: Words,
    reader: Reader,
) -> UnderstoodQuestion | None:
    question_sentence = replace(sentence, text=changed_question.question)
    try:
        scene = varied.applied(motion.study.scene)
        there = simulate_scene(scene)
    except (SceneError, SimulationError, UnsupportedError, ValueError) as error:
        raise TextError("question", f"with that change there is no such motion: {error}", "change less") from None
    compare = changed_question.compare
    before = answer_for_all_subjects(reader, question_sentence, motion, words) if compare != ITSELF else None
    if compare != ITSELF and (before is None or not before.simulated_answer.answer):
        return None
    after = answer_for_all_subjects(reader, question_sentence, there, words_in(scene, words))
    if after is None or after.posed_question.unknown is not None:
        return None
    question = replace(after.posed_question, varied=varied, compare=compare)
    structured = replace(after.asked, change=varied.text, compare=compare)
    if compare == ITSELF or after.simulated_answer.answer is None:
        return UnderstoodQuestion(structured, question, after.simulated_answer)
    if before is None or before.asked != after.asked:
        return None
    return UnderstoodQuestion(
        structured, question, _compared(changed_question, before.simulated_answer, after.simulated_answer)
    )


def answer_for_all_subjects(
    reader: Reader, sentence: TokenizedSentence, motion: FollowedMotion, words: Words
) -> UnderstoodQuestion | None:
    """Return the meaning of a question; without a subject, the common answer for all moving bodies."""
    meaning = reader.read(_with_only_subject(sentence, words), motion, words)
    asks = re.match(
        r"(?:what|which) is (?:its |their |common )?(?P<q>acceleration|speed)(?= of system| of blocks| of bodies|$| )",
        sentence.text,
    )
    if meaning is not None or asks is None or "@" in sentence.text:
        return meaning
    bodies = tuple(words.subject_phrases(Bodies()).values())
    rest = sentence.text[asks.end() :].removeprefix(" of system").removeprefix(" of blocks").removeprefix(" of bodies")
    variants = (
        replace(sentence, text=f"what is {asks['q']} of @{n}@{rest}", subjects=bodies) for n in range(len(bodies))
    )
    every = [reader.read(each, motion, words) for each in variants]
    answers = [
        each.simulated_answer.answer for each in every if each is not None and each.simulated_answer.answer is not None
    ]
    alike = len(answers) == len(every) and all(isclose(abs(a), abs(answers[0]), rel_tol=ANSWER_RTOL) for a in answers)
    return every[0] if alike and every else None


def _with_only_subject(sentence: TokenizedSentence, words: Words) -> TokenizedSentence:
    """Return a question such as *what is greatest angular speed* with the only moving or turning body as subject."""
    asks = re.fullmatch(r"what is (?:greatest|least|final) (?P<turns>angular )?(?:speed|velocity)", sentence.text)
    if asks is None:
        return sentence
    alone = tuple(words.subject_phrases(TurningBodies() if asks["turns"] else Bodies()).values())
    alone = sentence.subjects if len(sentence.subjects) == 1 and sentence.subjects[0] in alone else alone
    return replace(sentence, text=f"{sentence.text} of @0@", subjects=alone) if len(alone) == 1 else sentence


def _compared(changed_question: ChangedQuestion, before: SimulatedAnswer, after: SimulatedAnswer) -> SimulatedAnswer:
    """Return the ratio or difference of answers after and before a change; TextError if the presumed growth fails."""
    now, then = before.answer or 0.0, after.answer or 0.0
    if changed_question.grows is not None and (abs(then) > abs(now)) != changed_question.grows:
        raise TextError("question", "it is not so: it changes the other way", "ask by how much it changes")
    if changed_question.compare == RATIO:
        return after._replace(answer=then / now)
    return after._replace(answer=then - now if changed_question.grows is None else abs(then - now))


def _variation(changed_question: ChangedQuestion, motion: FollowedMotion, words: Words) -> SceneChange | None:
    """Return the supposed change of the scene; None if a name denotes no number of the scene."""
    values, fixed = dict[str, float](), list[str]()
    for supposed in changed_question.supposed:
        if supposed.how == FIXED:
            body = addresses(words).get(supposed.number.owners[0])
            if body is None or not words.released:  # else it is not clear from when on
                return None
            fixed.append(body)
            continue
        new_values = _values(supposed, motion, words)
        if not new_values:
            return None
        if supposed.how == SAME:
            continue
        values |= new_values
    return SceneChange(tuple(values.items()), tuple(fixed)) if values or fixed else None


def _values(supposed: Supposition, motion: FollowedMotion, words: Words) -> Mapping[str, float]:
    """Return the new values of the numbers in a supposition, by address; empty if it denotes none."""
    scene = motion.study.scene
    if supposed.how == NONE:
        return _vanishing(supposed.number, motion, words)
    paths = paths_of(supposed.number, motion.study, words)
    if supposed.direction and not _goes(supposed, motion, words):
        return {}
    if supposed.how == SWAPPED:
        return (
            dict(zip(paths, (number_at(scene, path) for path in reversed(paths)), strict=True))
            if len(paths) == 2
            else {}
        )
    if supposed.how == SAME:
        return {path: number_at(scene, path) for path in paths}
    return {path: value for path in paths if (value := _value(supposed, path, scene)) is not None}


def _goes(supposed: Supposition, motion: FollowedMotion, words: Words) -> bool:
    """Return whether a body starts in the stated direction, *up* or *down*."""
    names = [name for name, phrase in words.subject_phrases(Bodies()).items() if phrase in supposed.number.owners]
    rising = float(Velocity.evaluate(motion.study.trace.at(0.0), names[0])[0, 2]) if len(names) == 1 else 0.0
    return rising > 0.0 if supposed.direction == "up" else rising < 0.0


def _value(supposed: Supposition, path: str, scene: Scene) -> float | None:
    now, unit = number_at(scene, path), units_of(scene)[path]
    if supposed.how == TIMES:
        return supposed.factor * now
    bare = unit if unit in ("deg", "") and " " not in supposed.value else ""
    if " " not in supposed.value and not bare and unit:
        return None  # a number without a unit
    try:
        value = parse_amount("question", supposed.value, unit)
    except TextError:
        return None
    return now + supposed.sign * value if supposed.how == MORE else value


def _vanishing(number: NamedNumber, motion: FollowedMotion, words: Words) -> Mapping[str, float]:
    """Return zero for the address of each vanishing number; of friction, for all rough faces if no owner is named."""
    scene = motion.study.scene
    if number.kind != "friction":
        paths = paths_of(number, motion.study, words)
        return {
            path: smallest for path in paths if (smallest := max(0.0, find_limits(scene, path)[0])) <= MIN_NONZERO_VALUE
        }
    friction_paths = [
        path for path in units_of(scene) if path.rpartition(".")[2] in ("friction", "static_friction", "top_friction")
    ]
    rough = [path for path in friction_paths if number_at(scene, path)]
    if number.owners and len(rough) > 1:
        rough = list(paths_of(number, motion.study, words))
    return dict.fromkeys(rough, 0.0)
