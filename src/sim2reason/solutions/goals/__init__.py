"""Quantities of questions in terms of accelerations, velocities, displacements and forces; one a file."""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from typing import Protocol, Self

from sim2reason.base.registry import Registry
from sim2reason.questions import Target
from sim2reason.scenes.dsl.mechanism import X, Y, Z
from sim2reason.scenes.dsl.vectors import Vector
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol, added
from sim2reason.solutions.algebra.functions import Absolute, Power, Root
from sim2reason.solutions.algebra.polynomials import Polynomial, total
from sim2reason.solutions.goals.struck import Struck
from sim2reason.solutions.laws.either_way import needs_modulus
from sim2reason.solutions.setting import Setting, capital, joined
from sim2reason.solutions.writing.steps import Book, UnsolvedError
from sim2reason.solutions.writing.unit_latex import LETTERS, unit_of_quantity

Components = tuple[Polynomial, Polynomial, Polynomial]
AXES = ("x", "y", "z")


class Stretch(ABC):
    """A part of a motion; by default a path is all that it has."""

    __slots__ = ()

    @property
    def time(self) -> Symbol:
        """Return how long the part takes, in s."""
        raise UnsolvedError("no time in which no force changes")

    def force(self, kind: str, name: str) -> Polynomial:
        """Return a tension, or the friction on a body that slides, if it is constant: zero where there is none."""
        raise UnsolvedError(f"no {kind} of {name} that is constant")

    def moved(self, body: str, line: str) -> Polynomial:
        """Return how far a body moves, in m, along a line that is tied to it, away from where that is tied."""
        raise UnsolvedError(f"no way of {body} along {line}")

    def slipped(self, body: str) -> Polynomial:
        """Return how far a body slips on its face, in m."""
        raise UnsolvedError(f"no slip of {body}")

    def drawn(self, line: str) -> Polynomial:
        """Return by how much a line grows shorter, in m."""
        raise UnsolvedError(f"no change of {line}")

    @abstractmethod
    def path(self, body: str) -> Expression:
        """Return how far a body travels along its line, to and fro, in m."""

    def paths(self, body: str) -> Sequence[Expression]:
        """Return the distances between successive turning points in this part."""
        return (self.path(body),)


class Known(Protocol):
    """A strategy's knowledge of the motion at the moment in question; its methods write the steps that lead there."""

    @property
    def setting(self) -> Setting:
        """The scene and the query."""
        ...

    @property
    def book(self) -> Book:
        """Return where it is written."""
        ...

    def vector(self, kind: str, body: str) -> Components:
        """The acceleration ``a``, velocity ``v`` (``u`` at the start) or displacement ``s`` of a body, by component."""
        ...

    def apart(self, one: str, other: str) -> Components:
        """From the centre of one body to that of another, at the start."""
        ...

    def axes(self, body: str) -> tuple[str, ...]:
        """Return the text's names of directions for a body: x, y, z unless it has axes of its own."""
        ...

    def component(self, kind: str, body: str, way: Vector) -> Polynomial:
        """The component of one of these along a direction of the room, or along the line of the body's own motion."""
        ...

    def lone(self, kind: str, body: str) -> Polynomial | None:
        """Return one of these along the only line on which a body moves; None if it has several."""
        ...

    def rim(self, kind: str, body: str) -> Polynomial:
        """The acceleration, speed or path of the rim of a body that turns about its own axis; zero if it does not."""
        ...

    def radius(self, body: str) -> Polynomial:
        """Return the radius of that rim."""
        ...

    def rim_inertia(self, body: str) -> Polynomial:
        """Return the moment of inertia over the square of that radius."""
        ...

    def tell_arcs(self, body: str) -> None:
        """Write through which arcs that rim turns one after the other, if there are several."""
        ...

    def force(self, kind: str, name: str) -> Symbol:
        """Return the tension ``T`` of a line, or normal force ``N`` or friction ``f`` on a body."""
        ...

    def mass(self, body: str) -> Polynomial:
        """Return the mass of a body."""
        ...

    def spring(self, what: str, line: str) -> Polynomial:
        """Return a number of a spring: its ``stiffness``, ``damping``, or at the start its ``length`` or ``strain``."""
        ...

    def growth(self, kind: str, line: str) -> Polynomial:
        """Return by how much a line has grown, in m, for the kind ``s``, or how fast it grows, in m/s, for ``v``."""
        ...

    @property
    def stretches(self) -> Sequence[Stretch]:
        """The parts of the motion, in order."""
        ...

    def work(self, line: str, body: str) -> Symbol | None:
        """Return the work, in J, of a varying tension on a body; None if the tension is constant in each part."""
        ...

    def impulse(self, line: str) -> Symbol | None:
        """Return the impulse, in N s, of a varying tension; None if the tension is constant in each part."""
        ...

    @property
    def impacts(self) -> Sequence[Struck]:
        """The collisions that the question is about, in order."""
        ...

    @property
    def speeds(self) -> AbstractSet[str]:
        """The given names that are speeds or distances of bodies."""
        ...

    @property
    def gravity(self) -> Polynomial:
        """The acceleration of free fall."""
        ...


