"""Worked solutions of problems with several parts, later ones starting from earlier results, or with options."""

import re
from collections.abc import Container, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, replace

from sim2reason.grading.parts import LABELS
from sim2reason.solutions.algebra.expressions import Number, Symbol
from sim2reason.solutions.setting import joined
from sim2reason.solutions.solution import Relation, Solution, Step, with_unit

SAME = 1e-9  # relative: two values that differ by less are those of one quantity
EARLIER = "earlier part"
SPOKEN = "verify", "extreme"  # kinds of steps that give no name, but the reason for one that does
_BOX = re.compile(r"\\boxed\{([^{}]*(?:\{[^{}]*\}[^{}]*)*)\}")
_NAMED = re.compile(r"\$(\\?[A-Za-z]+(?:_(?:\{(?:[^{}$]|\{[^{}$]*\})*\}|\w))?)\$")


@dataclass(frozen=True, slots=True)
class PartsSolution(Solution):
    """The solutions of all parts as one; its goal and answer are those of the last part."""

    parts: tuple[Solution, ...] = ()

    @property
    def derived(self) -> bool:
        """Whether the answers to all parts are derived."""
        return bool(self.parts) and all(part.derived for part in self.parts)

    @property
    def text(self) -> str:
        """The solutions behind their labels, and all answers in one box."""
        told = [f"({label}) {_told(part)}" for label, part in zip(LABELS, self.parts, strict=False)]
        if self.answer is not None:
            boxes = (_BOX.search(part.text) for part in self.parts)
            said = "; ".join(f"({label}) {box[1] if box else ''}" for label, box in zip(LABELS, boxes, strict=False))
            told.append(rf"Answers: $\boxed{{{said}}}$.")
        return "\n\n".join(told)


@dataclass(frozen=True, slots=True)
class ChosenSolution(Solution):
    """A solution whose answer is one of several options."""

    letter: str = ""

    @property
    def text(self) -> str:
        """The solution of the question without options, and the letter in a box."""
        text = _BOX.sub(r"\1", super(ChosenSolution, self).text)
        return f"{text}\n\n" + rf"That is option $\boxed{{\text{{{self.letter}}}}}$."


def chosen(solution: Solution, letter: str) -> Solution:
    """The solution of a multiple choice from that of its question."""
    held = {each.name: getattr(solution, each.name) for each in fields(Solution)}
    return ChosenSolution(**held, letter=letter)


def together(parts: Sequence[Solution]) -> Solution:
    """One solution of all parts; without an answer where a part has none, and then it says of which."""
    for label, part in zip(LABELS, parts, strict=False):
        if part.answer is None:
            return Solution("", reason=f"part ({label}): {part.reason}")
    names = dict.fromkeys(part.strategy for part in parts)
    last = parts[-1]
    return PartsSolution(
        "; ".join(names),
        tuple(_in_one_row(parts)),
        last.values,
        last.goal,
        answer=last.answer,
        unit=last.unit,
        parts=tuple(parts),
    )


def starting_from(solution: Solution, earlier: Sequence[tuple[str, Solution]], *, whole: bool = False) -> Solution:
    """The solution with the results of earlier parts, by their labels, in place of the steps that lead to them.

    With `whole`, with all that the solutions of earlier parts find on their way, too. It stays as it is where no step
    can be left out, and where its motion has several phases or is integrated.
    """
    if solution.answer is None or solution.phases or any(step.integration is not None for step in solution.steps):
        return solution
    known: dict[str, tuple[str, Solution]] = {}
    for name in _found(solution):
        source = next((held for held in earlier if _is_told(name, solution, held[1], whole=whole)), None)
        if source is not None:
            known[name] = source
    kept = _needed(solution, known)
    said = {step.text for _, other in earlier for step in other.steps} if whole else set[str]()
    if len(kept) < sum(bool(step.gives) for step in solution.steps):
        kept += _verifications(solution, kept, known, said)
    used = {name for step in kept for name in _symbols(step)} & known.keys()
    given = {name for step in kept for name in step.gives}
    if not used - given or sum(bool(step.gives) for step in kept) >= sum(bool(step.gives) for step in solution.steps):
        return solution
    kept = sorted([*kept, *_introductions(solution, kept, said)], key=lambda step: step.id)
    first = [_givens(step, kept) for step in solution.steps if step.kind == "givens"]
    told = _recalled({name: known[name][0] for name in known if name in used - given}, solution)
    return replace(solution, steps=_renumbered([*first, *told, *kept]))


def _told(part: Solution) -> str:
    """Return the text of one part, without a box."""
    return _BOX.sub(r"\1", part.text)


def _in_one_row(parts: Sequence[Solution]) -> Iterator[Step]:
    """The steps of all parts, counted from zero."""
    count = 0
    for part in parts:
        for step in part.steps:
            yield replace(step, id=step.id + count, needs=tuple(need + count for need in step.needs))
        count += len(part.steps)


def _found(solution: Solution) -> list[str]:
    """The names that a solution finds on its way."""
    given = {name for step in solution.steps for name in step.gives}
    return [name for name in solution.values if name in given and name != solution.goal]


