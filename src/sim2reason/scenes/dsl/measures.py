"""Declarations about numbers: unit, symbol, wording and range of random values, and relations between fields.

One line declares a number; validation, sampling, prose, symbols and the schema read it:

    Mass = Annotated[float, Ge(1e-6), Measure("mass", "kg", "m"), Range(0.5, 10)]
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from decimal import Decimal
from functools import cache
from math import floor, isfinite, log10
from typing import Annotated, Any, NamedTuple, Protocol

import numpy as np
from annotated_types import Ge, Le, Lt

from sim2reason.scenes.dsl.units import parse_unit, to_coherent_unit


@dataclass(frozen=True, slots=True)
class Range:
    """The interval from which a number is drawn, both ends included.

    A field may narrow the range of its type by a further `Range`.

    Attributes:
        low: Least value, in the unit of the measure.
        high: Greatest value.

    Raises:
        ValueError: The interval is empty or infinite.

    Examples:
        >>> from typing import Annotated
        >>> from sim2reason.authoring import Mass, Range
        >>> Heavy = Annotated[Mass, Range(50.0, 100.0)]
        >>> Range(2.0, 1.0)
        Traceback (most recent call last):
        ValueError: not a range: 2.0 to 1.0
    """

    low: float
    high: float

    def __post_init__(self) -> None:
        """Check that the range is finite and not empty; ValueError otherwise."""
        if not (isfinite(self.low) and isfinite(self.high) and self.low <= self.high):
            raise ValueError(f"not a range: {self.low} to {self.high}")


@dataclass(frozen=True, slots=True)
class Count:
    """The range of the number of members of a randomly drawn variable-length part, both ends included.

    Attributes:
        low: Least number of members.
        high: Greatest number of members.
        alike: Whether all members are of one class.

    Examples:
        >>> from typing import Annotated
        >>> from sim2reason.authoring import Count
        >>> from sim2reason.scenes.bodies.blocks import Block
        >>> Blocks = Annotated[tuple[Block, ...], Count(1, 3)]
    """

    low: int
    high: int
    alike: bool = False


@dataclass(frozen=True, slots=True)
class Chance:
    """The probability of drawing an optional part if no recipe chooses; a part without this mark is never drawn.

    Attributes:
        likelihood: Probability, from 0 to 1.

    Raises:
        ValueError: The value is not a probability.

    Examples:
        >>> from typing import Annotated
        >>> from sim2reason.authoring import Chance, Friction
        >>> Rough = Annotated[Friction, Chance(0.2)]
    """

    likelihood: float

    def __post_init__(self) -> None:
        """Check that the value is a probability; ValueError otherwise."""
        if not 0.0 <= self.likelihood <= 1.0:
            raise ValueError(f"not a chance: {self.likelihood}")


@dataclass(frozen=True, slots=True)
class Usually:
    """A mark for an optional field that is always or never drawn unless a recipe chooses, without a random number.

    Attributes:
        present: Whether the field is drawn.

    Examples:
        >>> from sim2reason.authoring import StaticFriction, Usually
        >>> Usually(present=False) in StaticFriction.__metadata__
        True
    """

    present: bool


@dataclass(frozen=True, slots=True)
class Sized:
    """A mark for a variable-length part whose number of members follows from the fields before it.

    Attributes:
        by: Function that takes the values of those fields by name and returns the number.

    Examples:
        >>> from sim2reason.authoring import Sized
        >>> Sized(lambda fields: len(fields["gliders"]) - 1).by({"gliders": ["A", "B", "C"]})
        2
    """

    by: Callable[[Mapping[str, Any]], int]


@dataclass(frozen=True, slots=True)
class Member:
    """A mark for an index of a member of another field, which belongs to the same class or to the one that contains it.

    Attributes:
        field: Name of the field with the members.

    Examples:
        >>> from typing import Annotated
        >>> from sim2reason.authoring import Member
        >>> First = Annotated[int, Member("gliders")]
    """

    field: str


@dataclass(frozen=True, slots=True)
class Above:
    """A mark for a number that must be greater than the number in another field, which must not be zero."""

    field: str


@dataclass(frozen=True, slots=True)
class Hidden:
    """A mark for a number that no answer depends on and no text states, such as the position of the scene.

    Examples:
        >>> from sim2reason.authoring import FreeLength, Hidden
        >>> Hidden() in FreeLength.__metadata__
        True
    """


@dataclass(frozen=True, slots=True)
class Beside:
    """The symbol and name of a number if an optional number is given, too, such as µ_k instead of µ beside µ_s."""

    field: str
    symbol: str
    called: str


@dataclass(frozen=True, slots=True)
class Measure:
    """The meaning of a number: its name, unit and symbol, and the digits with which texts state it.

    Attributes:
        name: Name of the quantity.
        unit: Canonical unit, such as ``m/s^2``; empty for a pure number.
        symbol: Symbol in LaTeX, without dollars.
        decimals: Number of decimal places, up to three significant digits; by default two significant digits.
        called: Name in a question, if it is not `name`.
        beside: Symbol and name if another number is given too.
        sought: Relative frequency with which problems leave the number unknown.
        noun: Name in a question.

    Raises:
        UnitError: The unit is not in the table of units.

    Examples:
        >>> from typing import Annotated
        >>> from sim2reason.authoring import LEAST, Measure, Range
        >>> Pressure = Annotated[float, LEAST, Measure("pressure", "Pa", "p"), Range(1e3, 2e3)]
        >>> Measure("mass", "kg", "m").say(2.0)
        '2.0 kg'
    """

    name: str
    unit: str
    symbol: str
    decimals: int | None = None
    called: str = ""
    beside: Beside | None = None
    sought: float = 1.0

    def __post_init__(self) -> None:
        """Check that the unit is in the table of units; UnitError otherwise."""
        show_unit(self.unit)

    @property
    def noun(self) -> str:
        """Return the name of the number in a question: `called`, else *angle* for a unit of degrees, else `name`."""
        return self.called or ("angle" if self.unit == "deg" else self.name)

    def of(self, owner: object) -> "Measure":
        """Return this measure for an owner: with the symbol and name of `beside` if its field is given."""
        beside = self.beside
        if beside is None or getattr(owner, beside.field, None) is None:
            return self
        return replace(self, symbol=beside.symbol, called=beside.called, beside=None)

    def places(self, value: float) -> int:
        """Return the number of decimal places with which a value is stated, at least 0."""
        if value == 0.0:
            return self.decimals or 0
        if self.decimals is not None:
            return min(self.decimals, max(0, 2 - floor(log10(abs(float(f"{value:.2e}"))))))
        return max(0, 1 - floor(log10(abs(float(f"{value:.1e}")))))

    def round(self, value: float) -> float:
        """Return a value, rounded to the digits that texts state, so that the stated value is simulated."""
        digits = 2 - floor(log10(abs(value))) if value else 0
        return round(value, min(self.places(value), digits)) + 0.0

    def say(self, value: float) -> str:
        """Return a value with its unit as in texts, ``2.0 kg`` or ``30°``, with a true minus sign."""
        if value == 0.0:
            return join_unit("0", self.unit)
        rounded = round(value, self.places(value))
        text = repr(value) if abs(rounded - value) > 1e-12 * max(1.0, abs(value)) else f"{value:.{self.places(value)}f}"
        if "e" in text or not MIN_PLAIN_NUMBER <= abs(value) < VAST:
            return scientific_notation(value, self.unit)
        return join_unit(text.replace("-", "\N{MINUS SIGN}"), self.unit)

    def draw(self, rng: np.random.Generator, low: float, high: float) -> float:
        """Draw a number in [low, high], uniformly, rounded as texts state it."""
        return min(max(self.round(float(rng.uniform(low, high))), low), high)


MIN_PLAIN_NUMBER, VAST = 1e-5, 1e7  # smaller or larger numbers are written with a power of ten


def scientific_notation(value: float, unit: str) -> str:
    """Write a nonzero number in scientific notation, in a unit without prefixes: ``9.109 × 10^−31 kg``."""
    bare, size = to_coherent_unit(unit)
    sign, digits, _ = (scaled := (Decimal(repr(value)) * size).normalize()).as_tuple()
    first, rest = str(digits[0]), "".join(map(str, digits[1:])) or "0"
    text = f"{'-' * sign}{first}.{rest} \N{MULTIPLICATION SIGN} 10^{scaled.adjusted()}"
    return join_unit(text.replace("-", "\N{MINUS SIGN}"), bare)


@cache
def show_unit(unit: str) -> str:
    """Return a canonical unit as texts print it: ``m/s^2`` becomes ``m/s²``; UnitError if it is unknown."""
    return parse_unit(unit).display


def join_unit(number: str, unit: str) -> str:
    """Return a number with its unit, and a space between them if print requires one."""
    shown = show_unit(unit)
    return number + shown if shown in ("", "°") else f"{number} {shown}"


LEAST = Ge(1e-6)  # bound of positive numbers: smaller ones are typing errors, lost beside a kilogram in engines
MAX_SPEED = 3e7  # m/s, a tenth of the speed of light, up to which Newton's laws are good to a percent
Mass = Annotated[float, LEAST, Le(1e9), Measure("mass", "kg", "m"), Range(0.5, 10.0)]
Angle = Annotated[float, Ge(0), Lt(90), Measure("angle", "deg", r"\theta", decimals=0), Range(10.0, 70.0)]
KINETIC = Beside("static_friction", r"\mu_k", "coefficient of kinetic friction")
Friction = Annotated[
    float,
    Ge(0),
    Le(10),
    Measure("friction", "", r"\mu", decimals=2, called="coefficient of friction", beside=KINETIC, sought=3.0),
    Range(0.1, 0.7),
]
StaticFriction = Annotated[
    float,
    LEAST,
    Le(10),
    Above("friction"),
    Measure("static friction", "", r"\mu_s", decimals=2, called="coefficient of static friction"),
    Range(0.2, 0.9),
    Usually(present=False),
]
Force = Annotated[float, LEAST, Le(1e6), Measure("force", "N", "F", sought=2.0), Range(0.5, 10.0)]
Speed = Annotated[float, LEAST, Le(MAX_SPEED), Measure("speed", "m/s", "v", sought=2.0), Range(0.5, 5.0)]
AngularVelocity = Annotated[float, LEAST, Le(1e4), Measure("angular velocity", "rad/s", r"\omega_0"), Range(0.5, 5.0)]
Velocity = Annotated[float, Ge(-1e3), Le(1e3), Measure("velocity", "m/s", "v", decimals=2), Range(-3.0, 3.0)]
Coordinate = Annotated[float, Ge(-1e3), Le(1e3), Measure("position", "m", "x", decimals=2), Range(-2.0, 2.0)]
Length = Annotated[float, LEAST, Le(1e3), Measure("length", "m", r"\ell"), Range(0.5, 2.0)]
FreeLength = Annotated[float, LEAST, Le(1e3), Measure("free length", "m", r"\ell"), Range(2.0, 4.0), Hidden()]
Height = Annotated[float, LEAST, Le(1e4), Measure("height", "m", "h"), Range(1.0, 5.0)]
Stiffness = Annotated[float, LEAST, Le(1e6), Measure("stiffness", "N/m", "k", sought=2.0), Range(20.0, 250.0)]
NaturalLength = Annotated[float, LEAST, Le(1e3), Measure("natural length", "m", r"\ell_0"), Range(0.2, 1.0)]
Strain = Annotated[float, Ge(0), Le(1e3), Measure("strain", "m", "d", called="distance"), Range(0.05, 0.3)]
Damping = Annotated[float, LEAST, Le(1e6), Measure("damping constant", "N*s/m", "b"), Range(0.2, 3.0)]
MomentOfInertia = Annotated[float, LEAST, Le(1e9), Measure("moment of inertia", "kg*m^2", "I"), Range(0.05, 0.5)]
Restitution = Annotated[
    float,
    Ge(0),
    Le(1),
    Measure("restitution", "", "e", decimals=2, called="coefficient of restitution", sought=3.0),
    Range(0.3, 0.95),
]
Gravity = Annotated[float, Ge(0), Le(100), Measure("gravity", "m/s^2", "g")]


class Related(Protocol):
    """The relations of a field to others, a part of `sim2reason.scenes.dsl.model.FieldType`."""

    @property
    def models(self) -> tuple[type[Any], ...]:
        """Return the classes of models that the field may hold."""
        ...

    @property
    def member(self) -> str:
        """Return the field into which this field is an index; empty if it is no index."""
        ...

    @property
    def above(self) -> str:
        """Return the field whose number must be less than this field's number; empty if there is none."""
        ...

    @property
    def size(self) -> Callable[[Mapping[str, Any]], int] | None:
        """Return the function for the number of members, if other fields determine it."""
        ...


