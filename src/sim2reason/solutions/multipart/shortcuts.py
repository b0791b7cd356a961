"""A quantity of a later part from one equation, whose other quantities are given or known from earlier parts."""

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

from sim2reason.solutions.algebra.evaluated import NumericRoot
from sim2reason.solutions.algebra.expressions import Expression, Symbol
from sim2reason.solutions.algebra.inverse import solved_for
from sim2reason.solutions.algebra.tidied import tidied
from sim2reason.solutions.multipart.quoting import DEFINED, referred
from sim2reason.solutions.multipart.recall import kept_steps, known_from
from sim2reason.solutions.solution import Relation, Solution, Step

LAWS = frozenset({"newton", "constraint", "normal"})  # kinds of steps whose equations hold by themselves
SOLVED = frozenset({"solve"})


def shortened(solution: Solution, earlier: Sequence[tuple[str, Solution]]) -> Iterator[Solution]:
    """Yield the solution of a later part with steps that need fewer intermediate results, the shortest first.

    A name that follows from one law of the part, with what is given and what earlier parts found, needs no other.
    """
    known = {*known_from(solution, earlier, whole=True)}
    found = [solution]
    for place in reversed(range(len(solution.steps))):
        direct = _direct(found[-1], place, known)
        if direct is not None and _count(direct, known) < _count(found[-1], known):
            found.append(direct)
    yield from reversed(found[1:])


def _count(solution: Solution, known: Collection[str]) -> int:
    return sum(bool(step.gives) for step in kept_steps(solution, known) if step.kind not in LAWS)


def _direct(solution: Solution, place: int, known: Collection[str]) -> Solution | None:
    """Return a solution in which one step takes its result from a single law; None if there is no such law."""
    step = solution.steps[place]
    results = [relation for relation in step.relations if relation.role == "result"]
    if step.kind not in SOLVED or len(results) != 1 or step.gives != (results[0].left.latex(),):
        return None
    name = step.gives[0]
    given = {r.left.latex() for held in solution.steps for r in held.relations if r.role == "given"}
    if _is_direct(step, solution.steps[:place]):
        return None
    for source in solution.steps[:place]:
        for law in source.relations if source.kind in LAWS else ():
            if law.role != "law" or {*law.symbols()} - {name} - given - {*known} or name not in {*law.symbols()}:
                continue
            formula = _solved(name, law, solution)
            if formula is not None:
                new = _step(step, results[0], source, law, formula, solution)
                return replace(solution, steps=(*solution.steps[:place], new, *solution.steps[place + 1 :]))
    return None


def _is_direct(step: Step, before: Sequence[Step]) -> bool:
    """Return whether a step takes its result from one law already."""
    labels = {label for held in before if held.kind in LAWS for label, _ in DEFINED.findall(held.text)}
    used = referred(step.text)
    return len(used) == 1 and used[0] in labels


def _solved(name: str, law: Relation, solution: Solution) -> Expression | None:
    sides = (law.left, law.right) if name in {*law.left.symbols()} else (law.right, law.left)
    if name in {*sides[1].symbols()}:
        return None
    found = solved_for(name, *sides, solution.values)
    return None if isinstance(found, NumericRoot) else tidied(found, name, always=True)


def _step(step: Step, result: Relation, source: Step, law: Relation, formula: Expression, solution: Solution) -> Step:
    """Return the step that gives a name by one law, which it calls by its label if it has one."""
    labels = {text: label for label, text in DEFINED.findall(source.text)}
    label = labels.get(law.latex()[1:-1], "")
    name, relation = step.gives[0], Relation(Symbol(step.gives[0]), formula, "result", result.unit)
    where = f"From {label}, " if label else "So "
    text = f"{where}{relation.latex(solution.values[name])}."
    used = {held.id for held in solution.steps[: step.id] for other in held.gives if other in {*formula.symbols()}}
    return replace(step, text=text, relations=(relation,), needs=tuple(sorted({source.id, *used})))
