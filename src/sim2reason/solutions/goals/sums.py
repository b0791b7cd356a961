"""Sums over a motion: work, impulse, heat, distance travelled, and losses in collisions."""

from abc import abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

from sim2reason.questions import Target
from sim2reason.simulation.quantities.subjects.interactions import members, surface
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Sum, Symbol, multiply_factors, sum_terms
from sim2reason.solutions.algebra.polynomials import Polynomial, total
from sim2reason.solutions.goals import (
    GOALS,
    CollisionTerm,
    Components,
    Goal,
    KnownMotion,
    MotionPart,
    VectorName,
    magnitude,
    modulus,
    write_answer,
)
from sim2reason.solutions.goals.kinematics import VELOCITIES
from sim2reason.solutions.setting import ProblemContext, join_words
from sim2reason.solutions.writing.steps import UnsolvedError

WORK = VectorName.for_quantity("work of a tension")
HEAT = VectorName.for_quantity("energy dissipated by friction")
IMPULSES = VectorName.for_quantity("impulse of the net force")


class SumGoal(Goal):
    """A quantity that is a sum over the parts of a motion."""

    noun: ClassVar[VectorName]

    @property
    def uses(self) -> str:
        """Return ``s``: the sum is derived from the displacement in each part of the motion."""
        return "s"

    @property
    def throughout(self) -> bool:
        """Return True: the sum depends on forces during the whole motion."""
        return True

    @abstractmethod
    def term(self, target: Target, setting: ProblemContext, part: MotionPart) -> Expression:
        """Return the contribution of one part of the motion to the sum."""

    @abstractmethod
    def sum_name(self, target: Target, setting: ProblemContext) -> str:
        """Return the name of the sum, such as *the work of the hand*."""

    def write(self, target: Target, known: KnownMotion) -> Symbol:
        """Write the sum and return its symbol."""
        sum_formula: Expression = ZERO
        for part in known.motion_parts:
            sum_formula = sum_terms(sum_formula, self.term(target, known.setting, part))
        return write_answer(known, _gathered(sum_formula), self.noun, "", self.sum_name(target, known.setting))


def _gathered(formula: Expression) -> Expression:
    """Return a sum with equal terms collected, such as 2 s for s + s."""
    terms = formula.terms if isinstance(formula, Sum) else (formula,)
    if not all(isinstance(term, Symbol) or isinstance(-term, Symbol) for term in terms):
        return formula
    signed = [
        Polynomial.from_expression(t) if isinstance(t, Symbol) else Polynomial.from_expression(-t).scale(-1.0)
        for t in terms
    ]
    return total(signed).expression()


class TensionImpulse(SumGoal):
    """The impulse of a tension, T t for each part of the motion."""

    noun = IMPULSES

    def bodies(self, target: Target) -> Sequence[str]:
        """Return no bodies: the impulse depends on the tension and time, not on a particular body."""
        del target
        return ()

    def force(self, target: Target, setting: ProblemContext) -> str:
        """Return the name of the unknown tension, such as ``T2``."""
        return tension(target.subject, setting)

    def term(self, target: Target, setting: ProblemContext, part: MotionPart) -> Expression:
        """Return tension times duration for one part of the motion."""
        del setting
        return multiply_factors(part.force("T", target.subject).expression(), part.time)

    def write(self, target: Target, known: KnownMotion) -> Symbol:
        """Write the impulse part by part, or in one formula if the strategy has one."""
        return known.impulse(target.subject) or SumGoal.write(self, target, known)

    def sum_name(self, target: Target, setting: ProblemContext) -> str:
        """Return the name of the impulse, with that of the string."""
        return f"the impulse of the tension in {setting.string_phrases[target.subject]}"


class TensionWork(SumGoal):
    """The work of a tension on a body, T s along the string for each part of the motion."""

    noun = WORK

    def force(self, target: Target, setting: ProblemContext) -> str:
        """Return the name of the unknown tension of the string attached to the body, such as ``T2``."""
        return tension(_tied(target.subject, setting), setting)

    def term(self, target: Target, setting: ProblemContext, part: MotionPart) -> Expression:
        """Return tension times displacement along the string for one part of the motion."""
        name = _tied(target.subject, setting)
        return multiply_factors(
            part.force("T", name).expression(), part.displacement_along_line(target.subject, name).expression()
        )

    def write(self, target: Target, known: KnownMotion) -> Symbol:
        """Write the work part by part, or in one formula if the strategy has one."""
        name = _tied(target.subject, known.setting)
        return known.work(name, target.subject) or SumGoal.write(self, target, known)

    def sum_name(self, target: Target, setting: ProblemContext) -> str:
        """Return the name of the work of a tension on a body."""
        return f"the work of the tension on {setting.display_name(target.subject)}"


