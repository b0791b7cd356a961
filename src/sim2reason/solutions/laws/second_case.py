"""Second cases of a comparison, without repetition of what both cases share."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace

from sim2reason.solutions.algebra.expressions import Expression, Symbol
from sim2reason.solutions.algebra.inverse import substitute
from sim2reason.solutions.closed_forms.closed_form import defined_by
from sim2reason.solutions.laws.nested import AGAIN, NEW
from sim2reason.solutions.multipart.quantities import LABEL
from sim2reason.solutions.multipart.quoting import labelled
from sim2reason.solutions.multipart.renaming import TOKEN, renamed_step
from sim2reason.solutions.setting import join_words
from sim2reason.solutions.solution import Relation, Step
from sim2reason.solutions.writing.comparing import record_inequality
from sim2reason.solutions.writing.steps import SolutionBuilder, StepBuilder, UnsolvedError
from sim2reason.solutions.writing.subscripts import split_name, with_subscript

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
    labels, told = _labels(first, rest, names), _same_laws({**changed, **new})
    for number, step in enumerate(second):
        kept = replace(step, text=told if step is repeated[0] else "") if step in repeated else labelled(step, labels)
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
    for held in second:
        step = labelled(renamed_step(held, names), names)
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
    kept = [labelled(renamed_step(step, names), names) for step in kept]
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
    needs = {places.get(place, place) for place in step.needs}
    return replace(step, id=places[step.id], needs=tuple(sorted(needs)))


def _same_laws(names: Mapping[str, str]) -> str:
    """Return the sentence that the laws of the first case hold in the second, with new names for old ones."""
    said = [f"${new}$ for ${old}$" for new, old in names.items()]
    return f"The same laws hold, with {join_words(said)}."


def _repeated(
    book: SolutionBuilder, first: Sequence[Step], second: Sequence[Step], names: dict[str, str]
) -> list[Step]:
    """Return the steps that repeat a law of the first case, and add their new names to `names`."""
    found, left = list[Step](), [*first]
    for step in second:
        valued = any(name in book.values for name in step.gives)
        for other in left if not valued and step.kind not in REPEATED_KINDS else ():
            pairs = _renaming(step.text, other.text)
            if pairs is not None and all(names.get(new, old) == old for new, old in pairs.items()):
                names |= pairs
                found.append(step)
                left = [held for held in left if held is not other]
                break
    return found


def _renaming(text: str, other: str) -> dict[str, str] | None:
    """Return the renaming that turns one text into another; None if they differ in anything else.

    The renaming is one-to-one.
    """
    parts, others = text.split("$"), other.split("$")
    if len(parts) != len(others):
        return None
    found: dict[str, str] = {}
    for number, (part, its) in enumerate(zip(parts, others, strict=True)):
        pattern = TOKEN if number % 2 else LABEL  # names occur in formulas, labels between them
        if pattern.sub("", part) != pattern.sub("", its):
            return None
        new, old = ([match[0] for match in pattern.finditer(held)] for held in (part, its))
        if len(new) != len(old) or any(found.setdefault(a, b) != b for a, b in zip(new, old, strict=True)):
            return None
    return found if len({*found.values()}) == len(found) else None


def _labels(first: Sequence[Step], rest: Sequence[Step], names: Mapping[str, str]) -> dict[str, str]:
    """Return new labels for the second case's equations: the first case's for repeated laws, else the next numbers."""
    told = max((int(label[1:-1]) for step in first for label in LABEL.findall(step.text)), default=0)
    found = {new: old for new, old in names.items() if LABEL.fullmatch(new)}
    for step in rest:
        for label in LABEL.findall(step.text):
            if label not in found and int(label[1:-1]) > told:
                found[label] = f"({told + 1 + sum(1 for new in found.values() if int(new[1:-1]) > told)})"
    return found


MAX_WRITTEN_LENGTH = 200  # characters: longer formulas are checked, but not written
MAX_SUBSTITUTED_LENGTH = 1000  # characters: no substitution into longer formulas


def verify_again(book: SolutionBuilder, symbol: str, changed: Expression, lead: str) -> None:
    """Write that each comparison that depends on a symbol still holds with `changed` in its place.

    Raises:
        UnsolvedError: a comparison does not hold.
    """
    formulas = {name: formula for name, formula in defined_by(book.steps).items() if name not in book.stated}
    hanging = _hanging(formulas, symbol)
    for step in [*book.steps]:
        for held in step.relations:
            if held.role == "exceeds" and not {symbol, *hanging}.isdisjoint(held.symbols()):
                sides = [_changed(side, symbol, changed, hanging) for side in (held.left, held.right)]
                left, right = sides
                if left is not None and right is not None:
                    _verify(book, step, held, (left, right), lead)
                else:
                    _exceeds_still(book, held, {symbol: changed, **dict(reversed(hanging.items()))})


def _hanging(formulas: Mapping[str, Expression], symbol: str) -> dict[str, Expression]:
    """Return the formulas of names that depend on a symbol, the last defined first."""
    found: dict[str, Expression] = {}
    for name, formula in formulas.items():
        if not {symbol, *found}.isdisjoint(formula.symbols()):
            found = {name: formula, **found}
    return found


def _changed(
    side: Expression, symbol: str, changed: Expression, hanging: Mapping[str, Expression]
) -> Expression | None:
    """Return a formula with `changed` in place of a symbol, also in names that depend on it; None if it gets long."""
    for name, formula in {**hanging, symbol: changed}.items():
        side = substitute(side, name, formula)
        if len(side.latex()) > MAX_SUBSTITUTED_LENGTH:
            return None
    return side


def _exceeds_still(book: SolutionBuilder, held: Relation, formulas: Mapping[str, Expression]) -> None:
    """Check numerically that an inequality of the solution still holds with other formulas for names.

    Raises:
        UnsolvedError: the comparison does not hold.
    """
    at = dict(book.values)
    for name, formula in formulas.items():
        at[name] = book.value(formula, at)
    if not book.value(held.left, at) > book.value(held.right, at):
        raise UnsolvedError(f"{held.left.latex()} no longer exceeds {held.right.latex()}")


def _verify(book: SolutionBuilder, step: Step, held: Relation, sides: Sequence[Expression], lead: str) -> None:
    """Write that an inequality from an earlier step still holds for the new values of both sides."""
    writing, (left, right) = book.begin_step("verify"), sides
    record_inequality(book, writing, left, right)
    if max(len(side.latex()) for side in sides) > MAX_WRITTEN_LENGTH:
        return
    said = [_told(writing, step, pair) for pair in ((held.left, left), (held.right, right))]
    writing.add_text(f"{lead}, {said[0]} still exceeds {said[1]}.")
    writing.label(f"{AGAIN} {len(book.steps)}")
    writing.close()


def _told(writing: StepBuilder, step: Step, sides: tuple[Expression, Expression]) -> str:
    """Return one side of an inequality as LaTeX: its new value by a new name, or the old name if it is unchanged."""
    before, after = sides
    named = next((r for r in step.relations if r.role == "verified" and before in (r.left, r.right)), None)
    if named is None or before == after:
        return f"${(after if named is None else named.left).latex()}$"
    name = Symbol(with_subscript(named.left.latex(), NEW))
    return writing.verified(name, after, named.unit)
