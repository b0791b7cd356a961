"""Slabs stacked on a fixed plane, each face with its own friction, each slab open to strings on either side."""

from typing import Self

from pydantic import model_validator

from sim2reason.scenes.authoring import (
    End,
    Entity,
    Frame,
    Friction,
    Speed,
    StaticFriction,
    Vector,
    Word,
    either,
    entity,
    scale,
    starting,
)
from sim2reason.scenes.bodies.blocks import Slab
from sim2reason.scenes.bodies.simple_machines import Plane
from sim2reason.scenes.entities.string_ends import FRICTION_ON_PLANE, two_coefficients

STRING_LEVEL_SPACING = 0.4  # m; distance between the string levels of successive slabs, for drawings only


def frictions(number: str, below: str, above: str) -> dict[str, Word]:
    """Return the words, in four forms, that state the friction between two slabs or its absence."""
    given, pair = f"{{{number}}}", f"between {{{below}}} and {{{above}}}"
    return {
        f"{number}1": Word(
            number,
            {0.0: f"there is no friction {pair}"},
            f"the coefficient of friction (static and kinetic) {pair} is {given}",
        ),
        f"{number}2": Word(
            number,
            {0.0: f"{{{above}}} slides on {{{below}}} without friction"},
            f"{pair} the coefficient of friction, static and kinetic, is {given}",
        ),
        f"{number}3": Word(
            number,
            {0.0: f"the contact {pair} is smooth"},
            f"static and kinetic friction {pair} have the same coefficient, {given}",
        ),
        f"{number}4": Word(
            number,
            {0.0: f"friction {pair} is negligible"},
            f"the coefficients of static and of kinetic friction {pair} are both {given}",
        ),
    }


@entity
class StackedMassPlane(Entity):
    """Two or three slabs, one on top of the other; the second may start with a speed of its own."""

    plane: Plane
    lower: Slab
    upper: Slab
    top: Slab | None = None
    friction: Friction
    static_friction: StaticFriction | None = None
    top_friction: Friction | None = None
    speed: Speed | None = None

    words = {**frictions("friction", "lower", "upper"), **frictions("top_friction", "upper", "top")}
    says = (
        either(
            "{lower} lies on {plane} and carries {upper}.",
            "on {plane} lies {lower}, with {upper} on top of it.",
            "{upper} is on top of {lower}, which lies on {plane}.",
        ),
        either("on {upper} lies {top}.", "{top} is on top of {upper}.", "{upper} in turn carries {top}."),
        FRICTION_ON_PLANE,
        either("{friction1}.", "{friction2}.", "{friction3}.", "{friction4}.").if_given(
            "static_friction", *two_coefficients("between {lower} and {upper}")
        ),
        either("{top_friction1}.", "{top_friction2}.", "{top_friction3}.", "{top_friction4}."),
        starting(
            "at t = 0 {upper} is moving {plane.uphill} at speed {speed}, and all else is at rest.",
            "{upper} is launched {plane.uphill} at t = 0 with a speed of {speed}, all else being at rest.",
            "at t = 0 {upper} has a velocity of {speed}, directed {plane.uphill}, and all else is at rest.",
        ),
    )
    lower_left = End(
        sites=("lower_tail",), tied="{lower}", leaves="runs {plane.downhill}", arrives="reaches {lower} {plane.below}"
    )
    lower_right = End(
        sites=("lower_hook",), tied="{lower}", leaves="runs {plane.uphill}", arrives="reaches {lower} {plane.above}"
    )
    upper_left = End(
        sites=("upper_tail",), tied="{upper}", leaves="runs {plane.downhill}", arrives="reaches {upper} {plane.below}"
    )
    upper_right = End(
        sites=("upper_hook",), tied="{upper}", leaves="runs {plane.uphill}", arrives="reaches {upper} {plane.above}"
    )
    top_left = End(
        sites=("top_tail",), tied="{top}", leaves="runs {plane.downhill}", arrives="reaches {top} {plane.below}"
    )
    top_right = End(
        sites=("top_hook",), tied="{top}", leaves="runs {plane.uphill}", arrives="reaches {top} {plane.above}"
    )

    @model_validator(mode="after")
    def _is_whole(self) -> Self:
        if (self.top is None) != (self.top_friction is None):
            raise ValueError("top, top_friction: one is given without the other; give both or neither")
        return self

    def build(self, room: Frame) -> None:
        """Build each slab on the one below; speeds are relative to that, so that the top one starts at rest."""
        plane, speed = self.plane, self.speed or 0.0
        lower = self._slab(room, "lower", self.lower, (plane.friction, plane.static_friction))
        upper = self._slab(lower, "upper", self.upper, (self.friction, self.static_friction), speed)
        if self.top is not None:
            self._slab(upper, "top", self.top, (self.top_friction or 0.0, None), -speed)

    def _slab(self, below: Frame, name: str, slab: Slab, rubs: tuple[float, float | None], speed: float = 0.0) -> Frame:
        """Lay a slab on `below`, with coefficients of kinetic and static friction `rubs` and a hook on either side."""
        uphill, normal = self.plane.directions()
        at: Vector = scale(STRING_LEVEL_SPACING, normal)
        frame = below.body(name, slab.mass, at=at).rest(uphill, normal, rubs[0], speed, static=rubs[1])
        frame.site(f"{name}_tail", faces=scale(-1.0, uphill)).site(f"{name}_hook", faces=uphill)
        return frame
