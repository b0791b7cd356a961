"""Tests of the page on questions, made from the registries, with an example of each thing to ask for."""

import re
import shlex
from pathlib import Path

import pytest

from sim2reason.generation.asked_scenes import ASKED
from sim2reason.generation.example_scenes import OWN
from sim2reason.generation.question_page import COMMAND, format_page
from sim2reason.questions import KINDS, MOMENTS
from sim2reason.questions.following import simulate_scene
from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.questions.ordinary.understanding import understand_sentence
from sim2reason.questions.outcomes import OUTCOMES
from sim2reason.questions.posing import pose_question
from sim2reason.questions.prompt import words_of
from sim2reason.questions.structured import StructuredQuestion
from sim2reason.scenes.dsl.connection import CONNECTIONS
from sim2reason.scenes.dsl.entity import ENTITIES
from sim2reason.scenes.files import loads
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.text.prose.description import describe

PAGE = Path(__file__).parents[2] / "docs" / "questions.md"
RARE: set[str] = set()
"""What no scene of the page has an example of."""
RECORDED = {"inertia tensor, diagonal", "inertia tensor, off the diagonal"}
"""Quantities with several numbers, for which no question can ask."""
ASKING = [(scene.text, sentence) for scene in (*OWN, *ASKED) for sentence in scene.asked]


@pytest.fixture(scope="module")
def page() -> str:
    """Return the page as generated now."""
    return format_page()


def test_the_page_is_up_to_date(page: str) -> None:
    """The page has to be generated again after a new quantity, moment or kind is added."""
    assert PAGE.read_text(encoding="utf-8") == page, f"run: {COMMAND}"


def test_every_member_has_a_row_with_an_example(page: str) -> None:
    """The page covers every registry that questions are made from."""
    for registry in (QUANTITIES, FUNCTIONALS, MOMENTS, KINDS, OUTCOMES):
        for name in registry:
            said = name.replace("_", " ")
            rows = re.findall(rf"^\| {re.escape(said)} \| .* \|$", page, re.MULTILINE)
            assert rows, said
            assert any("`--find " in row for row in rows) or said in RARE | RECORDED, said
            assert any(row.split(" | ")[2].strip() for row in rows), said
            assert said in RECORDED or not any("not asked" in row for row in rows), said


def test_every_connection_has_an_example(page: str) -> None:
    """The example is written as in a scene file."""
    assert all(f"connections:\n- {name}:\n" in page for name in CONNECTIONS)


@pytest.mark.parametrize(("text", "sentence"), ASKING)
def test_ordinary_sentences_are_on_the_page_and_read_back(page: str, text: str, sentence: str) -> None:
    """Each sentence asks the same query as the structured form beside it."""
    scene = loads(text)
    motion, words = simulate_scene(scene), words_of(describe(scene))
    meant = understand_sentence(sentence, motion, words)
    assert meant is not None
    parts = next(row.split(" | ")[3] for row in page.splitlines() if f" | {sentence} | " in row)
    options = dict(zip(*[iter(shlex.split(parts.strip("|` ")))] * 2, strict=True))
    asked = StructuredQuestion(**{name.removeprefix("--"): part for name, part in options.items()})
    assert pose_question(asked, motion, words).query == meant.posed_question.query


def test_every_entity_shows_its_coordinates_or_has_none(page: str) -> None:
    """Entities without coordinates of their own are listed as such."""
    none = page.partition("Of their own these have none: ")[2].partition(".\n")[0].split(", ")
    assert none == ["ConstantForcePuller", "ConstantVelocityPuller", "FixedSupport"]
    rows = set(re.findall(r"^\| (\w+) \| [\w.]+ \| (?:m|rad) \| ", page, re.MULTILINE))
    assert rows.isdisjoint(none)
    assert rows.union(none) >= {cls.__name__ for cls in ENTITIES.values()}
