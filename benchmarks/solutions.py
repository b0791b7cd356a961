"""Worked solutions of drawn problems: ``python benchmarks/solutions.py [ITEMS] [SEED] [RECIPE,RECIPE] [MODE]``.

For each recipe how many have a derivation, how many an integration alone, how many a fault, and why others have none;
where two strategies answer one item, whether they agree; what the text alone says, and how many planted faults it
shows; how long it takes.
"""

import random
import re
import sys
import time
from collections import Counter, defaultdict
from statistics import median

from sim2reason.datasets.item_search import ItemSearch
from sim2reason.datasets.plan import Request
from sim2reason.recipes import DIFFICULTIES, RECIPES
from sim2reason.solutions import STRATEGIES, Setting, Solution, by, solve
from sim2reason.solutions.book import WELL
from sim2reason.solutions.check import SEEN, WORDS, faults, words
from sim2reason.solutions.reading import read
from sim2reason.solutions.reverse import forward

AGREED = 1e-9  # relative
SIGN, NUMBER = re.compile(r" [+-] (?=[^$]*\$)"), re.compile(r"\d+\.\d{2,}")
DERIVED = [strategy for strategy in STRATEGIES.values() if not strategy.integrates]


def problem(recipe: str, difficulty: str, mode: str, seed: int, index: int) -> Setting | None:
    found = ItemSearch(Request(recipe, difficulty, mode, seed, index)).found()
    return None if found is None else Setting.of(found.question, found.study, found.candidate.words, found.description)


def planted(text: str, rng: random.Random) -> list[tuple[str, str]]:
    """The text with one number 7 % larger, and with one sign turned."""
    found: list[tuple[str, str]] = []
    for kind, pattern in (("numbers", NUMBER), ("signs", SIGN)):
        held = list(pattern.finditer(text))
        if held:
            at = rng.choice(held)
            if kind == "numbers":
                put = f"{1.07 * float(at[0]):.{len(at[0].split('.')[1])}f}"
            else:
                put = " - " if "+" in at[0] else " + "
            found.append((kind, text[: at.start()] + put + text[at.end() :]))
    return found


def disagreement(setting: Setting) -> tuple[int, bool]:
    """How many strategies derive an answer, and whether two of them differ."""
    held = [solution.answer for strategy in DERIVED if (solution := by(strategy, setting)).answer is not None]
    return len(held), any(abs(one - held[0]) > AGREED * abs(held[0]) for one in held[1:])


def main(items: int = 200, seed: int = 1, recipes: str = "", mode: str = "numeric") -> int:
    """Print the figures; exit code 1 if a solution has a fault, or two strategies disagree."""
    names = recipes.split(",") if recipes else list(RECIPES)
    count: dict[str, Counter[str]] = defaultdict(Counter)
    why, said, times, rng = Counter[tuple[str, str, str]](), Counter[str](), list[float](), random.Random(seed)
    for number in range(items):
        recipe, difficulty = names[number % len(names)], DIFFICULTIES[number // len(names) % len(DIFFICULTIES)]
        setting = problem(recipe, difficulty, mode, seed, number // len(names))
        if setting is None:
            continue
        begin = time.process_time()
        solution = solve(setting)
        times.append(time.process_time() - begin)
        if solution.answer is None:
            count[recipe]["none"] += 1
            why[recipe, setting.query.kind, solution.reason[:160]] += 1
            continue
        setting = forward(setting)
        wrong = faults(solution, setting.answer, SEEN.get(setting.query.kind, WELL))
        several, differ = disagreement(setting)
        said += Counter({"two strategies": several > 1, "that disagree": differ})
        count[recipe]["faulty" if wrong else solution.strategy] += 1
        for fault in wrong:
            print(f"{recipe} {difficulty} {setting.query.kind} {number}: {fault}")
        _reading(solution, difficulty, said, rng)
    _tell(names, count, why, said, times)
    return 1 if any(found["faulty"] for found in count.values()) or said["that disagree"] else 0


def _reading(solution: Solution, difficulty: str, said: Counter[str], rng: random.Random) -> None:
    reading = read(solution.text)
    said.update(equalities=len(reading.equalities), unread=len(reading.unread), broken=len(reading.broken))
    said["too long"] += words(solution.text) > WORDS[difficulty]
    for kind, text in planted(solution.text, rng):
        spoiled = read(text)
        said[f"planted {kind}"] += 1
        said[f"caught {kind}"] += bool(spoiled.broken or spoiled.unread)


def _tell(
    names: list[str],
    count: dict[str, Counter[str]],
    why: Counter[tuple[str, str, str]],
    said: Counter[str],
    times: list[float],
) -> None:
    for recipe in names:
        print(f"{recipe:16} {dict(count[recipe])}")
    for held, times_said in why.most_common(40):
        print(f"{times_said:4} {': '.join(held)}")
    print(f"{dict(said)}; CPU median {1e3 * median(times):.1f} ms, greatest {1e3 * max(times):.0f} ms")


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:3]), *sys.argv[3:]))
