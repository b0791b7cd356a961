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
from sim2reason.questions.ordinary.hearing import ALL, TokenizedSentence
from sim2reason.questions.ordinary.reading import Reader, Understood
from sim2reason.questions.ordinary.whatif.conditions import StatedCondition, conditions
from sim2reason.questions.ordinary.whatif.frames import WantedFrame, framed
from sim2reason.questions.ordinary.whatif.numbers import is_zero, paths_of
from sim2reason.questions.ordinary.whatif.outcomes import (
    CIRCULAR_SPEED,
    by_outcome,
    moves_nevertheless,
    on_the_other_side,
    slips_nevertheless,
)
from sim2reason.questions.ordinary.whatif.supposed_rows import MULTIPLES
from sim2reason.questions.ordinary.whatif.understanding import of_all
from sim2reason.questions.ordinary.whatif.wording import directed, plainer, told_direction, told_values
from sim2reason.questions.posing import GREATEST, LEAST, MINUS, RATIO, VALUE, PosedQuestion, pose_question
from sim2reason.questions.structured import StructuredQuestion, measured
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


def with_weights(heard: TokenizedSentence, scene: Scene, words: Words) -> TokenizedSentence:
    """Return a sentence with a mass in place of each weight in newtons; unchanged if it asks for a mass or for g."""
    found = _WEIGHT.search(heard.text)
    if found is None or _CHANGES.search(heard.text) or scene.units.spell("N") != "N":
        return heard
    token = re.search(r"@\d+@", found["own"] or found["of"] or "")
    bodies = words.called(Bodies())
    said = heard.subject(token[0]) if token is not None else next(iter(bodies.values())) if len(bodies) == 1 else ""
    name = next((name for name, phrase in bodies.items() if phrase == said), "")
    if not name:
        return heard
    weight = words.mechanism.body[name].mass * float(np.linalg.norm(words.mechanism.gravity))
    value = f"{_factor(found['mult'] or '', heard) * weight:.15g} N"
    text = f"{heard.text[: found.start()]}{found['be']} #{len(heard.numbers)}#{heard.text[found.end() :]}"
    return replace(heard, text=text, numbers=(*heard.numbers, value))


def _factor(said: str, heard: TokenizedSentence) -> float:
    if said.startswith("#"):
        return float(heard.number(said.partition(" ")[0]).partition(" ")[0])
    return next((value for told, value in MULTIPLES.items() if re.fullmatch(told, said)), 1.0)


RESULT_RTOL = 1e-6  # relative: largest difference from the stated result
TRIED = 6  # values of a number tried to see whether a question has an answer
OWN = "mass", "speed", "angular speed", "charge"  # numbers of the subject, if the sentence does not name an owner
MAX_READINGS = 4  # readings of a result for which numbers are sought
_FROM_BOTTOM = re.compile(r"\b(?:at|from) (?:its |circle 's )?(?:bottom|lowest point|lowest position) .*\bround\b")


def number_making_so(
    heard: TokenizedSentence, motion: FollowedMotion, words: Words, reader: Reader
) -> Understood | None:
    """Return the meaning of a sentence that asks for a number by its effect; None if it is no such sentence.

    Raises:
        TextError: the sentence has readings with different answers, or the number does not lead to what is said.
    """
    if _FROM_BOTTOM.search(heard.text) and not is_zero("swing angle", motion.study.scene):
        return None
    heard = with_weights(heard, motion.study.scene, words)
    direction = told_direction(heard.text)
    told = replace(heard, text=plainer(direction.text))
    found: list[Understood] = []
    for frame in directed(framed(told.text, told), direction, told):
        alone = "@0@" if len(heard.subjects) == 1 and "@" not in told.text else ""
        for condition in conditions(frame.condition, frame.subject or alone, told):
            meant = _meant(frame, condition, told, motion, words, reader)
            if meant is not None and not (meant.asked.find == CIRCULAR_SPEED and "direction" in heard.text):
                found.append(_checked(frame, meant, motion))
        if found:
            break
    answers = [each.followed.answer for each in found]
    known = [answer for answer in answers if answer is not None]
    if any(not isclose(answer, known[0], rel_tol=RESULT_RTOL) for answer in known):
        told_ways = dict.fromkeys(each.asked.told for each in found)
        raise TextError("question", "it can be read in several ways", f"did you mean: {' or: '.join(told_ways)}")
    return next((each for each in found if each.followed.answer is not None), next(iter(found), None))


