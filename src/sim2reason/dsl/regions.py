"""Where forces act: inside, where all margins are positive."""

from dataclasses import dataclass, replace
from typing import Protocol, Self

from sim2reason.dsl.triples import Maths, Number, Triple, minus, product, times
from sim2reason.dsl.vectors import Vector, add, inner


class Region(Protocol):
    """Where a force acts: inside, where all margins are positive."""

    def margins(self, place: Triple, maths: Maths) -> tuple[Number, ...]:
        """Distances to the borders, m, positive inside."""
        ...

    def moved(self, by: Vector) -> Self:
        """The same region elsewhere."""
        ...


@dataclass(frozen=True, slots=True)
class HalfSpace:
    """All places with normal·r ≥ offset."""

    normal: Vector
    offset: float

    def margins(self, place: Triple, maths: Maths) -> tuple[Number, ...]:
        """The distance to the plane."""
        del maths
        return (product(self.normal, place) - self.offset,)

    def moved(self, by: Vector) -> "HalfSpace":
        """Elsewhere."""
        return replace(self, offset=self.offset + inner(self.normal, by))


@dataclass(frozen=True, slots=True)
class BoxRegion:
    """A slab or box: low ≤ axis·r ≤ high for each of its axes."""

    sides: tuple[tuple[Vector, float, float], ...]  # (axis, low, high)

    def margins(self, place: Triple, maths: Maths) -> tuple[Number, ...]:
        """The distances to its sides."""
        del maths
        found: list[Number] = []
        for axis, low, high in self.sides:
            along = product(axis, place)
            found += [along - low, high - along]
        return tuple(found)

    def moved(self, by: Vector) -> "BoxRegion":
        """Elsewhere."""
        return BoxRegion(tuple((axis, low + inner(axis, by), high + inner(axis, by)) for axis, low, high in self.sides))


@dataclass(frozen=True, slots=True)
class DiscRegion:
    """A cylinder of any length: the places within `radius` of an axis through `center`."""

    center: Vector
    radius: float
    axis: Vector = (0.0, 0.0, 1.0)

    def margins(self, place: Triple, maths: Maths) -> tuple[Number, ...]:
        """The distance to its border."""
        apart = minus(place, self.center)
        along = product(self.axis, apart)
        aside = minus(apart, times(along, self.axis))
        return (self.radius - maths.sqrt(product(aside, aside)),)

    def moved(self, by: Vector) -> "DiscRegion":
        """Elsewhere."""
        return replace(self, center=add(self.center, by))
