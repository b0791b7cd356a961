"""Quantities of questions in terms of accelerations, velocities, displacements and forces, one family a module."""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from typing import Protocol, Self

from sim2reason.base.registry import Registry
from sim2reason.questions import Target
from sim2reason.scenes.dsl.mechanism import X, Y, Z
from sim2reason.scenes.dsl.vectors import Vector
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol, sum_terms
from sim2reason.solutions.algebra.functions import Absolute, Power, Root
from sim2reason.solutions.algebra.polynomials import Polynomial, total
from sim2reason.solutions.closed_forms.symbolic_answers import needs_modulus
from sim2reason.solutions.setting import ProblemContext, capitalized, join_words
from sim2reason.solutions.writing.notation import QUANTITY_SYMBOLS, unit_of_quantity
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError


class CollisionTerm(Protocol):
    """One collision of a motion, with the reasons and formulas for its energy loss and impulse."""

    @property
    def bodies(self) -> tuple[str, ...]:
        """Return the names of the colliding bodies."""
        ...

    @property
    def collision_name(self) -> str:
        """Return the name of the collision, such as *the first collision of A and B*."""
        ...

    @property
    def energy_loss_lead(self) -> str:
        """Return the first words of a sentence that gives the energy loss: the reason why kinetic energy is lost."""
        ...

    @property
    def impulse_lead(self) -> str:
        """Return the first words of a sentence that gives the impulse: the laws from which the impulse follows."""
        ...

    @property
    def energy_loss(self) -> Expression:
        """Return the kinetic energy lost, J."""
        ...

    @property
    def impulse_magnitude(self) -> Expression:
        """Return the magnitude of the impulse, N s."""
        ...


Components = tuple[Polynomial, Polynomial, Polynomial]
AXES = ("x", "y", "z")


class MotionPart(ABC):
    """A part of a motion; by default only the distances travelled in it are known."""

    __slots__ = ()

    @property
    def time(self) -> Symbol:
        """Return the duration of the part, s."""
        raise UnsolvedError("no time in which no force changes")

    def force(self, kind: str, name: str) -> Polynomial:
        """Return a tension, or the kinetic friction on a body, if it is constant; zero if it does not act."""
        raise UnsolvedError(f"no {kind} of {name} that is constant")

    def displacement_along_line(self, body: str, line: str) -> Polynomial:
        """Return the displacement of a body, m, along a line attached to it, away from the attachment."""
        raise UnsolvedError(f"no way of {body} along {line}")

    def slipped(self, body: str) -> Polynomial:
        """Return the displacement of a body relative to the surface under it, m."""
        raise UnsolvedError(f"no slip of {body}")

    def drawn_length(self, line: str) -> Polynomial:
        """Return the decrease of a line's length, m."""
        raise UnsolvedError(f"no change of {line}")

    @abstractmethod
    def path(self, body: str) -> Expression:
        """Return the distance that a body travels along its line, with all reversals, m."""

    def paths(self, body: str) -> Sequence[Expression]:
        """Return the distances between successive turning points, m."""
        return (self.path(body),)


