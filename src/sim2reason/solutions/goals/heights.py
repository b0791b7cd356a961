"""Heights above the starting point and above the ground."""

from dataclasses import dataclass

from sim2reason.questions import Target
from sim2reason.scenes.dsl.mechanism import Z
from sim2reason.simulation.quantities.positions import Height, HeightAboveStart, height_at_start
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial
from sim2reason.solutions.goals import GOALS, Goal, Known, VectorName, finish, modulus
from sim2reason.solutions.writing.lexicon import Both
from sim2reason.solutions.writing.unit_latex import METRES


@dataclass(frozen=True, slots=True)
class HeightGoal(Goal):
    """The vertical displacement of a body, from where it starts or from the ground."""

    reference: str
    from_ground: bool

    @property
    def uses(self) -> str:
        """Displacements."""
        return "s"

    def write(self, target: Target, known: Known) -> Symbol:
        """Write the height at the start, if it is from the ground, and how far the body has risen since."""
        body, called = target.subject, known.setting.called(target.subject)
        first = self._at_start(body, known) if self.from_ground else NIL
        height = (first + known.component("s", body, Z)).factored()
        below, hidden = known.book.value(height) < 0.0, known.book.is_hidden(height)
        side = "below" if below else "above"
        noun, what = VectorName("h", METRES, "height"), f"the distance of {called} {side} {self.reference}"
        size = (-height if below else height) if hidden else modulus(height, known.book)  # its side is known
        return finish(known, size, noun, known.setting.mark(body), what)

    @staticmethod
    def _at_start(body: str, known: Known) -> Polynomial:
        lexicon = known.setting.lexicon
        return lexicon.read(Both(*(height_at_start(m, body) for m in (lexicon.mechanism, lexicon.twin))))


GOALS.add(HeightAboveStart.name, HeightGoal("its starting point", from_ground=False))
GOALS.add(Height.name, HeightGoal("the ground", from_ground=True))
