"""Tests of a run after SIGKILL: it can resume to the same bytes, and leaves no process."""

import os
import random
import signal
import subprocess
import sys
import time
import uuid
from collections.abc import Callable
from pathlib import Path

import pytest

from sim2reason.datasets.manifest import MANIFEST

SUPPORT = Path(__file__).parents[1] / "support"
PATHS = os.pathsep.join((str(SUPPORT), os.environ.get("PYTHONPATH", "")))
pytestmark = pytest.mark.skipif(not Path("/proc/self/environ").exists(), reason="looks processes up in /proc")


def start(out: Path, maker: str, workers: int, mark: str, items: int = 1000) -> "subprocess.Popen[bytes]":
    options = ["--items", str(items), "--recipe", "incline,pulley", "--shard-size", "20", "--workers", str(workers)]
    code = "from sim2reason.cli import main; main()"
    return subprocess.Popen(
        [sys.executable, "-c", code, "generate", str(out), *options, "--maker", f"fake_makers:{maker}"],
        env=os.environ | {"PYTHONPATH": PATHS, "MARK": mark},
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        start_new_session=True,
    )


def shards(out: Path) -> int:
    return len(list(out.glob("data/*.parquet")))


def finish(out: Path, mark: str, items: int) -> int:
    run = start(out, "slow", 2, mark, items)
    run.communicate(timeout=60)
    return run.returncode


def alive(mark: str) -> list[int]:
    """Return the ids of the processes with `mark` in their environment."""
    found: list[int] = []
    for path in Path("/proc").glob("[0-9]*/environ"):
        try:
            if f"MARK={mark}".encode() in path.read_bytes():
                found.append(int(path.parent.name))
        except OSError:  # gone, or not ours
            continue
    return found


def gone(mark: str, within: float = 20.0) -> bool:
    end = time.monotonic() + within
    while alive(mark) and time.monotonic() < end:
        time.sleep(0.05)
    return not alive(mark)


@pytest.mark.parametrize(("times", "items"), [(1, 400), pytest.param(10, 1000, marks=pytest.mark.slow)])
def test_killed_and_resumed_a_run_ends_in_the_same_bytes(
    tmp_path: Path, contents: Callable[[Path], dict[str, bytes]], times: int, items: int
) -> None:
    assert finish(tmp_path / "whole", "", items) == 0
    rng, mark, kills = random.Random(7), uuid.uuid4().hex, 0
    seen: set[int] = set()
    out = tmp_path / "killed"
    while kills < times:
        target, end = shards(out) + rng.choice((0, 1)), time.monotonic() + 30
        run = start(out, "slow", rng.choice((1, 2, 4)), mark, items)
        while shards(out) < target and time.monotonic() < end:
            time.sleep(0.002)
        time.sleep(rng.uniform(0.0, 0.08) if target else rng.uniform(0.0, 0.8))
        run.kill()
        run.communicate()
        assert run.returncode == -signal.SIGKILL, f"finished before {times} kills"
        kills += 1
        seen.add(shards(out))
        assert not (out / MANIFEST).exists()
    assert finish(out, mark, items) == 0
    assert times < 10 or len(seen) > 2, "the kills came too early to mean anything"
    assert contents(out) == contents(tmp_path / "whole")
    assert gone(mark)


@pytest.mark.parametrize("maker", ["slow", "hanging"])
def test_workers_die_with_a_killed_parent(tmp_path: Path, maker: str) -> None:
    mark = uuid.uuid4().hex
    run = start(tmp_path / "out", maker, 2, mark)
    end = time.monotonic() + 20
    while len(alive(mark)) < 4 and time.monotonic() < end:  # parent, tracker of resources, two workers
        time.sleep(0.02)
    time.sleep(0.3)
    run.kill()
    run.communicate()
    assert gone(mark)


@pytest.mark.usefixtures("heed_interrupts")
@pytest.mark.parametrize(
    ("send", "number"),
    [
        (os.kill, signal.SIGTERM),
        (os.killpg, signal.SIGINT),
        pytest.param(os.kill, signal.SIGINT, marks=pytest.mark.slow),
        pytest.param(os.killpg, signal.SIGTERM, marks=pytest.mark.slow),
    ],
    ids=["one by SIGTERM", "all by SIGINT", "one by SIGINT", "all by SIGTERM"],
)
def test_an_interrupt_says_how_to_go_on(
    tmp_path: Path, number: signal.Signals, send: Callable[[int, signal.Signals], None]
) -> None:
    mark = uuid.uuid4().hex
    run = start(tmp_path / "out", "hanging", 2, mark)
    end = time.monotonic() + 20
    while not list((tmp_path / "out").glob("data/*.parquet")) and time.monotonic() < end:
        time.sleep(0.02)
    send(run.pid, number)
    _, err = run.communicate(timeout=20)
    assert run.returncode == 130
    line = err.decode()
    assert line.count("\n") <= 2
    assert "interrupted; what is finished stays in" in line
    assert "give the same command again to go on" in line
    assert gone(mark)
