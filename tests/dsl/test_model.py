"""Values with declared parameters: walked, changed and drawn."""

from typing import Annotated, Self

import numpy as np
import pytest
from annotated_types import Ge, Gt, Le, Len
from pydantic import ValidationError, model_validator

from sim2reason.dsl.measures import Count, Hidden, Mass, Measure, Range
from sim2reason.dsl.model import Model, changed, draw, field_types, lookup, parameters, rebuilt
from sim2reason.errors import SceneError


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


def test_a_changed_value_is_another_value() -> None:
    new = changed(HEAP, "stones.1.mass", 7.0)
    assert (new.stones[1].mass, HEAP.stones[1].mass) == (7.0, 2.0)
    assert len(changed(HEAP, "stones.0", None).stones) == 1
    assert rebuilt(HEAP, slope=3.0).slope == 3.0
    with pytest.raises(ValidationError):
        changed(HEAP, "stones.0.mass", -1.0)


@pytest.mark.parametrize("path", ["nothing", "stones.9.mass", "stones.x", "top.mass.more", "model_fields"])
def test_an_address_that_leads_nowhere_is_named(path: str) -> None:
    with pytest.raises(SceneError, match=r"there is no such thing"):
        lookup(HEAP, path)


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


def test_a_number_without_a_range_is_refused() -> None:
    with pytest.raises(SceneError, match="no range to be drawn from"):
        draw(Heap, RNG, {"slope?": 1.0})
