import math
from pathlib import Path

import pyarrow.parquet as pq
import pytest
from pydantic import ValidationError

from fake_makers import steady
from sim2reason.datasets.grade import grade
from sim2reason.datasets.store import read, write
from sim2reason.generation.item import Answer, Binding, FormulaRecord, Item
from sim2reason.generation.request import Request


@pytest.fixture
def item() -> Item:
    made = steady(Request("pulley", "easy", "numeric", 0, 0)).item
    assert made is not None
    return made


def test_an_item_is_the_same_after_a_trip_through_json(item: Item) -> None:
    assert Item.model_validate_json(item.model_dump_json()) == item


def test_an_item_is_the_same_from_a_row_of_a_shard(item: Item, tmp_path: Path) -> None:
    """A row stores certificate, versions and weights as JSON texts."""
    write(tmp_path / "shard.parquet", [item])
    (row,) = pq.read_table(tmp_path / "shard.parquet").to_pylist()
    assert Item.model_validate(row) == item
    for wrong in ("{", "[]", '{"agreement": NaN}', "[" * 100_000):
        with pytest.raises(ValidationError, match="certificate"):
            Item.model_validate({**row, "certificate": wrong})


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


@pytest.fixture
def symbolic() -> Item:
    """Build the problem of a block of mass m on a smooth slope, a = g sin θ, at two bindings."""
    made = steady(Request("pulley", "easy", "numeric", 0, 0)).item
    assert made is not None
    bindings = tuple(
        Binding(numbers=(angle, 9.8), answer=9.8 * math.sin(angle))
        for angle in (math.radians(30.0), math.radians(42.5))
    )
    units = "rad", "m/s^2"
    formula = FormulaRecord(
        latex=r"g \sin\theta", symbols=(r"\theta", "g"), units=units, unit="m/s^2", bindings=bindings
    )
    return made.model_copy(update={"answer": Answer(value=4.9, unit="m/s^2", formula=formula)})


def test_a_formula_travels_through_a_shard(symbolic: Item, tmp_path: Path) -> None:
    plain = steady(Request("pulley", "easy", "numeric", 0, 1)).item
    assert plain is not None
    write(tmp_path / "shard.parquet", [symbolic, plain])
    assert read(tmp_path / "shard.parquet") == [symbolic, plain]


@pytest.mark.parametrize(
    ("said", "reward"),
    [(r"g\sin\theta", 1.0), (r"g \sqrt{1-\cos^2\theta}", 1.0), ("4.9", 0.0), (r"1.02 g\sin\theta", 0.0), ("g", 0.0)],
)
def test_a_formula_is_graded_at_its_bindings(symbolic: Item, said: str, reward: float) -> None:
    assert grade(symbolic, rf"So it is \boxed{{{said}}}.").reward == reward


def test_a_binding_is_said_in_the_units_of_the_text(symbolic: Item) -> None:
    formula = symbolic.answer.formula
    assert formula is not None
    assert formula.given() == {r"\theta": "30°", "g": "9.8 m/s²"}
    assert formula.given(1) == {r"\theta": "42.5°", "g": "9.8 m/s²"}
    assert symbolic.answer.told == r"$g \sin\theta$, which here is 4.9 m/s²"


def test_each_symbol_has_a_number() -> None:
    numbers = (Binding(numbers=(1.0, 2.0), answer=1.0),)
    with pytest.raises(ValidationError, match="each symbol"):
        FormulaRecord(latex="g", symbols=("g",), units=("m/s^2",), unit="m/s^2", bindings=numbers)


def test_a_formula_has_no_unit_that_needs_a_factor() -> None:
    numbers = (Binding(numbers=(30.0,), answer=30.0),)
    for units, unit in ((("deg",), "rad"), (("rad",), "deg"), (("km/s",), "m/s"), (("mC",), "C")):
        with pytest.raises(ValidationError, match=r"numbers of formulas are not in (deg|km/s|mC); give them in"):
            FormulaRecord(latex="x", symbols=("x",), units=units, unit=unit, bindings=numbers)


def test_a_record_of_an_earlier_version_is_told_in_the_units_of_its_numbers(symbolic: Item) -> None:
    """Old records gave display units for the symbols and no unit for the answers; both are converted on reading."""
    answer = symbolic.answer.model_dump(mode="json")
    del answer["formula"]["unit"]
    answer["formula"]["units"] = ["deg", "m/s^2"]
    assert Answer.model_validate(answer) == symbolic.answer
    assert Answer.model_validate(symbolic.answer.model_dump(mode="json")) == symbolic.answer
