"""Arrangement of steps: equal sentences merged, long chains of collisions as lists, arguments in order."""

import re
from collections.abc import Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import replace

from sim2reason.scenes.dsl.frames import Frames
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.vectors import dot, subtract_triples
from sim2reason.solutions.algebra.polynomials import Polynomial
from sim2reason.solutions.setting import capitalized, join_words
from sim2reason.solutions.solution import Step
from sim2reason.solutions.writing.lexicon import DualValue, Lexicon, UnreadError

BEGIN = frozenset({"other value", "names"})
"""Kinds of steps that begin a second case or name new unknowns; later steps are not moved before them."""
SENTENCE = re.compile(r"(?P<lead>((At|After the time|In the time) \$[^$]*\$)?[^$]*) (?P<formulas>\$[^$]*\$)\.")

SINGULAR_PLURAL = "the displacement is", "the displacements are"


def merge_steps(steps: Sequence[Step]) -> list[Step]:
    """Return steps in which those with like sentences form one step at the position of the first."""
    groups: list[list[Step]] = []
    group_ids: dict[int, int] = {}  # from the number of a step to that of the step with which it is merged
    start = 0
    for step in steps:
        start = len(groups) if step.kind in BEGIN else start
        renumbered = replace(step, needs=tuple(sorted({group_ids[n] for n in step.needs if n in group_ids})))
        group = next(
            (group for group in groups[start:] if _can_merge(group[0], renumbered, follows=group is groups[-1])), None
        )
        if group is None:
            groups.append(group := [])
        group.append(renumbered)
        group_ids[step.id] = group[0].id
    return [_merge_group(group) for group in groups]


def _can_merge(first: Step, other: Step, *, follows: bool) -> bool:
    """Return whether a later step can be merged with an earlier one: same words, and no use of results in between.

    A step that `follows` directly may use all earlier results; another one no more than the first step does.
    """
    one, two = SENTENCE.fullmatch(first.text), SENTENCE.fullmatch(other.text)
    same_words = one is not None and two is not None and one["lead"] == two["lead"]
    known = {*other.needs} == {*first.needs} or bool(other.needs and {*other.needs} < {*first.needs})
    known = known or (follows and all(number < first.id for number in other.needs))
    return (
        same_words
        and (first.kind, first.phase) == (other.kind, other.phase)
        and known
        and bool(first.gives and other.gives)
    )


def _merge_group(group: Sequence[Step]) -> Step:
    """Combine steps whose sentences differ only in their formulas into one step with all formulas."""
    if len(group) == 1:
        return group[0]
    matches = [match for step in group if (match := SENTENCE.fullmatch(step.text)) is not None]
    lead = matches[0]["lead"].replace(*SINGULAR_PLURAL)
    return merge_group_into(group, f"{lead} {join_words([match['formulas'] for match in matches])}.")


def merge_group_into(group: Sequence[Step], text: str) -> Step:
    """Combine several steps into one with a given text and the number of the first."""
    return replace(
        group[0],
        text=text,
        relations=tuple(relation for step in group for relation in step.relations),
        gives=tuple(name for step in group for name in step.gives),
        needs=tuple(sorted({n for step in group for n in step.needs})),
    )


Side = tuple[Frames, Mechanism]


def gap_at_start(lexicon: Lexicon, frames: tuple[Frames, Frames], number: int) -> Polynomial:
    """Return the initial gap of a pair, m; UnreadError if it is no simple function of the stated numbers.

    For a disc and a wall, the gap may be a sum of three lengths: the positions of wall and disc, and the radius.
    """
    sides: list[Side] = [(frames[0], lexicon.mechanism), (frames[1], lexicon.twin)]
    gap_value = DualValue(*(_place(*side, number) - side[1].meetings[number].distance for side in sides))
    try:
        return lexicon.read(gap_value)
    except UnreadError:
        gap = _of_three(lexicon, gap_value) if lexicon.mechanism.meetings[number].a is None else None
        if gap is None:
            raise
        return gap


def _of_three(lexicon: Lexicon, gap_value: DualValue) -> Polynomial | None:
    """Return a gap as a stated length, or its negative, plus a sum of two lengths; None if no length fits."""
    for length in reversed(lexicon.lengths):
        for sign in (1.0, -1.0):
            try:
                rest = lexicon.read(gap_value - DualValue(sign * length.value, sign * length.twin_value))
            except UnreadError:
                continue
            return lexicon.read(length).scale(sign) + rest
    return None


def _place(frames: Frames, mechanism: Mechanism, number: int) -> float:
    """Return the position of a pair's second body along the normal, relative to the first or, for walls, the origin."""
    met = mechanism.meetings[number]
    assert met.normal is not None
    other = frames.center(met.b).place
    return float(dot(met.normal, other if met.a is None else subtract_triples(other, frames.center(met.a).place)))


