"""Central spring: a body that moves around the fixed end of its spring, by energy and angular momentum.

See any textbook, such as Kleppner and Kolenkow, An Introduction to Mechanics, chapter 10, on central forces.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from math import hypot
from typing import ClassVar

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.strings import MostCompressed, MostStretched, NaturalLength
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import Power, Root, sum_of_squares
from sim2reason.solutions.algebra.root_finding import root_sentence
from sim2reason.solutions.oscillations.net_force import time_of_greatest
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.strategies import Strategy, strategy
from sim2reason.solutions.strategies.spring_line import SingleSpringBody, ends, quantity_of, single_spring_law
from sim2reason.solutions.swings.angle import FormulaMethod
from sim2reason.solutions.writing.notation import JOULES, METRES, SPEED, latex
from sim2reason.solutions.writing.steps import (
    SolutionBuilder,
    StepBuilder,
    UnsolvedError,
    record_inequality,
    verify_assumed,
)


@dataclass(frozen=True, slots=True)
class Launch:
    """A body launched across its spring: its velocity, and a function that writes energy and angular momentum.

    `angular_momentum_writer` returns the energy, in J, and the angular momentum per unit of mass, in m²/s.
    """

    body: SingleSpringBody
    velocity: Sequence[Expression]
    angular_momentum_writer: Callable[[], tuple[Symbol, Expression]]


HALF = Number(0.5)
MOMENTS = (MostCompressed, MostStretched, NaturalLength)
LENGTH_RTOL = 1e-3  # relative tolerance of a length found by a search
RADIAL_MOTION_RTOL = 1e-6  # relative to the speed: below it the motion is along the spring


@strategy
class CentralSpring(Strategy):
    """The strategy for a body launched across a single spring, at an extreme or the natural length of the spring."""

    name = "energy and angular momentum on a spring"
    cost = 1.1
    kinds = frozenset({"event", "extremum"})

    def why_unsuitable(self, mechanism: Mechanism) -> str:
        """Return the reason, in words, that the strategy cannot apply to a mechanism; empty if it may apply."""
        moves = any(coordinate.speed for coordinate in mechanism.coordinates)
        return "" if moves and single_spring_law(mechanism) else "no lone body is launched on a single spring"

    def formulas(self, mechanism: Mechanism) -> frozenset[str]:
        """Return the question kinds that have a compact formula: only ``event``, a quantity at a named event."""
        del mechanism
        return frozenset({"event"})

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        query, quantity = setting.query, quantity_of(setting)
        if not isinstance(query, StretchQuery) and not isinstance(query.moment, MOMENTS):
            return "only integration gives the place"
        return "" if quantity in _CentralMotion.METHOD_BY_QUANTITY else f"no way to the quantity {quantity}"

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the conserved quantities, the length of the spring and the answer, and return the answer's symbol."""
        model = _CentralMotion(setting, book)
        return model.answer(model.METHOD_BY_QUANTITY[quantity_of(setting)], model.signed_or_magnitude).name


