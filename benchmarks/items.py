"""Items and scenes per CPU-second over all recipes: python benchmarks/items.py [items per cell] [mode].

Every item is certified, of a scene of its own, with all filters and both engines counted. Then: a set from two
workers, their CPU time included; scenes by the exact engine alone; the first item of a fresh process; the import.
With a mode, its items alone.
"""

import ctypes
import os
import resource
import subprocess
import sys
import time
from contextlib import suppress
from pathlib import Path
from tempfile import TemporaryDirectory
from time import process_time

from sim2reason.datasets.make import make
from sim2reason.datasets.plan import Request
from sim2reason.datasets.random_scenes import sample
from sim2reason.datasets.worker import collect_seldom
from sim2reason.dsl.scene import Scene
from sim2reason.errors import SimulationError, UnsupportedError
from sim2reason.recipes import DIFFICULTIES, RECIPES
from sim2reason.simulation.scenes import simulate

SEED = 5
SCENES = 20  # of each cell
RUNS = 5
SUBREAPER = 36  # PR_SET_CHILD_SUBREAPER
CELLS = [(recipe, difficulty) for recipe in RECIPES for difficulty in DIFFICULTIES]
FIRST = "import sim2reason; sim2reason.item(recipe='hybrid', difficulty='hard', mode='numeric', seed=1, index=0)"


def items(count: int, mode: str) -> None:
    """Cell by cell in this process, set up as a worker is, after one item to load what is loaded lazily."""
    make(Request("pulley", "easy", mode, SEED + 1, 0))
    collect_seldom()
    total, texts = 0.0, set[str]()
    for recipe, difficulty in CELLS:
        start, found = process_time(), set[str]()
        for index in range(count):
            item = make(Request(recipe, difficulty, mode, SEED, index)).item
            if item is not None:
                found.add(item.scene)
        spent = process_time() - start
        total, texts = total + spent, texts | found
        print(f"{recipe:10} {difficulty:7} {len(found) / spent:6.1f} items of unique scenes / CPU-s", flush=True)
    print(f"all        {len(texts) / total:14.1f} items of unique scenes / CPU-s", flush=True)


def adopt_orphans() -> None:
    """Become the parent of what outlives its own, as the server of workers does; else its time is lost (Linux)."""
    ctypes.CDLL(None).prctl(SUBREAPER, 1, 0, 0, 0)


def children() -> float:
    """CPU seconds of all processes that were started from here, the workers of workers too; waits for their end."""
    while True:
        try:
            os.wait()
        except ChildProcessError:
            break
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def dataset(count: int) -> None:
    """A set as the command line makes it, with two workers."""
    with TemporaryDirectory() as folder:
        options = ["--items", str(count), "--recipe", "all", "--difficulty", "all", "--workers", "2"]
        before = children()
        run(["generate", str(Path(folder) / "set"), *options])
        spent = children() - before
    print(f"generate   {count / spent:14.1f} items / CPU-s, two workers, starting and writing included", flush=True)


def run(arguments: list[str]) -> None:
    code = "import sys; from sim2reason.cli import main; main(sys.argv[1:])"
    subprocess.run([sys.executable, "-c", code, *arguments], check=True, stdout=subprocess.DEVNULL)


def scenes() -> None:
    """From a mechanism, and from a declared scene, to its motion; built anew, since scenes remember their mechanism."""
    drawn = [sample(recipe, difficulty, seed=SEED, index=i) for recipe, difficulty in CELLS for i in range(SCENES)]
    fresh = [Scene(entities=s.entities, connections=s.connections, world=s.world) for s in drawn]
    start = process_time()
    for scene in fresh:
        _ = scene.mechanism
    built = process_time()
    for scene in fresh:
        with suppress(SimulationError, UnsupportedError):  # what a generator refuses and draws again
            simulate(scene)
    spent = process_time() - built
    print(f"scenes     {len(fresh) / spent:14.1f} by the exact engine / CPU-s, from a mechanism to 101 samples")
    print(f"           {len(fresh) / (spent + built - start):14.1f} from a declaration on")


def fresh_process(code: str) -> tuple[float, float]:
    """Median CPU and wall seconds of a new process."""
    found: list[tuple[float, float]] = []
    for _ in range(RUNS):
        before, start = children(), time.perf_counter()
        subprocess.run([sys.executable, "-c", code], check=True)
        found.append((children() - before, time.perf_counter() - start))
    return sorted(found)[RUNS // 2]


def main(count: int = 20, mode: str = "") -> None:
    adopt_orphans()
    items(count, mode or "numeric")
    if mode:
        return
    dataset(len(CELLS) * count)
    scenes()
    for name, code in (("first item", FIRST), ("import", "import sim2reason")):
        cpu, wall = fresh_process(code)
        print(f"{name:10} {cpu:14.2f} CPU-s, {wall:.2f} s")


if __name__ == "__main__":
    main(*map(int, sys.argv[1:2]), *sys.argv[2:3])
