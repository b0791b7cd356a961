"""Storage of traces in Parquet files: a row for each sample, a column for each component of a channel."""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np

from sim2reason.errors import SceneError, UnsupportedError
from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.trace import Channel, Event, Trace, channels

FORMAT = "sim2reason trace 1"
AXES = ("x", "y", "z")
ENDING = ".parquet"


@dataclass(frozen=True)
class Recording:
    """The samples and events of a trace read from a file, without the mechanism."""

    engine: str
    times: Array  # s, (n,)
    channels: Mapping[Channel, Array]  # (n,), or (n, 3) for a vector
    units: Mapping[str, str]  # by quantity
    events: tuple[Event, ...]
    stable_until: float  # s
    cut: str = ""


def check(path: Path) -> None:
    """Raise UnsupportedError unless the name of a trace file ends in ``.parquet``."""
    if path.suffix.lower() != ENDING:
        raise UnsupportedError(f"{path}: a trace is written as Parquet; end the name in {ENDING}")


def write_trace(trace: Trace, path: str | Path) -> None:
    """Write all channels of a trace as Parquet; raise OSError if the file cannot be written.

    A field's metadata name its subject, quantity, unit and axis; the schema's hold the engine and the events.
    """
    arrow, parquet = _arrow()
    fields, columns = (
        [_field(arrow, "time", {"quantity": "time", "unit": trace.mechanism.units.time})],
        [trace.state.times],
    )
    for channel, quantity in channels(trace.mechanism):
        values = quantity.evaluate(trace.state, channel.subject)
        meaning = {
            "subject": channel.subject,
            "quantity": channel.quantity,
            "unit": trace.mechanism.units.spell(quantity.unit),
        }
        for axis, column in zip(AXES, values.T, strict=True) if quantity.vector else (("", values),):
            name = " ".join(filter(None, (channel.subject, channel.quantity, axis)))
            fields.append(_field(arrow, name, {**meaning, "axis": axis}))
            columns.append(column)
    events = [[event.time, event.kind, list(event.subjects)] for event in trace.events]
    about = {"engine": trace.engine, "events": events, "stable_until": trace.stable_until, "cut": trace.cut}
    schema = arrow.schema(fields, metadata={"format": FORMAT, "trace": json.dumps(about)})
    arrays = [arrow.array(np.ascontiguousarray(column)) for column in columns]
    with Path(path).open("wb") as file:  # by its own name pyarrow opens only what is UTF-8
        parquet.write_table(arrow.Table.from_arrays(arrays, schema=schema), file, compression="zstd")


def read_trace(path: str | Path) -> Recording:
    """Return the recording in a file of `write_trace`.

    Raises:
        SceneError: the file is not a trace.
        OSError: it can't be read.
    """
    arrow, parquet = _arrow()
    with Path(path).open("rb") as file:  # by its own name pyarrow opens only what is UTF-8
        try:
            table: Any = parquet.read_table(file)
        except arrow.ArrowInvalid as error:
            raise SceneError(str(path), f"this is no Parquet file: {error}") from error
    about: dict[bytes, bytes] = table.schema.metadata or {}
    if about.get(b"format") != FORMAT.encode():
        raise SceneError(
            str(path), "this is no trace", "write one with: sim2reason simulate scene.yaml -o trace.parquet"
        )
    try:
        return _recorded(table, json.loads(about[b"trace"]))
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise SceneError(str(path), f"this trace is damaged: {error!r}") from error


def _recorded(table: Any, about: dict[str, Any]) -> Recording:  # noqa: ANN401 - pyarrow has no types
    parts: dict[Channel, list[Array]] = {}
    units: dict[str, str] = {}
    for field, column in zip(table.schema, table.columns, strict=True):
        meaning = {key.decode(): value.decode() for key, value in field.metadata.items()}
        if "subject" in meaning:
            units[meaning["quantity"]] = meaning["unit"]
            parts.setdefault(Channel(meaning["subject"], meaning["quantity"]), []).append(column.to_numpy())
    values = {channel: p[0] if len(p) == 1 else np.stack(p, axis=1) for channel, p in parts.items()}
    times = table["time"].to_numpy()
    events = tuple(Event(float(time), kind, tuple(subjects)) for time, kind, subjects in about["events"])
    return Recording(about["engine"], times, values, units, events, float(about["stable_until"]), about["cut"])


def _field(arrow: Any, name: str, meaning: dict[str, str]) -> Any:  # noqa: ANN401 - pyarrow has no types
    return arrow.field(name, arrow.float64(), metadata=meaning)


def _arrow() -> tuple[Any, Any]:
    """Import PyArrow on demand, since it is slow to import."""
    return import_module("pyarrow"), import_module("pyarrow.parquet")
