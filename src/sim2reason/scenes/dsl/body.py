"""Bodies: frozen values with parameters, nouns, a series of letters and a look in drawings."""

from collections.abc import Mapping
from dataclasses import dataclass
from math import hypot, sqrt
from typing import Any, ClassVar, Literal, TypeVar

from sim2reason.base.registry import Registry
from sim2reason.scenes.dsl.model import Model, field_types
from sim2reason.scenes.dsl.template import Word, slots
from sim2reason.scenes.dsl.vectors import Vector

SmallKind = Literal["ball", "sphere", "block", "slab", "cart", "puck", "rocket", "star", "planet"]
LineKind = Literal["string", "spring", "rod"]
THIN = 0.06  # the wall of what is thin, as it is drawn, as a part of its radius


@dataclass(frozen=True, slots=True)
class Small:
    """Something whose size does not matter; `mark` stands inside it, such as the sign of a charge."""

    kind: SmallKind
    mark: str = ""


@dataclass(frozen=True, slots=True)
class Spherical:
    """A sphere; a wall thickness makes it hollow, a hole has its centre at z = `offset`."""

    radius: float
    wall: float = 0.0
    hole: float = 0.0
    offset: float = 0.0

    def reach(self, way: Vector) -> float:
        """Return how far it extends along a unit vector, m."""
        del way
        return self.radius


@dataclass(frozen=True, slots=True)
class Axial:
    """A cylinder about z, or a prism if `sides` is given; a hole is parallel to z, with its axis at x = `offset`.

    Without a height the shape is a ring or a disc, without a radius a rod. A `step` is the radius of a drum on the end.
    """

    radius: float
    height: float = 0.0
    wall: float = 0.0
    sides: int = 0  # 0: round
    hole: float = 0.0
    offset: float = 0.0
    step: float = 0.0

    def reach(self, way: Vector) -> float:
        """Return how far it, or the cylinder about its edges, extends along a unit vector, m."""
        return self.radius * hypot(way[0], way[1]) + 0.5 * self.height * abs(way[2])


@dataclass(frozen=True, slots=True)
class Capped:
    """A part of a ball cut off at z = 0, with its pole at z = `height`; a wall thickness makes it a bowl."""

    radius: float
    height: float
    wall: float = 0.0

    def reach(self, way: Vector) -> float:
        """Return how far it extends along a unit vector from the centre of its flat face, m."""
        center = self.height - self.radius  # of the sphere, along z
        if center + self.radius * way[2] >= 0.0:
            return center * way[2] + self.radius
        return sqrt(max(0.0, self.height * (2.0 * self.radius - self.height))) * hypot(way[0], way[1])


@dataclass(frozen=True, slots=True)
class Rectangular:
    """A bar with its edges along its own axes."""

    x: float
    y: float
    z: float

    def reach(self, way: Vector) -> float:
        """Return how far it extends along a unit vector: to its farthest corner, m."""
        return 0.5 * (self.x * abs(way[0]) + self.y * abs(way[1]) + self.z * abs(way[2]))


@dataclass(frozen=True, slots=True)
class Silhouette:
    """A closed outline in the plane of its own x and z axes."""

    points: tuple[tuple[float, float], ...]


@dataclass(frozen=True, slots=True)
class FixedPlane:
    """A plane fixed in the room, at so many degrees; it is as long as what lies on it needs."""

    angle: float


@dataclass(frozen=True, slots=True)
class MovingSlope:
    """A wedge or prism; its faces are those on which something lies."""


@dataclass(frozen=True, slots=True)
class BigBox:
    """A box on the floor that is large enough to carry others on its top and at its sides."""


@dataclass(frozen=True, slots=True)
class PulleyWheel:
    """A pulley; a fixed one is held by a bracket, one with mass is filled."""

    fixed: bool
    solid: bool


@dataclass(frozen=True, slots=True)
class Tabletop:
    """A table seen from above, on which bodies move; `tilt` in degrees."""

    tilt: float = 0.0


@dataclass(frozen=True, slots=True)
class Slender:
    """Something light between two points, drawn where the mechanism has a line or an arm."""

    kind: LineKind


@dataclass(frozen=True, slots=True)
class Globe:
    """A planet so large that only its surface is seen, below what stands on it."""


@dataclass(frozen=True, slots=True)
class Unseen:
    """Nothing to be drawn at a place of its own: the region of a field, a way to start."""


