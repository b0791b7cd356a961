"""Heights above the starting point and above the ground."""

from dataclasses import dataclass

from sim2reason.questions import Target
from sim2reason.scenes.dsl.mechanism import Z
from sim2reason.simulation.quantities.positions import Height, HeightAboveStart, height_at_start
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial
from sim2reason.solutions.goals import GOALS, Goal, KnownMotion, VectorName, modulus, write_answer
from sim2reason.solutions.writing.lexicon import DualValue
from sim2reason.solutions.writing.unit_latex import METRES


@dataclass(frozen=True, slots=True)
class HeightGoal(Goal):
    """The vertical displacement of a body, from where it starts or from the ground."""

    reference: str
    from_ground: bool

    @property
    def uses(self) -> str:
        """Return ``s``: the height is derived from the displacement."""
        return "s"

    def write(self, target: Target, known: KnownMotion) -> Symbol:
        """Write the rise of the body since the start, added to its initial height if measured from the ground."""
        body, called = target.subject, known.setting.display_name(target.subject)
        first = self._at_start(body, known) if self.from_ground else NIL
        height = (first + known.component("s", body, Z)).factored()
        below, hidden = known.book.value(height) < 0.0, known.book.is_hidden(height)
        side = "below" if below else "above"
        noun, what = VectorName("h", METRES, "height"), f"the distance of {called} {side} {self.reference}"
        size = (-height if below else height) if hidden else modulus(height, known.book)  # its side is known
        return write_answer(known, size, noun, known.setting.subscript_of(body), what)

    @staticmethod
    def _at_start(body: str, known: KnownMotion) -> Polynomial:
        lexicon = known.setting.lexicon
        return lexicon.read(DualValue(*(height_at_start(m, body) for m in (lexicon.mechanism, lexicon.twin))))


GOALS.add(HeightAboveStart.name, HeightGoal("its starting point", from_ground=False))
GOALS.add(Height.name, HeightGoal("the ground", from_ground=True))
