"""Numeric items per CPU-second against an earlier commit: ``python benchmarks/ratio.py [COMMIT] [ITEMS] [TURNS]``.

Both trees make items of the recipes that the commit has, so many of each cell, turn about, each in a process of its
own: machines differ by a factor of two, and so do the minutes of one. This tree makes them twice: of all its kinds of
question, and of those only that the commit has, too.
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
count, recipes, left_out = int(sys.argv[1]), sys.argv[2].split(","), [kind for kind in sys.argv[3].split(",") if kind]
weights = {"weights": tuple((kind, 0.0) for kind in left_out)} if left_out else {}
make(Request(recipes[0], "easy", "numeric", 6, 0))
getattr(worker, "collect_seldom", lambda: None)()
cells = [(recipe, difficulty) for recipe in recipes for difficulty in ("easy", "medium", "hard")]
start = process_time()
made = [make(Request(*cell, "numeric", 5, index, **weights)).item for cell in cells for index in range(count)]
print(sum(item is not None for item in made) / (process_time() - start))
"""
RECIPES = "from sim2reason.recipes import RECIPES; print(','.join(RECIPES))"
KINDS = "from sim2reason.questions import KINDS; print(','.join(KINDS))"


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
            recipes, known = run(earlier, RECIPES), run(earlier, KINDS).split(",")
            newer = ",".join(kind for kind in run(ROOT, KINDS).split(",") if kind not in known)
            made = (earlier, ""), (ROOT, ""), (ROOT, newer)
            found = [[float(run(tree, LOOP, str(count), recipes, kinds)) for tree, kinds in made] for _ in range(turns)]
        finally:
            subprocess.run(["git", "-C", ROOT, "worktree", "remove", "--force", earlier], check=True)
    for before, now, alike in found:
        print(f"{commit} {before:6.1f}   this tree {now:6.1f}, of the same kinds {alike:6.1f} items / CPU-s")
    for name, place in (("all kinds", 1), (f"kinds {', '.join(known)}", 2)):
        print(f"median ratio over {recipes}, {name}: {median(row[place] / row[0] for row in found):.2f}")


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "d4ffb89", *map(int, sys.argv[2:4]))
