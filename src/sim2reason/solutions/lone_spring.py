"""A lone body on a level table, held by a single spring from a fixed point: its numbers, by their symbols."""

from functools import cached_property
from math import hypot

from sim2reason.dsl.frames import start
from sim2reason.dsl.mechanism import Elastic, Mechanism
from sim2reason.dsl.triples import minus
from sim2reason.solutions.book import Book
from sim2reason.solutions.expressions import Symbol
from sim2reason.solutions.functions import Root, squares
from sim2reason.solutions.lexicon import Both
from sim2reason.solutions.setting import Setting
from sim2reason.solutions.unit_latex import METRES


def is_lone_spring(m: Mechanism) -> bool:
    """Whether a single spring without damping, from a fixed point, is all that acts on a single body."""
    springs = [line for line in m.lines if isinstance(line.law, Elastic)]
    other = m.faces or m.forces or m.attractions or m.burns or m.meetings or m.feet
    slides = all(c.kind == "slide" and abs(c.axis[2]) < 1e-9 for c in m.coordinates)
    if len(springs) != 1 or len(m.lines) != 1 or len(m.bodies) != 1 or len(m.coordinates) != 2 or other or not slides:
        return False
    law, ends = springs[0].law, [m.site[site].body for site in springs[0].through]
    assert isinstance(law, Elastic)
    return len(ends) == 2 and None in ends and not law.damping and not law.side


def begins_at_rest(m: Mechanism) -> bool:
    """Whether nothing moves at the start."""
    return not any(c.speed for c in m.coordinates)


def length_at_first(m: Mechanism) -> float:
    """How long the spring is at the start, m."""
    return hypot(*_ends(m))


def _ends(m: Mechanism) -> tuple[float, float]:
    """From the fixed end of the spring to the body at the start, along the coordinates."""
    frames, through = start(m), m.lines[0].through
    fixed, free = sorted(through, key=lambda site: m.site[site].body is not None)
    apart = minus(frames.site(free).place, frames.site(fixed).place)
    x, y = (sum(a * b for a, b in zip(apart, c.axis, strict=True)) for c in m.coordinates)
    return float(x), float(y)


class LoneSpring:
    """What ways to its motion begin with."""

    def __init__(self, setting: Setting, book: Book) -> None:
        """UnreadError where a number is no simple function of those in the text."""
        self.setting, self.book = setting, book
        lexicon = setting.lexicon
        sides = (lexicon.mechanism, lexicon.twin)
        pairs = zip(*(_ends(m) for m in sides), strict=True)
        self.apart = [lexicon.read(Both(*pair)).expression() for pair in pairs]
        laws = [m.lines[0].law for m in sides]
        here, there = laws
        assert isinstance(here, Elastic)
        assert isinstance(there, Elastic)
        self.stiffness = lexicon.read(Both(here.stiffness, there.stiffness)).expression()
        self.natural = lexicon.read(Both(here.length, there.length)).expression()
        self.mass = lexicon.read(Both(sides[0].bodies[0].mass, sides[1].bodies[0].mass)).expression()
        speeds = zip(*([c.speed for c in m.coordinates] for m in sides), strict=True)
        self.first = [lexicon.read(Both(*pair)).expression() for pair in speeds]

    @cached_property
    def length(self) -> Symbol:
        """At the start."""
        formula = Root(squares(self.apart))
        return self.book.told(
            "length", "At first the spring is as long as", self.book.fresh(r"\ell", "1"), formula, METRES
        )
