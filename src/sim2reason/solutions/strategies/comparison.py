"""Comparison: the answers for two values of a parameter, and their ratio or difference."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace

from sim2reason.questions.kinds.comparison import ComparisonQuery
from sim2reason.questions.kinds.nested import INNER, usable_answer
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.solutions.algebra.expressions import Number, Symbol
from sim2reason.solutions.laws.nested import (
    NEW_SUBSCRIPT,
    in_formula_units,
    independent_symbol,
    inner_setting,
    verify_again,
    with_changed_scene,
    with_other_value,
    write_inner_answer,
)
from sim2reason.solutions.multipart.names import LABEL, TOKEN, renamed_step
from sim2reason.solutions.multipart.quoting import relabel
from sim2reason.solutions.setting import ProblemContext, join_words
from sim2reason.solutions.solution import Step
from sim2reason.solutions.strategies import Strategy, closed_form_strategies, deriving_strategies, strategy
from sim2reason.solutions.writing.notation import split_name, with_subscript
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError

REPEATED_KINDS = "verify", "solve"  # kinds of steps that are repeated under new names
MIN_REPEATED_WORDS = 20  # words: shorter repetitions are kept


def shorten_second_case(book: SolutionBuilder, begun: int, changed: Mapping[str, str]) -> None:
    """Replace steps of the second case, from `begun` on, that repeat laws by one sentence that the laws are the same.

    `changed` maps the name of the differing number to its name in the first case.
    """
    first, second, names = book.steps[:begun], book.steps[begun:], dict[str, str]()
    repeated = _repeated(book, first, second, names)
    if sum(len(step.text.split()) for step in repeated) < MIN_REPEATED_WORDS:
        return
    rest = [step for step in second if step not in repeated]
    used = {match[0] for step in rest for match in TOKEN.finditer(step.text)}
    known = {name for step in first for name in step.gives} | book.stated.keys()
    new = {name: old for name, old in names.items() if name in used - known and name != old}
    labels, sentence = _labels(first, rest, names), _same_laws({**changed, **new})
    for number, step in enumerate(second):
        kept = (
            replace(step, text=sentence if step is repeated[0] else "") if step in repeated else relabel(step, labels)
        )
        book.steps[begun + number] = kept


def reuse_first_case(book: SolutionBuilder, begun: int, stated: Collection[str]) -> dict[str, str]:
    """Remove steps of the second case that repeat the first; return the names of the first case by those of the second.

    `stated` has the first case's names of numbers in the question. For a motion with several phases, or a result that
    depends on an unknown, nothing is removed.
    """
    first, second = book.steps[:begun], book.steps[begun:]
    if book.phases or book.hidden or any(step.integration for step in second):
        return {}
    alike = ((new, old) for new in book.stated.keys() - stated for old in stated if _same_given(book, new, old))
    names, places, kept = dict(alike), dict[int, int](), list[Step]()
    for later_step in second:
        step = relabel(renamed_step(later_step, names), names)
        for other in first:
            pairs = _renaming(step.text, other.text) if step.kind == other.kind else None
            if pairs is not None and all(_same_result(book, new, old) for new, old in pairs.items()):
                names |= pairs
                places[step.id] = other.id
                break
        else:
            kept.append(step)
    names = {new: old for new, old in names.items() if new != old}
    kept = [step for step in kept if not _is_idle_law(step, kept, first, book)]
    places |= {step.id: begun + number for number, step in enumerate(kept)}
    kept = [relabel(renamed_step(step, names), names) for step in kept]
    book.rewrite(begun, [_moved(step, places) for step in kept])
    for name in names:
        book.stated.pop(name, None)
    return names


def _same_given(book: SolutionBuilder, new: str, old: str) -> bool:
    """Return whether two names, one of each case, are the same number of the question."""
    return book.stated[new] == book.stated[old] and split_name(new)[0] == split_name(old)[0]


def _same_result(book: SolutionBuilder, new: str, old: str) -> bool:
    """Return whether two names, one of each case, have the same value, or the new one is an equation's label."""
    if new == old or LABEL.fullmatch(new):
        return True
    return new in book.values and book.values.get(old) == book.values[new]


