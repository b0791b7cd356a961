"""Whether any simulation runs away: benchmarks/runaways.py.

Arguments: how many random mechanisms and scenes, how many spoiled ones, and where to begin counting. Both engines
simulate each one, as certifying does. Prints the longest CPU times, the most memory, and what became of all; ends
with status 1 if anything took over 5 s or 1 GB, or failed otherwise than by one of the library's own errors.
"""

import sys
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "support"))

from runaway import KINDS, SPOILED, Try, attempt


def report(tries: list[Try]) -> bool:
    """How long and how large; whether nothing ran away."""
    print(
        f"{len(tries)} simulations: "
        + ", ".join(f"{n} {what}" for what, n in Counter(t.outcome for t in tries).items())
    )
    print(f"most memory that one simulation took: {max(t.memory for t in tries):.2f} GB")
    for name in ("exact", "witness"):
        times = np.array([getattr(t, name) for t in tries])
        middle, high, most = np.quantile(times, [0.5, 0.99, 1.0])
        print(f"CPU of the {name} engine: median {1e3 * middle:.1f} ms, 99 % {1e3 * high:.0f} ms, most {most:.2f} s")
    for t in sorted(tries, key=lambda t: -(t.exact + t.witness))[:12]:
        print(f"  {t.kind} {t.seed}: {t.exact:.2f} + {t.witness:.2f} s, {t.outcome}")
    bad = [f"{t.kind} {t.seed}" for t in tries if t.bad]
    print(f"{len(bad)} ran away" + (": " + ", ".join(bad[:20]) if bad else ""))
    return not bad


def main(plain: int = 2000, wrong: int = 500, first: int = 0) -> None:
    jobs = [(kind, first + n) for kind in KINDS for n in range(-(-plain // len(KINDS)))]
    jobs += [(kind, first + n) for kind in SPOILED for n in range(-(-wrong // len(SPOILED)))]
    with ProcessPoolExecutor(2) as pool:
        tries = list(pool.map(attempt, jobs, chunksize=2))
    sys.exit(not report(tries))


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
