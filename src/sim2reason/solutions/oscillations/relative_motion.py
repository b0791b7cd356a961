"""Relative motion of two bodies whose total momentum is conserved."""

from dataclasses import dataclass
from typing import Self

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.scenes.bodies.simple_machines import Track
from sim2reason.scenes.dsl.state import Array
from sim2reason.solutions.algebra.expressions import Number, Symbol
from sim2reason.solutions.algebra.fractions import reduced_quotient
from sim2reason.solutions.algebra.functions import Power
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial, total
from sim2reason.solutions.oscillations.linear_motion import LinearMotion, SpringLaws
from sim2reason.solutions.setting import DIRECTION_TOLERANCE, ProblemContext
from sim2reason.solutions.writing.notation import KILOGRAMS
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError


@dataclass(frozen=True, slots=True)
class MomentumWords:
    """Sentences about the conservation of momentum, each without its full stop."""

    conserved: str
    zero: str
    centre_at_rest: str  # consequence for the centre of mass, as in the next two sentences
    drifts: str
    unaccelerated: str
    frame: str  # the frame in which the momentum is zero

    @property
    def zero_momentum_sentence(self) -> str:
        """Return the sentence that the momentum is zero, with the consequence for the centre of mass."""
        return f"{self.zero}{self.centre_at_rest}"

    @classmethod
    def for_scene(cls, setting: ProblemContext) -> Self:
        """Return the sentences on conserved momentum for a scene: horizontal, along a track, or angular on a ring."""
        coordinates = setting.mechanism.coordinates
        if all(coordinate.kind == "hinge" for coordinate in coordinates):  # beads on a level ring
            return cls._angular()
        level = all(abs(c.axis[2]) < DIRECTION_TOLERANCE for c in coordinates if c.kind == "slide")
        if level and any(isinstance(body, Track) for body in setting.scene.bodies.values()):
            return cls._along_a_track()
        return cls(
            "The total horizontal momentum is conserved",
            "The total horizontal momentum is zero",
            ", so the common centre of mass does not move horizontally",
            "The horizontal velocity of the centre of mass is constant",
            "The centre of mass has no horizontal acceleration",
            "In the frame of reference in which the horizontal momentum is zero,",
        )

    @classmethod
    def _along_a_track(cls) -> Self:
        return cls(
            "The total momentum along the track is conserved",
            "The total momentum along the track is zero",
            ", so the common centre of mass stays at rest",
            "The centre of mass moves with constant velocity",
            "The centre of mass is not accelerated",
            "In the frame of reference in which the momentum is zero,",
        )

    @classmethod
    def _angular(cls) -> Self:
        return cls(
            "The angular momentum about the centre of the circle is conserved",
            "The angular momentum about the centre of the circle is zero",
            "",
            "The angular momentum about the centre of the circle is constant",
            "The angular momentum about the centre of the circle does not change",
            "In the frame of reference in which the angular momentum is zero,",
        )


HALF = Number(0.5)
HORIZONTAL_DIRECTIONS = ((1.0, 0.0), (0.0, 1.0), (1.0, 1.0), (1.0, -1.0))


