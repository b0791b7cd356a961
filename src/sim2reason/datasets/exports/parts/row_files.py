"""Files of rows, written one batch after the other: Parquet with a declared schema, or JSON lines."""

# pyarrow ships no types; this module speaks types to the others:
# pyright: reportMissingTypeStubs=false, reportUnknownMemberType=false
# pyright: reportUnknownVariableType=false, reportUnknownArgumentType=false

import json
from collections.abc import Iterable, Mapping
from itertools import islice
from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.parquet as pq

from sim2reason.datasets.exports import Column, Row

BATCH = 1000  # rows that are held at once
BYTES: dict[str, Any] = {"compression": "zstd", "compression_level": 3, "version": "2.6"}
"""All that decides about the bytes of Parquet; none of it depends on the clock or the machine's cores."""
PLAIN = {str: pa.string(), int: pa.int64(), float: pa.float64()}


def write(path: Path, rows: Iterable[Row], columns: Mapping[str, Column]) -> int:
    """Write rows, and give their number: Parquet if there are columns. The same rows give the same bytes."""
    return _parquet(path, rows, columns) if columns else _lines(path, rows)


def _lines(path: Path, rows: Iterable[Row]) -> int:
    count = 0
    with path.open("w", encoding="utf-8", newline="\n") as file:
        for count, row in enumerate(rows, start=1):  # noqa: B007 - the last count is the result
            file.write(json.dumps(row, ensure_ascii=False, allow_nan=False) + "\n")
    return count


def _parquet(path: Path, rows: Iterable[Row], columns: Mapping[str, Column]) -> int:
    schema, left, count = pa.schema({name: _type(column) for name, column in columns.items()}), iter(rows), 0
    # by its own name pyarrow opens only what is UTF-8
    with path.open("wb") as file, pq.ParquetWriter(file, schema, **BYTES) as writer:
        while batch := list(islice(left, BATCH)):
            writer.write_table(pa.Table.from_pylist(batch, schema=schema))
            count += len(batch)
    return count


def _type(column: Column) -> Any:  # noqa: ANN401 - pyarrow has no types
    if isinstance(column, list):
        return pa.list_(_type(column[0]))
    if isinstance(column, dict):
        return pa.struct({name: _type(part) for name, part in column.items()})
    return PLAIN[column]
