"""Two questions about one motion in one text: a quantity at a reached value, and which of two is greater."""

import re
from collections.abc import Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import replace
from math import isclose, radians

from sim2reason.grading.parts import PART_LABELS
from sim2reason.questions import KINDS, Query
from sim2reason.questions.kinds.nested import WhichKind, WhichQuery
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.reached import Reached
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.solutions.algebra.expressions import Number, Symbol
from sim2reason.solutions.equivalent_questions import instants, is_number_of, number_unit
from sim2reason.solutions.multipart import LAWS, UNCLEAR, sequential_solutions
from sim2reason.solutions.multipart.names import are_same_meaning, meanings, names_in_text, renamed_step, unit_of
from sim2reason.solutions.multipart.quoting import AS_IN_PART, CONSEQUENCE_OPENING, cited_labels
from sim2reason.solutions.multipart.recall import RECALLED_STEP_KIND, reduce_givens
from sim2reason.solutions.setting import ProblemContext, join_words
from sim2reason.solutions.solution import CHECKS, RELATION_RTOL, Relation, Solution, Step
from sim2reason.solutions.solve import solve
from sim2reason.solutions.strategies import Strategy, strategy
from sim2reason.solutions.writing.arrangement import SOLVE_KIND
from sim2reason.solutions.writing.notation import DEGREES
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError, record_inequality

REFERENCES = RECALLED_STEP_KIND, "equations", "reference", "givens"
"""Kinds of steps that only quote an earlier part or the givens, and are left out in one text."""


def merge_into_one_text(
    settings: Sequence[ProblemContext], solutions: Sequence[Solution]
) -> tuple[list[Solution], list[Step]]:
    """Merge solutions into one text: return the solutions with consistent names, and all steps without given numbers.

    If a name is ambiguous, the solutions have no answer, and there are no steps.
    """
    parts, steps = sequential_solutions(settings, solutions, whole=True), list[Step]()
    if any(part.answer is None for part in parts) or not _have_clear_names(parts):
        return [replace(part, answer=None, reason=part.reason or UNCLEAR) for part in parts], []
    for part in parts:
        source = {name: step.id for step in steps for name in step.gives}
        if part.goal in source:  # with the same value, or names would not be clear
            continue
        kept = [step for step in part.steps if step.kind not in REFERENCES]
        places = {step.id: len(steps) + number for number, step in enumerate(kept)}
        steps += [_placed(step, places, source) for step in kept]
    return parts, steps


def _have_clear_names(parts: Sequence[Solution]) -> bool:
    """Return whether no symbol is introduced twice with different words."""
    words_by_name: dict[str, str] = {}
    introduced = (pair for part in parts for pair in meanings(part).items())
    return all(are_same_meaning(name, words_by_name.setdefault(name, words), words) for name, words in introduced)


def _placed(step: Step, places: Mapping[int, int], source: Mapping[str, int]) -> Step:
    """Return a step renumbered for the whole text, with the new numbers of the steps that it needs."""
    needs = {places[need] for need in step.needs if need in places}
    needs |= {source[name] for name in (*step.symbols(), *cited_labels(step.text)) if name in source}
    text = step.text.replace(AS_IN_PART.format(PART_LABELS[0]), CONSEQUENCE_OPENING)
    return replace(step, id=places[step.id], needs=tuple(sorted(needs)), text=text)


def enter(part: Solution, book: SolutionBuilder) -> None:
    """Record the names, values and stated numbers of a solution in a solution builder."""
    value_texts = {
        name: text for step in part.steps if step.kind == "givens" for name, text in _stated(part, step.text)
    }
    book.stated |= {name: value_texts[name] for name in part.stated if name in value_texts}
    book.constants |= part.constants
    for name, value in part.values.items():
        if name not in book.values:
            book.reserve(name)
            book.set_value(name, value, unit_of(name, part))
    book.condition_number = max(book.condition_number, part.condition_number)


