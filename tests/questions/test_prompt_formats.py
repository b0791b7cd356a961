"""Tests of prompts with several parts, composed and parsed, which describe each moment once."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from plain_scenes import atwood
from sim2reason.errors import TextError
from sim2reason.generation.question_search import QuestionSearch
from sim2reason.questions import KINDS, MODES, Question
from sim2reason.questions.moments import Happening
from sim2reason.questions.moments.times import AtTime
from sim2reason.questions.prompt_formats import (
    AS_PURE,
    AS_WHOLE,
    FORMS,
    REFERENCE_PHRASE,
    PartPrompt,
    build_part_prompt,
    parse_parts,
    resolved_references,
    with_reference,
)
from sim2reason.questions.query import targets

UNITS = st.lists(st.sampled_from(["m/s", "N·s", "degrees", "m/s²", AS_WHOLE, AS_PURE]), min_size=2, max_size=4)
SENTENCES = st.sampled_from(["What is it?", "Find the speed (of A) in m/s.", "How many (a) are there?", "A | b"])


@given(UNITS, st.data())
def test_prompts_are_read_as_they_were_written(units: list[str], data: st.DataObject) -> None:
    texts = tuple(data.draw(SENTENCES) for _ in units)
    scene = data.draw(st.sampled_from(["A scene.", "Two\n\nparagraphs.", "A table:\n\n| a |\n| --- |\n| 1 |"]))
    form = data.draw(st.integers(0, len(FORMS) - 1))
    prompt = PartPrompt(scene, texts, tuple(units), form)
    assert PartPrompt.read(prompt.text) == prompt
    assert prompt.text.count("\\boxed") == 1


@pytest.mark.parametrize(
    "text", ["", "A scene. What is it?", "A.\n\n(a) B?\n(c) D?\n\nGive it.", "A.\n\n(a) B?\n\nGive it."]
)
def test_what_has_no_parts_is_refused(text: str) -> None:
    with pytest.raises(TextError, match="it has no parts"):
        PartPrompt.read(text)


def asked(search: QuestionSearch) -> list[Question]:
    """Return questions for the time of an event, a speed at it, and a sum up to it."""
    rng, mode = np.random.default_rng(4), MODES["multipart"]
    drawn = (KINDS["time_to_event"].draw(search.study, search.words, {}, rng) for _ in range(40))
    first = next(query for query in drawn if query is not None)
    assert isinstance(first.moment, Happening)
    offered = targets(search.words)
    queries = [first]
    for kind in ("event", "sum"):
        found = (KINDS[kind].at(first.moment, search.study, search.words, offered, rng) for _ in range(20))
        queries += [query for query in [next((each for each in found if each is not None), None)] if query is not None]
    questions = [mode.asking(query, search.study, search.words, rng) for query in queries]
    return [question for question in questions if question is not None]


def test_a_moment_is_told_once_and_every_part_is_read_back() -> None:
    search = QuestionSearch(atwood(), 3)
    questions = asked(search)
    assert len(questions) > 1
    for seed in range(6):
        prompt, texts = build_part_prompt(search.description, questions, search.words, np.random.default_rng(seed))
        assert all(REFERENCE_PHRASE in text for text in texts[1:]), texts
        parsed = parse_parts(prompt.text)
        assert [each.query.kind for each in parsed] == [question.query.kind for question in questions]
        assert [each.answer for each in parsed] == pytest.approx([q.answer for q in questions], rel=1e-6)


def test_a_stretch_that_ends_at_a_moment_just_told_lasts_until_then() -> None:
    """The phrase *altogether during the first 0.50 s* became *altogether during the first at that moment* before."""
    search = QuestionSearch(atwood(), 3)
    moment = AtTime(0.5)
    for stretch in moment.stretches(search.words):
        text = f"Find how far A travels in all {stretch}."
        assert with_reference(text, moment, search.words) == f"Find how far A travels in all until {REFERENCE_PHRASE}."
        assert text in resolved_references(with_reference(text, moment, search.words), moment, search.words)


def test_words_for_a_moment_come_back_whatever_the_sentence() -> None:
    search = QuestionSearch(atwood(), 3)
    for question in asked(search):
        kind, moment = KINDS[question.query.kind], question.query.moment
        noun = targets(search.words)[question.query.target] if question.query.target is not None else None
        for shape in kind.shapes(question.query, search.words, noun):
            text = shape[0].upper() + shape[1:]
            short = with_reference(text, moment, search.words)
            assert short == text or text in resolved_references(short, moment, search.words)
    assert with_reference("What is it?", None, search.words) == "What is it?"
    assert not list(resolved_references("What is it at that moment?", None, search.words))
