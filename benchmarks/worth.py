"""What an answer hangs on: ``python benchmarks/worth.py [ITEMS] [SEED] [MODE,MODE]``.

Each prompt is read back into a scene and a question. Then every stated number is halved and doubled (angles are turned
by 10°), and every slip is made: how many numbers leave the answer where it is, and how many problems pay for a slip?
An approximation that holds is no slip, nor is what such answers by nature do not depend on. A second list of wrong
ideas, made independently (``wrong_ideas.py``), is tried, too: how many problems pay for one? How many answers are one
line, how many quantities are the same at other moments, and how many parts without bearing are not marked? The
prompts of those are printed.
"""

import sys
from collections import Counter

import numpy as np
from wrong_ideas import wrong_ideas

from sim2reason.datasets.plan import Config
from sim2reason.errors import TextError
from sim2reason.generation.filters import FILTERS, Candidate
from sim2reason.generation.filters.misconceptions import effects
from sim2reason.generation.filters.sensitivity import elasticities, givens, matters
from sim2reason.generation.item import Item
from sim2reason.generation.make import make
from sim2reason.generation.recipes import RECIPES, find_difficulty
from sim2reason.questions import MODES, Question
from sim2reason.questions.choices import ENDINGS
from sim2reason.questions.dependence import AnswerFunction
from sim2reason.questions.moments.times import AtStart
from sim2reason.questions.prompt import parse_prompt
from sim2reason.text.prose.description import describe

HIDDEN = np.random.default_rng(1)
SAME = 1e-3  # relative: an answer that a wrong idea changes by less does not hang on it
AT_ONCE = 1e-6  # of a time: what happens so close to a moment is what comes then


def candidate_of(item: Item) -> tuple[Candidate, frozenset[str]]:
    """The question of an item, from its text alone, with the numbers for symbols that travel with it.

    And the addresses of all numbers that the text tells: one on small oscillations leaves out the start.
    """
    formula, answer = item.answer.formula, item.answer.value
    parsed = parse_prompt(item.prompt, HIDDEN, formula.given() if formula is not None else {})
    query, given, unknown = parsed.query, parsed.asked.given, next(iter(parsed.reading.unknown), "")
    study, elasticity = parsed.study, 1.0
    question = Question(item.mode, query, "", answer, item.answer.unit, item.answer.sign, unknown, given)
    if given is not None and unknown:
        study = MODES[item.mode].study(question, study)
        elasticity = (AnswerFunction(query, study, unknown).rate(answer) or 0.0) * answer / given.value
        question = Question(item.mode, query, "", answer, item.answer.unit, "", unknown, given, elasticity)
    level, told = find_difficulty(item.difficulty), describe(study.scene, without=parsed.reading.without).told
    return Candidate(study, question, item.prompt, difficulty=level, tolerance=item.answer.tolerance), frozenset(told)


def is_idle(found: Candidate) -> bool:
    """Whether a quantity is within 2 % the same at nine instants on both sides of its moment, up to the next events."""
    query, trace = found.question.query, found.study.trace
    if query.target is None or query.moment is None or found.time is None or query.kind == "time_to_event":
        return False
    events = [event.time for event in trace.events if event.changes_motion and event.kind not in ENDINGS]
    if query.kind == "start" and (events or type(query.moment) is not AtStart):
        return False  # what comes later may differ, or it is asked of all the motion
    before = max((time for time in events if time < found.time * (1.0 - AT_ONCE)), default=0.0)
    after = min((time for time in events if time > found.time * (1.0 + AT_ONCE)), default=trace.stable_until)
    instants = np.append(np.linspace(before, found.time, 7)[1:-1], np.linspace(found.time, after, 6)[1:-1])
    if query.moment.sided is not None:
        instants = np.append(instants, [np.nextafter(found.time, 0.0), found.time])
    values = query.target.values(trace.sample(instants))
    return bool(np.all(np.abs(values - found.question.result) <= 0.02 * abs(found.question.result)))


