"""Faults planted in the data of a worked solution, each of which the verification must detect.

How they are counted. A law is dropped with every other law that states the same, letter by letter; of a phase each
equation is one. A phase is left out: of an integration everything at its end is as it was at its beginning; of several
phases all steps of one are missing. A jump is wrong: what a law says an event does is 0.9 times as large. A given is
left out if a relation or a phase uses it. A given is invented: the answer, or a result on the way to it that differs
from all that is given, is told as given, and what leads to it is left out. A sign is turned: that of one term of a sum,
or of a product behind a minus. A number other than zero and exponents is 7 % larger. What nothing depends on is left as
it is: a sign or number with which its relation holds as well (a term is zero), or a formula in a phase is the same (a
square), a relation for a name that is used nowhere else, and a comparison, which many wrong numbers leave true: that is
planted with its sides exchanged.
"""

import json
import random
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping
from math import isclose
from typing import Any

from sim2reason.solutions.checking import COMPARISON_ROLE
from sim2reason.solutions.checking.equation import Equation
from sim2reason.solutions.checking.integration import PARTS, formulas
from sim2reason.solutions.checking.trees import Tree, symbols, value
from sim2reason.solutions.solution import RELATION_RTOL

Data = dict[str, Any]
Place = tuple[Any, Any]
"""A list or mapping, and the index or key in it."""
JUMPS = frozenset(("rebound", "impulse", "after", "impact", "jerk", "event"))  # kinds of steps about sudden changes
INVENTED = "a given invented"  # undetectable by recomputation, which only derives consequences of given values
WRONG, LARGER = 0.9, 1.07  # factors


def planted_faults(
    data: Mapping[str, Any], values: Mapping[str, float], rng: random.Random, most: int
) -> Iterator[tuple[str, Data]]:
    """Yield copies of the data with one random fault each, at most `most` of a kind."""
    for kind, spoil in KINDS.items():
        count = spoil(_copy(data), None, values)
        for number in rng.sample(range(count), min(most, count)):
            faulty = _copy(data)
            spoil(faulty, number, values)
            yield kind, faulty


def _copy(data: Mapping[str, Any]) -> Data:
    return json.loads(json.dumps(data))


def _idle(data: Data) -> list[Data]:
    """Return the equations that the answer does not need: comparisons, and those for names not used elsewhere."""
    every = [relation for step in data["steps"] for relation in step["relations"]]
    relations = [relation for relation in every if relation["role"] != COMPARISON_ROLE]
    names = {id(r): frozenset((*symbols(r["left"]), *symbols(r["right"]))) for r in relations}
    fixed = {name for phase in _phases(data) for tree in formulas(phase) for name in symbols(tree)}
    fixed |= {str(data["goal"]), *data["givens"], *(name for phase in _phases(data) for _, name in phase["ends"])}
    idle = [relation for relation in every if relation["role"] == COMPARISON_ROLE]
    while more := _last_named(relations, names, fixed, str(data["goal"])):
        idle += more
        relations = [relation for relation in relations if not any(relation is other for other in more)]
    return idle


def _last_named(relations: list[Data], names: Mapping[int, frozenset[str]], fixed: set[str], goal: str) -> list[Data]:
    """Return the equations for one name that determines no other name; the `fixed` names are needed elsewhere."""
    known, new = fixed - {goal}, dict[int, frozenset[str]]()
    for relation in relations:
        new[id(relation)] = names[id(relation)] - known
        known |= new[id(relation)]
    where = defaultdict[str, list[Data]](list)
    for relation in relations:
        for name in names[id(relation)] - fixed:
            where[name].append(relation)
    last = (equations for name, equations in where.items() if all(new[id(r)] <= {name} for r in equations))
    return next(last, list[Data]())


def _laws(data: Data) -> list[tuple[list[Data], int]]:
    """Return the place of each law that the answer needs: its list of equations, and its index there."""
    lists = [step["relations"] for step in data["steps"]]
    idle = {id(relation) for relation in _idle(data)}
    laws = [
        (equations, n)
        for equations in lists
        for n, r in enumerate(equations)
        if r["role"] == "law" and id(r) not in idle
    ]
    for phase in _phases(data):
        laws += [(phase["equations"], n) for n in range(len(phase["equations"]))]
    return laws


