"""Solutions of multipart problems, with one name for each quantity and references to earlier results."""

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from itertools import chain

from sim2reason.grading.parts import PART_LABELS
from sim2reason.grading.tokens import canonical
from sim2reason.solutions.algebra.evaluated import NumericRoot
from sim2reason.solutions.algebra.expressions import Expression, Symbol
from sim2reason.solutions.algebra.root_finding import solved_for
from sim2reason.solutions.algebra.standard_equations import as_one_fraction
from sim2reason.solutions.laws.strings_and_pulleys import TAUT
from sim2reason.solutions.multipart.names import (
    VALUE_RTOL,
    NamedQuantity,
    are_same_meaning,
    meanings,
    names_in_text,
    names_of,
    quantities,
    rename_solution,
)
from sim2reason.solutions.multipart.quoting import DEFINED, cited_labels, quote_earlier_parts, without_unused
from sim2reason.solutions.multipart.recall import (
    RECALLED_STEP_KIND,
    recall_results,
    recallable_names,
    reduce_givens,
    renumber_steps,
    steps_to_goal,
)
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.solution import Relation, Solution, Step
from sim2reason.solutions.verification import verify_solution
from sim2reason.solutions.writing.notation import numbered_names, split_name


def naming_fault(parts: Sequence[Solution]) -> str:
    """Return a description of the first inconsistency in the names of several parts; empty if there is none.

    A name has one value and one meaning in all parts, and quantities introduced in the same words have the same name. A
    result that a part recalls must be a result of the cited part, by the same name.
    """
    return next((fault for fault in (*_recalled(parts), *_doubled(parts), *_called_twice(parts))), "")


def _recalled(parts: Sequence[Solution]) -> Iterator[str]:
    """Yield an error message for each result that a part recalls from a part without this result or value."""
    for label, part in zip(PART_LABELS, parts, strict=False):
        for step in part.steps:
            if step.kind != RECALLED_STEP_KIND:
                continue
            source = step.text.removeprefix("From part (").partition(")")[0]
            other = (
                parts[PART_LABELS.index(source)]
                if source and source in PART_LABELS[: PART_LABELS.index(label)]
                else None
            )
            found = {
                name
                for held in (other.steps if other else ())
                if held.kind != RECALLED_STEP_KIND
                for name in held.gives
            }
            for name in step.gives:
                if other is None or name not in found | {other.goal}:
                    yield f"part ({label}) takes {name} from part ({source}), which has no {name}"
                elif not _same(part, other, name):
                    yield f"part ({label}) takes {name} from part ({source}), where it has another value"


def _doubled(parts: Sequence[Solution]) -> Iterator[str]:
    """Yield a message for each name that has different meanings in two parts."""
    known: dict[str, tuple[str, Solution, str]] = {}
    for label, part in zip(PART_LABELS, parts, strict=False):
        if part.answer is None:
            continue
        words = meanings(part)
        for name in dict.fromkeys([*names_of(part.steps), part.goal]):
            first, other, meaning = known.setdefault(name, (label, part, words.get(name, "")))
            if name in part.values and name in other.values and not _same(part, other, name):
                yield f"{name} has one value in part ({first}) and another in part ({label})"
            if not are_same_meaning(name, meaning, words.get(name, "")):
                yield f"{name} is {meaning!r} in part ({first}) and {words[name]!r} in part ({label})"
            if not meaning and name in words:
                known[name] = (label, part, words[name])


def _called_twice(parts: Sequence[Solution]) -> Iterator[str]:
    """Yield a message for each quantity to which two parts give different names."""
    known: dict[tuple[str, str, str], tuple[str, set[str]]] = {}
    for label, part in zip(PART_LABELS, parts, strict=False):
        own: dict[tuple[str, str, str], set[str]] = {}
        for name, words in meanings(part).items():
            if name in part.values:
                own.setdefault((split_name(name)[0], words, f"{part.values[name]:.9g}"), set()).add(name)
        for key, names in own.items():
            first, called = known.setdefault(key, (label, names))
            if called.isdisjoint(names):
                yield f"{min(called)} of part ({first}) is called {min(names)} in part ({label})"


def _same(part: Solution, other: Solution, name: str) -> bool:
    return abs(part.values[name] - other.values[name]) <= VALUE_RTOL * abs(other.values[name])


