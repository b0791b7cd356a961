"""Tests of the grading of rows as other packages return them."""

import json
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any, NamedTuple
from unittest.mock import Mock

import numpy as np
import pandas as pd
import polars as pl
import pyarrow.parquet as pq
import pytest
from datasets import load_dataset

from sim2reason.datasets import store
from sim2reason.datasets.grade import grade, to_plain
from sim2reason.errors import DatasetError
from sim2reason.generation.item import Answer, Binding, FormulaRecord, Item

Rows = Callable[[Path], Iterable[Any]]


class Named(NamedTuple):
    """Row without an answer."""

    id: int


def by_pyarrow(path: Path) -> Iterable[Any]:
    return pq.read_table(path).to_pylist()


def by_pyarrow_scalars(path: Path) -> Iterable[Any]:
    table = pq.read_table(path)
    return [{name: table[name][row] for name in table.column_names} for row in range(table.num_rows)]


def by_columns(path: Path) -> Iterable[Any]:
    """Return rows as slices of `datasets` give them: dicts of columns, one row each."""
    columns = pq.read_table(path).to_pydict()
    return [{name: held[row] for name, held in columns.items()} for row in range(len(columns["id"]))]


def by_numpy(path: Path) -> Iterable[Any]:
    """Return rows in the format of pandas: nested object arrays, NumPy numbers, NaN for missing values."""

    def shaped(value: object) -> object:
        if isinstance(value, dict):
            return {name: shaped(held) for name, held in value.items()}
        if isinstance(value, list):
            found = np.empty(len(value), dtype=object)
            found[:] = [shaped(held) for held in value]
            return found if not value or isinstance(value[0], dict | str) else np.array(value)
        return np.float64(value) if isinstance(value, float) else value

    return [{name: shaped(held) for name, held in row.items()} for row in by_pyarrow(path)]


def by_json(path: Path) -> Iterable[Any]:
    """Return rows whose nested columns are JSON texts."""
    fold = lambda held: json.dumps(held) if isinstance(held, dict | list) else held  # noqa: E731
    return [{name: fold(held) for name, held in row.items()} for row in by_pyarrow(path)]


def by_empty_groups(path: Path) -> Iterable[Any]:
    """Return rows with a missing group as a group of missing values, as some versions of `datasets` do."""
    rows = by_pyarrow(path)
    nothing = {"latex": None, "symbols": None, "units": None, "bindings": None}
    return [row | {"answer": row["answer"] | {"formula": row["answer"]["formula"] or nothing}} for row in rows]


def by_pandas(path: Path) -> Iterable[Any]:
    return [row for _, row in pd.read_parquet(path).iterrows()]


def by_pandas_records(path: Path) -> Iterable[Any]:
    return pd.read_parquet(path).to_dict("records")


def by_pandas_tuples(path: Path) -> Iterable[Any]:
    return pd.read_parquet(path).itertuples()


def by_pandas_of_arrow(path: Path) -> Iterable[Any]:
    return [row for _, row in pd.read_parquet(path, dtype_backend="pyarrow").iterrows()]


def by_polars(path: Path) -> Iterable[Any]:
    return pl.read_parquet(path).iter_rows(named=True)


def by_polars_columns(path: Path) -> Iterable[Any]:
    frame = pl.read_parquet(path)
    return [{name: frame[name][row] for name in frame.columns} for row in range(len(frame))]


def by_datasets(path: Path) -> Iterable[Any]:
    loaded = load_dataset("parquet", data_files=str(path), split="train")
    return list(loaded)


def by_datasets_of_numpy(path: Path) -> Iterable[Any]:
    loaded = load_dataset("parquet", data_files=str(path), split="train")
    return list(loaded.with_format("numpy"))


READERS: list[Rows] = [
    *(by_pyarrow, by_pyarrow_scalars, by_columns, by_numpy, by_json, by_empty_groups),
    *(by_pandas, by_pandas_records, by_pandas_tuples, by_pandas_of_arrow, by_polars, by_polars_columns),
    *(by_datasets, by_datasets_of_numpy),
]


@pytest.fixture
def items() -> list[Item]:
    """Build items with a signed number, a number without a unit, and a formula."""
    from fake_makers import steady
    from sim2reason.generation.request import Request

    bindings = tuple(Binding(numbers=(angle, 9.8), answer=9.8 * np.sin(angle)) for angle in (0.5, 0.6, 0.7, 0.8))
    units = "rad", "m/s^2"
    formula = FormulaRecord(
        latex=r"g\sin\theta", symbols=(r"\theta", "g"), units=units, unit="m/s^2", bindings=bindings
    )
    answers = (
        Answer(value=-9.81, unit="N", sign="up"),
        Answer(value=3.0, unit="", tolerance=0.001),
        Answer(value=4.7, unit="m/s^2", formula=formula),
    )
    found = [steady(Request("pulley", "easy", "numeric", 0, index)).item for index in range(3)]
    return [item.model_copy(update={"answer": answer}) for item, answer in zip(found, answers, strict=True) if item]


@pytest.mark.parametrize("reader", READERS, ids=lambda reader: reader.__name__)
def test_a_row_is_graded_as_its_item(items: list[Item], reader: Rows, tmp_path: Path) -> None:
    store.write(tmp_path / "items.parquet", items)
    said = (
        *(r"\boxed{-9.81}", r"\boxed{9.81\text{ N down}}", r"\boxed{9.81}", r"\boxed{3}", r"\boxed{3.01}"),
        *(r"\boxed{g\sin\theta}", r"\boxed{\frac{g}{1/\sin(\theta)}}", r"\boxed{g\cos\theta}", r"\boxed{4.7}", "4.7"),
    )
    rows = list(reader(tmp_path / "items.parquet"))
    assert len(rows) == len(items)
    for row, item in zip(rows, items, strict=True):
        scores = [grade(item, text) for text in said]
        assert [grade(row, text) for text in said] == scores
        assert any(score.reward for score in scores)


@pytest.mark.parametrize(
    ("row", "said"),
    [
        ({}, "without the column 'answer'"),
        ({"id": 3, "answr": {}}, "it has: id, answr"),
        ({"answer": None}, "answer: "),
        ({"answer": {"value": "much", "unit": "N"}}, "answer.value: "),
        ({"answer": {"value": float("nan"), "unit": "N"}}, "answer.value: "),
        ({"answer": "{"}, "answer: "),
        ("a text", "str is no item"),
        (None, "NoneType is no item"),
        ((1, 2), "tuple is no item"),
        (Named(3), "it has: id"),
        (Named, "type is no item"),
        (Mock(), "Mock is no item"),
        ({"answer": Mock()}, "answer: "),
    ],
)
def test_what_is_no_row_is_said(row: Any, said: str) -> None:  # noqa: ANN401 - anything
    with pytest.raises(DatasetError, match=said):
        grade(row, r"\boxed{1}")


def test_plain_values_stay() -> None:
    for value in (None, True, 3, 3.5, "text", [1, [2.0, None]], {"a": {"b": [1]}}):
        assert to_plain(value) == value
    assert to_plain({"a": np.array([[1.0, 2.0]]), "b": (np.int64(3), float("nan"))}) == {
        "a": [[1.0, 2.0]],
        "b": [3, None],
    }
    assert to_plain({"a": None, "b": {"c": None}}) is None
