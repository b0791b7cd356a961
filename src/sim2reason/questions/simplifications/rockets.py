"""Misconceptions about rockets."""

from collections.abc import Iterable
from dataclasses import replace
from math import log

from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, misconception
from sim2reason.questions.simplifications.parts.burning import BurnMisconception, without_loss
from sim2reason.questions.study import SimulatedScene
from sim2reason.scenes.dsl.ablation import weighs, with_bodies
from sim2reason.scenes.dsl.frames import initial_frames
from sim2reason.scenes.dsl.mechanism import Attraction, MassEjection, Mechanism
from sim2reason.scenes.dsl.vectors import Vector, minus, scale


@misconception
class CommonLogarithm(BurnMisconception):
    """The velocity change is computed with the logarithm to base ten of the mass ratio."""

    name = "common logarithm"
    reason = "the logarithm to base ten is taken for the natural one"

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the bodies that burn fuel if their thrust is the only force; else none."""
        mechanism = study.mechanism
        return [] if weighs(mechanism) or mechanism.attractions else super().subjects(query, study)

    def burnt(self, mechanism: Mechanism, burn: MassEjection) -> MassEjection:
        """Return a burn whose exhaust is slower by ln 10, which has the same effect on the velocity."""
        del mechanism
        return replace(burn, exhaust=burn.exhaust / log(10.0))


@misconception
class ConstantMass(BurnMisconception):
    """A rocket is assumed to keep its mass as it burns fuel."""

    name = "constant mass"
    reason = "the mass of {subject} is taken as constant"

    def burnt(self, mechanism: Mechanism, burn: MassEjection) -> MassEjection:
        """Return a burn of the same thrust that ejects almost no mass."""
        del mechanism
        return without_loss(burn)


@misconception
class FuelAsRest(BurnMisconception):
    """The empty mass of a rocket is mistaken for the mass of its fuel."""

    name = "fuel mass for empty mass"
    reason = "the mass of {subject} without fuel is taken for the mass of its fuel"

    def burnt(self, mechanism: Mechanism, burn: MassEjection) -> MassEjection:
        """Return the burn of a rocket that takes its mass without fuel for the mass of its fuel."""
        left = mechanism.body[burn.body].mass - burn.rate * burn.until
        return replace(burn, until=left / burn.rate)


@misconception
class FuelLeftOut(BurnMisconception):
    """A rocket is assumed to have its empty mass from the start."""

    name = "fuel left out"
    reason = "the mass of the fuel of {subject} is left out"

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism in which one rocket has the same thrust but carries no fuel."""
        spent = {burn.body: burn.rate * burn.until for burn in mechanism.burns}
        lighter = with_bodies(mechanism, [subject], lambda body: replace(body, mass=body.mass - spent[subject]))
        return super().changed(lighter, subject)

    def burnt(self, mechanism: Mechanism, burn: MassEjection) -> MassEjection:
        """Return a burn of the same thrust that ejects almost no mass."""
        del mechanism
        return without_loss(burn)


@misconception
class UniformGravity(ChangedMechanism):
    """The weight of a body that leaves a planet is assumed to stay constant."""

    name = "uniform gravity"
    reason = "gravity is taken to be everywhere what it is at the start"

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the whole mechanism as the subject if a rocket is attracted by one other body; else none."""
        del query
        return [""] if len(study.mechanism.attractions) == 1 and study.mechanism.burns else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with uniform gravity in place of the attraction."""
        del subject
        (pull,) = mechanism.attractions
        return replace(mechanism, attractions=(), gravity=_free_fall(mechanism, pull))


def _free_fall(mechanism: Mechanism, pull: Attraction) -> Vector:
    """Return the initial acceleration, m/s², of the rocket due to the attraction."""
    falling = mechanism.burns[0].body
    other = pull.b if falling == pull.a else pull.a
    frames = initial_frames(mechanism)
    x, y, z = (float(part) for part in minus(frames.center(other).place, frames.center(falling).place))
    distance = (x * x + y * y + z * z) ** 0.5
    return scale(pull.constant * mechanism.body[other].mass / distance ** (pull.power + 1.0), (x, y, z))


@misconception
class WeightAlongThrust(ChangedMechanism):
    """The weight of a rocket is added to its thrust, not subtracted from it."""

    name = "weight along the thrust"
    reason = "the weight of {subject} is added to the thrust instead of being subtracted"

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the bodies that burn fuel if there is gravity; else none."""
        del query
        mechanism = study.mechanism
        return [burn.body for burn in mechanism.burns] if weighs(mechanism) else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with gravity reversed."""
        del subject
        return replace(mechanism, gravity=scale(-1.0, mechanism.gravity))
