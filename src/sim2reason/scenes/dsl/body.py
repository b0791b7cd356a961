"""Bodies: immutable values with parameters, nouns, letters and a drawn shape."""

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
THIN_WALL_RATIO = 0.06  # fraction of the radius: drawn thickness of a thin wall


@dataclass(frozen=True, slots=True)
class Small:
    """The drawn shape of a small body; `mark` is a text inside it, such as the sign of a charge."""

    kind: SmallKind
    mark: str = ""


@dataclass(frozen=True, slots=True)
class Spherical:
    """The drawn shape of a sphere; a wall thickness makes it hollow, a hole has its centre at z = `offset`."""

    radius: float
    wall: float = 0.0
    hole: float = 0.0
    offset: float = 0.0

    def reach(self, way: Vector) -> float:
        """Return the extent along a unit vector, m."""
        del way
        return self.radius


@dataclass(frozen=True, slots=True)
class Axial:
    """The drawn shape of a cylinder about z, or a prism if `sides` is given; a hole has its axis at x = `offset`.

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
        """Return the extent along a unit vector, m; for a prism that of the cylinder about its edges."""
        return self.radius * hypot(way[0], way[1]) + 0.5 * self.height * abs(way[2])


@dataclass(frozen=True, slots=True)
class Capped:
    """The drawn shape of a spherical cap with its pole at z = `height`; a wall thickness makes it a bowl."""

    radius: float
    height: float
    wall: float = 0.0

    def reach(self, way: Vector) -> float:
        """Return the extent along a unit vector from the centre of the flat face, m."""
        center = self.height - self.radius  # of the sphere, along z
        if center + self.radius * way[2] >= 0.0:
            return center * way[2] + self.radius
        return sqrt(max(0.0, self.height * (2.0 * self.radius - self.height))) * hypot(way[0], way[1])


@dataclass(frozen=True, slots=True)
class Rectangular:
    """The drawn shape of a bar with its edges along its own axes."""

    x: float
    y: float
    z: float

    def reach(self, way: Vector) -> float:
        """Return the extent along a unit vector, to the farthest corner, m."""
        return 0.5 * (self.x * abs(way[0]) + self.y * abs(way[1]) + self.z * abs(way[2]))


@dataclass(frozen=True, slots=True)
class Silhouette:
    """The drawn shape of a closed outline in the plane of its own x and z axes."""

    points: tuple[tuple[float, float], ...]


@dataclass(frozen=True, slots=True)
class FixedPlane:
    """The drawn shape of a fixed plane at an angle in degrees, as long as the bodies on it require."""

    angle: float


@dataclass(frozen=True, slots=True)
class MovingSlope:
    """The drawn shape of a wedge or prism; its faces are those that carry bodies."""


@dataclass(frozen=True, slots=True)
class BigBox:
    """The drawn shape of a box on the floor, large enough for the bodies on its top and at its sides."""


@dataclass(frozen=True, slots=True)
class PulleyWheel:
    """The drawn shape of a pulley; a fixed one has a bracket, one with mass is filled."""

    fixed: bool
    solid: bool


@dataclass(frozen=True, slots=True)
class Tabletop:
    """The drawn shape of a table seen from above; `tilt` in degrees."""

    tilt: float = 0.0


@dataclass(frozen=True, slots=True)
class Slender:
    """The drawn shape of a light line or arm between two points of the mechanism."""

    kind: LineKind


@dataclass(frozen=True, slots=True)
class Globe:
    """The drawn shape of a large planet, of which only the surface is visible."""


@dataclass(frozen=True, slots=True)
class Unseen:
    """The drawn shape of a body that is not drawn: the region of a field, a kind of start."""


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
    """The base class of all bodies. A subclass declares its numbers as fields and its phrases as class data.

    `lone` introduces the only one of its series, `again` one more without a letter, by default as *another*, `named`
    one with a letter, by default as `lone` does with the letter after the noun, `listed` one inside a list that begins
    with the plural noun, `alike` all of such a list at once, after their letters, if their numbers agree. All
    introductions state the same numbers; the entity's lines must state the remaining ones.
    """

    nouns: ClassVar[tuple[str, ...]] = ()
    letters: ClassVar[str] = "ABCDEFGHIJKLMN"  # "": never lettered, mentioned only beside its introduction
    lone: ClassVar[tuple[str, ...]] = ()
    again: ClassVar[tuple[str, ...]] = ()
    named: ClassVar[tuple[str, ...]] = ()
    listed: ClassVar[str] = ""
    alike: ClassVar[str] = ""
    words: ClassVar[dict[str, Word]] = {}
    matter: ClassVar[Matter] = "solid"  # the material, which determines plausible densities
    symbols: ClassVar[dict[str, str]] = {}  # symbols of numbers that differ from those of their measures

    @property
    def look(self) -> BodyLook | None:
        """Return the drawn shape; None if the class declares none, which the drawing reports."""
        return None

    def suits(self, noun: str, bodies: Mapping[str, "Body"]) -> bool:
        """Return whether a noun is apt for the body among all `bodies` of a scene, by address; by default True."""
        del noun, bodies
        return True

    @property
    def density(self) -> float | None:
        """Return the mean density, kg/m³; None if the text does not state the size."""
        return None

    @classmethod
    def __pydantic_init_subclass__(cls, **_: Any) -> None:
        """Raise TypeError if the phrases of a subclass do not match its numbers."""
        if not cls.nouns:
            return
        if cls.letters and "lone" in vars(cls) and "named" not in vars(cls):
            cls.named = tuple(template.replace("{noun}", "{noun} {letter}", 1) for template in cls.lone)
        introductions = [*cls.lone, *cls.again, *cls.named, *filter(None, (cls.listed, cls.alike))]
        if len(cls.lone) < 2 or (cls.letters and len(cls.named) < 2):
            raise TypeError(f"{cls.__name__}: a body needs at least two ways to be introduced")
        numbers_by_template = {template: cls.stated_parameters(template) for template in introductions}
        if len({frozenset(numbers) for numbers in numbers_by_template.values()}) > 1:
            raise TypeError(f"{cls.__name__}: its introductions say different numbers: {numbers_by_template}")

    @classmethod
    def stated_parameters(cls, template: str) -> set[str]:
        """Return the parameters that a template states, by number or by word; raise TypeError for an unknown name."""
        parameters: set[str] = set()
        for slot in slots(template):
            if slot.kind == "text" or slot.path in ("letter", "noun"):
                continue
            if slot.path in cls.words:
                word = cls.words[slot.path]
                inner = [*word.special.values(), word.otherwise]
                parameters |= set[str]().union(*(cls.stated_parameters(text) for text in inner))
                parameters |= {word.parameter} if word.otherwise and cls.stated_parameters(word.otherwise) else set()
            elif slot.path in field_types(cls):
                parameters.add(slot.path)
            else:
                problem = f"names {slot.path!r}, which is neither a parameter nor a word"
                raise TypeError(f"{cls.__name__}: {template!r} {problem}")
        return parameters

    @classmethod
    def introduced_words(cls) -> tuple[Word, ...]:
        """Return the words, such as *smooth*, in every introduction; their special values need no other statement."""
        return tuple(
            word
            for name, word in cls.words.items()
            if all(f"{{{name}}}" in template for template in (*cls.lone, *cls.named))
        )

    def is_stated_by_word(self, parameter: str) -> bool:
        """Return whether the introduction states a number by a special word, such as smooth for µ = 0."""
        value = getattr(self, parameter)
        return any(word.parameter == parameter and value in word.special for word in self.introduced_words())


B = TypeVar("B", bound=Body)
BODIES: Registry[type[Body]] = Registry("bodies", package="sim2reason.scenes.bodies")


def body(cls: type[B]) -> type[B]:
    """Register a body class under its name."""
    return BODIES.add(cls.__name__, cls)
