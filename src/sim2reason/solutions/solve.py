"""The search for the worked solution of a query about a scene."""

import re
from collections.abc import Mapping
from collections.abc import Set as AbstractSet
from dataclasses import replace
from math import radians

import numpy as np

from sim2reason.questions import KINDS, SimulatedScene
from sim2reason.questions.difficulty import ELEMENTARY, Need
from sim2reason.questions.prompt import ParsedPrompt, parse_prompt
from sim2reason.questions.words import Words
from sim2reason.solutions.algebra.evaluated import is_special, numeric_parts
from sim2reason.solutions.algebra.expressions import Number, Symbol
from sim2reason.solutions.closed_forms.symbolic_answers import needs_modulus, with_final_algebra
from sim2reason.solutions.equivalent_questions import number_unit, write_reason
from sim2reason.solutions.laws.strings_and_pulleys import after_what_they_rest_on
from sim2reason.solutions.multipart.names import rename_solution
from sim2reason.solutions.opposite_sign import states_only_magnitude
from sim2reason.solutions.reverse import Inversion, forward
from sim2reason.solutions.setting import ProblemContext, join_words
from sim2reason.solutions.solution import ANSWER_RTOL, Relation, Solution, Step
from sim2reason.solutions.strategies import STRATEGIES, Strategy, applicable_strategies, strategies_for_kind
from sim2reason.solutions.verification import verify_solution
from sim2reason.solutions.writing.arrangement import SOLVE_KIND, group_steps, in_order, merge_steps, without_repeats
from sim2reason.solutions.writing.lexicon import UnreadError
from sim2reason.solutions.writing.notation import DEGREES
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError
from sim2reason.text.prose.phrases import Names
from sim2reason.text.prose.voices import numeric
from sim2reason.text.prose.writer import Writer

TIME = re.compile(r"t(?:_(?:(\d)|\{(\d+)\}))?")  # the symbol t, with its number if it has one


def solve(setting: ProblemContext, *, derived: bool = False, checked: bool = True) -> Solution:
    """Return the worked solution with the simplest mathematics; if no strategy succeeds, one with only the reason.

    The first by cost with elementary needs is taken, if there is one. A solution is accepted if its answer can be
    recomputed from its data. With `derived`, only strategies that lead to formulas are tried; their solutions are
    compared with simulated motions instead of shown. Without `checked`, nothing is recomputed.
    """
    reasons: list[str] = []
    best: Solution | None = None
    setting = forward(setting)
    try:
        _ = setting.lexicon
    except UnreadError as error:
        return Solution("", reason=str(error))
    if not any(setting.query.kind in strategy.kinds for strategy in STRATEGIES.values()):
        return Solution("", reason=f"no strategy applies: none has a way to the kind {setting.query.kind}")
    for strategy in strategies_for_kind(setting.query.kind, setting.mechanism, derived=derived):
        if strategy.least_need > setting.most:
            continue
        if strategy.integrates and (best is not None or setting.most < Need.INTEGRATION):
            continue
        solution = _solve_cached(strategy, setting, derived=derived)
        if solution.answer is not None and best is not None and solution.needs >= best.needs:
            continue
        solution = verify_solution(solution, setting) if checked and not derived else solution
        if solution.answer is None:
            reasons += [f"{strategy.name}: {solution.reason}"] if solution.applies else []
        elif solution.needs <= ELEMENTARY:
            return solution
        elif best is None or solution.needs < best.needs:
            best = solution
    return best or Solution("", reason="; ".join(reasons) or "no strategy has a way to the question")


def _solve_cached(strategy: Strategy, setting: ProblemContext, *, derived: bool) -> Solution:
    """Return the worked solution of a question by one strategy, from the cache if possible.

    The solution of a derivation is cached with the motion, and reused by the search for the shortest solution of the
    same query unless its mathematics is too advanced. A solution to be shown is always written anew, in its own names.
    """
    key, study = ("derived by", strategy.name, setting.query), setting.study
    if derived:
        return study.memoize(key, lambda: solve_with(strategy, setting, shown=False))
    is_reverse = setting.unknown or setting.stated is not None or setting.sought is not None
    if not is_reverse and setting.most < Need.INTEGRATION and study.is_cached(key):
        solution = study.memoize(key, lambda: solve_with(strategy, setting, shown=False))
        if solution.answer is None or solution.needs <= setting.most:
            return solution
    return solve_with(strategy, setting)


