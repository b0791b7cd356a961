"""Collisions and flights as sums need them: what each costs in energy, gives as impulse, and how far it goes."""

from dataclasses import dataclass

from sim2reason.solutions.algebra.expressions import ONE, Expression, Number, Symbol, added, multiplied
from sim2reason.solutions.algebra.functions import Power
from sim2reason.solutions.collisions.legs import Impact
from sim2reason.solutions.collisions.oblique import Flights
from sim2reason.solutions.goals import Stretch
from sim2reason.solutions.goals.turning import squared
from sim2reason.solutions.writing.steps import UnsolvedError


@dataclass(frozen=True, slots=True)
class StruckBodies:
    """One collision."""

    flights: Flights
    impact: Impact

    @property
    def bodies(self) -> tuple[str, ...]:
        """Whose it is."""
        return self.impact.bodies

    @property
    def told(self) -> str:
        """It in words."""
        return self.flights.collision(self.impact)

    @property
    def loses(self) -> str:
        """Return the beginning of a sentence that says why kinetic energy is lost."""
        motion = "relative motion" if len(self.bodies) > 1 else "motion perpendicular to the surface"
        left = "keeps $e^2$ of its energy" if self.flights.restitution(self.impact.meeting) else "ends"
        return f"The {motion}{self._way} {left}, so"

    @property
    def pushes(self) -> str:
        """Return the beginning of a sentence that names the laws for the impulse."""
        e, pair = self.flights.restitution(self.impact.meeting), len(self.bodies) > 1
        if not pair:
            return "The impulse is the change of momentum, so"
        if e:
            return f"By conservation of momentum and restitution{self._way},"
        return f"By conservation of momentum, as no relative velocity{self._way} is left,"

    @property
    def _way(self) -> str:
        return (
            " along the line of centres" if self.flights.mechanism.meetings[self.impact.meeting].normal is None else ""
        )

    @property
    def lost(self) -> Expression:
        """½ (1 − e²) times what counts as the mass, times the square of the speed of approach."""
        closing = self.flights.closing(self.impact)
        e = self.flights.restitution(self.impact.meeting)
        left = added(ONE, -Power(e.expression(), 2)) if e else ONE
        half = multiplied(Number(0.5), multiplied(self.flights.inertia(self.impact), left))
        return multiplied(half, squared(closing))

    @property
    def push(self) -> Expression:
        """(1 + e) times what counts as the mass, times the speed of approach."""
        closing = self.flights.closing(self.impact)
        e = self.flights.restitution(self.impact.meeting).expression()
        size = closing if self.flights.book.value(closing) >= 0.0 else -closing
        return multiplied(multiplied(added(ONE, e), self.flights.inertia(self.impact)), size)


@dataclass(frozen=True, slots=True)
class FlightPart(Stretch):
    """One flight of a body."""

    flights: Flights
    number: int
    until: Symbol | None  # the time at which it is left

    def path(self, body: str) -> Expression:
        """From where the flight begins to where it ends, without a sign."""
        own = [k for k in self.flights.coordinates(body) if self.flights.leg(body, 0).speeds.get(k) is not None]
        if len(own) != 1 or self.flights.acceleration(own[0]):
            raise UnsolvedError("it turns back in flight, or flies in a plane")
        k = own[0]
        begin = self.flights.place(body, self.number, k, None)
        end = self.flights.place(body, self.number, k, self.until)
        held = (end - begin).expression()
        return held if self.flights.book.value(held) >= 0.0 else -held
