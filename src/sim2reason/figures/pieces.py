"""Parts of a drawing that are moved as a whole to lay it out, one class for each look of a body.

`PIECES` maps the look of a body to its piece, so that an entity made of bodies with looks needs no drawing code.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from math import isclose
from typing import TypeVar

from sim2reason.figures.paths import PathKnot, Paths
from sim2reason.figures.plane import RIGHT, Polygon, cross, dot, unit_vector
from sim2reason.figures.shapes import Sketch
from sim2reason.scenes.dsl.body import BodyLook
from sim2reason.scenes.dsl.mechanism import SurfaceContact
from sim2reason.scenes.dsl.model import Parameter
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.text.prose.description import Description

VALUE_TOLERANCE = 1e-9  # SI units; numbers closer than this are equal
MAX_DIGITS = 5  # significant digits of a number in a drawing, at most


@dataclass(frozen=True, slots=True)
class Sizes:
    """The sizes of bodies, in units of the drawing."""

    width: float = 1.0  # of a block
    height: float = 0.9
    radius: float = 0.45  # of a pulley
    small: float = 0.24  # of a small pulley at a wedge's edge
    link: float = 0.55  # of the string between neighbouring blocks


@dataclass(frozen=True, slots=True)
class Bend:
    """The bend of a string at a pulley: the directions in which its two segments leave the pulley, in order."""

    directions: tuple[complex, complex]
    side: float  # where two parallel strands meet the rim: the first one at the left (−1) or right (1)

    def touches(self, way: complex) -> complex:
        """Return the unit vector from the centre to where the segment that leaves along `way` touches the rim."""
        first = abs(way - self.directions[0]) <= abs(way - self.directions[1])
        other = self.directions[1] if first else self.directions[0]
        if abs(cross(way, other)) > 1e-6:
            return -unit_vector(other - dot(way, other) * way)
        across = way * 1j if (way * 1j).real > 0.0 or (way * 1j).imag > 1.0 - 1e-9 else way * -1j
        return across if dot(way, other) < 0.0 else across * self.side

    def rim(self, *, second: bool = False) -> complex:
        """Return the unit vector from the centre to the point where the first or second segment touches the rim."""
        first = self.touches(self.directions[0])
        if not second:
            return first
        parallel = abs(cross(*self.directions)) <= 1e-6 and dot(*self.directions) > 0.0
        return -first if parallel else self.touches(self.directions[1])

    @property
    def support_direction(self) -> complex:
        """Return the direction in which the axle is supported."""
        push = -(self.directions[0] + self.directions[1])
        return unit_vector(push) if abs(push) > 1e-6 else self.rim() * -1.0


@dataclass(frozen=True)
class DrawingPlan:
    """The data that all pieces of a candidate layout share: the scene, its text, and how strings bend."""

    scene: Scene
    paths: Paths
    description: Description
    sizes: Sizes
    numbers: bool
    bends: Mapping[str, Bend] = field(default_factory=dict[str, Bend])  # by what the string goes round
    ends: Mapping[str, tuple[complex, ...]] = field(
        default_factory=dict[str, tuple[complex, ...]]
    )  # by what it is tied to
    mirrored: frozenset[str] = frozenset()
    wider: Mapping[str, float] = field(default_factory=dict[str, float])  # by pulley piece, times the usual radius

    def name(self, address: str) -> str:
        """Return the label of a body: its letter, or its noun if it has none."""
        body = self.scene.bodies[address]
        return self.description.names.letters.get(address, "") or self.description.names.noun(body)

    def mass(self, address: str) -> str:
        """Return the mass of a body as in the text, if numbers are shown and the text states it."""
        parameter = next((p for p in self.scene.parameters if p.path == f"{address}.mass"), None)
        return self.number_text(parameter) if self.numbers and parameter is not None and parameter.value else ""

    def number_text(self, parameter: Parameter) -> str:
        """Return a number as in the text: an unknown by its symbol, others with at most five digits.

        Results of unknowns have more digits, which no drawing needs.
        """
        symbol = self.description.symbols.get(parameter.path, parameter.measure.symbol)
        shown = parameter.value and float(f"{parameter.value:.{MAX_DIGITS}g}")
        return self.description.voice(replace(parameter, value=shown), symbol)

    def stated(self, owner: str, unit_vector: str, value: float) -> str:
        """Return the text of an entity's number with this unit and value; empty if the text states no such number."""
        parameters = self._numbers(owner, unit_vector)
        return next(
            (
                self.number_text(p)
                for p in parameters
                if isclose(p.value or 0.0, value, rel_tol=1e-6, abs_tol=VALUE_TOLERANCE)
            ),
            "",
        )

    def labelled_number(self, letter: str, said: str) -> str:
        """Return a number with its letter, *F = 3 N*; a symbol alone remains unchanged."""
        return said if said.startswith("$") else f"{letter} = {said}"

    def friction_text(self, owner: str, face: SurfaceContact, letter: str = "µ") -> str:
        """Return a face's stated friction coefficient with its letter, or both coefficients if they differ."""
        kinetic = self.stated(owner, "", face.friction) if face.friction else ""
        if not kinetic or face.static_ratio == 1.0:
            return self.labelled_number(letter, kinetic) if kinetic else ""
        static = self.stated(owner, "", face.static_friction)
        both = zip((r"$\mu_s$", r"$\mu_k$"), (static, kinetic), strict=True)
        return ", ".join(self.labelled_number(symbol, text) for symbol, text in both if text)

    def leaves_open(self, owner: str, unit_vector: str) -> bool:
        """Return whether the text leaves a number unknown, so that the drawing must not show it to scale."""
        return any(self.number_text(p).startswith("$") for p in self._numbers(owner, unit_vector))

    def _numbers(self, owner: str, unit_vector: str) -> Iterator[Parameter]:
        for parameter in self.scene.parameters:
            inside = parameter.path.startswith(f"{owner}.") and not parameter.hidden
            if inside and parameter.value is not None and parameter.measure.unit == unit_vector:
                yield parameter

    def caption(self, address: str) -> str:
        """Return the name of a body, with its mass if numbers are shown: *W (8.1 kg)*."""
        mass = self.mass(address)
        return f"{self.name(address)} ({mass})" if mass else self.name(address)


