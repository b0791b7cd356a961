"""Memory against the number of items: python benchmarks/scale.py [largest power of ten] [items of the real maker].

For 10³ items, 10⁴ and so on (by default up to 10⁵; each needs some milliseconds of the CPU): the most memory that
generate, verify, show (a few, then all) and grade take, with a fake maker and two workers. Then the pass over variants
and duplicates alone, for 10⁴ items up to 10⁷. Then the CPU time of one and of two workers for so many items of the real
maker, by default 200. Exit code 1: something takes more than a bound below.
"""

import argparse
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
from sim2reason.datasets.duplicates import Marks, find_duplicates
from sim2reason.datasets.plan import DEFAULT_DISTANCE

SUPPORT = Path(__file__).resolve().parent.parent / "tests" / "support"
CODE = "from sim2reason.cli import main; main()"
MARKED = 2000  # items whose marks are read at once
GROWTH = 1.25  # the memory of a command for most items, as a ratio to that for fewest
MARK = 100e-6  # MB an item more that generate may take, while it looks for variants and duplicates
DISTINCT = 1024.0  # MB for the pass over variants and duplicates
MORE = 1.10  # CPU time of two workers, as a ratio to that of one
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


def commands(items: int, folder: Path) -> dict[str, float]:
    """MB that each command takes at most, but for the marks of so many items."""
    out, responses = folder / str(items), folder / f"{items}.jsonl"
    fake = ["--recipe", "incline,pulley", "--difficulty", "easy", "--maker", "fake_makers:steady", "--workers", 2]
    told = {"generate": peak("generate", out, "--items", items, *fake)}
    with responses.open("w") as file:
        file.writelines(json.dumps({"id": item.id, "response": "\\boxed{1 N}"}) + "\n" for item in Dataset(out))
    told["verify"] = peak("verify", out)
    told["show"], told["show all"] = peak("show", out, "-n", 5), peak("show", out, "-n", items)
    told["grade"] = peak("grade", out, "--responses", responses)
    line = ", ".join(f"{name} {memory:.0f} MB in {seconds:.0f} s" for name, (memory, seconds) in told.items())
    print(f"{items:9} items: {line}", flush=True)
    return {name: memory - MARK * items * (name == "generate") for name, (memory, _) in told.items()}


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
    for _, found in find_duplicates(lambda number: marks(number, items), -(-items // MARKED), items, DEFAULT_DISTANCE):
        for each in found:
            gone[each.alike] += 1
    print(f"{gone[0]} the same, {gone[1]} alike; {time.process_time() - begin:.0f} CPU-s")


def distinct_peak(items: int) -> float:
    run = subprocess.Popen([sys.executable, __file__, "distinct", str(items)], stdout=subprocess.PIPE, text=True)
    told = run.stdout.read().strip() if run.stdout is not None else ""
    _, status, used = os.wait4(run.pid, 0)
    run.returncode = os.waitstatus_to_exitcode(status)
    memory = used.ru_maxrss / (1024.0 if sys.platform == "linux" else 1024.0**2)
    print(f"{items:9} items: variants and duplicates {memory:.0f} MB ({told})", flush=True)
    return memory


def workers(items: int) -> float:
    """The ratio of CPU times of a real dataset by two workers and by one, starting and writing included."""
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
    return spent[1] / spent[0]


def main(arguments: Sequence[str]) -> int:
    if arguments[:1] == ["distinct"]:
        distinct(int(arguments[1]))
        return 0
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("largest", type=int, nargs="?", default=5, help="power of ten (default: 5)")
    parser.add_argument("real", type=int, nargs="?", default=200, help="items of the real maker (default: 200)")
    given = parser.parse_args(arguments)
    largest, real = given.largest, given.real
    adopt_orphans()
    with TemporaryDirectory() as folder:
        taken = [commands(10**power, Path(folder)) for power in range(3, largest + 1)]
    distinct_pass = max(distinct_peak(10**power) for power in range(4, 8))
    missed = [f"{name} grows with the items" for name, few in taken[0].items() if taken[-1][name] > GROWTH * few]
    missed += ["variants and duplicates take more than a GB"] * (distinct_pass > DISTINCT)
    missed += ["two workers take more than a tenth more than one"] * (workers(real) > MORE)
    for line in missed:
        print(f"MISSED: {line}")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
