"""Tests of addresses: lookup of values, and copies with other values at them."""

from typing import Self

import pytest
from pydantic import ValidationError, model_validator

from sim2reason.errors import SceneError
from sim2reason.scenes.dsl.addresses import lookup, with_values
from sim2reason.scenes.dsl.measures import Mass
from sim2reason.scenes.dsl.model import Model


class Stone(Model):
    mass: Mass
    heat: float | None = None


class Heap(Model):
    stones: tuple[Stone, ...]
    top: Stone


class Span(Model):
    low: Mass
    high: Mass

    @model_validator(mode="after")
    def _in_order(self) -> Self:
        if self.low >= self.high:
            raise ValueError("it must grow")
        return self


HEAP = Heap(stones=(Stone(mass=1.0), Stone(mass=2.0, heat=1.5)), top=Stone(mass=3.0))


def test_a_changed_value_is_another_value() -> None:
    new = with_values(HEAP, {"stones.1.mass": 7.0})
    assert (new.stones[1].mass, HEAP.stones[1].mass) == (7.0, 2.0)
    assert len(with_values(HEAP, {"stones.0": None}).stones) == 1
    with pytest.raises(ValidationError):
        with_values(HEAP, {"stones.0.mass": -1.0})


def test_changes_are_validated_together() -> None:
    """Only the final value is validated, not intermediate ones."""
    span = Span(low=1.0, high=2.0)
    assert with_values(span, {"low": 3.0, "high": 4.0}) == Span(low=3.0, high=4.0)
    with pytest.raises(ValidationError):
        with_values(span, {"low": 3.0})
    assert with_values(HEAP, {"stones.0": None, "stones.1.mass": 7.0}).stones == (Stone(mass=7.0, heat=1.5),)


@pytest.mark.parametrize("path", ["nothing", "stones.9.mass", "stones.x", "top.mass.more", "model_fields"])
def test_an_address_that_leads_nowhere_is_named(path: str) -> None:
    with pytest.raises(SceneError, match=r"there is no such thing"):
        lookup(HEAP, path)
    with pytest.raises(SceneError, match=r"there is no such thing"):
        with_values(HEAP, {path: 1.0})
