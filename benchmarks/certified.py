"""How many drawn scenes both engines agree on: python benchmarks/certified.py [scenes per cell] [recipe …].

A scene counts as certified if its certificate holds as long as the exact engine describes the motion. Nothing is
drawn again on the way. Prints for each recipe and difficulty the share, the agreement, and the rest by reason.
"""

import re
import sys
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from statistics import median
from typing import NamedTuple

from sim2reason.errors import SimulationError, UnsupportedError
from sim2reason.generation.item_search import sample
from sim2reason.generation.recipes import RECIPES
from sim2reason.questions.difficulty import DIFFICULTIES
from sim2reason.simulation.certify import CHANGES, RECORDED
from sim2reason.simulation.scenes import certify, simulate

SEED = 2024


class Cell(NamedTuple):
    """Scenes of one kind."""

    recipe: str
    difficulty: str


@dataclass(frozen=True)
class Witnessed:
    """What became of one scene."""

    index: int
    certified: bool
    changes: int  # events that change a mode
    worst: float  # relative difference of any channel
    reason: str  # why it is not certified to the end


def witnessed(cell: Cell, index: int) -> Witnessed:
    """Draw one scene, simulate it by both engines and compare."""
    scene = sample(cell.recipe, cell.difficulty, seed=SEED, index=index)
    try:
        described = simulate(scene, engine=RECORDED).stable_until
        trace, certificate = certify(scene)
    except (SimulationError, UnsupportedError) as error:
        return Witnessed(index, certified=False, changes=0, worst=0.0, reason=f"exact: {error}")
    worst = max(certificate.agreement.values(), default=0.0)
    changes = sum(event.kind in CHANGES and event.time <= described for event in trace.events)
    certified = certificate.stable_until >= described * (1.0 - 1e-6) and described > 1e-3 * scene.horizon
    return Witnessed(index, certified, changes, worst, "" if certified else certificate.reason or "ends at once")


def plain(reason: str) -> str:
    """A reason without names and numbers, to be counted."""
    return re.sub(r" of [a-z].*| at [\d.]+.*|[\d.]+(e-?\d+)? ", "", reason)[:60]


def report(cell: Cell, found: list[Witnessed]) -> None:
    """One line of figures, then the reasons."""
    good = [w for w in found if w.certified]
    smooth, eventful = ([w.worst for w in good if bool(w.changes) == kind] for kind in (False, True))
    parts = [f"{name} {median(v):.0e} / {max(v):.0e}" for name, v in (("smooth", smooth), ("events", eventful)) if v]
    share = len(good) / len(found)
    print(
        f"{cell.recipe:10} {cell.difficulty:7} {share:6.1%} certified; median / worst: {', '.join(parts)}", flush=True
    )
    for reason, count in Counter(plain(w.reason) for w in found if not w.certified).most_common():
        examples = [w.index for w in found if not w.certified and plain(w.reason) == reason][:6]
        print(f"    {count:4}  {reason}  (index {', '.join(map(str, examples))})", flush=True)


def main(count: int, recipes: list[str]) -> None:
    total: list[Witnessed] = []
    with ProcessPoolExecutor() as pool:
        for cell in (Cell(recipe, difficulty) for recipe in recipes for difficulty in DIFFICULTIES):
            found = list(pool.map(witnessed, [cell] * count, range(count), chunksize=5))
            report(cell, found)
            total += found
    print(f"all: {sum(w.certified for w in total) / len(total):.1%} of {len(total)} scenes certified")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 200, sys.argv[2:] or list(RECIPES))
