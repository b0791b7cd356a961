"""Understanding of a question in ordinary English, in all its readings, and suggestions if there is none."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import replace
from math import isclose

import numpy as np

from sim2reason.errors import TextError
from sim2reason.questions.following import FollowedMotion, SimulatedAnswer, simulate_until_event
from sim2reason.questions.kinds import KINDS, moments_by_cause
from sim2reason.questions.kinds.threshold import ThresholdQuery
from sim2reason.questions.moments import Happening, Moment
from sim2reason.questions.moments.times import AtTime, WholeMotion
from sim2reason.questions.moments.turning_points import Halted, Stopped
from sim2reason.questions.ordinary.hearing import TokenizedSentence, tokenize
from sim2reason.questions.ordinary.moment_phrases import DURING, addressed, in_numbers, seen_from
from sim2reason.questions.ordinary.placing import resolve_readings
from sim2reason.questions.ordinary.presumed import bounces_before, check_presumptions, two_sided, unsteadiness_reason
from sim2reason.questions.ordinary.reading import Reader, Reading, UnderstoodQuestion, read_sentence
from sim2reason.questions.ordinary.rewording import reword_question
from sim2reason.questions.ordinary.vocabulary import SLOWER
from sim2reason.questions.ordinary.wanted import numbers_wanted
from sim2reason.questions.ordinary.whatif.blows import read_blow_impulse, read_small_oscillations
from sim2reason.questions.ordinary.whatif.making_so import number_making_so
from sim2reason.questions.ordinary.whatif.two_motions import after_removal_of_things, goes_on_otherwise
from sim2reason.questions.ordinary.whatif.understanding import understand_changed_scene
from sim2reason.questions.posing import PosedQuestion, pose_question
from sim2reason.questions.query import Query, targets
from sim2reason.questions.structured import StructuredQuestion
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.body import BODIES
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.text.prose.description import describe

VECTOR = "velocity"  # the only word that distinguishes a vector from its magnitude
SPEEDS = "speed", "speed relative to its carrier"  # quantities without a sign
_ORIGIN = re.compile(r"\borigin\b")
_RESTATED = re.compile(
    r"(?P<one>.+?) ,? ?\(?(?:i\.e\.?|that is(?: to say)?|in other words|or equivalently) ,? ?"
    r"(?P<other>(?:how|what|when|after|at|with|find) [^()]+)\)?"
)
"""A question that is said a second time in other words."""
ANSWER_RTOL = 1e-6  # relative: answers that differ by less are equal


def understand_sentence(sentence: str, motion: FollowedMotion, words: Words) -> UnderstoodQuestion | None:
    """Return the question that a sentence asks, and its answer; None if the sentence is not understood.

    The question may be about the scene as it is, about a changed scene, or about a number that makes something so.

    Raises:
        TextError: the sentence has several readings with different answers, or a presumption of the sentence fails.
    """
    tokenized = tokenize(sentence, words)
    match = _RESTATED.fullmatch(tokenized.text)
    if match is None:
        return _meant(tokenized, motion, words)
    one, other = (
        _meant(replace(tokenized, text=reword_question(match[key])), motion, words) for key in ("one", "other")
    )
    if one is None or other is None:
        return None
    _agree([one, other], words)
    return other


def _meant(tokenized: TokenizedSentence, motion: FollowedMotion, words: Words) -> UnderstoodQuestion | None:
    """Return the question that a tokenized sentence asks, and its answer; None if it is not understood."""
    meaning = (
        read_small_oscillations(tokenized, motion, words, READER)
        or read_blow_impulse(tokenized, motion, words, READER)
        or understood_as_it_is(tokenized, motion, words)
        or understand_changed_scene(tokenized, motion, words, READER)
        or number_making_so(tokenized, motion, words, READER)
        or after_removal_of_things(tokenized, motion, words, READER)
    )
    if meaning is None and goes_on_otherwise(tokenized.text):
        raise TextError(
            "question",
            "it supposes that something is cut or let go, and it is not clear what follows it, or at which moment",
            "say when it is cut, and ask how much farther or how fast something moves from then on",
        )
    return meaning


def understood_as_it_is(
    tokenized: TokenizedSentence, motion: FollowedMotion, words: Words
) -> UnderstoodQuestion | None:
    """Return the question of a tokenized sentence about the unchanged scene, and its answer; None without one.

    Raises:
        TextError: the sentence has several readings with different answers, or a presumption of the sentence fails.
    """
    return first_of(questions_of(tokenized, motion, words), motion, words)


def questions_of(tokenized: TokenizedSentence, motion: FollowedMotion, words: Words) -> list[Reading]:
    """Return all readings of a tokenized sentence whose subjects and moments exist in the scene."""
    events = simulate_until_event(motion).study.trace.events if words.mechanism.meetings else ()
    candidates = [
        *resolve_readings(read_sentence(tokenized), words, events),
        *numbers_wanted(tokenized, motion.study.scene, words),
    ]
    return (
        [each for each in candidates if _from_origin(each)]
        if _ORIGIN.search(tokenized.text) and starts_off(words)
        else candidates
    )


def starts_off(words: Words) -> bool:
    """Return whether some body does not start at the origin of the text's axes."""
    stated = (each.stated for body in words.mechanism.bodies for each in body.coordinates)
    return any(start is not None and start[1] != 0.0 for start in stated)


