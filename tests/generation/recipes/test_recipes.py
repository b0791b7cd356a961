"""Tests that recipes draw consistent scenes that a text can describe, from the generator alone."""

import numpy as np
import pytest

from cells import CELLS, drawn
from sim2reason.errors import SceneError, UnknownNameError
from sim2reason.generation.item_search import sample
from sim2reason.generation.recipes import RECIPES, all_recipes
from sim2reason.generation.recipes.growth import LONGEST_SENTENCE, Tier, grow
from sim2reason.generation.recipes.inclines import BOX_TIERS, INCLINE_TIERS
from sim2reason.generation.recipes.pulleys import HYBRID_TIERS, MIXED_TIERS, PULLEY_TIERS
from sim2reason.questions.difficulty import DIFFICULTIES, Difficulty
from sim2reason.scenes.dsl.entity import outer_ports
from sim2reason.scenes.dsl.measures import Count, Range
from sim2reason.scenes.dsl.structure import is_weightless, stuck_bodies
from sim2reason.scenes.files import dump, load
from sim2reason.text.prose.description import describe

SCENES = 12
PLANE = ({"TwoSideMassPlane": 1.0},)
MASSES = {"mass": Range(1.0, 3.0), "pulley mass": Range(0.1, 0.5), "blocks": Count(1, 1)}
GROWN = {
    "pulley": PULLEY_TIERS,
    "incline": INCLINE_TIERS,
    "hybrid": HYBRID_TIERS,
    "box": BOX_TIERS,
    "mixed": MIXED_TIERS,
}


@pytest.mark.parametrize(("recipe", "difficulty"), CELLS)
def test_a_draw_is_a_function_of_its_coordinates(recipe: str, difficulty: Difficulty) -> None:
    assert sample(recipe, difficulty, seed=3, index=1) == sample(recipe, difficulty, seed=3, index=1)
    assert sample(recipe, difficulty, seed=3, index=1) != sample(recipe, difficulty, seed=4, index=1)
    assert sample(recipe, difficulty, seed=3, index=1) != sample(recipe, difficulty, seed=3, index=2)


@pytest.mark.parametrize(("recipe", "difficulty"), CELLS)
def test_scenes_can_be_built_told_and_written(recipe: str, difficulty: Difficulty) -> None:
    for scene in drawn(recipe, difficulty, SCENES):
        assert scene.mechanism.coordinates
        assert describe(scene).text
        assert load(dump(scene)) == scene


@pytest.mark.parametrize(("recipe", "difficulty"), [cell for cell in CELLS if cell[0] in GROWN])
def test_grown_scenes_keep_to_their_tier(recipe: str, difficulty: Difficulty) -> None:
    tier = GROWN[recipe][difficulty]
    for scene in drawn(recipe, difficulty, SCENES):
        grown = [type(n.entity).__name__ for n in scene.entities if type(n.entity).__name__ in tier.pool]
        assert 1 <= len(grown) <= tier.size.high
        sentences = [len(sentence.split()) for sentence in describe(scene).sentences]
        assert sum(sentences) <= tier.words
        assert max(sentences) <= LONGEST_SENTENCE
        used = {(link.entity, link.port) for connection in scene.connections for link in connection.links}
        required = {
            (n.name, p) for n in scene.entities for p, held in outer_ports(type(n.entity)).items() if held.required
        }
        assert required <= used


@pytest.mark.parametrize("count", [2 * SCENES, pytest.param(8 * SCENES, marks=pytest.mark.slow)])
@pytest.mark.parametrize(("recipe", "difficulty"), [c for c in CELLS if c[0] in GROWN and GROWN[c[0]][c[1]].rough])
def test_rough_scenes_are_as_often_told_as_they_are_meant(recipe: str, difficulty: Difficulty, count: int) -> None:
    """Rough scenes have the longest texts, so too tight a bound on length would leave only few of them."""
    scenes = list(drawn(recipe, difficulty, count))
    rough = sum(any(p.value for p in scene.parameters if p.measure.name == "friction") for scene in scenes)
    assert rough >= 0.3 * GROWN[recipe][difficulty].rough * len(scenes)