def solve_with(strategy: Strategy, setting: ProblemContext, *, shown: bool = True) -> Solution:
    """Return the worked solution by one strategy, in symbols for a symbolic problem; a failed one has no answer.

    If it is not `shown`, some verifications, on which no result depends, are omitted.
    """
    kind = setting.query.kind
    refused = "" if kind in strategy.kinds else f"no way to the kind {kind}"
    unfit = strategy not in applicable_strategies(setting.mechanism)
    refused = refused or (strategy.why_unsuitable(setting.mechanism) if unfit else strategy.why_not_applicable(setting))
    if refused:
        return Solution(strategy.name, reason=refused, applies=False)
    solution = _written(strategy, setting, shown=shown)
    if setting.formula is None or solution.answer is None:
        return solution
    given_symbols = {given.symbol for given in setting.lexicon.givens.values()}
    own = [symbol for symbol in setting.formula.symbols if symbol not in given_symbols]
    solution = _written(strategy, setting, dict(zip(solution.stated, own, strict=False)), shown=shown)
    if solution.answer is None:
        return solution
    sides = [side for relation in solution.relations for side in (relation.left, relation.right)]
    if any(is_special(side) or next(numeric_parts(side), None) is not None for side in sides):
        return Solution(strategy.name, reason="it would need numbers where all is in symbols")
    return with_final_algebra(replace(solution, formula=setting.formula.latex))


def _written(
    strategy: Strategy, setting: ProblemContext, called: Mapping[str, str] | None = None, *, shown: bool
) -> Solution:
    """Return a strategy's solution in numbers, or in symbols if `called` names the numbers that the question states."""
    asks = "" if setting.sought is None or setting.unknown else number_unit(setting.query.moment)
    book = SolutionBuilder(setting.words.units, asks=asks, called=called, most=setting.most)
    book.passage = setting.passage
    for path, given in setting.lexicon.givens.items():
        book.reserve(given.symbol)
        unit = given.counted_unit if path == setting.unknown else ""
        book.set_value(given.symbol, given.value, unit)
        if path == setting.unknown:
            book.sought = given.symbol
            book.hidden.add(given.symbol)
    book.reserve(*(own for name, own in (called or {}).items() if own != name))
    try:
        goal = strategy.write(setting, book)
        goal = _inverted(setting, book, goal) if setting.stated is not None and not strategy.integrates else goal
        if setting.extreme is not None:
            write_reason(setting, book, goal)
            book.units[goal] = book.units.get(goal) or setting.unit  # the text tells the unit of what it gives
        late = {*book.hidden, book.sought}
        if not book.in_symbols:
            book.hidden.clear()
        for write in [*book.afterwards, *(book.checks.values() if shown else ())]:
            write()
    except (UnsolvedError, UnreadError) as error:
        return Solution(strategy.name, reason=str(error))
    steps = book.steps if strategy.integrates or strategy.finished else _text_steps(book, goal, late)
    steps = _renumbered([_givens(setting, book, steps, goal), *steps])
    solution = renumber_times(_unanswered_solution(strategy, setting, book, goal, steps))
    answer = solution.in_answer_unit(book.values[goal])
    if setting.answer is None or abs(answer - setting.answer) > ANSWER_RTOL * abs(setting.answer):
        return Solution(strategy.name, reason=f"it leads to {answer:.6g}, which is not the answer")
    return replace(solution, answer=answer)


def _unanswered_solution(
    strategy: Strategy, setting: ProblemContext, book: SolutionBuilder, goal: str, steps: tuple[Step, ...]
) -> Solution:
    """Combine the steps that a strategy wrote into a solution whose answer is not yet set."""
    counted = not setting.unknown and setting.sought is None and KINDS[setting.query.kind].measured(setting.query).whole
    solution = Solution(
        strategy.name,
        steps,
        book.observed | book.values,
        goal,
        unit=book.units.get(goal, ""),
        stated=tuple(name for name in book.stated if name not in book.constants),
        constants=book.constants,
        condition_number=book.condition_number,
        phases=tuple(book.phases[: 1 + max(step.phase for step in steps)]),
        whole=counted,
        is_modulus=needs_modulus(setting, book, Symbol(goal), setting.query.subject),
    )
    unknown = setting.lexicon.givens.get(setting.unknown)
    if unknown is not None and goal == unknown.symbol and unknown.scale != 1.0 and not unknown.angle:
        return replace(solution, scale=1.0 / unknown.scale, asked_unit=(unknown.unit, 1.0))
    return solution


def _inverted(setting: ProblemContext, book: SolutionBuilder, goal: str) -> str:
    """Write the steps from the given answer of the query back to the unknown parameter, and return its symbol."""
    assert setting.stated is not None
    value, unit = setting.stated.value, book.units.get(goal, "")
    value = radians(value) if unit == DEGREES else value
    magnitude = states_only_magnitude(setting, book, goal)
    symbol = Inversion(book, goal, value, book.sought, magnitude=magnitude).write(f"{setting.stated.value:g}{unit}")
    hung = {*book.formulas, book.sought}
    for step in book.steps:
        worked = [part for r in step.relations for side in (r.left, r.right) for part in numeric_parts(side)]
        if step.kind != SOLVE_KIND and any(not hung.isdisjoint(part.names) for part in worked):
            raise UnsolvedError("it would need numbers that are not known")
    return symbol


