"""Tests of the command `eval` on valid and invalid configurations."""

import json
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner, Result

from faulty_endpoint import Said, answer, serving
from sim2reason.cli import main


def run(*args: object) -> Result:
    return CliRunner().invoke(main, ["eval", *map(str, args)])


def config(tmp_path: Path, url: str, **settings: object) -> Path:
    rows = [{"question": f"How much is {n}?", "answer": n} for n in range(1, 4)]
    (tmp_path / "numbers.json").write_text(json.dumps(rows))
    held = {
        "out": str(tmp_path / "run"),
        "policies": [{"kind": "endpoint", "name": "p", "url": url, "model": "m", "attempts": 1}],
        "benchmarks": [{"kind": "jsonl", "name": "numbers", "file": str(tmp_path / "numbers.json")}],
    }
    path = tmp_path / "config.yaml"
    path.write_text(json.dumps({**held, **settings}))
    return path


def test_a_run_prints_a_table_and_goes_on_with_the_same_command(tmp_path: Path) -> None:
    with serving(lambda *_: Said(answer(r"\boxed{1}"))) as server:
        path = config(tmp_path, server.url)
        first = run(path)
        assert first.exit_code == 0, first.stderr
        assert "33.3 [" in first.stdout
        again = run(path, "--json")
        assert json.loads(again.stdout)["results"][0]["responses"] == 3
        assert len(server.requests) == 3
        other = run(path, "-o", tmp_path / "elsewhere")
        assert other.exit_code == 0
        assert len(server.requests) == 6
    compared = run("compare", tmp_path / "run", tmp_path / "elsewhere")
    assert compared.exit_code == 0, compared.stderr
    assert "numbers" in compared.stdout
    assert json.loads(run("compare", tmp_path / "run", tmp_path / "elsewhere", "--json").stdout)[0]["items"] == 3


def test_open_samples_end_with_one_and_a_refusal_with_two(tmp_path: Path) -> None:
    with serving(lambda n, *_: Said(answer("1")) if n else Said(b"<html>")) as server:
        found = run(config(tmp_path, server.url))
        assert found.exit_code == 1
        assert "1 samples got no answer" in found.stderr
        before = (tmp_path / "run/report/report.json").read_bytes()
        other = run(config(tmp_path, server.url, seed=1))
        assert other.exit_code == 2
        assert "another configuration" in other.stderr
        assert (tmp_path / "run/report/report.json").read_bytes() == before
    with serving(lambda *_: Said(answer("1"))) as server:  # it came back elsewhere
        assert run(config(tmp_path, server.url)).exit_code == 0
        assert len(server.requests) == 1
    with serving(lambda *_: Said({"error": "no"}, 401)) as server:
        found = run(config(tmp_path, server.url, out=str(tmp_path / "other")))
        assert found.exit_code == 2
        assert "status 401" in found.stderr
        assert found.stderr.count("\n") == 1


@pytest.mark.parametrize(
    "settings",
    [
        {"benchmarks": [{"kind": "jsonl", "name": "numbers", "file": "none.json"}]},
        {"policies": [{"kind": "endpoint", "name": "p", "url": "http://a", "model": "m", "key_from": "NO_SUCH_KEY"}]},
    ],
)
def test_a_run_that_cannot_begin_leaves_no_folder(tmp_path: Path, settings: dict[str, Any]) -> None:
    found = run(config(tmp_path, "http://127.0.0.1:9/v1", out=str(tmp_path / "runs/first"), **settings))
    assert found.exit_code == 2, found.output
    assert found.stderr.count("\n") == 1
    assert not (tmp_path / "runs").exists()


def test_a_run_without_an_answer_is_replaced(tmp_path: Path) -> None:
    with serving(lambda *_: Said({"error": "no such model"}, 404)) as server:
        assert run(config(tmp_path, server.url)).exit_code == 2
    with serving(lambda *_: Said(answer(r"\boxed{1}"))) as server:
        policy = {"kind": "endpoint", "name": "p", "url": server.url, "model": "other"}
        assert run(config(tmp_path, server.url, policies=[policy], seed=1)).exit_code == 0


