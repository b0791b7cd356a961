"""Tests that traces in Parquet files keep their values and metadata."""

import json
import os
from pathlib import Path

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest

import machines
from sim2reason.errors import SceneError
from sim2reason.simulation import trace_files
from sim2reason.simulation.trace import ENGINES, Channel, channels

TIMES = np.linspace(0.0, 2.0, 41)


@pytest.mark.parametrize("name", ["carts", "prism", "atwood with a massive pulley"])
@pytest.mark.parametrize("engine", ["exact", "mujoco"])
def test_all_comes_back(name: str, engine: str, tmp_path: Path) -> None:
    trace = ENGINES[engine](machines.SAMPLES[name](), TIMES)
    trace_files.write_trace(trace, tmp_path / "trace.parquet")
    read = trace_files.read_trace(tmp_path / "trace.parquet")
    assert read.engine == engine
    assert read.events == trace.events
    assert (read.stable_until, read.cut) == (trace.stable_until, trace.cut)
    assert read.times.tobytes() == trace.state.times.tobytes()
    expected = dict(channels(trace.mechanism))
    assert list(read.channels) == list(expected)
    for channel, quantity in expected.items():
        values = quantity.evaluate(trace.state, channel.subject)
        np.testing.assert_array_equal(read.channels[channel], values, strict=True)  # NaN equals NaN here


def test_a_field_says_what_it_is(tmp_path: Path) -> None:
    trace = ENGINES["exact"](machines.carts(), TIMES)
    trace_files.write_trace(trace, tmp_path / "trace.parquet")
    schema = pq.read_schema(tmp_path / "trace.parquet")
    assert schema.field("time").metadata == {b"quantity": b"time", b"unit": b"s"}
    meaning = schema.field("runner velocity x").metadata
    assert meaning == {b"subject": b"runner", b"quantity": b"velocity", b"unit": b"m/s", b"axis": b"x"}
    assert schema.field("rope tension").metadata[b"unit"] == b"N"
    about = json.loads(schema.metadata[b"trace"])
    assert about["events"][0][1:] == ["collision", ["runner", "target"]]
    assert trace_files.read_trace(tmp_path / "trace.parquet").channels[Channel("runner", "velocity")].shape == (41, 3)


def test_the_same_trace_gives_the_same_bytes(tmp_path: Path) -> None:
    for name in ("one", "two"):
        trace_files.write_trace(ENGINES["exact"](machines.carts(), TIMES), tmp_path / name)
    assert (tmp_path / "one").read_bytes() == (tmp_path / "two").read_bytes()


def test_other_files_are_refused(tmp_path: Path) -> None:
    (tmp_path / "text").write_text("time,x\n0,1\n")
    with pytest.raises(SceneError, match="no Parquet file"):
        trace_files.read_trace(tmp_path / "text")
    pq.write_table(pa.table({"time": [0.0]}), tmp_path / "table")
    with pytest.raises(SceneError, match="no trace"):
        trace_files.read_trace(tmp_path / "table")
    with pytest.raises(OSError, match="missing"):
        trace_files.read_trace(tmp_path / "missing")


@pytest.mark.parametrize(
    "about", [None, "{", "[]", '{"events": [[0.0]], "stable_until": 1.0, "cut": null, "engine": ""}']
)
def test_damaged_traces_are_refused(tmp_path: Path, about: str | None) -> None:
    path = tmp_path / "trace.parquet"
    trace_files.write_trace(ENGINES["exact"](machines.carts(), TIMES), path)
    table = pq.read_table(path)
    spoiled = {"format": table.schema.metadata[b"format"]} | ({"trace": about} if about is not None else {})
    pq.write_table(table.replace_schema_metadata(spoiled), path)
    with pytest.raises(SceneError, match="damaged"):
        trace_files.read_trace(path)


def test_a_name_need_not_be_utf_8(tmp_path: Path) -> None:
    path = tmp_path / os.fsdecode(b"trace-\xff.parquet")
    trace_files.write_trace(ENGINES["exact"](machines.carts(), TIMES), path)
    assert len(trace_files.read_trace(path).times) == len(TIMES)
