"""Tests of questions that compare or order two bodies, answered by a name and a number."""

from collections import Counter
from functools import cache

import numpy as np
import pytest

from plain_scenes import atwood
from sim2reason import rewards
from sim2reason.datasets.grade import grade
from sim2reason.datasets.items import item
from sim2reason.errors import TextError
from sim2reason.generation.item import Answer, Distractor, Item
from sim2reason.generation.item_search import sample
from sim2reason.generation.options import OTHER, options_of_two
from sim2reason.generation.question_search import QuestionSearch
from sim2reason.grading import Outcome
from sim2reason.questions import KINDS, MODES
from sim2reason.questions.following import simulate_scene
from sim2reason.questions.kinds.nested import MIN_RELATIVE_DIFFERENCE, WhichKind, WhichQuery
from sim2reason.questions.posing import pose_question
from sim2reason.questions.prompt import parse_prompt, words_of
from sim2reason.questions.prompt_formats import LETTERS, ChoicePrompt, parse_choice
from sim2reason.questions.query import targets
from sim2reason.questions.structured import StructuredQuestion
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.text.prose.description import describe

NAMES = "which_first", "which_greater"
CELLS = [
    ("collision", "medium", "which_first"),
    ("pulley", "medium", "which_greater"),
    ("hybrid", "hard", "which_first"),
]
TRACK = (
    "On a straight smooth horizontal track there are two small balls, named in order of increasing x; along it x is "
    "measured to the right. The position of ball A of mass 3.2 kg at t = 0 is x = −1.44 m; it is then moving with "
    "velocity −0.09 m/s. The position of ball B (4.4 kg) at t = 0 is x = 1.53 m; it is then moving with velocity "
    "−2.86 m/s. All collisions conserve kinetic energy."
)
FORM = "Give your answer to three significant figures, inside \\boxed{}."
SECONDS = "Give your answer in s, to three significant figures, inside \\boxed{}."
MASSES, SPEEDS, MET = (3.2, 4.4), (-0.09, -2.86), (1.53 + 1.44) / (2.86 - 0.09)
CENTRE = (MASSES[0] * SPEEDS[0] + MASSES[1] * SPEEDS[1]) / sum(MASSES)
AFTER = tuple(2.0 * CENTRE - speed for speed in SPEEDS)


@cache
def made(recipe: str, difficulty: str, kind: str, units: str = "SI") -> Item:
    only = {name: float(name == kind) for name in KINDS}
    return item(recipe, difficulty, "choice", seed=1, weights=only, units=units, solutions=True)


def test_which_is_farther_and_by_what_factor() -> None:
    """Two balls in an elastic collision keep the velocity of their centre of mass."""
    time = 2.4
    far = [abs(speed * MET + after * (time - MET)) for speed, after in zip(SPEEDS, AFTER, strict=True)]
    asked = "Which of ball B and ball A is farther from its starting point at the time t = 2.4 s, and by what factor?"
    read = parse_prompt(f"{TRACK} {asked} {FORM}")
    assert read.asked.mode == "choice"
    assert read.query.subject.endswith("gliders.0")
    assert read.answer == pytest.approx(far[0] / far[1], rel=1e-6)


@pytest.mark.parametrize("pair", ["ball A and ball B", "ball B and ball A"])
def test_which_is_the_first_and_how_much_earlier(pair: str) -> None:
    distance = 2.0
    times = [
        MET + (distance + speed * MET) / -after if abs(speed) * MET < distance else distance / abs(speed)
        for speed, after in zip(SPEEDS, AFTER, strict=True)
    ]
    asked = f"Which of {pair} is the first to be 2.0 m from its starting point, and how much earlier than the other?"
    read = parse_prompt(f"{TRACK} {asked} {SECONDS}")
    assert read.query.subject.endswith(f"gliders.{int(times[1] < times[0])}")
    assert read.answer == pytest.approx(abs(times[0] - times[1]), rel=1e-6)


def test_only_values_of_one_quantity_are_compared() -> None:
    """Of blocks of 3 kg and 2 kg with a common speed, kinetic energies may be compared, not one with a momentum."""
    study = simulate_scene(atwood()).study
    words = words_of(describe(atwood()))
    asked = "Which of block A and block B has the greater kinetic energy at the time t = 0.5 s, and by what factor?"
    pairs = list(KINDS["which_greater"].parsed(asked, study, words, targets(words)))
    both = [pair.both for pair in pairs if isinstance(pair, WhichQuery)]
    quantities = [{each.target.quantity for each in pair if each.target is not None} for pair in both]
    assert {"kinetic energy"} in quantities
    assert all(len(each) == 1 for each in quantities)


def test_only_options_ask_for_one_of_two() -> None:
    asking = {name for name, mode in MODES.items() if not mode.kinds.isdisjoint(NAMES)}
    assert asking == {"choice"}
    study = simulate_scene(atwood()).study
    words = words_of(describe(atwood()))
    draws = (MODES["numeric"].ask(study, words, "", np.random.default_rng(seed)) for seed in range(40))
    assert not {question.query.kind for question in draws if question is not None} & {*NAMES}


