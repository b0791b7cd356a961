"""How far a charged body gets from an axis through its starting point, to and fro or round a circle."""

from sim2reason.questions.functionals.kinematics import GreatestXAxisDistance, GreatestYAxisDistance
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import Power, Root
from sim2reason.solutions.fields.forces import AXES, TURNS, Fields
from sim2reason.solutions.fields.magnetic_motion import Turning
from sim2reason.solutions.fields.motion import Driven, FieldMotion
from sim2reason.solutions.writing.steps import UnsolvedError
from sim2reason.solutions.writing.unit_latex import METRES, SPEED

HALF, TWO = Number(0.5), Number(2.0)
REACHES = {found.name: found.along for found in (GreatestYAxisDistance, GreatestXAxisDistance)}
"""The number of the coordinate whose greatest size each functional is."""


class Reach:
    """The greatest distance from an axis, written by the centre and the amplitude of the motion along a coordinate."""

    def __init__(self, motion: FieldMotion, axis: int, launched: Expression) -> None:
        """`axis` is the number of the coordinate, `launched` the speed at the start."""
        self.motion, self.axis, self.launched, self.book = motion, axis, launched, motion.book

    def written(self) -> Symbol:
        """Write the steps, and return the name of the distance."""
        if isinstance(self.motion, Turning):
            center, size = self._round(self.motion)
        elif isinstance(self.motion, Driven):
            center, size = self._to_and_fro(self.motion)
        else:
            raise UnsolvedError("it does not move about a fixed centre")
        along = AXES[self.axis]
        across = AXES[1 - self.axis]
        if center == ZERO:
            said = f"As the centre lies on the {across} axis, the greatest distance from this axis is"
            return self.book.told("extremum", said, self.book.fresh("d"), size, METRES)
        far = self.book.magnitude(center)
        if size == far:
            said = f"It starts from a turning point along {along} and turns back as far beyond the centre, so the"
            said = f"{said} greatest distance from the {across} axis is"
            return self.book.told("extremum", said, self.book.fresh("d"), TWO * far, METRES)
        most = "radius" if isinstance(self.motion, Turning) else "amplitude"
        said = f"The {along} coordinate differs from that of the centre by at most the {most}, so the greatest distance"
        return self.book.told("extremum", f"{said} from the {across} axis is", self.book.fresh("d"), far + size, METRES)

    def _round(self, motion: Turning) -> tuple[Expression, Expression]:
        """Return the centre along the coordinate and the radius of the circle of what turns."""
        drive, turns = motion.drive, motion.turning
        if motion.fields.damping is not None or (drive is not None and (drive.growth or drive.frequency is not None)):
            raise UnsolvedError("what turns does so about no fixed centre")
        if motion.carried(self.axis, turns) != ZERO:
            raise UnsolvedError("it drifts along this coordinate")
        parts, along = motion.turned if drive is not None else motion.launch, AXES[self.axis]
        kept = [part for part in parts if part != ZERO]
        size = kept[0] if len(kept) == 1 else Root(Power(parts[0], 2) + Power(parts[1], 2))
        if drive is None:
            size = self.launched
        pace = self.book.magnitude(turns)
        size = self.book.magnitude(size)
        what = "The circle on which it moves" if drive is None else "The circle that the rotating part leads it round"
        size = self.book.told("circle", f"{what} has the radius", self.book.fresh("R"), size / pace, METRES)
        center = parts[1 - self.axis] * TURNS[self.axis] / turns
        if center == ZERO:
            return ZERO, size
        what = "the velocity" if drive is None else "this part of the velocity"
        said = f"The radius to the centre is perpendicular to {what}, so the {along} coordinate of the centre is"
        return self.book.told("circle", said, self.book.fresh(along, "c"), center, METRES), size

    def _to_and_fro(self, motion: Driven) -> tuple[Expression, Expression]:
        """Return the centre and the amplitude of a harmonic oscillation along the field."""
        drive = motion.fields.drive
        swings = drive is not None and drive.axis == self.axis == drive.along and drive.slope is not None
        if not swings or not motion.swings:
            raise UnsolvedError("it does not oscillate along this coordinate")
        center, first = motion.center, motion.launch[self.axis]
        if first == ZERO:
            size = self.book.magnitude(center)
            return center, size
        said = "With the initial velocity and displacement from the centre, the amplitude of the oscillation is"
        formula = Root(Power(center, 2) + Power(first / motion.frequency, 2))
        return center, self.book.told("extremum", said, self.book.fresh("A"), formula, METRES)


def fastest_at_center(fields: Fields, launched: Expression) -> Symbol | None:
    """Write the greatest speed in a field that drives a body back: where it is zero, by energy; else None.

    `launched` is the speed at the start.
    """
    drive, book = fields.drive, fields.book
    if drive is None or drive.slope is None or drive.along != drive.axis or book.value(drive.slope) >= 0.0:
        return None
    along, step = AXES[drive.axis], book.open("extremum")
    step.rest_on(fields.law)
    place, speed = book.fresh(along, "0"), book.fresh("v")
    found = step.result(place, -(drive.strength / drive.slope), METRES, law=True)
    step.say(f"The electric force does positive work up to where it is zero, at {along} equal to {found}.")
    magnetic = "and the magnetic force does no work" if fields.turning is not None else "and no other force acts"
    step.say(f"It depends linearly on {along}, so its mean on the way there is half of that at the start, {magnetic}.")
    gained = drive.strength * place
    square = Power(launched, 2) + gained if launched != ZERO else gained
    found = step.result(speed, Root(square), SPEED, law=True)
    step.say(
        f"By the work-energy theorem, ${(HALF * gained).latex()}$ is what half the squared speed gains in this way,"
    )
    step.say(f"so the greatest speed is {found}.")
    step.close()
    return speed
