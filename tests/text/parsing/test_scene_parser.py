"""Tests of the scene parser: the same scene, only from the whole text, and nothing from junk."""

import random
import re
import time
from collections.abc import Iterator
from contextlib import suppress
from itertools import pairwise

import numpy as np
import pytest

import sim2reason
from scene_files import composed
from sim2reason.base.yaml_text import write
from sim2reason.errors import DrawError, SceneError, SimulationError, TextError, UnsupportedError
from sim2reason.generation.recipes import RECIPES
from sim2reason.questions.difficulty import DIFFICULTIES, Difficulty
from sim2reason.scenes.dsl.body import Body
from sim2reason.scenes.dsl.connection import CONNECTIONS, Link
from sim2reason.scenes.dsl.entity import ENTITIES, Named, Part
from sim2reason.scenes.dsl.measures import show_unit
from sim2reason.scenes.dsl.model import field_types
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.template import Each, PartLines, slots, wordings
from sim2reason.scenes.entities.two_d_collision_plane import PairRestitution
from sim2reason.scenes.files import load
from sim2reason.simulation.engines.exact import simulate
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.testing.checks.texts import (
    join_sentences,
    meaning,
    numbers,
    optional_sentences,
    text_signature,
    without_one,
)
from sim2reason.text.parsing import parse_scene
from sim2reason.text.parsing.equivalence import Signature, signature
from sim2reason.text.parsing.ordinary.content import forms
from sim2reason.text.parsing.sentences import MAX_CHARACTERS, MAX_PIECES, split_pieces
from sim2reason.text.prose.description import Description, describe

TIERS = [(recipe, difficulty) for recipe in RECIPES for difficulty in DIFFICULTIES]
MEDIUM = [(recipe, "medium") for recipe in RECIPES]
SCENES = [4, pytest.param(18, marks=pytest.mark.slow)]  # of each tier: 810 in all
QUICK = 2.0  # s, for any text at all on a busy machine; it is about 0.02 s on an idle one


def drawn(recipe: str, difficulty: Difficulty, count: int, first: int = 0) -> Iterator[Description]:
    """Yield descriptions of random valid scenes of a tier, each with wordings of its own."""
    found, index = 0, first
    while found < count:
        try:
            yield describe(RECIPES[recipe](difficulty, np.random.default_rng([5, index])), index)
            found += 1
        except (SceneError, DrawError):
            pass
        index += 1


def accelerations(scene: Scene, names: dict[str, str]) -> dict[str, np.ndarray]:
    """Return the initial acceleration of every body by its name in the text, (3,) each, in m/s²."""
    state = simulate(scene.mechanism, np.array([0.0, 1e-6])).state
    moving = {name: address for name, address in names.items() if address in scene.mechanism.body}
    return {name: QUANTITIES["acceleration"].evaluate(state, address)[0] for name, address in moving.items()}


@pytest.mark.parametrize("scenes", SCENES)
@pytest.mark.parametrize(("recipe", "difficulty"), TIERS)
def test_every_scene_is_read_back(recipe: str, difficulty: Difficulty, scenes: int) -> None:
    for number, description in enumerate(drawn(recipe, difficulty, scenes)):
        reading = parse_scene(description.text, np.random.default_rng(number))
        assert text_signature(reading) == meaning(description), description.text
        assert numbers(reading.scene) == numbers(description.scene), description.text
        for address in description.names.letters:
            assert description.mention(address) in reading.names


@pytest.mark.parametrize("chunk", [0, *(pytest.param(chunk, marks=pytest.mark.slow) for chunk in (1, 2, 3))])
def test_scenes_that_no_recipe_draws_are_read_back(chunk: int) -> None:
    """Scenes include entities that nothing joins, two tables, and hanging bodies at rest."""
    read_back = 0
    for index in range(60):
        try:
            description = describe(load(write(composed(np.random.default_rng([chunk, index])))), index)
        except SceneError:
            continue
        assert text_signature(parse_scene(description.text)) == meaning(description), description.text
        read_back += 1
    assert read_back > 20


@pytest.mark.parametrize("scenes", [4, pytest.param(12, marks=pytest.mark.slow)])
@pytest.mark.parametrize(("recipe", "difficulty"), TIERS)
def test_what_is_read_moves_alike(recipe: str, difficulty: Difficulty, scenes: int) -> None:
    """The exact engine compares the accelerations; hidden numbers may differ."""
    compared = 0
    for number, description in enumerate(drawn(recipe, difficulty, scenes, first=500)):
        reading = parse_scene(description.text, np.random.default_rng(number))
        said = {description.mention(address): address for address in description.scene.bodies}
        try:
            meant = accelerations(description.scene, said)
        except (SimulationError, UnsupportedError):
            continue
        found = accelerations(reading.scene, reading.names)
        for name in meant.keys() & found.keys():
            assert found[name] == pytest.approx(meant[name], rel=1e-9, abs=1e-9), (name, description.text)
            compared += 1
    assert compared > 0.8 * scenes