def unify_names(solutions: Sequence[Solution], fixed: Collection[str] = ()) -> list[Solution]:
    """Return the solutions renamed so that a name means the same in all; `fixed` names of the text are kept.

    Numbers that the question states keep their names. A quantity that several parts find has the first of its names
    that is free, and that no other quantity has in as many parts; otherwise it gets a fresh name.
    """
    solved = [solution for solution in solutions if solution.answer is not None]
    fixed = {*fixed, *(name for solution in solved for name in solution.constants)}
    named_quantities = quantities(solved, fixed)
    naming = _Naming(solved, named_quantities, fixed)
    names: list[dict[str, str]] = [{} for _ in solved]
    for quantity in naming.ordered():
        name = naming.named(quantity)
        for part, old in quantity.members.items():
            names[part][old] = name
    renamed = iter([rename_solution(solution, given) for solution, given in zip(solved, names, strict=True)])
    return [solution if solution.answer is None else next(renamed) for solution in solutions]


class _Naming:
    """The assignment of unique names to the quantities of several parts."""

    def __init__(self, solutions: Sequence[Solution], found: Sequence[NamedQuantity], fixed: Collection[str]) -> None:
        self._found = found
        self._taken = {canonical(name) for name in fixed}
        self._used: list[frozenset[str]] = []
        self._spoken: list[frozenset[str]] = []
        goals = [solution.goal for solution in solutions]
        for part, solution in enumerate(solutions):
            earlier = [q for q in found if any(q.members.get(n) == goals[n] for n in range(part))]
            steps = steps_to_goal(solution, {q.members[part] for q in earlier if part in q.members})
            self._used.append(frozenset([*names_of(steps), solution.goal, *solution.stated]))
            self._spoken.append(names_in_text(" ".join(step.text for step in steps)))

    def ordered(self) -> Iterator[NamedQuantity]:
        """Yield each quantity in the order of naming: those stated in questions, those used in texts, the others."""
        texts = [q for q in self._found if any(name in self._used[part] for part, name in q.members.items())]
        groups = [q for q in texts if q.stated], [q for q in texts if not q.stated]
        yield from chain(*groups)
        yield from (q for q in self._found if q not in texts)

    def named(self, quantity: NamedQuantity) -> str:
        """Choose and reserve the name of a quantity, and return it."""
        own = [*dict.fromkeys(quantity.members.values())]
        free = [name for name in own if self._is_free(name, quantity)]
        best = [name for name in free if len(own) == 1 or not self._is_needed(name, quantity)]
        name = next(chain(best, free, (n for n in numbered_names(own[0]) if self._is_free(n, quantity))))
        self._taken.add(canonical(name))
        return name

    def _is_free(self, name: str, quantity: NamedQuantity) -> bool:
        """Return whether a name is not taken and no part uses it for another quantity."""
        clash = any(
            name != old and name in self._spoken[part] and not self._is_own(part, name)
            for part, old in quantity.members.items()
        )
        return canonical(name) not in self._taken and not clash

    def _is_own(self, part: int, name: str) -> bool:
        return any(q.members.get(part) == name for q in self._found)

    def _is_needed(self, name: str, quantity: NamedQuantity) -> bool:
        """Return whether another quantity has only this name, in no fewer parts than `quantity` has the name."""
        occurrences = [*quantity.members.values()].count(name)
        others = (q for q in self._found if q is not quantity and {*q.members.values()} == {name})
        return any(len(q.members) >= occurrences for q in others)


LAWS = frozenset({"newton", "constraint", "normal"})  # kinds of steps whose equations are laws
SOLVED = frozenset({"solve"})


def shortened_variants(solution: Solution, earlier: Sequence[tuple[str, Solution]]) -> Iterator[Solution]:
    """Yield variants of the solution of a later part with fewer intermediate results, the shortest first.

    A name that one law of the part gives, from given numbers and results of earlier parts, needs no other steps.
    """
    known = {*recallable_names(solution, earlier, whole=True)}
    variants = [solution]
    for index in reversed(range(len(solution.steps))):
        direct = _direct(variants[-1], index, known)
        if direct is not None and _count(direct, known) < _count(variants[-1], known):
            variants.append(direct)
    yield from reversed(variants[1:])


def _count(solution: Solution, known: Collection[str]) -> int:
    return sum(bool(step.gives) for step in steps_to_goal(solution, known) if step.kind not in LAWS)


def _direct(solution: Solution, index: int, known: Collection[str]) -> Solution | None:
    """Return a solution in which the step at index `index` computes its result from a single law; None if none does."""
    step = solution.steps[index]
    results = [relation for relation in step.relations if relation.role == "result"]
    if step.kind not in SOLVED or len(results) != 1 or step.gives != (results[0].left.latex(),):
        return None
    name = step.gives[0]
    given = {r.left.latex() for each in solution.steps for r in each.relations if r.role == "given"}
    if _is_direct(step, solution.steps[:index]):
        return None
    for source in solution.steps[:index]:
        for law in source.relations if source.kind in LAWS else ():
            if law.role != "law" or {*law.symbols()} - {name} - given - {*known} or name not in {*law.symbols()}:
                continue
            formula = _solved(name, law, solution)
            if formula is not None:
                new = _step(step, results[0], source, law, formula, solution)
                return replace(solution, steps=(*solution.steps[:index], new, *solution.steps[index + 1 :]))
    return None


