"""Force laws of fields and media, for floats, arrays or symbols.

A law takes a position, a velocity and a time, and `maths` with the square root, sine and cosine of their type of
number.
"""

from dataclasses import dataclass, replace
from typing import Protocol, Self

from sim2reason.scenes.dsl.vectors import (
    Maths,
    Number,
    Triple,
    Vector,
    add,
    cross,
    dot,
    inner,
    scale_triple,
    subtract_triples,
)


@dataclass(frozen=True, slots=True)
class Profile:
    """The strength of a field as a function of place and time.

    The strength is (value + slope·(axis·r) + rate·t)·cos(frequency·t + phase), in the unit of the field.

    Attributes:
        value: Strength at the origin at t = 0, without the cosine.
        slope: Change of the strength per metre along `axis`.
        axis: Unit vector along which the strength changes.
        rate: Change of the strength per second.
        frequency: Angular frequency, rad/s; 0 for a field that does not oscillate.
        phase: Phase of the oscillation, rad.
        steady: Whether the strength does not depend on time.
        uniform: Whether the strength is the same everywhere and always.

    Examples:
        >>> from sim2reason.authoring import Profile
        >>> Profile(3.0).uniform, Profile(3.0, frequency=2.0).steady
        (True, False)
    """

    value: float
    slope: float = 0.0
    axis: Vector = (1.0, 0.0, 0.0)
    rate: float = 0.0
    frequency: float = 0.0  # rad/s
    phase: float = 0.0  # rad, of what has a frequency

    def at(self, place: Triple, time: Number, maths: Maths) -> Number:
        """Return the strength at a place, m, and a time, s."""
        strength: Number = self.value
        if self.slope:
            strength = strength + self.slope * dot(self.axis, place)
        if self.rate:
            strength = strength + self.rate * time
        if not self.frequency:
            return strength
        angle = self.frequency * time
        return strength * maths.cos(angle + self.phase if self.phase else angle)

    def moved(self, by: Vector) -> "Profile":
        """Return the profile about an origin that is displaced by `by`, m."""
        return replace(self, value=self.value - self.slope * inner(self.axis, by)) if self.slope else self

    @property
    def steady(self) -> bool:
        """Return whether the strength does not depend on time."""
        return self.rate == 0.0 and self.frequency == 0.0

    @property
    def uniform(self) -> bool:
        """Return whether the strength is the same everywhere and always."""
        return self.steady and self.slope == 0.0


class Law(Protocol):
    """The protocol of laws of force: functions of place, velocity and time.

    A law accepts floats, arrays and symbols, with a `maths` that has their square root, sine and cosine.

    Attributes:
        constant: Whether the force never changes.

    Examples:
        >>> import math
        >>> from sim2reason.authoring import Law, Profile, Push, X, ZERO
        >>> law: Law = Push(X, Profile(3.0))
        >>> law.force(ZERO, ZERO, 0.0, math)
        (3.0, 0.0, 0.0)
    """

    def force(self, place: Triple, velocity: Triple, time: Number, maths: Maths) -> Triple:
        """Return the force, N.

        Args:
            place: Position, m, in the axes of the room.
            velocity: Velocity, m/s.
            time: Time, s.
            maths: Functions for the type of number: square root, sine and cosine.

        Returns:
            The components of the force.
        """
        ...

    def potential(self, place: Triple, maths: Maths) -> Number | None:
        """Return the potential energy, J, at a place; None for a force that has none."""
        ...

    @property
    def constant(self) -> bool:
        """Return whether the force never changes."""
        ...

    def moved(self, by: Vector) -> Self:
        """Return the law about an origin that is displaced by `by`, m."""
        ...


@dataclass(frozen=True, slots=True)
class Push:
    """A force along a fixed direction, such as that of an electric field on a charge.

    Attributes:
        direction: Unit vector.
        profile: Strength of the force, N.
        constant: Whether the force never changes.

    Examples:
        >>> from sim2reason.authoring import Profile, Push, X
        >>> Push(X, Profile(3.0)).constant
        True
    """

    direction: Vector
    profile: Profile

    def force(self, place: Triple, velocity: Triple, time: Number, maths: Maths) -> Triple:
        """Return the force, N: the strength times the direction."""
        del velocity
        return scale_triple(self.profile.at(place, time, maths), self.direction)

    def potential(self, place: Triple, maths: Maths) -> Number | None:
        """Return the potential energy −∫F·dr, J; None if the force depends on time, or changes across its direction."""
        del maths
        along = dot(self.direction, self.profile.axis)
        if not self.profile.steady or (self.profile.slope and abs(along * along - 1.0) > 1e-12):
            return None
        s = dot(self.direction, place)
        return -(self.profile.value + 0.5 * self.profile.slope * along * s) * s

    @property
    def constant(self) -> bool:
        """Return whether the profile is uniform."""
        return self.profile.uniform

    def moved(self, by: Vector) -> "Push":
        """Return the law with its origin displaced by `by`, m."""
        return replace(self, profile=self.profile.moved(by))


