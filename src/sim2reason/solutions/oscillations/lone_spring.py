"""Bodies attached to a single spring on a level table, and their greatest speed."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import hypot

from sim2reason.base.records import cached_property
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.strings import MostCompressed, MostStretched, NaturalLength
from sim2reason.scenes.dsl.frames import initial_frames
from sim2reason.scenes.dsl.mechanism import Elastic, Mechanism
from sim2reason.scenes.dsl.vectors import minus
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import Power, vector_length
from sim2reason.solutions.oscillations.net_force import greatest_target
from sim2reason.solutions.setting import DIRECTION_TOLERANCE, ProblemContext
from sim2reason.solutions.swings.angle import Way
from sim2reason.solutions.writing.comparing import record_inequality, verify_assumed
from sim2reason.solutions.writing.steps import SolutionBuilder, StepBuilder, UnsolvedError
from sim2reason.solutions.writing.unit_latex import JOULES, METRES, QUANTITY_SYMBOLS, magnitude_words

PARTS = "stiffness", "length"


def single_spring_law(m: Mechanism) -> Elastic | None:
    """Return the law of the only spring, from a fixed point to the only body; None for other mechanisms."""
    other = m.faces or m.forces or m.attractions or m.burns or m.meetings or m.feet
    slides = all(c.kind == "slide" and abs(c.axis[2]) < DIRECTION_TOLERANCE for c in m.coordinates)
    if len(m.lines) != 1 or len(m.bodies) != 1 or len(m.coordinates) != 2 or other or not slides:
        return None
    law, ends = m.lines[0].law, [m.site[site].body for site in m.lines[0].through]
    plain = isinstance(law, Elastic) and not law.damping and not law.side
    return law if isinstance(law, Elastic) and plain and len(ends) == 2 and None in ends else None


def ends(m: Mechanism) -> tuple[float, float]:
    """Return the vector, m, from the fixed end of the spring to the body at the start, along the coordinates."""
    frames, through = initial_frames(m), m.lines[0].through
    fixed, free = sorted(through, key=lambda site: m.site[site].body is not None)
    apart = minus(frames.site(free).place, frames.site(fixed).place)
    x, y = (sum(a * b for a, b in zip(apart, c.axis, strict=True)) for c in m.coordinates)
    return float(x), float(y)


def length(m: Mechanism) -> float:
    """Return the length of the spring at the start, m."""
    return hypot(*ends(m))


def quantity_of(setting: ProblemContext) -> str:
    """Return the quantity that is asked for, or whose greatest value is asked for; empty for a time."""
    target = greatest_target(setting) if isinstance(setting.query, StretchQuery) else setting.query.target
    return target.quantity if target is not None else ""


class SingleSpringBody:
    """The parameters of a body on a single spring, in the symbols of the text."""

    def __init__(self, setting: ProblemContext, book: SolutionBuilder) -> None:
        """Read the parameters; raise UnreadError if one is not a simple function of the numbers in the text."""
        self.setting, self.book = setting, book
        self.apart = [self.read(lambda m, n=n: ends(m)[n]) for n in (0, 1)]
        self.stiffness, self.natural = (self.read(lambda m, of=of: getattr(m.lines[0].law, of)) for of in PARTS)
        self.mass = self.read(lambda m: m.bodies[0].mass)

    def read(self, number: Callable[[Mechanism], float]) -> Expression:
        """Return a formula for a number of the mechanism."""
        return self.setting.lexicon.of(number).expression()

    @cached_property
    def length(self) -> Symbol:
        """Write the initial length of the spring, m, and return its symbol."""
        said, name = "The initial length of the spring is", self.book.fresh(r"\ell", "1")
        return self.book.add_step("length", said, name, vector_length(self.apart), METRES)

    def answer(self, way: Way, turned: Callable[[Expression], Expression]) -> Symbol:
        """Write the answer by the method in `way` and return the answer's symbol; `turned` sets a formula's sign."""
        method, said = way
        along: Expression = getattr(self, method)()
        formula, quantity = turned(along), quantity_of(self.setting)
        if isinstance(formula, Symbol):
            return formula
        if formula == -along:
            said = magnitude_words(said, quantity)
        name = self.book.fresh(QUANTITY_SYMBOLS[quantity])
        return self.book.add_step("answer", said, name, formula, self.setting.unit)


HALF = Number(0.5)


@dataclass(frozen=True, slots=True)
class Launch:
    """A body launched across its spring: its velocity, and a function that writes energy and angular momentum.

    `kept` returns the energy, in J, and the angular momentum per unit of mass, in m²/s.
    """

    body: SingleSpringBody
    velocity: Sequence[Expression]
    kept: Callable[[], tuple[Symbol, Expression]]


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
            said = _passes(book, step, sides, relation, "is stretched at first", "and compressed in the end")
        case MostStretched() if not stretched:
            said = _passes(book, step, sides, relation, "is compressed at first", "and stretched in the end")
        case MostStretched() if not lengthens:
            book.afterwards.append(lambda: _verify_reached(launch))
            why = "and does not turn back before"
            return _passes(book, step, (ZERO, outward), f"{outward.latex()} < 0", "shortens at first", why)
        case _:
            raise UnsolvedError("nothing shows that it passes its natural length")
    if known or lengthens == stretched or book.is_hidden(outward):
        return said
    record_inequality(book, step, *((outward, ZERO) if lengthens else (ZERO, outward)))
    state, way = ("compressed", "shortens") if stretched else ("stretched", "lengthens")
    less = f"${outward.latex()} {'>' if lengthens else '<'} 0$"
    return f"{said} If it were {state} at first, it would be fastest at the start, as it {way} then, {less}."


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
    body, (energy, swirl) = launch.body, launch.kept()
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
