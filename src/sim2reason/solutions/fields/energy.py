"""Energy of a charged body in fields and a medium; magnetic forces do no work."""

from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import Power, Root
from sim2reason.solutions.algebra.polynomials import NIL, total
from sim2reason.solutions.fields.moment import FieldMoment
from sim2reason.solutions.goals import magnitude
from sim2reason.solutions.goals.kinematics import VELOCITIES, squared
from sim2reason.solutions.laws.straight_way import StraightMotion
from sim2reason.solutions.writing.steps import UnsolvedError
from sim2reason.solutions.writing.unit_latex import JOULES

HALF = Number(0.5)


class FieldEnergy:
    """Works and energies of a charged body up to a moment, written as they are needed."""

    def __init__(self, known: StraightMotion, moment: FieldMoment) -> None:
        """Take the displacement and velocity at the moment of the question as `known`, and that `moment`."""
        self.known, self.moment, self.fields, self.book = known, moment, moment.fields, known.book

    def potential(self) -> Expression:
        """Return the work of the electric force along its axis; UnsolvedError for a field without a potential."""
        drive, mass = self.fields.drive, self.fields.mass
        if drive is None:
            return ZERO
        if drive.growth is not None or drive.frequency is not None:
            raise UnsolvedError("the field changes with time")
        moved = self.known.vector("s", self.fields.body)[drive.axis].expression()
        work = mass * drive.strength * moved
        if drive.slope is not None:
            if drive.along != drive.axis:
                raise UnsolvedError("the field has no potential")
            work = work + HALF * mass * drive.slope * Power(moved, 2)
        return work

    def _gained(self) -> Expression:
        """Return the change in kinetic energy from the start to the moment of the question."""
        speeds = (self.known.first_speeds.get(number, NIL) for number in self.fields.coordinates)
        first = total(speed * speed for speed in speeds).expression()
        square = self._square()
        return HALF * self.fields.mass * (square - first)

    def _square(self) -> Expression:
        """Return the square of the body's speed at the moment of the question."""
        if self.moment.speed is not None:
            return Power(self.moment.speed, 2)
        last = magnitude(self.known.vector("v", self.fields.body), self.known, VELOCITIES, self.fields.body)
        return last.inside if isinstance(last, Root) else squared(last)

    def work(self) -> Symbol:
        """Write the work of the electric field and return its symbol."""
        if self.fields.damping is None:
            formula = self._gained()
            said = "The magnetic force does no work, so the work of the electric force is the gain in kinetic energy,"
            said = said if self.fields.turning is not None else "By the work-energy theorem,"
        else:
            said, formula = "The work of the electric force is", self.potential()
        return self.book.add_step("work", said, self.book.fresh("W"), formula, JOULES)

    def lost(self) -> Symbol:
        """Write the energy lost to the medium: the electric work minus the gain in kinetic energy."""
        work: Expression = self.potential()
        if work != ZERO:
            said = "The work of the electric force is"
            work = self.book.add_step("work", said, self.book.fresh("W"), work, JOULES)
        said = "The energy lost to the medium is this work less the gain in kinetic energy,"
        return self.book.add_step("energy", said, self.book.fresh("Q"), work - self._gained(), JOULES)