def _phases(data: Data) -> list[Data]:
    return [step["integration"] for step in data["steps"] if step["integration"] is not None]


def _drop_law(data: Data, number: int | None, values: Mapping[str, float]) -> int:
    del values
    laws = _laws(data)
    if number is not None:
        equations, index = laws[number]
        same = equations[index]["left"], equations[index]["right"]
        for every in [step["relations"] for step in data["steps"]] + [phase["equations"] for phase in _phases(data)]:
            every[:] = [r for r in every if (r["left"], r["right"]) != same or r.get("role", "law") != "law"]
    return len(laws)


def _leave_out_phase(data: Data, number: int | None, values: Mapping[str, float]) -> int:
    del values
    integrated = [step for step in data["steps"] if step["integration"] is not None]
    idle = {id(relation) for relation in _idle(data)}
    needed = (
        step for step in data["steps"] if any(id(r) not in idle for r in step["relations"]) or step["integration"]
    )
    phases = sorted({step["phase"] for step in needed})
    removable = phases if len(phases) > 1 else []
    if number is not None and number < len(integrated):
        _skip(integrated[number])
    elif number is not None:
        left_out = removable[number - len(integrated)]
        data["steps"] = [step for step in data["steps"] if step["phase"] != left_out]
    return len(integrated) + len(removable)


def _skip(step: Data) -> None:
    """Replace the integration of a phase by equations that set its final values to the initial ones."""
    phase = step.pop("integration")
    step["integration"] = None
    start: dict[str, Tree] = {phase["time"]: phase["begin"]}
    for entry in phase["coordinates"]:
        start |= {entry["place"]: entry["initial_place"], entry["rate"]: entry["initial_rate"]}
    start |= {entry["name"]: entry["initial"] for entry in phase["accumulated"]}
    ends = [(name, start[symbol]) for symbol, name in phase["ends"] if symbol in start]
    step["relations"] += [{"role": "law", "left": name, "right": tree, "unit": ""} for name, tree in ends]


def _change_jump(data: Data, number: int | None, values: Mapping[str, float]) -> int:
    steps, idle = [step for step in data["steps"] if step["kind"] in JUMPS], {id(relation) for relation in _idle(data)}
    jumps = [r for step in steps for r in step["relations"] if r["role"] == "law" and id(r) not in idle]
    jumps = [r for r in jumps if not _holds(r | {"right": ["*", WRONG, r["right"]]}, values)]
    if number is not None:
        jumps[number]["right"] = ["*", WRONG, jumps[number]["right"]]
    return len(jumps)


def _exchange_sides(data: Data, number: int | None, values: Mapping[str, float]) -> int:
    del values
    compared = [r for step in data["steps"] for r in step["relations"] if r["role"] == COMPARISON_ROLE]
    if number is not None:
        relation = compared[number]
        relation["left"], relation["right"] = relation["right"], relation["left"]
    return len(compared)


def _leave_out_given(data: Data, number: int | None, values: Mapping[str, float]) -> int:
    del values
    used = {name for parent, key in _trees(data) for name in symbols(parent[key])}
    names = [name for name in data["givens"] if name in used]
    if number is not None:
        del data["givens"][names[number]]
    return len(names)


def _invent_given(data: Data, number: int | None, values: Mapping[str, float]) -> int:
    known, steps = [*data["givens"].values()], data["steps"]
    given = [str(name) for step in steps for name in step["gives"] if name in values] + [str(data["goal"])]
    names = [name for name in dict.fromkeys(given) if name in values and not _is_among(values[name], known)]
    if number is not None:
        data["givens"][names[number]] = values[names[number]]
        for step in steps:
            step["relations"] = [relation for relation in step["relations"] if relation["left"] != names[number]]
    return len(names)


def _is_among(value: float, numbers: Iterable[float]) -> bool:
    return any(isclose(value, number, rel_tol=RELATION_RTOL) for number in numbers)


def _turn_sign(data: Data, number: int | None, values: Mapping[str, float]) -> int:
    return _change(data, number, values, _signs, lambda term: ["*", -1.0, term])


