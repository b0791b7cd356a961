"""Tests of shapes of prompts: each can be undone, none is too frequent, and all lead back to the answer."""

from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np
import pytest

from sim2reason.errors import SimulationError, TextError, UnsupportedError
from sim2reason.generation.item_search import sample
from sim2reason.generation.question_search import QuestionSearch
from sim2reason.generation.recipes import RECIPES
from sim2reason.questions import MODES, Question
from sim2reason.questions.difficulty import DIFFICULTIES, Difficulty
from sim2reason.questions.prompt import FORMATS, PLAIN_FORMATS, parse_prompt, shaped, unit_in_words
from sim2reason.questions.shapes import SHAPES
from sim2reason.questions.shapes.layout import is_table, join_units, units
from sim2reason.questions.shapes.numbers import FEWEST
from sim2reason.scenes.bodies.blocks import Block
from sim2reason.scenes.bodies.oscillators import NailedSpring
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.spring_blocks import SpringBlock
from sim2reason.text.prose import describe
from sim2reason.text.prose.description import Description
from sim2reason.text.prose.voices import symbolic_at, symbolic_but_zero

SCENES = [2, pytest.param(6, marks=pytest.mark.slow)]  # of each recipe and difficulty
MOST = 0.32  # of the prompts of a recipe


def asked(
    recipe: str, count: int, difficulties: Sequence[Difficulty] = DIFFICULTIES
) -> Iterator[tuple[QuestionSearch, Question]]:
    """Yield random scenes, each with a question about it."""
    for difficulty in difficulties:
        for seed in range(count):
            try:
                search = QuestionSearch(sample(recipe, difficulty, seed=seed), seed)
            except (SimulationError, UnsupportedError):
                continue
            question = MODES["numeric"].ask(search.study, search.words, "", np.random.default_rng(seed))
            if question is not None:
                yield search, question


def composed(description: Description, question: str) -> dict[str, str]:
    """Return the text in every possible shape, by name."""
    made = {name: shape.compose(description, question, np.random.default_rng(3)) for name, shape in SHAPES.items()}
    return {name: text for name, text in made.items() if text is not None}


def ended(text: str, question: Question) -> str:
    form = FORMATS[0].format(unit=unit_in_words(question.unit)) if question.unit else PLAIN_FORMATS[0]
    return f"{text}\n\n{form}"


@pytest.mark.parametrize("scenes", SCENES)
@pytest.mark.parametrize("recipe", RECIPES)
def test_no_shape_is_drawn_too_often(recipe: str, scenes: int) -> None:
    """The probability of a shape, among those possible for a text and question, is averaged over scenes."""
    chances, number = Counter[str](), 0
    for search, question in asked(recipe, scenes):
        shares = {name: SHAPES[name].share for name in composed(search.description, question.text)}
        total = sum(shares.values())
        chances.update({name: share / total for name, share in shares.items()})  # type: ignore[arg-type]
        number += 1
    assert number >= scenes
    assert max(chances.values()) <= MOST * number, chances
    assert len(chances) >= 5


@pytest.mark.parametrize(
    "difficulties", [("easy",), pytest.param(("medium", "hard"), marks=pytest.mark.slow)], ids="-".join
)
@pytest.mark.parametrize("recipe", RECIPES)
def test_every_shape_leads_back_to_query_and_answer(recipe: str, difficulties: Sequence[Difficulty]) -> None:
    for search, question in asked(recipe, 1, difficulties):
        for name, text in composed(search.description, question.text).items():
            read = parse_prompt(ended(text, question), np.random.default_rng(5))
            assert read.shape == name, text
            assert read.query.kind == question.query.kind, text
            assert read.answer == pytest.approx(question.answer, rel=0.01), text


def test_ten_shapes_are_drawn() -> None:
    search, question = next(asked("pulley", 1))
    drawn = Counter(shaped(search.description, question, np.random.default_rng(n)).shape for n in range(300))
    able = composed(search.description, question.text)
    assert drawn.keys() == able.keys()
    for name, count in drawn.items():  # three standard deviations
        chance = SHAPES[name].share / sum(SHAPES[other].share for other in able)
        assert abs(count - 300 * chance) <= 3.0 * (300 * chance * (1.0 - chance)) ** 0.5
    assert len(SHAPES) >= 6


