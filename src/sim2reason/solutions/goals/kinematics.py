"""Displacements, velocities, accelerations, rotations, distances and heights."""

from abc import abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

from sim2reason.questions import Target
from sim2reason.scenes.dsl.mechanism import Z
from sim2reason.simulation.quantities.positions import Height, HeightAboveStart, height_at_start
from sim2reason.simulation.quantities.subjects import Sense
from sim2reason.simulation.quantities.subjects.interactions import members
from sim2reason.solutions.algebra.expressions import Expression, Symbol, multiply_factors, ratio
from sim2reason.solutions.algebra.functions import Absolute, Power, Root
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial
from sim2reason.solutions.closed_forms.symbolic_answers import reason_for_negative
from sim2reason.solutions.goals import (
    GOALS,
    Components,
    Goal,
    KnownMotion,
    VectorName,
    magnitude,
    modulus,
    write_answer,
)
from sim2reason.solutions.writing.lexicon import DualValue
from sim2reason.solutions.writing.notation import METRES

DISPLACEMENTS = VectorName.for_quantity("displacement")
VELOCITIES = VectorName.for_quantity("velocity")
ACCELERATIONS = VectorName.for_quantity("acceleration")


def along_sense(whose: str, sense: Sense) -> str:
    """Return words such as *the x component of the velocity*, or *the velocity (taking up as positive)*."""
    if sense.fixed:
        return f"the {sense.axis} component of the {whose}"
    return f"the {whose} (taking {sense.positive} as positive)"


@dataclass(frozen=True, slots=True)
class VectorGoal(Goal):
    """A displacement, velocity or acceleration of a body: its component along a sense, or its magnitude."""

    noun: VectorName

    @property
    def uses(self) -> str:
        """Return the kind of the vector: displacement ``s``, velocity ``v`` or acceleration ``a``."""
        return self.noun.base

    def write(self, target: Target, known: KnownMotion) -> Symbol:
        """Write the components, then the component or magnitude asked for."""
        body, base = target.subject, self.noun.base
        whose, carrier = (
            f"{self.noun.noun} of {known.setting.display_name(body)}",
            known.setting.mechanism.body[body].parent,
        )
        mark = known.setting.subscript_of(body)
        if target.sense is not None:
            formula = known.component(base, body, target.sense.vector).factored()
            return write_answer(known, formula, self.noun, mark, along_sense(whose, target.sense))
        lone = None if known.book.in_symbols else known.line_component(base, body)
        if lone is not None and lone:
            whose = f"{whose} relative to the ground" if carrier is not None and lone.symbol is None else whose
            formula = modulus(lone.factored(), known.book)
        else:
            formula = magnitude(known.vector(base, body), known, self.noun, body)
        if isinstance(formula, Absolute) and (
            why := reason_for_negative(known.setting, known.book, formula.inside, body)
        ):
            what = f"{why}, so the magnitude of the {whose} is"
            return write_answer(known, -formula.inside, self.noun, mark, what)
        return write_answer(known, formula, self.noun, mark, f"so the magnitude of the {whose} is")


for _name, _noun in {"displacement": DISPLACEMENTS, "velocity": VELOCITIES, "acceleration": ACCELERATIONS}.items():
    GOALS.add(_name, VectorGoal(_noun))


@dataclass(frozen=True, slots=True)
class RelativeSpeedGoal(Goal):
    """The relative speed of two bodies."""

    @property
    def uses(self) -> str:
        """Return ``v``: the relative speed is derived from velocities."""
        return "v"

    def bodies(self, target: Target) -> Sequence[str]:
        """Return the two bodies of the subject."""
        return members(target.subject)

    def write(self, target: Target, known: KnownMotion) -> Symbol:
        """Write the difference of the velocities component by component, then its magnitude."""
        one, other = members(target.subject)
        a, b = known.vector("v", one), known.vector("v", other)
        parts: Components = (b[0] - a[0], b[1] - a[1], b[2] - a[2])
        noun, reference_name = VectorName.for_quantity("relative speed", "velocity"), known.setting.display_name(one)
        formula = magnitude(parts, known, noun, other, relative_to=reference_name)
        return write_answer(known, formula, VELOCITIES, r"\text{rel}", "so the relative speed is")


GOALS.add("relative speed", RelativeSpeedGoal())


class AboutAxis(Goal):
    """A quantity that depends on the rotation of a body about its own axis."""

    @property
    def turns(self) -> bool:
        """Return True: the quantity depends on the rotation of the body."""
        return True


@dataclass(frozen=True, slots=True)
class AngularGoal(AboutAxis):
    """An angular velocity or acceleration of a body: that of its rim over the radius."""

    noun: VectorName
    of: str

    @property
    def uses(self) -> str:
        """Return the kind of motion of the rim that is needed: acceleration ``a``, velocity ``v`` or arc ``s``."""
        return self.of

    def write(self, target: Target, known: KnownMotion) -> Symbol:
        """Write the quantity as that of the rim over the radius, such as ω = v/R."""
        body = target.subject
        formula = ratio(modulus(known.rim(self.of, body).expression(), known.book), known.radius(body).expression())
        what = f"the magnitude of the {self.noun.noun} of {known.setting.display_name(body)}"
        return write_answer(known, formula, self.noun, known.setting.subscript_of(body), what)


@dataclass(frozen=True, slots=True)
class AngleGoal(AngularGoal):
    """The angle of rotation of a body: the arc of its rim over the radius."""

    def write(self, target: Target, known: KnownMotion) -> Symbol:
        """Write the arcs in opposite senses, if there are several, then the angle."""
        known.rim(self.of, target.subject)
        known.write_arcs(target.subject)
        return AngularGoal.write(self, target, known)


