"""Mutation check: the share of random faults in the code that the tests find.

    python benchmarks/mutants.py 100 SEED [WORKERS]

Each mutant changes one operator, constant or condition of the exact engine, the questions, the filters or the grader in
a copy of the source, and the tests beside the changed module run against it, then those of its package, then a digest
of an item of each recipe. A mutant is killed if a test fails or takes `LIMIT` seconds. Survivors are printed with their
line, since some of them change nothing that a user could notice.
"""

import ast
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from itertools import accumulate
from pathlib import Path

ROOT = Path(__file__).parents[1]
SOURCE = ROOT / "src" / "sim2reason"
AREAS = {
    "simulation/engines/exact": ("tests/simulation",),
    "questions": ("tests/questions",),
    "generation/filters": ("tests/generation/filters",),
    "grading": ("tests/grading",),
}
"""The packages that are changed, each with the tests of its package."""
DIGESTS = "tests/acceptance/test_same_items.py"
LIMIT = 600.0  # s of one run of the tests
OPERATORS = {"+": "-", "-": "+", "*": "/", "/": "*", "<": ">=", ">": "<=", "<=": ">", ">=": "<", "==": "!=", "!=": "=="}
WORDS = {"and": "or", "or": "and"}


@dataclass(frozen=True)
class Mutant:
    """One changed span of a module."""

    path: Path
    start: int
    end: int
    new: str
    text: str

    @property
    def line(self) -> int:
        """Return the number of the changed line."""
        return self.text.count("\n", 0, self.start) + 1

    def __str__(self) -> str:
        """Return the place of the change, the changed line, and what replaces what."""
        shown = self.text.splitlines()[self.line - 1].strip()
        place = f"{self.path.relative_to(SOURCE)}:{self.line}"
        return f"{place}: {self.text[self.start : self.end]!r} -> {self.new!r} in: {shown}"


def mutants(path: Path) -> Iterator[Mutant]:
    """Yield all mutants of the functions of a module."""
    text = path.read_text("utf-8")
    lines = text.splitlines(keepends=True)
    starts = [0, *accumulate(map(len, lines))]

    def at(line: int, column: int) -> int:
        """Return the index of a position, whose column counts bytes."""
        return starts[line - 1] + len(lines[line - 1].encode()[:column].decode())

    for function in (node for node in ast.walk(ast.parse(text)) if isinstance(node, ast.FunctionDef)):
        for statement in function.body:
            for node in ast.walk(statement):
                for start, end, new in _changes(node, text, at):
                    yield Mutant(path, start, end, new, text)


def _changes(node: ast.AST, text: str, at: Callable[[int, int], int]) -> Iterator[tuple[int, int, str]]:
    """Yield the spans of a node that may be replaced, with what replaces them."""
    if isinstance(node, ast.BinOp):
        pairs, table = [(node.left, node.right)], OPERATORS
    elif isinstance(node, ast.Compare):
        pairs, table = [(node.left, node.comparators[0])], OPERATORS
    elif isinstance(node, ast.BoolOp):
        pairs, table = [(node.values[0], node.values[1])], WORDS
    else:
        pairs, table = [], {}
    for left, right in pairs:
        low, high = at(left.end_lineno, left.end_col_offset), at(right.lineno, right.col_offset)
        found = re.search(r"<=|>=|==|!=|\band\b|\bor\b|[-+*/<>]", text[low:high])
        if found and found[0] in table and "#" not in text[low:high]:
            yield low + found.start(), low + found.end(), table[found[0]]
    if isinstance(node, ast.Constant) and type(node.value) in (int, float):
        low, high = at(node.lineno, node.col_offset), at(node.end_lineno, node.end_col_offset)
        yield low, high, repr(node.value + 1 if isinstance(node.value, int) else node.value * 1.5 + (not node.value))
    if isinstance(node, ast.If | ast.IfExp):
        test = node.test
        low, high = at(test.lineno, test.col_offset), at(test.end_lineno, test.end_col_offset)
        yield low, high, f"(not ({text[low:high]}))"


def drawn(number: int, seed: int) -> list[Mutant]:
    """Draw mutants, as many of each area."""
    rng, found = random.Random(seed), []
    for area in AREAS:
        every = [each for path in sorted((SOURCE / area).rglob("*.py")) for each in mutants(path)]
        found += rng.sample(every, -(-number // len(AREAS)))
    rng.shuffle(found)
    return found[:number]


def outcome(mutant: Mutant) -> str:
    """Return how a mutant ended: killed by which tests, or survived."""
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / "src" / "sim2reason"
        shutil.copytree(SOURCE, copy, ignore=shutil.ignore_patterns("__pycache__"))
        changed = mutant.text[: mutant.start] + mutant.new + mutant.text[mutant.end :]
        (copy / mutant.path.relative_to(SOURCE)).write_text(changed, "utf-8")
        environment = {**os.environ, "PYTHONPATH": f"{folder}/src", "OMP_NUM_THREADS": "1"}
        for tests in _tests(mutant):
            command = [sys.executable, "-m", "pytest", "-x", "-q", "-p", "no:cacheprovider", *tests]
            try:
                done = subprocess.run(
                    command, cwd=ROOT, env=environment, capture_output=True, timeout=LIMIT, check=False
                )
            except subprocess.TimeoutExpired:
                return "killed by the time limit"
            if done.returncode not in (0, 5):
                return f"killed by {' '.join(tests)}"
    return "survived"


def _tests(mutant: Mutant) -> Iterator[tuple[str, ...]]:
    """Yield the tests of a mutant: of its module, of its package, and digests of items."""
    inner = mutant.path.relative_to(SOURCE)
    beside = ROOT / "tests" / inner.parent / f"test_{inner.stem}.py"
    if beside.exists():
        yield (str(beside.relative_to(ROOT)),)
    if not str(inner).startswith("grading"):
        yield (DIGESTS,)
    yield next(tests for area, tests in AREAS.items() if str(inner).startswith(area))


def main() -> None:
    """Print each survivor, and how many of each area are killed."""
    number, seed = int(sys.argv[1]), int(sys.argv[2])
    counts: Counter[tuple[str, bool]] = Counter()
    chosen = drawn(number, seed)
    with ThreadPoolExecutor(int(sys.argv[3]) if len(sys.argv) > 3 else os.cpu_count()) as pool:
        for mutant, found in zip(chosen, pool.map(outcome, chosen), strict=True):
            area = next(area for area in AREAS if str(mutant.path.relative_to(SOURCE)).startswith(area))
            counts[area, found == "survived"] += 1
            print(f"{found}: {mutant}", flush=True)
    for area in AREAS:
        killed, survived = counts[area, False], counts[area, True]
        print(f"{area}: {killed} of {killed + survived} killed")
    killed = sum(count for (_, survived), count in counts.items() if not survived)
    print(f"{killed} of {number} killed")


if __name__ == "__main__":
    main()
