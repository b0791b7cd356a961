"""Tests of the search for problems shared with a benchmark in any file; other files give a one-line error."""

import json
from collections.abc import Callable
from pathlib import Path

import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from click.testing import CliRunner
from hypothesis import given, settings
from hypothesis import strategies as st

from fake_makers import steady
from sim2reason.cli import main
from sim2reason.datasets import contamination
from sim2reason.datasets.contamination import RUN_LENGTH, Benchmarks, words
from sim2reason.datasets.dataset import Dataset
from sim2reason.datasets.generate import Order, generate
from sim2reason.datasets.manifest import read_refusals
from sim2reason.errors import DatasetError
from sim2reason.generation.request import Request

ORIGINAL = (
    "A block of mass $m = 2.5 \\mathrm{~kg}$ rests on a rough incline of angle $30^{\\circ}$ while a light string, "
    "which passes over a smooth pulley, joins it to a second block that hangs freely."
)
VARIANT = (
    "Find the tension. A block of mass M=4 kg rests on a rough incline of angle 45° while a light string, which "
    "passes over a smooth pulley, joins it to a second block that hangs freely."
)
REWORDED = "A crate of 4 kg lies on a rough slope. A light string over a smooth pulley joins it to another that hangs."


def json_file(folder: Path) -> Path:
    (folder / "b.json").write_text(json.dumps({"test": [{"q": "short"}, {"id": 7, "parts": [{"text": ORIGINAL}]}]}))
    return folder / "b.json"


def json_lines(folder: Path) -> Path:
    (folder / "b.jsonl").write_text(f"{json.dumps({'q': 'short'})}\n\n{json.dumps([ORIGINAL])}\n")
    return folder / "b.jsonl"


def parquet(folder: Path) -> Path:
    table = pa.table({"n": [1, 2], "image": [b"a", b"b"], "turns": [[{"text": "short"}], [{"text": ORIGINAL}]]})
    pq.write_table(table, folder / "b.parquet")
    return folder / "b.parquet"


def plain(folder: Path) -> Path:
    (folder / "b.txt").write_text("short\n\n  \n" + ORIGINAL.replace(" a ", "\na "))
    return folder / "b.txt"


@pytest.mark.parametrize("file", [json_file, json_lines, parquet, plain])
def test_a_variant_of_a_benchmarks_problem_is_found_in_any_file(tmp_path: Path, file: Callable[[Path], Path]) -> None:
    path = file(tmp_path)
    found = Benchmarks([path]).overlap(VARIANT)
    assert found is not None
    assert (found.file, found.item) == (path.name, 2)
    assert len(found.words.split()) == RUN_LENGTH
    assert found.words.startswith("block of mass kg rests on rough incline of angle")
    assert Benchmarks([path]).overlap(REWORDED) is None


def test_no_benchmark_shares_nothing() -> None:
    assert Benchmarks([]).overlap(VARIANT) is None


@settings(max_examples=30)
@given(st.lists(st.sampled_from(["red", "green", "blue", "grey", "gold", "pink"]), max_size=40), st.integers(0, 30))
def test_a_run_is_found_wherever_it_stands_and_one_word_less_is_not(
    tmp_path_factory: pytest.TempPathFactory, colours: list[str], start: int
) -> None:
    run = [f"{a}{b}" for a, b in zip("abcdefghij", "klmnopqrst", strict=True)]
    text = " ".join(colours[:start] + run + colours[start:])
    path = tmp_path_factory.mktemp("run") / "b.txt"
    path.write_text("… ".join(run), encoding="utf-8")
    benchmarks = Benchmarks([path])
    assert benchmarks.overlap(text) is not None
    assert benchmarks.overlap(text.replace(run[3], "other")) is None


def test_words_have_no_numbers_symbols_or_spelling() -> None:
    assert words("The Block’s mass: $m_{A}=\\text{2.5\\,kg}$, 3×10⁻² m/s; ﬁnd 12cm") == [
        *("the", "block", "mass", "kg", "find", "cm")
    ]


