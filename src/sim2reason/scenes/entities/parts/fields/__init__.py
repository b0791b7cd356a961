"""Fields that act on a charged bead in the x-y plane: their sentences and force laws."""

from collections.abc import Mapping
from typing import Annotated, Literal, TypeVar

from annotated_types import Ge, Le

from sim2reason.base.registry import Registry
from sim2reason.scenes.authoring import LEAST, Law, Measure, Part, Range, Vector, Word, X, Y, Z, scale
from sim2reason.scenes.dsl.model import Model

ElectricStrength = Annotated[
    float, LEAST, Le(1e9), Measure("electric field", "N/C", "E", called="strength"), Range(0.4, 2.0)
]
MagneticStrength = Annotated[
    float, Ge(1e-12), Le(1e6), Measure("magnetic field", "T", "B", called="strength"), Range(0.4, 1.2)
]
Direction = Literal["positive x", "negative x", "positive y", "negative y"]
Trend = Literal["increases", "decreases"]
AXES: Mapping[str, Vector] = {"x": X, "y": Y, "z": Z}
ElectricAtFirst = Annotated[
    float, LEAST, Le(1e9), Measure("field strength", "N/C", "E", called="magnitude"), Range(0.4, 2.0)
]
MagneticAtFirst = Annotated[
    float, Ge(1e-12), Le(1e6), Measure("field strength", "T", "B", called="magnitude"), Range(0.4, 1.2)
]
"""Ranges for fields that have this strength only at one time or position."""


class ForceField(Part):
    """Base class of fields. A kind outside the classes below may have a base of its own, with a field of an entity."""

    @classmethod
    def variants(cls) -> tuple[type[Model], ...]:
        """Return the fields that are registered under this base."""
        return tuple(kind for kind in FIELDS.values() if issubclass(kind, cls))

    def law(self, charge: float) -> Law:
        """Return the force law for a charge, uC; forces in uN, positions in m and times in s."""
        raise NotImplementedError

    def rate(self, charge: float, mass: float) -> float:
        """Return the rate of rotation, oscillation, decay or acceleration of a bead, 1/s; 0 without a time scale."""
        del charge, mass
        return 0.0


F = TypeVar("F", bound=ForceField)
FIELDS: Registry[type[ForceField]] = Registry(
    "entities.parts.fields", package="sim2reason.scenes.entities.parts.fields"
)


def force_field(cls: type[F]) -> type[F]:
    """Register a field under the name of its class."""
    return FIELDS.add(cls.__name__, cls)


class ElectricField(ForceField):
    """An electric field in the plane of the motion."""

    called = "the electric field"


class MagneticField(ForceField):
    """A magnetic field square to the plane of the motion."""

    called = "the magnetic field"


class Medium(ForceField):
    """Base class of media that resist the motion."""

    called = "the medium"


_WAYS = [f"{side} {axis}" for axis in AXES for side in ("positive", "negative")]
_TURNED: Mapping[str, str] = {"increases": "decreases", "decreases": "increases"}


def _by_way(trend: str) -> Word:
    """Return the word for the trend of a field's component along an axis, given the trend along the field."""
    return Word("way", {way: trend if way.startswith("positive") else _TURNED[trend] for way in _WAYS})


CHANGING: dict[str, Word] = {
    "direction": Word("way", {way: f"the {way} direction" for way in _WAYS}),
    "line": Word("way", {way: f"the {way[-1]} axis" for way in _WAYS}),
    "component": Word("way", {way: f"{way[-1]} component" for way in _WAYS}),
    "growing": _by_way("increases"),
    "fading": _by_way("decreases"),
    "changes": Word("trend", {"increases": "{growing}", "decreases": "{fading}"}),
}
"""The words for the axis and the trend of a field's component, so that texts avoid components along negative axes.
component, and what that does, so that no text speaks of a component in a negative direction."""


def along(way: str) -> Vector:
    """Return the unit vector of a direction given in words."""
    side, axis = way.split()
    return scale(1.0 if side == "positive" else -1.0, AXES[axis])