class KnownMotion(Protocol):
    """The motion at the moment of a question, as a strategy knows it; methods write the steps to their results."""

    @property
    def setting(self) -> ProblemContext:
        """Return the scene and the question."""
        ...

    @property
    def book(self) -> SolutionBuilder:
        """Return the solution that is being written."""
        ...

    def vector(self, kind: str, body: str) -> Components:
        """Return components of a body's acceleration ``a``, velocity ``v`` (initial ``u``) or displacement ``s``."""
        ...

    def initial_separation(self, one: str, other: str) -> Components:
        """Return the initial vector from the centre of one body to that of another."""
        ...

    def axes(self, body: str) -> tuple[str, ...]:
        """Return the names of a body's axes in the text: x, y, z unless it has axes of its own."""
        ...

    def component(self, kind: str, body: str, way: Vector) -> Polynomial:
        """Return a body's vector of the given kind as a component along a world direction, or along its own line."""
        ...

    def line_component(self, kind: str, body: str) -> Polynomial | None:
        """Return a vector as its signed component along the body's only line of motion; None for several lines."""
        ...

    def rim(self, kind: str, body: str) -> Polynomial:
        """Return acceleration, velocity or distance of a rotating body's rim, along the rim; zero for other bodies."""
        ...

    def radius(self, body: str) -> Polynomial:
        """Return the radius of a body's rim."""
        ...

    def rim_inertia(self, body: str) -> Polynomial:
        """Return a body's moment of inertia over the square of its rim's radius."""
        ...

    def write_arcs(self, body: str) -> None:
        """Write the successive arcs through which a body's rim turns, if there are several."""
        ...

    def force(self, kind: str, name: str) -> Symbol:
        """Return the tension ``T`` of a line, or the normal force ``N`` or friction ``f`` on a body."""
        ...

    def mass(self, body: str) -> Polynomial:
        """Return the mass of a body."""
        ...

    def spring(self, what: str, line: str) -> Polynomial:
        """Return a number of a spring: ``stiffness``, ``damping``, or the initial ``length`` or ``strain``."""
        ...

    def growth(self, kind: str, line: str) -> Polynomial:
        """Return the increase of a string's or spring's length, m, for the kind ``s``, or its rate, m/s, for ``v``."""
        ...

    @property
    def motion_parts(self) -> Sequence[MotionPart]:
        """Return the parts of the motion in order."""
        ...

    def work(self, line: str, body: str) -> Symbol | None:
        """Return the work, in J, of a varying tension on a body; None if the tension is constant in each part."""
        ...

    def impulse(self, line: str) -> Symbol | None:
        """Return the impulse, in N s, of a varying tension; None if the tension is constant in each part."""
        ...

    @property
    def impacts(self) -> Sequence[CollisionTerm]:
        """Return the collisions that the question refers to, in order."""
        ...

    @property
    def speeds(self) -> AbstractSet[str]:
        """Return the names of given numbers that are speeds or distances of bodies."""
        ...

    @property
    def gravity(self) -> Polynomial:
        """Return the gravitational acceleration."""
        ...


class Goal(ABC):
    """A quantity of a question, and its derivation from the motion."""

    @property
    def summary(self) -> str:
        """Return the first line of the class docstring as a description."""
        return (type(self).__doc__ or "").partition("\n")[0]

    @property
    @abstractmethod
    def uses(self) -> str:
        """Return letters of the vectors needed: ``a`` accelerations, ``v`` velocities, ``s`` displacements; or ""."""

    @property
    def turns(self) -> bool:
        """Return whether the quantity depends on rotation of a body about its own axis; by default False."""
        return False

    @property
    def throughout(self) -> bool:
        """Return whether the quantity depends on forces during the whole motion, not only at its end."""
        return False

    def bodies(self, target: Target) -> Sequence[str]:
        """Return the bodies whose motion the quantity depends on; by default its subject."""
        return (target.subject,)

    def lines(self, target: Target) -> Sequence[str]:
        """Return the strings and springs whose length the quantity depends on; by default none."""
        del target
        return ()

    def force(self, target: Target, setting: ProblemContext) -> str:
        """Return the name of the unknown force that determines the quantity, such as ``T2``; by default ""."""
        del target, setting
        return ""

    @abstractmethod
    def write(self, target: Target, known: KnownMotion) -> Symbol:
        """Write the derivation and return the symbol whose value is the answer, in SI units."""


GOALS: Registry[Goal] = Registry("solutions.goals")


def single_symbol(parts: Components, known: KnownMotion) -> Symbol | None:
    """Return the symbol of a vector that is this symbol times a unit vector; None for other vectors."""
    names = {name for part in parts for name in part.names() if name in known.book.values}
    unknown = [name for name in sorted(names) if not known.setting.is_given(name) or name in known.speeds]
    if len(unknown) != 1:
        return None
    size = total(part.coefficient(unknown[0]) * part.coefficient(unknown[0]) for part in parts)
    rest = any(part.terms_without(unknown) for part in parts)
    return Symbol(unknown[0]) if size.number is not None and abs(size.number - 1.0) < 1e-9 and not rest else None