def _is_idle_law(step: Step, kept: Sequence[Step], first: Sequence[Step], book: SolutionBuilder) -> bool:
    """Return whether a step of the second case only repeats laws of the first, and no kept step depends on the step."""
    if step.kind in REPEATED_KINDS or any(name in book.values for name in step.gives):
        return False
    used = {match[0] for other in kept if other is not step for match in TOKEN.finditer(other.text)}
    needed = any(step.id in other.needs for other in kept)
    renamings = (_renaming(step.text, other.text) for other in first)
    return not needed and any(
        pairs is not None and all(new == old or new not in used for new, old in pairs.items()) for pairs in renamings
    )


def _moved(step: Step, places: Mapping[int, int]) -> Step:
    """Return a step with new step numbers in place of its own number and of those that it depends on."""
    needs = {places.get(need, need) for need in step.needs}
    return replace(step, id=places[step.id], needs=tuple(sorted(needs)))


def _same_laws(names: Mapping[str, str]) -> str:
    """Return the sentence that the laws of the first case hold in the second, with new names for old ones."""
    renamings = [f"${new}$ for ${old}$" for new, old in names.items()]
    return f"The same laws hold, with {join_words(renamings)}."


def _repeated(
    book: SolutionBuilder, first: Sequence[Step], second: Sequence[Step], names: dict[str, str]
) -> list[Step]:
    """Return the steps that repeat a law of the first case, and add their new names to `names`."""
    repeated, left = list[Step](), [*first]
    for step in second:
        valued = any(name in book.values for name in step.gives)
        for other in left if not valued and step.kind not in REPEATED_KINDS else ():
            pairs = _renaming(step.text, other.text)
            if pairs is not None and all(names.get(new, old) == old for new, old in pairs.items()):
                names |= pairs
                repeated.append(step)
                left = [earlier for earlier in left if earlier is not other]
                break
    return repeated


def _renaming(text: str, other: str) -> dict[str, str] | None:
    """Return the renaming that turns one text into another; None if they differ in anything else.

    The renaming is one-to-one.
    """
    parts, others = text.split("$"), other.split("$")
    if len(parts) != len(others):
        return None
    renaming: dict[str, str] = {}
    for number, (part, its) in enumerate(zip(parts, others, strict=True)):
        pattern = TOKEN if number % 2 else LABEL  # names occur in formulas, labels between them
        if pattern.sub("", part) != pattern.sub("", its):
            return None
        new, old = ([match[0] for match in pattern.finditer(piece)] for piece in (part, its))
        if len(new) != len(old) or any(renaming.setdefault(a, b) != b for a, b in zip(new, old, strict=True)):
            return None
    return renaming if len({*renaming.values()}) == len(renaming) else None


def _labels(first: Sequence[Step], rest: Sequence[Step], names: Mapping[str, str]) -> dict[str, str]:
    """Return new labels for the second case's equations: the first case's for repeated laws, else the next numbers."""
    highest = max((int(label[1:-1]) for step in first for label in LABEL.findall(step.text)), default=0)
    labels = {new: old for new, old in names.items() if LABEL.fullmatch(new)}
    for step in rest:
        for label in LABEL.findall(step.text):
            if label not in labels and int(label[1:-1]) > highest:
                labels[label] = f"({highest + 1 + sum(1 for new in labels.values() if int(new[1:-1]) > highest)})"
    return labels


ANSWER_RTOL = 1e-6  # relative tolerance of the formula to the engine's answer for the other value
WORDS = {2.0: "doubled", 0.5: "halved", 3.0: "tripled"}


