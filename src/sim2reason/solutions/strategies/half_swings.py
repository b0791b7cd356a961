"""Half swings: friction shifts the place of balance each time that a body on a spring turns back.

See Lapidus, Motion of a harmonic oscillator with sliding friction, American Journal of Physics 38 (1970) 1360.
"""

from collections.abc import Sequence

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.lazy import cached_property
from sim2reason.simulation.engines.exact.motion import Segment
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial
from sim2reason.solutions.goals import Stretch
from sim2reason.solutions.oscillations.harmonic import Harmonic
from sim2reason.solutions.oscillations.linear_motion import LinearMotion, fewest_free
from sim2reason.solutions.oscillations.to_and_fro import Travelled
from sim2reason.solutions.setting import Setting
from sim2reason.solutions.strategies import STRATEGIES, Strategy, strategy
from sim2reason.solutions.strategies.oscillation import Oscillating, not_driven_back
from sim2reason.solutions.writing.steps import Book, UnsolvedError
from sim2reason.solutions.writing.unit_latex import METRES, SECONDS


@strategy
class HalfSwings(Strategy):
    """One free coordinate on springs, with friction that acts against it all the while."""

    name = "half swings"
    cost = 1.3
    kinds = frozenset({"state", "event", "time_to_event", "extremum", "sum"})

    def unfit(self, mechanism: Mechanism) -> str:
        """Whether there is no friction, or there are several modes, else as without it."""
        if not any(face.friction > 0.0 for face in mechanism.faces):
            return "there is no friction"
        return not_driven_back(mechanism) or ("there are several modes" if fewest_free(mechanism) > 1 else "")

    def refusal(self, setting: Setting) -> str:
        """As without friction."""
        return STRATEGIES["oscillation"].refusal(setting)

    def write(self, setting: Setting, book: Book) -> str:
        """Swing by swing, then the moment."""
        return _Swinging(setting, book).write().name


class _Swinging(Oscillating):
    """The last swing; those before it leave where and when it begins."""

    @cached_property
    def _segments(self) -> list[Segment]:
        return [s for s in self.setting.motion.segments if s.start < self.setting.time * (1.0 - 1e-9) or s.start == 0.0]

    @cached_property
    def segment(self) -> Segment:
        """The last one."""
        return self._segments[-1]

    def _swing(self, segment: Segment, name: Symbol, before: Harmonic | None) -> Harmonic:
        """One swing, from `begin` on."""
        at = self.book.value(self.begin) if self.begin != ZERO else 0.0
        motion = LinearMotion(self.setting, segment, self.linear.free).counted_from(self.begin, at)
        if len(motion.free) != 1:
            raise UnsolvedError("there are several modes")
        if motion.damped or not any(motion.laws.rough.values()):
            raise UnsolvedError("it does not slide all the while")
        return Harmonic(self.book, motion, name, NIL if before else self.first(motion.free[0]), before)

    @cached_property
    def harmonic(self) -> Harmonic:
        """The last swing."""
        if len(self.linear.free) != 1:
            raise UnsolvedError("nothing moves at last, or several modes do")
        self.introduce({self.linear.free[0]: self.whole_name})
        before: Harmonic | None = None
        for number, segment in enumerate(self._segments):
            name = self.book.fresh("s", str(number + 1)) if number else self.whole_name
            step = self.book.open("names")
            step.say(
                f"From there until it turns back again, the friction force is constant; let ${name.name}$ be the "
                "displacement from this turning point."
                if number
                else "Until it first turns back, the friction force is constant."
            )
            step.close()
            held = self._swing(segment, name, before)
            if segment is self._segments[-1]:
                return held
            span = self._segments[number + 1].start - segment.start
            if not held.turns(span):
                raise UnsolvedError("something changes on the way that is no turn")
            self._turn(held, span)
            before = held
        raise UnsolvedError("it never moves")

    def _turn(self, held: Harmonic, span: float) -> None:
        """Where and when the next swing begins."""
        first = self.begin == ZERO
        name = self.book.fresh("x") if first else held.name
        said = "It first turns back at" if first else "It turns back at"
        there = self.book.told("turning", said, name, held.turning(span), METRES)
        if first:
            self.begin = there
        else:
            said = "Its displacement from the start is then"
            self.begin = self.book.told("turning", said, self.book.fresh("x"), self.begin + there, METRES)
        self._places.append(self.begin)
        self._times.append((held, span))
        self.started += span

    @cached_property
    def _places(self) -> list[Expression]:
        return [ZERO]

    @cached_property
    def _times(self) -> list[tuple[Harmonic, float]]:
        return []

    @cached_property
    def _begun(self) -> Expression:
        """When the last swing begins."""
        found: Expression = ZERO
        for held, span in self._times:
            formula = held.angle_of_turning(span) / held.rate
            found = found + self.book.told(
                "time", "This half oscillation takes", self.book.fresh("t"), formula, SECONDS
            )
        return found

    def since(self, time: Symbol) -> Symbol:
        """Less what the swings before take."""
        if self._begun == ZERO:
            return time
        return self.book.told("time", "The remaining time is", self.book.fresh("t"), time - self._begun, SECONDS)

    def until(self, time: Symbol) -> Symbol:
        """And what the swings before take."""
        if self._begun == ZERO:
            return time
        return self.book.told("time", "The total time is", self.book.fresh("t"), self._begun + time, SECONDS)

    @property
    def stretches(self) -> Sequence[Stretch]:
        """All swings."""
        last = self.whole_place
        return [_Rubbing(self, [*self._places, last])]


class _Rubbing(Travelled):
    """Swings with friction of one size."""

    def force(self, kind: str, name: str) -> Polynomial:
        """µN: its work is that along the whole path."""
        if kind != "f":
            return super().force(kind, name)
        newton = self.way.newton
        number = next(n for n, face in enumerate(self.way.mechanism.faces) if face.subject == name)
        row = newton.normal(number)
        found = (row.inertia - row.forces.without((f"N{number}",))).put({f"q{k}": NIL for k in self.way.motion.ratios})
        return newton.coefficient(number) * found

    def slipped(self, body: str) -> Polynomial:
        """The whole path."""
        return Polynomial.of(self.path(body))
