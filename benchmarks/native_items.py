"""Items per CPU-second with and without the native core, timed alternately for each recipe and difficulty.

    python benchmarks/native_items.py [items of each cell] [mode] [--tree PATH]

Two processes (three with --tree, whose `src` is an earlier commit's) make the same items, each while the others wait.
The digests of all prompts and answers must be the same.
"""

import argparse
import hashlib
import json
import os
import subprocess
import sys
from importlib import import_module
from pathlib import Path
from time import process_time

from against import ROOT

SEED = 5


def serve(mode: str) -> None:
    """Make the items of each cell that a line asks for, and say how many, in what time, and with what digest."""
    from sim2reason.datasets.worker import tune_garbage_collection  # noqa: PLC0415 - of the tree that this process imports from
    from sim2reason.generation.make import make  # noqa: PLC0415
    from sim2reason.generation.request import Request  # noqa: PLC0415

    make(Request("pulley", "easy", mode, SEED + 1, 0))
    import_module("sympy.polys.fields")  # half a second, when the first formula is shortened
    tune_garbage_collection()
    print("ready", flush=True)
    for line in sys.stdin:
        recipe, difficulty, index = json.loads(line)
        start = process_time()
        item = make(Request(recipe, difficulty, mode, SEED, index)).item
        spent = process_time() - start
        text = "" if item is None else f"{item.prompt} {item.answer!r}"
        print(json.dumps([item is not None, spent, hashlib.sha256(text.encode()).hexdigest()]), flush=True)


class Maker:
    """A process that makes items."""

    def __init__(self, name: str, tree: Path, switch: str, mode: str) -> None:
        """Start the process, with the package of a tree and a value of the switch, and wait until it is ready."""
        environment = os.environ | {"PYTHONPATH": str(tree / "src"), "SIM2REASON_NATIVE": switch}
        command = [sys.executable, __file__, "--serve", mode]
        self.name, self.count, self.seconds, self.digest = name, 0, 0.0, hashlib.sha256()
        self._process = subprocess.Popen(
            command, env=environment, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1
        )
        assert self._process.stdout is not None
        self._process.stdout.readline()

    def make(self, recipe: str, difficulty: str, index: int) -> None:
        """Make one item of a cell, and add what it took."""
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._process.stdin.write(json.dumps([recipe, difficulty, index]) + "\n")
        made, spent, digest = json.loads(self._process.stdout.readline())
        self.count, self.seconds = self.count + made, self.seconds + spent
        self.digest.update(digest.encode())

    def close(self) -> None:
        """End the process."""
        self._process.communicate()


def main() -> None:
    options = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    options.add_argument("count", type=int, nargs="?", default=2, help="items of each cell (default: 2)")
    options.add_argument("mode", nargs="?", default="numeric", help="the mode of question (default: numeric)")
    options.add_argument("--tree", type=Path, help="a checkout of an earlier commit")
    options.add_argument("--serve", metavar="MODE", help=argparse.SUPPRESS)
    given = options.parse_args()
    if given.serve:
        serve(given.serve)
        return
    from sim2reason.generation.recipes import RECIPES  # noqa: PLC0415
    from sim2reason.questions.difficulty import DIFFICULTIES  # noqa: PLC0415

    makers = [Maker("native", ROOT, "1", given.mode), Maker("Python", ROOT, "0", given.mode)]
    if given.tree:
        makers.append(Maker(str(given.tree), given.tree, "0", given.mode))
    for number, (recipe, difficulty) in enumerate((r, d) for r in RECIPES for d in DIFFICULTIES):
        for index in range(given.count):
            for maker in makers[number % len(makers) :] + makers[: number % len(makers)]:
                maker.make(recipe, difficulty, index)
    for maker in makers:
        maker.close()
        rate, ratio = maker.count / maker.seconds, maker.seconds / makers[0].seconds
        line = f"{maker.name:20} {rate:6.2f} {given.mode} items / CPU-s, {ratio:5.2f} times native's time"
        print(f"{line}, digest {maker.digest.hexdigest()[:12]}")


if __name__ == "__main__":
    main()