def solve_prompt(prompt: str) -> tuple[Solution, ProblemContext]:
    """Return the solution and context of a problem from its prompt alone; TextError if it cannot be parsed."""
    parsed = parse_prompt(prompt)
    setting = setting_of(parsed)
    if setting.stated != parsed.asked.given:
        return Solution("", reason="the text leaves open what is asked for"), setting
    return solve(setting), setting


def setting_of(parsed: ParsedPrompt) -> ProblemContext:
    """Build the problem context that a parsed prompt describes, with the symbols of its text.

    If the given result does not determine the unknown, the setting asks for that result.
    """
    scene, mentions = parsed.scene, parsed.reading.mentions
    letters = {
        address: mention.rpartition(" ")[2] for address, mention in mentions.items() if not mention.startswith("the ")
    }
    nouns = {type(body): _noun(mentions[address]) for address, body in scene.bodies.items() if address in mentions}
    named = Writer(scene, Names(letters, nouns), np.random.default_rng(0), numeric).symbols
    study, given = parsed.study, parsed.asked.given
    limited = parsed.query.hides if given is not None else ""
    unknown = next((path for path in parsed.reading.unknown if path != limited), "")
    if unknown and given is not None:
        answer = parsed.is_count
        if answer is None:
            return ProblemContext(scene, Words.of(scene, mentions), named, study, parsed.query)
        study = SimulatedScene.of(scene.having(unknown, answer), study.trace.state.times)
    words = Words.of(study.scene, mentions)
    return ProblemContext(study.scene, words, named, study, parsed.query, unknown, given)


def _noun(mention: str) -> str:
    return mention.removeprefix("the ") if mention.startswith("the ") else mention.rpartition(" ")[0]


def _text_steps(book: SolutionBuilder, goal: str, late: AbstractSet[str]) -> list[Step]:
    """Return the steps that lead to the goal, ordered and merged for the text."""
    ordered = in_order(_needed(book.steps, goal), book.earliest, late)
    return without_repeats(group_steps(merge_steps(after_what_they_rest_on(ordered, late))))


def _needed(steps: list[Step], goal: str) -> list[Step]:
    """Return the steps that lead to the goal, and those without results, such as laws and verifications.

    Steps on which a verification depends are kept as well.
    """
    source = {name: step.id for step in steps for name in step.gives}
    kept: set[int] = set()
    waiting = [source[goal]] if goal in source else []
    waiting += [number for step in steps if not step.gives for number in step.needs]
    while waiting:
        number = waiting.pop()
        if number not in kept:
            kept.add(number)
            waiting += steps[number].needs
    return [step for step in steps if step.id in kept or not step.gives]


def _givens(setting: ProblemContext, book: SolutionBuilder, steps: list[Step], goal: str) -> Step:
    """Return the step that lists the numbers the solution takes from the text."""
    used = {name for step in steps for name in step.symbols()} | {goal}
    texts: dict[str, str] = {}
    relations: list[Relation] = []
    for given in setting.lexicon.givens.values():
        if given.symbol in used and given.symbol != book.sought:
            elastic = given.parameter.path.endswith("restitution") and given.value == 1.0
            texts[given.symbol] = f"{given.latex}{' (elastic)' if elastic else ''}"
            relations.append(Relation(Symbol(given.symbol), Number(given.value), "given"))
    for name, text in book.stated.items():
        if name in used:
            texts[name] = text
            relations.append(Relation(Symbol(name), Number(book.values[name]), "given"))
    symbols = setting.formula.symbols if book.in_symbols and setting.formula is not None else ()
    pairs = [(name, *text.partition(" (elastic)")[:2]) for name, text in texts.items() if name not in symbols]
    numbers = [f"${name} = {text}${why}" for name, text, why in pairs]
    text = f"Given: {join_words(numbers)}." if numbers else ""
    return Step(-1, "givens", text, tuple(relations), (), ())


def _renumbered(steps: list[Step]) -> tuple[Step, ...]:
    """Return the steps numbered from zero."""
    numbers = {step.id: number for number, step in enumerate(steps)}
    return tuple(
        replace(step, id=number, needs=tuple(numbers[n] for n in step.needs if n in numbers))
        for number, step in enumerate(steps)
    )


def renumber_times(solution: Solution) -> Solution:
    """Return a solution whose times t₁, t₂, … are numbered in the order of the steps that give them."""
    given = [name for step in solution.steps for name in step.gives if TIME.fullmatch(name)]
    names = [name for name in dict.fromkeys(given) if name not in solution.stated]
    exchanged = dict(zip(names, sorted(names, key=_number), strict=True))
    return rename_solution(solution, exchanged)


def _number(name: str) -> int:
    match = TIME.fullmatch(name)
    assert match is not None
    return int(match[1] or match[2] or 0)