def _stated(part: Solution, givens: str) -> list[tuple[str, str]]:
    """Return name and value with unit of each number that the question states, from the list of given numbers."""
    equations = (formula.partition(" = ") for formula in givens.split("$")[1::2])
    return [(name, value_text) for name, _, value_text in equations if name in part.stated]


_SENTENCES = re.compile(r"(?<=[.]) (?=[A-Z])")


@strategy
class ValueReached(Strategy):
    """The strategy that finds the moment at which a quantity has a stated value, then answers for it."""

    name = "value reached"
    cost = 1.0
    drawn = False
    kinds = frozenset({"event"})
    nested = True
    finished = True

    def formulas(self, mechanism: Mechanism) -> frozenset[str]:
        """Return the question kinds that have a compact formula: none, since the answer takes two solutions in turn."""
        del mechanism
        return frozenset()

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        moment = setting.query.moment
        if not isinstance(moment, Reached):
            return "no quantity reaches a value"
        if setting.unknown or setting.formula is not None:
            return "it has no way to an unknown, or in symbols"
        if setting.target is None or setting.target == moment.target:
            return "the question says the value"
        return ""

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the distance, angle or time of the moment, and the answer from the first of these that leads to one."""
        reasons: list[str] = []
        for moment, value in instants(setting):
            parts = [*_parts(setting, moment, value)]
            solutions = [solve(part, checked=False) for part in parts]
            failed = next((solved for solved in solutions if not solved.derived), None)
            if failed is not None:
                reasons.append(failed.reason or "only an integration leads to it")
                continue
            chained = [solutions[0], *(_with_found(part, moment, value) for part in solutions[1:])]
            solved, steps = merge_into_one_text(parts, chained)
            if steps:
                for part in solved:
                    enter(part, book)
                steps, goal = _with_stated_result(_without_repeated(steps), solved)
                book.rewrite(0, steps)
                return goal
            reasons.append(solved[-1].reason)
        raise UnsolvedError(reasons[-1])


def _parts(setting: ProblemContext, moment: Moment, value: float) -> Iterator[ProblemContext]:
    """Yield the question for the distance, angle or time of the moment, then that for the quantity at this moment."""
    reached = setting.query.moment
    assert isinstance(reached, Reached)
    query, which = Query(moment.kind, reached.target, moment), reached.number
    yield replace(setting, query=query, stated=reached.given, sought=value, passage=which)
    if not is_number_of(moment, setting.query.target):
        yield replace(setting, query=Query(moment.kind, setting.query.target, moment))


def _with_found(part: Solution, moment: Moment, value: float) -> Solution:
    """Return a solution in which the number of the moment is an earlier result instead of a given number."""
    unit = number_unit(moment)
    counted = radians(value) if unit == DEGREES else value
    name = next((n for n in part.stated if isclose(part.values[n], counted, rel_tol=RELATION_RTOL)), "")
    if not name:
        return part
    used = {n for step in part.steps for n in step.symbols()} - {name}
    steps = [reduce_givens(step, used) if step.kind == "givens" else step for step in part.steps]
    relation = Relation(Symbol(name), Number(part.values[name]), "result", unit)
    moment_step = Step(len(steps), "moment", "", (relation,), (name,), ())
    return replace(
        part, steps=tuple(_after_givens(steps, moment_step)), stated=tuple(n for n in part.stated if n != name)
    )


def _after_givens(steps: list[Step], moment_step: Step) -> Iterator[Step]:
    """Yield steps with `moment_step` inserted after the given numbers; steps that use its name depend on it."""
    (name,) = moment_step.gives
    first = [step for step in steps if step.kind == "givens"]
    rest = [step for step in steps if step.kind != "givens"]
    numbers = {step.id: number for number, step in enumerate([*first, moment_step, *rest])}
    yield from (replace(step, id=numbers[step.id]) for step in first)
    yield replace(moment_step, id=numbers[moment_step.id])
    for step in rest:
        needs = {numbers[need] for need in (*step.needs, *((moment_step.id,) if name in step.symbols() else ()))}
        yield replace(step, id=numbers[step.id], needs=tuple(sorted(needs)))


def _with_stated_result(steps: Sequence[Step], parts: Sequence[Solution]) -> tuple[list[Step], str]:
    """Return the steps, with a stated value in place of each repeated computation of it, and the name of the goal.

    What the answer does not rest on is left out: a kinetic energy follows from a stated speed alone.
    """
    first, goal = parts[0], parts[-1].goal
    own = {r.left.latex(): r.right for step in first.steps for r in step.relations if r.role in ("law", "result")}
    again: dict[str, str] = {}
    for step in steps:
        for relation in step.relations if len(step.gives) == 1 else ():
            stated = (name for name in first.stated if own.get(name) == relation.right)
            again |= {name: known for name in step.gives for known in stated if name not in (known, goal)}
    kept = [*_renumbered([renamed_step(step, again) for step in steps if again.keys().isdisjoint(step.gives)])]
    kept = _with_found_values(kept, first)
    needed = _needed(goal, kept, {*first.stated})
    if not any(first.goal in (*step.gives, *step.symbols()) for step in needed):
        kept = [_without(step, first.goal) for step in needed]
    return [*_renumbered(kept)], goal


def _with_found_values(steps: Sequence[Step], first: Solution) -> list[Step]:
    """Return the steps and an added one: values, at the found moment, of names that were defined before that moment."""
    index = max((n for n, step in enumerate(steps) if first.goal in step.gives), default=len(steps))
    formulas = {r.left.latex(): r for step in steps[:index] for r in step.relations if r.left.latex() in step.gives}
    known = {name for step in steps[:index] if step.kind == SOLVE_KIND for name in step.gives} | {*first.stated}
    open_names = {first.goal}
    for name, relation in formulas.items():
        if not open_names.isdisjoint(relation.right.symbols()) and name not in known:
            open_names.add(name)
    used = {name for step in steps[index + 1 :] for name in step.symbols()}
    restated = [formulas[name] for name in formulas if name in open_names & used]
    if not restated:
        return [*steps]
    equations = join_words([relation.latex(first.values[relation.left.latex()]) for relation in restated])
    sources = tuple(n for n, step in enumerate(steps) if {r.left.latex() for r in restated} & {*step.gives})
    relations = tuple(replace(relation, role="derived") for relation in restated)
    step = Step(len(steps), "moment", f"At this moment, {equations}.", relations, (), (*sources, index))
    return [*_renumbered([*steps[: index + 1], step, *steps[index + 1 :]])]


def _without(step: Step, name: str) -> Step:
    """Return a step without the sentences and verifications about a name that the text no longer contains."""
    sentences = (sentence for sentence in _SENTENCES.split(step.text) if name not in names_in_text(sentence))
    checks = (r for r in step.relations if r.role not in CHECKS or name not in r.symbols())
    return replace(step, text=" ".join(sentences), relations=tuple(checks))


def _without_repeated(steps: Sequence[Step]) -> list[Step]:
    """Remove the steps that only verify relations which an earlier step verifies in other words."""
    seen: list[tuple[Relation, ...]] = []
    kept: list[Step] = []
    for step in steps:
        if step.gives or not step.relations or step.relations not in seen:
            kept.append(step)
        if not step.gives:
            seen.append(step.relations)
    return [*_renumbered(kept)]


def _needed(goal: str, steps: Sequence[Step], stated: AbstractSet[str]) -> list[Step]:
    """Return the steps on which a name depends, and the steps that verify assumptions of these.

    What leads to a stated name is needed only if something is found from that name.
    """
    names = {name for step in steps for name in step.symbols()}
    labels = {step.id for step in steps if step.gives and names.isdisjoint(step.gives)}  # of equations, not of values
    source = {name: step for step in steps for name in step.gives}  # the last one, which finds what was unknown before
    waiting, kept = [source[goal]] if goal in source else [], dict[int, Step]()
    while waiting:
        step = waiting.pop()
        if step.id in kept:
            continue
        kept[step.id] = step
        solves = step.kind == SOLVE_KIND
        waiting += [source[name] for name in step.symbols() if name in source and name not in stated]
        waiting += [steps[need] for need in step.needs if need in labels or (solves and stated & {*steps[need].gives})]
    ids, by_laws = kept.keys(), any(step.kind in LAWS for step in kept.values())
    checks = [s.id for s in steps if not s.gives and (not ids.isdisjoint(s.needs) or (by_laws and not s.needs))]
    return [step for step in steps if step.id in ids or step.id in checks]


def _renumbered(steps: Sequence[Step]) -> Iterator[Step]:
    numbers = {step.id: number for number, step in enumerate(steps)}
    for step in steps:
        yield replace(step, id=numbers[step.id], needs=tuple(numbers[need] for need in step.needs if need in numbers))


@strategy
class WhichOfTwo(Strategy):
    """The strategy that solves two queries in one text and states which value is reached first or is greater."""

    name = "which of two"
    cost = 1.0
    kinds = frozenset({"which_first", "which_greater"})
    nested = True
    finished = True

    def formulas(self, mechanism: Mechanism) -> frozenset[str]:
        """Return the question kinds that have a compact formula: none, as a choice between two has no formula."""
        del mechanism
        return frozenset()

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        if not isinstance(setting.query, WhichQuery):
            return "it asks for none of two"
        answer = KINDS[setting.query.kind].answer(setting.query, setting.study)
        return "" if answer is not None and answer > 0.0 else "the first of the two is not the one"

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write both answers in the shorter order and the comparison, and return the answer's symbol."""
        query = setting.query
        assert isinstance(query, WhichQuery)
        settings = [_inner(each, setting) for each in sorted(query.both, key=lambda each: (each.subject, repr(each)))]
        pairs = [(each, _solved(each)) for each in settings]
        orders = [merge_into_one_text(*zip(*order, strict=True)) for order in (pairs, pairs[::-1])]
        merged = [(parts, steps) for parts, steps in orders if steps]
        if not merged:
            raise UnsolvedError(orders[0][0][0].reason)
        parts, steps = min(merged, key=lambda each: sum(len(step.text.split()) for step in each[1]))
        for part in parts:
            enter(part, book)
        book.rewrite(0, steps)
        book.phases = [*max((part.phases for part in parts), key=len)]
        queries = [each.query for each in settings]
        goals = dict(zip(queries if parts is orders[0][0] else queries[::-1], parts, strict=True))
        return _concluded(query, setting, book, *(Symbol(goals[each].goal) for each in query.both))