@strategy
class Comparison(Strategy):
    """The strategy that evaluates one formula for two values of a parameter and compares the results."""

    name = "comparison"
    cost = 1.0
    kinds = frozenset({"comparison"})
    nested = True

    def formulas(self, mechanism: Mechanism) -> frozenset[str]:
        """Return the question kinds that have a compact formula: ``comparison`` if the compared question has one."""
        return self.kinds if any(deriving_strategies(kind, mechanism) for kind in INNER) else frozenset()

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        if not isinstance(setting.query, ComparisonQuery):
            return "it compares nothing"
        inner = inner_setting(setting)
        offered = any(not candidate.why_not_applicable(inner) for candidate in _deriving(inner))
        return "" if offered else f"no formula for the kind {inner.query.kind}"

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the formula of the answer, its value with the changed parameter, and their ratio or difference."""
        query = setting.query
        assert isinstance(query, ComparisonQuery)
        symbol, inner = independent_symbol(setting, query.path), inner_setting(setting)
        goal = write_inner_answer(inner, book, _deriving(inner))
        changed = Number(query.factor) * Symbol(symbol)
        lead = f"With ${symbol}$ {WORDS[query.factor]}"
        verify_again(book, symbol, changed, lead)
        after = with_other_value(inner, book, goal, symbol, changed, lead)
        unit, value = book.units.get(goal, ""), book.values[after.name]
        wanted = usable_answer(query.inner, query.changed(setting.study))
        if wanted is None or abs(value - in_formula_units(wanted, unit)) > ANSWER_RTOL * abs(value):
            raise UnsolvedError("with the other value the formula is another one")
        return write_comparison(book, query, goal, after.name)


@strategy
class TwoCases(Strategy):
    """The strategy that solves the question for two values of a parameter in turn and compares the answers."""

    name = "comparison of two cases"
    cost = 2.0
    kinds = frozenset({"comparison"})
    nested = True

    def formulas(self, mechanism: Mechanism) -> frozenset[str]:
        """Return the question kinds that have a compact formula: none, since two cases are solved separately."""
        del mechanism
        return frozenset()

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        if not isinstance(setting.query, ComparisonQuery):
            return "it compares nothing"
        return "" if setting.query.changed(setting.study) is not None else "there is no motion with the other value"

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the solutions for the given and the changed parameter, and the ratio or difference of the answers."""
        query = setting.query
        assert isinstance(query, ComparisonQuery)
        changed, symbol, inner = (
            query.changed(setting.study),
            independent_symbol(setting, query.path),
            inner_setting(setting),
        )
        assert changed is not None
        goal = write_inner_answer(inner, book, _closed(inner))
        step, new = book.begin_step("other value"), Symbol(with_subscript(symbol, NEW_SUBSCRIPT))
        unit = setting.lexicon.givens[query.path].counted_unit
        becomes = step.result(new, Number(query.factor) * Symbol(symbol), unit, law=True)
        step.add_text(f"With ${symbol}$ {WORDS[query.factor]}, {becomes}.")
        step.close()
        other, begun = with_changed_scene(inner, changed, query.path, new.name), len(book.steps)
        checks, stated, late = {**book.checks}, {*book.stated}, len(book.afterwards)
        after = write_inner_answer(other, book, _closed(other))
        book.checks = checks  # strings are told to stay taut in the first case alone
        if len(book.afterwards) == late:  # what is written in the end has names of its own
            after = reuse_first_case(book, begun, stated).get(after, after)
        shorten_second_case(book, begun, {new.name: symbol})
        return write_comparison(book, query, goal, after)


def write_comparison(book: SolutionBuilder, query: ComparisonQuery, before: str, after: str) -> str:
    """Write the ratio or the difference of two results and return its symbol."""
    old, new = Symbol(before), Symbol(after)
    if query.ratio:
        return book.add_step(
            "comparison", "The ratio of the new value to the original one is", book.fresh("r"), new / old
        ).name
    greater, less = (new, old) if query.grows else (old, new)
    unit = book.units.get(before, "")
    return book.add_step("comparison", "The difference is", book.fresh(r"\Delta"), greater - less, unit).name


def _deriving(inner: ProblemContext) -> Sequence[Strategy]:
    """Return the strategies that may derive a formula for the question that is compared."""
    return deriving_strategies(inner.query.kind, inner.mechanism)


def _closed(inner: ProblemContext) -> Sequence[Strategy]:
    """Return the strategies that answer the compared question without integration, those of lowest cost first."""
    return [
        candidate for candidate in closed_form_strategies(inner.query.kind, inner.mechanism) if not candidate.nested
    ]