class Piece(ABC):
    """A rigid part of a drawing, in coordinates relative to its own origin."""

    mirrors = False  # whether it may be drawn mirrored, since no text says which way it faces

    def __init__(self, name: str, plan: DrawingPlan) -> None:
        """Store the plan, and the piece's name: the address of its main body, or of a fixed point without a body."""
        self.name, self.plan = name, plan

    @abstractmethod
    def anchor(self, knot: PathKnot, way: complex, *, second: bool) -> complex:
        """Return where a string segment that leaves along `way` begins: before or (`second`) after a pulley."""

    @abstractmethod
    def hulls(self) -> list[Polygon]:
        """Return convex polygons that cover the piece, for the detection of overlaps with others."""

    @abstractmethod
    def sketch(self) -> Sketch:
        """Return the shapes of the piece and its labels."""

    def lead(self, knot: PathKnot, way: complex) -> float:
        """Return the length of the part of a string segment that lies over this piece itself, in units."""
        del knot, way
        return 0.0

    @property
    def level(self) -> tuple[str, float] | None:
        """Return the kind and height of the piece's floor or ceiling, which pieces of one kind share if possible."""
        return None

    def edge(self, way: complex) -> complex | None:
        """Return the corner where a face ends in a direction, on which a pulley can be mounted."""
        del way
        return None


def positions_around(center: complex, near: float, text_width: float, *, start: complex = RIGHT) -> tuple[complex, ...]:
    """Return candidate positions of a label around a circle, the first one in the direction `start`."""
    turns = (0, 1, -1, 2, -2, 3, -3, 4, -4, 5, -5, 6, -6, 7, -7, 8)
    ways = [start * complex(0.92388, 0.38268) ** turn for turn in turns]
    return tuple(
        center + complex(direction.real * (far + 0.5 * text_width), direction.imag * (far + 0.24))
        for far in (near, near + 0.3)
        for direction in ways
    )


Factory = Callable[[str, DrawingPlan], Piece]
PIECES: dict[type[BodyLook], Factory] = {}
M = TypeVar("M")


def draws(*looks: type[BodyLook]) -> Callable[[M], M]:
    """Register the decorated piece for bodies with looks of these classes."""

    def enter(factory: M) -> M:
        for look in looks:
            PIECES[look] = factory  # type: ignore[assignment]
        return factory

    return enter
