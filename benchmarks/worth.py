"""What an answer hangs on: ``python benchmarks/worth.py [ITEMS] [SEED]``.

Each prompt is read back into a scene and a question. Then every stated number is halved and doubled (angles are turned
by 10°), and every slip is made: how many numbers leave the answer where it is, and how many problems pay for a slip?
How many answers are one line, and how many quantities are the same at other moments?
"""

import sys
from collections import Counter

import numpy as np

from sim2reason.datasets.item import Item
from sim2reason.datasets.make import make
from sim2reason.datasets.plan import Config
from sim2reason.filters import Candidate
from sim2reason.filters.parts.effects import effects
from sim2reason.filters.parts.numbers import elasticities, givens, matters
from sim2reason.filters.parts.products import product_of
from sim2reason.questions import Question
from sim2reason.questions.constancy import ENDINGS
from sim2reason.questions.moments.at_start import AtStart
from sim2reason.questions.parse_prompt import parse_prompt
from sim2reason.recipes import RECIPES, known

HIDDEN = np.random.default_rng(1)


def candidate_of(item: Item) -> Candidate:
    """The question of an item, from its text alone."""
    parsed = parse_prompt(item.prompt, HIDDEN)
    question = Question(item.mode, parsed.query, "", item.answer.value, item.answer.unit, item.answer.sign)
    difficulty = known(item.difficulty)
    return Candidate(parsed.study, question, item.prompt, difficulty=difficulty, tolerance=item.answer.tolerance)


def is_idle(found: Candidate) -> bool:
    """Whether a quantity is within 2 % the same at nine instants of the whole stretch between the events around it."""
    query, trace = found.question.query, found.study.trace
    if query.target is None or query.moment is None or found.time is None or query.kind == "time_to_event":
        return False
    events = [event.time for event in trace.events if event.kind not in {"turn", *ENDINGS}]
    if query.kind == "start" and (events or type(query.moment) is not AtStart):
        return False  # what comes later may differ, or it is asked of all the motion
    before = max((time for time in events if time < found.time * (1.0 - 1e-9)), default=0.0)
    after = min((time for time in events if time > found.time * (1.0 + 1e-9)), default=trace.stable_until)
    instants = np.linspace(before, after, 11)[1:-1]
    if query.moment.sided is not None:
        instants = np.append(instants, [np.nextafter(found.time, 0.0), found.time])
    values = query.target.values(trace.sample(instants))
    return bool(np.all(np.abs(values - found.question.result) <= 0.02 * abs(found.question.result)))


class Count:
    """What was found so far."""

    def __init__(self) -> None:
        """Nothing."""
        self.items, self.stated, self.idle, self.cancelling = 0, 0, 0, 0
        self.paid, self.marked = Counter[str](), Counter[str]()
        self.paying = self.lines = self.idle_moments = 0
        self.by_recipe: dict[str, list[int]] = {}

    def add(self, item: Item) -> None:
        """One more."""
        found = candidate_of(item)
        self.items += 1
        self._numbers(item, found)
        every = [*effects(found, part=False), *effects(found, part=True)]
        paid = [e for e in every if e.simplification.misleads and e.change <= item.answer.tolerance]
        aside = bool(item.idle)
        for effect in paid:
            (self.marked if aside else self.paid)[effect.simplification.name] += 1
            print(f"  {item.id}: {effect.simplification.name} {effect.subject} pays ({effect.change:.2g})")
        self.paying += bool(paid) and not aside
        self._trivial(item, found)

    def _trivial(self, item: Item, found: Candidate) -> None:
        line = product_of(found) if not found.kind.measured(found.question.query).whole else ""
        idle = is_idle(found)
        self.lines, self.idle_moments = self.lines + bool(line), self.idle_moments + idle
        if line or idle:
            print(f"  {item.id}: {line or 'the moment decorates'}")

    def _numbers(self, item: Item, found: Candidate) -> None:
        stated = [given for given in givens(found.study.scene) if given.owner != "world"]
        own = f"{found.question.query.subject}.mass"
        idle = [e.given for e in elasticities(found) if e.given in stated and not matters(found, e)]
        parts = [effect.subject for effect in effects(found, part=True) if effect.close]
        unmarked = [g for g in idle if not any(g.paths[0].startswith(f"{part}.") for part in parts)]
        row = self.by_recipe.setdefault(item.recipe, [0, 0, 0])
        self.cancelling += sum(own in given.paths for given in unmarked)
        row[0] += len(stated)
        row[1] += len(unmarked)
        row[2] += len(idle)
        self.stated, self.idle = self.stated + len(stated), self.idle + len(unmarked)


def main(items: int = 300, seed: int = 21) -> int:
    """Print the shares; exit code 1 if over 6 % of the numbers are idle, 3 % pay a slip, or one is trivial."""
    config, count = Config(items=items, recipes=tuple(RECIPES), seed=seed), Count()
    for position in range(items):
        item = make(config.request(position)).item
        if item is not None:
            count.add(item)
    print(f"{'recipe':16} stated  idle  idle with what is marked")
    for recipe, (stated, idle, every) in sorted(count.by_recipe.items()):
        print(f"{recipe:16} {stated:6} {idle / stated:5.1%} {every / stated:5.1%}")
    idle, paying = count.idle / count.stated, count.paying / count.items
    print(f"{count.items} items: {idle:.1%} of {count.stated} numbers idle ({count.cancelling} masses that cancel)")
    print(f"{count.lines} are one line, {count.idle_moments} have a moment that decorates")
    print(f"{paying:.1%} pay a slip: {dict(count.paid.most_common())}; beside marked parts: {dict(count.marked)}")
    return int(idle > 0.06 or paying > 0.03 or count.lines + count.idle_moments > 0)


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:])))
