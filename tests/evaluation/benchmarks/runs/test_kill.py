"""Tests of a run killed twice against a faulty server: no request repeated, none lost, no key written."""

import json
import os
import subprocess
import sys
import time
from collections.abc import Generator
from pathlib import Path

import pytest

import faulty_endpoint
from faulty_endpoint import KEY

ITEMS, SAMPLES = 50, 4
RUN = """
import sys, time
from sim2reason.cli import main
sleep = time.sleep
time.sleep = lambda seconds: sleep(seconds / 1000.0)
main(["eval", *sys.argv[1:]])
"""


@pytest.fixture
def server(tmp_path: Path) -> Generator[tuple[str, Path]]:
    log = tmp_path / "answered.jsonl"
    log.touch()
    command = [sys.executable, faulty_endpoint.__file__, str(log)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        yield process.stdout.readline().strip(), log
        process.kill()


def config(tmp_path: Path, url: str) -> Path:
    rows = [{"question": f"Problem {n}: how much?", "answer": "9.81", "unit": "N", "id": f"p{n}"} for n in range(ITEMS)]
    (tmp_path / "problems.json").write_text(json.dumps(rows))
    policy = {"kind": "endpoint", "name": "faulty", "url": url, "model": "m", "key_from": "TEST_ENDPOINT_KEY"}
    benchmark = {"kind": "jsonl", "name": "mine", "file": str(tmp_path / "problems.json")}
    settings = {"out": str(tmp_path / "run"), "samples": SAMPLES, "policies": [policy], "benchmarks": [benchmark]}
    path = tmp_path / "config.yaml"
    path.write_text(json.dumps(settings))  # JSON is YAML
    return path


def lines(path: Path) -> int:
    return path.read_bytes().count(b"\n") if path.is_file() else 0


@pytest.mark.slow
def test_two_kills_lose_nothing_and_ask_nothing_twice(server: tuple[str, Path], tmp_path: Path) -> None:
    url, log = server
    journal = tmp_path / "run/samples/faulty/mine.jsonl"
    command = [sys.executable, "-c", RUN, str(config(tmp_path, url))]
    environ = os.environ | {"TEST_ENDPOINT_KEY": KEY}
    finished: set[tuple[str, int]] = set()
    said = b""
    for wanted in (60, 130):
        with subprocess.Popen(command, env=environ, stdout=subprocess.PIPE, stderr=subprocess.STDOUT) as process:
            assert process.stdout is not None
            end = time.monotonic() + 120.0
            while lines(journal) < wanted and process.poll() is None and time.monotonic() < end:
                time.sleep(0.005)
            process.kill()
            said += process.stdout.read()
        held = journal.read_bytes()
        whole = [json.loads(line) for line in held[: held.rfind(b"\n") + 1].splitlines()]
        assert wanted <= len(whole) < ITEMS * SAMPLES, said.decode()
        before = lines(log)
        assert finished <= {(found["id"], found["sample"]) for found in whole}
        finished |= {(found["id"], found["sample"]) for found in whole}
    seeds = {(found["id"], found["sample"]): found["seed"] for found in whole}
    last = subprocess.run(command, env=environ, capture_output=True, check=False)
    assert last.returncode == 0, last.stderr
    found = [json.loads(line) for line in journal.read_text("utf-8").splitlines()]
    assert len(found) == len({(one["id"], one["sample"]) for one in found}) == ITEMS * SAMPLES
    asked = [tuple(json.loads(line)) for line in log.read_text("utf-8").splitlines()]
    later = {(prompt.split(":")[0].replace("Problem ", "p"), seed) for prompt, seed in asked[before:]}
    assert not later & {(name, seeds[name, sample]) for name, sample in finished}, "asked again what was finished"
    for path in [file for file in (tmp_path / "run").rglob("*") if file.is_file()]:
        assert KEY.encode() not in path.read_bytes(), path
    assert KEY.encode() not in said + last.stdout + last.stderr
    report = json.loads((tmp_path / "run/report/report.json").read_text("utf-8"))
    (result,) = report["results"]
    assert (result["responses"], result["missing"], result["items"]) == (ITEMS * SAMPLES, 0, ITEMS)
    assert {ending for ending, count in result["endings"].items() if count} == {
        *("correct", "wrong", "truncated", "empty", "refused", "unreadable"),
    }