class _CentralMotion(SingleSpringBody):
    """The quantities of a body that is launched across a spring."""

    def __init__(self, setting: ProblemContext, book: SolutionBuilder) -> None:
        """Read the parameters; raise UnsolvedError if the body moves straight along the spring."""
        super().__init__(setting, book)
        self.launch = [self.read(lambda m, n=n: m.coordinates[n].speed) for n in (0, 1)]
        (x, y), (u, v) = ends(setting.mechanism), (c.speed for c in setting.mechanism.coordinates)
        if abs(x * v - y * u) <= RADIAL_MOTION_RTOL * hypot(x, y) * hypot(u, v):
            raise UnsolvedError("it moves straight along the spring")

    # ---- what is kept

    @cached_property
    def energy(self) -> Symbol:
        """Write the conserved energy of body and spring, J, and return its symbol."""
        launched = HALF * self.mass * sum_of_squares(self.launch)
        stored = HALF * self.stiffness * Power(self.length - self.natural, 2)
        step, name = self.book.begin_step("energy"), self.book.fresh("E")
        text = "Energy is conserved; its value is"
        if quantity_of(self.setting) == "kinetic energy" and self.relaxed:
            step.add_text(passed_words(self._launched, step))
            text = "There all energy is kinetic; as it is conserved, its value is"
        step.add_text(f"{text} {step.result(name, launched + stored, JOULES, law=True)}.")
        step.close()
        return name

    @property
    def _launched(self) -> Launch:
        return Launch(self, self.launch, lambda: (self.energy, self.specific_angular_momentum))

    @cached_property
    def specific_angular_momentum(self) -> Expression:
        """Write the angular momentum per unit mass about the fixed end, m²/s, and return its magnitude."""
        (x, y), (u, v) = self.apart, self.launch
        formula = x * v - y * u
        formula = self.book.magnitude(formula)
        text = (
            "The spring force points to the fixed end, so the angular momentum about that point is conserved; per unit"
        )
        return self.book.add_step("swirl", f"{text} mass it is", self.book.fresh("h"), formula, latex("m^2/s"))

    # ---- the moment

    @cached_property
    def _engine_length(self) -> tuple[float, float]:
        """Return the spring length at the moment, m, and its rate of change over the body's speed, by the engine."""
        extreme = isinstance(self.setting.query, StretchQuery)
        time = time_of_greatest(self.setting) if extreme else self.setting.time
        state = self.setting.study.trace.sample(np.array([time]))
        position = np.array(ends(self.setting.mechanism)) + state.q[0]
        far = float(np.hypot(*position))
        return far, float(position @ state.v[0]) / (far * float(np.hypot(*state.v[0])))

    @cached_property
    def relaxed(self) -> bool:
        """Return whether the spring has its natural length, instead of an extreme length, at the question's moment."""
        if not isinstance(self.setting.query, StretchQuery):
            return isinstance(self.setting.query.moment, NaturalLength)
        (far, rate), natural = self._engine_length, self.book.value(self.natural)
        if abs(far - natural) <= LENGTH_RTOL * natural:
            return True
        if abs(rate) > LENGTH_RTOL:
            raise UnsolvedError("the greatest value is taken somewhere on the way")
        return False

    @cached_property
    def final_length(self) -> Expression:
        """Return the length of the spring at the moment."""
        return self.natural if self.relaxed else self._extreme

    @cached_property
    def _extreme(self) -> Symbol:
        name, step = self.book.fresh(r"\ell"), self.book.begin_step("extreme")
        across = HALF * self.mass * Power(self.specific_angular_momentum / name, 2)
        stored = HALF * self.stiffness * Power(name - self.natural, 2)
        residual = across + stored - self.energy
        step.add_text(
            "At an extreme length, the velocity is perpendicular to the spring and equal to "
            f"${self.specific_angular_momentum.latex()}$"
        )
        step.add_text(f"divided by the length. By conservation of energy, {step.law(across + stored, self.energy)}.")
        step.add_text(
            root_sentence(self.book, step, name, residual, self._engine_length[0], METRES, "The numerical solution is")
        )
        step.close()
        return name

    @cached_property
    def speed(self) -> Symbol:
        """Write the speed at the moment, m/s, and return its symbol."""
        name = self.book.fresh("v")
        if not self.relaxed:
            return self.book.add_step(
                "speed", "The speed there is", name, self.specific_angular_momentum / self.final_length, SPEED
            )
        step = self.book.begin_step("speed")
        step.add_text(passed_words(self._launched, step))
        law = step.law(HALF * self.mass * Power(name, 2), self.energy)
        formula = Root(2.0 * self.energy / self.mass)
        step.add_text(f"At the natural length all energy is kinetic: {law}, so {step.result(name, formula, SPEED)}.")
        step.close()
        return name

    # ---- what is asked

    def signed_or_magnitude(self, formula: Expression) -> Expression:
        """Return a formula for a signed quantity; its magnitude if the question asks for no sign."""
        target = self.setting.query.target
        sense = target.sense if target is not None else None
        if sense is not None and any(sense.vector):
            raise UnsolvedError("a component along a direction of the table")
        return -formula if sense is None and self.book.value(formula) < 0.0 else formula

    def _speed(self) -> Expression:
        return self.speed

    def _momentum(self) -> Expression:
        return self.mass * self.speed

    def _kinetic(self) -> Expression:
        return self.energy if self.relaxed else HALF * self.mass * Power(self.speed, 2)

    def _extension(self) -> Expression:
        return self.final_length - self.natural if not self.relaxed else ZERO

    def _current_length(self) -> Expression:
        return self.final_length

    def _pull(self) -> Expression:
        return self.stiffness * self._extension()

    def _stored(self) -> Expression:
        return HALF * self.stiffness * Power(self._extension(), 2)

    def _acceleration(self) -> Expression:
        return self._pull() / self.mass

    def _rate(self) -> Expression:
        if not self.relaxed:
            raise UnsolvedError("it does not grow then")
        along = Root(Power(self.speed, 2) - Power(self.specific_angular_momentum / self.natural, 2))
        return along if self._engine_length[1] > 0.0 else -along

    METHOD_BY_QUANTITY: ClassVar[Mapping[str, FormulaMethod]] = {
        "velocity": ("_speed", ""),
        "momentum": ("_momentum", "The momentum is"),
        "kinetic energy": ("_kinetic", "The kinetic energy is"),
        "extension": ("_extension", "The change in its length is"),
        "spring length": ("_current_length", ""),
        "spring force": ("_pull", "The spring force is"),
        "spring energy": ("_stored", "The elastic energy is"),
        "extension rate": ("_rate", "The component of the velocity along the spring is"),
        "net force": ("_pull", "The force of the spring is"),
        "acceleration": ("_acceleration", "By Newton's second law, the acceleration is"),
    }