def _is_told(name: str, solution: Solution, other: Solution, *, whole: bool) -> bool:
    """Whether another solution leads to a name of a solution, or finds it on its way, where `whole` counts that."""
    if other.answer is None:
        return False
    found = [(other.goal, other.unit)]
    if whole and any(name in step.gives and step.kind != EARLIER for step in other.steps):
        found.append((name, _unit(name, other)))
    value, unit = solution.values[name], _unit(name, solution)
    if abs(other.values.get(name, value) - value) > SAME * abs(value) or _is_opposite(other):
        found = [(known, said) for known, said in found if known == name]  # its goal is another quantity of this size
    return any(unit == said and abs(value - other.values[known]) <= SAME * abs(value) for known, said in found)


def _is_opposite(solution: Solution) -> bool:
    """Return whether the last relation only changes a sign, as from a displacement to a compression."""
    last = [held.right for held in solution.relations if held.left.latex() == solution.goal]
    return bool(last) and isinstance(-last[-1], Symbol)


def _introductions(solution: Solution, kept: Sequence[Step], said: Container[str]) -> list[Step]:
    """Return the steps that define symbols of the kept steps, as *let x be the displacement*, unless `said`."""
    symbols = {name for step in kept for name in _symbols(step)}
    symbols |= {name.partition("_")[0] for name in symbols}
    found = (step for step in solution.steps if step.kind == "names" and step not in kept and step.text not in said)
    return [step for step in found if symbols & {*_NAMED.findall(step.text)}]


def _verifications(
    solution: Solution, kept: Sequence[Step], known: Mapping[str, tuple[str, Solution]], said: Container[str]
) -> list[Step]:
    """Return the steps with the reasons for the kept steps, unless they are `said`."""
    numbers, found = {step.id for step in kept}, list[Step]()
    for step in solution.steps:
        needs = [held for need in step.needs if (held := solution.steps[need]).gives]
        apart = [held for held in needs if held.id not in numbers]
        if step.kind in SPOKEN and step.text not in said and len(apart) < max(len(needs), 1):
            found += [step] if all(_is_known(held, step, known) for held in apart) else []
    return found


def _unit(name: str, solution: Solution) -> str:
    return next(
        (r.unit for r in solution.relations if isinstance(r.left, Symbol) and r.left.name == name and r.unit), ""
    )


def _symbols(step: Step) -> set[str]:
    return {name for relation in step.relations for name in relation.symbols()}


def _needed(solution: Solution, known: dict[str, tuple[str, Solution]]) -> list[Step]:
    """The steps that lead to the goal if some names are known."""
    last = next((step for step in reversed(solution.steps) if solution.goal in step.gives), None)
    waiting, kept = [last] if last is not None else [], dict[int, Step]()
    while waiting:
        step = waiting.pop()
        if step.id in kept:
            continue
        kept[step.id] = step
        waiting += [solution.steps[need] for need in step.needs if not _is_known(solution.steps[need], step, known)]
    return [kept[number] for number in sorted(kept)]


def _is_known(needed: Step, step: Step, known: Mapping[str, tuple[str, Solution]]) -> bool:
    """Whether all that a step takes from another is known: names alone, no equations by their labels."""
    taken = set(needed.gives) & _symbols(step)
    return bool(taken) and taken <= known.keys()


def _givens(step: Step, kept: Sequence[Step]) -> Step:
    """What the text gives, as far as the steps need it."""
    used = {name for held in kept for name in _symbols(held)}
    said = re.findall(r"\$[^$]*\$", step.text)
    if len(said) != len(step.relations):
        return step
    pairs = [(text, r) for text, r in zip(said, step.relations, strict=True) if used & set(r.left.symbols())]
    lead, colon, _ = step.text.partition(": ")
    texts = [text for text, _ in pairs]
    return replace(step, text=f"{lead}{colon}{joined(texts)}." if texts else "", relations=tuple(r for _, r in pairs))


def _recalled(known: dict[str, str], solution: Solution) -> list[Step]:
    """The results of earlier parts, by the names that this solution has for them: a step for each part."""
    steps: list[Step] = []
    for label in sorted({*known.values()}):
        names = [name for name in known if known[name] == label]
        relations = [Relation(Symbol(n), Number(solution.values[n]), "given", _unit(n, solution)) for n in names]
        said = [
            f"${r.left.latex()} = {with_unit(solution.values[n], r.unit)}$"
            for n, r in zip(names, relations, strict=True)
        ]
        steps.append(Step(-1, EARLIER, f"From part ({label}), {joined(said)}.", tuple(relations), tuple(names), ()))
    return steps


def _renumbered(steps: Sequence[Step]) -> tuple[Step, ...]:
    """Steps counted from zero, each with those of its needs that are left, and with recalled results it uses."""
    place = {step.id: number for number, step in enumerate(steps) if step.id >= 0}
    recalled = {name: number for number, step in enumerate(steps) if step.kind == EARLIER for name in step.gives}
    found: list[Step] = []
    for number, step in enumerate(steps):
        needs = {place[need] for need in step.needs if need in place}
        needs |= {recalled[name] for name in _symbols(step) if name in recalled and step.kind != EARLIER}
        found.append(replace(step, id=number, needs=tuple(sorted(needs))))
    return tuple(found)
