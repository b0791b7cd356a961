"""Newton's laws of bodies on straight lines with springs; the force of spring n is the unknown ``S`` n."""

from sim2reason.scenes.dsl.frames import Frames
from sim2reason.scenes.dsl.mechanism import Elastic, Line, Mechanism
from sim2reason.solutions.algebra.polynomials import Polynomial
from sim2reason.solutions.laws.newton import Newton, symbol
from sim2reason.solutions.writing.lexicon import DualValue, UnreadError


class SpringLaws(Newton):
    """Newton's laws in a segment of a motion in which springs act."""

    @property
    def springs(self) -> list[int]:
        """Return the indices of the lines that are springs."""
        return [number for number, line in enumerate(self.mechanism.lines) if isinstance(line.law, Elastic)]

    def tension(self, number: int, line: Line) -> Polynomial:
        """Return the tension of a line; that of a spring is a symbol of its own."""
        if not isinstance(line.law, Elastic):
            return Newton.tension(self, number, line)
        if line.law.side:
            raise UnreadError("a spring acts only one way")
        return symbol("S", number)

    def _elastic(self, number: int, what: str) -> Polynomial:
        """Return a parameter of a spring, such as the stiffness, in the symbols of the text."""
        return self.read(lambda m, _: getattr(m.lines[number].law, what))

    def stiffness(self, number: int) -> Polynomial:
        """Return the stiffness of a spring, N/m."""
        return self._elastic(number, "stiffness")

    def damping(self, number: int) -> Polynomial:
        """Return the damping constant of the dashpot parallel to a spring, N s/m."""
        return self._elastic(number, "damping")

    def strain(self, number: int) -> Polynomial:
        """Return the initial extension of a spring, m."""
        return self.read(lambda m, f: _length(m.lines[number], f) - _natural(m, number))

    def length(self, number: int) -> Polynomial:
        """Return the initial length of a spring, m."""
        return self.read(lambda m, f: _length(m.lines[number], f))

    def changes(self, number: int, k: int) -> DualValue:
        """Return the change of a spring's length per unit of a coordinate, as numbers."""
        return self._stretch(number, k) / self.scale[k]


def _length(line: Line, frames: Frames) -> float:
    """Return the initial length of a line, m."""
    return sum(float(piece.value) for piece in frames.pieces(line))


def _natural(mechanism: Mechanism, number: int) -> float:
    """Return the natural length of a spring, m."""
    law = mechanism.lines[number].law
    assert isinstance(law, Elastic)
    return law.length
