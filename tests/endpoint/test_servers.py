"""Tests of evaluation against real OpenAI-compatible servers, each with a tiny model of random weights."""

import importlib.util
import json
import os
import signal
import subprocess
import sys
import time
import urllib.request
from collections.abc import Generator
from contextlib import suppress
from pathlib import Path

import pytest

from sim2reason.errors import PolicyError
from sim2reason.evaluation.policies import Policy, SampleRequest, build_policy
from sim2reason.evaluation.policies.journal import read_finished
from sim2reason.evaluation.reports.evaluation import evaluate

SERVERS = {"llama": ("xllamacpp", "gguf"), "vllm": ("vllm",)}  # with the modules that each needs
TARGETS = {"llama": "make test-endpoint", "vllm": "make test-vllm"}
KEY = "sk-local-5Zb8"
AUTHORIZED = {"Authorization": f"Bearer {KEY}"}
UP_WITHIN = 300.0  # s


def python(server: str) -> str:
    """Return the interpreter that can run a server, or an empty string if its modules are not installed."""
    own = sys.executable if all(map(importlib.util.find_spec, SERVERS[server])) else ""
    return os.environ.get(f"SIM2REASON_{server.upper()}_PYTHON", own)


@pytest.fixture(scope="module", params=SERVERS)
def url(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Generator[str]:
    server = str(request.param)
    if not python(server):
        pytest.skip(f"{SERVERS[server][0]} is not installed; {TARGETS[server]} runs these")
    folder = tmp_path_factory.mktemp(server)
    command = [python(server), str(Path(__file__).with_name(f"{server}_server.py")), str(folder), KEY]
    environ = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    with (folder / "log").open("w") as log:
        process = subprocess.Popen(
            command, stdout=subprocess.PIPE, stderr=log, text=True, env=environ, start_new_session=True
        )
    assert process.stdout is not None
    try:
        address = process.stdout.readline().strip()
        wait_for(address, process)
        yield address
    finally:
        with suppress(ProcessLookupError):  # it may have ended by itself
            os.killpg(process.pid, signal.SIGKILL)  # and what it has started
        process.wait()
        process.stdout.close()


def wait_for(address: str, process: "subprocess.Popen[str]") -> None:
    """Wait until the server answers."""
    end = time.monotonic() + UP_WITHIN
    while time.monotonic() < end and process.poll() is None:
        try:
            with urllib.request.urlopen(urllib.request.Request(f"{address}/models", headers=AUTHORIZED)):
                return
        except OSError:
            time.sleep(0.2)
    pytest.fail(f"{address} does not answer")


@pytest.fixture(autouse=True)
def key(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("LOCAL_KEY", KEY)


def settings(url: str, **more: object) -> dict[str, object]:
    held: dict[str, object] = {"kind": "endpoint", "name": "tiny", "url": url, "model": "tiny", "key_from": "LOCAL_KEY"}
    return {**held, "sampling": {"max_tokens": 12}, "requests_in_flight": 2, **more}


def policy(url: str, **more: object) -> Policy:
    return build_policy(settings(url, **more))


def test_a_seed_gives_the_same_answer_and_another_seed_another(url: str) -> None:
    tiny = policy(url)
    seeds = (1, 1, 2, 3)
    found = [tiny.complete([SampleRequest("a", 0, "How fast?", seed)])[0] for seed in seeds]
    assert found[0].text == found[1].text
    assert len({each.text for each in found}) > 1
    assert found[0].finish in {"length", "stop"}
    assert found[0].prompt_tokens == found[3].prompt_tokens
    assert 1 <= (found[0].completion_tokens or 0) <= 12


def test_a_prompt_beyond_the_context_and_a_wrong_key(url: str, monkeypatch: pytest.MonkeyPatch) -> None:
    assert policy(url).complete([SampleRequest("a", 0, "far " * 1000, 1)])[0].finish == "overflow"
    monkeypatch.setenv("LOCAL_KEY", "sk-wrong")
    with pytest.raises(PolicyError, match="status 401") as raised:
        policy(url).complete([SampleRequest("a", 0, "How fast?", 1)])
    assert "sk-wrong" not in str(raised.value)


def config(tmp_path: Path, url: str, out: str) -> dict[str, object]:
    rows = [{"question": f"How much is {n}?", "answer": n, "id": f"n{n}"} for n in range(1, 21)]
    (tmp_path / "numbers.json").write_text(json.dumps(rows))
    benchmark = {"kind": "jsonl", "name": "numbers", "file": str(tmp_path / "numbers.json")}
    return {"out": str(tmp_path / out), "samples": 4, "policies": [settings(url)], "benchmarks": [benchmark]}


def test_a_whole_evaluation_is_the_same_twice(url: str, tmp_path: Path) -> None:
    one, other = (evaluate(config(tmp_path, url, out)) for out in ("one", "other"))
    assert one.report.results[0].responses == 80
    assert one.report.results[0].tokens is not None
    texts = [
        {found.key: found.completion.text for found in read_finished(run.folder.samples("tiny", "numbers"))}
        for run in (one, other)
    ]
    same = sum(texts[0][key] == texts[1][key] for key in texts[0])
    assert same >= 72  # of 80: batches of two slots may round differently
    for path in [file for file in (tmp_path / "one").rglob("*") if file.is_file()]:
        assert KEY.encode() not in path.read_bytes()


def test_a_run_that_is_killed_goes_on(url: str, tmp_path: Path) -> None:
    path, journal = tmp_path / "config.yaml", tmp_path / "run/samples/tiny/numbers.jsonl"
    path.write_text(json.dumps(config(tmp_path, url, "run")))
    command = [sys.executable, "-m", "sim2reason", "eval", str(path)]
    with subprocess.Popen(command, stdout=subprocess.DEVNULL) as process:
        end = time.monotonic() + 120.0
        while len(list(read_finished(journal))) < 10 and process.poll() is None and time.monotonic() < end:
            time.sleep(0.005)
        process.kill()
    before = {found.key: found.completion for found in read_finished(journal)}
    assert before
    assert subprocess.run(command, stdout=subprocess.DEVNULL, check=False).returncode == 0
    after = {found.key: found.completion for found in read_finished(journal)}
    assert len(after) == 80
    assert before.items() <= after.items()