BodyLook = (
    Small
    | Spherical
    | Axial
    | Capped
    | Rectangular
    | Silhouette
    | FixedPlane
    | MovingSlope
    | BigBox
    | PulleyWheel
    | Tabletop
    | Slender
    | Globe
    | Unseen
)


Matter = Literal["solid", "planet"]


class Body(Model):
    """The base of all bodies. A subclass declares its numbers as fields and its words as class data.

    `lone` introduces the only one of its series, `again` one more that has no letter either, by default as *another*,
    `named` one that has a letter, `listed` one inside a list that begins with the plural noun, `alike` all of such a
    list at once, after their letters, where their numbers agree. All ways to introduce a body say the same numbers;
    what they leave out, the entity's lines must say.
    """

    nouns: ClassVar[tuple[str, ...]] = ()
    letters: ClassVar[str] = "ABCDEFGHIJKLMN"  # "": never lettered, spoken of only beside its introduction
    lone: ClassVar[tuple[str, ...]] = ()
    again: ClassVar[tuple[str, ...]] = ()
    named: ClassVar[tuple[str, ...]] = ()
    listed: ClassVar[str] = ""
    alike: ClassVar[str] = ""
    words: ClassVar[dict[str, Word]] = {}
    matter: ClassVar[Matter] = "solid"  # of which it is, which says what densities are plausible
    symbols: ClassVar[dict[str, str]] = {}  # where a number's symbol is not that of its measure

    @property
    def look(self) -> BodyLook | None:
        """Return how a drawing shows it; None where its class declares nothing, and a drawing says so."""
        return None

    def suits(self, noun: str, bodies: Mapping[str, "Body"]) -> bool:
        """Return whether one of its nouns is apt for it among all `bodies` of a scene, by address; by default True."""
        del noun, bodies
        return True

    @property
    def density(self) -> float | None:
        """Its mean density, kg/m³; None where the text does not say how large it is."""
        return None

    @classmethod
    def __pydantic_init_subclass__(cls, **_: Any) -> None:
        """Refuse a body whose words and numbers do not fit; TypeError says what is amiss."""
        if not cls.nouns:
            return
        introductions = [*cls.lone, *cls.again, *cls.named, *filter(None, (cls.listed, cls.alike))]
        if len(cls.lone) < 2 or (cls.letters and len(cls.named) < 2):
            raise TypeError(f"{cls.__name__}: a body needs at least two ways to be introduced")
        said = {template: cls.says_in(template) for template in introductions}
        if len({frozenset(numbers) for numbers in said.values()}) > 1:
            raise TypeError(f"{cls.__name__}: its introductions say different numbers: {said}")

    @classmethod
    def says_in(cls, template: str) -> set[str]:
        """The parameters that a template of this body tells, by number or by word; TypeError for an unknown name."""
        told: set[str] = set()
        for slot in slots(template):
            if slot.kind == "text" or slot.path in ("letter", "noun"):
                continue
            if slot.path in cls.words:
                word = cls.words[slot.path]
                inner = [*word.special.values(), word.otherwise]
                told |= set[str]().union(*(cls.says_in(text) for text in inner))
                told |= {word.parameter} if word.otherwise and cls.says_in(word.otherwise) else set()
            elif slot.path in field_types(cls):
                told.add(slot.path)
            else:
                problem = f"names {slot.path!r}, which is neither a parameter nor a word"
                raise TypeError(f"{cls.__name__}: {template!r} {problem}")
        return told

    @classmethod
    def introduced_words(cls) -> tuple[Word, ...]:
        """Return the words that every introduction uses: what they can say specially need not be said again."""
        return tuple(
            word
            for name, word in cls.words.items()
            if all(f"{{{name}}}" in template for template in (*cls.lone, *cls.named))
        )

    def told_by_word(self, parameter: str) -> bool:
        """Return whether this body's introduction tells a number by a special word, as smooth tells µ = 0."""
        value = getattr(self, parameter)
        return any(word.parameter == parameter and value in word.special for word in self.introduced_words())


B = TypeVar("B", bound=Body)
BODIES: Registry[type[Body]] = Registry("bodies", package="sim2reason.scenes.bodies")


def body(cls: type[B]) -> type[B]:
    """Enter a body class under its name."""
    return BODIES.add(cls.__name__, cls)
