"""Results of earlier parts in place of the steps that would derive them again."""

import re
from collections.abc import Collection, Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from sim2reason.solutions.algebra.expressions import Number, Symbol
from sim2reason.solutions.multipart.names import VALUE_RTOL, introduced_names, names_in_text, names_of, unit_of
from sim2reason.solutions.setting import join_words
from sim2reason.solutions.solution import CHECKS, Relation, Solution, Step, with_unit
from sim2reason.solutions.writing.arrangement import ORDER, SINGULAR

RECALLED_STEP_KIND = "earlier part"
REASON_STEP_KINDS = "verify", "extreme", "meaning"  # kinds of steps that give no name, but a reason for one
_ONE = {f"{several} are ": f"{one} is " for several, one in SINGULAR.items()}
_NAMED = re.compile(r"\$(\\?[A-Za-z]+(?:_(?:\{(?:[^{}$]|\{[^{}$]*\})*\}|\w))?)\$")


def recall_results(solution: Solution, earlier: Sequence[tuple[str, Solution]], *, whole: bool = False) -> Solution:
    """Return a solution that cites results of earlier parts, by their labels, instead of deriving them.

    Names mean the same in all parts. With `whole`, intermediate results of earlier parts are used as well. The solution
    is unchanged if no step can be left out, or if it integrates the motion.
    """
    known = recallable_names(solution, earlier, whole=whole)
    known_texts = {text for _, other in earlier for text in _introduced(other)} if whole else set[str]()
    steps = (step for step in steps_to_goal(solution, known, known_texts) if step.kind != "givens")
    kept = [_without(step, known, solution.goal) for step in steps]
    used = {*names_of(kept), *names_in_text(" ".join(step.text for step in kept))} & known.keys()
    recalled = used - {name for step in kept for name in step.gives}
    shorter = whole and bool(earlier) and _results(kept) < _results(solution.steps)
    if not recalled and not shorter:
        return solution
    kept = sorted([*kept, *_introductions(solution, kept, known_texts)], key=lambda step: step.id)
    symbols = {name for step in kept for name in step.symbols()}
    first = [reduce_givens(step, symbols) for step in solution.steps if step.kind == "givens"]
    recalled_steps = _recalled({name: known[name] for name in known if name in recalled}, solution)
    recalled_steps = recalled_steps or _verified_earlier(solution, earlier)
    return replace(solution, steps=renumber_steps([*first, *recalled_steps, *kept]))


def _verified_earlier(solution: Solution, earlier: Sequence[tuple[str, Solution]]) -> list[Step]:
    """Return [step], which cites the first part with the same verification as the solution; [] if no part has one."""
    reasons = {step.text for step in solution.steps if _is_reason(step)}
    parts = (label for label, other in earlier if any(step.text in reasons for step in other.steps))
    label = next(parts, "")
    text = f"What was verified of this motion in part ({label}) holds here, too."
    return [Step(-1, "reference", text, (), (), ())] if label else []


def recallable_names(solution: Solution, earlier: Sequence[tuple[str, Solution]], *, whole: bool) -> dict[str, str]:
    """Return the names that earlier parts compute, each with the label of the first such part."""
    known: dict[str, str] = {}
    for name in _result_names(solution):
        source = next((label for label, other in earlier if _tells(other, name, solution, whole=whole)), None)
        if source is not None:
            known[name] = source
    return known


def steps_to_goal(solution: Solution, known: Collection[str], known_texts: Container[str] = ()) -> list[Step]:
    """Return the steps from known names to the goal, and the verifications whose texts are not in `known_texts`.

    All steps are returned if none can be left out.
    """
    if solution.answer is None or any(step.integration is not None for step in solution.steps):
        return [*solution.steps]
    kept = _needed(solution, known, known_texts)
    return kept if _results(kept) < _results(solution.steps) else [*solution.steps]


def _results(steps: Collection[Step]) -> int:
    """Return the number of steps that give results; reasons and introductions give none."""
    return sum(bool(step.gives) for step in steps)


def renumber_steps(steps: Sequence[Step]) -> tuple[Step, ...]:
    """Return steps with new numbers, and with needs among the remaining steps and recalled results."""
    number_by_id = {step.id: number for number, step in enumerate(steps) if step.id >= 0}
    recalled = {
        name: number for number, step in enumerate(steps) if step.kind == RECALLED_STEP_KIND for name in step.gives
    }
    updated: list[Step] = []
    for number, step in enumerate(steps):
        needs = {number_by_id[need] for need in step.needs if need in number_by_id}
        needs |= {recalled[name] for name in step.symbols() if name in recalled and step.kind != RECALLED_STEP_KIND}
        updated.append(replace(step, id=number, needs=tuple(sorted(needs))))
    return tuple(updated)


def _result_names(solution: Solution) -> list[str]:
    """Return the names of the intermediate results of a solution."""
    given = {name for step in solution.steps for name in step.gives}
    return [name for name in solution.values if name in given and name != solution.goal]


def _tells(other: Solution, name: str, solution: Solution, *, whole: bool) -> bool:
    """Return whether another solution gives a name the same value, as its answer or, with `whole`, as any result."""
    if other.answer is None or name not in other.values:
        return False
    is_result = other.goal == name or (
        whole and any(name in step.gives and step.kind != RECALLED_STEP_KIND for step in other.steps)
    )
    value = solution.values[name]
    same = abs(value - other.values[name]) <= VALUE_RTOL * abs(value) and unit_of(name, other) == unit_of(
        name, solution
    )
    return is_result and same