@pytest.mark.parametrize("count", [4, pytest.param(12, marks=pytest.mark.slow)])
@pytest.mark.parametrize(("recipe", "difficulty"), TIERS)
def test_all_wordings_of_a_scene_are_the_same_scene(recipe: str, difficulty: Difficulty, count: int) -> None:
    scene = next(drawn(recipe, difficulty, 1, first=900)).scene
    for seed in range(count):
        description = describe(scene, seed)
        assert text_signature(parse_scene(description.text)) == meaning(description), description.text


@pytest.mark.parametrize(
    ("recipe", "difficulty", "scenes"),
    [*((*tier, 1) for tier in MEDIUM), *(pytest.param(*tier, 5, marks=pytest.mark.slow) for tier in TIERS)],
)
def test_nothing_can_be_left_out(recipe: str, difficulty: Difficulty, scenes: int) -> None:
    """A text without a sentence or table row has no meaning or another one, apart from optional parts.

    `testing/test_entities` checks each entity in this way.
    """
    for description in drawn(recipe, difficulty, scenes, first=1000):
        for cut, text in without_one(list(split_pieces(description.text))):
            if cut in optional_sentences(description):
                continue
            try:
                reading = parse_scene(text)
            except TextError:
                continue
            assert text_signature(reading) != meaning(description), text


@pytest.mark.parametrize(
    ("recipe", "difficulty", "scenes"),
    [*((*tier, 1) for tier in MEDIUM), *(pytest.param(*tier, 3, marks=pytest.mark.slow) for tier in TIERS)],
)
def test_another_number_is_another_scene(recipe: str, difficulty: Difficulty, scenes: int) -> None:
    for description in drawn(recipe, difficulty, scenes, first=1100):
        for match in re.finditer(r"(?<![\w.])\d+(\.\d+)?(?= (kg|N|m)\b|°|\.|\))", description.text):
            digits = match.group()
            other = digits[:-1] + str((int(digits[-1]) + 1) % 10)
            try:
                reading = parse_scene(description.text[: match.start()] + other + description.text[match.end() :])
            except TextError:
                continue
            assert text_signature(reading) != meaning(description), (digits, other, description.text)


@pytest.mark.parametrize(("recipe", "difficulty"), TIERS)
def test_two_swapped_numbers_are_another_scene(recipe: str, difficulty: Difficulty) -> None:
    for description in drawn(recipe, difficulty, 3, first=1200):
        masses = list(re.finditer(r"\d+(\.\d+)?(?= kg)", description.text))
        for one, other in pairwise(masses):
            if one.group() == other.group():
                continue
            between = description.text[one.end() : other.start()]
            before, after = description.text[: one.start()], description.text[other.end() :]
            text = f"{before}{other.group()}{between}{one.group()}{after}"
            try:
                read = parse_scene(text)
            except TextError:  # such a scene can't be: a rocket is not lighter with its fuel
                continue
            assert text_signature(read) != meaning(description), text


def _table() -> Scene:
    """Return a scene with three pucks on a table."""
    return next(t.scene for t in drawn("collision", "hard", 50) if t.scene.entities[0].name == "table")


@pytest.mark.parametrize("count", [0, 1, 2, 3])
def test_pairs_with_a_restitution_of_their_own(count: int) -> None:
    scene = _table()
    *_, last = pucks = scene.value("table.pucks")
    scene = scene.having("table.pucks", (*pucks, last.model_copy(update={"x": -last.x, "y": 1.5 - last.y})))
    pairs = [(0, 1), (1, 3), (0, 2)][:count]
    own = tuple(PairRestitution(first=a, second=b, restitution=0.25 + 0.1 * a) for a, b in pairs)
    scene = scene.having("table.pairs", own).having("table.restitution", 0.7)
    for seed in range(6):
        description = describe(scene, seed)
        assert text_signature(parse_scene(description.text)) == meaning(description), description.text


def test_columns_that_agree_are_read_from_their_sentence() -> None:
    scene = _table()
    for index in range(3):
        scene = scene.having(f"table.pucks.{index}.mass", 2.0).having(f"table.pucks.{index}.vy", 0.0)
    description = describe(scene, 1)
    assert description.text.count("Each has") == 2
    assert text_signature(parse_scene(description.text)) == meaning(description)