def _meant(
    frame: WantedFrame,
    condition: StatedCondition,
    heard: TokenizedSentence,
    motion: FollowedMotion,
    words: Words,
    reader: Reader,
) -> Understood | None:
    number = frame.number
    if not number.owners and number.kind in OWN and frame.subject:
        number = number._replace(owners=(heard.subject(frame.subject),))
    paths = paths_of(number, motion.study, words)
    if not paths and not number.owners and number.kind in OWN and condition.subject:
        paths = paths_of(number._replace(owners=(condition.subject,)), motion.study, words)
    path = paths[0] if len(paths) == 1 else ""
    frame = frame._replace(number=number)
    found = _bringing_about(frame, condition, path, heard, motion, words, reader)
    if found is not None and frame.compare == VALUE and frame.grows is not None:
        now = number_at(motion.study.scene, path) if path else 0.0
        if found.followed.answer is None or (found.followed.answer > now) != frame.grows:
            raise TextError("question", "it is not so: the number changes the other way", "ask for the number itself")
    return found


def _bringing_about(
    frame: WantedFrame,
    condition: StatedCondition,
    path: str,
    heard: TokenizedSentence,
    motion: FollowedMotion,
    words: Words,
    reader: Reader,
) -> Understood | None:
    """Return the question for the number at an address that meets a condition; None if it has no meaning."""
    if condition.outcome:
        readings = list(by_outcome(frame, condition, path, motion, words))
        found = reader.first_of(readings, motion, words) if readings else None
        if found is None or slips_nevertheless(found) or moves_nevertheless(found, condition, motion, words):
            return None
        if on_the_other_side(found, frame, condition, motion, words):
            raise TextError("question", "it comes about on the other side of that number", "ask for the other end")
        return found
    return _by_result(frame, condition, path, heard, motion, words, reader) if path else None


def _by_result(
    frame: WantedFrame,
    condition: StatedCondition,
    path: str,
    heard: TokenizedSentence,
    motion: FollowedMotion,
    words: Words,
    reader: Reader,
) -> Understood | None:
    """Return the question for the number with which a question has the stated answer."""
    told = replace(heard, text=condition.question)
    found: list[Understood] = []
    for asked, unit in _askable(told, motion, words, reader):
        stated = _stated(condition, asked, unit, motion, words)
        given = f"{asked.find} = {stated}" + (f", {frame.end}" if frame.end else "")
        wanted = StructuredQuestion(path, asked.of, asked.when, asked.along, given, compare=frame.compare)
        try:
            question = pose_question(wanted, motion, words)
        except TextError:
            continue
        unknown = question.unknown
        if unknown is None or not _ever(question, motion):
            continue
        every = _distinct(values_giving(question.query, question.given, unknown, motion.study))
        values = _of_end(frame.end, every if frame.compare != VALUE else told_values(every, path, frame, motion))
        meant = condition._replace(stated=stated)
        leading = [value for value in values if _leads(value, path, told, meant, motion, words, reader)]
        leading = _with_taut_strings(leading, question, path, motion)
        if len(leading) > 1:
            several = ", ".join(f"{value:.6g} {unknown.unit}" for value in leading)
            raise TextError("question", f"several values do: {several}", "ask for the least, or for the greatest")
        if len(every) > 1 and leading:
            end = LEAST if leading[0] == every[0] else GREATEST if leading[0] == every[-1] else ""
            wanted, question = replace(wanted, given=f"{given}, {end}"), replace(question, end=end)
        if leading or not values:
            found.append(Understood(wanted, question, question.followed(motion)))
    answered = [each for each in found if each.followed.answer is not None]
    if len({f"{each.followed.answer:.6g}" for each in answered}) > 1:
        raise TextError("question", "it can be read in several ways", answered[0].asked.told)
    return next(iter(answered or found), None)


def _of_end(end: str, values: list[float]) -> list[float]:
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
    found: list[float] = []
    for value in sorted(values):
        if not found or not isclose(value, found[-1], rel_tol=RESULT_RTOL):
            found.append(value)
    return found


