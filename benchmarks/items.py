"""Items and scenes per CPU-second over all recipes.

    python benchmarks/items.py [items per cell] [mode] [--rounds N] [--against COMMIT]

Every item is certified, of a scene of its own, with all filters and both engines counted. Then: a set from two
workers, their CPU time included; scenes by the exact engine alone; the first item of a fresh process; the import.
With a mode, its items alone.

With --against, items of the recipes that the commit has, made by both trees turn about: of all kinds of question and by
all filters, and where this tree has more, of those kinds only that the commit has, by those filters only, and both.
"""

import ctypes
import json
import os
import resource
import subprocess
import sys
import time
from contextlib import suppress
from importlib import import_module
from pathlib import Path
from tempfile import TemporaryDirectory
from time import process_time

from against import PHASE, ROOT, Figures, checked_out, compare, fixed_loop, medians, parser, told

from sim2reason.datasets.worker import tune_garbage_collection
from sim2reason.errors import SimulationError, UnsupportedError
from sim2reason.generation.item_search import sample
from sim2reason.generation.make import make
from sim2reason.generation.recipes import RECIPES
from sim2reason.generation.request import Request
from sim2reason.questions.difficulty import DIFFICULTIES
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.simulation.scenes import simulate

SEED = 5
SCENES = 20  # of each cell
RUNS = 5
SUBREAPER = 36  # PR_SET_CHILD_SUBREAPER
CELLS = [(recipe, difficulty) for recipe in RECIPES for difficulty in DIFFICULTIES]
FIRST = "import sim2reason; sim2reason.item(recipe='hybrid', difficulty='hard', mode='numeric', seed=1, index=0)"
FIND = """
from importlib import import_module

def find(*names):
    # the first of several modules that there is: packages have moved
    for name in names:
        try:
            return import_module("sim2reason." + name)
        except ImportError:
            pass
    raise ImportError(names)

filters = find("generation.filters", "filters")
"""
NAMES = f"""{FIND}
from sim2reason.questions import KINDS
for names in (find("generation.recipes", "recipes").RECIPES, KINDS, filters.FILTERS):
    print(",".join(names))
"""
# Of a package of any age: how many items a CPU-second, in all and of each recipe, but for some kinds of question and
# some filters.
LOOP = f"""{FIND}
import json, sys
from time import process_time
sys.path.insert(0, {str(Path(__file__).parent)!r})
from against import PHASE, fixed_loop
from sim2reason.datasets import worker
make, Request = find("generation.make", "datasets.make").make, find("generation.request", "datasets.request").Request
count, mode, recipes = int(sys.argv[1]), sys.argv[2], sys.argv[3].split(",")
kinds, refusing = (set(names.split(",")) - {{""}} for names in sys.argv[4:6])
if refusing:
    kept = [found for found in filters.in_order() if found[0] not in refusing]
    filters.in_order = lambda: kept
weights = {{"weights": tuple((kind, 0.0) for kind in sorted(kinds))}} if kinds else {{}}
make(Request(recipes[0], "easy", mode, {SEED + 1}, 0))
import sympy.polys.fields  # half a second, once a process, when the first formula is shortened
for name in ("collect_seldom", "tune_garbage_collection"):  # as its workers do, under the name of its age
    getattr(worker, name, lambda: None)()
rates, total, spent = {{}}, 0, 0.0
for recipe in recipes:
    start = process_time()
    cells = [(recipe, difficulty, mode, {SEED}, n) for difficulty in ("easy", "medium", "hard") for n in range(count)]
    kept = sum(make(Request(*cell, **weights)).item is not None for cell in cells)
    seconds = process_time() - start
    rates[recipe], total, spent = kept / seconds, total + kept, spent + seconds
print(json.dumps({{"items / CPU-s": total / spent, **rates, PHASE: fixed_loop()}}))
"""