class HeatGoal(SumGoal):
    """The energy dissipated by friction: friction times the distance of slip, without a sign."""

    noun = HEAT

    def force(self, target: Target, setting: ProblemContext) -> str:
        """Return the name of the unknown friction force on the body, such as ``f0``."""
        names = [face.subject for face in setting.mechanism.faces]
        return f"f{names.index(target.subject)}"

    def bodies(self, target: Target) -> Sequence[str]:
        """Return the body that slips."""
        return (target.subject,)

    def term(self, target: Target, setting: ProblemContext, part: MotionPart) -> Expression:
        """Return friction times distance of slip for one part of the motion."""
        del setting
        friction = part.force("f", target.subject)
        return multiply_factors(friction.expression(), part.slipped(target.subject).expression()) if friction else ZERO

    def sum_name(self, target: Target, setting: ProblemContext) -> str:
        """Return the name of the dissipated energy; for a rolling body it mentions the slip of the contact point."""
        rolls = any(face.subject == target.subject and len(face.slip) > 1 for face in setting.mechanism.faces)
        how = ", which is the friction times the distance that the point of contact slips," if rolls else ""
        who, under = setting.display_name(target.subject), setting.mechanism.body[target.subject].parent
        if under is not None or any(body.parent == target.subject for body in setting.mechanism.bodies):
            on = surface(setting.mechanism, target.subject, setting.words.mentions)
            return f"the energy that friction between {who} and {on} dissipates{how}"
        return f"the energy that friction on {who} dissipates{how}"


class HandWork(SumGoal):
    """The work of a hand: its force times the length of string drawn in."""

    noun = WORK

    def bodies(self, target: Target) -> Sequence[str]:
        """Return no bodies: the work depends on the length of the string, not on one body."""
        del target
        return ()

    def lines(self, target: Target) -> Sequence[str]:
        """Return the string that is drawn in."""
        return (target.subject,)

    def term(self, target: Target, setting: ProblemContext, part: MotionPart) -> Expression:
        """Return the force of the hand times the length of string drawn in, for one part of the motion."""
        del setting
        return multiply_factors(
            part.force("T", target.subject).expression(), part.drawn_length(target.subject).expression()
        )

    def sum_name(self, target: Target, setting: ProblemContext) -> str:
        """Return the name of the work of a hand."""
        del target, setting
        return "the work of the hand"


class PathLength(SumGoal):
    """The distance travelled by a body: the sum of the distances between its turning points."""

    noun = VectorName.for_quantity("distance travelled")

    def term(self, target: Target, setting: ProblemContext, part: MotionPart) -> Expression:
        """Return the distance travelled in one part of the motion."""
        del setting
        return part.path(target.subject)

    def write(self, target: Target, known: KnownMotion) -> Symbol:
        """Write the terms that have no names yet, such as those of a body that turns back, then the sum."""
        all_terms = (term for part in known.motion_parts for term in part.paths(target.subject))
        terms = [term for term in all_terms if term != ZERO]  # zero for a flight that begins at the moment
        sum_formula: Expression = ZERO
        for term in terms:
            sum_formula = sum_terms(sum_formula, term)
        what, formula = self.sum_name(target, known.setting), _gathered(sum_formula)
        if formula != sum_formula and all(_gathered(term) == term for term in terms):
            lengths = join_words([f"${term.latex()}$" for term in terms])
            what = (
                f"part by part, the path of {known.setting.display_name(target.subject)} is {lengths} long, so {what}"
            )
        return write_answer(known, formula, self.noun, "", what)

    def sum_name(self, target: Target, setting: ProblemContext) -> str:
        """Return the name of the distance travelled by a body."""
        return f"the distance that {setting.display_name(target.subject)} travels"


class NetImpulseGoal(Goal):
    """The impulse of the net force on a body: its change of momentum."""

    @property
    def uses(self) -> str:
        """Return ``v``: the impulse is derived from the final velocity."""
        return "v"

    def write(self, target: Target, known: KnownMotion) -> Symbol:
        """Write the impulse as m times the change of velocity."""
        body = target.subject
        lone = known.line_component("v", body), known.line_component("u", body)
        if lone[0] is not None and lone[1] is not None:
            size = (lone[0] - lone[1]).expression()
        else:
            end, begin = known.vector("v", body), known.vector("u", body)
            parts: Components = (end[0] - begin[0], end[1] - begin[1], end[2] - begin[2])
            size = magnitude(parts, known, VectorName("w", VELOCITIES.unit, "change in the velocity"), body)
        mass = known.mass(body).expression()
        formula = multiply_factors(mass, modulus(size, known.book, of_either_sign=True))
        who = known.setting.display_name(body)
        return write_answer(
            known, formula, IMPULSES, "", f"the impulse is the change in the momentum of {who}, of magnitude"
        )


