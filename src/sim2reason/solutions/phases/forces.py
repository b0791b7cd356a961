"""Forces in a phase: their symbols, initial rates and jumps of velocity, and explicit formulas of forces."""

from collections.abc import Collection, Mapping, Sequence

import numpy as np

from sim2reason.simulation.engines.exact.motion import Segment
from sim2reason.simulation.trace import Event
from sim2reason.solutions.algebra.evaluated import NumericRoot
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol, sum_terms
from sim2reason.solutions.algebra.polynomials import Polynomial, total
from sim2reason.solutions.algebra.root_finding import solved_for, substitute
from sim2reason.solutions.closed_forms import ClosedFormError, simplified_form
from sim2reason.solutions.phases.equations import LETTERS, PhaseEquations
from sim2reason.solutions.setting import ProblemContext, join_words
from sim2reason.solutions.solution import Relation
from sim2reason.solutions.writing.lexicon import DualValue, Lexicon, UnreadError
from sim2reason.solutions.writing.notation import IMPULSE, split_name
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError

MAX_SOLVED_LAWS = 4  # largest number of laws that are solved by formulas
MAX_FORMULA_LENGTH = 80  # maximum length of the LaTeX of a formula that is written beside its number


def explicit_formulas(
    laws: Sequence[Relation], names: Collection[str], values: Mapping[str, float]
) -> dict[str, Expression]:
    """Return the short formulas, by name, of the unknowns that laws determine; empty for many laws.

    `values` holds the values of all names.
    """
    chain: list[tuple[str, Expression]] = []
    waiting = [sum_terms(law.left, -law.right) for law in laws] if len(laws) <= MAX_SOLVED_LAWS else []
    while waiting:
        unknown = [[name for name in names if name in expression.symbols()] for expression in waiting]
        index = min(range(len(waiting)), key=lambda n: len(unknown[n]) or len(names) + 1)
        if not unknown[index]:
            break
        law, name = waiting.pop(index), unknown[index][-1]
        formula = solved_for(name, law, ZERO, values)
        if isinstance(formula, NumericRoot):
            return {}
        waiting = [substitute(expression, name, formula) for expression in waiting]
        chain.append((name, formula))
    formulas: dict[str, Expression] = {}
    for name, formula in reversed(chain):
        for other, known in formulas.items():
            formula = substitute(formula, other, known)  # noqa: PLW2901
        formulas[name] = formula
    short = {
        name: _short(expression) for name, expression in formulas.items() if {*names}.isdisjoint(expression.symbols())
    }
    return {
        name: expression
        for name, expression in short.items()
        if expression is not None and len(expression.latex()) <= MAX_FORMULA_LENGTH
    }


def _short(formula: Expression) -> Expression | None:
    try:
        return simplified_form(formula).expression
    except ClosedFormError:
        return None


class ForceSymbols:
    """The symbols of the forces used so far, with their descriptions."""

    def __init__(self, setting: ProblemContext, book: SolutionBuilder) -> None:
        """Take the problem and the solution builder; no force has a symbol yet."""
        self._setting, self._book = setting, book
        self._symbols: dict[str, Symbol] = {}
        self._untold: list[str] = []

    def force_symbols(self, segment: Segment) -> dict[str, Symbol]:
        """Return the symbols of the forces in a segment, by ``row``, ``normal`` or ``friction`` and their number."""
        symbols: dict[str, Symbol] = {}
        kinds, acting = segment.kinds, segment.found.mode.acting
        several = sum(kind.kind not in LETTERS for kind in kinds) > 1
        for n, kind in enumerate(kinds):
            if acting[n]:
                mark = str(n + 1) if kind.kind not in LETTERS and several else ""
                symbols[f"row{n}"] = self._symbol(kind.kind, kind.name, LETTERS.get(kind.kind, "T"), mark)
        faces = self._setting.mechanism.faces
        rough = [n for n, face in enumerate(faces) if face.friction > 0.0]
        for face, side in zip(rough, segment.found.mode.rubbing, strict=True):
            letter, of = ("N", "normal") if side else ("f", "friction")
            subject = faces[face].subject
            symbols[f"{of}{face}"] = self._symbol(of, subject, letter, self._setting.subscript_of(subject))
        return symbols

    def introductions(self) -> list[str]:
        """Return descriptions of the symbols that no sentence has introduced yet."""
        descriptions, self._untold = self._untold, []
        return descriptions

    def _symbol(self, kind: str, name: str, letter: str, mark: str) -> Symbol:
        key = f"{kind} {name}"
        if key not in self._symbols:
            symbol = self._symbols[key] = self._book.fresh(letter, mark)
            self._untold.append(f"${symbol.name}$ {self._described(kind, name)}")
        return self._symbols[key]

    def _described(self, kind: str, name: str) -> str:
        setting = self._setting
        if kind in ("normal", "friction"):
            force = "the normal force on" if kind == "normal" else "the static friction on"
            return f"{force} {setting.display_name(name)}"
        if kind == "foot":
            return "the force with which the plane presses on the edge"
        if kind == "hold":
            return "the static friction at the edge"
        if kind == "stuck":
            return f"the force between {' and '.join(setting.display_name(part) for part in name.split(' and '))}"
        return (
            f"the force in {setting.string_phrases.get(name, 'the rod')}"
            if kind != "string"
            else f"the tension in {setting.string_phrases[name]}"
        )


