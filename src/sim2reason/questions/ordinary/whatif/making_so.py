"""Questions for a number that causes a result: *what mass must B have for A to slip*."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from math import isclose, isfinite

import numpy as np

from sim2reason.errors import SceneError, SimulationError, TextError, UnsupportedError
from sim2reason.questions.dependence import AnswerFunction
from sim2reason.questions.following import FOLLOWED_NO_LONGER, FollowedMotion, simulate_scene, simulate_until_answer
from sim2reason.questions.inversion import values_giving
from sim2reason.questions.ordinary.hearing import ALL_WORD, TokenizedSentence
from sim2reason.questions.ordinary.reading import Reader, UnderstoodQuestion
from sim2reason.questions.ordinary.whatif.conditions import StatedCondition, read_conditions
from sim2reason.questions.ordinary.whatif.frames import WantedFrame, split_number_question
from sim2reason.questions.ordinary.whatif.numbers import check_single, is_zero, paths_of
from sim2reason.questions.ordinary.whatif.outcomes import (
    CIRCULAR_SPEED,
    by_outcome,
    moves_nevertheless,
    on_the_other_side,
    slips_nevertheless,
)
from sim2reason.questions.ordinary.whatif.supposed_rows import MULTIPLES
from sim2reason.questions.ordinary.whatif.understanding import answer_for_all_subjects
from sim2reason.questions.ordinary.whatif.wording import filter_by_hint, reword_plainly, told_direction, told_values
from sim2reason.questions.posing import GREATEST, LEAST, MINUS, RATIO, VALUE, PosedQuestion, pose_question
from sim2reason.questions.structured import StructuredQuestion, parse_amount
from sim2reason.questions.study import COARSE_STEP_ERROR
from sim2reason.questions.unknown import number_at, range_of, with_number
from sim2reason.questions.variation import words_in
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.simulation.quantities.subjects.bodies import Bodies

_MULTIPLE = f"(?P<mult>{'|'.join(MULTIPLES)}|#\\d+# times)"
_WEIGHT = re.compile(
    rf"\b(?P<be>be|is|become|reach|equal|with) (?:just |exactly |only |equal to )*(?:{_MULTIPLE} )?"
    r"(?:(?P<own>@\d+@ 's|its|ball 's) (?:own )?weight|weight of (?P<of>@\d+@|ball))\b"
)
_CHANGES = re.compile(r"\b(?:mass|heavy|heavier|g|gravity)\b")


def with_weights(sentence: TokenizedSentence, scene: Scene, words: Words) -> TokenizedSentence:
    """Return a sentence with a mass in place of each weight in newtons; unchanged if it asks for a mass or for g."""
    match = _WEIGHT.search(sentence.text)
    if match is None or _CHANGES.search(sentence.text) or scene.units.spell("N") != "N":
        return sentence
    token = re.search(r"@\d+@", match["own"] or match["of"] or "")
    bodies = words.subject_phrases(Bodies())
    owner = sentence.subject(token[0]) if token is not None else next(iter(bodies.values())) if len(bodies) == 1 else ""
    name = next((name for name, phrase in bodies.items() if phrase == owner), "")
    if not name:
        return sentence
    weight = words.mechanism.body[name].mass * float(np.linalg.norm(words.mechanism.gravity))
    value = f"{_factor(match['mult'] or '', sentence) * weight:.15g} N"
    text = f"{sentence.text[: match.start()]}{match['be']} #{len(sentence.numbers)}#{sentence.text[match.end() :]}"
    return replace(sentence, text=text, numbers=(*sentence.numbers, value))


def _factor(multiple: str, sentence: TokenizedSentence) -> float:
    if multiple.startswith("#"):
        return float(sentence.number(multiple.partition(" ")[0]).partition(" ")[0])
    return next((value for regex, value in MULTIPLES.items() if re.fullmatch(regex, multiple)), 1.0)


RESULT_RTOL = 1e-6  # relative: largest difference from the stated result
TRIAL_VALUES = 6  # values of a number tried to see whether a question has an answer
SUBJECT_NUMBERS = "mass", "speed", "angular speed", "charge"  # the subject's, if the sentence does not name an owner
MAX_READINGS = 4  # readings of a result for which numbers are sought
_FROM_BOTTOM = re.compile(r"\b(?:at|from) (?:its |circle 's )?(?:bottom|lowest point|lowest position) .*\bround\b")


def number_making_so(
    sentence: TokenizedSentence, motion: FollowedMotion, words: Words, reader: Reader
) -> UnderstoodQuestion | None:
    """Return the meaning of a sentence that asks for a number by its effect; None if it is no such sentence.

    Raises:
        TextError: the sentence has readings with different answers, or the number does not lead to what is said.
    """
    if _FROM_BOTTOM.search(sentence.text) and not is_zero("swing angle", motion.study.scene):
        return None
    sentence = with_weights(sentence, motion.study.scene, words)
    direction = told_direction(sentence.text)
    plain_sentence = replace(sentence, text=reword_plainly(direction.text))
    meanings: list[UnderstoodQuestion] = []
    for frame in filter_by_hint(split_number_question(plain_sentence.text, plain_sentence), direction, plain_sentence):
        alone = "@0@" if len(sentence.subjects) == 1 and "@" not in plain_sentence.text else ""
        for condition in read_conditions(frame.condition, frame.subject or alone, plain_sentence):
            meaning = _meant(frame, condition, plain_sentence, motion, words, reader)
            if meaning is not None and not (meaning.asked.find == CIRCULAR_SPEED and "direction" in sentence.text):
                meanings.append(_checked(frame, meaning, motion))
        if meanings:
            break
    answers = [each.simulated_answer.answer for each in meanings]
    known = [answer for answer in answers if answer is not None]
    if any(not isclose(answer, known[0], rel_tol=RESULT_RTOL) for answer in known):
        told_ways = dict.fromkeys(each.asked.options for each in meanings)
        raise TextError("question", "it can be read in several ways", f"did you mean: {' or: '.join(told_ways)}")
    return next((each for each in meanings if each.simulated_answer.answer is not None), next(iter(meanings), None))


def _meant(
    frame: WantedFrame,
    condition: StatedCondition,
    sentence: TokenizedSentence,
    motion: FollowedMotion,
    words: Words,
    reader: Reader,
) -> UnderstoodQuestion | None:
    number = frame.number
    if not number.owners and number.kind in SUBJECT_NUMBERS and frame.subject:
        number = number._replace(owners=(sentence.subject(frame.subject),))
    paths = paths_of(number, motion.study, words)
    if not paths and not number.owners and number.kind in SUBJECT_NUMBERS and condition.subject:
        paths = paths_of(number._replace(owners=(condition.subject,)), motion.study, words)
    path = paths[0] if len(paths) == 1 else ""
    frame = frame._replace(number=number)
    meaning = _bringing_about(frame, condition, path, sentence, motion, words, reader)
    if meaning is not None and frame.compare == VALUE and frame.grows is not None:
        now = number_at(motion.study.scene, path) if path else 0.0
        if meaning.simulated_answer.answer is None or (meaning.simulated_answer.answer > now) != frame.grows:
            raise TextError("question", "it is not so: the number changes the other way", "ask for the number itself")
    return meaning


def _bringing_about(
    frame: WantedFrame,
    condition: StatedCondition,
    path: str,
    sentence: TokenizedSentence,
    motion: FollowedMotion,
    words: Words,
    reader: Reader,
) -> UnderstoodQuestion | None:
    """Return the question for the number at an address that meets a condition; None if it has no meaning."""
    if condition.outcome:
        readings = list(by_outcome(frame, condition, path, motion, words))
        meaning = reader.first_of(readings, motion, words) if readings else None
        if meaning is None or slips_nevertheless(meaning) or moves_nevertheless(meaning, condition, motion, words):
            return None
        if on_the_other_side(meaning, frame, condition, motion, words):
            raise TextError("question", "it comes about on the other side of that number", "ask for the other end")
        return meaning
    return _by_result(frame, condition, path, sentence, motion, words, reader) if path else None


def _by_result(
    frame: WantedFrame,
    condition: StatedCondition,
    path: str,
    sentence: TokenizedSentence,
    motion: FollowedMotion,
    words: Words,
    reader: Reader,
) -> UnderstoodQuestion | None:
    """Return the question for the number with which a question has the stated answer."""
    question_sentence = replace(sentence, text=condition.question)
    meanings: list[UnderstoodQuestion] = []
    for structured, unit in _askable(question_sentence, motion, words, reader):
        stated = _stated(condition, structured, unit, motion, words)
        given = f"{structured.find} = {stated}" + (f", {frame.end}" if frame.end else "")
        of, when, along = structured.of, structured.when, structured.along
        wanted = StructuredQuestion(path, of, when, along, given, compare=frame.compare)
        try:
            question = pose_question(wanted, motion, words)
        except TextError:
            continue
        if (unknown := question.unknown) is None or not _ever(question, motion):
            continue
        every = _distinct(values_giving(question.query, question.given, unknown, motion.study))
        told = every if frame.compare != VALUE else told_values(every, path, frame, motion)
        values = _select_extreme(frame.end, told)
        here = path, question_sentence, condition._replace(stated=stated), motion, words, reader
        leading = [value for value in values if _leads(value, *here)]
        leading = _with_taut_strings(leading, question, path, motion)
        check_single(leading, question, unknown, motion)
        if len(every) > 1 and leading:
            end = LEAST if leading[0] == every[0] else GREATEST if leading[0] == every[-1] else ""
            wanted, question = replace(wanted, given=f"{given}, {end}"), replace(question, end=end)
        if leading or not values:
            meanings.append(UnderstoodQuestion(wanted, question, question.simulate_answer(motion)))
    answered = [each for each in meanings if each.simulated_answer.answer is not None]
    if len({f"{each.simulated_answer.answer:.6g}" for each in answered}) > 1:
        raise TextError("question", "it can be read in several ways", answered[0].asked.options)
    return next(iter(answered or meanings), None)


def _select_extreme(end: str, values: list[float]) -> list[float]:
    """Return only the least or greatest of values in ascending order if `end` names one of these; else all values."""
    return values if not end else values[:1] if end == LEAST else values[-1:]


def _with_taut_strings(values: list[float], question: PosedQuestion, path: str, motion: FollowedMotion) -> list[float]:
    """Return the values of a number for which all strings stay taut up to the answer, or else all values."""

    def stays_taut(value: float) -> bool:
        study = simulate_until_answer(
            question.query, simulate_scene(with_number(motion.study.scene, path, value))
        ).study
        time = study.time(question.query.moment) if question.query.moment is not None else None
        until = study.trace.stable_until if time is None else time
        return not any(event.kind in ("slack", "taut") and event.time <= until for event in study.trace.events)

    return [value for value in values if stays_taut(value)] or values if len(values) > 1 else values


def _distinct(values: Sequence[float]) -> list[float]:
    """Return ordered values without near-duplicates, of which the least is kept."""
    distinct: list[float] = []
    for value in sorted(values):
        if not distinct or not isclose(value, distinct[-1], rel_tol=RESULT_RTOL):
            distinct.append(value)
    return distinct


def _stated(
    condition: StatedCondition, structured: StructuredQuestion, unit: str, motion: FollowedMotion, words: Words
) -> str:
    """Return the stated answer with its unit: a number, or a multiple of the answer in the scene as it is."""
    if not condition.factor:
        return condition.stated if " " in condition.stated or not unit else f"{condition.stated} {unit}"
    answer = pose_question(structured, motion, words).simulate_answer(motion).answer
    return f"{condition.factor * abs(answer):.15g} {unit}".strip() if answer else ""


def _ever(question: PosedQuestion, motion: FollowedMotion) -> bool:
    """Return whether a question has an answer for any of a few values of the number."""
    assert question.unknown is not None
    scene, path = motion.study.scene, question.unknown.path
    dependence = AnswerFunction(question.query, motion.study, path, COARSE_STEP_ERROR)
    values = range_of(scene, path)
    return any(
        isfinite(dependence(value) or 0.0) and dependence(value) is not None
        for value in (number_at(scene, path), *values[:: len(values) // TRIAL_VALUES])
    )


def _askable(
    sentence: TokenizedSentence, motion: FollowedMotion, words: Words, reader: Reader
) -> Iterator[tuple[StructuredQuestion, str]]:
    """Yield the structured questions that a sentence may mean, with units; if the scene answers one, that one only."""
    try:
        plain = answer_for_all_subjects(reader, sentence, motion, words)
    except TextError:
        plain = None
    if plain is not None and plain.simulated_answer.reason.endswith(FOLLOWED_NO_LONGER):
        raise TextError("question", plain.simulated_answer.reason, "ask about a stated stretch of time")
    if plain is not None and plain.simulated_answer.answer is not None and plain.posed_question.unknown is None:
        if MINUS not in plain.asked.when:
            yield plain.asked, plain.posed_question.unit(words)
        return
    candidates = [*reader.readings(sentence, motion, words), *reader.readings(_of_first(sentence), motion, words)]
    seen = dict.fromkeys(reading.asked for reading in candidates)
    for structured in list(seen)[:MAX_READINGS]:
        try:
            question = pose_question(structured, motion, words)
        except TextError:
            continue
        if question.unknown is None and question.less is None:
            yield structured, question.unit(words)


def _of_first(sentence: TokenizedSentence) -> TokenizedSentence:
    """Return a question about the first of several bodies in place of all; the others are checked later."""
    first = (subject.removeprefix(f"{ALL_WORD} ").partition(" & ")[0] for subject in sentence.subjects)
    return replace(sentence, subjects=tuple(first))


def _leads(
    value: float,
    path: str,
    sentence: TokenizedSentence,
    condition: StatedCondition,
    motion: FollowedMotion,
    words: Words,
    reader: Reader,
) -> bool:
    """Return whether a question has the stated answer with a value of a number, and its presumptions hold."""
    try:
        there = with_number(motion.study.scene, path, value)
        meaning = answer_for_all_subjects(reader, sentence, simulate_scene(there), words_in(there, words))
    except (SceneError, SimulationError, UnsupportedError, TextError, ValueError):
        return False
    if meaning is None or meaning.simulated_answer.answer is None:
        return False
    stated = parse_amount("question", condition.stated, meaning.posed_question.unit(words))
    return isclose(abs(meaning.simulated_answer.answer), abs(stated), rel_tol=RESULT_RTOL, abs_tol=1e-9)


def _checked(frame: WantedFrame, meaning: UnderstoodQuestion, motion: FollowedMotion) -> UnderstoodQuestion:
    """Return a meaning with its answer in the form asked for; TextError if the number changes the other way."""
    answer, path = meaning.simulated_answer.answer, meaning.asked.find
    if frame.compare == VALUE or answer is None:
        return meaning
    question = meaning.posed_question
    if question.compare != frame.compare:
        question = replace(question, compare=frame.compare)
        meaning = UnderstoodQuestion(
            replace(meaning.asked, compare=frame.compare), question, question.simulate_answer(motion)
        )
        answer = meaning.simulated_answer.answer
    if answer is None:
        return meaning
    larger = answer > (1.0 if frame.compare == RATIO else 0.0)
    if frame.compare == RATIO and frame.grows is False:
        raise TextError("question", "a factor by which a number is less may be read in two ways", "ask for the number")
    if frame.grows is not None and larger != frame.grows:
        raise TextError("question", f"it is not so: {path} changes the other way", "ask for the number itself")
    return meaning
