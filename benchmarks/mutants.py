"""Mutation check: the share of random faults in the code that the tests find.

    python benchmarks/mutants.py 100 SEED [--workers N] [--log FILE]

Each mutant changes one operator, constant or condition of the exact engine, the questions, the filters or the grader in
a copy of the source, and the tests beside the changed module run against it, then a digest of an item of each recipe,
then the tests of its package, and, after all mutants, the other tests that make items. A mutant is killed if a test
fails or a run takes longer than `LIMITS`; the first failed test is printed. Survivors are printed with their line,
since some of them change nothing that a user could notice.

Mutants of the exact engine run without its native core, which replaces much of it, and survivors run against the
comparison of both, too. With --log, outcomes are added to a file, and a run that was stopped goes on from there.
"""

import argparse
import ast
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from dataclasses import dataclass
from itertools import accumulate, islice
from pathlib import Path
from queue import Queue
from subprocess import DEVNULL, PIPE

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
COMPARISON = "tests/simulation/engines/exact/test_native.py"
SCENE_QUESTIONS = "tests/datasets/test_scene_questions.py"
OTHERS = ("tests/solutions", "tests/generation", "tests/acceptance", "tests/text", SCENE_QUESTIONS)
"""The tests that the survivors of others run against."""
LIMITS = {False: 900.0, True: 3600.0}  # s of one run of tests, and of one of the `OTHERS`
PASSED, SURVIVED = "passes its own tests", "survived"
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

    @property
    def changed(self) -> str:
        """Return the text of the changed module."""
        return self.text[: self.start] + self.new + self.text[self.end :]

    def compiles(self) -> bool:
        """Return whether the changed module is Python; in f-strings, positions of expressions may be wrong."""
        try:
            ast.parse(self.changed)
        except SyntaxError:
            return False
        return True

    @property
    def area(self) -> str:
        """Return the area of the module."""
        return next(area for area in AREAS if self.path.is_relative_to(SOURCE / area))

    def __str__(self) -> str:
        """Return the place of the change, the changed line, and what replaces what."""
        shown = self.text.splitlines()[self.line - 1].strip()
        column = self.start - self.text.rfind("\n", 0, self.start)
        place = f"{self.path.relative_to(SOURCE)}:{self.line}:{column}"
        return f"{place}: {self.text[self.start : self.end]!r} -> {self.new!r} in: {shown}"


def mutants(path: Path) -> Iterator[Mutant]:
    """Yield all mutants of the functions of a module."""
    text = path.read_text("utf-8")
    lines = text.splitlines(keepends=True)
    starts = [0, *accumulate(map(len, lines))]

    def at(line: int, column: int) -> int:
        """Return the index of a position, whose column counts bytes."""
        return starts[line - 1] + len(lines[line - 1].encode()[:column].decode())

    def span(node: ast.expr) -> tuple[int, int]:
        """Return the indices between which an expression is written."""
        assert node.end_lineno is not None
        assert node.end_col_offset is not None
        return at(node.lineno, node.col_offset), at(node.end_lineno, node.end_col_offset)

    for function in (node for node in ast.walk(ast.parse(text)) if isinstance(node, ast.FunctionDef)):
        for statement in function.body:
            for node in ast.walk(statement):
                for start, end, new in _changes(node, text, span):
                    yield Mutant(path, start, end, new, text)


def _changes(node: ast.AST, text: str, span: Callable[[ast.expr], tuple[int, int]]) -> Iterator[tuple[int, int, str]]:
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
        low, high = span(left)[1], span(right)[0]
        found = re.search(r"\*\*|//|<<|>>|<=|>=|==|!=|\band\b|\bor\b|[-+*/<>]", text[low:high])
        if found and found[0] in table and "#" not in text[low:high]:
            yield low + found.start(), low + found.end(), table[found[0]]
    if isinstance(node, ast.Constant) and isinstance(node.value, int | float) and not isinstance(node.value, bool):
        changed = node.value + 1 if isinstance(node.value, int) else node.value * 1.5 + (not node.value)
        yield *span(node), repr(changed)
    if isinstance(node, ast.If | ast.IfExp):
        low, high = span(node.test)
        yield low, high, f"(not ({text[low:high]}))"


