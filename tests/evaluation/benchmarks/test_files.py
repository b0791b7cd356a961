"""Tests of benchmark files, the general loader, and this library's own suite."""

import json
import sys
from hashlib import sha256
from pathlib import Path
from types import ModuleType

import pytest

from sim2reason.datasets.generate import generate
from sim2reason.errors import EvaluationError, MissingExtraError, UnknownNameError
from sim2reason.evaluation.benchmarks import BENCHMARKS, Benchmark, build_benchmark, data_hash, load_items

ROWS = [
    {"question": "How far?", "answer": "2.5", "unit": "m", "subject": "mechanics", "id": "a"},
    {"question": "How hot?", "answer": 300, "unit": "K", "subject": "heat", "id": "b", "image": "fig.png"},
    {"question": "How loud?", "answer": ["60"], "unit": "phon", "subject": "waves", "id": "c"},
]


def written(tmp_path: Path, kind: str) -> Path:
    path = tmp_path / f"file.{kind}"
    if kind == "parquet":
        from pyarrow import Table, parquet

        parquet.write_table(Table.from_pylist([{**row, "answer": str(row["answer"])} for row in ROWS[:2]]), path)
    else:
        lines = "".join(f"{json.dumps(row)}\n" for row in ROWS)
        path.write_text(lines if kind == "jsonl" else json.dumps(ROWS))
    return path


def made(path: Path, **settings: object) -> Benchmark:
    return build_benchmark({"kind": "jsonl", "name": "mine", "file": str(path), **settings})


@pytest.mark.parametrize("kind", ["json", "jsonl", "parquet"])
def test_rows_of_every_format_are_read(tmp_path: Path, kind: str) -> None:
    found = load_items(made(written(tmp_path, kind), text_only=False))
    assert [item.id for item in found][:2] == ["a", "b"]
    assert found[0].reference["value"] == 2.5
    assert found[0].reference["unit"] == "m"
    assert found[0].prompt.startswith("How far?\n\n")


def test_filters_counts_and_hashes(tmp_path: Path) -> None:
    path = written(tmp_path, "jsonl")
    right = sha256(path.read_bytes()).hexdigest()
    assert [item.id for item in load_items(made(path, sha256=right, expected=2))] == ["a", "c"]
    assert load_items(made(path))[1].reference["unit"] is None  # no unit of our table
    with pytest.raises(EvaluationError, match="its SHA-256 is"):
        load_items(made(path, sha256="0" * 64))
    with pytest.raises(EvaluationError, match="2 problems where 512 are expected"):
        load_items(made(path, expected=512))
    with pytest.raises(EvaluationError, match="no problem passes"):
        load_items(made(path, subjects=["heat"]))
    whole = data_hash(load_items(made(path)))
    assert whole == data_hash(load_items(made(path)))
    assert whole != data_hash(load_items(made(path, limit=1)))


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b'[{"question": "a"}]', "row 0 has no 'answer'"),
        (b'[{"question": "a", "answer": "many"}]', "row 0: its answer 'many' is no number"),
        (b'[{"question": "", "answer": "1"}]', "row 0: its question is no text"),
        (b'[{"question": "a", "answer": []}]', "is no number"),
        (b'[{"question": "a", "answer": "1", "id": 3}, {"question": "a", "answer": "1", "id": 3}]', "'3' twice"),
        (b'{"question": "a"}', "no list of objects"),
        (b"[1]", "no list of objects"),
        (b"[", "not readable"),
        (b"[" * 100_000, "not readable"),
        (b"\xff\xfe", "not readable"),
    ],
)
def test_a_damaged_file_is_one_line_that_names_it(tmp_path: Path, content: bytes, message: str) -> None:
    path = tmp_path / "file.json"
    path.write_bytes(content)
    with pytest.raises(EvaluationError, match=message) as raised:
        load_items(made(path))
    assert "\n" not in str(raised.value)


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"kind": "jsonl", "name": "a"}, "give either file or hub"),
        ({"kind": "jsonl", "name": "a", "file": "x", "sha256": "12"}, "64 hexadecimal digits"),
        ({"kind": "jsonl", "name": "a", "file": "x", "scoring": "guess"}, "no such rule"),
        ({"kind": "jsonl", "name": "a", "file": "x", "colour": "red"}, "colour: no such setting"),
        ({"kind": "jsonl", "file": "x"}, "name: is missing"),
        ({"name": "a"}, "kind: give one of"),
        ({"kind": "synthetic", "name": "a"}, "give either dataset, a folder, or seed"),
        ({"kind": "synthetic", "name": "a", "seed": 1, "split": "test"}, "split is one of a dataset"),
        ({"kind": "synthetic", "name": "a", "seed": 1, "modes": []}, "modes: names none"),
        (
            {"kind": "synthetic", "name": "a", "dataset": "d", "recipe": "pulley"},
            "recipe is of problems that are drawn",
        ),
    ],
)
def test_settings_are_checked(settings: dict[str, object], message: str) -> None:
    with pytest.raises(EvaluationError, match=message):
        build_benchmark(settings)


