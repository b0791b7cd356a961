"""Understanding of a question in ordinary English about a motion: all of its readings must agree in the answer."""

import re
from dataclasses import replace
from math import isclose

from sim2reason.errors import TextError
from sim2reason.questions.following import FollowedMotion, SimulatedAnswer, simulate_until_event
from sim2reason.questions.kinds.threshold import ThresholdQuery
from sim2reason.questions.moments.times import WholeMotion
from sim2reason.questions.moments.turning_points import Halted, Stopped
from sim2reason.questions.ordinary.hearing import TokenizedSentence, tokenize
from sim2reason.questions.ordinary.multiples import in_numbers
from sim2reason.questions.ordinary.placing import placed
from sim2reason.questions.ordinary.presumed import bounces_before, presumed, steady, two_sided
from sim2reason.questions.ordinary.reading import Reader, Reading, Understood, readings
from sim2reason.questions.ordinary.rewording import reworded
from sim2reason.questions.ordinary.vocabulary import SLOWER
from sim2reason.questions.ordinary.wanted import numbers_wanted
from sim2reason.questions.ordinary.whatif.blows import of_blow, of_small_oscillations
from sim2reason.questions.ordinary.whatif.making_so import number_making_so
from sim2reason.questions.ordinary.whatif.two_motions import after_removal_of_things, goes_on_otherwise
from sim2reason.questions.ordinary.whatif.understanding import in_changed_scene
from sim2reason.questions.ordinary.whens import DURING, addressed, seen_from
from sim2reason.questions.posing import PosedQuestion, pose_question
from sim2reason.questions.structured import StructuredQuestion
from sim2reason.questions.words import Words

VECTOR = "velocity"  # the only word that distinguishes a vector from its magnitude
SPEEDS = "speed", "speed relative to its carrier"  # quantities without a sign
_ORIGIN = re.compile(r"\borigin\b")
_RESTATED = re.compile(
    r"(?P<one>.+?) ,? ?\(?(?:i\.e\.?|that is(?: to say)?|in other words|or equivalently) ,? ?"
    r"(?P<other>(?:how|what|when|after|at|with|find) [^()]+)\)?"
)
"""A question that is said a second time in other words."""
ANSWER_RTOL = 1e-6  # relative: answers that differ by less are equal


def understood(sentence: str, motion: FollowedMotion, words: Words) -> Understood | None:
    """Return the question that a sentence asks, and its answer; None if the sentence is not understood.

    The question may be about the scene as it is, about a changed scene, or about a number that makes something so.

    Raises:
        TextError: the sentence has several readings with different answers, or a presumption of the sentence fails.
    """
    heard = tokenize(sentence, words)
    said = _RESTATED.fullmatch(heard.text)
    if said is None:
        return _meant(heard, motion, words)
    one, other = (_meant(replace(heard, text=reworded(said[key])), motion, words) for key in ("one", "other"))
    if one is None or other is None:
        return None
    _agree([one, other], words)
    return other


def _meant(heard: TokenizedSentence, motion: FollowedMotion, words: Words) -> Understood | None:
    """Return the question that a tokenized sentence asks, and its answer; None if it is not understood."""
    found = (
        of_small_oscillations(heard, motion, words, READER)
        or of_blow(heard, motion, words, READER)
        or understood_as_it_is(heard, motion, words)
        or in_changed_scene(heard, motion, words, READER)
        or number_making_so(heard, motion, words, READER)
        or after_removal_of_things(heard, motion, words, READER)
    )
    if found is None and goes_on_otherwise(heard.text):
        raise TextError(
            "question",
            "it supposes that something is cut or let go, and it is not clear what follows it, or at which moment",
            "say when it is cut, and ask how much farther or how fast something moves from then on",
        )
    return found


def understood_as_it_is(heard: TokenizedSentence, motion: FollowedMotion, words: Words) -> Understood | None:
    """Return the question of a tokenized sentence about the unchanged scene, and its answer; None without one.

    Raises:
        TextError: the sentence has several readings with different answers, or a presumption of the sentence fails.
    """
    return first_of(questions_of(heard, motion, words), motion, words)


def questions_of(heard: TokenizedSentence, motion: FollowedMotion, words: Words) -> list[Reading]:
    """Return all readings of a tokenized sentence whose subjects and moments exist in the scene."""
    events = simulate_until_event(motion).study.trace.events if words.mechanism.meetings else ()
    found = [*placed(readings(heard), words, events), *numbers_wanted(heard, motion.study.scene, words)]
    return [each for each in found if _from_origin(each)] if _ORIGIN.search(heard.text) and starts_off(words) else found