MIN_NAMES_FOR_ROWS = 6  # names defined by steps of these kinds, from which on lists are easier to follow
VELOCITY, TIME, DISPLACEMENT = "velocity in flight", "time of flight", "displacement in flight"  # kinds of steps
GROUPED = VELOCITY, TIME, DISPLACEMENT
ROWS = {VELOCITY: "velocities", DISPLACEMENT: "displacements"}
SINGULAR = {"velocities": "velocity", "displacements": "displacement"}
INSTANT = re.compile(r"At (\$[^$]*\$) ")  # matches the time with which a sentence begins


def group_steps(steps: Sequence[Step]) -> list[Step]:
    """Return the steps of a long text with those of one kind combined; a short text is unchanged."""
    waiting = list(steps)
    if sum(len(step.gives) for step in waiting if step.kind in GROUPED) < MIN_NAMES_FOR_ROWS:
        return waiting
    written, grouped, group_ids = set[int](), list[Step](), dict[int, int]()
    while waiting:
        group: list[Step] = [waiting.pop(0)]
        kind = group[0].kind
        written.add(group[0].id)
        while kind in GROUPED and (more := [s for s in waiting if s.kind == kind and written.issuperset(s.needs)]):
            group += more
            written.update(step.id for step in more)
            waiting = [step for step in waiting if step.id not in written]
        rows = group if kind == TIME else [_row(group)]  # times count from different events
        group_ids |= {step.id: (step if kind == TIME else group[0]).id for step in group}
        grouped += rows
    return [
        replace(s, needs=tuple(sorted({group_ids[n] for n in s.needs if n in group_ids} - {s.id}))) for s in grouped
    ]


def without_repeats(steps: Sequence[Step]) -> list[Step]:
    """Shorten or remove the sentences in steps about collisions that repeat an earlier step."""
    seen, shortened = set[str](), list[Step]()
    for step in steps:
        text, (lead, *_) = step.text, step.text.split("$", 1)
        if step.kind == "impulse" and lead in seen:
            text = text.replace(lead, "In the same way, ", 1)
        first, end, rest = text.partition(". ")
        if step.kind == "relative" and first in seen:
            text = rest
        seen |= {lead, first} if end else {lead}
        shortened.append(replace(step, text=text))
    return shortened


def _row(group: Sequence[Step]) -> Step:
    """Combine steps of one kind into one step that lists their formulas by instant; a single step is unchanged."""
    if group[0].kind not in ROWS or len(group) == 1:
        return group[0]
    rows: dict[str, list[str]] = {}
    for step in group:
        instants = set(INSTANT.findall(step.text))
        formulas = [f"${formula}$" for formula in step.text.split("$")[1::2][-len(step.gives) :]]
        rows.setdefault(instants.pop() if len(instants) == 1 else "", []).extend(formulas)
    noun = ROWS[group[0].kind]
    clauses = [
        f"{f'at {instant} ' if instant else ''}the {noun if len(formulas) > 1 else SINGULAR[noun]} "
        f"{'are' if len(formulas) > 1 else 'is'} {join_words(formulas)}"
        for instant, formulas in rows.items()
    ]
    return merge_group_into(group, f"{capitalized('; '.join(clauses))}.")


ORDER = "order of collisions"  # kind of these steps

LAST = "so there is no further collision"  # ends the argument about the last flights, before the end time
SOLVE_KIND = "solve for the unknown"  # kind of the steps that solve for the unknown

OUTCOME = frozenset({"after", "solve"})  # kinds of the steps that give velocities just after a collision


def in_order(steps: Sequence[Step], earliest: Mapping[int, int], late: AbstractSet[str]) -> list[Step]:
    """Move each argument about the order of collisions behind the steps with its numbers and the first collision time.

    `earliest` has, for each argument, the index of the step from which on that collision is sought. An argument with
    names that are known only at the end, `late`, stays in its position; its conclusion is assumed before the unknown is
    solved for.
    """
    ordered = [step for step in steps if step.kind != ORDER or not late.isdisjoint(step.symbols())]
    for step in steps:
        if step in ordered:
            continue
        used = {name for r in step.relations if r.role == "verified" for name in r.right.symbols()}
        after = [n for n, other in enumerate(ordered) if used & {*other.gives}]
        begins = earliest[step.id]
        times = (n for n, other in enumerate(ordered) if other.kind == "impact time" and other.id >= begins)
        first = next(times, next((n - 1 for n, other in enumerate(ordered) if other.id >= begins), len(ordered) - 1))
        index = max([first, *after]) + 1
        while index < len(ordered) and ordered[index].kind in OUTCOME:
            index += 1
        ordered.insert(index, step)
    return _with_supposition(ordered)


def _with_supposition(steps: Sequence[Step]) -> list[Step]:
    """Insert a sentence before the unknown is solved for, with the assumptions verified only later."""
    solved = next((n for n, step in enumerate(steps) if step.kind == SOLVE_KIND), len(steps))
    late = next((step for step in steps[solved:] if step.kind == ORDER and LAST in step.text), None)
    if late is None:
        return [*steps]
    until = late.text.rpartition(LAST)[2]
    text = f"This supposes that there is no further collision{until.removesuffix('.')}, which is verified below."
    supposition = Step(max(step.id for step in steps) + 1, "supposition", text, (), (), ())
    return [*steps[:solved], supposition, *steps[solved:]]