@dataclass(frozen=True, slots=True)
class Magnetic:
    """The force v × B of a magnetic field on a charge.

    Attributes:
        direction: Unit vector along the field.
        profile: Charge times field, C T.
        constant: Whether the force never changes: always False, since it depends on the velocity.

    Examples:
        >>> import math
        >>> from sim2reason.authoring import X, Z, ZERO, Magnetic, Profile
        >>> Magnetic(Z, Profile(2.0)).force(ZERO, X, 0.0, math)
        (0.0, -2.0, 0.0)
    """

    direction: Vector
    profile: Profile

    def force(self, place: Triple, velocity: Triple, time: Number, maths: Maths) -> Triple:
        """Return the force, which is perpendicular to velocity and field and does no work."""
        return scale_triple(self.profile.at(place, time, maths), cross(velocity, self.direction))

    def potential(self, place: Triple, maths: Maths) -> Number | None:
        """Return 0, since the force does no work."""
        del place, maths
        return 0.0

    @property
    def constant(self) -> bool:
        """Return False, since the force depends on the velocity."""
        return False

    def moved(self, by: Vector) -> "Magnetic":
        """Return the law with its origin displaced by `by`, m."""
        return replace(self, profile=self.profile.moved(by))


@dataclass(frozen=True, slots=True)
class Resistance:
    """The drag −linear·v − quadratic·|v|·v.

    Attributes:
        linear: Coefficient of the linear term, N s/m.
        quadratic: Coefficient of the quadratic term, N s²/m².
        constant: Whether the force never changes: always False, since it depends on the velocity.

    Examples:
        >>> import math
        >>> from sim2reason.authoring import X, ZERO, Resistance
        >>> Resistance(linear=0.5).force(ZERO, X, 0.0, math)
        (-0.5, -0.0, -0.0)
    """

    linear: float = 0.0  # N s/m
    quadratic: float = 0.0  # N s²/m²

    def force(self, place: Triple, velocity: Triple, time: Number, maths: Maths) -> Triple:
        """Return the force, which is opposite to the velocity."""
        del place, time
        factor: Number = -self.linear
        if self.quadratic:
            factor = factor - self.quadratic * maths.sqrt(dot(velocity, velocity))
        return scale_triple(factor, velocity)

    def potential(self, place: Triple, maths: Maths) -> Number | None:
        """Return None, since drag dissipates energy."""
        del place, maths
        return None

    @property
    def constant(self) -> bool:
        """Return False, since the force depends on the velocity."""
        return False

    def moved(self, by: Vector) -> "Resistance":
        """Return the law of a translated scene: itself, since a resistance does not depend on position."""
        del by
        return self


@dataclass(frozen=True, slots=True)
class Central:
    """A force strength/rᵖ away from a fixed point; a negative strength attracts."""

    center: Vector
    strength: float
    power: int = 2

    def force(self, place: Triple, velocity: Triple, time: Number, maths: Maths) -> Triple:
        """Return the force along the line from the centre, N."""
        del velocity, time
        separation = subtract_triples(place, self.center)
        square = dot(separation, separation)
        return scale_triple(self.strength / _power(square, self.power + 1, maths), separation)

    def potential(self, place: Triple, maths: Maths) -> Number | None:
        """Return the potential energy strength / ((p − 1) rᵖ⁻¹), zero at infinity, J; None for p = 1."""
        if self.power == 1:
            return None
        separation = subtract_triples(place, self.center)
        return self.strength / (self.power - 1) / _power(dot(separation, separation), self.power - 1, maths)

    @property
    def constant(self) -> bool:
        """Return False, since the force depends on position."""
        return False

    def moved(self, by: Vector) -> "Central":
        """Return the law with its origin displaced by `by`, m."""
        return replace(self, center=add(self.center, by))


def _power(square: Number, power: int, maths: Maths) -> Number:
    """Return an integer power of a distance, given its square."""
    product: Number = maths.sqrt(square) if power % 2 else 1.0
    for _ in range(abs(power) // 2):
        product = product * square
    return product if power >= 0 else 1.0 / product