def _from_origin(reading: Reading) -> bool:
    """Return whether a reading counts from the origin rather than from a body's starting point."""
    return any(word in f"{reading.asked.find} {reading.asked.when}" for word in ("origin", "coordinate"))


def first_of(questions: list[Reading], motion: FollowedMotion, words: Words) -> UnderstoodQuestion | None:
    """Return the most likely reading of a sentence that the scene answers; None if there is none.

    Raises:
        TextError: there are several readings with different answers, or a presumption fails.
    """
    for rank in sorted({reading.rank for reading in questions}):
        fitting, refused = _of_rank([reading for reading in questions if reading.rank == rank], motion, words)
        answered = [each for each in fitting if each.simulated_answer.answer is not None]
        if refused and not answered:
            raise TextError("question", f"it is not so: {refused}", "ask about what happens, or say when")
        _agree(answered, words)
        if answered or any(not isinstance(each.posed_question.query.moment, WholeMotion | Halted) for each in fitting):
            return next(iter([*answered, *fitting]))
    return None


READER = Reader(understood_as_it_is, questions_of, first_of)


def _of_rank(questions: list[Reading], motion: FollowedMotion, words: Words) -> tuple[list[UnderstoodQuestion], str]:
    """Return the readings that fit a motion, and why the first unfit one does not; an empty reason if all fit."""
    fitting: list[UnderstoodQuestion] = []
    refused = ""
    for reading in questions:
        question = _posed(reading.asked, motion, words)
        if question is None:
            continue
        followed = question.simulate_answer(motion)
        if reading.asked.find in SPEEDS and followed.answer is not None:  # along an axis, it is no velocity
            followed = followed._replace(answer=abs(followed.answer))
        reason = _unfit(reading, question, followed, words)
        refused = refused or reason
        if not reason:
            fitting.append(UnderstoodQuestion(reading.asked, question, followed))
    return fitting, refused


def _posed(structured: StructuredQuestion, motion: FollowedMotion, words: Words) -> PosedQuestion | None:
    """Return the posed question, with addresses in place of unknown phrases; None if it has no meaning."""
    for variant in dict.fromkeys((structured, addressed(structured, words), seen_from(structured, words))):
        try:
            return pose_question(in_numbers(variant, motion, words), motion, words)
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
        vanishes = any(presumption == SLOWER for _, presumption in reading.present_directions)
        during, vector = reading.side == DURING, reading.asked.find == VECTOR and not reading.asked.along
        reason = unsteadiness_reason(query.target, study.trace, during=during, vanishes=vanishes, vector=vector)
        if reason:
            return reason
    elif query.target is not None and query.moment is not None and two_sided(query, study, reading.side):
        return "it changes at once at that moment; ask just before it, or just after it"
    if isinstance(query.moment, Stopped) and bounces_before(query.moment, study.trace):
        return "it bounces before that, and then stops for an instant only"
    return next((reason for reason in check_presumptions(reading, followed, query, words) if reason), "")


def _wrong_end(reading: Reading, question: PosedQuestion) -> str:
    """Return a message if the question asks for the least value but the threshold is a greatest one, or vice versa."""
    query = question.query
    if reading.least is None or not isinstance(query, ThresholdQuery):
        return ""
    below = query.greatest if reading.happens else not query.greatest  # whether what is wanted comes about below it
    return "it comes about on the other side of that number" if below == reading.least else ""


def _agree(meanings: list[UnderstoodQuestion], words: Words) -> None:
    """Raise TextError, which lists all readings of a sentence, if the readings have different answers."""
    answers = [each.simulated_answer.answer for each in meanings]
    if all(isclose(answer or 0.0, answers[0] or 0.0, rel_tol=ANSWER_RTOL, abs_tol=1e-12) for answer in answers):
        return
    wordings = dict.fromkeys(each.posed_question.sentence(words) or each.asked.options for each in meanings)
    raise TextError("question", "it can be read in several ways", f"did you mean: {' or: '.join(wordings)}")


SETTING = frozenset(
    ["circle", "ground", "half-plane", "plane", "rectangle", "space", "start", "strip", "table", "track"]
)
"""Nouns that sentences about any scene may have."""


def missing_object(sentence: str, scene: Scene) -> str:
    """Return a clause that names an object of a sentence that the scene lacks; empty if there is none."""
    sentence_words, scene_words = _singular_words(sentence), _singular_words(describe(scene).text)
    present = {noun for body in scene.bodies.values() for noun in body.nouns}
    nouns = {noun for body in BODIES.values() for noun in body.nouns} - SETTING - present
    missing = sorted(noun for noun in nouns if noun in sentence_words and noun not in scene_words)
    return f"the scene has no {missing[0]}" if missing else ""


