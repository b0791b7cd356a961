"""Bodies, forces and initial velocities that are left out of account."""

from collections.abc import Iterable
from dataclasses import replace

from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.simplifications.parts.which import carriers, massive, others
from sim2reason.questions.study import Study
from sim2reason.scenes.dsl.ablation import NEARLY_NOTHING, held, left_out, weighs, with_bodies, with_lines
from sim2reason.scenes.dsl.constancy import bending
from sim2reason.scenes.dsl.frames import start
from sim2reason.scenes.dsl.mechanism import ConstantTension, Elastic, Line, Mechanism, RigidBody
from sim2reason.scenes.dsl.vectors import scale


@simplification
class BodyHeld(ChangedMechanism):
    """A body that moves is held where it is."""

    name = "body held"
    reason = "{subject} is taken to stay where it is"
    part = True
    misleads = False

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """Return all that can move but for wheels."""
        del query
        movable = {coordinate.body for coordinate in study.mechanism.coordinates}
        return [name for name in massive(study.mechanism) if name in movable]

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with it held on what carries it."""
        return held(mechanism, subject)


@simplification
class BodyLeftOut(ChangedMechanism):
    """A body is left out: it has no mass, and nothing meets it."""

    name = "body left out"
    reason = "all is taken to move as if {subject} were not there"
    part = True
    misleads = False

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """Return all of several with mass but what would tremble without it: on springs, across strings, as a pivot."""
        del query
        mechanism = study.mechanism
        elastic = [line for line in mechanism.lines if isinstance(line.law, Elastic)]
        sprung = {mechanism.site[site].body for line in elastic for site in line.through}
        sprung |= {body for line in elastic for body in line.circle or ()}
        frames = start(mechanism)
        turning = [line for line in mechanism.lines if bending(line, frames)]
        held = {mechanism.site[site].body for line in turning for site in (line.through[0], line.through[-1])}
        pivots = {body.parent for body in mechanism.bodies if any(c.kind == "hinge" for c in body.coordinates)}
        return [name for name in others(mechanism) if name not in sprung | held | pivots]

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return all but without it."""
        return left_out(mechanism, subject)


@simplification
class FixedCarrier(ChangedMechanism):
    """What carries others, such as a wedge, is taken as fixed."""

    name = "fixed carrier"
    reason = "{subject} is taken as fixed"
    holds = True
    common = True

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """Return whatever carries something and can move."""
        del query
        return carriers(study.mechanism)

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with it held."""
        return held(mechanism, subject)


@simplification
class ForceLeftOut(ChangedMechanism):
    """The force of a field, or the drag of a medium, is left out."""

    name = "force left out"
    reason = "the force of {subject} is left out"
    part = True

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """Return all of them."""
        del query
        return [force.name for force in study.mechanism.forces]

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism without it."""
        return replace(mechanism, forces=tuple(force for force in mechanism.forces if force.name != subject))


@simplification
class FromRest(ChangedMechanism):
    """What moves at the start is taken to be at rest."""

    name = "from rest"
    common = True
    reason = "the velocity at the start is left out"

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """Return the whole, where anything moves at the start; but nobody has planets fall into their star."""
        del query
        moving = any(coordinate.speed for coordinate in study.mechanism.coordinates)
        return [""] if moving and not study.mechanism.attractions else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with all at rest."""
        del subject
        return with_bodies(mechanism, mechanism.body, _still)


def _still(body: RigidBody) -> RigidBody:
    return replace(body, coordinates=tuple(replace(c, speed=0.0) for c in body.coordinates))


@simplification
class GravityLeftOut(ChangedMechanism):
    """Weight is left out."""

    name = "gravity left out"
    reason = "weight is left out"

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """Return the whole, where anything weighs."""
        del query
        return [""] if weighs(study.mechanism) else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with next to no gravity, so that there still is an up and a down."""
        del subject
        return replace(mechanism, gravity=scale(NEARLY_NOTHING, mechanism.gravity))


@simplification
class HandLeftOut(ChangedMechanism):
    """The pull of a hand on a string is left out."""

    name = "hand left out"
    reason = "the pull of the hand is left out"
    part = True

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """Return the lines that are drawn in."""
        del query
        return [line.name for line in study.mechanism.pulls]

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with a force of zero."""
        return with_lines(mechanism, [subject], lambda line: replace(line, law=ConstantTension(0.0)))


@simplification
class NoDamping(ChangedMechanism):
    """All dashpots are left out."""

    name = "no damping"
    reason = "damping is left out"

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """Return the whole, where anything is damped."""
        del query
        return [""] if _damped(study.mechanism) else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with springs alone."""
        del subject
        return with_lines(mechanism, _damped(mechanism), _undamped)


def _damped(mechanism: Mechanism) -> list[str]:
    return [line.name for line in mechanism.lines if isinstance(line.law, Elastic) and line.law.damping]


def _undamped(line: Line) -> Line:
    assert isinstance(line.law, Elastic)
    return replace(line, law=replace(line.law, damping=0.0))


@simplification
class SpringLeftOut(ChangedMechanism):
    """A spring is left out, and with it the energy that it stores."""

    name = "spring left out"
    reason = "{subject} is left out"
    part = True

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """Return all springs."""
        del query
        return [line.name for line in study.mechanism.lines if isinstance(line.law, Elastic)]

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with a spring that pulls at nothing."""
        return with_lines(mechanism, [subject], lambda line: replace(line, law=Elastic(0.0, 0.0)))