def _without(step: Step, known: Collection[str], goal: str) -> Step:
    """Return a step that lists several results, reduced to those that are not known."""
    *_, formulas = ["", *re.findall(r"(?:\$[^$]*\$(?:, | and )?)+(?=\.$)", step.text)]
    equations = re.findall(r"\$[^$]*\$", formulas)
    rest = [n for n, name in enumerate(step.gives) if name not in known or name == goal]
    if not len(equations) == len(step.gives) == len(step.relations) or not 0 < len(rest) < len(equations):
        return step
    lead = step.text.removesuffix(f"{formulas}.")
    many = next((ending for ending in _ONE if lead.endswith(ending)), "") if len(rest) == 1 else ""
    lead = lead.removesuffix(many) + _ONE.get(many, "")
    text = f"{lead}{join_words([equations[n] for n in rest])}."
    return replace(
        step,
        text=text,
        relations=tuple(step.relations[n] for n in rest),
        gives=tuple(step.gives[n] for n in rest),
    )


def _introductions(solution: Solution, kept: Sequence[Step], known_texts: Container[str]) -> list[Step]:
    """Return the steps that introduce symbols of the kept steps, except those whose texts are in `known_texts`."""
    symbols = with_bases((name for step in kept for name in step.symbols()), solution)
    candidates = (
        step for step in solution.steps if step.kind == "names" and step not in kept and step.text not in known_texts
    )
    return [step for step in candidates if symbols & {*_NAMED.findall(step.text)}]


def with_bases(names: Iterable[str], solution: Solution) -> set[str]:
    """Return the given names and, for those that the solution does not introduce, their bases without subscripts.

    x_1 is a value of the x that a text introduces; but if a text introduces a_1, it is a different acceleration from a.
    """
    all_names = {*names}
    own = {name for step in solution.steps if step.kind == "names" for name in introduced_names(step.text)}
    return all_names | {name.partition("_")[0] for name in all_names - own}


def _introduced(solution: Solution) -> Iterator[str]:
    """Yield the text of each step, except steps that only introduce symbols which no relation uses."""
    used = with_bases(names_of(solution.steps), solution)
    yield from (step.text for step in solution.steps if step.kind != "names" or used & {*introduced_names(step.text)})


def _needed(solution: Solution, known: Collection[str], known_texts: Container[str]) -> list[Step]:
    """Return the steps from known names to the goal, and their reasons whose texts are not in `known_texts`.

    The steps that exclude earlier collisions are kept with everything on which they depend.
    """
    last = next((step for step in reversed(solution.steps) if solution.goal in step.gives), None)
    orders = [step for step in solution.steps if step.kind == ORDER and step.text not in known_texts]
    waiting, kept = [*orders, *([last] if last is not None else [])], dict[int, Step]()
    while waiting:
        step = waiting.pop()
        if step.id in kept:
            continue
        kept[step.id] = step
        waiting += [solution.steps[need] for need in step.needs if not _is_known(solution.steps[need], step, known)]
    if _results(kept.values()) < _results(solution.steps):
        kept |= {step.id: step for step in _reasons(solution, kept, known, known_texts)}
    return [kept[number] for number in sorted(kept)]


def _reasons(
    solution: Solution, kept: Collection[int], known: Collection[str], known_texts: Container[str]
) -> Iterator[Step]:
    """Yield the steps that give reasons for the kept steps, except those whose texts are in `known_texts`."""
    for step in solution.steps:
        needs = [needed_step for need in step.needs if (needed_step := solution.steps[need]).gives]
        missing = [needed_step for needed_step in needs if needed_step.id not in kept]
        if _is_reason(step) and step.text not in known_texts and len(missing) < max(len(needs), 1):
            yield from [step] if all(_is_known(needed_step, step, known) for needed_step in missing) else []


def _is_reason(step: Step) -> bool:
    """Return whether a step only verifies an assumption or gives the reason for an extreme value."""
    return step.kind in REASON_STEP_KINDS or (bool(step.relations) and all(r.role in CHECKS for r in step.relations))


def _is_known(needed: Step, step: Step, known: Collection[str]) -> bool:
    """Return whether all names that a step takes from another step are known."""
    taken = {*needed.gives} & {*step.symbols()} or {*needed.gives}
    return bool(taken) and taken <= {*known}


def reduce_givens(step: Step, used: Collection[str]) -> Step:
    """Reduce the step that lists the given numbers to the names in use."""
    given_texts = re.findall(r"\$[^$]*\$(?: \([a-z]+\))?", step.text)
    if len(given_texts) != len(step.relations):
        return step
    pairs = [
        (text, r)
        for text, r in zip(given_texts, step.relations, strict=True)
        if not {*r.left.symbols()}.isdisjoint(used)
    ]
    lead, colon, _ = step.text.partition(": ")
    texts = [text for text, _ in pairs]
    return replace(
        step, text=f"{lead}{colon}{join_words(texts)}." if texts else "", relations=tuple(r for _, r in pairs)
    )


def _recalled(known: Mapping[str, str], solution: Solution) -> list[Step]:
    """Return the steps that cite known results, one for each earlier part."""
    steps: list[Step] = []
    for label in sorted({*known.values()}):
        names = [name for name in known if known[name] == label]
        relations = [Relation(Symbol(n), Number(solution.values[n]), "given", unit_of(n, solution)) for n in names]
        equations = [
            f"${r.left.latex()} = {with_unit(solution.values[n], r.unit)}$"
            for n, r in zip(names, relations, strict=True)
        ]
        steps.append(
            Step(
                -1,
                RECALLED_STEP_KIND,
                f"From part ({label}), {join_words(equations)}.",
                tuple(relations),
                tuple(names),
                (),
            )
        )
    return steps
