"""Tests of reports, comparisons and correlations of small runs."""

import json
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from sim2reason.errors import EvaluationError
from sim2reason.evaluation.benchmarks import build_benchmark
from sim2reason.evaluation.benchmarks.runs.config import Evaluation, RunFolder
from sim2reason.evaluation.reports.comparison import compare, correlate
from sim2reason.evaluation.reports.evaluation import evaluate
from sim2reason.evaluation.reports.results import wilson_interval
from told_policy import Told

Made = Callable[..., Evaluation]


def test_a_report_has_numbers_pages_and_pictures(made: Made) -> None:
    found = evaluate(made(Told(name="good"), Told(name="half", right=0.5), samples=2))
    folder = found.folder.report
    assert sorted(path.name for path in folder.iterdir()) == sorted(
        ["report.json", "report.md", "scores.jsonl", "answers.html", "accuracy.png", "numbers-subject.png"]
    )
    good, half = found.report.results
    assert (good.accuracy.value, half.accuracy.value) == (1.0, 0.5)
    assert (good.responses, good.missing, good.samples) == (40, 0, 2)
    assert half.pass_at == {1: 0.5, 2: 0.5}
    assert half.groups["subject"]["even"].items == 10
    assert half.tokens == pytest.approx(3 + 9.5)
    assert {str(name): count for name, count in half.endings.items() if count} == {"correct": 20, "wrong": 20}
    text = (folder / "report.md").read_text("utf-8")
    assert "| numbers | half | 20 | 2 | 50.0 [" in text
    assert "numbers, by subject" in text
    assert (folder / "accuracy.png").read_bytes().startswith(b"\x89PNG")


def test_one_sample_each_has_wilsons_interval(made: Made) -> None:
    (found,) = evaluate(made(Told(name="half", right=0.5))).report.results
    expected = wilson_interval(10, 20)
    assert (found.accuracy.low, found.accuracy.high) == (expected.low, expected.high)


def test_a_report_is_the_same_each_time_and_asks_nothing_again(made: Made) -> None:
    evaluation = made(Told(name="told", right=0.3), samples=2)
    first = evaluate(evaluation)
    held = {path.name: path.read_bytes() for path in first.folder.report.iterdir()}
    again = made(Told(name="told", right=0.3), samples=2)
    evaluate(again)
    assert not again.policies[0]._asked  # type: ignore[attr-defined]
    assert held == {path.name: path.read_bytes() for path in first.folder.report.iterdir()}


def test_what_models_say_is_shown_and_never_run(made: Made) -> None:
    attack = "<script>alert(1)</script> | a | b |\n# head"
    told = Told(name="told", texts={"n1": [attack + r"\boxed{<img src=x onerror=alert(1)>}"]})
    folder = evaluate(made(told)).folder.report
    page = (folder / "answers.html").read_text("utf-8")
    assert "<script" not in page
    assert "<img" not in page
    assert "&lt;script&gt;" in page


def test_lengths_and_accuracies_over_training(made: Made) -> None:
    policies = [Told(name=f"step-{n}", right=n / 100, step=n) for n in (0, 50, 100)]
    assert "steps.png" in evaluate(made(*policies)).report.pictures


