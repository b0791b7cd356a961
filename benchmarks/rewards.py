"""How long the reward of a training step takes: python benchmarks/rewards.py [COMPLETIONS] [ROUNDS].

By default 512 completions, 16 to each of 32 problems of all modes: answers that are right, wrong ones, and none, behind
so many words of thought that a response has about 100, 8,000 or 48,000 characters. The first round meets each formula
for the first time; the median is that of all rounds. Exit code 1 if it takes over 0.2 s.
"""

import sys
import time
from itertools import islice
from statistics import median

from against import PHASE, fixed_loop

from sim2reason.datasets.items import stream
from sim2reason.rewards import accuracy, answered, boxed, ground_truth

RESPONSES = 16  # to each problem
BOUND = 0.2  # seconds
SENTENCE = "Newton's second law gives $m a = F - m g$, so that we go on from there. "
LENGTHS = 100, 8_000, 48_000  # characters


def main(completions: int = 512, rounds: int = 7) -> int:
    """Print the seconds; exit code 1 if the bound is missed."""
    items = list(islice(stream(mode="all", seed=20_261_124), max(1, completions // RESPONSES)))
    rows = [item for item in items for _ in range(RESPONSES)]
    right = [ground_truth(item) for item in rows]
    answers = ["", *(boxed(text) for text in ("1.23", r"\frac{1}{2}"))]
    slowest = 0.0
    print(f"{len(rows)} completions of {len(items)} problems, seconds")
    for length in LENGTHS:
        thought = SENTENCE * (length // len(SENTENCE) + 1)
        said = [
            thought + (boxed(answered(item)) if number % 2 else answers[number // 2 % len(answers)])
            for number, item in enumerate(rows)
        ]
        times = list[float]()
        for _ in range(rounds):
            begin = time.perf_counter()
            paid = accuracy(said, said, ground_truth=right)
            times.append(time.perf_counter() - begin)
            assert sum(reward == 1.0 for reward in paid) >= len(rows) // 2
        slowest = max(slowest, median(times))
        print(f"  {length:6} characters: first {times[0]:.4f}, median of {rounds} {median(times):.4f}")
    print(f"{PHASE}: {fixed_loop():.1f} ms")
    return 1 if slowest > BOUND else 0


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:])))