class Count:
    """What was found so far."""

    def __init__(self) -> None:
        """Nothing."""
        self.items, self.stated, self.idle, self.cancelling, self.sound = 0, 0, 0, 0, 0
        self.paid, self.marked, self.ideas = Counter[str](), Counter[str](), Counter[str]()
        self.misled = self.paying = self.lines = self.idle_moments = self.unmarked = 0
        self.rows: dict[str, list[int]] = {}

    def add(self, item: Item) -> None:
        """One more."""
        try:
            found, told = candidate_of(item)
        except TextError as error:
            print(f"  {item.id} is not read: {error}\n{item.prompt}")
            return
        self.items += 1
        self._numbers(item, found, told)
        faults = [*self._slips(item, found), *self._ideas(item, found), *self._trivial(found)]
        for fault in faults:
            print(f"  {item.id}: {fault}")
        if faults:
            print(f"{item.prompt}\n  Answer: {item.answer.told}")

    def _slips(self, item: Item, found: Candidate) -> list[str]:
        """Those that are paid; and parts that could be taken away, though the item does not say so."""
        parts = [effect for effect in effects(found, part=True) if effect.change <= item.answer.tolerance]
        slips = [effect for effect in effects(found, part=False) if effect.change <= item.answer.tolerance]
        paid = [effect for effect in (*slips, *parts) if effect.simplification.misleads and effect.is_error]
        self.sound += sum(not effect.is_error for effect in slips)
        for effect in paid:
            (self.marked if item.idle else self.paid)[effect.simplification.name] += 1
        self.paying += bool(paid) and not item.idle
        self.unmarked += bool(parts) and not item.idle
        unmarked = {f"{effect.subject} has no bearing" for effect in parts if not item.idle}
        return [*(f"{e.simplification.name} {e.subject} pays ({e.change:.2g})" for e in paid), *unmarked]

    def _ideas(self, item: Item, found: Candidate) -> list[str]:
        """The wrong ideas of the second list that are paid, but for those about what the item marks as idle."""
        query = found.question.query
        spared = {query.subject, *(query.moment.subjects if query.moment is not None else ())}
        changes = {idea.name: found.change(idea.study) for idea in wrong_ideas(found.study, found.until, spared)}
        paid = {name: change for name, change in changes.items() if SAME < change <= item.answer.tolerance}
        self.ideas.update(name.partition(":")[0] for name in paid)
        self.misled += bool(paid) and not item.idle
        return [f"{name} pays ({change:.2g})" for name, change in paid.items()]

    def _trivial(self, found: Candidate) -> list[str]:
        line, idle = FILTERS["one line"].reason(found), is_idle(found)
        self.lines, self.idle_moments = self.lines + bool(line), self.idle_moments + idle
        return [*([line] if line else []), *(["the moment decorates"] if idle else [])]

    def _numbers(self, item: Item, found: Candidate, told: frozenset[str]) -> None:
        stated = [given for given in givens(found.study.scene, found.question.unknown) if given.owner != "world"]
        stated = [given for given in stated if told.issuperset(given.paths)]
        own = f"{found.question.query.subject}.mass"
        idle = [e.given for e in elasticities(found) if e.given in stated and not matters(found, e)]
        parts = [effect.subject for effect in effects(found, part=True) if effect.is_accepted]
        unmarked = [g for g in idle if not any(g.paths[0].startswith(f"{part}.") for part in parts)]
        self.cancelling += sum(own in given.paths for given in unmarked)
        for name in (item.recipe, item.difficulty, item.mode):
            row = self.rows.setdefault(name, [0, 0, 0])
            for place, more in enumerate((stated, unmarked, idle)):
                row[place] += len(more)
        self.stated, self.idle = self.stated + len(stated), self.idle + len(unmarked)


def main(items: int = 300, seed: int = 21, modes: str = "numeric") -> int:
    """Print the shares; exit code 1 if over 6 % of the numbers are idle, 3 % pay a wrong idea, or one is trivial."""
    config = Config(items=items, recipes=tuple(RECIPES), modes=tuple(modes.split(",")), seed=seed)
    count = Count()
    for position in range(items):
        item = make(config.request(position)).item
        if item is not None:
            count.add(item)
    print(f"{'recipe':16} stated  idle  idle with what is marked")
    for name, (stated, idle, every) in count.rows.items():
        print(f"{name:16} {stated:6} {idle / stated:5.1%} {every / stated:5.1%}")
    idle, paying = count.idle / count.stated, count.paying / count.items
    print(f"{count.items} items: {idle:.1%} of {count.stated} numbers idle ({count.cancelling} masses that cancel)")
    print(f"{count.lines} are one line, {count.idle_moments} have a moment that decorates")
    print(f"{count.unmarked} have a part without bearing that is not marked")
    print(f"{paying:.1%} pay a slip: {dict(count.paid.most_common())}; beside marked parts: {dict(count.marked)}")
    print(f"{count.misled} of {count.items} pay a wrong idea of the second list: {dict(count.ideas.most_common())}")
    print(f"{count.sound} times an approximation holds, or no root need be chosen")
    misled = count.misled / count.items
    return int(idle > 0.06 or max(paying, misled) > 0.03 or count.lines + count.idle_moments > 0)


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:3]), *sys.argv[3:4]))
