"""Worked solutions of drawn problems.

Usage: ``python benchmarks/solutions.py [ITEMS] [SEED] [RECIPES] [MODES] [UNITS] [KEPT]``.

Of a problem of several parts each part is looked at by itself, as `part_solutions` solves it.
For each recipe how many have a derivation, how many an integration alone, how many a fault, and why others have none.
Then every line of the bar, figure against bar, by difficulty: how many have a solution, whether answers, relations and
five-digit arithmetic hold, whether two strategies agree, what the text alone says, how many planted faults it shows
(each number 7 % larger, each sign turned, a few of each text), whether it is graded right as an answer, how long it is,
and how long it takes. Each solution is recomputed from its data, in which then faults are planted: how many of each
kind are refused; `sim2reason.testing.planted_faults` says how they are counted. With `events` for KEPT, ITEMS
hard problems are looked at in which an event, such as a collision, precedes what is asked.
"""

import random
import re
import sys
import time
from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from itertools import count as counted
from itertools import islice
from statistics import median

from sim2reason.datasets.grade import grade
from sim2reason.generation.certified import part_solutions, worked_solution
from sim2reason.generation.item import Item
from sim2reason.generation.item_search import ItemSearch
from sim2reason.generation.make import build_item
from sim2reason.generation.recipes import RECIPES
from sim2reason.generation.request import SI, Request
from sim2reason.questions.difficulty import DIFFICULTIES
from sim2reason.solutions import STRATEGIES, ProblemContext, Solution, solve, solve_with
from sim2reason.solutions.checking import recompute
from sim2reason.solutions.data import as_data
from sim2reason.solutions.multipart import results_of
from sim2reason.solutions.reverse import forward
from sim2reason.solutions.solution import ANSWER_RTOL, RELATION_RTOL
from sim2reason.solutions.verification import verification_fault
from sim2reason.testing.planted_faults import KINDS, planted_faults
from sim2reason.testing.solution_text import read
from sim2reason.testing.solution_verification import RTOL_BY_KIND, WORDS, faults, words

AGREED = 1e-9  # relative
EVENTS = "events"
PLANTED = 6  # of each kind in one text
SIGN, NUMBER = re.compile(r" [+-] (?=[^$]*\$)"), re.compile(r"\d+\.\d{2,}")
LETTER = re.compile(r"That is option \$\\boxed\{\\text\{[A-Z]\}\}\$\.")  # a sentence without an equation
DERIVED = [strategy for strategy in STRATEGIES.values() if not strategy.integrates]
SHARES = {  # what is counted, of what, and at least how much of it
    "have a solution": ("solved", "asked", 0.99),
    "are derived": ("derived", "solved", 0.0),
    "without a fault of the checks": ("sound", "solved", 1.0),
    "two strategies agree": ("agree", "several", 1.0),
    "second derivations without a fault": ("others that are sound", "others", 1.0),
    "equalities read and right": ("right", "equalities", 0.98),
    "planted numbers caught": ("caught numbers", "planted numbers", 0.95),
    "planted signs caught": ("caught signs", "planted signs", 0.95),
    "graded right": ("graded", "solved", 1.0),
    "short enough": ("short", "solved", 1.0),
    "recomputed from their data": ("recomputed", "solved", 1.0),
    **{f"refused: {kind}": (f"refused: {kind}", f"planted: {kind}", 0.99) for kind in KINDS},
}
MEDIAN, WORST = 0.1, 1.0  # s of CPU


@dataclass
class Tally:
    """Counts and times of the solutions of one difficulty."""

    count: Counter[str] = field(default_factory=Counter[str])
    times: list[float] = field(default_factory=list[float])
    lengths: list[int] = field(default_factory=list[int])
    checks: list[float] = field(default_factory=list[float])

    def lines(self, difficulty: str) -> Iterator[tuple[str, str, str, bool]]:
        """Each line of the bar: what it is about, the figure, the bar, and whether it is kept."""
        for said, (part, whole, least) in SHARES.items():
            held, of = self.count[part], self.count[whole]
            yield said, f"{held} of {of}", f"{least:.0%}", held >= least * of
        if self.lengths:
            yield "words, median", f"{median(self.lengths):.0f}", "", True
            yield "words, most", f"{max(self.lengths)}", f"{WORDS[difficulty]}", max(self.lengths) <= WORDS[difficulty]
            middle = median(self.times)
            yield "CPU, median", f"{1e3 * middle:.1f} ms", f"{1e3 * MEDIAN:g} ms", middle <= MEDIAN
            yield "CPU, most", f"{1e3 * max(self.times):.0f} ms", f"{WORST:g} s", max(self.times) <= WORST
            yield "CPU of the check, median", f"{1e3 * median(self.checks):.1f} ms", "", True
            yield "CPU of the check, most", f"{1e3 * max(self.checks):.0f} ms", "", True


