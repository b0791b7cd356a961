"""Numeric: where only integration answers, the equations of motion, how it begins, and what integration gives."""

from functools import cached_property
from math import radians

import numpy as np

from sim2reason.dsl.state import State
from sim2reason.questions import KINDS
from sim2reason.questions.period_words import PeriodQuery
from sim2reason.solutions.book import Book, UnsolvedError, Writing
from sim2reason.solutions.equations_of_motion import EquationsOfMotion, Names, phase_at
from sim2reason.solutions.expressions import ZERO, Expression, Symbol
from sim2reason.solutions.lexicon import Both, Lexicon
from sim2reason.solutions.polynomials import NIL, Polynomial, total
from sim2reason.solutions.setting import Setting, capital, joined
from sim2reason.solutions.shared import NEWTONS
from sim2reason.solutions.stage import SECONDS
from sim2reason.solutions.strategies import Strategy, strategy
from sim2reason.solutions.unit_latex import DEGREES, latex

EASY = 300  # characters of a side of an equation that is written out
LONG = 900  # characters of an equation that nobody reads
SOUND = 1e-9  # relative: how well an equation must hold at the moment that is shown
NONE = 1e-12  # of a state: what rounding has left of zero
SLIDES = {"place": r"\ \text{m}", "rate": r"\ \text{m/s}", "acceleration": r"\ \text{m/s}^2"}
HINGES = {"place": r"\ \text{rad}", "rate": r"\ \text{rad/s}", "acceleration": r"\ \text{rad/s}^2"}
WHENCE = ("state", "event", "start", "time_to_event", "sum", "extremum", "count", "period")


@strategy
class Integration(Strategy):
    """Any motion: its equations, integrated; no derivation."""

    name = "integration"
    cost = 100.0
    kinds = frozenset(WHENCE)
    integrates = True

    def refusal(self, setting: Setting) -> str:
        """Why it does not apply."""
        query, m = setting.query, setting.mechanism
        if isinstance(query, PeriodQuery) and query.small:
            return "no motion is integrated for small oscillations"
        if m.feet or any(meeting.sticks for meeting in m.meetings):
            return "the equations change with what stands or sticks"
        return "" if setting.answer is not None else "there is no answer"

    def write(self, setting: Setting, book: Book) -> str:
        """Names, equations, the beginning, the result."""
        return _Integrated(setting, book).write()


