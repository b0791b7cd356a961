"""Tests that every range, count, choice and option that recipes declare varies over two hundred draws."""

from collections import defaultdict
from collections.abc import Iterator
from importlib import import_module

import pytest

from cells import drawn
from sim2reason.generation.recipes import RECIPES
from sim2reason.generation.recipes.growth import Tier
from sim2reason.questions.difficulty import DIFFICULTIES, Difficulty
from sim2reason.scenes.dsl.entity import Entity
from sim2reason.scenes.dsl.model import Model, field_types

USUAL = "electromagnetic", "hybrid"  # whose draws the usual tests look at; those marked slow look at all
SCENES = 70  # of each difficulty: some 200 of a recipe

OFTEN = 12  # times that something must be there before it is called constant

ROUGH = "Plane", "StackedMassPlane", "Prism", "Box", "Rough", "RoughTrack", "Wedge"  # may have two coefficients

ON_PURPOSE: dict[str, dict[str, tuple[str, ...]]] = {
    "only a row of blocks without strings is sent off with a speed": {
        "TwoSideMassPlane.speed presence": ("hybrid", "mixed"),
    },
    "no string comes on the level to the foot of a prism from the top of a slope; of others the texts are too long": {
        "MassPrismPlane.left_blocks count": ("incline",),
    },
    "with a second coefficient of restitution pucks are less a problem than a program": {
        "TwoDCollisionPlane.pairs count": ("collision",),
    },
    "a prism on its face would lie there": {"TumblingPrism.rate presence": ("rolling",)},
    "an arm's length is said where something hangs from its end": {
        "RotationEntity.reach presence": ("rotation",),
        "RigidPendulum.reach presence": ("mixed",),
    },
    "where families meet, each is as simple as can be": {
        "Hanging.blocks count": ("mixed",),
        "TwoSideMassPlane.blocks count": ("mixed",),
        "MassPrismPlane.left_blocks count": ("mixed",),
        "MassPrismPlane.right_blocks count": ("mixed",),
        "MassWithFixedPulley.system type": ("mixed",),
        "LightRodPendulum.speed presence": ("mixed",),
        "RigidPendulum.pieces count": ("mixed",),
        "RigidPendulum.rate presence": ("mixed",),
        "RollingEntity.grip type": ("mixed",),
        "RollingEntity.hole presence": ("mixed",),
        "RollingEntity.start presence": ("mixed",),
        "RollingEntity.start type": ("mixed",),
    },
    "a scene of one's own may say what no recipe draws": dict.fromkeys(
        [
            *(f"{name}.static_friction presence" for name in ROUGH),
            *(f"TwoDCollisionPlane.{side} presence" for side in ("left", "right", "bottom", "top")),
            *(f"Projectile.{name} presence" for name in ("angle", "speed")),
            "OscillatingElectric.phase presence",
        ],
        tuple(RECIPES),
    ),
}
"""What a recipe fixes, by the reason: which aspect, in which recipes or cells."""

Aspect = tuple[str, str, str]  # class, field, and what of it varies


def aspects(value: Model) -> Iterator[tuple[Aspect, object]]:
    """Yield every aspect of a value and its parts that a recipe may draw."""
    for name, kind in field_types(type(value)).items():
        held, key = getattr(value, name), (type(value).__name__, name)
        if kind.optional:
            yield (*key, "presence"), held is not None
        if kind.count is not None:
            yield (*key, "count"), len(held)
        if kind.measure is not None and held is not None:
            yield (*key, "value"), held
        if kind.count is None and len(kind.models) > 1:
            yield (*key, "type"), type(held).__name__
        for member in held if isinstance(held, tuple) else (held,):
            if isinstance(member, Model):
                yield from aspects(member)


def reached(recipe: str) -> dict[Aspect, list[object]]:
    found: dict[Aspect, list[object]] = defaultdict(list)
    for scene in (scene for difficulty in DIFFICULTIES for scene in drawn(recipe, difficulty, SCENES, seed=41)):
        for named in scene.entities:
            assert isinstance(named.entity, Entity)
            found[type(named.entity).__name__, "", "presence"].extend((True, False))
            for aspect, value in aspects(named.entity):
                found[aspect].append(value)
        for connection in scene.connections:
            for aspect, value in aspects(connection):
                found[aspect].append(value)
    return found


def on_purpose(aspect: Aspect, recipe: str) -> bool:
    name = f"{aspect[0]}.{aspect[1]} {aspect[2]}"
    return any(recipe in fixed.get(name, ()) for fixed in ON_PURPOSE.values())


def seldom(recipe: str) -> list[pytest.MarkDecorator]:
    return [] if recipe in USUAL else [pytest.mark.slow]


@pytest.mark.parametrize("recipe", [pytest.param(name, marks=seldom(name)) for name in sorted(RECIPES)])
def test_nothing_that_is_declared_stays_constant(recipe: str) -> None:
    """All difficulties count together, since one may deliberately omit what another has."""
    found = reached(recipe)
    constant = {aspect for aspect, values in found.items() if len(values) >= OFTEN and len(set(values)) == 1}
    assert not [aspect for aspect in sorted(constant) if not on_purpose(aspect, recipe)]


GROWN = [
    pytest.param(name, difficulty, tier, marks=seldom(name), id=f"{name} {difficulty}")
    for name in sorted(RECIPES)
    for difficulty, tier in getattr(import_module(RECIPES[name].draw.__module__), f"{name.upper()}_TIERS", {}).items()
    if isinstance(tier, Tier)
]


@pytest.mark.parametrize(("recipe", "difficulty", "tier"), GROWN)
def test_every_entity_of_a_pool_is_drawn(recipe: str, difficulty: Difficulty, tier: Tier) -> None:
    """No entity of a pool is always too long to describe, or never compatible with the others."""
    scenes = drawn(recipe, difficulty, SCENES, seed=41)
    assert set(tier.pool) <= {type(named.entity).__name__ for scene in scenes for named in scene.entities}
