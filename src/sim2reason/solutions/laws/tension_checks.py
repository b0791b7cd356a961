"""Verification that strings stay taut in a phase of constant accelerations: their tensions are positive."""

from collections.abc import Mapping, Sequence
from collections.abc import Set as AbstractSet

from sim2reason.solutions.algebra.elimination import solved
from sim2reason.solutions.algebra.expressions import ZERO, Symbol
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial
from sim2reason.solutions.laws.dynamics import Dynamics
from sim2reason.solutions.laws.newton import Row
from sim2reason.solutions.setting import capital, joined
from sim2reason.solutions.solution import Relation, Step
from sim2reason.solutions.writing.steps import Writing
from sim2reason.solutions.writing.unit_latex import NEWTONS

TAUT = "tension check"  # the kind of these steps


def verify_taut(dynamics: Dynamics, rows: Sequence[Row]) -> None:
    """Let a solution that is shown say that the strings stay taut whose tensions it does not work out anyway.

    `rows` are the laws. Nothing rests on it; where all is in symbols, the text of the problem says it.
    """
    book = dynamics.book
    if dynamics.taut and not dynamics.measure.values and not book.in_symbols:
        phase = book.phase
        book.checks.setdefault(dynamics, lambda: _tell(dynamics, rows, phase))


def after_what_they_rest_on(steps: Sequence[Step], late: AbstractSet[str]) -> list[Step]:
    """Put these steps directly after what their numbers follow from, unless some are known only `late`."""
    found = [step for step in steps if step.kind != TAUT or not late.isdisjoint(step.symbols())]
    for step in (step for step in steps if step.kind == TAUT and step not in found):
        found.insert(
            max((n for n, held in enumerate(found) if held.id in step.needs), default=len(found) - 1) + 1, step
        )
    return found


def _tell(dynamics: Dynamics, rows: Sequence[Row], phase: int) -> None:
    book, rows = dynamics.book, _with_weights(dynamics, rows)
    now, book.phase = book.phase, phase
    step, told = book.open(TAUT), list[tuple[int, str]]()
    waiting, symbols = [n for n in dynamics.taut if not _is_told(dynamics, n)], dict(dynamics.names)
    while (ready := _ready(dynamics, rows, waiting, symbols)) is not None:
        place, law = ready
        waiting.remove(place)
        new = _positive(dynamics, step, place, law, symbols)
        if not new:
            break
        told += new
    if len(told) == 1:
        ((place, formula),) = told
        alone = len(dynamics.newton.lines) == 1 and f"T{place}" in dynamics.names
        who, what = ("The string", "") if alone else (capital(_line(dynamics, place)), "its tension ")
        step.say(f"{who} stays taut, as {what}{formula} is positive.")
    elif told:
        named = [
            formula if f"T{place}" in dynamics.names else f"the tension {formula} in {_line(dynamics, place)}"
            for place, formula in told
        ]
        every = "The" if len(told) == len(dynamics.taut) else "These"
        step.say(f"{every} strings stay taut, as {joined(named)} are positive.")
    step.close()
    book.phase = now


def _line(dynamics: Dynamics, place: int) -> str:
    return dynamics.setting.lines[dynamics.newton.lines[place].name]


def _positive(
    dynamics: Dynamics, step: Writing, place: int, law: Polynomial, symbols: dict[str, Polynomial]
) -> list[tuple[int, str]]:
    """Record that a tension is positive, by its law; return it with its equation, or nothing if it is zero."""
    own = next(iter(symbols[f"T{place}"].names())) if f"T{place}" in symbols else f"T{place}"
    formula, book = solved(law, own), dynamics.book
    line = dynamics.newton.lines[place]
    bodies = [dynamics.mechanism.site[site].body or "" for site in (line.through[0], line.through[-1])]
    symbol = Symbol(own) if f"T{place}" in symbols else book.fresh("T", "".join(map(dynamics.setting.mark, bodies)))
    symbols[f"T{place}"] = Polynomial.of(symbol)
    told = step.verified(symbol, formula, NEWTONS)
    if book.observed[symbol.name] <= 0.0:
        step.relations.pop()
        return []
    step.relations.append(Relation(symbol, ZERO, "exceeds"))
    return [(place, told)]


def _ready(
    dynamics: Dynamics, rows: Sequence[Row], waiting: Sequence[int], symbols: Mapping[str, Polynomial]
) -> tuple[int, Polynomial] | None:
    """Return a tension with the shortest law in which all else is known; None if there is none."""
    known = dynamics.book.values.keys() | {
        name for n in dynamics.taut if n not in waiting for name in symbols.get(f"T{n}", NIL).names()
    }
    found: list[tuple[int, Polynomial]] = []
    for place in waiting:
        name = next(iter(symbols[f"T{place}"].names())) if f"T{place}" in symbols else f"T{place}"
        for row in rows:
            if f"T{place}" in row.zero.names():
                law = row.zero.put(symbols).put(dynamics.bound)
                if name in law.names() and law.names() - {name} <= known:
                    found.append((place, law))
    return min(found, key=lambda pair: len(pair[1].terms), default=None)


def _is_told(dynamics: Dynamics, place: int) -> bool:
    named = dynamics.names.get(f"T{place}")
    return named is not None and named.names() <= dynamics.book.values.keys()


def _with_weights(dynamics: Dynamics, rows: Sequence[Row]) -> list[Row]:
    """Return all laws but those of normal forces, with the normal forces that weights alone give put in."""
    pressed: dict[str, Polynomial] = {}
    for row in rows:
        name = f"N{row.number}"
        if row.kind == "normal" and not row.inertia.put(dynamics.names):
            pressed[name] = row.forces.without((name,)).scaled(-1.0)
    return [Row(r.kind, r.number, r.forces.put(pressed), r.inertia) for r in rows if r.kind != "normal"]
