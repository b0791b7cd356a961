import os
import subprocess
import sys
import time
from pathlib import Path

import pytest

from sim2reason.datasets.places.here import run
from sim2reason.datasets.plan import Config
from sim2reason.datasets.worker import Batch, outcome

SUPPORT = Path(__file__).parents[2] / "support"
CONFIG = Config(items=40, recipes=("pulley",), difficulties=("easy",), maker="fake_makers:steady")


def batches(count: int, size: int = 4) -> list[Batch]:
    return [[(k, CONFIG.request(k)) for k in range(n * size, (n + 1) * size)] for n in range(count)]


@pytest.mark.parametrize("workers", [pytest.param(1, marks=pytest.mark.slow), 3])
def test_every_batch_comes_back_once(workers: int) -> None:
    waiting = batches(6)
    replies = run(lambda: waiting.pop() if waiting else None, "fake_makers:steady", workers, 60.0)
    done = sorted(outcome.position for _, reply in replies for outcome in reply if not isinstance(outcome, str))
    assert done == list(range(24))


def test_the_source_is_asked_again_after_a_reply() -> None:
    waiting = batches(1)
    seen = 0
    for batch, _ in run(lambda: waiting.pop() if waiting else None, "fake_makers:steady", 2, 60.0):
        seen += 1
        if seen < 3:
            waiting.append(batch)
    assert seen == 3


def test_a_crash_takes_only_its_own_batch() -> None:
    waiting = batches(6)
    replies = list(run(lambda: waiting.pop() if waiting else None, "fake_makers:crashing", 2, 60.0))
    lost = [batch for batch, reply in replies if isinstance(reply, str)]
    assert [[k for k, _ in batch] for batch in lost] == [[4, 5, 6, 7]]
    assert len(replies) == 6


def test_a_pause_of_the_caller_is_no_hang() -> None:
    waiting = batches(4)
    for _, reply in run(lambda: waiting.pop() if waiting else None, "fake_makers:steady", 2, 1.0):
        time.sleep(0.6)
        assert not isinstance(reply, str)


def test_to_start_may_take_longer_than_a_batch() -> None:
    waiting = batches(2)
    replies = [reply for _, reply in run(lambda: waiting.pop() if waiting else None, "slow_makers:steady", 1, 1.0)]
    assert [len(reply) for reply in replies if not isinstance(reply, str)] == [4, 4]


ORDER = "items=12, recipe='pulley', maker='fake_makers:steady'"


def ran(program: str, *arguments: str, folder: Path) -> "subprocess.CompletedProcess[str]":
    """Run a program from a file, or from standard input if the argument is a dash."""
    paths = os.pathsep.join([str(SUPPORT), os.environ.get("PYTHONPATH", "")])
    script = folder / "script.py"
    script.write_text(program)
    return subprocess.run(
        [sys.executable, *(arguments or [str(script)])],
        input=program,
        capture_output=True,
        text=True,
        check=False,
        cwd=folder,
        env=os.environ | {"PYTHONPATH": paths},
    )


FILE, INPUT = (), ("-",)


@pytest.mark.parametrize(
    ("workers", "how"),
    [
        (None, FILE),
        (3, INPUT),
        *(pytest.param(*case, marks=pytest.mark.slow) for case in ((1, FILE), (3, FILE), (None, INPUT), (1, INPUT))),
    ],
)
def test_a_plain_script_runs_once_with_any_number_of_workers(
    tmp_path: Path, workers: int | None, how: tuple[str, ...]
) -> None:
    """The script has no `__name__` guard, and it would catch an error."""
    program = (
        "import sim2reason\nprint('my own line')\n"
        f"try:\n    print(len(sim2reason.generate('out', {ORDER}, workers={workers})))\n"
        "except Exception:\n    print('failed')\n"
    )
    done = ran(program, *how, folder=tmp_path)
    assert (done.stdout, done.stderr, done.returncode) == ("my own line\n12\n", "", 0)


def test_other_processes_of_a_script_are_as_ever(tmp_path: Path) -> None:
    """Only this library's processes skip the main program."""
    program = (
        "import multiprocessing, sim2reason\n\ndef double(x):\n    return 2 * x\n\n"
        f"if __name__ == '__main__':\n    sim2reason.generate('out', {ORDER}, workers=2)\n"
        "    with multiprocessing.get_context('spawn').Pool(1) as pool:\n        print(pool.map(double, [21]))\n"
    )
    assert ran(program, folder=tmp_path).stdout == "[42]\n"


OWN = """
from sim2reason.generation.filters import FILTERS

@FILTERS.register("own")
def own(candidate):
    return ""
"""


def test_what_a_script_imports_is_known_to_workers(tmp_path: Path) -> None:
    (tmp_path / "own_members.py").write_text(OWN)
    (tmp_path / "own_maker.py").write_text(
        "from fake_makers import steady\nfrom sim2reason.generation.filters import FILTERS\n\n"
        "def make(request):\n    FILTERS['own']\n    return steady(request)\n"
    )
    order = ORDER.replace("fake_makers:steady", "own_maker:make")
    program = f"import own_members, sim2reason\nprint(len(sim2reason.generate('out', {order}, workers=2)))\n"
    assert ran(program, folder=tmp_path).stdout == "12\n"


def test_what_a_script_defines_itself_is_known_to_one_worker(tmp_path: Path) -> None:
    call = "import sim2reason\nprint(len(sim2reason.generate('out', {}, workers={})))\n"
    for workers in (None, 1):
        assert ran(OWN + call.format(ORDER, workers), folder=tmp_path).stdout == "12\n"
    done = ran(OWN + call.format(ORDER, 2), folder=tmp_path)
    told = "workers: 2 worker processes do not run your program, which defines own; move that to a module and import it"
    assert told in done.stderr.splitlines()[-1]


def test_an_outcome_tells_an_error_in_one_line() -> None:
    from fake_makers import raising

    assert outcome(raising, 7, CONFIG.request(7)).failure == "raised ValueError: a defect of two lines"