class Goal(ABC):
    """A quantity, and the way in which it follows from the knowledge of a strategy."""

    @property
    def summary(self) -> str:
        """Return the first line of the docstring of its class, with which lists describe it."""
        return (type(self).__doc__ or "").partition("\n")[0]

    @property
    @abstractmethod
    def uses(self) -> str:
        """Return what it needs: accelerations ``a``, velocities ``v``, displacements ``s``; empty for nothing."""

    @property
    def turns(self) -> bool:
        """Return whether it depends on the rotation of a body about its own axis; by default it does not."""
        return False

    @property
    def throughout(self) -> bool:
        """Return whether it depends on forces all the while; by default it does on those at the end alone."""
        return False

    def bodies(self, target: Target) -> Sequence[str]:
        """Return the bodies whose motion it needs; by default its subject."""
        return (target.subject,)

    def lines(self, target: Target) -> Sequence[str]:
        """Return the lines whose length it needs; by default none."""
        del target
        return ()

    def force(self, target: Target, setting: Setting) -> str:
        """Return the force that it is, such as ``T2``; by default none."""
        del target, setting
        return ""

    @abstractmethod
    def write(self, target: Target, known: Known) -> Symbol:
        """Write the way to it; the symbol has the answer's value, in SI units."""


GOALS: Registry[Goal] = Registry("solutions.goals")


def single(parts: Components, known: Known) -> Symbol | None:
    """Return the symbol of which all components are multiples, by a unit vector; None if there are several."""
    names = {name for part in parts for name in part.names() if name in known.book.values}
    unknown = [name for name in sorted(names) if not known.setting.is_given(name) or name in known.speeds]
    if len(unknown) != 1:
        return None
    size = total(part.coefficient(unknown[0]) * part.coefficient(unknown[0]) for part in parts)
    rest = any(part.without(unknown) for part in parts)
    return Symbol(unknown[0]) if size.number is not None and abs(size.number - 1.0) < 1e-9 and not rest else None


def modulus(held: Expression, book: Book, *, of_either_sign: bool = False) -> Expression:
    """Return the modulus of a formula: between bars where its value is negative.

    With `of_either_sign` a formula in symbols is between bars whatever its value is. What hangs on an unknown changes
    its sign instead, so that it can be solved for that.
    """
    positive = book.value(held) >= 0.0
    if isinstance(held, Root | Absolute):
        return held
    if not book.hidden.isdisjoint(held.symbols()):
        book.sign_chosen = 1 if positive and book.sign_chosen >= 0 else -1
        return held if positive else -held
    either = book.in_symbols and of_either_sign
    if positive and not either:
        return held
    return (Absolute(-held) if either else -held) if held.negative else Absolute(held)


def _along(way: Vector, part: Polynomial, known: Known) -> str:
    """Return the direction in which a component that has a name is positive; in symbols without its sense."""
    if known.book.in_symbols:
        return "vertically" if way == Z else "horizontally"
    ((x, y, z), (sign,)) = way, part.terms.values()
    return known.setting.towards((sign * x, sign * y, sign * z))


def magnitude(
    parts: Components, known: Known, noun: "VectorName", body: str, *, relative_to: str = "the ground"
) -> Expression:
    """Return the magnitude of a vector as a formula of its components, each of which gets a name.

    Components along the axes of the room are said to be `relative_to` something.
    """
    one = single(parts, known)
    if one is not None:
        return modulus(one, known.book, of_either_sign=needs_modulus(known.setting, known.book, one, body))
    axes = known.axes(body)
    kept = [(axis, way, part) for axis, way, part in zip(axes, (X, Y, Z), parts, strict=True) if part]
    kind = "components" if any(part.symbol is None for _, _, part in kept) else "meaning"  # it gives no name
    step, mark = known.book.open(kind), known.setting.mark(body)
    names, sentences = list[Symbol](), list[str]()
    for axis, way, part in kept:
        plain = part.symbol
        if plain is not None:
            names.append(plain)
            if axes == AXES:
                sentences.append(f"${plain.latex()}$ {_along(way, part, known)}")
            continue
        names.append(known.book.fresh(noun.base, f"{axis},{mark}" if mark else axis))
        where = known.setting.towards(way) if axes == AXES else f"along {axis}"
        sentences.append(f"{step.result(names[-1], part.factored(), noun.unit, law=True)} {where}")
    whose = f"{noun.said} of {known.setting.called(body)}"
    if (sentences and len(kept) > 1) or step.relations:
        said = f" relative to {relative_to}" if axes == AXES or relative_to != "the ground" else ""
        none = "; the other component is zero" if axes != AXES and len(kept) == 1 else ""
        step.say(f"The {whose}{said} has the component{'s' if sentences[1:] else ''} {joined(sentences)}{none}.")
    step.close()
    if len(names) == 1:
        return modulus(names[0], known.book)
    squares: Expression = ZERO
    for name in names:
        squares = added(squares, Power(name, 2))
    return Root(squares)


@dataclass(frozen=True, slots=True)
class VectorName:
    """The letter, the unit in LaTeX and the word of a vector."""

    base: str
    unit: str
    said: str

    @classmethod
    def of(cls, quantity: str, said: str = "") -> Self:
        """Return the name of a quantity or functional, which is its own word unless another is `said`."""
        return cls(LETTERS[quantity], unit_of_quantity(quantity), said or quantity)


def finish(known: Known, formula: Expression, noun: VectorName, mark: str, what: str) -> Symbol:
    """Return the last step: a name for the answer, unless it has one."""
    if isinstance(formula, Symbol):
        return formula
    step = known.book.open("answer")
    verb = "" if what.endswith((" is", "of magnitude")) else " is"
    told = step.result(known.book.fresh(noun.base, mark), formula, noun.unit, law=True)
    turned = known.book.sign_chosen < 0 and known.book.is_hidden(formula)
    step.say(f"{capital(what)}{verb} {told}{', supposing that this is positive' if turned else ''}.")
    step.close()
    return Symbol(known.book.last)
