"""Randomisation reaches what it declares: over two hundred draws no range, count, choice or option stays constant."""

from collections import defaultdict
from collections.abc import Iterator

import pytest

from cells import CELLS, drawn
from sim2reason.dsl.entity import Entity
from sim2reason.dsl.model import Model, field_types
from sim2reason.recipes import Difficulty, hybrid, incline, pulley

SCENES = 200

ON_PURPOSE: dict[str, dict[str, tuple[str, ...]]] = {
    "a table is one entity": {"Scene.entities count": ("collision",)},
    "easy and medium tables are level": {"Table.tilt value": ("collision easy", "collision medium")},
    "easy hits are elastic, and all alike": {
        "TwoDCollisionPlane.restitution value": ("collision easy",),
        "TwoDCollisionPlane.pairs count": ("collision easy",),
    },
    "one block on each end or face while scenes are easy, two on one face at most while they are medium": {
        "Hanging.blocks count": ("pulley easy", "hybrid easy"),
        "OnPlane.blocks count": ("hybrid easy",),
        "TwoSideMassPlane.blocks count": ("incline easy", "hybrid easy"),
        "MassPrismPlane.left_blocks count": ("incline easy", "incline medium", "hybrid medium"),
        "MassPrismPlane.right_blocks count": ("incline easy", "hybrid medium"),
        "OnWedge.blocks count": ("hybrid medium",),
    },
    "friction is for the recipes of faces, and is too long to tell on a prism among much else": {
        "Plane.friction value": ("pulley easy", "pulley medium", "hybrid easy"),
        "Prism.friction value": ("incline easy", "hybrid medium"),
        "Wedge.friction value": ("hybrid medium",),
    },
    "only a row of blocks without strings is sent off with a speed": {
        "TwoSideMassPlane.speed presence": ("hybrid", "incline hard"),
    },
    "no string goes on under a movable pulley in recipes that have none": {"Connection.links count": ("incline",)},
    "a light pulley with nothing on its axle is held by nothing": {
        "MassWithReverseMovablePulley.load presence": ("pulley easy", "hybrid easy"),
    },
    "an easy text has no room for a movable pulley's mass": {
        "MovablePulley.mass value": ("pulley easy", "hybrid easy"),
    },
    "simple strings have hanging ends": {
        "MassWithFixedPulley.system type": ("pulley easy",),
        "MassWithMovablePulley.left type": ("pulley easy", "pulley medium", "hybrid easy"),
        "MassWithMovablePulley.right type": ("pulley easy", "pulley medium", "hybrid easy"),
    },
}
"""What a recipe fixes, by the reason: which aspect, in which recipes or cells."""

POOLS = {"pulley": pulley.TIERS, "incline": incline.TIERS, "hybrid": hybrid.TIERS}
Aspect = tuple[str, str, str]  # class, field, and what of it varies


def aspects(value: Model) -> Iterator[tuple[Aspect, object]]:
    """Everything about a value and its parts that a recipe may draw."""
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


def reached(recipe: str, difficulty: Difficulty) -> dict[Aspect, list[object]]:
    found: dict[Aspect, list[object]] = defaultdict(list)
    for scene in drawn(recipe, difficulty, SCENES, seed=41):
        found["Scene", "entities", "count"].append(len(scene.entities))
        for named in scene.entities:
            assert isinstance(named.entity, Entity)
            found[type(named.entity).__name__, "", "presence"].extend((True, False))
            for aspect, value in aspects(named.entity):
                found[aspect].append(value)
        for connection in scene.connections:
            found["Connection", "links", "count"].append(len(connection.links))
            for aspect, value in aspects(connection):
                found[aspect].append(value)
    return found


def on_purpose(aspect: Aspect, cell: str) -> bool:
    name = f"{aspect[0]}.{aspect[1]} {aspect[2]}"
    where = [place for fixed in ON_PURPOSE.values() for place in fixed.get(name, ())]
    return any(cell == place or cell.startswith(f"{place} ") for place in where)


@pytest.mark.slow
@pytest.mark.parametrize(("recipe", "difficulty"), CELLS)
def test_nothing_that_is_declared_stays_constant(recipe: str, difficulty: Difficulty) -> None:
    found = reached(recipe, difficulty)
    constant = {aspect for aspect, values in found.items() if len(set(values)) == 1}
    assert not [aspect for aspect in sorted(constant) if not on_purpose(aspect, f"{recipe} {difficulty}")]
    if recipe in POOLS:
        assert set(POOLS[recipe][difficulty].pool) <= {owner for owner, _, _ in found}