@pytest.mark.parametrize("name", NAMES)
def test_the_sign_says_which_and_what_is_nearly_equal_is_not_asked(name: str) -> None:
    kind, drawn = KINDS[name], 0
    assert isinstance(kind, WhichKind)
    for recipe in ("collision", "pulley", "pendulum"):
        for seed in range(7):
            search = QuestionSearch(sample(recipe, "medium", seed=seed), 1)
            query = kind.draw(search.study, search.words, targets(search.words), np.random.default_rng(seed))
            if query is None:
                continue
            assert isinstance(query, WhichQuery)
            drawn += 1
            answer = kind.answer(query, search.study)
            assert answer is not None
            assert answer > 0.0
            assert kind.answer(query.exchanged, search.study) == pytest.approx(-answer)
            values = sorted(KINDS[each.kind].answer(each, search.study) or 0.0 for each in query.both)
            assert values[1] - values[0] > MIN_RELATIVE_DIFFERENCE * values[1]
            assert kind.oriented(query.exchanged, search.study) == query
            assert kind.time(query, search.study) == max(
                KINDS[each.kind].time(each, search.study) or 0.0 for each in query.both
            )
            assert len(query.subjects) > 1
    assert drawn > 2


@pytest.mark.parametrize("units", ["SI", "cgs"])
@pytest.mark.parametrize("cell", CELLS)
def test_both_names_stand_beside_both_numbers(cell: tuple[str, str, str], units: str) -> None:
    told = made(*cell, units)
    answer, prompt = told.answer, ChoicePrompt.read(told.prompt)
    assert told.kind == cell[2]
    assert prompt.options == answer.texts
    assert Counter(Counter(f"{abs(value):.9g}" for value in answer.options).values()) == {2: 2}
    assert Counter(value > 0.0 for value in answer.options) == {True: 2, False: 2}
    assert answer.options[LETTERS.index(answer.letter)] == answer.value > 0.0
    assert answer.told == f"{answer.letter}. {answer.texts[answer.options.index(answer.value)]}"
    assert {wrong.simplification for wrong in told.distractors} > {OTHER}
    assert all(wrong.reason for wrong in told.distractors)


@pytest.mark.parametrize("cell", CELLS)
def test_the_letter_or_the_words_of_its_option_are_right(cell: tuple[str, str, str]) -> None:
    told = made(*cell)
    for letter, text in zip(LETTERS, told.answer.texts, strict=False):
        right = float(letter == told.answer.letter)
        for said in (letter, f"{letter}. {text}", text, rf"\text{{{text}}}"):
            assert grade(told, rewards.boxed(said)).reward == right
            assert rewards.score(rewards.ground_truth(told), rewards.boxed(said)).reward == right
    other = LETTERS[(LETTERS.index(told.answer.letter) + 1) % len(told.answer.texts)]
    right = told.answer.texts[LETTERS.index(told.answer.letter)]
    for unclear in (f"{told.answer.value:.3g}", f"{other}. {right}"):
        assert grade(told, rewards.boxed(unclear)).outcome == Outcome.UNREADABLE


@pytest.mark.parametrize("cell", CELLS)
def test_it_reads_back_with_the_same_answer(cell: tuple[str, str, str]) -> None:
    told = made(*cell)
    parsed = parse_choice(told.prompt, told.answer.unit)
    assert (parsed.asked.mode, parsed.query.kind) == ("choice", told.kind)
    assert parsed.query.subject.partition(".")[2] == told.asked.subject.partition(".")[2]
    assert parsed.answer == pytest.approx(told.answer.value, rel=1e-6)


def test_a_wrong_number_that_is_near_or_none_makes_no_choice() -> None:
    def wrong(value: float) -> Distractor:
        return Distractor(value=value, simplification="x", reason="X.")

    answer = Answer(value=1.5, unit="s")
    assert options_of_two(answer, [], "name") is None
    assert options_of_two(answer, [wrong(1.55), wrong(-1.6)], "name") is None
    found = options_of_two(answer, [wrong(1.55), wrong(-2.0)], "name")
    assert found is not None
    assert sorted(each.value for each in found if each is not None) == [-2.0, -1.5, 2.0]
    places = Counter((options_of_two(answer, [wrong(2.0)], f"item-{n}") or ()).index(None) for n in range(400))
    assert all(60 < places[place] < 140 for place in range(4))


def answered(scene: Scene, **parts: str) -> tuple[str, float | None]:
    """Return the subject and the number that answer a structured question."""
    motion = simulate_scene(scene)
    question = pose_question(StructuredQuestion.read(parts), motion, words_of(describe(scene)))
    return question.query.subject, question.simulate_answer(motion).answer


def test_two_subjects_or_two_moments_in_parts() -> None:
    track = parse_prompt(
        f"{TRACK} What is the speed of ball A at t = 2.4 s? {SECONDS.replace('in s,', 'in m/s,')}"
    ).scene
    slow, fast = sorted(map(abs, AFTER))
    subject, ratio = answered(track, find="speed", of="ball A or ball B", when="t = 2.4 s")
    assert subject.endswith(f"gliders.{int(abs(AFTER[1]) == fast)}")
    assert ratio == pytest.approx(fast / slow, rel=1e-6)
    _, earlier = answered(track, find="time", when="ball A moved 2 m or ball B moved 2 m")
    assert earlier is not None
    assert earlier > 0.0
    with pytest.raises(TextError, match="there is no 'ball C'"):
        answered(track, find="speed", of="ball A or ball C", when="t = 2.4 s")