def passed_words(launch: Launch, step: StepBuilder) -> str:
    """Return sentences that the speed is greatest at the natural length of the spring, and why the spring reaches it.

    Raises:
        UnsolvedError: no argument shows that it is passed.
    """
    query = launch.body.setting.query
    if not isinstance(query, StretchQuery):
        return ""
    what = query.functional.partition(" ")[2]
    passed = "" if isinstance(query.moment, NaturalLength) else f" {_why_passed(launch, step, query)}"
    return f"The {what} is greatest where the spring stores no energy, at its natural length.{passed}"


def _why_passed(launch: Launch, step: StepBuilder, query: StretchQuery) -> str:
    """Return why the spring passes its natural length before its greatest extension or compression."""
    body, (u, v) = launch.body, launch.velocity
    book, (x, y) = body.book, body.apart
    outward, known = x * u + y * v, not (book.is_hidden(body.length) or book.is_hidden(body.natural))
    lengthens, stretched = book.value(outward) > 0.0, book.value(body.length) > book.value(body.natural)
    sides = (body.length, body.natural) if stretched else (body.natural, body.length)
    relation = f"{body.length.latex()} {'>' if stretched else '<'} {body.natural.latex()}"
    match query.moment:
        case MostCompressed() if lengthens and not (stretched and known):
            why = "and goes on to do so as long as it is compressed; in the end it is compressed"
            return _passes(book, step, (outward, ZERO), f"{outward.latex()} > 0", "lengthens at first", why)
        case MostCompressed() if stretched:
            sentence = _passes(book, step, sides, relation, "is stretched at first", "and compressed in the end")
        case MostStretched() if not stretched:
            sentence = _passes(book, step, sides, relation, "is compressed at first", "and stretched in the end")
        case MostStretched() if not lengthens:
            book.afterwards.append(lambda: _verify_reached(launch))
            why = "and does not turn back before"
            return _passes(book, step, (ZERO, outward), f"{outward.latex()} < 0", "shortens at first", why)
        case _:
            raise UnsolvedError("nothing shows that it passes its natural length")
    if known or lengthens == stretched or book.is_hidden(outward):
        return sentence
    record_inequality(book, step, *((outward, ZERO) if lengthens else (ZERO, outward)))
    state, verb = ("compressed", "shortens") if stretched else ("stretched", "lengthens")
    less = f"${outward.latex()} {'>' if lengthens else '<'} 0$"
    return f"{sentence} If it were {state} at first, it would be fastest at the start, as it {verb} then, {less}."


def _passes(
    book: SolutionBuilder,
    step: StepBuilder,
    sides: tuple[Expression, Expression],
    relation: str,
    begins: str,
    ends: str,
) -> str:
    """Return a sentence that the spring passes its natural length, from its initial and final states.

    A `relation` in LaTeX states that the first of two `sides` is larger, which gives the initial state.
    """
    if not any(map(book.is_hidden, sides)):
        record_inequality(book, step, *sides)
        return f"The spring passes that length, as it {begins}, ${relation}$, {ends}."
    book.afterwards.append(lambda: verify_assumed(book, *sides, relation))
    return f"Assume that ${relation}$. Then the spring passes that length, as it {begins} {ends}."


def _verify_reached(launch: Launch) -> None:
    """Write that a spring that shortens at first does so until it has its natural length."""
    body, (energy, swirl) = launch.body, launch.angular_momentum_writer()
    book = body.book
    across, name = HALF * body.mass * Power(swirl / body.natural, 2), book.fresh("K", "0")
    step = book.begin_step("verify")
    record_inequality(book, step, energy, across)
    step.add_text(
        "The energy at a turning point of the length, where the velocity is perpendicular to the spring, is a convex "
        f"function of that length. It is less than ${energy.latex()}$ for ${body.length.latex()}$, where the spring "
        f"shortens, and for ${body.natural.latex()}$, where it is {step.verified(name, across, JOULES)}; so the spring "
        "does not turn back between these."
    )
    step.close()