def _inner(query: Query, setting: ProblemContext) -> ProblemContext:
    return replace(setting, query=query, unknown="", stated=None, sought=None)


def _solved(inner: ProblemContext) -> Solution:
    solution = solve(inner, checked=False)
    if solution.answer is None or not solution.derived:
        raise UnsolvedError(solution.reason or "only an integration leads to it")
    return solution


def _concluded(query: WhichQuery, setting: ProblemContext, book: SolutionBuilder, one: Symbol, other: Symbol) -> str:
    """Write which of the two is first or greater, and return the symbol of the difference or ratio."""
    kind = KINDS[query.kind]
    assert isinstance(kind, WhichKind)
    greater, less = (other, one) if kind.is_least else (one, other)
    step = book.begin_step("comparison")
    record_inequality(book, step, greater, less)
    formula, unit = (greater - less, book.units[one.name]) if kind.is_least else (greater / less, "")
    goal = book.fresh(r"\tau" if kind.is_least else "r")
    number = step.result(goal, formula, unit, law=True)
    inequality = f"${less.latex()} < {greater.latex()}$" if kind.is_least else f"${greater.latex()} > {less.latex()}$"
    step.add_text(f"Since {inequality}, {kind.conclusion(query, setting.words)} {number}.")
    step.close()
    return goal.name