def test_a_string_whose_entities_are_told_the_other_way_round() -> None:
    """The string sentence begins at the end that makes the better sentence, not at the first link."""
    plane = ENTITIES["TwoSideMassPlane"].model_validate(
        {"plane": {"angle": 30.0, "friction": 0.0}, "blocks": ({"mass": 2.0},)}
    )
    bight = ENTITIES["MassWithReverseMovablePulley"].model_validate({"pulley": {"mass": 0.5}, "load": {"mass": 3.0}})
    hook = ENTITIES["FixedSupport"]()
    string = CONNECTIONS["tendon"]
    entities = (Named(name="c", entity=hook), Named(name="b", entity=bight), Named(name="a", entity=plane))
    links = tuple(Link(entity=name, port=port) for name, port in (("c", "end"), ("b", "under"), ("a", "right")))
    description = describe(Scene(entities=entities, connections=(string(links=links),)))
    reading = parse_scene(description.text)
    assert text_signature(reading) == meaning(description)
    assert [link.port for link in reading.scene.connections[0].links][:2] == ["end", "under"]


def test_hidden_numbers_are_drawn_anew_and_change_nothing() -> None:
    description = next(drawn("pulley", "medium", 1))
    readings = [parse_scene(description.text, np.random.default_rng(seed)) for seed in (1, 2, 1)]
    assert readings[0].scene == readings[2].scene == parse_scene(description.text, np.random.default_rng(1)).scene
    assert readings[0].scene != readings[1].scene
    assert text_signature(readings[0]) == text_signature(readings[1])


def test_line_breaks_and_spaces_do_not_matter() -> None:
    description = next(drawn("pulley", "medium", 1))
    assert text_signature(parse_scene(description.text.replace(" ", "\n  "))) == meaning(description)


@pytest.mark.parametrize("kind", [*ENTITIES.values()], ids=[*ENTITIES])
def test_whether_a_line_is_said_does_not_depend_on_its_wording(kind: type[Part]) -> None:
    """Otherwise a text could have one sentence less and the same meaning."""
    for part in [kind, *(model for held in field_types(kind).values() for model in held.models)]:
        for saying in getattr(part, "says", ()):
            reasons = {frozenset(reasons_to_be_silent(part, text)) for text in wordings(saying)}
            assert isinstance(saying, Each | PartLines) or len(reasons) == 1


def reasons_to_be_silent(part: type[Part], text: str) -> Iterator[str]:
    """Yield the fields that a line needs and that may be absent or be expressed by a word."""
    fields = field_types(part)
    for slot in slots(text):
        owner, _, name = slot.path.rpartition(".")
        if slot.kind == "path" and slot.path in fields and fields[slot.path].optional:
            yield slot.path
        for model in fields[owner].models if slot.kind == "path" and owner in fields else ():
            if issubclass(model, Body) and name in {word.parameter for word in model.introduced_words()}:
                yield slot.path


