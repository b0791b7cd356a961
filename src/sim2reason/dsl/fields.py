"""Laws of force: data that any kind of number can be put through.

A law takes a place, a velocity and a time, as floats, arrays or symbols, and `maths`, which knows the root, sine
and cosine of such numbers.
"""

from dataclasses import dataclass, replace
from typing import Protocol, Self

from sim2reason.dsl.vectors import Maths, Number, Triple, Vector, add, cross, inner, minus, product, times


@dataclass(frozen=True, slots=True)
class Profile:
    """The strength of a field: (value + slope·(axis·r) + rate·t) · cos(frequency·t + phase)."""

    value: float
    slope: float = 0.0
    axis: Vector = (1.0, 0.0, 0.0)
    rate: float = 0.0
    frequency: float = 0.0  # rad/s
    phase: float = 0.0  # rad, of what has a frequency

    def at(self, place: Triple, time: Number, maths: Maths) -> Number:
        """The strength at a place and a time."""
        found: Number = self.value
        if self.slope:
            found = found + self.slope * product(self.axis, place)
        if self.rate:
            found = found + self.rate * time
        if not self.frequency:
            return found
        angle = self.frequency * time
        return found * maths.cos(angle + self.phase if self.phase else angle)

    def moved(self, by: Vector) -> "Profile":
        """The same profile about another origin."""
        return replace(self, value=self.value - self.slope * inner(self.axis, by)) if self.slope else self

    @property
    def steady(self) -> bool:
        """Whether it does not depend on time."""
        return self.rate == 0.0 and self.frequency == 0.0

    @property
    def uniform(self) -> bool:
        """Whether it is the same everywhere and always."""
        return self.steady and self.slope == 0.0


class Law(Protocol):
    """A force as a function of place, velocity and time."""

    def force(self, place: Triple, velocity: Triple, time: Number, maths: Maths) -> Triple:
        """The force, N."""
        ...

    def potential(self, place: Triple, maths: Maths) -> Number | None:
        """The potential energy, J, of a force that has one; else None."""
        ...

    @property
    def constant(self) -> bool:
        """Whether the force never changes."""
        ...

    def moved(self, by: Vector) -> Self:
        """The same law about another origin."""
        ...


@dataclass(frozen=True, slots=True)
class Push:
    """A force along one direction, such as that of an electric field on a charge."""

    direction: Vector
    profile: Profile

    def force(self, place: Triple, velocity: Triple, time: Number, maths: Maths) -> Triple:
        """Strength times direction."""
        del velocity
        return times(self.profile.at(place, time, maths), self.direction)

    def potential(self, place: Triple, maths: Maths) -> Number | None:
        """−∫F·dr where the curl is zero: the strength may change along the direction alone, and not in time."""
        del maths
        along = product(self.direction, self.profile.axis)
        if not self.profile.steady or (self.profile.slope and abs(along * along - 1.0) > 1e-12):
            return None
        s = product(self.direction, place)
        return -(self.profile.value + 0.5 * self.profile.slope * along * s) * s

    @property
    def constant(self) -> bool:
        """Whether it is uniform."""
        return self.profile.uniform

    def moved(self, by: Vector) -> "Push":
        """About another origin."""
        return replace(self, profile=self.profile.moved(by))


@dataclass(frozen=True, slots=True)
class Magnetic:
    """The force v × B on a unit of charge; the profile holds charge times field, T C."""

    direction: Vector
    profile: Profile

    def force(self, place: Triple, velocity: Triple, time: Number, maths: Maths) -> Triple:
        """Square to velocity and field; it does no work."""
        return times(self.profile.at(place, time, maths), cross(velocity, self.direction))

    def potential(self, place: Triple, maths: Maths) -> Number | None:
        """Zero: it does no work."""
        del place, maths
        return 0.0

    @property
    def constant(self) -> bool:
        """Never."""
        return False

    def moved(self, by: Vector) -> "Magnetic":
        """About another origin."""
        return replace(self, profile=self.profile.moved(by))


@dataclass(frozen=True, slots=True)
class Resistance:
    """Drag: −linear·v − quadratic·|v|·v."""

    linear: float = 0.0  # N s/m
    quadratic: float = 0.0  # N s²/m²

    def force(self, place: Triple, velocity: Triple, time: Number, maths: Maths) -> Triple:
        """Against the velocity."""
        del place, time
        factor: Number = -self.linear
        if self.quadratic:
            factor = factor - self.quadratic * maths.sqrt(product(velocity, velocity))
        return times(factor, velocity)

    def potential(self, place: Triple, maths: Maths) -> Number | None:
        """None: it dissipates."""
        del place, maths
        return None

    @property
    def constant(self) -> bool:
        """Never."""
        return False

    def moved(self, by: Vector) -> "Resistance":
        """It is the same everywhere."""
        del by
        return self


@dataclass(frozen=True, slots=True)
class Central:
    """A force strength/rᵖ away from a fixed point; a negative strength attracts."""

    center: Vector
    strength: float
    power: int = 2

    def force(self, place: Triple, velocity: Triple, time: Number, maths: Maths) -> Triple:
        """Along the line from the centre."""
        del velocity, time
        apart = minus(place, self.center)
        square = product(apart, apart)
        return times(self.strength / _power(square, self.power + 1, maths), apart)

    def potential(self, place: Triple, maths: Maths) -> Number | None:
        """Strength / ((p − 1) rᵖ⁻¹), zero at infinity; None for p = 1."""
        if self.power == 1:
            return None
        apart = minus(place, self.center)
        return self.strength / (self.power - 1) / _power(product(apart, apart), self.power - 1, maths)

    @property
    def constant(self) -> bool:
        """Never."""
        return False

    def moved(self, by: Vector) -> "Central":
        """About another origin."""
        return replace(self, center=add(self.center, by))


def _power(square: Number, power: int, maths: Maths) -> Number:
    """R to a whole power, from r²."""
    found: Number = maths.sqrt(square) if power % 2 else 1.0
    for _ in range(abs(power) // 2):
        found = found * square
    return found if power >= 0 else 1.0 / found
