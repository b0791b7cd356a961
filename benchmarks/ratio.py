"""Numeric items per CPU-second against an earlier commit: ``python benchmarks/ratio.py [COMMIT] [ITEMS] [TURNS]``.

Both trees make items of the recipes that the commit has, so many of each cell, turn about, each in a process of its
own: machines differ by a factor of two, and so do the minutes of one.
"""

import subprocess
import sys
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory

ROOT = Path(__file__).parents[1]
LOOP = """
import sys
from time import process_time
from sim2reason.datasets import worker
from sim2reason.datasets.make import make
from sim2reason.datasets.plan import Request
count, recipes = int(sys.argv[1]), sys.argv[2].split(",")
make(Request(recipes[0], "easy", "numeric", 6, 0))
getattr(worker, "collect_seldom", lambda: None)()
cells = [(recipe, difficulty) for recipe in recipes for difficulty in ("easy", "medium", "hard")]
start = process_time()
made = [make(Request(*cell, "numeric", 5, index)).item for cell in cells for index in range(count)]
print(sum(item is not None for item in made) / (process_time() - start))
"""
RECIPES = "from sim2reason.recipes import RECIPES; print(','.join(RECIPES))"


def run(tree: Path, code: str, *arguments: str) -> str:
    """What code prints with the package of a tree."""
    command = [sys.executable, "-c", code, *arguments]
    told = subprocess.run(
        command,
        env={"PYTHONPATH": str(tree / "src"), "OMP_NUM_THREADS": "1"},
        check=True,
        capture_output=True,
        text=True,
    )
    return told.stdout.strip()


def main(commit: str = "d4ffb89", count: int = 6, turns: int = 3) -> None:
    """Turn about, and the medians."""
    with TemporaryDirectory() as folder:
        earlier = Path(folder) / "tree"
        subprocess.run(["git", "-C", ROOT, "worktree", "add", "--quiet", "--detach", earlier, commit], check=True)
        try:
            recipes = run(earlier, RECIPES)
            found = [[float(run(tree, LOOP, str(count), recipes)) for tree in (earlier, ROOT)] for _ in range(turns)]
        finally:
            subprocess.run(["git", "-C", ROOT, "worktree", "remove", "--force", earlier], check=True)
    for before, now in found:
        print(f"{commit} {before:6.1f}   this tree {now:6.1f} items / CPU-s   ratio {now / before:.2f}")
    print(f"median ratio over {recipes}: {median(now / before for before, now in found):.2f}")


if __name__ == "__main__":
    main(*sys.argv[1:2], *map(int, sys.argv[2:4]))
