"""How fast the grader is, at worst and as usual, and beside math-verify.

    python benchmarks/grading.py [--against COMMIT] [--math-verify PYTHON] [--json FILE]

math-verify brings sympy, so it is no dependency of ours, not even for development; give a Python that has it:
    python -m venv mv && mv/bin/pip install math-verify && python benchmarks/grading.py --math-verify mv/bin/python
Exit code 1 if a bound of ours is missed.
"""

import json
import subprocess
import sys
import time
import tracemalloc
from collections import Counter
from collections.abc import Callable
from functools import partial
from pathlib import Path
from statistics import median

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "support"))

from against import PHASE, fixed_loop, parser, script_against

import hostile
from grader_cases import CASES, grade
from sim2reason.grading import formula, number

REFERENCE = r"2\pi\sqrt{\frac{m(M+m\sin^2\theta)}{k(M+m)}}"
THOUGHT = "<think>" + "Newton's second law gives $m a = F - m g$, so we go on. " * 400 + "</think>"
PLAIN: dict[str, Callable[[], object]] = {
    "number, plain": lambda: number(r"The acceleration is $\boxed{9.8}$.", 9.8, "m/s^2"),
    "number, with unit": lambda: number(r"It is $\boxed{1.2\times10^{3}\,\mathrm{m/s^2}}$.", 1200, "m/s^2"),
    "number, named, with unit": lambda: number(r"So $\boxed{v = 3.2\ \text{m/s}}$.", 3.2, "m/s"),
    "number, after 22 000 characters": lambda: number(THOUGHT + r"It is $\boxed{9.8\ \text{m/s}^2}$.", 9.8, "m/s^2"),
    "steps, their sides read": lambda: number(
        r"So $\boxed{v = \sqrt{2\cdot 9.8\cdot 0.52} = 3.2\,\text{m/s}}$.", 3.2, "m/s"
    ),
    "remark, a direction": lambda: number(r"So $\boxed{3.2\text{ m/s (downward)}}$.", 3.2, "m/s"),
    "siunitx": lambda: number(r"So $\boxed{\SI{3.2}{\meter\per\second}}$.", 3.2, "m/s"),
    "formula, Atwood": lambda: formula(r"$\boxed{g\frac{m_1-m_2}{m_1+m_2}}$", r"\frac{m_1-m_2}{m_1+m_2}g"),
    "formula, spring on wedge": lambda: formula(rf"$\boxed{{{REFERENCE}}}$", REFERENCE),
}
FLOORS = {"number": 15_000, "formula": 6_000}  # grades a second on one core
CEILINGS = {"number": 50, "formula": 50}  # milliseconds
MEMORY = 64 * 2**20
BESIDE = """
import json, logging, sys, time
logging.disable(logging.CRITICAL)
from math_verify import parse, verify
parse("$1$")
for line in sys.stdin:
    case = json.loads(line)
    start = time.perf_counter()
    try:
        right = bool(verify(parse("$" + case["reference"].split(" ")[0] + "$"), parse(case["response"])))
    except Exception:
        right = None
    print(json.dumps([right, time.perf_counter() - start]), flush=True)
"""


def rate(job: Callable[[], object], seconds: float = 0.5) -> float:
    """Calls in a second of CPU time, the best of three rounds."""
    best = 0.0
    for _ in range(3):
        count, start = 0, time.process_time()
        while time.process_time() - start < seconds:
            for _ in range(50):
                job()
            count += 50
        best = max(best, count / (time.process_time() - start))
    return best


def once(job: Callable[[], object]) -> float:
    """Milliseconds of CPU time of one call."""
    start = time.process_time()
    job()
    return 1000 * (time.process_time() - start)


def speeds() -> dict[str, float]:
    print("grades a second on one core")
    found = {name: rate(job) for name, job in PLAIN.items()}
    for name, speed in found.items():
        floor = FLOORS.get(name.split(",")[0])
        bound = f"(at least {floor:,})" if floor else ""
        print(f"  {name:36} {speed:10,.0f}   {bound}".rstrip())
    print(f"  {PHASE:36} {fixed_loop():10.1f}")
    return found