@dataclass(frozen=True)
class Solved:
    """A question with its worked solution: a problem, or one part of a problem of several parts."""

    item: Item
    setting: ProblemContext
    solution: Solution
    whole: str  # the text that is graded as an answer to the problem
    earlier: Mapping[str, float]  # the answers to earlier parts by name


def requests(seed: int, recipes: list[str], modes: list[str], units: str, kept: str) -> Iterator[Request]:
    """Yield requests without end: recipes in turn, then difficulties, then modes."""
    difficulties = ("hard",) if kept == EVENTS else DIFFICULTIES
    for number in counted():
        index, at = divmod(number, len(recipes))
        difficulty, mode = difficulties[index % len(difficulties)], modes[index // len(difficulties) % len(modes)]
        yield Request(recipes[at], difficulty, mode, seed, index, units=units)


def problems(requested: Iterator[Request], kept: str) -> Iterator[list[Solved]]:
    """Yield the parts of each requested problem; with `EVENTS`, only of problems in which an event precedes a part."""
    for request in requested:
        held = list(solved(request))
        if kept != EVENTS or any(forward(part.setting).earlier_event_kinds for part in held):
            yield held


def solved(request: Request) -> Iterator[Solved]:
    """Yield the problem of a request with its solution as the text asks for it; each part by itself if it has parts."""
    found = ItemSearch(request).find()
    if found is None:
        return
    item, solution = build_item(request, found), worked_solution(request, found)
    if not found.parts:
        yield Solved(item, found.setting, solution, solution.text, {})
        return
    parts = part_solutions(request, found) if solution.answer is not None else [solution] * len(found.parts)
    for number, (part, held) in enumerate(zip(found.parts, parts, strict=True)):
        yield Solved(item, part.certified.setting, held, solution.text, results_of(parts[:number]))


def planted(text: str, rng: random.Random) -> Iterator[tuple[str, str]]:
    """The text with one number 7 % larger, or with one sign turned."""
    for kind, pattern in (("numbers", NUMBER), ("signs", SIGN)):
        held = list(pattern.finditer(text))
        for at in rng.sample(held, min(PLANTED, len(held))):
            if kind == "numbers":  # two more digits, so that it is another number
                put = f"{1.07 * float(at[0]):.{len(at[0].split('.')[1]) + 2}f}"
            else:
                put = " - " if "+" in at[0] else " + "
            yield kind, text[: at.start()] + put + text[at.end() :]


def derivations(setting: ProblemContext) -> list[Solution]:
    """The derivations by all strategies that apply."""
    return [solution for strategy in DERIVED if (solution := solve_with(strategy, setting)).answer is not None]


def differ(held: list[Solution]) -> bool:
    """Return whether two derivations lead to different answers."""
    answers = [solution.answer for solution in held if solution.answer is not None]
    return any(abs(one - answers[0]) > AGREED * abs(answers[0]) for one in answers[1:])


def main(
    items: int = 200, seed: int = 1, recipes: str = "", modes: str = "numeric", units: str = SI, kept: str = ""
) -> int:
    """Print the figures; exit code 1 if a line of the bar is not kept."""
    names = recipes.split(",") if recipes else list(RECIPES)
    outcomes: dict[str, Counter[str]] = defaultdict(Counter)
    why, rng = Counter[tuple[str, str, str]](), random.Random(seed)
    tallies = {difficulty: Tally() for difficulty in DIFFICULTIES}
    drawn = islice(problems(requests(seed, names, modes.split(","), units, kept), kept), items)
    for held in (part for parts in drawn for part in parts):
        recipe, tally, setting = held.item.recipe, tallies[held.item.difficulty], held.setting
        begin = time.process_time()
        solve(setting)
        tally.times.append(time.process_time() - begin)
        tally.count["asked"] += 1
        if held.solution.answer is None:
            outcomes[recipe]["none"] += 1
            why[recipe, setting.query.kind, held.solution.reason[:160]] += 1
            continue
        wrong = [*_wrong(held, tally), *_reading(held.item, held.solution, tally, rng)]
        wrong += _recomputed(held, tally, rng)
        outcomes[recipe]["faulty" if wrong else held.solution.strategy] += 1
        for fault in wrong:
            print(f"{held.item.id} {setting.query.kind}: {fault}", flush=True)
    for recipe in names:
        print(f"{recipe:16} {dict(outcomes[recipe])}")
    for held, times_said in why.most_common(40):
        print(f"{times_said:4} {': '.join(held)}")
    return _tell(tallies)


def _wrong(solved: Solved, tally: Tally) -> Iterator[str]:
    """Yield what checks, other strategies and the grader find wrong with a solution."""
    setting, solution = forward(solved.setting), solved.solution
    assert setting.answer is not None
    near = RTOL_BY_KIND.get(setting.query.kind, RELATION_RTOL)
    found, held = faults(solution, setting.answer, near), derivations(setting)
    others = [other for other in held if other.strategy != solution.strategy]
    amiss = {other.strategy: _but_for_length(faults(other, setting.answer, near)) for other in others}
    graded = grade(solved.item, solved.whole)
    tally.count.update(
        solved=1,
        derived=solution.derived,
        sound=not found,
        several=len(held) > 1,
        agree=len(held) > 1 and not differ(held),
        others=len(others),
        **{"others that are sound": sum(not told for told in amiss.values())},
        graded=graded.reward == 1.0,
    )
    yield from found
    yield from (f"by {name}: {fault}" for name, told in amiss.items() for fault in told)
    if differ(held):
        yield "two strategies disagree"
    if graded.reward != 1.0:
        yield f"graded {graded}"


def _but_for_length(told: list[str]) -> list[str]:
    """Return the faults of a derivation apart from its length, which may be great where a shorter one is shown."""
    return [fault for fault in told if not fault.startswith("superfluous")]


def _reading(item: Item, solution: Solution, tally: Tally, rng: random.Random) -> Iterator[str]:
    """Yield what is wrong with the text alone; of a problem in symbols, read at its own numbers."""
    known = item.answer.formula.points[0] if item.answer.formula is not None else {}
    shown = LETTER.sub("", solution.text)
    difficulty, reading, size = item.difficulty, read(shown, known), words(shown)
    said = len(reading.equalities) + len(reading.sums) + len(reading.unread)
    wrong = [*reading.broken, *reading.unread]
    tally.lengths.append(size)
    tally.count.update(equalities=said, right=said - len(wrong), short=size <= WORDS[difficulty])
    yield from (f"in the text: {line}" for line in wrong)
    if size > WORDS[difficulty]:
        yield f"{size} words"
    for kind, text in planted(shown, rng):
        spoiled = read(text, known)
        caught = bool(spoiled.broken or spoiled.unread)
        tally.count.update({f"planted {kind}": 1, f"caught {kind}": caught})


def _recomputed(solved: Solved, tally: Tally, rng: random.Random) -> Iterator[str]:
    """Yield what is wrong when a solution is recomputed from its data, and count which planted faults are refused."""
    setting = forward(solved.setting)
    assert setting.answer is not None
    begin, data = time.process_time(), as_data(solved.solution)
    found = recompute(data)
    tally.checks.append(time.process_time() - begin)
    tally.count.update(recomputed=found.agrees(setting.answer, ANSWER_RTOL))
    yield from (f"recomputed: {fault}" for fault in found.faults)
    if reason := verification_fault(data, setting, solved.earlier):
        yield f"refused: {reason}"
    for kind, spoiled in planted_faults(data, found.values, rng, PLANTED):
        tally.count.update(
            {f"planted: {kind}": 1, f"refused: {kind}": bool(verification_fault(spoiled, setting, solved.earlier))}
        )


def _tell(tallies: dict[str, Tally]) -> int:
    """Print each line of the bar; 1 if one is not kept."""
    missed = False
    for difficulty, tally in tallies.items():
        print(f"\n{difficulty}")
        for said, figure, bar, kept in tally.lines(difficulty):
            missed = missed or not kept
            print(f"  {said:32} {figure:>14} {'bar ' + bar if bar else '':12} {'' if kept else 'MISSED'}".rstrip())
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:3]), *sys.argv[3:]))
