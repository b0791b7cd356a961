"""Storage of items in Parquet with a fixed schema; equal items give equal bytes."""

# pyarrow ships no types; it is used for data in this one module of the package, which speaks types to the others:
# pyright: reportMissingTypeStubs=false, reportUnknownMemberType=false
# pyright: reportUnknownVariableType=false, reportUnknownArgumentType=false

import json
from collections.abc import Generator, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.parquet as pq

from sim2reason.generation.item import Item

TEXT, REAL, WHOLE = pa.string(), pa.float64(), pa.int64()
BINDING = pa.struct({"numbers": pa.list_(REAL), "answer": REAL})
FORMULA = pa.struct(
    {
        "latex": TEXT,
        "symbols": pa.list_(TEXT),
        "units": pa.list_(TEXT),
        "unit": TEXT,
        "bindings": pa.list_(BINDING),
    }
)
ONE = {"value": REAL, "unit": TEXT, "sign": TEXT, "tolerance": REAL, "formula": FORMULA}
CHOSEN = {"letter": TEXT, "options": pa.list_(REAL), "texts": pa.list_(TEXT)}
ANSWER = pa.struct({**ONE, "parts": pa.list_(pa.struct(ONE)), **CHOSEN})
ASKED = pa.struct(
    {
        "subject": TEXT,
        "quantity": TEXT,
        "time": REAL,
        "event": TEXT,
        "unknown": TEXT,
        "limit_of": TEXT,
        "given": REAL,
        "given_unit": TEXT,
    }
)
DISTRACTORS = pa.list_(pa.struct({"value": REAL, "simplification": TEXT, "reason": TEXT}))
STEP = pa.struct({"kind": TEXT, "text": TEXT, "relations": pa.list_(TEXT), "needs": pa.list_(WHOLE)})
SOLUTION = pa.struct({"strategy": TEXT, "derived": pa.bool_(), "text": TEXT, "steps": pa.list_(STEP)})
PART = pa.struct(
    {
        "text": TEXT,
        "kind": TEXT,
        "asked": ASKED,
        "uses": pa.list_(WHOLE),
        "distractors": DISTRACTORS,
        "solution": SOLUTION,
        "unsolved": TEXT,
        "certificate": TEXT,
    }
)
SCHEMA = pa.schema(
    {
        "id": TEXT,
        "prompt": TEXT,
        "shape": TEXT,
        "answer": ANSWER,
        "mode": TEXT,
        "kind": TEXT,
        "recipe": TEXT,
        "difficulty": TEXT,
        "entities": pa.list_(TEXT),
        "asked": ASKED,
        "needs": TEXT,
        "measured": pa.struct({"laws": WHOLE, "phases": WHOLE, "unknowns": WHOLE, "score": WHOLE}),
        "parts": pa.list_(PART),
        "distractors": DISTRACTORS,
        "idle": pa.list_(TEXT),
        "idle_numbers": pa.list_(TEXT),
        "solution": SOLUTION,
        "unsolved": TEXT,
        "scene": TEXT,
        "certificate": TEXT,
        "provenance": pa.struct(
            {
                "recipe": TEXT,
                "difficulty": TEXT,
                "mode": TEXT,
                "seed": WHOLE,
                "index": WHOLE,
                "versions": TEXT,
                "settings": TEXT,
                "weights": TEXT,
                "units": TEXT,
                "needs": pa.list_(TEXT),
            }
        ),
    }
)
"""What has keys of its own, the certificate, the versions and the weights, is kept as JSON text."""
COLUMNS: tuple[str, ...] = tuple(SCHEMA.names)
OPEN = "versions", "weights"
BATCH_ROWS = 100  # rows that are plain values at a time
Row = dict[str, Any]


def write(path: Path, items: Sequence[Item]) -> None:
    """Write a file; equal items give equal bytes with the same pyarrow."""
    table = pa.Table.from_pylist([_row(item) for item in items], schema=SCHEMA)
    # all that decides about bytes is said here, and none of it depends on the clock or the machine's cores
    with path.open("wb") as file:  # by its own name pyarrow opens only what is UTF-8
        pq.write_table(table, file, compression="zstd", compression_level=3, version="2.6")


def read(path: Path, places: Sequence[int] | None = None) -> list[Item]:
    """Return the items of one file, or those at some indices, in order; OSError or ValueError if damaged."""
    with _opened(path) as file:
        return [Item.model_validate(row) for row in _take_rows(file.read(use_threads=False), places).to_pylist()]


def rows(path: Path, columns: Sequence[str], places: Sequence[int] | None = None) -> Iterator[Row]:
    """Yield some columns (``recipe``, ``asked.quantity``) of one file, row by row."""
    with _opened(path) as file:
        table = file.read(columns=list(columns), use_threads=False)
        for batch in _take_rows(table, places).to_batches(max_chunksize=BATCH_ROWS):
            yield from batch.to_pylist()


def count(path: Path) -> int:
    """Return the number of rows in a file's metadata; OSError or ValueError if damaged."""
    with _opened(path) as file:
        return file.metadata.num_rows


def _take_rows(table: Any, places: Sequence[int] | None) -> Any:  # noqa: ANN401 - pyarrow has no types
    return table if places is None else table.take(pa.array(places, WHOLE))


@contextmanager
def _opened(path: Path) -> Generator[Any, None, None]:
    """Open a file for reading without threads, which could abort Python at exit."""
    try:
        with path.open("rb") as file:
            yield pq.ParquetFile(file, pre_buffer=False)
    except (pa.ArrowException, KeyError, TypeError) as error:
        raise ValueError(str(error)) from error


def _row(item: Item) -> dict[str, Any]:
    row = item.model_dump(mode="json")
    for record in (row, *row["parts"]):
        record["certificate"] = _json(record["certificate"])
    row["provenance"] |= {name: _json(row["provenance"][name]) for name in OPEN}
    return row


def _json(value: object) -> str:
    return json.dumps(value, sort_keys=True, ensure_ascii=False, allow_nan=False)
