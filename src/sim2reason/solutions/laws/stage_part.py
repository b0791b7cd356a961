"""A stage of a motion as sums need it: how long, by which force, how far."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Protocol

from sim2reason.dsl.frames import Frames
from sim2reason.dsl.mechanism import ConstantTension, Mechanism
from sim2reason.dsl.triples import minus, product
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial, total
from sim2reason.solutions.goals import Stretch
from sim2reason.solutions.laws.dynamics import Dynamics
from sim2reason.solutions.laws.newton import Newton
from sim2reason.solutions.laws.rolling_words import rolling_way
from sim2reason.solutions.laws.straight_way import Way
from sim2reason.solutions.writing.steps import Book, UnsolvedError


class Course(Protocol):
    """How far coordinates come in a part of a motion, see `Stage`."""

    @property
    def dynamics(self) -> Dynamics:
        """What names its displacements, or its accelerations."""
        ...

    @property
    def time(self) -> Symbol:
        """How long it takes."""
        ...

    def gain(self, k: int) -> Polynomial:
        """How far a coordinate comes."""
        ...

    def gained(self, k: int) -> Polynomial:
        """The same, relative to what carries the body."""
        ...

    def path(self, k: int) -> Expression:
        """How far to and fro, without a sign."""
        ...


def tell_arcs(book: Book, stages: Sequence[Course], k: int) -> None:
    """Write through which arcs a hinge turns the rim of its body in several stages, and which of them it turns back."""
    gains = [gain for stage in stages if (gain := stage.gain(k))]
    if len(gains) < 2:
        return
    step, dynamics = book.open("verify"), stages[0].dynamics
    senses = [1.0 if book.value(gain.expression()) > 0.0 else -1.0 for gain in gains]
    arcs = [f"${gain.scaled(sense).expression().latex()}$" for gain, sense in zip(gains, senses, strict=True)]
    turns = ("further" if now == before else "back" for before, now in pairwise(senses))
    later = (f", then {way} through {arc}" for way, arc in zip(turns, arcs[1:], strict=True))
    who = dynamics.setting.called(dynamics.mechanism.coordinates[k].body)
    way = rolling_way(dynamics, k, senses[0])
    step.say(f"The rim of {who} first turns through the arc {arcs[0]} in the sense of rolling {way}{''.join(later)}.")
    for name in dict.fromkeys(name for gain in gains for name in gain.names()):
        step.rest_on(name)
    step.close()


@dataclass(frozen=True, slots=True)
class StagePart(Stretch):
    """One stage of a way, and the laws that give its forces."""

    way: Way
    stage: Course
    laws: Dynamics

    @property
    def _newton(self) -> Newton:
        return self.laws.newton

    @property
    def time(self) -> Symbol:
        """How long it takes."""
        return self.stage.time

    def force(self, kind: str, name: str) -> Polynomial:
        """A tension; µN against the slip of a body that slides, with the sign that makes its work positive."""
        m, names = self.way.mechanism, self.laws.names
        if kind == "T":
            line = m.line[name]
            if isinstance(line.law, ConstantTension):
                return self._newton.tension(m.lines.index(line), line)
            return names.get(f"T{m.constraints.index(line)}", NIL)
        face = next(number for number, held in enumerate(m.faces) if held.subject == name)
        side = self._newton.rough.get(face, 0)
        return (self._newton.coefficient(face) * names[f"N{face}"]).scaled(float(side)) if side else NIL

    def moved(self, body: str, line: str) -> Polynomial:
        """How far a body moves along a line that is tied to it."""
        own = self.stage.dynamics.enough(self.way.moving([body]))
        parts: list[Polynomial] = []
        for k in own:
            along = self._newton.read(lambda m, f, k=k: _along(m, f, (body, line, k)))
            parts.append(along * self.stage.gain(k) if along else NIL)
        return total(parts)

    def slipped(self, body: str) -> Polynomial:
        """How far it slips on its face."""
        face = next(n for n, held in enumerate(self.way.mechanism.faces) if held.subject == body)
        return total(part * self.stage.gained(k) for k, part in self._newton.slip(face).items())

    def drawn(self, line: str) -> Polynomial:
        """By how much a line grows shorter."""
        number = self.way.mechanism.lines.index(self.way.mechanism.line[line])
        moving = self.way.stretching(line)
        return total(self._newton.stretch(number, k) * self.stage.gained(k) for k in moving).scaled(-1.0)

    def path(self, body: str) -> Expression:
        """How far it travels along its line."""
        dynamics = self.stage.dynamics
        own = [k for k in dynamics.enough(self.way.moving([body])) if k not in dynamics.frozen]
        if not own:
            return ZERO
        if len(own) != 1:
            raise UnsolvedError("its path is no line of its own")
        return self.stage.path(own[0])


def _along(mechanism: Mechanism, frames: Frames, of: tuple[str, str, int]) -> float:
    """How much of a coordinate's motion goes along a line, away from where that is tied to a body."""
    body, line, k = of
    through = mechanism.line[line].through
    ends = through if mechanism.site[through[0]].body == body else through[::-1]
    apart = minus(frames.site(ends[1]).place, frames.site(ends[0]).place)
    size = float(product(apart, apart)) ** 0.5
    return float(product(apart, frames.center(body).gradient[k])) / size