def _change_number(data: Data, number: int | None, values: Mapping[str, float]) -> int:
    if number is not None and number < len(data["givens"]):
        data["givens"][list(data["givens"])[number]] *= LARGER
        return 0
    count = len(data["givens"])
    rest = None if number is None else number - count
    return count + _change(data, rest, values, _numbers, lambda number: LARGER * number)


def _change(
    data: Data,
    number: int | None,
    values: Mapping[str, float],
    places: Callable[[Place], Iterator[Place]],
    changed: Callable[[Any], Any],
) -> int:
    """Change one number or sign of the equations that the answer needs; return the number of candidates."""
    candidates: list[Place] = []
    idle = {id(relation) for relation in _idle(data)}
    for relation, root in _roots(data):
        if id(relation) in idle:
            continue
        holder, side = root
        generic = {name: 0.7 + 0.31 * n for n, name in enumerate(dict.fromkeys(symbols(holder[side])))}
        was = _value(holder[side], generic)
        for parent, key in places(root):
            before = parent[key]
            parent[key] = changed(before)
            zero = _value(before, values) == _value(parent[key], values) == 0.0
            same = zero or (_value(holder[side], generic) == was if relation is None else _holds(relation, values))
            parent[key] = before
            if not same:
                candidates.append((parent, key))
    if number is not None:
        parent, key = candidates[number]
        parent[key] = changed(parent[key])
    return len(candidates)


def _holds(relation: Data, values: Mapping[str, float]) -> bool:
    """Return whether a relation holds for the correct values; False if it cannot be evaluated alone."""
    try:
        return Equation.from_trees(relation["left"], relation["right"]).holds(values)
    except (KeyError, ValueError, ArithmeticError):
        return False


def _value(tree: Tree, values: Mapping[str, float]) -> float | None:
    """Return the value of a formula; None if it has none."""
    try:
        return value(tree, values)
    except (KeyError, ValueError, ArithmeticError):
        return None


def _roots(data: Data) -> Iterator[tuple[Data | None, Place]]:
    """Yield each formula of a solution as a place in its data, with the equation that it belongs to."""
    for step in data["steps"]:
        for relation in step["relations"]:
            for side in ("left", "right"):
                yield relation, (relation, side)
        if step["integration"] is not None:
            yield from ((None, slot) for slot in _phase_trees(step["integration"]))


def _phase_trees(phase: Data) -> Iterator[Place]:
    yield phase, "begin"
    yield phase["until"], "expression"
    for part, names in PARTS.items():
        for entry in phase[part]:
            yield from ((entry, name) for name in names)


def _trees(data: Data) -> Iterator[Place]:
    return (slot for _, slot in _roots(data))


def _signs(slot: Place) -> Iterator[Place]:
    """Yield the terms of sums, and products after a minus sign."""
    parent, key = slot
    tree: Tree = parent[key]
    if not isinstance(tree, list):
        return
    if tree[0] == "+":
        yield from ((tree, n) for n in range(1, len(tree)))
    elif tree[0] == "*" and isinstance(tree[1], float) and tree[1] < 0.0:
        yield slot
    for n in range(1, len(tree)):
        yield from _signs((tree, n))


def _numbers(slot: Place) -> Iterator[Place]:
    """Yield all numbers except zeros and exponents."""
    parent, key = slot
    tree: Tree = parent[key]
    if isinstance(tree, float | int):
        if tree:
            yield slot
    elif isinstance(tree, list):
        if tree[0] == "^":
            yield from _numbers((tree, 1))
            return
        for n in range(1, len(tree)):
            yield from _numbers((tree, n))


KINDS: Mapping[str, Callable[[Data, int | None, Mapping[str, float]], int]] = {
    "a law dropped": _drop_law,
    "a phase left out": _leave_out_phase,
    "a wrong jump": _change_jump,
    "a given left out": _leave_out_given,
    INVENTED: _invent_given,
    "a sign turned": _turn_sign,
    "a number changed": _change_number,
    "a comparison turned round": _exchange_sides,
}  # each plants the fault of a number, or with None only counts how many there are