@pytest.mark.parametrize("items", [1, 7, 12])
def test_nobody_there_ends_with_two_however_few_the_samples_are(tmp_path: Path, items: int) -> None:
    path = config(tmp_path, "http://127.0.0.1:9/v1")
    (tmp_path / "numbers.json").write_text(json.dumps([{"question": f"{n}?", "answer": n} for n in range(items)]))
    found = run(path)
    assert found.exit_code == 2, found.output
    assert "no connection" in found.stderr
    assert found.stderr.count("\n") == 1


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("out: a", "policies: is missing"),
        ("out: a\npolicies: 3", "policies"),
        ("- a", "holds no settings"),
        ("a: [", "line 1: this is not YAML"),
        ("out: a\nout: b", "'out' stands twice"),
        ("out: &x [a]\nseed: *x", "an alias"),
        ("out: a\nseed: -1\npolicies: []\nbenchmarks: []", "seed"),
        (
            "out: a\npolicies: [{kind: endpoint, name: ../up, url: http://a, model: m}]\nbenchmarks: [{}]",
            "policies[0].name",
        ),
        (
            "out: a\npolicies: [{kind: endpoint, name: p, url: http://a, model: m, api_key: sk-1}]\nbenchmarks: [{}]",
            "api_key",
        ),
        ("out: a\npolicies: [{kind: endpont}]\nbenchmarks: [{}]", "did you mean: endpoint"),
        (
            "out: a\npolicies: [{kind: endpoint, name: p, url: http://a, model: m}]\nbenchmarks: [{}]",
            "benchmarks[0].kind",
        ),
        ("\x00", "this is not YAML"),
        ("x: " + "[" * 5000, "this is not YAML"),
    ],
)
def test_a_wrong_configuration_is_one_line_that_names_the_place(tmp_path: Path, text: str, message: str) -> None:
    path = tmp_path / "config.yaml"
    path.write_text(text)
    found = run(path)
    assert found.exit_code == 2, found.output
    assert message in found.stderr
    assert found.stderr.count("\n") == 1
    assert "sk-1" not in found.stderr
    assert not (tmp_path / "a").exists()


def test_a_missing_file_and_missing_runs(tmp_path: Path) -> None:
    for args in ((tmp_path / "none.yaml",), ("compare", tmp_path, tmp_path), ("correlate", tmp_path)):
        found = run(*args)
        assert found.exit_code == 2
        assert found.stderr.count("\n") == 1


@pytest.mark.parametrize("name", ["compare", "correlate"])
def test_subcommands_show_an_example(name: str) -> None:
    found = run(name, "--help")
    assert found.exit_code == 0
    assert f"sim2reason eval {name}" in found.stdout.partition("Example:")[2]


def test_the_solvable_filter_keeps_what_is_solved_sometimes(tmp_path: Path) -> None:
    from sim2reason.datasets.generate import generate

    made = generate(tmp_path / "d", items=4, recipe="pulley", maker="fake_makers:steady", workers=1)
    values = {item.prompt: item.answer.value for item in made}
    seen: dict[str, int] = {}

    def sometimes(_: int, fields: dict[str, Any], __: str) -> Said:
        prompt = fields["messages"][-1]["content"]
        seen[prompt] = seen.get(prompt, 0) + 1
        return Said(answer(rf"\boxed{{{values[prompt] if seen[prompt] == 1 else -1.0!r}}}"))

    with serving(sometimes) as server:
        path = tmp_path / "policy.yaml"
        path.write_text(f"kind: endpoint\nname: p\nurl: {server.url}\nmodel: m\nrequests_in_flight: 1\n")
        args = "solvable", tmp_path / "d", "--policy", path, "--k", "2", "-o", tmp_path / "out"
        found = run(*args)
        assert found.exit_code == 0, found.stderr
        assert "4 of 4 problems kept" in found.stdout
        assert json.loads(run(*args, "--json").stdout)["rates"] == {"0": 0, "1": 4, "2": 0}
        wrong = run(*args, "--between", "half")
        assert wrong.exit_code == 2
        assert "write LOW,HIGH" in wrong.stderr


@pytest.mark.usefixtures("heed_interrupts")
def test_an_interrupted_run_ends_at_once_and_goes_on_later(tmp_path: Path) -> None:
    end = threading.Event()

    def first_only(number: int, *_: object) -> Said:
        if number:
            end.wait(60.0)
        return Said(answer(r"\boxed{1}"))

    with serving(first_only) as server:
        path = config(tmp_path, server.url)
        command = [sys.executable, "-m", "sim2reason", "eval", str(path)]
        with subprocess.Popen(command, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True) as process:
            journal = tmp_path / "run/samples/p/numbers.jsonl"
            until = time.monotonic() + 60.0
            while not (journal.is_file() and journal.stat().st_size) and time.monotonic() < until:
                time.sleep(0.01)
            process.send_signal(signal.SIGINT)
            assert process.wait(30.0) == 130
            assert process.stderr is not None
            assert "give the same command again to go on" in process.stderr.read()
        end.set()
        assert run(path).exit_code == 0
        assert len(journal.read_text("utf-8").splitlines()) == 3