def bounds() -> dict[str, float]:
    """The slowest of all hostile texts, the fastest of three tries each, and the most memory that one takes."""
    texts = {**hostile.giants(), **{f"random {i}": text for i, text in enumerate(hostile.strings(20_000, 1))}}
    jobs: dict[str, Callable[[str], object]] = {
        "number": lambda text: number(text, 9.8, "m/s^2", lenient=True),
        "formula": lambda text: formula(text, REFERENCE),
    }
    found: dict[str, float] = {}
    print(f"\nworst of {len(texts):,} hostile texts, CPU time")
    for kind, job in jobs.items():
        times = {name: min(once(partial(job, text)) for _ in range(3)) for name, text in texts.items()}
        worst = max(times, key=lambda name: times[name])
        found[kind] = times[worst]
        print(f"  {kind:36} {times[worst]:10.2f} ms   (at most {CEILINGS[kind]} ms): {worst}")
    tracemalloc.start()
    for name, text in texts.items():
        if not name.startswith("random"):
            for job in jobs.values():
                job(text)
    found["memory"] = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    print(f"  {'memory':36} {found['memory'] / 2**20:10.2f} MiB  (at most {MEMORY // 2**20} MiB)")
    return found


def beside(python: str | None) -> dict[str, object] | None:
    """Verdicts and times of both graders on the given numeric cases."""
    cases = [case for case in CASES if case["kind"] == "numeric" and case["expect"] != "no_crash"]
    print(f"\nbeside math-verify, {len(cases)} numeric cases with a verdict")
    if python is None:
        print("  skipped; it needs math-verify: python -m venv mv && mv/bin/pip install math-verify,")
        print("  then: python benchmarks/grading.py --math-verify mv/bin/python")
        return None
    lines = "".join(json.dumps(case) + "\n" for case in cases)
    done = subprocess.run([python, "-c", BESIDE], input=lines, capture_output=True, text=True, check=False)
    if done.returncode:
        print(f"  {python} has no working math-verify: {done.stderr.strip().splitlines()[-1]}")
        return None
    theirs = [json.loads(line) for line in done.stdout.splitlines()]
    ours = [(bool(grade(case).reward), once(partial(grade, case))) for case in cases]
    right = [case["expect"] == "correct" for case in cases]
    report: dict[str, object] = {}
    for name, verdicts, times in (
        ("sim2reason", [verdict for verdict, _ in ours], [spent for _, spent in ours]),
        ("math-verify", [verdict for verdict, _ in theirs], [1000 * spent for _, spent in theirs]),
    ):
        false_accepts = sum(bool(verdict) and not truth for verdict, truth in zip(verdicts, right, strict=True))
        false_refusals = sum(not verdict and truth for verdict, truth in zip(verdicts, right, strict=True))
        agreed = len(cases) - false_accepts - false_refusals
        print(
            f"  {name:12} agrees with the policy on {agreed:3} ({agreed / len(cases):.1%}); "
            f"false accepts {false_accepts}, false refusals {false_refusals}; "
            f"median {median(times):.3f} ms, worst {max(times):.1f} ms"
        )
        report[name] = {
            "agreed": agreed,
            "false_accepts": false_accepts,
            "false_refusals": false_refusals,
            "median_ms": median(times),
            "worst_ms": max(times),
        }
    pairs = zip(cases, ours, theirs, strict=True)
    apart = Counter(case["id"].split("-")[1] for case, (mine, _), (other, _) in pairs if mine != bool(other))
    print(f"  they agree with each other on {len(cases) - apart.total()} and differ in {dict(apart)}")
    print("  (math-verify compares to 6 digits and ignores units: the policy's 5 % and units are not its aim)")
    return report | {"differ": apart}


def main() -> int:
    arguments = parser(__doc__)
    arguments.add_argument("--math-verify", metavar="PYTHON", help="a Python that has math-verify")
    arguments.add_argument("--json", metavar="FILE", type=Path, help="write the figures here too")
    options = arguments.parse_args()
    if options.against:
        script_against(__file__, options.against, options.rounds)
        return 0
    if options.figures:
        print(json.dumps({name: rate(job) for name, job in PLAIN.items()} | {PHASE: fixed_loop()}))
        return 0
    report = {"speeds": speeds(), "bounds": bounds(), "beside": beside(options.math_verify)}
    if options.json:
        options.json.write_text(json.dumps(report, indent=2) + "\n", encoding="utf-8")
    fast = all(speed >= FLOORS.get(name.split(",")[0], 0.0) for name, speed in report["speeds"].items())
    bounded = all(report["bounds"][kind] <= limit for kind, limit in CEILINGS.items())
    return 0 if fast and bounded and report["bounds"]["memory"] <= MEMORY else 1


if __name__ == "__main__":
    sys.exit(main())