def starts_off(words: Words) -> bool:
    """Return whether some body does not start at the origin of the text's axes."""
    stated = (each.stated for body in words.mechanism.bodies for each in body.coordinates)
    return any(place is not None and place[1] != 0.0 for place in stated)


def _from_origin(reading: Reading) -> bool:
    """Return whether a reading counts from the origin rather than from a body's starting point."""
    return any(word in f"{reading.asked.find} {reading.asked.when}" for word in ("origin", "coordinate"))


def first_of(questions: list[Reading], motion: FollowedMotion, words: Words) -> Understood | None:
    """Return the most likely reading of a sentence that the scene answers; None if there is none.

    Raises:
        TextError: there are several readings with different answers, or a presumption fails.
    """
    for rank in sorted({reading.rank for reading in questions}):
        found, refused = _of_rank([reading for reading in questions if reading.rank == rank], motion, words)
        answered = [each for each in found if each.followed.answer is not None]
        if refused and not answered:
            raise TextError("question", f"it is not so: {refused}", "ask about what happens, or say when")
        _agree(answered, words)
        if answered or any(not isinstance(each.posed.query.moment, WholeMotion | Halted) for each in found):
            return next(iter([*answered, *found]))
    return None


READER = Reader(understood_as_it_is, questions_of, first_of)


def _of_rank(questions: list[Reading], motion: FollowedMotion, words: Words) -> tuple[list[Understood], str]:
    """Return the readings that fit a motion, and why the first unfit one does not; an empty reason if all fit."""
    found: list[Understood] = []
    refused = ""
    for reading in questions:
        question = _posed(reading.asked, motion, words)
        if question is None:
            continue
        followed = question.followed(motion)
        if reading.asked.find in SPEEDS and followed.answer is not None:  # along an axis, it is no velocity
            followed = followed._replace(answer=abs(followed.answer))
        reason = _unfit(reading, question, followed, words)
        refused = refused or reason
        if not reason:
            found.append(Understood(reading.asked, question, followed))
    return found, refused


def _posed(asked: StructuredQuestion, motion: FollowedMotion, words: Words) -> PosedQuestion | None:
    """Return the posed question, with addresses in place of unknown phrases; None if it has no meaning."""
    for told in dict.fromkeys((asked, addressed(asked, words), seen_from(asked, words))):
        try:
            return pose_question(in_numbers(told, motion, words), motion, words)
        except TextError:
            continue
    return None


def _unfit(reading: Reading, question: PosedQuestion, followed: SimulatedAnswer, words: Words) -> str:
    """Return why a reading cannot be what a sentence means; empty if the reading is possible."""
    if followed.answer is None:
        return ""
    if question.unknown is not None or isinstance(question.query, ThresholdQuery):
        return _wrong_end(reading, question)
    query, study = question.query, followed.study
    if reading.steady and query.target is not None:
        vanishes = any(way == SLOWER for _, way in reading.moving)
        during, vector = reading.side == DURING, reading.asked.find == VECTOR and not reading.asked.along
        reason = steady(query.target, study.trace, during=during, vanishes=vanishes, vector=vector)
        if reason:
            return reason
    elif query.target is not None and query.moment is not None and two_sided(query, study, reading.side):
        return "it changes at once at that moment; ask just before it, or just after it"
    if isinstance(query.moment, Stopped) and bounces_before(query.moment, study.trace):
        return "it bounces before that, and then stops for an instant only"
    return next((reason for reason in presumed(reading, followed, query, words) if reason), "")


def _wrong_end(reading: Reading, question: PosedQuestion) -> str:
    """Return a message if the question asks for the least value but the threshold is a greatest one, or vice versa."""
    query = question.query
    if reading.least is None or not isinstance(query, ThresholdQuery):
        return ""
    below = query.greatest if reading.happens else not query.greatest  # whether what is wanted comes about below it
    return "it comes about on the other side of that number" if below == reading.least else ""


def _agree(found: list[Understood], words: Words) -> None:
    """Raise TextError, which lists all readings of a sentence, if the readings have different answers."""
    answers = [each.followed.answer for each in found]
    if all(isclose(answer or 0.0, answers[0] or 0.0, rel_tol=ANSWER_RTOL, abs_tol=1e-12) for answer in answers):
        return
    told = dict.fromkeys(each.posed.sentence(words) or each.asked.told for each in found)
    raise TextError("question", "it can be read in several ways", f"did you mean: {' or: '.join(told)}")
