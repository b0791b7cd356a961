"""Tests of the commands `train` and `sample-solutions` on valid and invalid files."""

import json
import os
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from short_run import settings
from sim2reason.cli import main
from sim2reason.datasets.generate import generate

NEEDED = "torch", "transformers", "accelerate", "datasets", "trl"
installed = pytest.mark.skipif(not all(map(find_spec, NEEDED)), reason="needs the libraries of the extra [train]")


def run(*args: object) -> Result:
    return CliRunner().invoke(main, [*map(str, args)])


@pytest.fixture
def config(tmp_path: Path) -> Path:
    rows = ({"prompt": f"How much is {n} and {n}? ", "completion": str(2 * n)} for n in range(10, 26))
    (tmp_path / "rows.jsonl").write_text("".join(f"{json.dumps(row)}\n" for row in rows))
    path = tmp_path / "config.yaml"
    path.write_text(f"""
out: {tmp_path / "run"}
model: {{kind: scratch, layers: 1, width: 16, heads: 1, vocabulary: 280, context: 64}}
corpora: [{{kind: jsonl, file: {tmp_path / "rows.jsonl"}}}]
steps: 3
batch: 4
log_every: 1
device: cpu
""")
    return path


@installed
def test_it_prints_a_table_and_says_where_the_model_is(config: Path, tmp_path: Path) -> None:
    found = run("train", "sft", config)
    assert found.exit_code == 0, found.output
    assert found.stderr == ""
    assert "last loss" in found.stdout
    assert found.stdout.endswith(f"The model: {tmp_path / 'run' / 'model'}\n")
    again = run("train", "sft", config, "--json")
    assert json.loads(again.stdout)["steps"] == 3
    other = run("train", "sft", config, "-o", tmp_path / "other")
    assert other.exit_code == 0
    assert (tmp_path / "other/model/model.safetensors").is_file()


@installed
def test_what_needs_no_gpu_can_be_done_before(config: Path, tmp_path: Path) -> None:
    found = run("train", "sft", config, "--until", "data")
    assert found.exit_code == 0, found.output
    assert found.stdout == f"Prepared until data: {tmp_path / 'run'}; the same command without --until goes on\n"
    assert not (tmp_path / "run" / "model").exists()
    assert run("train", "sft", config, "--until", "warm-start").exit_code == 2
    out = tmp_path / "rl"
    (tmp_path / "rl.yaml").write_text(json.dumps(settings(out)))
    found = run("train", "rl", tmp_path / "rl.yaml", "--until", "warm-start")
    assert found.exit_code == 0, found.output
    assert "Prepared until warm-start" in found.stdout
    assert (out / "warm-start" / "model").is_dir()
    assert not (out / "train").exists()
    assert run("train", "rl", tmp_path / "rl.yaml").exit_code == 0


@installed
def test_two_processes_learn_what_one_does_and_one_of_them_speaks(config: Path, tmp_path: Path) -> None:
    command = [sys.executable, "-m", "torch.distributed.run", "--standalone", "--nproc_per_node", "2"]
    args = ["-m", "sim2reason", "train", "sft", str(config), "--json"]
    env = {**os.environ, "OMP_NUM_THREADS": "1"}
    done = subprocess.run([*command, *args], capture_output=True, text=True, check=False, env=env, timeout=300)
    assert done.returncode == 0, done.stderr
    two = json.loads(done.stdout)
    one = json.loads(run("train", "sft", config, "-o", tmp_path / "alone", "--json").stdout)
    assert two["loss"] == pytest.approx(one["loss"], rel=0.01)
    assert {**two, "loss": 0} == {**one, "loss": 0}


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("out: a", "model: is missing"),
        ("- a", "holds no settings"),
        ("out: a\nmodel: {kind: scratch}\ncorpora: [{kind: jsonl, file: none}]\nsteps: x", "steps: "),
        (
            "out: a\nmodel: {kind: scratch, layers: -1}\ncorpora: [{kind: jsonl, file: none}]\nsteps: 1",
            "model.layers: ",
        ),
        ("out: a\nmodel: {kind: scratch}\ncorpora: [{kind: worked}]\nsteps: 1", "corpora[0].all of it: give either"),
        ("x: " + "[" * 5000, "this is not YAML"),
    ],
)
def test_a_wrong_configuration_is_one_line_that_names_the_place(tmp_path: Path, text: str, message: str) -> None:
    path = tmp_path / "config.yaml"
    path.write_text(text)
    found = run("train", "sft", path)
    assert found.exit_code == 2, found.output
    assert message in found.stderr
    assert "config.yaml" in found.stderr
    assert found.stderr.count("\n") == 1
    assert not Path("a").exists()


def test_a_missing_file_and_a_missing_method(tmp_path: Path) -> None:
    for args in (("train", "sft", tmp_path / "none.yaml"), ("train", "dpo"), ("train",)):
        found = run(*args)
        assert found.exit_code == 2
        assert found.stderr.count("\n") == 1 or args == ("train",)


def test_without_the_extra_it_is_one_line(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in NEEDED:
        monkeypatch.setitem(sys.modules, name, None)
    path = tmp_path / "config.yaml"
    path.write_text(json.dumps(settings(tmp_path / "run")))
    found = run("train", "rl", path)
    assert found.exit_code == 2, found.output
    assert "transformers is not installed; install it with: pip install 'accelerate>=" in found.stderr
    assert found.stderr.count("\n") == 1


def test_subcommands_show_an_example() -> None:
    found = run("train", "sft", "--help")
    assert found.exit_code == 0
    assert "      steps: 1000\n" in found.stdout
    assert "sim2reason train sft" in found.stdout.partition("Example:")[2]


def test_solutions_are_sampled_told_and_gone_on_with(tmp_path: Path) -> None:
    data = generate(tmp_path / "problems", items=6, recipe="pulley", maker="fake_makers:steady", workers=1)
    answer = next(iter(data)).answer.value
    (tmp_path / "policy.yaml").write_text(f"{{kind: constant, name: one, text: '\\boxed{{{answer!r}}}'}}")
    args = ("sample-solutions", data.path, "--policy", tmp_path / "policy.yaml", "-o", tmp_path / "out")
    found = run(*args, "--k", 2)
    assert found.exit_code == 0, found.output
    assert "of 6 problems" in found.stdout
    result = json.loads(run(*args, "--k", 3, "--keep", 1, "--json").stdout)
    assert result["kept"] == result["left_out"]["duplicate"] / 2 >= 1
    assert result["tries"] == 3
    for extra in (("--k", 0), ("--keep", 0), ("--split", "dev"), ("--seed", 1)):
        refused = run(*args, *extra)
        assert refused.exit_code == 2
        assert refused.stderr.count("\n") == 1
