"""A carriage on a level rail, with an arm that swings on it and strings that pull it along the rail."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from math import copysign

from sim2reason.base.records import cached_property
from sim2reason.scenes.dsl.frames import initial_frames
from sim2reason.scenes.dsl.mechanism import ConstantTension, Coordinate, Inextensible, Line, Mechanism
from sim2reason.scenes.dsl.vectors import dot, subtract_triples
from sim2reason.solutions.algebra.expressions import ZERO, Expression
from sim2reason.solutions.algebra.functions import sum_formulas
from sim2reason.solutions.setting import DIRECTION_TOLERANCE, ProblemContext, capitalized
from sim2reason.solutions.swings.arm import Arm
from sim2reason.solutions.writing.steps import SolutionBuilder


@dataclass(frozen=True, slots=True)
class CarriagePull:
    """A string that pulls the carriage along or against its axis, held by a hand or by a hanging body."""

    line: str
    side: float  # 1.0 along the axis, -1.0 against it
    body: str = ""  # empty for a hand


@dataclass(frozen=True, slots=True)
class CarriageSystem:
    """The carriage, the arm that swings on it, and the strings that pull it."""

    carriage: str
    arm: str
    pulls: tuple[CarriagePull, ...]


def carriage_system(m: Mechanism) -> CarriageSystem | None:
    """Return the carriage, arm and strings of a mechanism that starts from rest; None for other mechanisms."""
    hinges = [c for c in m.coordinates if c.kind == "hinge"]
    other = m.faces or m.forces or m.attractions or m.burns or m.meetings or m.feet
    if len(hinges) != 1 or other or any(c.speed for c in m.coordinates):
        return None
    hinge, carriage = hinges[0], m.body[hinges[0].body].parent
    slides = [c for c in m.coordinates if c.body == carriage]
    if carriage is None or m.body[carriage].parent is not None or len(slides) != 1 or slides[0].kind != "slide":
        return None
    pulls = [_pull(m, line, slides[0]) for line in m.lines]
    along = slides[0].axis
    upright = (
        abs(along[2]) < DIRECTION_TOLERANCE
        and abs(hinge.axis[2]) < DIRECTION_TOLERANCE
        and abs(dot(along, hinge.axis)) < DIRECTION_TOLERANCE
    )
    valid_pulls = tuple(pull for pull in pulls if pull is not None)
    known = {carriage, hinge.body, *(pull.body for pull in valid_pulls if pull.body)}
    is_complete = len(m.coordinates) == len(known) and all(
        body.name in known or body.parent in known for body in m.bodies
    )
    return (
        CarriageSystem(carriage, hinge.body, valid_pulls)
        if upright and is_complete and len(valid_pulls) == len(pulls)
        else None
    )


def _pull(m: Mechanism, line: Line, rail: Coordinate) -> CarriagePull | None:
    """Return the pull of a string that runs along the rail from the carriage; None for any other string."""
    on = [index for index, site in enumerate(line.through) if m.site[site].body == rail.body]
    if len(on) != 1 or on[0] not in (0, len(line.through) - 1) or line.wheels or line.circle:
        return None
    names = line.through if on[0] == 0 else line.through[::-1]
    inner, outer = names[:-1], m.site[names[-1]]
    frames = initial_frames(m)
    direction = subtract_triples(frames.site(names[1]).place, frames.site(names[0]).place)
    fixed = all(m.site[site].body is None for site in inner[1:])
    if not fixed or abs(abs(dot(direction, rail.axis)) - dot(direction, direction) ** 0.5) > DIRECTION_TOLERANCE:
        return None
    side = copysign(1.0, float(dot(direction, rail.axis)))
    if isinstance(line.law, ConstantTension):
        return CarriagePull(line.name, side) if outer.body is None else None
    plain = isinstance(line.law, Inextensible) and not line.law.slack and not line.law.reel
    down = subtract_triples(frames.site(names[-1]).place, frames.site(names[-2]).place)
    hangs = (
        outer.body is not None and down[2] < 0.0 and abs(abs(down[2]) - dot(down, down) ** 0.5) < DIRECTION_TOLERANCE
    )
    own = m.body[outer.body].coordinates if outer.body is not None else ()
    free = len(own) == 1 and own[0].kind == "slide" and abs(own[0].axis[2]) > 1.0 - DIRECTION_TOLERANCE
    return CarriagePull(line.name, side, outer.body) if plain and hangs and free and outer.body else None


class Carriage:
    """The masses and forces of a carriage, in the symbols of the text; forward is the arm's initial side."""

    def __init__(self, setting: ProblemContext, book: SolutionBuilder) -> None:
        """Read the parameters; raise UnreadError if one is not a simple function of the numbers in the text."""
        system = carriage_system(setting.mechanism)
        assert system is not None, "who asks has seen that something swings on it"
        self.setting, self.riding = setting, system
        self.arm = Arm(setting, book, system.arm)
        self._rail = setting.mechanism.body[system.carriage].coordinates[0].axis
        self.forward = copysign(1.0, float(dot(self._rail, self.arm.initial_direction(setting.mechanism))))

    @property
    def way(self) -> str:
        """Return the forward direction of the rail, in words."""
        x, y, z = self._rail
        return self.setting.direction_words((self.forward * x, self.forward * y, self.forward * z))

    @property
    def turning(self) -> str:
        """Return the sense of rotation of the arm as it falls from its initial side, in words."""
        return {"to the right": "clockwise", "to the left": "anticlockwise"}.get(self.way, "downward")

    def read(self, number: Callable[[Mechanism], float]) -> Expression:
        """Return a formula for a number of the mechanism."""
        return self.setting.lexicon.formula_for(number).expression()

    def mass(self, body: str) -> Expression:
        """Return the mass of a body, kg."""
        return self.read(lambda m: m.body[body].mass)

    @cached_property
    def moving_along(self) -> list[str]:
        """Return the bodies with the speed of the carriage: the carriage and those that hang from its strings."""
        return [self.riding.carriage, *(pull.body for pull in self.riding.pulls if pull.body)]

    @cached_property
    def sliding_mass(self) -> Expression:
        """Return the total mass of the carriage and of the bodies that hang from its strings, kg."""
        return sum_formulas(self.mass(body) for body in self.moving_along)

    @cached_property
    def swinging_mass(self) -> Expression:
        """Return the mass of the arm with the bodies on it, kg."""
        return sum_formulas(self.arm.piece(body).mass for body in self.arm.bodies)

    @cached_property
    def total_mass(self) -> Expression:
        """Return the mass of all bodies, kg."""
        return self.sliding_mass + self.swinging_mass

    @cached_property
    def is_single_body(self) -> bool:
        """Return whether a single small body swings."""
        inertia = self.setting.mechanism.body[self.arm.bodies[0]].inertia
        return len(self.arm.bodies) == 1 and not any(inertia)

    def towards(self, line: str) -> float:
        """Return 1.0 if a string pulls the carriage forward, -1.0 if it pulls it back."""
        return next(self.forward * pull.side for pull in self.riding.pulls if pull.line == line)

    @cached_property
    def driving_force(self) -> Expression:
        """Return the forward force along the rail, in N: that of hands, and the weight of hanging bodies."""
        force: Expression = ZERO
        for pull in sorted(self.riding.pulls, key=lambda pull: -self.towards(pull.line)):
            size = self._weight(pull.body) if pull.body else self._hand(pull.line)
            force = force + (size if self.towards(pull.line) > 0.0 else -size)
        return force

    def _weight(self, body: str) -> Expression:
        return self.mass(body) * self.arm.gravity

    def _hand(self, line: str) -> Expression:
        def force(m: Mechanism) -> float:
            law = m.line[line].law
            assert isinstance(law, ConstantTension)
            return law.force

        return self.read(force)

    @property
    def noun(self) -> str:
        """Return the noun phrase of the carriage, such as *the cart*."""
        return self.setting.display_name(self.riding.carriage)

    def hanging_body_sentences(self) -> Iterator[str]:
        """Yield a sentence for each hanging body, which adds to the mass of the carriage."""
        x, y, z = (self.forward * part for part in self._rail)
        for pull in self.riding.pulls:
            if pull.body:
                direction = self.setting.direction_words((x, y, z) if self.towards(pull.line) > 0.0 else (-x, -y, -z))
                mass, weight = (expression.latex() for expression in (self.mass(pull.body), self._weight(pull.body)))
                yield (
                    f"{capitalized(self.setting.display_name(pull.body))} moves vertically as fast as {self.noun} "
                    f"along the rail, so it acts as a mass ${mass}$ fixed to {self.noun} "
                    f"that a force ${weight}$ pulls {direction}."
                )
