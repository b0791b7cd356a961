"""Newton's laws of bodies on straight ways that springs pull, too; the force of spring n is the unknown ``S`` n."""

from sim2reason.scenes.dsl.frames import Frames
from sim2reason.scenes.dsl.mechanism import Elastic, Line, Mechanism
from sim2reason.solutions.algebra.polynomials import Polynomial
from sim2reason.solutions.laws.newton import Newton, symbol
from sim2reason.solutions.writing.lexicon import Both, UnreadError


class SpringLaws(Newton):
    """The laws of a segment in which springs act."""

    @property
    def springs(self) -> list[int]:
        """The numbers of the lines that are springs."""
        return [number for number, line in enumerate(self.mechanism.lines) if isinstance(line.law, Elastic)]

    def tension(self, number: int, line: Line) -> Polynomial:
        """Return the tension of a line; that of a spring is a symbol of its own."""
        if not isinstance(line.law, Elastic):
            return Newton.tension(self, number, line)
        if line.law.side:
            raise UnreadError("a spring acts only one way")
        return symbol("S", number)

    def _elastic(self, number: int, what: str) -> Polynomial:
        return self.read(lambda m, _: getattr(m.lines[number].law, what))

    def stiffness(self, number: int) -> Polynomial:
        """Of a spring, N/m."""
        return self._elastic(number, "stiffness")

    def damping(self, number: int) -> Polynomial:
        """Of the dashpot beside it, N s/m."""
        return self._elastic(number, "damping")

    def strain(self, number: int) -> Polynomial:
        """By how much a spring is longer than its natural length at the start."""
        return self.read(lambda m, f: _length(m.lines[number], f) - _natural(m, number))

    def length(self, number: int) -> Polynomial:
        """Return how long it is at the start."""
        return self.read(lambda m, f: _length(m.lines[number], f))

    def changes(self, number: int, k: int) -> Both:
        """Return how its length grows with a coordinate, as numbers."""
        return self._stretch(number, k) / self.scale[k]


def _length(line: Line, frames: Frames) -> float:
    return sum(float(piece.value) for piece in frames.pieces(line))


def _natural(mechanism: Mechanism, number: int) -> float:
    law = mechanism.lines[number].law
    assert isinstance(law, Elastic)
    return law.length