def beside(commit: str, count: int, mode: str, rounds: int) -> None:
    """Time an earlier commit and this tree alternately."""
    with checked_out(commit) as tree:
        recipes, kinds, filters = told((tree, ["-c", NAMES])).splitlines()
        _, *here = told((ROOT, ["-c", NAMES])).splitlines()
        newer = [
            ",".join(sorted(set(n.split(",")) - set(o.split(",")))) for n, o in zip(here, (kinds, filters), strict=True)
        ]
        plain = ["-c", LOOP, str(count), mode, recipes]
        orders = {commit: (tree, [*plain, "", ""]), "this tree": (ROOT, [*plain, "", ""])}
        if newer[0]:
            orders["same kinds"] = ROOT, [*plain, newer[0], ""]
        if newer[1]:
            orders["same filters"] = ROOT, [*plain, "", newer[1]]
        if all(newer):
            orders["same kinds and filters"] = ROOT, [*plain, *newer]
        print(f"recipes {recipes}; kinds {kinds}; filters {filters}")
        compare(orders, rounds)


def items(count: int, mode: str, rounds: int) -> None:
    """Cell by cell in this process, set up as a worker is, after one item to load what is loaded lazily."""
    make(Request("pulley", "easy", mode, SEED + 1, 0))
    import_module("sympy.polys.fields")  # when the first formula is shortened
    tune_garbage_collection()
    found: list[Figures] = []
    for turn in range(rounds):
        found.append(one_round(count, mode))
        print(f"round {turn + 1}: all {found[-1]['all']:.1f} items / CPU-s, {PHASE} {found[-1][PHASE]:.1f}", flush=True)
    for name, rate in medians(found).items():
        print(f"{name:26} {rate:6.1f}" + " items of unique scenes / CPU-s" * (name != PHASE), flush=True)


def one_round(count: int, mode: str) -> Figures:
    """Rates of each cell and of all."""
    total, texts, found = 0.0, set[str](), Figures()
    for recipe, difficulty in CELLS:
        start = process_time()
        made = [make(Request(recipe, difficulty, mode, SEED, index)).item for index in range(count)]
        spent, scenes = process_time() - start, {item.scene for item in made if item is not None}
        found[f"{recipe} {difficulty}"] = len(scenes) / spent
        total, texts = total + spent, texts | scenes
    return found | {"all": len(texts) / total, PHASE: fixed_loop()}


def adopt_orphans() -> None:
    """Become the parent of what outlives its own, as workers do their server, or its time is lost; on Linux alone."""
    if sys.platform == "linux":
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
        options = ["--items", str(count), "--recipe", "all", "--difficulty", "all", "--workers", "2", "--json"]
        before = children()
        rows = json.loads(run(["generate", str(Path(folder) / "set"), *options]))["rows"]
        spent = children() - before
    print(f"generate   {rows / spent:14.1f} items / CPU-s, two workers, starting and writing included", flush=True)


def run(arguments: list[str]) -> str:
    code = "import sys; from sim2reason.cli import main; main(sys.argv[1:])"
    return subprocess.run([sys.executable, "-c", code, *arguments], check=True, stdout=subprocess.PIPE).stdout.decode()


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


def main() -> None:
    options = parser(__doc__)
    options.add_argument("count", type=int, nargs="?", default=4, help="items of each cell (default: 4)")
    options.add_argument("mode", nargs="?", default="", help="the mode of question alone (default: numeric, and more)")
    given = options.parse_args()
    if given.against:
        beside(given.against, given.count, given.mode or "numeric", given.rounds)
        return
    adopt_orphans()
    items(given.count, given.mode or "numeric", given.rounds)
    if given.mode:
        return
    dataset(len(CELLS) * given.count)
    scenes()
    for name, code in (("first item", FIRST), ("import", "import sim2reason")):
        cpu, wall = fresh_process(code)
        print(f"{name:10} {cpu:14.2f} CPU-s, {wall:.2f} s")


if __name__ == "__main__":
    main()
