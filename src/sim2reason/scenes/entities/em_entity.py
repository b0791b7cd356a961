"""A charged bead in electric and magnetic fields, free of gravity."""

import math
from collections.abc import Mapping
from typing import Annotated, Any, ClassVar, Self

import numpy as np
from pydantic import model_validator

from sim2reason.scenes.authoring import ZERO, Chance, Entity, Frame, X, Y, assuming, either, entity
from sim2reason.scenes.bodies.charges import (
    ChargedBead,
    CircularRegion,
    HalfPlane,
    Launched,
    Rectangle,
    Released,
    Strip,
)
from sim2reason.scenes.dsl.measures import FASTEST
from sim2reason.scenes.dsl.model import replace_validated
from sim2reason.scenes.dsl.units import MINUTE, UnitSystem
from sim2reason.scenes.entities.parts.fields import ElectricField, ForceField, MagneticField, Medium

TURN = 8.0  # rad of the fastest rotation or oscillation in the default duration
USUAL = 2.0  # s, default duration without a time scale of the fields
PATH_LENGTH_RATIO = 1.5  # assumed length of a path through a region, in straight paths
AIM = 12.0  # degrees, largest error of aim of a drawn bead towards a region


@entity
class EmEntity(Entity):
    """It moves in the x-y plane; electric fields lie in it, magnetic ones are square to it."""

    units: ClassVar[UnitSystem] = MINUTE

    magnetic: Annotated[MagneticField | None, Chance(0.7)] = None
    electric: Annotated[ElectricField | None, Chance(0.7)] = None
    medium: Annotated[Medium | None, Chance(0.2)] = None
    region: Annotated[HalfPlane | Strip | Rectangle | CircularRegion | None, Chance(0.4)] = None
    particle: ChargedBead
    start: Launched | Released

    says = (
        either(
            "outside {region} there is no field.",
            "there is a field only in {region}.",
            "there is no field except inside {region}.",
        ),
        either(
            "at t = 0 {particle} {start}.",
            "at t = 0, {particle} {start}.",
            "at the time t = 0 {particle} {start}.",
        ),
        assuming(
            "there is no gravity.",
            "no gravity acts here.",
            "gravity is absent.",
        ),
    )

    @model_validator(mode="after")
    def _moves(self) -> Self:
        if self.magnetic is None and self.electric is None:
            raise ValueError("magnetic, electric: there is no field; give one")
        if isinstance(self.start, Released):
            if self.electric is None:
                raise ValueError("start: a magnetic field does nothing to a bead at rest; launch it")
            if self.region is not None and min(self.region.shape.margins(ZERO, math)) <= 0.0:
                raise ValueError("start: there is no field where the bead is released; launch it, or move the region")
        return self

    @classmethod
    def fitted(cls, drawn: Mapping[str, Any], rng: np.random.Generator) -> Mapping[str, object]:
        """Return a bead that starts towards the region."""
        start, region = drawn["start"], drawn.get("region")
        if region is None or not isinstance(start, Launched):
            return {}
        x, y = region.middle
        angle = round(math.degrees(math.atan2(y, x)) + rng.uniform(-AIM, AIM)) % 360
        return {"start": replace_validated(start, angle=float(angle))}

    @property
    def fields(self) -> dict[str, ForceField]:
        """Return all fields and media by name."""
        found = {"magnetic": self.magnetic, "electric": self.electric, "medium": self.medium}
        return {name: field for name, field in found.items() if field is not None}

    @property
    def clocked(self) -> bool:
        """Return True, since the bead starts at t = 0."""
        return True

    def horizon(self, gravity: float) -> float:
        """Return the time of about one turn of the fastest field effect, or to reach and cross the region, s."""
        del gravity
        mass, charge = self.particle.mass, self.particle.signed_charge
        fastest = max(field.rate(charge, mass) for field in self.fields.values())
        enough = TURN / fastest if fastest else self._speeding_up
        if self.region is None or not isinstance(self.start, Launched):
            return enough
        speed = self.start.speed
        return math.hypot(*self.region.middle) / speed + min(enough, PATH_LENGTH_RATIO * self.region.width / speed)

    @property
    def _speeding_up(self) -> float:
        """Return the default duration, s, reduced if the bead would become too fast for Newton's laws."""
        pushes = [field.law(self.particle.signed_charge).force(ZERO, ZERO, 0.0, math) for field in self.fields.values()]
        most = sum(math.hypot(*map(float, push)) for push in pushes) / self.particle.mass
        return min(USUAL, FASTEST / most) if most else USUAL

    def build(self, room: Frame) -> None:
        """Build the bead with two sliding coordinates in a level plane, and a force for each field."""
        vx, vy = self.start.velocity
        bead = room.body("particle", self.particle.mass).slide(X, vx, name="x", stated=("x", 0.0))
        bead.slide(Y, vy, name="y", stated=("y", 0.0))
        region = self.region.shape if self.region is not None else None
        for name, field in self.fields.items():
            bead.force(name, field.law(self.particle.signed_charge), None if field is self.medium else region)