def _stated(
    condition: StatedCondition, asked: StructuredQuestion, unit: str, motion: FollowedMotion, words: Words
) -> str:
    """Return the stated answer with its unit: a number, or a multiple of the answer in the scene as it is."""
    if not condition.factor:
        return condition.stated if " " in condition.stated or not unit else f"{condition.stated} {unit}"
    answer = pose_question(asked, motion, words).followed(motion).answer
    return f"{condition.factor * abs(answer):.15g} {unit}".strip() if answer else ""


def _ever(question: PosedQuestion, motion: FollowedMotion) -> bool:
    """Return whether a question has an answer for any of a few values of the number."""
    assert question.unknown is not None
    scene, path = motion.study.scene, question.unknown.path
    dependence = AnswerFunction(question.query, motion.study, path, COARSE_STEP_ERROR)
    values = range_of(scene, path)
    return any(
        isfinite(dependence(value) or 0.0) and dependence(value) is not None
        for value in (number_at(scene, path), *values[:: len(values) // TRIED])
    )


def _askable(
    heard: TokenizedSentence, motion: FollowedMotion, words: Words, reader: Reader
) -> Iterator[tuple[StructuredQuestion, str]]:
    """Yield the structured questions that a sentence may mean, with units; if the scene answers one, that one only."""
    try:
        plain = of_all(reader, heard, motion, words)
    except TextError:
        plain = None
    if plain is not None and plain.followed.reason.endswith(FOLLOWED_NO_LONGER):
        raise TextError("question", plain.followed.reason, "ask about a stated stretch of time")
    if plain is not None and plain.followed.answer is not None and plain.posed.unknown is None:
        if MINUS not in plain.asked.when:
            yield plain.asked, plain.posed.unit(words)
        return
    found = [*reader.readings(heard, motion, words), *reader.readings(_of_first(heard), motion, words)]
    seen = dict.fromkeys(reading.asked for reading in found)
    for asked in list(seen)[:MAX_READINGS]:
        try:
            question = pose_question(asked, motion, words)
        except TextError:
            continue
        if question.unknown is None and question.less is None:
            yield asked, question.unit(words)


def _of_first(heard: TokenizedSentence) -> TokenizedSentence:
    """Return a question about the first of several bodies in place of all; the others are checked later."""
    first = (said.removeprefix(f"{ALL} ").partition(" & ")[0] for said in heard.subjects)
    return replace(heard, subjects=tuple(first))


def _leads(
    value: float,
    path: str,
    heard: TokenizedSentence,
    condition: StatedCondition,
    motion: FollowedMotion,
    words: Words,
    reader: Reader,
) -> bool:
    """Return whether a question has the stated answer with a value of a number, and its presumptions hold."""
    try:
        there = with_number(motion.study.scene, path, value)
        found = of_all(reader, heard, simulate_scene(there), words_in(there, words))
    except (SceneError, SimulationError, UnsupportedError, TextError, ValueError):
        return False
    if found is None or found.followed.answer is None:
        return False
    stated = measured("question", condition.stated, found.posed.unit(words))
    return isclose(abs(found.followed.answer), abs(stated), rel_tol=RESULT_RTOL, abs_tol=1e-9)


def _checked(frame: WantedFrame, meant: Understood, motion: FollowedMotion) -> Understood:
    """Return a meaning with its answer in the form asked for; TextError if the number changes the other way."""
    answer, path = meant.followed.answer, meant.asked.find
    if frame.compare == VALUE or answer is None:
        return meant
    question = meant.posed
    if question.compare != frame.compare:
        question = replace(question, compare=frame.compare)
        meant = Understood(replace(meant.asked, compare=frame.compare), question, question.followed(motion))
        answer = meant.followed.answer
    if answer is None:
        return meant
    larger = answer > (1.0 if frame.compare == RATIO else 0.0)
    if frame.compare == RATIO and frame.grows is False:
        raise TextError("question", "a factor by which a number is less may be read in two ways", "ask for the number")
    if frame.grows is not None and larger != frame.grows:
        raise TextError("question", f"it is not so: {path} changes the other way", "ask for the number itself")
    return meant