@pytest.mark.parametrize(
    ("name", "content", "word"),
    [
        ("b.json", b"[1, 2", "not readable"),
        ("b.json", b"\xff\xfe{", "not readable"),
        ("b.json", b"[" * 100_000, "not readable"),
        ("b.json", b"[" * 500 + b"]" * 500, "nested in more than"),
        ("b.json", b"[" + b"9" * 10_000 + b"]", "not readable"),
        ("b.jsonl", b"{}\n{", "not readable"),
        ("b.txt", b"\xff", "not readable"),
        ("b.parquet", b"PAR1", "not readable"),
        ("b.csv", b"a,b", "not a kind of file"),
        ("none.json", None, "no such file"),
        ("b.json", b"[]", "holds no text"),
        ("b.json", b'[{"id": 3, "x": ["4.5", "$\\\\pi$"]}]', "holds no text"),
        ("b.jsonl", b"\n", "holds no text"),
        ("b.txt", b"", "holds no text"),
    ],
)
def test_what_can_not_be_read_is_one_line(tmp_path: Path, name: str, content: bytes | None, word: str) -> None:
    if content is not None:
        (tmp_path / name).write_bytes(content)
    options = ["--items", "1", "--recipe", "pulley", "--maker", "fake_makers:steady"]
    result = CliRunner().invoke(
        main, ["generate", str(tmp_path / "out"), *options, "--decontaminate", str(tmp_path / name)]
    )
    assert result.exit_code == 2
    assert result.stderr.count("\n") == 1
    assert name in result.stderr
    assert word in result.stderr
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("limit", "module", "size", "name"),
    [
        ("MAX_WORDS", contamination, 5, "b.txt"),
        ("MAX_FILE_SIZE", contamination, 100, "b.txt"),
        ("MAX_PART_SIZE", contamination, 100, "b.txt"),
        ("MAX_PART_SIZE", contamination, 100, "b.json"),
        ("MAX_PART_SIZE", contamination, 100, "b.jsonl"),
        ("MAX_PART_SIZE", contamination, 100, "b.parquet"),
    ],
)
def test_sizes_are_bounded(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, limit: str, module: object, size: int, name: str
) -> None:
    makers = {"b.txt": plain, "b.json": json_file, "b.jsonl": json_lines, "b.parquet": parquet}
    path = makers[name](tmp_path)
    monkeypatch.setattr(module, limit, size)
    with pytest.raises(DatasetError, match=r"more than|larger than"):
        Benchmarks([path])


def test_what_meets_a_benchmark_is_left_out_and_told(
    tmp_path: Path, contents: Callable[[Path], dict[str, bytes]]
) -> None:
    first = steady(Request("incline", "easy", "numeric", 0, 0)).item
    assert first is not None
    (tmp_path / "own.txt").write_text(" ".join(words(first.prompt)[:RUN_LENGTH]))
    for name, workers in (("one", 1), ("two", 2)):
        generate(tmp_path / name, workers=workers, decontaminate=[tmp_path / "own.txt"], **_order())
    found = list(read_refusals(tmp_path / "one", "contaminated"))
    data = generate(tmp_path / "all", workers=1, **_order())
    assert len(found) == 59  # all of incline but the one without a draw; texts of pulley name another recipe
    assert {each.recipe for each in found} == {"incline"}
    assert found[0].reason.endswith("with item 1 of own.txt")
    manifest = generate(tmp_path / "one", workers=1, decontaminate=[tmp_path / "own.txt"], **_order()).manifest
    assert manifest.rows == data.manifest.rows == 60
    assert manifest.counts["recipe"] == {"pulley": 60}  # which took their place
    assert {item.recipe for item in Dataset(tmp_path / "one")} == {"pulley"}
    assert manifest.rejected["incline"]["contaminated"] == manifest.refused["contaminated"].total == len(found)
    assert manifest.config.decontaminate[0].name == "own.txt"
    assert contents(tmp_path / "one") == contents(tmp_path / "two")
    (tmp_path / "own.txt").write_text("other words")
    with pytest.raises(DatasetError, match="another configuration"):
        generate(tmp_path / "one", workers=1, decontaminate=[tmp_path / "own.txt"], **_order())


def _order() -> Order:
    return {"items": 60, "recipe": ("incline", "pulley"), "difficulty": "easy", "maker": "fake_makers:steady"}
