"""Public names for authors of entities: quantities, sentences, ports, forces, and the frame for building mechanisms.

An entity is a subclass of `Entity` that is registered with `entity`; `Part` is the base of what entities share.

- Numbers are fields with an annotated type, which has a unit, a symbol, limits, and a range for random draws: `Mass`,
  `Angle`, `Coordinate`, `Length`, `FreeLength`, `NaturalLength`, `Height`, `Speed`, `Velocity`, `AngularVelocity`,
  `Force`, `Friction`, `StaticFriction`, `Stiffness`, `Strain`, `Damping` and `Restitution`. New types consist of a
  `Measure`, a `Range` and limits such as `LEAST`, the least positive number.
- Marks on fields determine how they are drawn: `Chance`, `Count`, `Hidden`, `Member`, `Sized`, `Usually`.
- Sentences are templates: `either`, `among`, `starting`, `placing`, `defining_axes`, `assuming`, `each`, `lines_of`;
  a `Word` depends on a value.
- Ports are the points where connections join: `End`, `StringEnd`, `Pass`, `Chain`, `Mount`, `Base`.
- Forces follow a `Law`: `Push` and `Magnetic`, with a `Profile`, and `Resistance`.
- `Frame` has the methods that build a mechanism. A `Vector` has three components in the axes of the room: `X` points to
  the right, `Y` away from the reader, `Z` up; `ZERO`, `add`, `scale`, `inner`, `outer` and `axial_inertia` help with
  geometry. `GRAVITY` is in m/s², `WHEEL_RADIUS`, the default radius of a pulley, in m.

Example:
    >>> from sim2reason.authoring import Mass, Measure, Range
    >>> unit, = (each.unit for each in Mass.__metadata__ if isinstance(each, Measure))
    >>> drawn, = (each for each in Mass.__metadata__ if isinstance(each, Range))
    >>> drawn, unit
    (Range(low=0.5, high=10.0), 'kg')
"""

from sim2reason.scenes.dsl.builder import WHEEL_RADIUS, Frame, axial_inertia
from sim2reason.scenes.dsl.entity import Entity, Part, entity
from sim2reason.scenes.dsl.fields import Law, Magnetic, Profile, Push, Resistance
from sim2reason.scenes.dsl.measures import (
    LEAST,
    Angle,
    AngularVelocity,
    Chance,
    Coordinate,
    Count,
    Damping,
    Force,
    FreeLength,
    Friction,
    Height,
    Hidden,
    Length,
    Mass,
    Measure,
    Member,
    NaturalLength,
    Range,
    Restitution,
    Sized,
    Speed,
    StaticFriction,
    Stiffness,
    Strain,
    Usually,
    Velocity,
)
from sim2reason.scenes.dsl.mechanism import GRAVITY, ZERO, X, Y, Z
from sim2reason.scenes.dsl.ports import Base, Chain, End, Mount, Pass, StringEnd
from sim2reason.scenes.dsl.template import (
    Word,
    among,
    assuming,
    defining_axes,
    each,
    either,
    lines_of,
    placing,
    starting,
)
from sim2reason.scenes.dsl.vectors import Vector, add, inner, outer, scale

__all__ = [
    "GRAVITY",
    "LEAST",
    "WHEEL_RADIUS",
    "ZERO",
    "Angle",
    "AngularVelocity",
    "Base",
    "Chain",
    "Chance",
    "Coordinate",
    "Count",
    "Damping",
    "End",
    "Entity",
    "Force",
    "Frame",
    "FreeLength",
    "Friction",
    "Height",
    "Hidden",
    "Law",
    "Length",
    "Magnetic",
    "Mass",
    "Measure",
    "Member",
    "Mount",
    "NaturalLength",
    "Part",
    "Pass",
    "Profile",
    "Push",
    "Range",
    "Resistance",
    "Restitution",
    "Sized",
    "Speed",
    "StaticFriction",
    "Stiffness",
    "Strain",
    "StringEnd",
    "Usually",
    "Vector",
    "Velocity",
    "Word",
    "X",
    "Y",
    "Z",
    "add",
    "among",
    "assuming",
    "axial_inertia",
    "defining_axes",
    "each",
    "either",
    "entity",
    "inner",
    "lines_of",
    "outer",
    "placing",
    "scale",
    "starting",
]
