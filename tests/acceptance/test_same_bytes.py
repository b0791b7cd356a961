"""Tests that the real maker gives byte-identical datasets with any number of workers, and after kills."""

import hashlib
import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

ITEMS, SHARD = 16, 2  # one of each recipe
FEW = 4  # items
KILLS = 3  # ten of a maker that is fast, in datasets/test_kill


def start(out: Path, workers: int, items: int = ITEMS) -> "subprocess.Popen[bytes]":
    options = ["--items", str(items), "--shard-size", str(SHARD), "--seed", "8", "--workers", str(workers)]
    code = "from sim2reason.cli import main; main()"
    if items == FEW:  # pictures cost more than all else, and have tests of their own
        code = f"import sim2reason.datasets.build as last; last.put_pictures = lambda *_: (); {code}"
    command = [sys.executable, "-c", code, "generate", str(out), "--recipe", "all", "--difficulty", "all", *options]
    return subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, env=os.environ)


def finish(out: Path, workers: int, items: int = ITEMS) -> None:
    run = start(out, workers, items)
    _, err = run.communicate(timeout=120)
    assert run.returncode == 0, err.decode()


def digest(folder: Path) -> str:
    """Return the SHA-256 over the names and bytes of all files."""
    found = hashlib.sha256()
    for path in sorted(path for path in folder.rglob("*") if path.is_file()):
        found.update(str(path.relative_to(folder)).encode() + b"\0" + path.read_bytes())
    return found.hexdigest()


def shards(out: Path) -> int:
    return len(list(out.glob("data/*.parquet")))


def killed(out: Path, rng: random.Random) -> None:
    """Start a run, wait for one more shard and a short random time, and kill it."""
    wanted, run, end = shards(out) + 1, start(out, rng.choice((1, 2))), time.monotonic() + 60
    while shards(out) < wanted and run.poll() is None and time.monotonic() < end:
        time.sleep(0.002)
    time.sleep(rng.uniform(0.0, 0.03))
    run.kill()
    run.communicate()
    assert run.returncode == -signal.SIGKILL, "it finished before it was killed"


def test_one_and_two_workers_give_one_digest(tmp_path: Path) -> None:
    for workers in (1, 2):
        finish(tmp_path / f"by{workers}", workers, FEW)
    assert digest(tmp_path / "by1") == digest(tmp_path / "by2")
    assert shards(tmp_path / "by1") == FEW // SHARD


@pytest.mark.slow
def test_one_two_and_four_workers_and_kills_give_one_digest(tmp_path: Path) -> None:
    """The run that is killed several times, with one or two workers, finishes with two."""
    for workers in (1, 4):
        finish(tmp_path / f"by{workers}", workers)
    rng = random.Random(5)
    for _ in range(KILLS):
        killed(tmp_path / "killed", rng)
    assert 0 < shards(tmp_path / "killed") <= ITEMS // SHARD
    finish(tmp_path / "killed", 2)
    digests = {path.name: digest(path) for path in sorted(tmp_path.iterdir())}
    assert len(set(digests.values())) == 1, digests
    assert shards(tmp_path / "killed") == ITEMS // SHARD