def initial_rates(lexicon: Lexicon, senses: Sequence[float]) -> list[Expression]:
    """Return the initial rate of each coordinate in the numbers of the text, times its sense, 1 or -1.

    Raises:
        UnsolvedError: a rate is not a simple function of the numbers in the text.
    """
    pairs = zip(lexicon.mechanism.coordinates, lexicon.twin.coordinates, senses, strict=True)
    return [_speed(lexicon, DualValue(sense * a.speed, sense * b.speed)) for a, b, sense in pairs]


def _speed(lexicon: Lexicon, speed: DualValue) -> Expression:
    """Return an initial rate in the numbers of the text; an angular one may be a speed divided by a length."""
    for length in (None, *lexicon.lengths):
        try:
            if length is None:
                return lexicon.read(speed).expression()
            return lexicon.read(speed * length).expression() / lexicon.read(length).expression()
        except UnreadError:
            continue
    raise UnsolvedError(f"the initial rate {speed.value:.6g} is no simple function of the numbers in the text")


IMPACT_VELOCITY_RTOL = 1e-8  # relative tolerance of the velocities after an impact to those of the engine
VELOCITY_CHANGE_RTOL = 1e-9  # relative: a velocity that changes by less at an event is continuous


class ImpulseEquations:
    """The relations between the velocities just before and just after an event."""

    def __init__(self, before: PhaseEquations, after: Sequence[Symbol], events: Sequence[Event]) -> None:
        """Take the equations just `before` the event, the symbols of the rates just `after` it, and its events."""
        self._before, self._after, self._events = before, after, events

    def relations(self, rows: Sequence[int], impulses: Sequence[Symbol]) -> list[Relation]:
        """Return the impulse equations of all coordinates, then the condition for each impulse.

        `rows` are the strings that are taut during the event; `impulses` has a symbol for each collision, then for
        each of these rows.
        """
        motion, names = self._before.motion, self._before.names
        size, pairs = range(len(self._after)), self.pairs
        changes = [
            (Polynomial.from_expression(self._after[k]) - Polynomial.from_expression(names.rates[k])).scale(
                names.senses[k]
            )
            for k in size
        ]
        along = [[self._gap(number, k) for k in size] for number in pairs]
        along += [[motion.constraint_derivative(row, k).scale(-1.0) for k in size] for row in rows]
        equations: list[tuple[Expression, Expression]] = []
        for k in size:
            sense = names.senses[k]
            left = total(motion.mass(k, j) * changes[j] for j in size).scale(sense)
            right = total(
                ways[k] * Polynomial.from_expression(impulse) for ways, impulse in zip(along, impulses, strict=True)
            ).scale(sense)
            if left or right:
                equations.append((left.expression(), right.expression()))
        rates = [Polynomial.from_expression(symbol).scale(names.senses[k]) for k, symbol in enumerate(self._after)]
        for ways, number in zip(along, pairs, strict=False):
            after = total(coefficient * rate for coefficient, rate in zip(ways, rates, strict=True))
            before = total(coefficient * names.rate(k) for k, coefficient in enumerate(ways))
            equations.append((after.expression(), (self._restitution(number) * before).scale(-1.0).expression()))
        taut = along[len(pairs) :]
        equations += [
            (total(w * rate for w, rate in zip(ways, rates, strict=True)).expression(), ZERO) for ways in taut
        ]
        return [Relation(left, right, "law") for left, right in equations]

    @property
    def pairs(self) -> list[int]:
        """Return the indices, among the pairs of bodies that may meet, of the pairs that collide."""
        hit = [set(event.subjects) for event in self._events if event.kind == "collision"]
        return [n for n, meeting in enumerate(self._before.mechanism.meetings) if set(meeting.names) in hit]

    def _gap(self, number: int, k: int) -> Polynomial:
        return self._before.motion.read_recorded(lambda a: a.separation(a.mechanism.meetings[number]).along.get(k, 0.0))

    def _restitution(self, number: int) -> Polynomial:
        lexicon = self._before.lexicon
        pair = DualValue(lexicon.mechanism.meetings[number].restitution, lexicon.twin.meetings[number].restitution)
        return self._before.motion.number(pair)


