"""Tests of configurations: the one in the docs, and the settings passed on to policies and benchmarks."""

from pathlib import Path

import pytest
import yaml

from sim2reason.errors import EvaluationError, PolicyError
from sim2reason.evaluation.benchmarks.runs.config import build_evaluation

PAGE = Path(__file__).parents[4] / "docs/evaluation.md"
POLICY = {"kind": "constant", "name": "p", "text": "1"}
BENCHMARK = {"kind": "synthetic", "name": "b", "seed": 1}


def test_the_configuration_of_the_docs_is_one() -> None:
    text = PAGE.read_text("utf-8").partition("```yaml\n")[2].partition("```")[0]
    found = build_evaluation(yaml.safe_load(text))
    assert [policy.name for policy in found.policies] == ["base", "trained"]
    assert len(found.benchmarks) == 9
    assert found.judge is not None
    assert found.policies[0].sampling.max_tokens == 16384
    assert {found.samples_of(benchmark) for benchmark in found.benchmarks} == {4, 8}


def test_a_policy_s_own_sampling_comes_before_that_of_all() -> None:
    own = {**POLICY, "name": "q", "sampling": {"temperature": 0.0}}
    shared = {"temperature": 0.7, "max_tokens": 9}
    found = build_evaluation({"out": "o", "sampling": shared, "policies": [POLICY, own], "benchmarks": [BENCHMARK]})
    assert [policy.sampling.temperature for policy in found.policies] == [0.7, 0.0]
    assert [policy.sampling.max_tokens for policy in found.policies] == [9, 9]


def test_a_name_stands_once_and_the_folder_may_be_given(tmp_path: Path) -> None:
    both = {"out": "o", "policies": [POLICY, POLICY], "benchmarks": [BENCHMARK]}
    with pytest.raises(EvaluationError, match="the name 'p' stands twice"):
        build_evaluation(both)
    found = build_evaluation({"policies": [POLICY], "benchmarks": [BENCHMARK]}, tmp_path)
    assert found.out == tmp_path
    assert build_evaluation(found, tmp_path / "other").out == tmp_path / "other"


@pytest.mark.parametrize("value", ["012", "1:30", "on", "0x10", "1_000", ".5", "~", "2026-01-01"])
def test_a_value_that_readers_of_yaml_differ_on_is_refused_with_its_line(value: str, tmp_path: Path) -> None:
    path = tmp_path / "c.yaml"
    path.write_text(f"out: o\nsamples: {value}\n")
    with pytest.raises(EvaluationError, match=r"c\.yaml, line 2: .* a value that readers of YAML differ on") as raised:
        build_evaluation(path)
    assert repr(value) not in str(raised.value)


def test_an_error_names_file_and_place(tmp_path: Path) -> None:
    path = tmp_path / "c.yaml"
    benchmark = {**BENCHMARK, "recipe": "puley"}
    path.write_text(yaml.safe_dump({"out": "o", "policies": [POLICY], "benchmarks": [BENCHMARK, benchmark]}))
    with pytest.raises(EvaluationError, match=r"c\.yaml: benchmarks\[1\]\.recipe: .*did you mean: pulley"):
        build_evaluation(path)
    path.write_text("out: o\npolicies: [{kind: constant, name: p}]\nbenchmarks: [{kind: synthetic, name: b, seed: 1}]")
    with pytest.raises(PolicyError, match=r"c\.yaml: policies\[0\]\.text: is missing"):
        build_evaluation(path)
