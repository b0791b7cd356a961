"""Worked solutions of drawn problems: ``python benchmarks/solutions.py [ITEMS] [SEED] [RECIPE,RECIPE]``.

For each recipe how many have one, how many have a fault, and why others have none; what the text alone says; how long.
"""

import sys
import time
from collections import Counter, defaultdict
from statistics import median

from sim2reason.datasets.question_search import QuestionSearch
from sim2reason.datasets.random_scenes import generator
from sim2reason.errors import SceneError, SimulationError, UnsupportedError
from sim2reason.questions import MODES
from sim2reason.recipes import DIFFICULTIES, RECIPES, known
from sim2reason.solutions import Setting, solve
from sim2reason.solutions.check import WORDS, faults, words
from sim2reason.solutions.reading import read

TRIES = 40
KINDS = ("start", "state", "event", "time_to_event")  # that strategies have a way to


def problem(recipe: str, difficulty: str, seed: int, index: int) -> Setting | None:
    for attempt in range(TRIES):
        rng = generator("worked", recipe, difficulty, seed, index, attempt)
        try:
            search = QuestionSearch(RECIPES[recipe](known(difficulty), rng), int(rng.random() * 2**31))
            found = search.ask(MODES["numeric"], rng, Counter(), KINDS[attempt % len(KINDS)])
        except (SceneError, SimulationError, UnsupportedError):
            continue
        if found is not None:
            query = found.question.query
            return Setting(search.study.scene, search.words, search.description.symbols, search.study, query)
    return None


def main(items: int = 200, seed: int = 1, recipes: str = "") -> int:
    """Print the figures; exit code 1 if a solution has a fault."""
    names = recipes.split(",") if recipes else list(RECIPES)
    count, why, times = defaultdict(Counter), Counter(), []
    said = Counter()
    for number in range(items):
        recipe, difficulty = names[number % len(names)], DIFFICULTIES[number // len(names) % len(DIFFICULTIES)]
        setting = problem(recipe, difficulty, seed, number)
        if setting is None:
            continue
        begin = time.process_time()
        solution = solve(setting)
        times.append(time.process_time() - begin)
        if solution.answer is None:
            count[recipe]["none"] += 1
            why[recipe, solution.reason[:160]] += 1
            continue
        wrong = faults(solution, setting.answer)
        count[recipe]["faulty" if wrong else solution.strategy] += 1
        for fault in wrong:
            print(f"{recipe} {difficulty} {number}: {fault}")
        reading = read(solution.text)
        said += Counter(equalities=len(reading.equalities), unread=len(reading.unread), broken=len(reading.broken))
        said["too long"] += words(solution.text) > WORDS[difficulty]
    for recipe in names:
        print(f"{recipe:16} {dict(count[recipe])}")
    for (recipe, reason), times_said in why.most_common(40):
        print(f"{times_said:4} {recipe}: {reason}")
    print(f"{dict(said)}; CPU median {1e3 * median(times):.1f} ms, greatest {1e3 * max(times):.0f} ms")
    return 1 if any(found["faulty"] for found in count.values()) else 0


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:3]), *sys.argv[3:]))