def _is_direct(step: Step, before: Sequence[Step]) -> bool:
    """Return whether a step already computes its result from a single law."""
    labels = {label for earlier in before if earlier.kind in LAWS for label, _ in DEFINED.findall(earlier.text)}
    used = cited_labels(step.text)
    return len(used) == 1 and used[0] in labels


def _solved(name: str, law: Relation, solution: Solution) -> Expression | None:
    sides = (law.left, law.right) if name in {*law.left.symbols()} else (law.right, law.left)
    if name in {*sides[1].symbols()}:
        return None
    found = solved_for(name, *sides, solution.values)
    return None if isinstance(found, NumericRoot) else as_one_fraction(found, name, always=True)


def _step(step: Step, result: Relation, source: Step, law: Relation, formula: Expression, solution: Solution) -> Step:
    """Return the step that computes a name from one law, cited by its label if it has one."""
    labels = {text: label for label, text in DEFINED.findall(source.text)}
    label = labels.get(law.latex()[1:-1], "")
    name, relation = step.gives[0], Relation(Symbol(step.gives[0]), formula, "result", result.unit)
    where = f"From {label}, " if label else "So "
    text = f"{where}{relation.latex(solution.values[name])}."
    used = {held.id for held in solution.steps[: step.id] for other in held.gives if other in {*formula.symbols()}}
    return replace(step, text=text, relations=(relation,), needs=tuple(sorted({source.id, *used})))


UNCLEAR = "the names of its parts are not clear"


def sequential_solutions(
    settings: Sequence[ProblemContext], solutions: Sequence[Solution], *, whole: bool = False
) -> list[Solution]:
    """Rewrite the solutions of the separate parts so that each part uses the answers of earlier parts.

    With `whole`, a solution also uses the intermediate results of earlier solutions. Names mean the same in all parts;
    if that is impossible, no part has an answer.
    """
    fixed = {given.symbol for setting in settings for given in setting.lexicon.givens.values()}
    rewritten, earlier = list[Solution](), list[tuple[str, Solution]]()
    for label, alone, setting in zip(PART_LABELS, unify_names(solutions, fixed), settings, strict=False):
        reduced = _without_repeated_checks(alone, earlier) if whole else alone
        solution = recall_results(reduced, earlier, whole=whole)
        known = results_of(rewritten, whole=whole)
        accepted = partial(_accepted, setting=setting, known=known)
        if whole:
            direct = (recall_results(each, earlier, whole=True) for each in shortened_variants(reduced, earlier))
            solution = next((each for each in direct if accepted(each)), solution)
        checked = solution if solution is reduced else verify_solution(solution, setting, known)
        rewritten.append(checked if whole else without_unused(checked, accepted))
        earlier.append((label, rewritten[-1]))
    if fault := naming_fault(rewritten):
        return [Solution("", reason=f"{UNCLEAR}: {fault}") for _ in rewritten]
    return quote_earlier_parts(rewritten) if whole else rewritten


def _without_repeated_checks(solution: Solution, earlier: Sequence[tuple[str, Solution]]) -> Solution:
    """Return a solution without the verification that strings stay taut if an earlier part contains one."""
    if not any(step.kind == TAUT for _, other in earlier for step in other.steps):
        return solution
    kept = [step for step in solution.steps if step.kind != TAUT]
    if len(kept) == len(solution.steps):
        return solution
    symbols = {name for step in kept if step.kind != "givens" for name in step.symbols()} | {solution.goal}
    return replace(
        solution,
        steps=renumber_steps([reduce_givens(step, symbols) if step.kind == "givens" else step for step in kept]),
    )


def _accepted(solution: Solution, setting: ProblemContext, known: Mapping[str, float]) -> bool:
    return verify_solution(solution, setting, known).answer is not None


def results_of(earlier: Iterable[Solution], *, whole: bool = False) -> dict[str, float]:
    """Return results by name that a later part may use: answers, with `whole` also intermediate results."""
    results: dict[str, float] = {}
    for solution in earlier:
        if solution.answer is None:
            continue
        names = [solution.goal, *(name for step in solution.steps for name in step.gives if whole)]
        results |= {name: solution.values[name] for name in names if name in solution.values}
    return results
