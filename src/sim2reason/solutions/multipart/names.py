"""Names of quantities in several parts: which denote the same quantity, and their renaming in solutions."""

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, fields, is_dataclass, replace
from typing import Any, cast

from sim2reason.solutions.algebra.evaluated import NumericRoot
from sim2reason.solutions.algebra.expressions import Expression, Symbol
from sim2reason.solutions.data import Tree, tree
from sim2reason.solutions.solution import Accumulated, Coordinate, Integration, Relation, Solution, Step
from sim2reason.solutions.writing.notation import split_name, with_subscript

VALUE_RTOL = 1e-9  # relative tolerance within which two values belong to one quantity
LABEL = re.compile(r"\(\d+\)")
_INTRODUCED = re.compile(r"\$(?P<name>[^$=]+)\$ (?P<words>(?:[^$;.]|\.(?=\d))+?)(?= and \$|, and |[;.]|$)")
_SAID = re.compile(r"be the [a-z]+ ")


@dataclass
class NamedQuantity:
    """A quantity with its name in each part, by the index of the part."""

    members: dict[int, str]
    stem: str
    value: float | None
    unit: str | None  # None if the text states no value
    stated: bool
    meaning: str = ""
    formula: Tree | None = None
    places: list[tuple[int, int]] = field(default_factory=list[tuple[int, int]])

    def has(self, other: "NamedQuantity") -> bool:
        """Return whether another quantity has equal value and unit, where known, and is likewise given or computed."""
        if self.stated != other.stated or (None not in (self.unit, other.unit) and self.unit != other.unit):
            return False
        if self.value is None or other.value is None:
            return self.value is other.value
        return abs(self.value - other.value) <= VALUE_RTOL * abs(self.value)


def quantities(solutions: Sequence[Solution], fixed: Collection[str]) -> list[NamedQuantity]:
    """Return all quantities in the order of the parts; `fixed` names mean the same in all and are left out."""
    collected: list[NamedQuantity] = []
    for part, solution in enumerate(solutions):
        own = [*_own(part, solution, {*fixed, *solution.constants})]
        index_by_name: dict[str, int] = {}
        for number, (name, quantity) in enumerate(own):
            right = _formula(solution, name)
            quantity.formula = None if right is None else _by_number(tree(right), index_by_name)
            rest = [other for each, other in own if each != name]
            known = _known(collected, part, name, quantity, rest)
            if known is None:
                collected.append(quantity)
                known = quantity
            known.members[part] = name
            known.places.append((part, number))
            known.meaning = known.meaning or quantity.meaning
            index_by_name[name] = next(n for n, each in enumerate(collected) if each is known)
    return collected


def meanings(solution: Solution) -> dict[str, str]:
    """Return the meanings, in words by name, that a solution introduces in its text."""
    words_by_name: dict[str, str] = {}
    for step in solution.steps:
        if step.kind == "names" or step.text.startswith("Let $"):
            for match in _INTRODUCED.finditer(step.text):
                words_by_name[match["name"]] = _SAID.sub("", match["words"].strip())
    return words_by_name


def introduced_names(text: str) -> list[str]:
    """Return the names that a text introduces in words."""
    return [match["name"] for match in _INTRODUCED.finditer(text)]


def are_same_meaning(name: str, one: str, other: str) -> bool:
    """Return whether two introductions of a name, in words, can describe one quantity.

    They are equal, or both mention the body in its subscript: a_A *of blocks A and B*, and *of block A*.
    """
    body = split_name(name)[1]
    if not one or not other or one == other:
        return True
    return len(body) == 1 and body.isupper() and all(re.search(rf"\b{body}\b", words) for words in (one, other))


def unit_of(name: str, solution: Solution) -> str:
    """Return the unit of a name, in LaTeX; empty if the text states none."""
    if name == solution.goal:
        return solution.unit
    units = (r.unit for r in solution.relations if isinstance(r.left, Symbol) and r.left.name == name and r.unit)
    return next(units, "")


def names_of(steps: Sequence[Step]) -> Iterator[str]:
    """Yield the names of quantities in steps, some more than once; labels of equations are excluded."""
    for step in steps:
        yield from step.symbols()
        integration = step.integration
        if integration is not None:
            yield from (integration.time, *integration.unknowns, *(each.name for each in integration.accumulated))
            yield from (name for c in integration.coordinates for name in (c.place, c.rate, c.acceleration))
        mentioned = {r.left.latex() for r in step.relations} | (
            {name for _, name in integration.ends} if integration else set[str]()
        )
        yield from (name for name in step.gives if name in mentioned)


def _own(part: int, solution: Solution, fixed: Collection[str]) -> Iterator[tuple[str, NamedQuantity]]:
    """Yield each name of a part with its quantity, beginning with those that the question states."""
    words, given = meanings(solution), {name for step in solution.steps for name in step.gives}
    for name in dict.fromkeys([*solution.stated, *names_of(solution.steps)]):
        if name not in fixed:
            value, stated = solution.values.get(name), name in solution.stated
            unit = unit_of(name, solution) if stated or name in given else None
            yield name, NamedQuantity({part: name}, split_name(name)[0], value, unit, stated, words.get(name, ""))


def _formula(solution: Solution, name: str) -> Expression | None:
    formulas = (
        r.right
        for step in solution.steps
        if name in step.gives
        for r in step.relations
        if isinstance(r.left, Symbol) and r.left.name == name and r.role in ("law", "result")
    )
    return next(formulas, None)


