"""How many random mechanisms that bend and turn both engines agree on: benchmarks/curved.py.

Arguments: first, last and family. Seeds from first to last of each family (or of one) of
`tests/support/curved_mechanisms`; both engines simulate each one over 2 s.
Prints the share in agreement, how near, and what parted the engines or kept the exact one from an answer.
"""

import re
import sys
from collections import defaultdict
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from statistics import median
from time import process_time

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "support"))

from curved_mechanisms import FAMILIES
from sim2reason.errors import SceneError, SimulationError, UnsupportedError
from sim2reason.simulation.certify import certify_trace
from sim2reason.simulation.trace import ENGINES

TIMES = np.linspace(0.0, 2.0, 101)
PARTED = ("only one engine", "the engines disagree", "no witness")


@dataclass(frozen=True)
class Try:
    """What became of one mechanism."""

    family: str
    seed: int
    outcome: str  # agreed, parted, refused
    reason: str
    exact: float  # CPU seconds
    witness: float
    worst: float = 0.0  # relative difference of any channel
    lived: float = 0.0  # s, until the recorded engine's own end
    until: float = 0.0  # s, that both vouch for


def attempt(job: tuple[str, int]) -> Try:
    """Simulate one mechanism by both engines and compare."""
    family, seed = job
    mechanism = FAMILIES[family](seed)
    start = process_time()
    try:
        recorded = ENGINES["exact"](mechanism, TIMES)
    except (SimulationError, UnsupportedError, SceneError) as error:
        return Try(family, seed, "refused", f"{type(error).__name__}: {error}", process_time() - start, 0.0)
    middle = process_time()
    _, certificate = certify_trace(recorded)
    parted = certificate.reason.startswith(PARTED)
    worst = max(certificate.agreement.values(), default=0.0)
    times = (middle - start, process_time() - middle)
    ends = (recorded.stable_until, certificate.stable_until)
    return Try(family, seed, "parted" if parted else "agreed", certificate.reason, *times, worst, *ends)


def plain(reason: str) -> str:
    """A reason without names and numbers, to be counted."""
    return re.sub(r"[\w.]*\d[\w.]*|\bof [a-z., ]+(?= at)", "…", reason)[:90]


def report(tries: list[Try]) -> None:
    """A line for each family, then what is left, by reason."""
    answered = [t for t in tries if t.outcome != "refused"]
    agreed = [t for t in answered if t.outcome == "agreed"]
    share = len(agreed) / max(len(answered), 1)
    print(f"{len(tries)} mechanisms, {len(answered)} answered by the exact engine, {share:.2%} of those agreed on")
    worst = [t.worst for t in agreed]
    print(f"relative difference: median {median(worst):.0e}, worst {max(worst):.0e}")
    exact, witness = _mean([t.exact for t in tries]), _mean([t.witness for t in answered])
    print(f"CPU: exact {1e3 * exact:.1f} ms, witness {1e3 * witness:.0f} ms")
    print(f"slowest: exact {max(t.exact for t in tries):.2f} s, witness {max(t.witness for t in tries):.2f} s")
    for family in FAMILIES:
        mine = [t for t in tries if t.family == family]
        counts = {outcome: sum(t.outcome == outcome for t in mine) for outcome in ("agreed", "parted", "refused")}
        if mine:
            print(f"  {family:8} " + ", ".join(f"{outcome} {count}" for outcome, count in counts.items()))
    kinds: dict[tuple[str, str], list[Try]] = defaultdict(list)
    for t in tries:
        kinds[t.outcome, plain(t.reason)].append(t)
    for (outcome, reason), found in sorted(kinds.items(), key=lambda item: (item[0][0], -len(item[1]))):
        some = "" if outcome == "agreed" else "  (" + ", ".join(f"{t.family} {t.seed}" for t in found[:8]) + ")"
        print(f"  {len(found):5}  {outcome}: {reason or 'to the end'}{some}")


def _mean(values: list[float]) -> float:
    return sum(values) / max(len(values), 1)


def main(first: int = 0, last: int = 100, family: str = "") -> None:
    jobs = [(name, seed) for name in FAMILIES if family in ("", name) for seed in range(first, last)]
    with ProcessPoolExecutor() as pool:
        report(list(pool.map(attempt, jobs, chunksize=5)))


if __name__ == "__main__":
    main(*map(int, sys.argv[1:3]), *sys.argv[3:])