STORY = (
    "A light string tied to block A of mass 2.0 kg runs straight up, passes over a light fixed pulley P,"
    " then over a light fixed pulley Q and runs straight down to block B (3.0 kg)."
)
HANGS = (
    "hangs on a light string that passes over a light fixed pulley"
    " and is pulled at its far end by a hand with a constant force of 9.0 N."
)
HOSTILE = {
    "nothing": "",
    "spaces": " \n\t ",
    "junk": "x" * 100_000,
    "long": "a " * (MAX_CHARACTERS // 2),
    "sentences": "A. " * (MAX_PIECES + 1),
    "braces": "{" * 5_000 + "}" * 5_000,
    "nesting": "(" * 9_000 + ".",
    "code": "__import__('os').system('true'). {0.__class__}.",
    "many digits": f"A block of mass {'9' * 19_000} kg {HANGS}",
    "huge": f"A block of mass 1e308 kg {HANGS}",
    "infinite": f"A block of mass 1e999 kg {HANGS}",
    "negative": f"A block of mass \N{MINUS SIGN}1.0 kg {HANGS}",
    "other digits": f"A block of mass ٣.٢ kg {HANGS}",
    "controls": "\x00\u202e\ufeff\ud7ff" * 500,
    "other letters": STORY.replace("A", "\N{GREEK CAPITAL LETTER ALPHA}"),
    "shouted": STORY.upper(),
    "same block again": f"Block A of mass 1.0 kg {HANGS} " * 50,
    "many blocks": " ".join(f"Block {letter} of mass 1.0 kg {HANGS}" for letter in "ABCDEFGHIJKLMN"),
    "many listed": "Blocks " + ", ".join(f"{letter} (1.0 kg)" for letter in "ABCDEFGHIJKLM") + " and N (1.0 kg) hang.",
    "empty table": "|\n|\n|\n",
    "table": "The discs at t = 0 are these.\n\n| disc | $m$ (kg) |\n| --- | --- |\n| A | 1.0 |\n| B |",
    "rows": "| a | b |\n" * 1_000,
    "loose ends": STORY,
    "twice": f"{STORY} {STORY}",
}


@pytest.mark.parametrize("text", HOSTILE.values(), ids=HOSTILE)
def test_hostile_texts_are_refused_at_once(text: str) -> None:
    forms()  # loaded once in a process, whatever the text
    start = time.perf_counter()
    with pytest.raises(TextError):
        parse_scene(text)
    assert time.perf_counter() - start < QUICK


def test_the_story_of_the_hostile_texts_is_a_good_one_when_whole() -> None:
    closed = (
        "The motion starts from rest with the string taut. Pulleys turn without friction, and {room}."
        " Take g = 9.8 m/s²."
    )
    with pytest.raises(TextError, match=r"sentence 3: .* is not understood"):
        parse_scene(f"{STORY} {closed.format(room='so on')}")
    description = describe(parse_scene(f"{STORY} {closed.format(room='no body reaches a pulley')}").scene)
    assert [type(named.entity).__name__ for named in description.scene.entities] == ["MassWithFixedPulley"] * 2


@pytest.mark.parametrize("count", [100, pytest.param(400, marks=pytest.mark.slow)])
def test_mutated_texts_are_read_or_refused(count: int) -> None:
    dice = random.Random(3)
    texts = [next(drawn(*tier, count=1)).text for tier in TIERS]
    words = sorted({word for text in texts for word in text.split()})
    for _ in range(count):
        text = dice.choice(texts)
        for _ in range(dice.randint(1, 4)):
            text = mutated(text, words, dice)
        start = time.perf_counter()
        with suppress(TextError):
            parse_scene(text)
        assert time.perf_counter() - start < QUICK, text


def mutated(text: str, words: list[str], dice: random.Random) -> str:
    begin = dice.randrange(len(text)) if text else 0
    end = min(len(text), begin + dice.randint(0, 40))
    inside = dice.choice(["", dice.choice(words), text[begin:end] * 2, chr(dice.randint(1, 0xD7FF))])
    return text[:begin] + inside + text[end:]


def test_a_prompt_is_sent_to_what_reads_prompts() -> None:
    made = sim2reason.item("pulley", "easy")
    prompt = made.prompt
    with pytest.raises(TextError, match=r"sentence \d+: .* is not understood; .* sim2reason\.parse_prompt") as refused:
        sim2reason.parse_scene(prompt)
    assert "\n" not in str(refused.value)
    read = sim2reason.parse_prompt(prompt)
    assert (read.answer, read.unit) == (pytest.approx(made.answer.value), show_unit(made.answer.unit))
    assert read.query.target.quantity == made.asked.quantity


def test_errors_name_the_place() -> None:
    description = next(drawn("pulley", "easy", 1))
    parts = list(split_pieces(description.text))
    with pytest.raises(TextError, match=r"sentence 2: 'Fish swim\.' is not understood; say"):
        parse_scene(join_sentences([parts[0], "Fish swim.", *parts[1:]]))
    with pytest.raises(TextError, match="nothing is said of 'g'"):
        parse_scene(join_sentences([part for part in parts if " g = " not in part]))
    with pytest.raises(TextError, match="is not finite"):
        parse_scene(re.sub(r"\d+(\.\d+)? kg", "1e999 kg", description.text, count=1))


def test_a_text_of_two_scenes_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    """The library's texts never describe two scenes, as equal readings are merged; here no readings are equal."""
    description = next(t for t in drawn("incline", "hard", 60) if len(readings(t.text, monkeypatch)) > 1)
    assert text_signature(parse_scene(description.text)) == meaning(description)
    monkeypatch.setattr("sim2reason.text.parsing.scene_parser.signature", lambda scene, names: (id(scene), id(names)))
    with pytest.raises(TextError, match="it tells two scenes"):
        parse_scene(description.text)


def readings(text: str, monkeypatch: pytest.MonkeyPatch) -> list[Scene]:
    """Return all scenes that the parser finds for a text, equal ones included."""
    found: list[Scene] = []

    def noted(scene: Scene, names: dict[str, str]) -> Signature:
        found.append(scene)
        return signature(scene, names)

    with monkeypatch.context() as patch:
        patch.setattr("sim2reason.text.parsing.scene_parser.signature", noted)
        parse_scene(text)
    return found
