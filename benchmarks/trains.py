"""How many random trains both engines agree on: python benchmarks/trains.py [first seed [last seed]].

A train is a row of carts with cargo, strings, collisions and whatever draws them, as the tests make them at random:
jerks, hits and friction come in combinations that no recipe would choose. Both engines simulate each one over 2 s.
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

import machines
from sim2reason.errors import SimulationError
from sim2reason.simulation.certify import certify

TIMES = np.linspace(0.0, 2.0, 201)
PARTED = ("only one engine", "the engines disagree", "no witness")


@dataclass(frozen=True)
class Ride:
    """What became of one train."""

    seed: int
    reason: str  # why the motion or the agreement ended
    spent: float  # CPU seconds, both engines
    worst: float | None = None  # relative difference of any channel; None if the exact engine gave no answer

    @property
    def agreed(self) -> bool:
        """Whether both engines describe the motion to the same end."""
        return self.worst is not None and not self.reason.startswith(PARTED)


def ride(seed: int) -> Ride:
    """Draw one train, simulate it by both engines and compare."""
    mechanism = machines.train(np.random.default_rng(seed))
    start = process_time()
    try:
        _, certificate = certify(mechanism, TIMES)
    except SimulationError as error:
        return Ride(seed, f"exact: {error}", process_time() - start)
    spent = process_time() - start
    return Ride(seed, certificate.reason, spent, max(certificate.agreement.values(), default=0.0))


def plain(reason: str) -> str:
    """A reason without names and numbers, to be counted."""
    return re.sub(r"( of| at|:) ([a-z]*\d|-?[\d.]+ s|cargo|hand|rope|weight|inner|one|two).*", "", reason)[:80]


def report(rides: list[Ride]) -> None:
    """The shares, then what is left, by reason."""
    worst = [r.worst for r in rides if r.worst is not None and r.agreed]
    print(f"{len(rides)} trains, {len(worst) / len(rides):.2%} agreed on")
    if worst:
        print(f"relative difference: median {median(worst):.0e}, worst {max(worst):.0e}")
    print(f"{1e3 * sum(r.spent for r in rides) / len(rides):.1f} ms of CPU a train, both engines")
    kinds: dict[tuple[bool, str], list[int]] = defaultdict(list)
    for r in rides:
        kinds[r.agreed, plain(r.reason)].append(r.seed)
    for (fine, reason), seeds in sorted(kinds.items(), key=lambda item: (item[0][0], -len(item[1]))):
        examples = "" if fine else f"  (seeds {', '.join(map(str, seeds[:8]))})"
        print(f"    {len(seeds):5}  {'agreed' if fine else 'parted'}: {reason or 'to the end'}{examples}")


def main(first: int = 0, last: int = 1000) -> None:
    with ProcessPoolExecutor() as pool:
        report(list(pool.map(ride, range(first, last), chunksize=20)))


if __name__ == "__main__":
    main(*map(int, sys.argv[1:3]))
