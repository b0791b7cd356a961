"""Tests of models with declared parameters: traversal, changes and random draws."""

from collections.abc import Mapping
from typing import Annotated, Any, Literal, Self

import numpy as np
import pytest
from annotated_types import Ge, Gt, Le, Len
from pydantic import ValidationError, model_validator

from sim2reason.errors import SceneError
from sim2reason.scenes.dsl.addresses import lookup
from sim2reason.scenes.dsl.measures import Chance, Count, Hidden, Mass, Measure, Member, Range, Sized
from sim2reason.scenes.dsl.model import Model, draw, field_types, parameters, replace_validated


class Stone(Model):
    mass: Mass
    heat: Annotated[float, Measure("heat", "J", "Q"), Range(1.0, 2.0)] | None = None


class Pebble(Stone):
    pass


class Heap(Model):
    stones: Annotated[tuple[Stone, ...], Len(1, 9), Count(2, 4)]
    top: Stone | Pebble
    depth: Annotated[float, Gt(0), Measure("depth", "m", "h"), Range(1.0, 2.0), Range(5.0, 6.0), Hidden()] = 5.5
    slope: Annotated[float, Ge(0), Le(90), Measure("angle", "deg", "a", 0)] = 0.0


HEAP = Heap(stones=(Stone(mass=1.0), Stone(mass=2.0, heat=1.5)), top=Stone(mass=3.0))
RNG = np.random.default_rng(0)


def test_fields_are_taken_apart_once() -> None:
    kinds = field_types(Heap)
    assert kinds["stones"].count == Count(2, 4)
    assert kinds["top"].models == (Stone, Pebble)
    assert kinds["depth"].drawn == Range(5.0, 6.0)  # a field narrows its alias
    assert kinds["depth"].hidden
    measure = field_types(Stone)["heat"].measure
    assert measure is not None  # inside an optional, too
    assert measure.unit == "J"


def test_parameters_are_found_by_address() -> None:
    found = {parameter.path: parameter for parameter in parameters(HEAP, "a")}
    assert [path for path in found if path.endswith("mass")] == ["a.stones.0.mass", "a.stones.1.mass", "a.top.mass"]
    assert found["a.stones.0.heat"].value is None
    assert found["a.depth"].hidden
    assert all(lookup(HEAP, path.removeprefix("a.")) == parameter.value for path, parameter in found.items())


def test_a_rebuilt_value_has_some_other_fields() -> None:
    assert replace_validated(HEAP, slope=3.0).slope == 3.0
    with pytest.raises(ValidationError):
        replace_validated(HEAP, slope=91.0)


@pytest.mark.parametrize("field", [{"mass": "1"}, {"mass": float("nan")}, {"mass": True}, {"mass": 1.0, "size": 2}])
def test_models_are_strict(field: dict[str, object]) -> None:
    with pytest.raises(ValidationError):
        Stone(**field)  # type: ignore[arg-type]


def test_draws_follow_what_is_declared_and_what_a_recipe_chooses() -> None:
    heaps = [draw(Heap, RNG, {"heat?": 0.5, "angle": Range(10.0, 20.0), "Heap.top": ("Pebble",)}) for _ in range(200)]
    assert {len(heap.stones) for heap in heaps} == {2, 3, 4}
    assert {type(heap.top) for heap in heaps} == {Pebble}
    assert all(5.0 <= heap.depth <= 6.0 for heap in heaps)
    heat = [stone.heat is None for heap in heaps for stone in heap.stones]
    assert 0.3 < np.mean(heat) < 0.7


def test_the_most_special_choice_counts_and_zero_is_a_choice() -> None:
    drawn = draw(Heap, RNG, {"mass": 4.0, "Stone.mass": 2.0, "slope?": 1.0, "angle": 0.0})
    assert {stone.mass for stone in drawn.stones} == {2.0}
    assert drawn.slope == 0.0


def test_what_validators_refuse_is_drawn_again_within_a_budget() -> None:
    class Odd(Model):
        mass: Mass

        @model_validator(mode="after")
        def _heavy(self) -> Self:
            if self.mass < 5.0:
                raise ValueError("too light")
            return self

    assert all(draw(Odd, RNG, {}).mass >= 5.0 for _ in range(20))
    with pytest.raises(SceneError, match="too light"):
        draw(Odd, RNG, {"mass": 1.0})


