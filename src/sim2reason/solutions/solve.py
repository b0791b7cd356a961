"""From a query about a scene to its worked solution."""

from dataclasses import replace

from sim2reason.solutions.book import Book, Relation, Solution, Step, UnsolvedError
from sim2reason.solutions.expressions import Number, Symbol
from sim2reason.solutions.lexicon import UnreadError
from sim2reason.solutions.setting import Setting, joined
from sim2reason.solutions.strategies import STRATEGIES, Strategy


def solve(setting: Setting) -> Solution:
    """The worked solution by the cheapest strategy that finds one; else one that says why there is none."""
    reasons: list[str] = []
    try:
        _ = setting.lexicon
    except UnreadError as error:
        return Solution("", reason=str(error))
    for strategy in sorted(STRATEGIES.values(), key=lambda held: held.cost):
        found = by(strategy, setting)
        if found.answer is not None:
            return found
        reasons.append(f"{strategy.name}: {found.reason}")
    return Solution("", reason="; ".join(reasons) or "no strategy applies")


def by(strategy: Strategy, setting: Setting) -> Solution:
    """The solution by one strategy, without an answer where it finds none."""
    refused = strategy.refusal(setting)
    if refused:
        return Solution(strategy.name, reason=refused)
    book = Book()
    for given in setting.lexicon.givens.values():
        book.reserve(given.symbol)
        book.know(given.symbol, given.value)
    try:
        goal = strategy.write(setting, book)
    except UnsolvedError as error:
        return Solution(strategy.name, reason=str(error))
    steps = _needed(book.steps, goal)
    steps = [_givens(setting, book, steps), *steps]
    unit = book.units.get(goal, "")
    return Solution(strategy.name, tuple(steps), book.observed | book.values, book.units, goal, book.values[goal], unit)


def _needed(steps: list[Step], goal: str) -> list[Step]:
    """The steps that lead to the goal; laws and names always, results only if something rests on them."""
    source = {name: step.id for step in steps for name in step.gives}
    kept: set[int] = set()
    waiting = [source[goal]] if goal in source else []
    while waiting:
        number = waiting.pop()
        if number not in kept:
            kept.add(number)
            waiting += steps[number].needs
    return [step for step in steps if step.id in kept or not step.gives]


def _givens(setting: Setting, book: Book, steps: list[Step]) -> Step:
    """What the solution takes from the text."""
    used = {name for step in steps for relation in step.relations for name in relation.symbols()}
    said: list[str] = []
    relations: list[Relation] = []
    for given in setting.lexicon.givens.values():
        if given.symbol in used:
            said.append(f"${given.symbol} = {given.latex}$")
            relations.append(Relation(Symbol(given.symbol), Number(given.value), "given"))
    for name, text in book.stated.items():
        if name in used:
            said.append(f"${name} = {text}$")
            relations.append(Relation(Symbol(name), Number(book.values[name]), "given"))
    return Step(-1, "givens", f"Given: {joined(said)}." if said else "", tuple(relations), (), ())


def renumbered(solution: Solution) -> Solution:
    """The same with steps counted from zero."""
    place = {step.id: number for number, step in enumerate(solution.steps)}
    steps = tuple(
        replace(step, id=number, needs=tuple(place[n] for n in step.needs if n in place))
        for number, step in enumerate(solution.steps)
    )
    return replace(solution, steps=steps)