def _singular_words(text: str) -> set[str]:
    """Return the words of a text, without the s of plurals."""
    return {word.removesuffix("s") for word in re.findall(r"[a-z-]+", text.lower())}


UNSUPPORTED_TOPICS: Mapping[str, str] = {
    r"semi-?minor": "of the shape of an orbit only the semi-major axis and the eccentricity are quantities here",
    r"radius of (?:the |its )?(?:circle|circular|orbit|path|curvature|motion|trajectory)|amplitude": "the size of a "
    "path is a quantity here only in a magnetic field: ask for the greatest displacement, or for a distance",
    r"magnetic force|electric force|gravitational force|weight of|centripetal force|drag force": "of the forces "
    "that lie in no string, rod, spring or contact only the net one, and those of fields and of a medium, are here",
    r"on (?:the |its )?(?:fixed |light )*pulley": "the force of strings on a pulley is a quantity here only where the "
    "text tells the directions of their parts, which it does not of parts along separate planes",
    r"average|mean (?:speed|velocity|force|power)": "averages are no quantities here: ask for what the motion adds up "
    "to, and for the time",
    r"\bpower\b|at what rate does .*(?:work|energy)": "of powers only those of a hand "
    "and of gravity are asked in sentences: ask for others in parts, such as --find 'power of gravity'",
    r"(?:what|which|find the|the) direction|angle (?:above|below|to|with) the horizontal": "of directions only the "
    "angle of a projectile's velocity with the horizontal is a quantity here: ask for the components",
    r"\d\s?(?:s|seconds?|yr|years?) (?:after|before) (?!t\b|the start|release|launch)|\d\s?s later|next \d|last "
    r"(?:\d|second)": "a time is counted from the start: ask when that happens first, then at a time",
    r"altogether|combined|total (?:momentum|mass) of the \w+s\b|centre of mass of the|of the system": (
        "of sums over several bodies only those of energies of one kind are quantities here: ask for each"
    ),
    r"work (?:is |has |was |does )?(?:the )?(?:done )?(?:by )?(?:the )?(?:friction|gravity|weight|normal)": "of works "
    "those of a hand, a tension and a field are quantities here, and what friction dissipates",
    r"\bratio\b|what (?:fraction|percentage|share)|how many times (?:as|greater|larger|faster)": "a ratio of two "
    "answers is asked for only where a number is changed (--change): ask for both",
    r"\bif (?!the system is|it is released)|\bwere\b|\bwould .* (?:be )?(?:on the moon|on mars)": "what would be "
    "otherwise is asked by a change of a number (--change)",
    r"\b(?:second|third|fourth|next) time\b|\bagain\b": (
        "what happens again has no moment here, but bounces and collisions"
    ),
}
"""By what a sentence has that is not understood: the reason, with what to ask instead."""


def reason(sentence: str) -> str:
    """Return a clause that explains why the library cannot answer a sentence; empty if the reason is unknown."""
    plain = " ".join(sentence.lower().split())
    return next((explanation for like, explanation in UNSUPPORTED_TOPICS.items() if re.search(like, plain)), "")


MAX_SUGGESTIONS = 3
COMMON_WORDS = frozenset(
    re.split(" ", "the a an of is what how find when at in it to and does do for by with that determine")
)


def suggest_rewording(sentence: str, motion: FollowedMotion, words: Words) -> str:
    """Return a hint for a sentence that is not understood: the reason, if known, and similar questions."""
    why = missing_object(sentence, motion.study.scene) or reason(sentence)
    sentence_words = _content_words(sentence)
    offered = dict.fromkeys(question.sentence(words) for question in _offered(motion, words))
    ranked = sorted(
        (suggested for suggested in offered if suggested),
        key=lambda suggested: -len(sentence_words & _content_words(suggested)) / len(_content_words(suggested)),
    )
    near = [suggested for suggested in ranked if sentence_words & _content_words(suggested)]
    label = "did you mean" if near else "questions of this scene, and more by sim2reason ask, are"
    several = " or: ".join((near or ranked)[:MAX_SUGGESTIONS])
    suggested = f"{label}: {several}" if several else "see: sim2reason ask SCENE"
    return f"{why}; {suggested}" if why else suggested


def _content_words(sentence: str) -> set[str]:
    return set(re.findall(r"[a-z]+", sentence.lower())) - COMMON_WORDS


def _offered(motion: FollowedMotion, words: Words) -> Iterator[PosedQuestion]:
    """Yield questions for the time of each kind of event, and for every quantity at an event or a stated time."""
    study = simulate_until_event(motion).study
    rng = np.random.default_rng(0)
    moments: list[Moment] = [moment for cls in moments_by_cause() for moment in list(cls.found(study, words, rng))[:1]]
    for moment in moments:
        if isinstance(moment, Happening) and moment.clause(words) is not None:
            yield PosedQuestion(Query("time_to_event", None, moment))
        if isinstance(moment, Happening | AtTime) and KINDS[moment.kind].finds(words):
            yield from (PosedQuestion(Query(moment.kind, target, moment)) for target in targets(words))