def tension(line: str, setting: ProblemContext) -> str:
    """Return the name of the unknown tension of a string, such as ``T2``."""
    names = [constraint.name for constraint in setting.mechanism.constraints]
    if line not in names:
        raise UnsolvedError("it has no tension of its own")
    return f"T{names.index(line)}"


def _tied(body: str, setting: ProblemContext) -> str:
    """Return the name of the only string attached to a body; UnsolvedError for none or several."""
    m = setting.mechanism
    string_names = [line.name for line in m.strings if any(m.site[site].body == body for site in line.through)]
    if len(string_names) != 1:
        raise UnsolvedError("the body has no string of its own")
    return string_names[0]


GOALS.add("impulse of a tension", TensionImpulse())
GOALS.add("work of a tension", TensionWork())
GOALS.add("energy dissipated by friction", HeatGoal())
GOALS.add("work of a hand", HandWork())
GOALS.add("distance travelled", PathLength())
GOALS.add("impulse of the net force", NetImpulseGoal())


LOSS = VectorName.for_quantity("energy lost in a collision")


@dataclass(frozen=True, slots=True)
class CollisionGoal(Goal):
    """The energy lost, or the impulse, in the last collision of given bodies or in all collisions.

    The kinetic energy that two bodies lose is that of their motion along the normal in the frame of their centre of
    mass, (1 − e²) of it; see any textbook, such as Kleppner and Kolenkow, An Introduction to Mechanics, § 6.3.
    """

    noun: VectorName
    of: str  # bodies of the collisions: pair, body or whole
    several: bool

    @property
    def uses(self) -> str:
        """Return ``v``: the energy lost and the impulse are derived from velocities."""
        return "v"

    def bodies(self, target: Target) -> Sequence[str]:
        """Return the colliding bodies; for all collisions, no bodies."""
        return members(target.subject) if self.of == "pair" else (target.subject,) if self.of == "body" else ()

    def write(self, target: Target, known: KnownMotion) -> Symbol:
        """Write the loss or impulse of one collision as a formula, or of several as a sum."""
        own = {*self.bodies(target)}
        collisions = [struck for struck in known.impacts if not own or {*struck.bodies} == own]
        if not collisions:
            raise UnsolvedError("there is no such collision")
        collisions = collisions if self.several else collisions[-1:]
        what = "the kinetic energy lost" if self.noun is LOSS else "the magnitude of the impulse"
        if len(collisions) == 1:
            return write_answer(known, self._one(collisions[0]), self.noun, "", f"{self._law(collisions[0])} {what} is")
        sum_formula: Expression = ZERO
        for number, struck in enumerate(collisions, start=1):
            formula = self._one(struck)
            step, name = known.book.begin_step("sum"), known.book.fresh(self.noun.base, str(number))
            law = (
                f"{self._law(struck)} {what} in {struck.collision_name}"
                if number == 1
                else f"In {struck.collision_name} it"
            )
            step.add_text(f"{law} is {step.result(name, formula, self.noun.unit, law=True)}.")
            step.close()
            sum_formula = sum_terms(sum_formula, name)
        return write_answer(known, sum_formula, self.noun, "", f"{what} in all is")

    def _law(self, struck: CollisionTerm) -> str:
        """Return the first words of a sentence that gives a collision's energy loss or impulse: the law for it."""
        return struck.energy_loss_lead if self.noun is LOSS else struck.impulse_lead

    def _one(self, struck: CollisionTerm) -> Expression:
        """Return the energy loss or the impulse of one collision."""
        return struck.energy_loss if self.noun is LOSS else struck.impulse_magnitude


GOALS.add("energy lost in a collision", CollisionGoal(LOSS, "pair", several=False))
GOALS.add("energy lost in collisions", CollisionGoal(LOSS, "whole", several=True))
GOALS.add("impulse of a collision", CollisionGoal(IMPULSES, "pair", several=False))
GOALS.add("impulse of an impact", CollisionGoal(IMPULSES, "body", several=False))
GOALS.add("total impulse of impacts", CollisionGoal(IMPULSES, "body", several=True))