class RelativeMotion:
    """A linear motion with one free coordinate: the displacement of one body relative to another."""

    def __init__(self, motion: LinearMotion, book: SolutionBuilder) -> None:
        """Take the motion of two bodies; UnsolvedError unless two coordinates are free and a momentum is conserved."""
        self.whole, self.book = motion, book
        self.laws: SpringLaws = motion.laws
        self.segment, self.givens, self.damped = motion.segment, motion.givens, motion.damped
        if len(motion.free) != 2:
            raise UnsolvedError("there are several modes" if len(motion.free) > 2 else "only one thing moves by itself")
        if len({motion.mechanism.coordinates[i].body for i in motion.free}) < len(motion.free):
            raise UnsolvedError("a single body moves in two directions")
        directions = [direction for direction in HORIZONTAL_DIRECTIONS if self._is_conserved(direction)]
        if len(directions) != 1:
            raise UnsolvedError("no momentum is conserved")
        self.way = directions[0]
        kept = 0 if self.way[0] else 1
        self.other, own = motion.free[kept], motion.free[1 - kept]
        self.free = [own]
        self.words = MomentumWords.for_scene(motion.setting)
        self.coordinate_name = "x"  # symbol of the relative displacement
        self.recoils = ""  # beginning of a sentence with the shared velocity, in the frame of zero momentum
        share = self.way[1 - kept] if self.way[kept] else 0.0  # rate of the free coordinate per rate of the other
        self.shared = share / self.way[kept]
        self.ratios = {
            k: {
                i: part
                for i, part in (
                    (self.other, motion.ratio(k, self.other) + self.shared * motion.ratio(k, own)),
                    (own, motion.ratio(k, own)),
                )
                if part
            }
            for k in motion.ratios
        }

    def _is_conserved(self, way: tuple[float, float]) -> bool:
        pairs = [*zip(self.whole.free, way, strict=True)]
        if total(self.whole.load(i).scale(part) for i, part in pairs if part):
            return False
        return not any(
            abs(sum(self.whole.extension_ratio(n, i) * part for i, part in pairs)) > 0.0 for n in self.whole.springs
        )

    def ratio(self, k: int, i: int) -> float:
        """Return the rate of coordinate k per rate of i: the relative coordinate, or the one common to both bodies."""
        return self.ratios[k].get(i, 0.0)

    @property
    def springs(self) -> list[int]:
        """Return the indices of the springs that the relative motion stretches."""
        return self.whole.springs

    def extension_ratio(self, number: int, i: int) -> float:
        """Return the rate of a line's length per rate of a coordinate; zero for the motion common to both bodies."""
        return self.whole.extension_ratio(number, i) if i == self.free[0] else 0.0

    # ---- inertia

    @cached_property
    def masses(self) -> tuple[Polynomial, Polynomial, Polynomial]:
        """Return the mass-matrix elements of the common motion of both bodies, the mixed one, and the relative one."""
        i, j, m = self.other, self.free[0], self.whole.mass
        both = m(i, j) + m(j, j).scale(self.shared)
        shared = m(i, i) + m(i, j).scale(2.0 * self.shared) + m(j, j).scale(self.shared**2)
        return shared, both, m(j, j)

    @cached_property
    def reduced_mass(self) -> Symbol:
        """Write the reduced mass µ, or the effective mass from the kinetic energy, and return its symbol."""
        shared, both, own = self.masses
        name, square = self.book.fresh(r"\mu"), Power(both.factored(), 2)
        if both == own:
            text = f"{self.words.conserved}, so the relative motion has the reduced mass"
            return self.book.add_step(
                "inertia", text, name, reduced_quotient(own * shared - both * both, shared), KILOGRAMS
            )
        step, rate = self.book.begin_step("inertia"), Symbol(rf"\dot{{{self.coordinate_name}}}")
        negative = both.value(self.givens) < 0.0
        share = (both.scale(-1.0) if negative else both).factored() / shared.expression()
        recoil, moving = share * rate if negative else -(share * rate), self.book.fresh("V")
        step.add_text(f"{self.recoils} ${recoil.latex()}$.")
        kinetic_energy = HALF * shared.expression() * Power(moving, 2) + HALF * own.expression() * Power(rate, 2)
        mixed = both.scale(-1.0 if negative else 1.0).factored() * moving * rate
        kinetic_energy = kinetic_energy - mixed if negative else kinetic_energy + mixed
        step.add_text(
            f"With ${moving.name}$ for this velocity, the total kinetic energy is ${kinetic_energy.latex()}$."
        )
        step.add_text(f"In terms of ${rate.name}$, it is")
        formula = own.expression() - square / shared.expression()
        energy = (HALF * name * Power(rate, 2)).latex()
        step.add_text(f"${energy}$ with the effective mass {step.result(name, formula, KILOGRAMS, law=True)}.")
        step.close()
        return name

    def mass(self, i: int, j: int) -> Polynomial:
        """Return the reduced mass µ of the relative motion."""
        del i, j
        return Polynomial.from_expression(self.reduced_mass)

    def stiffness(self, i: int, j: int) -> Polynomial:
        """Return the stiffness of the springs along the relative motion."""
        return self.whole.stiffness(i, j)

    def steady(self, i: int) -> Polynomial:
        """Return the forces along the relative motion except those of springs."""
        return self.whole.steady(i)

    def load(self, i: int) -> Polynomial:
        """Return the net force along the relative motion at the start."""
        return self.whole.load(i)

    def matrix(self, entry: str) -> Array:
        """Return the ``mass``, ``stiffness`` or ``damping`` matrix of the relative motion as numbers, (1, 1)."""
        if entry != "mass":
            return np.array([[getattr(self, entry)(self.free[0], self.free[0]).value(self.givens)]])
        shared, both, own = (part.value(self.givens) for part in self.masses)
        return np.array([[own - both**2 / shared]])

    def momentum(self, first: dict[int, Polynomial]) -> Polynomial:
        """Return the conserved momentum from the initial rates of both coordinates."""
        shared, both, _ = self.masses
        return shared * first.get(self.other, NIL) + both * first.get(self.free[0], NIL)
