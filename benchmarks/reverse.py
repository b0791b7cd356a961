"""Whether a result fixes what is asked for: ``python benchmarks/reverse.py [ITEMS] [SEED]``.

Each prompt of the reverse mode is read back. The unknown is then looked for anew, by a plain scan of many values over
ten times the range that it is drawn from, either way, and to ten times the answer, and by bisection: wherever the
result that the prompt states, to the digits that it is stated with, comes out. All that is found must lie within 1 % of
the answer.
"""

import sys
import time
from collections import Counter
from collections.abc import Callable, Iterator
from itertools import pairwise

import numpy as np

from sim2reason.datasets.plan import Config
from sim2reason.errors import Sim2ReasonError, TextError
from sim2reason.generation.make import make
from sim2reason.generation.recipes import RECIPES
from sim2reason.questions import KINDS, SimulatedScene, Words
from sim2reason.questions.accuracy import StatedResult
from sim2reason.questions.moments.reached import Reached
from sim2reason.questions.prompt import ParsedPrompt, parse_prompt
from sim2reason.questions.unknown import range_of

VALUES = 300  # of the unknown, at most this far apart
INSTANTS = 4000  # of a motion, if the unknown is a time
HALVINGS = 40
LONGER = 2.0  # times the horizon of the scene, that a motion is followed for
RIGHT = 0.01  # relative

Function = Callable[[float], float | None]


def of_number(read: ParsedPrompt, path: str, answer: float) -> tuple[Function, np.ndarray]:
    """The result as a function of the unknown, and where to look."""
    scene, query = read.study.scene, read.query
    reach = range_of(scene, path, answer)
    low, high = reach[0], reach[-1]
    kind = KINDS[query.kind]
    answered = kind.loose_answer if query.hides else kind.answer  # each value of a limit is a search of its own

    def result(value: float) -> float | None:
        try:
            other = scene.having(path, value)
            for times in (1.0, LONGER):
                study = SimulatedScene.of(other, np.array([0.0, times * other.horizon]))
                found = answered(query, study)
                if found is not None:
                    return float(found)
        except (Sim2ReasonError, ValueError):
            return None
        return None

    return result, np.geomspace(low, high, VALUES) if low > 0.0 else np.linspace(low, high, VALUES)


def of_time(read: ParsedPrompt, moment: Reached) -> tuple[Function, np.ndarray]:
    """The quantity as a function of time, and until when it is followed."""
    scene = read.study.scene
    times = np.linspace(0.0, scene.horizon, INSTANTS)
    study = SimulatedScene.of(scene, times)

    def result(value: float) -> float | None:
        return moment.target.value(study.trace.sample(np.array([value])))

    return result, times[times <= study.trace.stable_until]


def hits(result: Function, values: np.ndarray, given: StatedResult) -> Iterator[float]:
    """Where the result is what is given: between two values, or at one of them as far as its digits tell."""
    found = list(sampled(result, values))
    for value, here in found:
        if here is not None and abs(here - given.value) <= given.half:
            yield value
    for (low, below), (high, above) in pairwise(found):
        if below is None or above is None or (below > given.value) == (above > given.value):
            continue
        inside = bisected(result, low, high, given.value)
        there = result(inside)
        if there is not None and abs(there - given.value) <= given.half:  # else it jumps
            yield inside


def sampled(result: Function, values: np.ndarray) -> Iterator[tuple[float, float | None]]:
    """The result at all values, and at the last ones that have one before others have none."""
    before: tuple[float, float | None] | None = None
    for value in map(float, values):
        here = value, result(value)
        if before is not None and (before[1] is None) != (here[1] is None):
            edge = last_with_one(result, *(before[0], value) if here[1] is None else (value, before[0]))
            yield edge, result(edge)
        yield here
        before = here


def last_with_one(result: Function, there: float, beyond: float) -> float:
    """How far from a value that has a result towards another that has none there is one."""
    for _ in range(HALVINGS):
        middle = 0.5 * (there + beyond)
        there, beyond = (there, middle) if result(middle) is None else (middle, beyond)
    return there


def bisected(result: Function, low: float, high: float, given: float) -> float:
    """Between two values with the given result between theirs; the lower one if none in between has it.

    Where values in the middle have no result, those before and those behind them are looked into.
    """
    first = (result(low) or 0.0) > given
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        found = result(middle)
        if found is None:
            before, behind = last_with_one(result, low, middle), last_with_one(result, high, middle)
            if ((result(before) or 0.0) > given) != first:
                high = before
            elif ((result(behind) or 0.0) > given) == first:
                low = behind
            else:
                return low
        else:
            low, high = (middle, high) if (found > given) == first else (low, middle)
    return 0.5 * (low + high)


def verdict(prompt: str, answer: float, rng: np.random.Generator) -> str:
    """What is wrong with an item; empty if its answer alone gives the result."""
    try:
        read = parse_prompt(prompt, rng)
    except TextError as error:
        return f"it is not read: {error}"
    given, moment = read.asked.given, read.query.moment
    if isinstance(moment, Reached):
        result, values = of_time(read, moment)
        found = list(hits(result, values, moment.given))[:1]  # the first time is asked for
    elif given is None:
        return "it states no result"
    else:
        words = Words.of(read.scene, read.reading.mentions, read.reading.unknown)
        unknowns = [found for found in words.unknowns if found.path != read.query.hides]
        if len(unknowns) != 1:
            return f"it leaves {len(unknowns)} numbers unknown"
        result, values = of_number(read, unknowns[0].path, answer)
        found = list(hits(result, values, given))
    if not found:
        return "nothing gives the result"
    wrong = [value for value in found if abs(value - answer) > RIGHT * abs(answer)]
    return f"{wrong[0]:.6g} gives the result, too" if wrong else ""


def main(items: int = 100, seed: int = 17) -> int:
    """Print every item whose answer is not the only one; exit code 1 if there is any."""
    config = Config(items=items, recipes=tuple(RECIPES), modes=("reverse",), seed=seed)
    asked, wrong, missing, spent = 0, 0, Counter[str](), 0.0
    for position in range(items):
        request = config.request(position)
        begin = time.process_time()
        item = make(request).item
        spent += time.process_time() - begin
        if item is None:
            missing[f"{request.recipe} {request.difficulty}"] += 1
            continue
        asked += 1
        found = verdict(item.prompt, item.answer.value, np.random.default_rng(position))
        if found:
            wrong += 1
            print(f"{item.id}: {found}; the answer is {item.answer.value:.6g}\n  {item.prompt}")
    print(f"{asked - wrong} of {asked} unknowns are recovered and unique; {asked / spent:.1f} items made a CPU-second")
    if missing:
        print("no item:", ", ".join(f"{cell} ({count})" for cell, count in missing.items()))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:])))
