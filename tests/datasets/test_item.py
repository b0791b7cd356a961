import math

import pytest
from pydantic import ValidationError

from fake_makers import steady
from sim2reason.datasets.item import Answer, Item
from sim2reason.datasets.plan import Request


@pytest.fixture
def item() -> Item:
    made = steady(Request("pulley", "easy", "numeric", 0, 0)).item
    assert made is not None
    return made


def test_an_item_is_the_same_after_a_trip_through_json(item: Item) -> None:
    assert Item.model_validate_json(item.model_dump_json()) == item


def test_an_item_is_frozen_and_knows_its_fields(item: Item) -> None:
    with pytest.raises(ValidationError):
        item.prompt = "another"  # type: ignore[misc]
    with pytest.raises(ValidationError):
        Item.model_validate({**item.model_dump(), "colour": "red"})


@pytest.mark.parametrize("value", [math.nan, math.inf])
def test_numbers_are_finite(item: Item, value: float) -> None:
    with pytest.raises(ValidationError):
        Answer(value=value, unit="N")
    with pytest.raises(ValidationError):
        Item.model_validate({**item.model_dump(), "certificate": {"agreement": value}})