def _by_number(node: Tree, index_by_name: Mapping[str, int]) -> Tree:
    """Return a formula with the indices of quantities in place of their names."""
    if isinstance(node, str):
        return f"#{index_by_name[node]}" if node in index_by_name else node
    return [node[0], *(_by_number(each, index_by_name) for each in node[1:])] if isinstance(node, list) else node


def _known(
    earlier: Sequence[NamedQuantity], part: int, name: str, quantity: NamedQuantity, rest: Sequence[NamedQuantity]
) -> NamedQuantity | None:
    """Return the quantity of earlier parts that a name denotes, by meaning, formula, name or value; None if new."""
    alike = [q for q in earlier if part not in q.members and q.stem == quantity.stem and q.has(quantity)]
    alike = [q for q in alike if _same(q, quantity, name)]
    by_words = [q for q in alike if quantity.meaning and q.meaning == quantity.meaning]
    by_formula = [q for q in alike if quantity.formula is not None and q.formula == quantity.formula]
    by_name = [q for q in alike if name in q.members.values()]
    for group in (by_words, by_formula, by_name):
        if group:
            return group[0]
    alone = len(alike) == 1 and not any(other.stem == quantity.stem and other.has(quantity) for other in rest)
    by_value = alone and all(_marks_agree(name, each) for each in alike[0].members.values())
    return alike[0] if by_value and quantity.value is not None else None


def _same(quantity: NamedQuantity, other: NamedQuantity, name: str) -> bool:
    if not (quantity.meaning and other.meaning) or quantity.meaning == other.meaning:
        return True
    return name in quantity.members.values() and are_same_meaning(name, quantity.meaning, other.meaning)


def _marks_agree(one: str, other: str) -> bool:
    """Return whether the subscripts of two names allow them to denote one quantity."""
    subscripts = (split_name(name)[1].split(",") for name in (one, other))
    marks = [{part for part in parts if part.isalpha() and len(part) == 1} for parts in subscripts]
    return not all(marks) or marks[0] == marks[1]


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


def rename_in_formula(formula: Expression, names: Names) -> Expression:
    """Return a formula with names replaced."""
    if isinstance(formula, Symbol):
        return Symbol(names.get(formula.name, formula.name))
    if not is_dataclass(formula):
        return formula
    changed: dict[str, object] = {}
    for entry in fields(formula):
        value: object = getattr(formula, entry.name)
        if isinstance(value, Expression | tuple):
            changed[entry.name] = _inside(cast("Expression | tuple[object, ...]", value), names)
        elif isinstance(formula, NumericRoot) and entry.name == "name":
            changed[entry.name] = names.get(formula.name, formula.name)
    return cast("Expression", replace(cast("Any", formula), **changed))


def in_relation(relation: Relation, names: Names) -> Relation:
    """Return a relation with names replaced."""
    left, right = (rename_in_formula(side, names) for side in (relation.left, relation.right))
    return replace(relation, left=left, right=right)


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
    names: set[str] = set()
    for part in text.split("$")[1::2]:
        for match in TOKEN.finditer(part):
            if match["name"] or match["inside"]:
                names.add(_plain(match["name"] or match["inside"] + (match["below"] or "")))
    return frozenset(names)


def _inside(value: "Expression | tuple[object, ...]", names: Names) -> object:
    if isinstance(value, Expression):
        return rename_in_formula(value, names)
    return tuple(
        _inside(cast("Expression | tuple[object, ...]", item), names)
        if isinstance(item, Expression | tuple)
        else names.get(item, item)
        if isinstance(item, str)
        else item
        for item in value
    )


def renamed_step(step: Step, names: Names) -> Step:
    """Return a step with names replaced; names missing from the mapping are kept."""
    integration = step.integration
    return replace(
        step,
        text=rename_in_text(step.text, names, step.relations),
        relations=tuple(in_relation(relation, names) for relation in step.relations),
        gives=tuple(names.get(name, name) for name in step.gives),
        integration=None if integration is None else _integration(integration, names),
    )


def _integration(integration: Integration, names: Names) -> Integration:
    """Return an initial-value problem with names replaced."""

    def of(name: str) -> str:
        return names.get(name, name)

    return replace(
        integration,
        time=of(integration.time),
        begin=rename_in_formula(integration.begin, names),
        coordinates=tuple(
            Coordinate(
                of(c.place),
                of(c.rate),
                of(c.acceleration),
                rename_in_formula(c.initial_place, names),
                rename_in_formula(c.initial_rate, names),
            )
            for c in integration.coordinates
        ),
        unknowns=tuple(map(of, integration.unknowns)),
        equations=tuple(in_relation(relation, names) for relation in integration.equations),
        until=replace(integration.until, expression=rename_in_formula(integration.until.expression, names)),
        ends=tuple((of(symbol), of(name)) for symbol, name in integration.ends),
        accumulated=tuple(
            Accumulated(of(a.name), rename_in_formula(a.rate, names), rename_in_formula(a.initial, names))
            for a in integration.accumulated
        ),
    )


def _in_latex(text: str, names: Names) -> str:
    return TOKEN.sub(lambda match: _token(match, names), text)


def _token(match: re.Match[str], names: Names) -> str:
    name = match["name"] or (match["inside"] or "") + (match["below"] or "")
    new = names.get(_plain(name)) if name else None
    if new is None:
        return match[0]
    if match["name"]:
        return new
    base, mark = split_name(new)
    return f"{match['dots']}{{{base}}}" + (f"_{{{mark}}}" if mark else "")


def _plain(name: str) -> str:
    base, mark = split_name(name)
    return with_subscript(base, mark)
