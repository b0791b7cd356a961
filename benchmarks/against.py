"""Common parts of speed benchmarks: the machine's phase, medians over rounds, and alternation with an earlier commit.

Machines differ by a factor of two, and so do the minutes of one: only ratios of one run say anything.
"""

import argparse
import json
import os
import subprocess
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory
from time import process_time

ROOT = Path(__file__).parents[1]
ADDENDS = 300_000
PHASE = "fixed loop, ms"
Figures = dict[str, float]
"""Names and rates; the more the better, but for the phase."""
Order = tuple[Path, Sequence[str]]
"""A tree and what Python shall run with its package."""


def fixed_loop() -> float:
    """Milliseconds of CPU that a fixed loop takes: in which phase the machine is. The best of three."""
    times: list[float] = []
    for _ in range(3):
        start, total = process_time(), 0
        for number in range(ADDENDS):
            total += number * number
        times.append(1e3 * (process_time() - start))
    return min(times)


def medians(rounds: Sequence[Figures]) -> Figures:
    """Of each figure that all rounds have."""
    return {name: median(found[name] for found in rounds) for name in rounds[0] if all(name in r for r in rounds)}


def told(order: Order) -> str:
    """What Python prints with the package of a tree; a sentence and exit code 1 where that tree can't do it."""
    tree, command = order
    threads = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    done = subprocess.run(
        [sys.executable, *command],
        env=os.environ | threads | {"PYTHONPATH": str(tree / "src")},
        check=False,
        capture_output=True,
        text=True,
    )
    if done.returncode:
        sys.exit(f"{tree} can't be measured so: {done.stderr.strip().splitlines()[-1]}")
    return done.stdout.strip()


@contextmanager
def checked_out(commit: str) -> Iterator[Path]:
    """A tree of an earlier commit, for as long as the block runs."""
    with TemporaryDirectory() as folder:
        tree = Path(folder) / commit.replace("/", "-")
        subprocess.run(["git", "-C", ROOT, "worktree", "add", "--quiet", "--detach", tree, commit], check=True)
        try:
            yield tree
        finally:
            subprocess.run(["git", "-C", ROOT, "worktree", "remove", "--force", tree], check=True)


def compare(orders: Mapping[str, Order], rounds: int) -> None:
    """Run all orders alternately, each printing `Figures` as JSON, and print medians and ratios to the first."""
    found: dict[str, list[Figures]] = {name: [] for name in orders}
    for turn in range(rounds):
        for name, order in orders.items():
            figures: Figures = json.loads(told(order))
            found[name].append(figures)
            print(f"round {turn + 1}, {name}: " + ", ".join(f"{k} {v:,.4g}" for k, v in figures.items()), flush=True)
    first, *others = found
    for name in others:
        ratios = [
            {key: now[key] / before[key] for key in before.keys() & now.keys() - {PHASE}}
            for before, now in zip(found[first], found[name], strict=True)
        ]
        for key, ratio in sorted(medians(ratios).items()):
            spread = [each[key] for each in ratios]
            print(f"{name} / {first}, {key}: median ratio {ratio:.2f} ({min(spread):.2f} to {max(spread):.2f})")


def parser(description: str | None) -> argparse.ArgumentParser:
    """A parser with the options that speed benchmarks share."""
    found = argparse.ArgumentParser(description=(description or "").partition("\n")[0])
    found.add_argument("--against", metavar="COMMIT", help="measure an earlier commit too, turn about")
    found.add_argument("--rounds", type=int, default=3, help="how often; medians are given (default: 3)")
    found.add_argument("--figures", action="store_true", help=argparse.SUPPRESS)  # one round as JSON, for `compare`
    return found


def script_against(script: str, commit: str, rounds: int, *arguments: str) -> None:
    """Run one script, as it stands here, with both packages."""
    with checked_out(commit) as tree:
        command = [script, *arguments, "--figures"]
        compare({commit: (tree, command), "this tree": (ROOT, command)}, rounds)