class Relations(NamedTuple):
    """The relations of one class: fields with dependent counts, ordered numbers, and indices with their targets."""

    sizes: tuple[tuple[str, Callable[[Mapping[str, Any]], int]], ...]
    greater: tuple[tuple[str, str], ...]  # a field, and the one with the smaller number
    indices: tuple[tuple[str, str, str], ...]  # the field with the index (empty for an own one), its name, its target


@cache
def relations(model: type[Any], types: Callable[[type[Any]], Mapping[str, Related]]) -> Relations:
    """Return the relations that a class of models declares; `types` analyses its fields."""
    kinds = types(model)
    own = [("", name, kind.member) for name, kind in kinds.items() if kind.member in kinds]
    inner = [
        (holder, name, kind.member)
        for holder, holder_kind in kinds.items()
        for part in holder_kind.models
        for name, kind in types(part).items()
        if kind.member in kinds
    ]
    sizes = tuple((name, kind.size) for name, kind in kinds.items() if kind.size is not None)
    greater = tuple((name, kind.above) for name, kind in kinds.items() if kind.above)
    return Relations(sizes, greater, (*own, *inner))


def violated_relation(value: Any, declared: Relations) -> str:
    """Return a message for a violated relation of a value; empty if all hold."""
    for name, demanded in declared.sizes:
        size, wanted = len(getattr(value, name)), demanded(value.__dict__)
        if size != wanted:
            return f"{name}: what stands beside them demands {wanted}, not {size}"
    for name, less in declared.greater:
        one, other = getattr(value, name), getattr(value, less)
        if one is not None and not 0.0 < other < one:
            return f"{name}: {one} is not greater than {less}, {other}, or that is zero; leave it out"
    for holder, name, field in declared.indices:
        count = len(getattr(value, field))
        for item in _each_of(getattr(value, holder)) if holder else (value,):
            index = getattr(item, name, None)
            if index is not None and not 0 <= index < count:
                location = f"{holder}.{name}" if holder else name
                return f"{location}: {field} has no member {index}, count from 0 to {count - 1}"
    return ""


def _each_of(value: Any) -> tuple[Any, ...]:
    """Return a value, or the members of a tuple."""
    return value if isinstance(value, tuple) else (value,)  # type: ignore[reportUnknownVariableType]
