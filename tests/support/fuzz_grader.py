"""Fuzz test of the grader in a separate process: ``python fuzz.py COUNT SEED`` prints the failures as JSON.

An audit hook records all access to files, processes and the like during grading. References and tolerance are such
that no text made here can be right by luck, so every accepted one is a false accept.
"""

import itertools
import json
import sys
import time
import tracemalloc
from collections import Counter

import hostile
from sim2reason.grading import formula, number

FORBIDDEN = (
    "exec",
    "compile",
    "import",
    "open",
    "os.",
    "subprocess.",
    "socket.",
    "ctypes.",
    "marshal.",
    "pty.",
    "shutil.",
)
LIMITS = {"number": 0.050, "formula": 0.050}  # seconds of CPU
GRADES = {
    "number": lambda text: number(text, 73219.456, "m/s^2", tolerance=1e-9),
    "unit-blind number": lambda text: number(text, 73219.456, tolerance=1e-9),
    "lenient number": lambda text: number(text, 73219.456, "m", tolerance=1e-9, lenient=True),
    "formula": lambda text: formula(text, r"\frac{m_1 g\sin\theta+\mu_k h^3}{2m_1+5h}"),
}


def seconds(kind: str, text: str) -> float:
    start = time.thread_time()
    GRADES[kind](text)
    return time.thread_time() - start


class EventDetector:
    """Recorder of audit events while it is on; an audit hook can't be removed again."""

    def __init__(self) -> None:
        self.on, self.events = False, []
        sys.addaudithook(self.audit)
        self.on = True
        compile("1", "the hook must see this", "eval")
        if self.events != ["compile"]:
            raise SystemError(f"the audit hook is blind: {self.events}")
        self.events.clear()

    def audit(self, event: str, _: object) -> None:
        if self.on and event.startswith(FORBIDDEN):
            self.events.append(event)


def main(count: int, seed: int) -> dict[str, object]:
    for kind in GRADES:
        seconds(kind, r"\boxed{9.8}")  # what is loaded once, is loaded now
    giants = list(hostile.giants().values())
    jobs = [(kind, text) for text in giants for kind in GRADES]
    jobs += zip(itertools.cycle(GRADES), hostile.strings(count, seed))
    slow, accepted, outcomes = [], [], Counter()
    watch = EventDetector()
    for kind, text in jobs:
        start = time.thread_time()
        score = GRADES[kind](text)
        spent = time.thread_time() - start
        outcomes[score.outcome] += 1
        if score.reward:
            accepted.append([kind, text[:200]])
        limit = LIMITS[kind.split()[-1]]
        if spent > limit and min(seconds(kind, text) for _ in range(3)) > limit:
            slow.append([kind, spent, text[:200]])
    peak = memory(giants)
    watch.on = False
    report = {"graded": len(jobs), "outcomes": outcomes, "slow": slow, "accepted": accepted, "peak": peak}
    return report | {"events": watch.events}


def memory(giants: list[str]) -> int:
    """Return the peak memory in bytes of grading all texts."""
    tracemalloc.start()
    for text in giants:
        for grade in GRADES.values():
            grade(text)
    return tracemalloc.get_traced_memory()[1]


if __name__ == "__main__":
    print(json.dumps(main(int(sys.argv[1]), int(sys.argv[2]))))  # noqa: T201 - its result