class _Integrated:
    """The text about one integration."""

    def __init__(self, setting: Setting, book: Book) -> None:
        self.setting, self.book, self.mechanism = setting, book, setting.mechanism
        moment = setting.query.moment
        side = moment.side(setting.time) if moment is not None else setting.time
        self._pulls: list[Symbol] = []  # forces that the equations have to find
        self.state: State = setting.study.trace.sample(np.array([side]))
        self._told_names = 0  # of those that the equations give to what is long
        self.segment = [s for s in setting.motion.segments if s.start <= side][-1]

    @cached_property
    def names(self) -> Names:
        """Of all coordinates."""
        places, rates, accelerations = list[Symbol](), list[Symbol](), list[Symbol]()
        for c in self.mechanism.coordinates:
            several = len(self.mechanism.body[c.body].coordinates) > 1
            mark = self.setting.mark(c.body)
            hinge = c.kind == "hinge"
            label = c.label if several and not hinge and len(c.label) == 1 else ""
            marks = ",".join(part for part in (mark, label) if part)
            places.append(self.book.fresh(r"\varphi" if hinge else label or "s", mark if label else marks))
            rates.append(self.book.fresh(r"\omega" if hinge else "v", marks))
            accelerations.append(self.book.fresh(r"\alpha" if hinge else "a", marks))
        time = self.book.fresh("t")
        return Names(tuple(places), tuple(rates), tuple(accelerations), time)

    @cached_property
    def equations(self) -> EquationsOfMotion:
        """Those of the moment."""
        phase, lexicon, size = phase_at(self.state), self.setting.lexicon, len(self.mechanism.coordinates)
        draft = EquationsOfMotion(lexicon, self.book.copy(), phase, self.names)
        parts = [part for k in range(size) for part in (draft.inertia(k), draft.load(k))]
        if all(len(part.expression().latex()) <= EASY for part in parts):
            return draft.written_in(self.book)
        found = EquationsOfMotion(lexicon, self.book, phase, self.names)
        found.shorten()
        return found

    def write(self) -> str:
        """All of it."""
        self._introduce()
        self._know()
        self._laws()
        self._beginning()
        self._result()
        return self._answer()

    def _introduce(self) -> None:
        step = self.book.open("names")
        step.say("The motion follows from its equations by numerical integration, not from a formula.")
        said: list[str] = []
        for number, c in enumerate(self.mechanism.coordinates):
            name, who = self.names.places[number].name, self.setting.called(c.body)
            if c.kind == "hinge":
                said.append(f"${name}$ is the angle through which {who} has turned")
                continue
            parent = self.mechanism.body[c.body].parent
            way = self.setting.towards(c.axis, on=parent)
            on = f" relative to {self.setting.called(parent)}" if parent is not None else ""
            said.append(f"${name}$ is how far {who} has moved {way}{on}")
        rates = [f"${symbol.name}$" for symbol in self.names.rates]
        turned = [f"${symbol.name}$" for symbol in self.names.accelerations]
        step.say(
            f"{capital(joined(said))}; {joined(rates)} {'are' if len(rates) > 1 else 'is'} the first"
            f" and {joined(turned)} the second derivative{'s' if len(rates) > 1 else ''}."
        )
        step.close()

    def _know(self) -> None:
        """What the engine has at the moment, for all names."""
        names, state = self.names, self.state
        for number, coordinate in enumerate(self.mechanism.coordinates):
            units = HINGES if coordinate.kind == "hinge" else SLIDES
            for symbol, values, unit in (
                (names.places[number], state.q, "place"),
                (names.rates[number], state.v, "rate"),
                (names.accelerations[number], state.a, "acceleration"),
            ):
                value = float(values[0, number])
                self.book.know(symbol.name, value if abs(value) > NONE else 0.0, self.book.spelled(units[unit]))
        self.book.know(names.time.name, float(state.times[0]), self.book.spelled(SECONDS))

    # ---- laws

    def _laws(self) -> None:
        """Newton's law of each coordinate, what strings and rods demand, and friction."""
        step, equations = self.book.open("newton"), self.equations
        size = len(self.mechanism.coordinates)
        forces = self._forces()
        loads = [
            equations.load(k) - total(equations.pull(n, k) * force for n, force in forces.items()) for k in range(size)
        ]
        for k, extra in self._friction(step, forces).items():
            loads[k] = loads[k] + extra
        laws = [
            (equations.inertia(k).collected([s.name for s in self.names.accelerations]), loads[k].expression())
            for k in range(size)
        ]
        laws += [tuple(side.expression() for side in equations.held(number)) for number in forces]  # type: ignore[misc]
        self._name(step)
        for left, right in laws:
            if left != right:
                self._check(left, right)
                step.say(f"{step.law(left, right)}.")
        step.close()

    def _name(self, step: Writing) -> None:
        """Tell what has been named since."""
        for formula, name in list(self.equations.named.items())[self._told_names :]:
            self.book.know(name.name, self.book.value(formula))
            step.say(f"With {step.law(name, formula)}.")
        self._told_names = len(self.equations.named)

    def _check(self, left: Expression, right: Expression) -> None:
        if len(left.latex()) + len(right.latex()) > LONG:
            raise UnsolvedError("the equations of motion are too long to be written")
        one, other = self.book.value(left), self.book.value(right)
        terms = [abs(self.book.value(t)) for side in (left, right) for t in getattr(side, "terms", (side,))]
        if abs(one - other) > SOUND * max(terms, default=0.0):
            raise UnsolvedError("the equations of motion do not hold as they are written")

    def _forces(self) -> dict[int, Polynomial]:
        """The tensions of the lines that act, by row."""
        found: dict[int, Polynomial] = {}
        acting = self.segment.found.mode.acting
        rows = [n for n in range(len(self.mechanism.constraints)) if acting[n]]
        for number in rows:
            line = self.mechanism.constraints[number]
            name = self.book.fresh("T", str(number + 1) if len(rows) > 1 else "")
            value = float(self.state.constraint_tension[line.name][0])
            self.book.know(name.name, value, self.book.spelled(NEWTONS))
            self._pulls.append(name)
            found[number] = Polynomial.of(name)
        return found

    def _friction(self, step: Writing, forces: dict[int, Polynomial]) -> dict[int, Polynomial]:
        """What rough faces add to the loads, by coordinate; their normal forces are told."""
        found: dict[int, Polynomial] = {}
        lexicon, equations = self.setting.lexicon, self.equations
        rough = [n for n, face in enumerate(self.mechanism.faces) if face.friction > 0.0]
        for face, side in zip(rough, self.segment.found.mode.rubbing, strict=True):
            held = self.mechanism.faces[face]
            mark = self.setting.mark(held.subject)
            if side == 0:
                force = self._named("f", mark, float(self.state.friction[held.subject][0]))
                self._pulls += [force.symbol] if force.symbol is not None else []
                step.say(f"Friction holds {self.setting.called(held.subject)}: {self._still(step, face)}.")
            else:
                normal = self._named("N", mark, float(self.state.normal[held.subject][0]))
                pressing = equations.pressing(face) + total(equations.lifted(n, face) * t for n, t in forces.items())
                self._name(step)
                self._check(normal.expression(), pressing.expression())
                who = self.setting.called(held.subject)
                step.say(f"The face presses on {who} with {step.law(normal.expression(), pressing.expression())}.")
                coefficient = equations.number(_friction(lexicon, face))
                force = (coefficient * normal).scaled(float(-side))
            for place, (name, _) in enumerate(held.slip):
                k = self.mechanism.number[name]
                part = equations.number(_slip(lexicon, face, place))
                found[k] = found.get(k, NIL) + part * force
        return found

    def _still(self, step: Writing, face: int) -> str:
        """No acceleration along a face."""
        slips, names = self.mechanism.faces[face].slip, self.names.accelerations
        moves = [(place, names[self.mechanism.number[name]]) for place, (name, _) in enumerate(slips)]
        slip = total(
            self.equations.number(_slip(self.setting.lexicon, face, place)) * Polynomial.of(name)
            for place, name in moves
        )
        return step.law(slip.expression(), ZERO)

    def _named(self, base: str, mark: str, value: float) -> Polynomial:
        name = self.book.fresh(base, mark)
        self.book.know(name.name, value, self.book.spelled(NEWTONS))
        return Polynomial.of(name)

    # ---- the integration

    def _beginning(self) -> None:
        """How it begins, in words: each name has one value in the text, that of the moment."""
        step, lexicon = self.book.open("beginning"), self.setting.lexicon
        pairs = zip(self.names.rates, lexicon.mechanism.coordinates, lexicon.twin.coordinates, strict=True)
        moving: list[str] = []
        for name, here, there in pairs:
            if here.speed:
                speed = self.equations.number(Both(here.speed, there.speed)).expression()
                moving.append(f"${name.name}$ at {step.stated(speed, self.book.units[name.name])}")
        step.say(f"All begin at zero{f', but {joined(moving)}' if moving else ''}.")
        step.close()

    def _result(self) -> None:
        """What the equations need of the state, and the accelerations that then follow from them."""
        step, names = self.book.open("integration"), self.names
        used = {name for held in self.book.steps for relation in held.relations for name in relation.symbols()}
        needed = [name for name in (*names.places, *names.rates, names.time) if name.name in used]
        until = "the moment in question"
        if needed:
            step.say(f"Integrated numerically to {until}: {joined([self._told(step, name) for name in needed])}.")
        else:
            step.say(f"They are integrated to {until}.")
        step.close()
        step = self.book.open("accelerations")
        found = [name for name in (*names.accelerations, *self._pulls) if name.name in used]
        if found:
            step.say(f"There {joined([step.stated(name, self.book.units[name.name]) for name in found])}.")
        step.close()

    def _told(self, step: Writing, name: Symbol) -> str:
        return step.integrated(name, self.book.values[name.name])

    def _answer(self) -> str:
        """What is asked for, as the integration gives it."""
        setting, book = self.setting, self.book
        assert setting.answer is not None
        step = book.open("answer")
        if setting.unknown:
            name = Symbol(book.sought)
            book.hidden.discard(name.name)
            step.say(f"Repeated for other values of ${name.name}$ until the result is what is given:")
        else:
            measured = KINDS[setting.query.kind].measured(setting.query)
            time = setting.sought is not None
            unit = SECONDS if time else book.spelled(latex(measured.unit))
            name = book.fresh("t" if time else "X")
            book.know(name.name, radians(setting.answer) if unit == DEGREES else setting.answer, unit)
            step.say(f"From this follows the {'time' if time else measured.name}:")
        step.say(f"{step.integrated(name, book.values[name.name])}.")
        step.close()
        return name.name


def _friction(lexicon: Lexicon, face: int) -> Both:
    return Both(lexicon.mechanism.faces[face].friction, lexicon.twin.faces[face].friction)


def _slip(lexicon: Lexicon, face: int, place: int) -> Both:
    return Both(lexicon.mechanism.faces[face].slip[place][1], lexicon.twin.faces[face].slip[place][1])