def drawn(number: int, seed: int) -> list[Mutant]:
    """Draw mutants, as many of each area."""
    rng, found = random.Random(seed), list[Mutant]()
    for area in AREAS:
        modules = sorted((SOURCE / area).rglob("*.py"))
        every = list(dict.fromkeys(each for path in modules for each in mutants(path)))  # nested functions come twice
        rng.shuffle(every)
        found += islice((mutant for mutant in every if mutant.compiles()), -(-number // len(AREAS)))
    rng.shuffle(found)
    return found[:number]


class Copies:
    """Copies of the source, one for each worker, whose bytecode is kept between runs."""

    def __init__(self, folder: Path, number: int) -> None:
        """Copy the source."""
        self._free: Queue[Path] = Queue()
        for index in range(number):
            source = folder / str(index) / "src" / SOURCE.name
            shutil.copytree(SOURCE, source, ignore=shutil.ignore_patterns("__pycache__"))
            self._free.put(source)

    def outcome(self, mutant: Mutant, known: str | None) -> str:
        """Return what follows a known outcome: killed by which test, passed by its own tests, or survived all."""
        runs = _runs(mutant) if known is None else [(OTHERS, _switch(mutant))] if known == PASSED else []
        if not runs:
            return str(known)
        source = self._free.get()
        changed = source / mutant.path.relative_to(SOURCE)
        try:
            changed.write_text(mutant.changed, "utf-8")
            found = (_failure(source, tests, switch) for tests, switch in runs)
            passed = SURVIVED if known else PASSED
            return next((f"killed by {failure}" for failure in found if failure), passed)
        finally:
            shutil.copy2(mutant.path, changed)
            self._free.put(source)


def _failure(source: Path, tests: tuple[str, ...], switch: str) -> str:
    """Return the first test that fails with a copy of the source, or why a run of tests ended; empty if all pass."""
    environment = {**os.environ, "PYTHONPATH": str(source.parent), "OMP_NUM_THREADS": "1", "SIM2REASON_NATIVE": switch}
    environment["PYTHONPYCACHEPREFIX"] = str(source.parents[1] / "bytecode")
    environment.pop("PYTHONDONTWRITEBYTECODE", None)
    command = [sys.executable, "-m", "pytest", "-x", "-q", "-p", "no:cacheprovider", *tests]
    limit = LIMITS[tests == OTHERS]
    with subprocess.Popen(
        command, cwd=ROOT, env=environment, stdout=PIPE, stderr=DEVNULL, text=True, start_new_session=True
    ) as process:
        try:
            output, _ = process.communicate(timeout=limit)
        except subprocess.TimeoutExpired:
            return f"the time limit of {' '.join(tests)}"
        finally:
            with suppress(ProcessLookupError):  # a mutant's loop without end may run in a process that a test started
                os.killpg(process.pid, signal.SIGKILL)
    if process.returncode in (0, 5):
        return ""
    named = re.search(r"^(?:FAILED|ERROR) (tests/\S+)", output, re.MULTILINE)
    return named[1] if named else f"the start of {' '.join(tests)}"


def _runs(mutant: Mutant) -> Iterator[tuple[tuple[str, ...], str]]:
    """Yield the runs of a mutant's own tests, cheap ones first, each with the switch of the native core."""
    inner, switch = mutant.path.relative_to(SOURCE), _switch(mutant)
    beside = ROOT / "tests" / inner.parent / f"test_{inner.stem}.py"
    if beside.exists():
        yield (str(beside.relative_to(ROOT)),), switch
    if mutant.area != "grading":
        yield (DIGESTS,), switch
    yield AREAS[mutant.area], switch
    if switch == "0":
        yield (COMPARISON,), "1"


def _switch(mutant: Mutant) -> str:
    """Return the switch of the native core, which is off where it would replace the mutant."""
    exact = mutant.area == "simulation/engines/exact"
    return "0" if exact and not mutant.path.stem.startswith("native") else "1"


def recorded(log: Path | None) -> dict[str, str]:
    """Return the outcomes in a log, by mutant."""
    lines = log.read_text("utf-8").splitlines() if log is not None and log.exists() else []
    return {mutant: found for found, _, mutant in (line.partition("\t") for line in lines)}


def _report(line: str, log: Path | None) -> None:
    """Print a line, and add it to a log."""
    print(line, flush=True)
    if log is not None:
        with log.open("a", encoding="utf-8") as file:
            file.write(f"{line}\n")


def main() -> None:
    """Print the outcome of each mutant, and how many of each area are killed."""
    options = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    options.add_argument("number", type=int, help="how many mutants")
    options.add_argument("seed", type=int)
    options.add_argument("--workers", type=int, default=os.cpu_count(), help="runs of tests at a time (default: CPUs)")
    options.add_argument("--log", type=Path, help="a file to which outcomes are added; those in it are not run again")
    given = options.parse_args()
    known, chosen = recorded(given.log), drawn(given.number, given.seed)
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(given.workers) as pool:
        copies = Copies(Path(folder), given.workers)

        def outcome(mutant: Mutant) -> tuple[Mutant, str]:
            return mutant, copies.outcome(mutant, known.get(str(mutant)))

        for _ in ("its own tests", "the others"):
            for mutant, found in pool.map(outcome, chosen):
                if known.get(str(mutant)) != found:
                    _report(f"{found}\t{mutant}", given.log)
                    known[str(mutant)] = found
    counts = Counter((mutant.area, known[str(mutant)] == SURVIVED) for mutant in chosen)
    for area in AREAS:
        killed, survived = counts[area, False], counts[area, True]
        print(f"{area}: {killed} of {killed + survived} killed")
    print(f"{sum(count for (_, survived), count in counts.items() if not survived)} of {given.number} killed")


if __name__ == "__main__":
    main()
