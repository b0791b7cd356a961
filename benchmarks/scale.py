"""Memory against the number of items: python benchmarks/scale.py [largest power of ten] [items of the real maker].

For 10³ items, 10⁴ and so on (by default up to 10⁵; each needs some milliseconds of the CPU): the most memory that
generate, verify, show and grade take, with a fake maker and two workers. Then the pass over variants and duplicates
alone, for 10⁴ items up to 10⁷. Then the CPU time of one and of two workers for so many items of the real maker, by
default 200.
"""

import json
import os
import subprocess
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from items import adopt_orphans, children

from sim2reason.datasets.dataset import Dataset
from sim2reason.datasets.distinct import Marks, doubles
from sim2reason.datasets.plan import DISTANCE

SUPPORT = Path(__file__).resolve().parent.parent / "tests" / "support"
CODE = "from sim2reason.cli import main; main()"
MARKED = 2000  # items whose marks are read at once
PROBLEMS, NUMBERS = 2000, 6  # that three in ten of them are variants of, and the numbers of each


def peak(*arguments: object) -> tuple[float, float]:
    """MB that a command's own process takes at most, and seconds."""
    begin = time.monotonic()
    paths = os.pathsep.join([str(SUPPORT), os.environ.get("PYTHONPATH", "")])
    run = subprocess.Popen(
        [sys.executable, "-c", CODE, *map(str, arguments)],
        env=os.environ | {"PYTHONPATH": paths},
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    _, status, used = os.wait4(run.pid, 0)
    run.returncode = os.waitstatus_to_exitcode(status)
    assert run.returncode == 0, arguments
    return used.ru_maxrss / (1024.0 if sys.platform == "linux" else 1024.0**2), time.monotonic() - begin


def commands(items: int, folder: Path) -> None:
    out, responses = folder / str(items), folder / f"{items}.jsonl"
    fake = ["--recipe", "incline,pulley", "--difficulty", "easy", "--maker", "fake_makers:steady", "--workers", 2]
    told = {"generate": peak("generate", out, "--items", items, *fake)}
    with responses.open("w") as file:
        file.writelines(json.dumps({"id": item.id, "response": "\\boxed{1 N}"}) + "\n" for item in Dataset(out))
    told["verify"] = peak("verify", out)
    told["show"] = peak("show", out, "-n", 5)
    told["grade"] = peak("grade", out, "--responses", responses)
    line = ", ".join(f"{name} {memory:.0f} MB in {seconds:.0f} s" for name, (memory, seconds) in told.items())
    print(f"{items:9} items: {line}", flush=True)


def marks(number: int, items: int) -> Marks:
    """Marks as of random items: one in twenty says what another says, three in ten are variants of few problems."""
    rng = np.random.default_rng(number)
    positions = np.arange(number * MARKED, min((number + 1) * MARKED, items), dtype=np.uint64)
    size = len(positions)
    words, asked = rng.integers(0, 2**63, size, dtype=np.uint64), rng.integers(0, 2**63, size, dtype=np.uint64)
    words = np.where(rng.random(size) < 0.05, words % np.uint64(10**5), words)
    few = rng.random(size) < 0.3
    problems = np.where(few, rng.integers(0, PROBLEMS, size), rng.integers(2**40, 2**63, size)).astype(np.uint64)
    counts = np.full(size, NUMBERS, dtype=np.uint64)
    sizes = np.round(rng.uniform(0.5, 10.0, (size, NUMBERS)), 2)
    sizes[:, 0] = 9.8
    return Marks(np.column_stack([positions, problems, counts, words, asked]), np.log(sizes).astype(np.float32).ravel())


def distinct(items: int) -> None:
    """The pass itself, in a process of its own."""
    begin, gone = time.process_time(), [0, 0]
    for _, found in doubles(lambda number: marks(number, items), -(-items // MARKED), items, DISTANCE):
        for each in found:
            gone[each.alike] += 1
    print(f"{gone[0]} the same, {gone[1]} alike; {time.process_time() - begin:.0f} CPU-s")


def distinct_peak(items: int) -> None:
    run = subprocess.Popen([sys.executable, __file__, "distinct", str(items)], stdout=subprocess.PIPE, text=True)
    told = run.stdout.read().strip() if run.stdout is not None else ""
    _, status, used = os.wait4(run.pid, 0)
    run.returncode = os.waitstatus_to_exitcode(status)
    print(f"{items:9} items: variants and duplicates {used.ru_maxrss / 1024:.0f} MB ({told})", flush=True)


def workers(items: int) -> None:
    """CPU seconds of a real dataset by one worker and by two, starting and writing included."""
    spent: list[float] = []
    for count in (1, 2):
        with TemporaryDirectory() as folder:
            before = children()
            options = ["--items", items, "--seed", 5, "--workers", count]
            subprocess.run(
                [sys.executable, "-c", CODE, "generate", str(Path(folder) / "set"), *map(str, options)],
                check=True,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
            )
            spent.append(children() - before)
    print(f"{items} real items: {spent[0]:.1f} CPU-s by one worker, {spent[1]:.1f} by two: {spent[1] / spent[0]:.3f}")


def main(arguments: Sequence[str]) -> None:
    if arguments[:1] == ["distinct"]:
        distinct(int(arguments[1]))
        return
    largest, real = (*map(int, arguments), *(5, 200)[len(arguments) :])
    adopt_orphans()
    with TemporaryDirectory() as folder:
        for power in range(3, largest + 1):
            commands(10**power, Path(folder))
    for power in range(4, 8):
        distinct_peak(10**power)
    workers(real)


if __name__ == "__main__":
    main(sys.argv[1:])