def modulus(formula: Expression, book: SolutionBuilder, *, of_either_sign: bool = False) -> Expression:
    """Return the absolute value of a formula, with bars where its value is negative.

    With `of_either_sign`, a symbolic formula always stands between bars. A formula that depends on an unknown changes
    its sign instead, so that it can be solved for the unknown.
    """
    positive = book.value(formula) >= 0.0
    if isinstance(formula, Root | Absolute):
        return formula
    if not book.hidden.isdisjoint(formula.symbols()):
        book.sign_chosen = 1 if positive and book.sign_chosen >= 0 else -1
        return formula if positive else -formula
    either = book.in_symbols and of_either_sign
    if positive and not either:
        return formula
    return (Absolute(-formula) if either else -formula) if formula.negative else Absolute(formula)


def _along(direction: Vector, part: Polynomial, known: KnownMotion) -> str:
    """Return words for the direction in which a vector component is positive; in symbols, words for its line."""
    if known.book.in_symbols:
        return "vertically" if direction == Z else "horizontally"
    ((x, y, z), (sign,)) = direction, part.terms.values()
    return known.setting.direction_words((sign * x, sign * y, sign * z))


def magnitude(
    parts: Components, known: KnownMotion, noun: "VectorName", body: str, *, relative_to: str = "the ground"
) -> Expression:
    """Return the magnitude of a vector as a formula of its components, each of which gets a name.

    For components along world axes, the sentence names the frame `relative_to`.
    """
    one = single_symbol(parts, known)
    if one is not None:
        return modulus(one, known.book, of_either_sign=needs_modulus(known.setting, known.book, one, body))
    axes = known.axes(body)
    kept = [(axis, direction, part) for axis, direction, part in zip(axes, (X, Y, Z), parts, strict=True) if part]
    kind = "components" if any(part.symbol is None for _, _, part in kept) else "meaning"  # "meaning" defines no names
    step, mark = known.book.begin_step(kind), known.setting.subscript_of(body)
    names, sentences = list[Symbol](), list[str]()
    for axis, direction, part in kept:
        plain = part.symbol
        if plain is not None:
            names.append(plain)
            if axes == AXES:
                sentences.append(f"${plain.latex()}$ {_along(direction, part, known)}")
            continue
        names.append(known.book.fresh(noun.base, f"{axis},{mark}" if mark else axis))
        where = known.setting.direction_words(direction) if axes == AXES else f"along {axis}"
        sentences.append(f"{step.result(names[-1], part.factored(), noun.unit, law=True)} {where}")
    whose = f"{noun.noun} of {known.setting.display_name(body)}"
    if (sentences and len(kept) > 1) or step.relations:
        frame_phrase = f" relative to {relative_to}" if axes == AXES or relative_to != "the ground" else ""
        none = "; the other component is zero" if axes != AXES and len(kept) == 1 else ""
        step.add_text(
            f"The {whose}{frame_phrase} has the component{'s' if sentences[1:] else ''} {join_words(sentences)}{none}."
        )
    step.close()
    if len(names) == 1:
        return modulus(names[0], known.book)
    squares: Expression = ZERO
    for name in names:
        squares = sum_terms(squares, Power(name, 2))
    return Root(squares)


@dataclass(frozen=True, slots=True)
class VectorName:
    """The letter, the LaTeX unit and the noun of a quantity."""

    base: str
    unit: str
    noun: str

    @classmethod
    def for_quantity(cls, quantity: str, said: str = "") -> Self:
        """Return the name of a quantity or functional; its noun is the quantity itself unless `said` is given."""
        return cls(QUANTITY_SYMBOLS[quantity], unit_of_quantity(quantity), said or quantity)


def write_answer(known: KnownMotion, formula: Expression, noun: VectorName, mark: str, what: str) -> Symbol:
    """Write the last step, which names and computes the answer, and return its symbol; a symbol needs no step."""
    if isinstance(formula, Symbol):
        return formula
    step = known.book.begin_step("answer")
    verb = "" if what.endswith((" is", "of magnitude")) else " is"
    equation = step.result(known.book.fresh(noun.base, mark), formula, noun.unit, law=True)
    turned = known.book.sign_chosen < 0 and known.book.is_hidden(formula)
    step.add_text(f"{capitalized(what)}{verb} {equation}{', supposing that this is positive' if turned else ''}.")
    step.close()
    return Symbol(known.book.last)