def first_mass(scene: Scene) -> str:
    return next(p.path for p in scene.parameters if p.measure.name == "mass" and not p.hidden)


def test_what_a_voice_hides_is_in_no_list() -> None:
    search, question = next(found for found in asked("incline", 3) if len(found[0].words.unknowns) > FEWEST)
    scene = search.study.scene
    shown = describe(scene, 4)
    path = first_mass(scene)
    hidden = describe(scene, 4, symbolic_at(path))
    listed = SHAPES["numbers_listed"].compose(hidden, question.text, np.random.default_rng(0))
    usual = SHAPES["numbers_listed"].compose(shown, question.text, np.random.default_rng(0))
    assert listed is not None
    assert usual is not None
    assert f"${hidden.symbols[path]}$ =" not in listed
    assert f"${hidden.symbols[path]}$ =" in usual
    for shape in SHAPES.values():
        text = shape.compose(hidden, question.text, np.random.default_rng(0))
        assert text is None or f"${hidden.symbols[path]}$" in text


def test_a_list_of_symbols_has_no_zeros() -> None:
    """Zeros are in the text, since the list of a symbolic problem would consist of them."""
    springs = (NailedSpring(stiffness=80.0, length=0.3, x=0.0, y=0.0),)
    entity = SpringBlock(block=Block(mass=2.0), springs=springs, x=0.1, y=0.2)
    shown = describe(Scene(entities=(Named(name="table", entity=entity),)))
    compose = SHAPES["numbers_listed"].compose
    listed = compose(shown, "How fast is it?", np.random.default_rng(0))
    assert listed is not None
    assert "(0 m, 0 m)" in listed
    assert "= 0 m" not in listed
    symbols = shown.voiced(symbolic_but_zero)
    assert compose(symbols, "How fast is it?", np.random.default_rng(0)) is None
    assert "($x_1$, $y_1$)" in symbols.text  # the origin takes no index from what is told by symbols


@pytest.mark.parametrize("seed", range(12))
def test_a_list_does_not_begin_as_the_sentence_before_it(seed: int) -> None:
    """Texts such as *Let g = 9.8 m/s². Let $m$ = 2.0 kg and $v$ = 1.5 m/s.* are avoided."""
    description = describe(sample("incline", "medium", seed=seed), seed)
    texts = (SHAPES["numbers_listed"].compose(description, "How?", np.random.default_rng(n)) for n in range(9))
    found = [units(text) for text in texts if text is not None]
    assert found
    for said in found:
        assert not any(one.split()[0] == other.split()[0] in {"Let", "Take", "Use"} for one, other in pairwise(said))


@pytest.mark.parametrize("change", ["kg", "$m"])
def test_a_list_that_lacks_a_number_or_has_one_to_spare_is_refused(change: str) -> None:
    search, question = next(asked("pulley", 1))
    text = SHAPES["numbers_listed"].compose(search.description, question.text, np.random.default_rng(0))
    assert text is not None
    spoiled = text.replace("kg", "m", 1) if change == "kg" else text.replace("$m_A$ = ", "$m_Z$ = ", 1)
    assert spoiled != text
    with pytest.raises(TextError):
        parse_prompt(ended(spoiled, question))


@pytest.mark.parametrize("recipe", ["collision", "springs", "orbital", "box"])
def test_sentences_and_tables_come_apart_and_together(recipe: str) -> None:
    for seed in range(6):
        description = describe(sample(recipe, "medium", seed=seed), seed)
        apart = units(description.text)
        assert join_units(apart) == description.text
        assert sum(map(is_table, apart)) == sum(map(is_table, description.sentences))
        assert len(apart) == len(description.sentences)


def test_symbols_are_numbered_as_they_are_told() -> None:
    for seed in range(6):
        description = describe(sample("incline", "hard", seed=seed), seed)
        told = [description.symbols[path] for path in description.told if path in description.symbols]
        numbered = [symbol for symbol in told if symbol.startswith(r"\theta_")]
        assert numbered == sorted(numbered)
