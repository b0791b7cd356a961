"""Tests of problems that are sampled on the fly or read from files."""

import json
from pathlib import Path

import pytest

from sim2reason.datasets.generate import generate
from sim2reason.datasets.items import item
from sim2reason.errors import MissingExtraError, TrainingError, UnknownNameError
from sim2reason.training.sources import SOURCES, build_source
from sim2reason.training.sources.problems import Fresh, fingerprint


def test_a_problem_is_that_of_its_coordinates() -> None:
    source = Fresh(name="ours", recipe="pulley", difficulty="easy", seed=3)
    found = source.at("easy", 4)
    assert found is not None
    assert found.item.prompt == item("pulley", "easy", seed=3, index=4).prompt
    assert (found.source, found.cell) == ("ours", "easy")
    assert found == source.at("easy", 4)


def test_cells_are_difficulties_and_recipes_take_turns() -> None:
    source = Fresh(name="ours", recipe=("pulley", "incline"), difficulty=("easy", "hard"), seed=3)
    assert source.cells == ("easy", "hard")
    recipes = [source.request("hard", index).recipe for index in range(4)]
    assert sorted(recipes[:2]) == ["incline", "pulley"] == sorted(recipes[2:])


def test_only_some_kinds_and_quantities() -> None:
    source = Fresh(name="ours", recipe="rolling", difficulty="easy", seed=3, kinds=("state",), quantities=("momentum",))
    found = [problem for index in range(4) if (problem := source.at("easy", index))]
    assert found
    assert {problem.item.tags["quantity"] for problem in found} == {("momentum",)}
    assert {problem.item.tags["kind"] for problem in found} == {("state",)}


def test_quantities_are_drawn_not_picked_and_change_the_name() -> None:
    source = Fresh(name="ours", recipe="rolling", difficulty="easy", seed=3, kinds=("state",))
    chosen = source.model_copy(update={"quantities": ("momentum",)})
    found = [chosen.at("easy", index) for index in range(6)]
    assert sum(problem is not None for problem in found) >= 5
    assert chosen.request("easy", 0).id != source.request("easy", 0).id
    nothing = source.model_copy(update={"quantities": ("current",)})
    assert nothing.at("easy", 0) is None


def test_unfiltered_problems_are_others() -> None:
    source = Fresh(name="ours", recipe="rolling", difficulty="easy", seed=3, unfiltered=True)
    found = source.at("easy", 0)
    assert found is not None
    assert found.item.id == "rolling-easy-numeric-3-0-unfiltered"


def test_the_same_numbers_in_other_words() -> None:
    one = item("pulley", "easy", seed=3)
    assert fingerprint(one) == fingerprint(one.model_copy(update={"prompt": "In other words."}))
    assert fingerprint(one) != fingerprint(item("pulley", "easy", seed=3, index=1))


def test_a_folder_is_passed_through_again_in_another_order(tmp_path: Path) -> None:
    generate(tmp_path / "problems", items=6, recipe="pulley", difficulty="easy", workers=1)
    settings = {
        "kind": "benchmark",
        "name": "made",
        "benchmark": {"kind": "synthetic", "dataset": tmp_path / "problems"},
    }
    source = build_source(settings, "problems[0]")
    (cell,) = source.cells
    passes = [[found.item.id for n in range(6) if (found := source.at(cell, 6 * turn + n))] for turn in range(3)]
    assert all(sorted(each) == sorted(passes[0]) for each in passes)
    assert len({tuple(each) for each in passes}) > 1


def test_another_corpus_keeps_its_own_rule(tmp_path: Path) -> None:
    file = tmp_path / "questions.jsonl"
    file.write_text(json.dumps({"question": "2 + 2?", "answer": "4"}) + "\n")
    settings = {"kind": "benchmark", "name": "sums", "benchmark": {"kind": "jsonl", "file": file, "scoring": "numeric"}}
    found = build_source(settings, "problems[0]").at("sums", 7)
    assert found is not None
    assert found.item.scoring == "numeric"


def test_a_corpus_whose_rule_lacks_its_library_is_refused_as_it_is_read(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sim2reason.evaluation.benchmarks.scoring.find_spec", lambda _: None)
    file = tmp_path / "questions.jsonl"
    file.write_text(json.dumps({"question": "2 + 2?", "answer": "4"}) + "\n")
    settings = {"kind": "benchmark", "name": "sums", "benchmark": {"kind": "jsonl", "file": file, "scoring": "math"}}
    with pytest.raises(MissingExtraError):
        _ = build_source(settings, "problems[0]").cells


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"name": "x"}, r"problems\[0\]\.kind: give one of"),
        ({"kind": "fresh", "name": "x"}, r"problems\[0\]\.seed"),
        ({"kind": "fresh", "name": "x", "seed": 1, "kinds": ["perod"]}, "no such kind: 'perod'"),
        ({"kind": "fresh", "name": "x", "seed": 1, "quantities": ["mas"]}, "no such quantity: 'mas'"),
        ({"kind": "fresh", "name": "x", "seed": 1, "weight": 0}, r"problems\[0\]\.weight"),
        ({"kind": "fresh", "name": "x", "seed": 1, "kinds": ["sum"], "weights": {"sum": 1}}, "either kinds or weights"),
        ({"kind": "benchmark", "name": "x", "benchmark": {"kind": "jsonl"}}, "give either file or hub"),
    ],
)
def test_faults_name_their_place(settings: dict[str, object], message: str) -> None:
    with pytest.raises(TrainingError, match=message):
        build_source(settings, "problems[0]")


def test_an_unknown_kind_of_source() -> None:
    with pytest.raises(UnknownNameError, match="fresch"):
        build_source({"kind": "fresch"}, "problems[0]")
    assert {"fresh", "benchmark"} <= {*SOURCES}