@pytest.mark.parametrize(("recipe", "difficulty"), CELLS)
def test_numbers_are_what_is_said(recipe: str, difficulty: Difficulty) -> None:
    for scene in drawn(recipe, difficulty, SCENES):
        for parameter in scene.parameters:
            if parameter.value is not None and not parameter.hidden:
                assert parameter.measure.round(parameter.value) == parameter.value, parameter.path


def test_a_choice_of_zero_is_a_choice() -> None:
    smooth = Tier(Count(1, 1), PLANE, {**MASSES, "mass": Range(1.0, 2.0)})
    for seed in range(20):
        scene = grow(smooth, np.random.default_rng(seed))
        assert [p.value for p in scene.parameters if p.measure.name == "friction"] == [0.0]


def test_what_can_not_be_told_in_so_few_words_is_refused() -> None:
    with pytest.raises(SceneError, match="5 words"):
        grow(Tier(Count(1, 1), PLANE, MASSES, words=5), np.random.default_rng(0))


def test_names_say_what_entities_are() -> None:
    for recipe in GROWN:
        for scene in drawn(recipe, "hard", SCENES):
            for named in scene.entities:
                assert named.name.rstrip("0123456789").replace("_", "") == type(named.entity).__name__.lower()


@pytest.mark.parametrize("difficulty", DIFFICULTIES)
def test_hybrid_scenes_hold_both_kinds(difficulty: Difficulty) -> None:
    pulleys, faces = HYBRID_TIERS[difficulty].groups
    for scene in drawn("hybrid", difficulty, SCENES):
        kinds = {type(named.entity).__name__ for named in scene.entities}
        assert kinds & pulleys.keys()
        assert kinds & faces.keys()


@pytest.mark.parametrize(("recipe", "difficulty"), [cell for cell in CELLS if cell[0] in GROWN])
def test_masses_are_comparable_and_pulleys_light(recipe: str, difficulty: Difficulty) -> None:
    """No pulley is heavier than the lightest block by more than 5 %, and no block far heavier than another."""
    for scene in drawn(recipe, difficulty, SCENES):
        found = [(p.measure.name, p.value) for p in scene.parameters if p.value]
        blocks = [value for name, value in found if name == "mass"]
        pulleys = [value for name, value in found if name == "pulley mass"]
        assert max(blocks) <= 1.05 * GROWN[recipe][difficulty].spread * min(blocks)
        assert max(pulleys, default=0.0) <= 1.05 * min(blocks)


def test_everything_can_move_and_nothing_moves_for_nothing() -> None:
    for recipe in GROWN:
        for scene in drawn(recipe, "medium", SCENES):
            assert not stuck_bodies(scene.mechanism)
            assert not is_weightless(scene.mechanism)


def test_over_all_recipes_strings_and_planes_are_a_quarter_at_most() -> None:
    dealt = all_recipes()
    machines = [name for name in dealt if name in ("pulley", "incline", "hybrid", "box")]
    assert set(dealt) == set(RECIPES)
    assert len(machines) <= 0.25 * len(dealt)


def test_unknown_names_are_refused_with_what_there_is() -> None:
    with pytest.raises(UnknownNameError, match="pulley"):
        sample("puley")
    with pytest.raises(UnknownNameError, match="easy, medium, hard"):
        sample("pulley", "harder")
    assert set(DIFFICULTIES) == {"easy", "medium", "hard"}
    assert set(GROWN) < set(RECIPES)


@pytest.mark.parametrize("difficulty", ["medium", "hard"])
def test_pieces_that_would_be_in_one_another_are_not_drawn(difficulty: Difficulty) -> None:
    """The recipe uses the arm's own rule of sufficient room, so none of its draws is refused for overlap."""
    refused = list[str]()
    for seed in range(30):
        try:
            RECIPES["rotation"](difficulty, np.random.default_rng(seed))
        except SceneError as error:
            refused.append(str(error))
    assert not [reason for reason in refused if "overlap" in reason]


@pytest.mark.parametrize("recipe", ["incline", "pulley", "hybrid", "box"])
def test_one_hand_pulls_at_most(recipe: str) -> None:
    """Two hands at the ends of one chain act as one."""
    for seed in range(15):
        kinds = [type(named.entity).__name__ for named in sample(recipe, "hard", seed=seed).entities]
        assert kinds.count("ConstantForcePuller") <= 1