def test_without_matplotlib_there_are_no_pictures_and_it_says_so(made: Made, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    found = evaluate(made())
    assert found.report.pictures == ()
    assert "matplotlib is not installed" in (found.folder.report / "report.md").read_text("utf-8")


def test_a_run_grows_and_refuses_what_it_cannot_go_on_with(made: Made) -> None:
    evaluate(made(Told(name="a")))
    grown = made(Told(name="a"), Told(name="b"), samples=3)
    found = evaluate(grown)
    assert len(grown.policies[0]._asked) == 40  # type: ignore[attr-defined]
    assert {(r.policy, r.responses) for r in found.report.results} == {("a", 60), ("b", 60)}
    evaluate(made(Told(name="a")))  # fewer samples: those that stand are kept
    with pytest.raises(EvaluationError, match=r"another configuration \(seed 0 ≠ 1"):
        evaluate(made(Told(name="a"), seed=1))
    with pytest.raises(EvaluationError, match="policy a: right"):
        evaluate(made(Told(name="a", right=0.1)))


def test_a_folder_with_something_else_is_left_alone(made: Made, tmp_path: Path) -> None:
    (tmp_path / "run").mkdir()
    (tmp_path / "run/thesis.tex").write_text("years of work")
    with pytest.raises(EvaluationError, match=r"holds thesis\.tex and is no run"):
        evaluate(made())
    assert [path.name for path in (tmp_path / "run").iterdir()] == ["thesis.tex"]


def test_problems_that_changed_are_noticed(made: Made, tmp_path: Path) -> None:
    evaluate(made())
    path = tmp_path / "run/problems/numbers.jsonl"
    path.write_text(path.read_text("utf-8").replace("How much is 3", "How much is 4"))
    folder = RunFolder(tmp_path / "run")
    with pytest.raises(EvaluationError, match="changed since the run was begun"):
        folder.items("numbers")


def test_a_judge_rules_on_what_the_rule_did_not_pay(tmp_path: Path) -> None:
    path = tmp_path / "physics.json"
    path.write_text(json.dumps([{"questions": f"Why {n}?", "final_answers": [str(n)], "id": f"n{n}"} for n in (1, 2)]))
    benchmark = build_benchmark({"kind": "physics", "name": "physics", "file": str(path)})
    policy = Told(name="told", texts={"n1": [r"\boxed{1}"], "n2": [r"\boxed{two}"]})
    judge = Told(name="judge", texts={"n2#0": [r"\boxed{yes}"]})
    (found,) = evaluate(Evaluation(tmp_path / "run", (policy,), (benchmark,), judge=judge)).report.results
    assert [request.id for request in judge._asked] == ["n2#0"]
    assert (found.accuracy.value, found.judged) == (1.0, 1)


def test_two_runs_are_compared_problem_by_problem(made: Made, tmp_path: Path) -> None:
    evaluate(made(Told(name="base", right=0.5), out="before"))
    evaluate(made(Told(name="trained", right=0.8), Told(name="base", right=0.5), out="after"))
    (found,) = compare(tmp_path / "before", f"{tmp_path}/after:trained", tmp_path / "comparison")
    assert (found.items, found.first, found.second, found.better, found.worse) == (20, 0.5, 0.8, 6, 0)
    assert found.difference.value == pytest.approx(0.3)
    assert 0.0 < found.difference.low < 0.3 < found.difference.high
    assert "| numbers | 20 | 50.0 | 80.0 | 30.0 [" in (tmp_path / "comparison/compare.md").read_text("utf-8")
    assert json.loads((tmp_path / "comparison/compare.json").read_text("utf-8"))["benchmarks"][0]["better"] == 6
    (tmp_path / "data").mkdir()
    (tmp_path / "data/manifest.json").touch()
    with pytest.raises(EvaluationError, match=r"data: holds manifest\.json and no compare\.json; choose a new folder"):
        compare(tmp_path / "before", f"{tmp_path}/after:trained", tmp_path / "data")
    assert len(list((tmp_path / "data").iterdir())) == 1
    with pytest.raises(EvaluationError, match=r"which policy.*base, trained"):
        compare(tmp_path / "before", tmp_path / "after")
    with pytest.raises(EvaluationError, match=r"no run\.json here"):
        compare(tmp_path / "before", tmp_path)


def test_runs_with_other_problems_are_not_compared(made: Made, tmp_path: Path) -> None:
    evaluate(made(out="before"))
    other = made(out="after")
    rows = json.loads((tmp_path / "numbers.json").read_text("utf-8"))
    (tmp_path / "numbers.json").write_text(json.dumps(rows[:10]))
    evaluate(other)
    with pytest.raises(EvaluationError, match="other problems"):
        compare(tmp_path / "before", tmp_path / "after")


def test_models_are_correlated_across_benchmarks(made: Made, tmp_path: Path) -> None:
    shares = 0.1, 0.4, 0.5, 0.9
    for number, share in enumerate(shares):
        evaluate(made(Told(name=f"m{number}", right=share), out=f"run-{number}", names=("ours", "theirs")))
    runs = [tmp_path / f"run-{number}" for number in range(4)]
    (found,) = correlate(runs, "ours", out=tmp_path / "correlation")
    assert found.models == ("m0", "m1", "m2", "m3")
    assert found.rho is not None
    assert found.rho.value == pytest.approx(1.0)
    names = {path.name for path in (tmp_path / "correlation").iterdir()}
    assert names == {"correlate.json", "correlate.md", "ours-theirs.png"}
    with pytest.raises(EvaluationError, match="2 models have answered both; it takes 3"):
        correlate(runs[:2], "ours")
    with pytest.raises(EvaluationError, match="which benchmark shall lie across"):
        correlate(runs)
    with pytest.raises(EvaluationError, match="no benchmark 'none' in these runs; there are: ours, theirs"):
        correlate(runs, "ours", ["none"])
    with pytest.raises(EvaluationError, match="no benchmark 'none' in these runs; there are: ours, theirs"):
        correlate(runs, "none")
    with pytest.raises(EvaluationError, match="ours lies across; correlate it with others: ours, theirs"):
        correlate(runs, "ours", ["theirs", "ours"])
    with pytest.raises(EvaluationError, match="run-0: this run stands twice"):
        correlate([*runs, tmp_path / "correlation" / ".." / "run-0"], "ours")
    correlate(runs[1:], "ours", out=tmp_path / "correlation")
    with pytest.raises(EvaluationError, match=r"run-0: holds .* and no correlate\.json; choose a new folder"):
        correlate(runs, "ours", out=runs[0])


def test_drawn_problems_are_not_drawn_again_by_a_run_that_goes_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    settings = {"kind": "synthetic", "name": "ours", "seed": 5, "items": 2, "recipe": "projectile"}
    config = {"out": str(tmp_path / "run"), "benchmarks": [{**settings, "difficulty": "easy"}]}
    policies = [{"kind": "constant", "name": "one", "text": r"\boxed{1}"}]
    first = evaluate({**config, "policies": policies})
    monkeypatch.setattr("sim2reason.evaluation.benchmarks.own.stream", None)
    again = evaluate({**config, "policies": policies, "samples": 2})
    assert again.report.results[0].items == first.report.results[0].items == 2
    assert set(again.report.results[0].groups) >= {"recipe", "difficulty", "mode", "kind", "quantity", "entity"}