def test_a_missing_file_another_format_and_an_unknown_kind(tmp_path: Path) -> None:
    with pytest.raises(EvaluationError, match="no such file"):
        load_items(made(tmp_path / "none.json"))
    (tmp_path / "a.csv").write_text("question,answer\n")
    with pytest.raises(EvaluationError, match="no format that is known"):
        load_items(made(tmp_path / "a.csv"))
    with pytest.raises(UnknownNameError, match="did you mean: jeebench"):
        build_benchmark({"kind": "jebench"})


def test_the_hub_is_asked_through_its_own_library(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    settings = {"kind": "jsonl", "name": "a", "hub": {"repository": "some/set", "path": "file.jsonl"}}
    monkeypatch.setitem(sys.modules, "huggingface_hub", None)
    with pytest.raises(MissingExtraError, match=r"pip install .*'math-verify"):
        load_items(build_benchmark(settings))
    hub, path = ModuleType("huggingface_hub"), written(tmp_path, "jsonl")
    monkeypatch.setattr("sim2reason.evaluation.benchmarks.files.out_of_reach", lambda *_: False)
    hub.hf_hub_download = lambda *_, **__: str(path)  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "huggingface_hub", hub)
    assert len(load_items(build_benchmark(settings))) == 2
    hub.hf_hub_download = lambda *_, **__: 1 / 0  # type: ignore[attr-defined]
    with pytest.raises(EvaluationError, match=r"hub: no file\.jsonl of some/set at main"):
        load_items(build_benchmark(settings))


def test_physics_mathematics_and_exercises_have_columns_of_their_own(tmp_path: Path) -> None:
    path = tmp_path / "a.json"
    path.write_text(json.dumps([{"questions": "Why?", "final_answers": ["$x=1$", "2"], "graphs": None}]))
    (item,) = load_items(build_benchmark({"kind": "physics", "name": "p", "file": str(path)}))
    assert (item.scoring, item.reference["answers"]) == ("physics", ["$x=1$", "2"])
    path.write_text(json.dumps([{"problem": "1 + 1?", "answer": 2}]))
    (item,) = load_items(build_benchmark({"kind": "math", "name": "aime", "file": str(path)}))
    assert (item.scoring, item.reference["answer"], item.id) == ("math", "2", "aime-0")
    path.write_text(json.dumps([{"question": "How fast?", "answer": "3", "unit": "km/h"}]))
    (item,) = load_items(build_benchmark({"kind": "hcv", "name": "hcv", "file": str(path)}))
    assert (item.scoring, item.reference["unit"]) == ("numeric", "km/h")


def test_an_olympiad_file_has_points_and_illustrations(tmp_path: Path) -> None:
    row = {"id": "x", "context": "C", "question": "Q", "answer": [r"\boxed{$3$}"], "answer_type": ["Numerical Value"]}
    row |= {"unit": ["m"], "points": [0.5], "modality": "text-only", "field": "Mechanics", "source": "ours"}
    others = [
        {**row, "id": "y", "modality": "text+variable figure"},
        {**row, "id": "z", "modality": "text+illustration figure", "answer_type": ["Expression"]},
        {"information": "about the paper"},
    ]
    path = tmp_path / "a.json"
    path.write_text(json.dumps([row, *others]))
    settings = {"kind": "hipho", "name": "i", "file": str(path)}
    assert [item.id for item in load_items(build_benchmark(settings))] == ["x", "z"]
    (item,) = load_items(build_benchmark({**settings, "numeric_only": True}))
    assert item.reference["parts"] == [{"answer": "3", "unit": "m", "points": 0.5, "type": "Numerical Value"}]


def test_our_suite_is_a_dataset_or_drawn(tmp_path: Path) -> None:
    generate(tmp_path / "d", items=6, recipe="pulley", maker="fake_makers:steady", workers=1)
    found = load_items(build_benchmark({"kind": "synthetic", "name": "ours", "dataset": str(tmp_path / "d")}))
    assert len(found) == 6
    assert found[0].tags["recipe"] == ("pulley",)
    assert found[0].scoring == "sim2reason"
    assert "N" in found[0].answer_text
    drawn = {"kind": "synthetic", "name": "ours", "seed": 99, "items": 2, "recipe": "projectile", "difficulty": "easy"}
    first, second = load_items(build_benchmark(drawn)), load_items(build_benchmark(drawn))
    assert first == second
    assert {item.id.split("-")[3] for item in first} == {"99"}


def test_every_kind_says_what_it_is() -> None:
    assert all((kind.__doc__ or "").strip() for kind in BENCHMARKS.values())


def test_a_column_may_be_a_path_into_what_is_nested(tmp_path: Path) -> None:
    file = tmp_path / "nested.jsonl"
    row = {"prompt": [{"role": "user", "content": "2 + 2?"}], "reward_model": {"ground_truth": "4"}}
    file.write_text(json.dumps(row) + "\n")
    columns = {"question_column": "prompt.0.content", "answer_column": "reward_model.ground_truth"}
    settings = {"kind": "jsonl", "name": "nested", "file": file, "id_column": "extra_info.index", **columns}
    (found,) = load_items(build_benchmark(settings))
    assert found.prompt.startswith("2 + 2?")
    assert found.reference["value"] == 4.0
    with pytest.raises(EvaluationError, match=r"prompt\.1\.content"):
        load_items(build_benchmark({**settings, "question_column": "prompt.1.content"}))
