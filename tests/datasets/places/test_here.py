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


@pytest.mark.parametrize("workers", [1, 3])
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


def test_a_script_without_a_guard_is_told_so(tmp_path: Path) -> None:
    script = tmp_path / "script.py"
    script.write_text(
        "from sim2reason.datasets.build import build\nfrom sim2reason.datasets.plan import Config\n"
        f"build({str(tmp_path / 'out')!r}, Config(items=1, recipes=('a',), maker='fake_makers:steady'), workers=1)\n"
    )
    result = subprocess.run([sys.executable, script], capture_output=True, text=True, check=False)
    assert result.returncode == 1
    assert "put the call under: if __name__ == '__main__'" in result.stderr.splitlines()[-1]


def test_a_program_on_standard_input_is_told_so_and_a_short_one_works(tmp_path: Path) -> None:
    program = f"import sim2reason; sim2reason.generate({str(tmp_path / 'out')!r}, items=1, maker='fake_makers:steady')"
    paths = os.pathsep.join([str(SUPPORT), os.environ.get("PYTHONPATH", "")])
    env = os.environ | {"PYTHONPATH": paths}
    result = subprocess.run([sys.executable, "-"], input=program, capture_output=True, text=True, check=False, env=env)
    last = result.stderr.splitlines()[-1]
    assert (result.returncode, result.stderr.count("Traceback")) == (1, 1)  # ours, and none of a worker
    assert "there is no such file; put it into one, or give it to python -c" in last
    assert subprocess.run([sys.executable, "-c", program], check=False, env=env).returncode == 0


def test_an_outcome_tells_an_error_in_one_line() -> None:
    from fake_makers import raising

    assert outcome(raising, 7, CONFIG.request(7)).failure == "raised ValueError: a defect of two lines"