def write_jump(
    before: PhaseEquations, following: Segment, events: Sequence[Event], number: int
) -> tuple[Symbol, ...] | None:
    """Write the velocity changes at an event and return the symbols of the new rates; None if continuous.

    Raises:
        UnsolvedError: the laws do not lead to the engine's velocities after the event.
    """
    book, names, segment = before.book, before.names, before.segment
    old = [book.values[rate.name] for rate in names.rates]
    new = [sense * v for sense, v in zip(names.senses, following.v, strict=True)]
    largest = max(map(abs, (*old, *new)), default=0.0)
    if all(abs(a - b) <= VELOCITY_CHANGE_RTOL * largest for a, b in zip(old, new, strict=True)):
        return None
    after = tuple(_fresh(book, rate, value) for rate, value in zip(names.rates, new, strict=True))
    jump = ImpulseEquations(before, after, events)
    rows = [row for row in range(len(segment.kinds)) if _taut(segment, following, row)]
    impulses = [book.fresh("P", str(number + 1)) for _ in (*jump.pairs, *rows)]
    relations = jump.relations(rows, impulses)
    impulse_values = _impulses(relations, [impulse.name for impulse in impulses], dict(book.values))
    for name, value in impulse_values.items():
        book.set_value(name, value, book.unit_in_text(IMPULSE))
    step = book.begin_step("event")
    step.add_text(_describe_jump(jump, impulses))
    laws = [step.law(relation.left, relation.right) for relation in relations]
    step.add_text(f"{join_words(laws)}.")
    for symbol in after:
        step.label(symbol.name)
    step.add_text(f"Just after it, {join_words([step.stated(symbol, book.units[symbol.name]) for symbol in after])}.")
    step.close()
    return after


def _describe_jump(jump: ImpulseEquations, impulses: Sequence[Symbol]) -> str:
    names = join_words([f"${impulse.name}$" for impulse in impulses])
    whose = f"impulse{'s' if len(impulses) > 1 else ''} {names}"
    if jump.pairs:
        return f"In the collision, with the {whose}, momentum and the coefficient of restitution require"
    return f"The string becomes taut with a jerk, whose {whose} takes away the velocity along it:"


def _fresh(book: SolutionBuilder, rate: Symbol, value: float) -> Symbol:
    base, mark = split_name(rate.name)
    name = book.name_after_impact(base, mark)
    book.set_value(name.name, value, book.units[rate.name])
    return name


def _taut(segment: Segment, following: Segment, row: int) -> bool:
    """Return whether a constraint is active during an event, because it is active just before or just after it."""
    after = (
        row < len(following.kinds) and following.kinds[row] == segment.kinds[row] and following.found.mode.acting[row]
    )
    return segment.found.mode.acting[row] or after


def _impulses(relations: Sequence[Relation], unknowns: Sequence[str], values: dict[str, float]) -> dict[str, float]:
    """Return the impulses, N s by symbol, from the relations of an event and the engine's velocities after it."""

    def excess(at: dict[str, float]) -> list[float]:
        return [float((r.left.value(at) - r.right.value(at)).real) for r in relations]

    zero = values | dict.fromkeys(unknowns, 0.0)
    base = np.array(excess(zero))
    matrix = np.array([np.array(excess(zero | {name: 1.0})) - base for name in unknowns]).T
    solution, _, rank, _ = np.linalg.lstsq(matrix, -base, rcond=1e-12)
    if rank < len(unknowns) or np.abs(matrix @ solution + base).max() > IMPACT_VELOCITY_RTOL * max(
        1.0, np.abs(base).max()
    ):
        raise UnsolvedError("the laws of the impact do not lead to the velocities after it")
    return dict(zip(unknowns, map(float, solution), strict=True))