@dataclass(frozen=True, slots=True)
class InertiaTimes(AboutAxis):
    """The moment of inertia of a body, its angular momentum I ω, or the net torque I α."""

    noun: VectorName
    of: str  # empty for the moment of inertia alone

    @property
    def uses(self) -> str:
        """Return the kind of motion of the rim that is needed: acceleration ``a``, velocity ``v`` or arc ``s``."""
        return self.of

    def write(self, target: Target, known: KnownMotion) -> Symbol:
        """Write the quantity as c m R times that of the rim, such as L = I ω = c m R v with I = c m R²."""
        body = target.subject
        coefficient = known.rim_inertia(body) * known.radius(body)
        rim = known.rim(self.of, body) if self.of else known.radius(body)
        other = modulus(rim.expression(), known.book)
        size = "magnitude of the " if self.of else ""
        about = " about its centre of mass" if self.of == "v" else ""
        what = f"the {size}{self.noun.noun} of {known.setting.display_name(body)}{about}"
        return write_answer(
            known, multiply_factors(coefficient.expression(), other), self.noun, known.setting.subscript_of(body), what
        )


class KineticShare(Goal):
    """A part of the kinetic energy of a body: half an effective mass times the square of a speed."""

    noun: ClassVar[VectorName]

    @property
    def uses(self) -> str:
        """Return ``v``: the energy is derived from a velocity."""
        return "v"

    @abstractmethod
    def energy(self, body: str, known: KnownMotion) -> Expression:
        """Return this part of the kinetic energy of a body, in J."""

    def write(self, target: Target, known: KnownMotion) -> Symbol:
        """Write the energy as one formula."""
        body = target.subject
        what = f"{self.reason_clause(body, known)}the {self.noun.noun} of {known.setting.display_name(body)}"
        return write_answer(known, self.energy(body, known), self.noun, known.setting.subscript_of(body), what)

    def reason_clause(self, body: str, known: KnownMotion) -> str:
        """Return a clause with the reason for the energy's formula, for the answer's sentence; by default ""."""
        del body, known
        return ""


class EnergyOfRim(KineticShare, AboutAxis):
    """The rotational energy of a body, ½ I ω², as ½ (I/R²) v² with the speed v of its rim."""

    noun = VectorName.for_quantity("rotational kinetic energy", "energy of rotation")

    def reason_clause(self, body: str, known: KnownMotion) -> str:
        """Return a clause that relates the rim's speed to the angular velocity."""
        rim = known.rim("v", body).expression()
        along = -rim if rim.negative else rim  # in the sense in which it rolls
        return f"as its radius times its angular velocity is ${along.latex()}$, "

    def energy(self, body: str, known: KnownMotion) -> Expression:
        """Return ½ (I/R²) v², J."""
        half = known.rim_inertia(body).scale(0.5).expression()
        return multiply_factors(half, squared(known.rim("v", body).expression()))


class EnergyOfCenter(KineticShare):
    """The translational energy of a body, ½ m v², with the speed v of its centre of mass."""

    noun = VectorName.for_quantity("translational kinetic energy", "energy of translation")

    def energy(self, body: str, known: KnownMotion) -> Expression:
        """Return ½ m v², J."""
        speed = magnitude(known.vector("v", body), known, VELOCITIES, body)
        return multiply_factors(known.mass(body).scale(0.5).expression(), squared(speed))


def squared(formula: Expression) -> Expression:
    """Return the square of a formula; the square of a root is its radicand, without signs and bars."""
    if isinstance(formula, Root):
        return formula.inside
    if isinstance(formula, Absolute):
        formula = formula.inside
    return Power(-formula if formula.negative else formula, 2)


ANGULAR_VELOCITIES = VectorName.for_quantity("angular velocity")
ANGULAR_ACCELERATIONS = VectorName.for_quantity("angular acceleration")
GOALS.add("angular velocity", AngularGoal(ANGULAR_VELOCITIES, "v"))
GOALS.add("angular acceleration", AngularGoal(ANGULAR_ACCELERATIONS, "a"))
GOALS.add("angle rolled", AngleGoal(VectorName.for_quantity("angle rolled", "net angle of rotation"), "s"))
GOALS.add("moment of inertia", InertiaTimes(VectorName.for_quantity("moment of inertia"), ""))
GOALS.add("angular momentum", InertiaTimes(VectorName.for_quantity("angular momentum"), "v"))
GOALS.add("torque", InertiaTimes(VectorName.for_quantity("torque"), "a"))
GOALS.add("rotational kinetic energy", EnergyOfRim())
GOALS.add("translational kinetic energy", EnergyOfCenter())


@dataclass(frozen=True, slots=True)
class DistanceGoal(Goal):
    """The distance between two bodies."""

    @property
    def uses(self) -> str:
        """Return ``s``: the distance is derived from displacements."""
        return "s"

    def bodies(self, target: Target) -> Sequence[str]:
        """Return the two bodies of the subject."""
        return members(target.subject)

    def write(self, target: Target, known: KnownMotion) -> Symbol:
        """Write the initial separation and the displacements since, then the distance."""
        one, other = members(target.subject)
        separation, a, b = known.initial_separation(one, other), known.vector("s", one), known.vector("s", other)
        parts: Components = (separation[0] + b[0] - a[0], separation[1] + b[1] - a[1], separation[2] + b[2] - a[2])
        noun = VectorName.for_quantity("distance", "position")
        formula = magnitude(parts, known, noun, other, relative_to=known.setting.display_name(one))
        return write_answer(known, formula, noun, r"\text{rel}", "so the distance is")


GOALS.add("distance", DistanceGoal())


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
