"""Tests of work in several processes: messages of the first are passed on, and no failure leaves one waiting."""

import os
import signal
from collections.abc import Callable
from multiprocessing import Pipe
from multiprocessing.connection import Connection, wait
from pathlib import Path

import pytest

from sim2reason.errors import TrainingError
from sim2reason.training import processes
from sim2reason.training.processes import is_launched, run_in_processes

pytest.importorskip("torch")
pytestmark = pytest.mark.filterwarnings("ignore")
Begun, Advance = Callable[[str, int], object], Callable[[int], object]


def count(folder: Path, begun: Begun, advance: Advance) -> None:
    assert is_launched()
    begun("counting", 2)
    (folder / os.environ["RANK"]).write_text(os.environ["WORLD_SIZE"])
    advance(2)


def fail(ranks: str, begun: Begun, advance: Advance) -> None:
    """Raise an error in the named ranks, and wait forever in the others."""
    begun("failing", 1)
    advance(0)
    if os.environ["RANK"] in ranks:
        raise TrainingError("nothing to learn from")
    signal.pause()


def vanish(rank: str, begun: Begun, advance: Advance) -> None:
    begun("vanishing", 1)
    advance(0)
    if os.environ["RANK"] == rank:
        os.kill(os.getpid(), signal.SIGKILL)
    signal.pause()


def heard() -> tuple[list[object], Begun, Advance]:
    said: list[object] = []
    return said, lambda phase, steps: said.append((phase, steps)), said.append


def test_each_process_works_and_the_first_is_heard(tmp_path: Path) -> None:
    said, begun, advance = heard()
    run_in_processes(3, count, tmp_path, begun, advance)
    assert said == [("counting", 2), 2]
    assert {path.name: path.read_text() for path in tmp_path.iterdir()} == dict.fromkeys("012", "3")
    assert not is_launched()


@pytest.mark.parametrize("ranks", ["0", "01"])
def test_an_error_of_the_first_is_raised_here(ranks: str) -> None:
    said, begun, advance = heard()
    with pytest.raises(TrainingError, match="nothing to learn from"):
        run_in_processes(2, fail, ranks, begun, advance)
    assert ("failing", 1) in said


def test_an_error_of_another_ends_all() -> None:
    with pytest.raises(TrainingError, match="a process of the run ended with code 2"):
        run_in_processes(2, fail, "1", *heard()[1:])


@pytest.mark.parametrize("rank", ["0", "1"])
def test_a_process_that_is_killed_ends_all(rank: str) -> None:
    with pytest.raises(TrainingError, match="ended with code -9"):
        run_in_processes(2, vanish, rank, *heard()[1:])


class Seen:
    """Process with a given exit code at each poll, and a sentinel that is ready if the last one is set."""

    def __init__(self, *codes: int | None) -> None:
        self.codes = [*codes]
        self.sentinel, self.other = Pipe(duplex=False)
        if codes[-1] is not None:
            self.other.close()

    @property
    def exitcode(self) -> int | None:
        return self.codes.pop(0) if len(self.codes) > 1 else self.codes[0]

    def is_alive(self) -> bool:
        return self.exitcode is None


def test_a_process_that_ends_between_two_looks_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    def impatient(among: list[Connection]) -> list[object]:
        return wait(among, timeout=5) or pytest.fail("waits for what has ended")

    monkeypatch.setattr(processes, "wait", impatient)
    said, silent = Pipe(duplex=False)
    assert processes._followed(said, [Seen(None), Seen(None, -9)], *heard()[1:]) is None
    silent.close()
