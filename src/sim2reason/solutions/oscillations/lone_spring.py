"""A body on a level table on which one spring acts that is fixed at its other end."""

from collections.abc import Callable
from math import hypot

from sim2reason.dsl.frames import start
from sim2reason.dsl.mechanism import Elastic, Mechanism
from sim2reason.dsl.triples import minus
from sim2reason.lazy import cached_property
from sim2reason.questions.kinds.parts.stretch_kind import StretchQuery
from sim2reason.solutions.algebra.expressions import Expression, Symbol
from sim2reason.solutions.algebra.functions import length_of
from sim2reason.solutions.oscillations.greatest_value import greatest_target
from sim2reason.solutions.setting import LEVEL, Setting
from sim2reason.solutions.swings.angle import Way
from sim2reason.solutions.writing.letters import LETTERS
from sim2reason.solutions.writing.magnitudes import of_magnitude
from sim2reason.solutions.writing.steps import Book
from sim2reason.solutions.writing.unit_latex import METRES

PARTS = "stiffness", "length"


def lone_spring(m: Mechanism) -> Elastic | None:
    """The law of a single spring from a fixed point that acts on a single body; None where something else acts."""
    other = m.faces or m.forces or m.attractions or m.burns or m.meetings or m.feet
    slides = all(c.kind == "slide" and abs(c.axis[2]) < LEVEL for c in m.coordinates)
    if len(m.lines) != 1 or len(m.bodies) != 1 or len(m.coordinates) != 2 or other or not slides:
        return None
    law, ends = m.lines[0].law, [m.site[site].body for site in m.lines[0].through]
    plain = isinstance(law, Elastic) and not law.damping and not law.side
    return law if isinstance(law, Elastic) and plain and len(ends) == 2 and None in ends else None


def ends(m: Mechanism) -> tuple[float, float]:
    """From the fixed end of the spring to the body at the start, along the coordinates."""
    frames, through = start(m), m.lines[0].through
    fixed, free = sorted(through, key=lambda site: m.site[site].body is not None)
    apart = minus(frames.site(free).place, frames.site(fixed).place)
    x, y = (sum(a * b for a, b in zip(apart, c.axis, strict=True)) for c in m.coordinates)
    return float(x), float(y)


def length(m: Mechanism) -> float:
    """Of the spring at the start, m."""
    return hypot(*ends(m))


def quantity_of(setting: Setting) -> str:
    """The quantity that is asked about, be it for its greatest value; empty for a time."""
    target = greatest_target(setting) if isinstance(setting.query, StretchQuery) else setting.query.target
    return target.quantity if target is not None else ""


class LoneSpring:
    """Its numbers in the symbols of the text."""

    def __init__(self, setting: Setting, book: Book) -> None:
        """UnreadError where a number is no simple function of those in the text."""
        self.setting, self.book = setting, book
        self.apart = [self.read(lambda m, n=n: ends(m)[n]) for n in (0, 1)]
        self.stiffness, self.natural = (self.read(lambda m, of=of: getattr(m.lines[0].law, of)) for of in PARTS)
        self.mass = self.read(lambda m: m.bodies[0].mass)

    def read(self, number: Callable[[Mechanism], float]) -> Expression:
        """A number of the mechanism."""
        return self.setting.lexicon.of(number).expression()

    @cached_property
    def length(self) -> Symbol:
        """At the start."""
        said, name = "The initial length of the spring is", self.book.fresh(r"\ell", "1")
        return self.book.told("length", said, name, length_of(self.apart), METRES)

    def answer(self, way: Way, turned: Callable[[Expression], Expression]) -> Symbol:
        """Write the answer, unless it has a name; `turned` gives its formula the sign or the component asked for."""
        method, said = way
        along: Expression = getattr(self, method)()
        formula, quantity = turned(along), quantity_of(self.setting)
        if isinstance(formula, Symbol):
            return formula
        if formula == -along:
            said = of_magnitude(said, quantity)
        name = self.book.fresh(LETTERS[quantity])
        return self.book.told("answer", said, name, formula, self.setting.unit)
