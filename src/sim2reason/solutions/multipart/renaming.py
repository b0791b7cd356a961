"""Renaming of quantities in solutions, and numbering of times in the order of the text."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import fields, is_dataclass, replace
from typing import Any, cast

from sim2reason.solutions.algebra.evaluated import NumericRoot
from sim2reason.solutions.algebra.expressions import Expression, Symbol
from sim2reason.solutions.solution import Accumulated, Coordinate, Integration, Relation, Solution, Step
from sim2reason.solutions.writing.subscripts import split_name, with_subscript

_BELOW = r"_(?:\\[A-Za-z]+|[A-Za-z0-9]|\{(?:[^{}]|\{[^{}]*\})*\})"
_NAME = rf"(?:\\[A-Za-z]+|[A-Za-z])'*(?:{_BELOW})?"
TOKEN = re.compile(
    r"(?P<upright>\\(?:text|mathrm|operatorname)\{[^{}]*\})"
    rf"|(?P<dots>\\dd?ot)\{{(?P<inside>{_NAME})\}}(?P<below>{_BELOW})?"
    rf"|(?P<measure>d(?=\\vartheta))|(?P<name>{_NAME})"
)
"""Tokens of a formula: upright words, names below dots, the differential d of an integral, and names."""

Names = Mapping[str, str]


def rename_solution(solution: Solution, names: Names) -> Solution:
    """Return a solution with names replaced; names missing from the mapping are kept."""
    names = {old: new for old, new in names.items() if old != new}
    if not names:
        return solution

    def of(name: str) -> str:
        return names.get(name, name)

    return replace(
        solution,
        steps=tuple(renamed_step(step, names) for step in solution.steps),
        values={of(name): value for name, value in solution.values.items()},
        goal=of(solution.goal),
        stated=tuple(map(of, solution.stated)),
        constants={of(name): value for name, value in solution.constants.items()},
        phases=tuple(
            replace(p, begins=rename_in_text(p.begins, names), ends=rename_in_text(p.ends, names))
            for p in solution.phases
        ),
    )


def rename_in_formula(held: Expression, names: Names) -> Expression:
    """Return a formula with names replaced."""
    if isinstance(held, Symbol):
        return Symbol(names.get(held.name, held.name))
    if not is_dataclass(held):
        return held
    changed: dict[str, object] = {}
    for field in fields(held):
        value: object = getattr(held, field.name)
        if isinstance(value, Expression | tuple):
            changed[field.name] = _inside(cast("Expression | tuple[object, ...]", value), names)
        elif isinstance(held, NumericRoot) and field.name == "name":
            changed[field.name] = names.get(held.name, held.name)
    return cast("Expression", replace(cast("Any", held), **changed))


def in_relation(relation: Relation, names: Names) -> Relation:
    """Return a relation with names replaced."""
    return replace(
        relation, left=rename_in_formula(relation.left, names), right=rename_in_formula(relation.right, names)
    )


def rename_in_text(text: str, names: Names, relations: Sequence[Relation] = ()) -> str:
    """Return a text with names replaced in its formulas; formulas of given relations are typeset again."""
    parts = text.split("$")
    for number in range(1, len(parts), 2):
        part = _in_latex(parts[number], names)
        for relation in relations:
            new = in_relation(relation, names)
            for old_side, new_side in ((relation.left, new.left), (relation.right, new.right)):
                part = part.replace(_in_latex(old_side.latex(), names), new_side.latex())
        parts[number] = part
    return "$".join(parts)


def names_in_text(text: str) -> frozenset[str]:
    """Return all names in the formulas of a text."""
    found: set[str] = set()
    for part in text.split("$")[1::2]:
        for match in TOKEN.finditer(part):
            if match["name"] or match["inside"]:
                found.add(_plain(match["name"] or match["inside"] + (match["below"] or "")))
    return frozenset(found)


def _inside(value: "Expression | tuple[object, ...]", names: Names) -> object:
    if isinstance(value, Expression):
        return rename_in_formula(value, names)
    return tuple(
        _inside(cast("Expression | tuple[object, ...]", held), names)
        if isinstance(held, Expression | tuple)
        else names.get(held, held)
        if isinstance(held, str)
        else held
        for held in value
    )


def renamed_step(step: Step, names: Names) -> Step:
    """Return a step with names replaced; names missing from the mapping are kept."""
    held = step.integration
    return replace(
        step,
        text=rename_in_text(step.text, names, step.relations),
        relations=tuple(in_relation(relation, names) for relation in step.relations),
        gives=tuple(names.get(name, name) for name in step.gives),
        integration=None if held is None else _integration(held, names),
    )


def _integration(held: Integration, names: Names) -> Integration:
    """Return an initial-value problem with names replaced."""

    def of(name: str) -> str:
        return names.get(name, name)

    return replace(
        held,
        time=of(held.time),
        begin=rename_in_formula(held.begin, names),
        coordinates=tuple(
            Coordinate(
                of(c.place),
                of(c.rate),
                of(c.acceleration),
                rename_in_formula(c.initial_place, names),
                rename_in_formula(c.initial_rate, names),
            )
            for c in held.coordinates
        ),
        unknowns=tuple(map(of, held.unknowns)),
        equations=tuple(in_relation(relation, names) for relation in held.equations),
        until=replace(held.until, expression=rename_in_formula(held.until.expression, names)),
        ends=tuple((of(symbol), of(name)) for symbol, name in held.ends),
        accumulated=tuple(
            Accumulated(of(a.name), rename_in_formula(a.rate, names), rename_in_formula(a.initial, names))
            for a in held.accumulated
        ),
    )


def _in_latex(text: str, names: Names) -> str:
    return TOKEN.sub(lambda match: _token(match, names), text)


def _token(match: re.Match[str], names: Names) -> str:
    said = match["name"] or (match["inside"] or "") + (match["below"] or "")
    new = names.get(_plain(said)) if said else None
    if new is None:
        return match[0]
    if match["name"]:
        return new
    base, mark = split_name(new)
    return f"{match['dots']}{{{base}}}" + (f"_{{{mark}}}" if mark else "")


def _plain(name: str) -> str:
    base, mark = split_name(name)
    return with_subscript(base, mark)


TIME = re.compile(r"t(?:_(?:(\d)|\{(\d+)\}))?")  # the symbol t, with its number if it has one


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