class Shape(Model):
    """Base class with an open set of variants."""

    @classmethod
    def variants(cls) -> tuple[type[Model], ...]:
        """Return both variants for the base class, and a variant itself for a variant."""
        return (Round, Square) if cls is Shape else (cls,)


class Round(Shape):
    radius: Annotated[float, Measure("radius", "m", "r"), Range(1.0, 2.0)]


class Square(Shape):
    side: Annotated[float, Measure("side", "m", "a"), Range(1.0, 2.0)]
    colour: Literal["red", "green", "blue"] = "red"


class Tray(Model):
    shapes: Annotated[tuple[Round | Square, ...], Len(1, 4), Count(2, 4, alike=True)]
    lid: Annotated[Shape | None, Chance(0.5)] = None
    tilt: Annotated[float, Measure("angle", "deg", "a", 0), Range(0.0, 10.0)]
    rise: Annotated[float, Measure("rise", "m", "h"), Range(0.0, 1.0)]

    @classmethod
    def fitted(cls, drawn: Mapping[str, Any], rng: np.random.Generator) -> Mapping[str, object]:
        """Return a tilt of ten degrees for each metre of the rise."""
        del rng
        return {"tilt": 10.0 * drawn["rise"]}


def test_an_open_base_holds_its_variants_and_an_optional_thing_has_a_chance() -> None:
    assert field_types(Tray)["lid"].models == (Round, Square)
    lids = [type(draw(Tray, RNG, {}).lid).__name__ for _ in range(200)]
    assert {lids.count("Round") > 20, lids.count("Square") > 20, 70 < lids.count("NoneType") < 130} == {True}
    assert all(draw(Tray, RNG, {"lid?": 0.0}).lid is None for _ in range(20))


def test_members_can_be_all_of_one_class() -> None:
    kinds = [{type(shape) for shape in draw(Tray, RNG, {}).shapes} for _ in range(50)]
    assert {len(kind) for kind in kinds} == {1}
    assert set[type[Model]]().union(*kinds) == {Round, Square}


def test_numbers_that_hang_together_are_fitted_but_not_against_a_choice() -> None:
    assert all(tray.tilt == 10.0 * tray.rise for tray in (draw(Tray, RNG, {}) for _ in range(20)))
    assert draw(Tray, RNG, {"angle": 3.0}).tilt == 3.0
    assert draw(Tray, RNG, {}, {"tilt": 4.0}).tilt == 4.0


def test_a_recipe_chooses_words() -> None:
    assert {draw(Square, RNG, {"colour?": 1.0, "colour": ("red", "blue")}).colour for _ in range(50)} == {"red", "blue"}


def test_a_number_without_a_range_is_refused() -> None:
    with pytest.raises(SceneError, match="no range to be drawn from"):
        draw(Heap, RNG, {"slope?": 1.0})


class Throw(Model):
    stone: Annotated[int, Member("stones")]


class Row(Model):
    stones: Annotated[tuple[Stone, ...], Len(1, 9), Count(2, 4)]
    gaps: Annotated[tuple[Pebble, ...], Count(0, 9), Sized(lambda held: len(held["stones"]) - 1)]
    first: Annotated[int, Member("stones")]
    throw: Annotated[Throw | None, Chance(0.5)] = None
    other: Throw | None = None


def test_counts_and_indices_fit_what_they_count() -> None:
    rows = [draw(Row, RNG, {}) for _ in range(200)]
    assert {len(row.gaps) - len(row.stones) for row in rows} == {-1}
    assert {row.first for row in rows} == {0, 1, 2, 3}
    assert all(row.throw is None or row.throw.stone < len(row.stones) for row in rows)
    assert 60 < sum(row.throw is None for row in rows) < 140
    assert all(row.other is None for row in rows)
    assert draw(Row, RNG, {"throw?": 1.0}).throw is not None


@pytest.mark.parametrize(
    ("fields", "message"),
    [
        ({"gaps": ()}, "gaps: what stands beside them demands 1, not 0"),
        ({"first": 2}, "first: stones has no member 2, count from 0 to 1"),
        ({"throw": Throw(stone=-1)}, r"throw\.stone: stones has no member -1"),
    ],
)
def test_a_count_or_an_index_that_does_not_fit_is_refused(fields: dict[str, object], message: str) -> None:
    stone = Stone(mass=1.0)
    given: dict[str, object] = {"stones": (stone, stone), "gaps": (Pebble(mass=1.0),), "first": 0}
    with pytest.raises(ValidationError, match=message):
        Row(**{**given, **fields})  # type: ignore[arg-type]
